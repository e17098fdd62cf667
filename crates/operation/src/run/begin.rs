//! A job's wires bent from their beginning, one after the other.

use wirebend_driver_host::Permit;
use wirebend_driver_host::jobs::{Clock, Heading, JobRun, Journal, WireJob};

use super::about::about;
use super::absence::Watch;
use super::cutting::{AfterCut, WirePermit};
use super::making::Making;
use super::report::{LeftBecause, RunResponse};
use super::task::Task;
use crate::live::{Connection, Unnamed, Zero, ask_permit, connect, refused};
use crate::{LiveProblem, OperationError};

impl Task<'_> {
    /// Bends the wires that were asked for, none of which may be unfinished.
    pub fn begin(&self) -> Result<RunResponse, OperationError> {
        let wanted = self.wanted();
        wanted.iter().try_for_each(|&wire| self.require_clear(wire))?;
        let mut connection = connect(self.app, &self.at(None, Unnamed::Simulate), self.progress)?;
        self.require_person_between(&connection)?;
        connection.require_settings(self.setup.machine_id(), self.request.accept_settings)?;
        wanted.iter().try_for_each(|&wire| self.require_within(&connection, wire, 1))?;
        self.require_cutter(&connection, &wanted)?;
        connection.settle_head(self.request.answers.head_at_deg, self.request.answers.confirmed)?;
        let mut response = self.response();
        response.port = Some(connection.port.clone());
        response.identity = Some(connection.session.identity().to_owned());
        let mut row = None;
        for (n, (wire, rest)) in self.sequence(&wanted).enumerate() {
            let first = n == 0;
            let permit = match self.permit(&mut connection, wire, first, row.take()) {
                Ok(permit) => permit,
                // Wires that are done stay done: the answer lists the rest.
                Err(OperationError::Live(problem)) if !first => {
                    response.left_because = Some(match problem {
                        LiveProblem::NotConfirmed | LiveProblem::ZeroNotConfirmed => LeftBecause::NobodyAsked,
                        _ => LeftBecause::Declined,
                    });
                    response.left = std::iter::once(wire).chain(rest.iter().copied()).collect();
                    break;
                }
                Err(error) => return Err(error),
            };
            let homes = connection.can_home();
            let WirePermit { wire: permit, row: of_row } = permit;
            let (back, made) = self.make(connection, wire, homes, permit, &mut response);
            self.wire_ended(wire, rest.is_empty(), &mut response)?;
            made?;
            // It is given back where the wire was finished or interrupted.
            let Some(back) = back else { return Ok(response) };
            connection = back;
            if !response.wires.last().is_some_and(|made| made.outcome.is_whole()) {
                response.left = rest.to_vec();
                break;
            }
            if let Some(of_row) = of_row {
                row = match self.cut_off(&mut connection, of_row, &mut response) {
                    AfterCut::GoesOn(row) => Some(row),
                    AfterCut::Asks => None,
                    AfterCut::Ends => {
                        response.left = rest.to_vec();
                        break;
                    }
                };
            }
        }
        response.notes.append(&mut connection.observer.warnings);
        Ok(response)
    }

    /// Asks a person, unless they have permitted this wire with those before.
    fn permit(
        &self,
        connection: &mut Connection,
        wire: usize,
        first: bool,
        row: Option<Permit>,
    ) -> Result<WirePermit, OperationError> {
        let permit = match row.filter(|_| self.goes_on(wire)) {
            Some(row) => row,
            None => self.ask(connection, wire, first)?,
        };
        if connection.can_home() {
            // Before anything of the wire is written down.
            connection.ask_zero(Zero::Wire)?;
        }
        Ok(WirePermit::new(&connection.session, permit, self.request.repeat.cut)?)
    }

    /// Whether a wire is bent without a question: those before it were cut off, and there is wire for it.
    pub fn goes_on(&self, wire: usize) -> bool {
        self.wire(wire).is_ok_and(|wire| self.pieces.get().goes_on(wire))
    }

    /// Refuses a yes given beforehand for several pieces of a real machine that does not cut them off, before anything of it moves. What is
    /// simulated is in nobody's way.
    fn require_person_between(&self, connection: &Connection) -> Result<(), LiveProblem> {
        let pieces = self.request.repeat.pieces;
        let alone = pieces > 1 && self.request.answers.confirmed && !self.request.repeat.cut;
        if alone && connection.session.simulated().is_none() {
            return Err(LiveProblem::YesForPieces { pieces });
        }
        Ok(())
    }

    fn ask(&self, connection: &mut Connection, wire: usize, first: bool) -> Result<Permit, OperationError> {
        let lines = about(self, connection, wire, Some(self.wire_lines(wire)?), connection.can_home())?;
        let question = if first {
            "Is the wire in, and may the machine move?"
        } else {
            self.pieces.get().question(self.wire(wire)?)
        };
        // The person who said yes with the request could not know when the wire before would be done. What is simulated is in
        // nobody's way.
        let session = &mut connection.session;
        let row = self.request.repeat.pieces > 1 && session.simulated().is_some();
        let confirmed = self.request.answers.confirmed && (first || row);
        let permit = ask_permit(session, self.progress, self.permit_kind(), lines, question, confirmed)?;
        self.wire_confirmed(wire)?;
        Ok(permit)
    }

    /// What to see to before a wire is bent from its beginning.
    pub fn wire_lines(&self, wire: usize) -> Result<Vec<String>, OperationError> {
        let wire = self.wire(wire)?;
        Ok(self.pieces.get().lines(self.setup.material_name(), wire, self.setup.fed_mm(wire)))
    }

    /// A person has said that there is wire for this one.
    pub fn wire_confirmed(&self, wire: usize) -> Result<(), OperationError> {
        let mut pieces = self.pieces.get();
        pieces.confirmed(self.wire(wire)?);
        self.pieces.set(pieces);
        Ok(())
    }

    /// What became of the wire that was bent last counts for the pieces, and for the wire that is left. `last`: it is the last of its piece.
    pub fn wire_ended(
        &self,
        wire: usize,
        last: bool,
        response: &mut RunResponse,
    ) -> Result<(), OperationError> {
        let Some(run) = response.wires.last() else { return Ok(()) };
        let of_job = self.wire(wire)?;
        let mut pieces = self.pieces.get();
        if run.outcome.is_whole() {
            pieces.wire_made(self.setup.fed_mm(of_job));
            if last {
                pieces.piece_made();
            }
        } else {
            // What may have been done counts: rather too little is said to be left than too much.
            let done = run.in_doubt.map_or(run.made, |[_, last]| last);
            let whole = self.setup.fed_in_mm(of_job, done as usize);
            let part = run.stopped_in.as_ref().filter(|stopped| stopped.step > done);
            pieces.wire_fed(whole + part.map_or(0.0, |stopped| stopped.made.feed_mm));
        }
        self.pieces.set(pieces);
        response.pieces = pieces.report();
        Ok(())
    }

    /// Bends a wire from its beginning. `homes`: the machine homes first. The connection is given
    /// back unless the loop could not be begun with it.
    pub fn make<'c>(
        &self,
        mut connection: Connection<'c>,
        wire: usize,
        homes: bool,
        permit: Permit,
        response: &mut RunResponse,
    ) -> (Option<Connection<'c>>, Result<(), OperationError>) {
        let (id, journal, work) = match self.prepare(&mut connection, wire, &permit) {
            Ok(prepared) => prepared,
            Err(error) => return (Some(connection), Err(error)),
        };
        connection.through(|session, observer| {
            let run = match JobRun::new(session, journal, work, Box::new(self.clock)) {
                Ok(run) => run,
                Err(error) => return (None, Err(LiveProblem::from(error).into())),
            };
            let (watch, steps) = (Watch::default(), self.step_watch(wire));
            let making = Making { task: self, wire, id, homes, run, watch, steps, past_pause: None };
            making.go(observer, permit, response)
        })
    }

    fn prepare(
        &self,
        connection: &mut Connection,
        wire: usize,
        permit: &Permit,
    ) -> Result<(String, Journal, WireJob), OperationError> {
        if self.request.accept_settings && !connection.session.differences().is_empty() {
            let session = &mut connection.session;
            let accepted = session.accept_differences(permit);
            accepted.map_err(|error| refused(session, error, "a wire was to be begun"))?;
        }
        let work = self.work(wire, connection)?;
        let (id, path) = self.folder.next(self.job.hash(), wire)?;
        let heading = Heading {
            version: 0, // filled in by the journal
            job_hash: work.run.job_hash.clone(),
            design_hash: work.run.design_hash.clone(),
            name: work.run.name.clone(),
            wire,
            piece: self.pieces.get().piece(),
            steps: work.run.steps,
            machine: work.run.machine.clone(),
            driver: connection.driver_id.clone(),
            driver_version: connection.driver_version.clone(),
            port: connection.port.clone(),
            material: self.setup.material_id().to_owned(),
            stock_mm: work.run.stock_mm,
            done_by: connection.session.done_by(),
            estimates_s: work.estimates.iter().map(|time| time.total().as_secs_f64()).collect(),
        };
        let journal = Journal::create(&path, heading, self.clock.stamp()).map_err(LiveProblem::from)?;
        Ok((id, journal, work))
    }
}
