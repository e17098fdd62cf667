//! A job's wires made from their beginning, one after the other.

use std::time::Duration;

use wirebend_driver_host::jobs::{Clock, Heading, JobRun, Journal, Work};

use super::about::about;
use super::making::{Making, Watch};
use super::report::{LeftBecause, RunResponse};
use super::task::Task;
use crate::live::{Connection, Unnamed, Yes, Zero};
use crate::{AppError, LiveProblem};

impl Task<'_> {
    /// Makes the wires that were asked for, none of which may be unfinished.
    pub fn begin(&self) -> Result<RunResponse, AppError> {
        let wanted = self.wanted();
        wanted.iter().try_for_each(|&wire| self.require_clear(wire))?;
        let mut connection = self.app.connect(&self.at(None, Unnamed::Simulate), self.progress)?;
        connection.require_settings(self.setup.machine_id(), self.request.accept_settings)?;
        wanted.iter().try_for_each(|&wire| self.require_within(&connection, wire, 1))?;
        connection.settle_head(self.request.head_at_deg, self.request.confirmed)?;
        let mut response = self.response();
        response.port = Some(connection.port.clone());
        response.identity = Some(connection.session.identity().to_owned());
        for (place, &wire) in wanted.iter().enumerate() {
            let yes = match self.ask(&mut connection, wire, place == 0) {
                Ok(yes) => yes,
                // What is made is made: the answer tells of the rest.
                Err(AppError::Live(problem)) if place > 0 => {
                    response.left_because = Some(match problem {
                        LiveProblem::NotConfirmed | LiveProblem::ZeroNotConfirmed => LeftBecause::NobodyAsked,
                        _ => LeftBecause::Declined,
                    });
                    response.left = wanted[place..].to_vec();
                    break;
                }
                Err(error) => return Err(error),
            };
            let homes = connection.can_home();
            let (back, made) = self.make(connection, wire, homes, &yes, &mut response);
            made?;
            // It is given back where the wire was made or interrupted.
            let Some(back) = back else { return Ok(response) };
            connection = back;
            if !response.wires.last().is_some_and(|made| made.outcome.is_whole()) {
                response.left = wanted[place + 1..].to_vec();
                break;
            }
        }
        response.notes.append(&mut connection.hearing.warnings);
        Ok(response)
    }

    fn ask(&self, connection: &mut Connection, wire: usize, first: bool) -> Result<Yes, AppError> {
        let lines = about(self, connection, wire, true, connection.can_home())?;
        let question = if first {
            "Is the wire in, and may the machine move?"
        } else {
            "Is the wire before taken out and new wire in, and may the machine move?"
        };
        // The person who said yes with the request could not know when the wire before would be done.
        let yes = Yes::ask(self.progress, lines, question, first && self.request.confirmed)?;
        if connection.can_home() {
            // Before anything of the wire is written down.
            connection.ask_zero(Zero::Wire)?;
        }
        Ok(yes)
    }

    /// Makes a wire from its beginning. `homes`: the machine searches its reference first. The connection is given
    /// back unless the loop could not be begun with it.
    pub fn make<'c>(
        &self,
        mut connection: Connection<'c>,
        wire: usize,
        homes: bool,
        yes: &Yes,
        response: &mut RunResponse,
    ) -> (Option<Connection<'c>>, Result<(), AppError>) {
        let (id, journal, work) = match self.prepare(&mut connection, wire, yes) {
            Ok(prepared) => prepared,
            Err(error) => return (Some(connection), Err(error)),
        };
        connection.through(|session, hearing| {
            let run = match JobRun::new(session, journal, work, Box::new(self.clock)) {
                Ok(run) => run,
                Err(error) => return (None, Err(LiveProblem::from(error).into())),
            };
            let making = Making { task: self, wire, id, homes, run, watch: Watch::default() };
            making.go(hearing, yes, response)
        })
    }

    fn prepare(
        &self,
        connection: &mut Connection,
        wire: usize,
        yes: &Yes,
    ) -> Result<(String, Journal, Work), AppError> {
        if self.request.accept_settings && !connection.session.differences().is_empty() {
            connection.session.accept_differences(yes.confirmed()?);
        }
        let work = self.work(wire, connection)?;
        let (id, path) = self.folder.next(self.job.hash(), wire)?;
        let heading = Heading {
            version: 0, // filled in by the journal
            job_hash: work.run.job_hash.clone(),
            design_hash: work.run.design_hash.clone(),
            name: work.run.name.clone(),
            wire,
            steps: work.run.steps,
            machine: work.run.machine.clone(),
            driver: connection.driver_id.clone(),
            driver_version: connection.driver_version.clone(),
            port: connection.port.clone(),
            material: self.setup.material_id().to_owned(),
            stock_mm: work.run.stock_mm,
            done_by: connection.session.done_by(),
            estimates_s: work.estimates.iter().map(Duration::as_secs_f64).collect(),
        };
        let journal = Journal::create(&path, heading, self.clock.stamp()).map_err(LiveProblem::from)?;
        Ok((id, journal, work))
    }
}
