//! An interrupted wire, resumed as its journal and the machine allow.

use std::time::Instant;

use wirebend_driver_host::jobs::{JobRun, Journal, Piece, Resume, Settled};
use wirebend_driver_host::{Permit, PermitKind, Standstill};
use wirebend_error::InputName;
use wirebend_files::document::JobPause;
use wirebend_planning::pauses;

use super::about::{about, first};
use super::absence::Watch;
use super::doubt::{is_settled, said_before};
use super::interrupted::Interrupted;
use super::making::Making;
use super::report::{LeftBecause, RunOutcome, RunResponse, WireRun};
use super::task::Task;
use crate::live::{Connection, Unnamed, ask_permit, connect, refused};
use crate::{Decided, LiveProblem, OperationError};

/// The session knows what came of a stop long before.
const STOPPING: std::time::Duration = std::time::Duration::from_secs(30);

/// What is to be done with an interrupted wire.
enum Settling {
    /// It resumes, as the user has confirmed.
    Resume(Permit),
    /// Nothing moves.
    Nothing(Box<WireRun>),
}

impl Task<'_> {
    /// Resumes the wire that was interrupted; says so when there is none.
    pub fn resume(&self, decided: Option<Decided>) -> Result<RunResponse, OperationError> {
        let mut response = self.response();
        let Some(interrupted) = self.interrupted(&mut response)? else { return Ok(response) };
        let begun_at = interrupted.begun_at();
        let at = self.at(Some(&interrupted), Unnamed::SimulateAgain(&begun_at));
        let mut connection = connect(self.app, &at, self.progress)?;
        // A machine that still is in the wire knows it itself.
        if connection.session.resume_state().is_none() && !interrupted.is_made() {
            connection.settle_head(self.request.answers.head_at_deg, self.request.answers.confirmed)?;
        }
        let (connection, ended) = self.resume_through(connection, interrupted, true, decided, &mut response);
        ended?;
        if let Some(mut connection) = connection {
            response.notes.append(&mut connection.observer.warnings);
        }
        Ok(response)
    }

    /// Resumes a wire through a connection, which is given back unless the loop could not be begun with it.
    /// Where the machine may still be in the wire, that has to be one with the token of its journal. `homes`: the
    /// machine, if it can, homes where it is not in the wire any more.
    pub fn resume_through<'c>(
        &self,
        connection: Connection<'c>,
        interrupted: Interrupted,
        homes: bool,
        decided: Option<Decided>,
        response: &mut RunResponse,
    ) -> (Option<Connection<'c>>, Result<(), OperationError>) {
        let Interrupted { wire, id, journal } = interrupted;
        let homes = homes && connection.can_home();
        let ready = connection
            .require_settings(self.setup.machine_id(), self.request.accept_settings)
            .map_err(OperationError::from)
            .and_then(|()| self.require_within(&connection, wire, journal.state().done + 1))
            .and_then(|()| Ok((about(self, &connection, wire, None, false)?, self.work(wire, &connection)?)));
        let (mut lines, work) = match ready {
            Ok(ready) => ready,
            Err(error) => return (Some(connection), Err(error)),
        };
        if let Some(Piece { number, of }) = journal.state().heading.piece {
            lines.push(format!("it is piece {number} of {of}; arm the machine again for those after it"));
        }
        let ahead = |pause: &&JobPause| pause.after > journal.state().done;
        let ahead: Vec<JobPause> = self.pauses(wire).iter().filter(ahead).cloned().collect();
        lines.extend(pauses::lines(&ahead));
        let begun_at = &journal.state().heading.port;
        if *begun_at != connection.port {
            lines.push(format!("it was begun at {begun_at}"));
        }
        response.port = Some(connection.port.clone());
        response.identity = Some(connection.session.identity().to_owned());
        connection.through(|session, observer| {
            let run = match JobRun::new(session, journal, work, Box::new(self.clock)) {
                Ok(run) => run,
                Err(error) => return (None, Err(LiveProblem::from(error).into())),
            };
            let (watch, steps) = (Watch::default(), self.step_watch(wire));
            let mut making = Making { task: self, wire, id, homes, run, watch, steps, past_pause: None };
            match self.settle(&mut making, lines, decided) {
                Ok(Settling::Resume(permit)) => making.go(observer, permit, response),
                Ok(Settling::Nothing(made)) => {
                    // That it is finished may have been written down just now.
                    let kept = making.keep(response);
                    response.wires.push(*made);
                    (Some(making.into_session()), kept)
                }
                Err(error) => (Some(making.into_session()), Err(error)),
            }
        })
    }

    /// What has to be known before the wire resumes: what was done, and the user's yes.
    fn settle(
        &self,
        making: &mut Making,
        mut lines: Vec<String>,
        mut decided: Option<Decided>,
    ) -> Result<Settling, OperationError> {
        // What was said before, and was written down then, is not said again.
        decided = decided.filter(|decided| !is_settled(self, &making.run, *decided));
        if decided.is_none() && !self.request.answers.confirmed {
            self.ask_what_was_said(making)?;
        }
        let permit = loop {
            match (making.run.resume_from(), decided) {
                (Resume::Contradiction(contradiction), _) => {
                    self.stop_contradiction(making, &contradiction.to_string(), decided.is_some())?;
                }
                (Resume::Ask { in_doubt, last }, _) => {
                    self.decide(making, in_doubt, last, decided.take())?;
                }
                // A person may know better than the machine.
                (Resume::Arm { from }, Some(said))
                    if said.step == from && making.run.doubtful().is_some() =>
                {
                    self.decide(making, from, from, decided.take())?;
                }
                // They may correct themselves as long as nothing is bent after it.
                (_, Some(said)) if making.run.said().any(|(step, _)| step == said.step) => {
                    making.run.take_back(said.step).map_err(LiveProblem::from)?;
                }
                (_, Some(said)) => return Err(self.not_in_doubt(making, said).into()),
                (Resume::Nothing(settled), None) => {
                    return Ok(Settling::Nothing(Box::new(self.settled(making, settled)?)));
                }
                (Resume::Reattach { from, done }, None) => {
                    lines.push(format!(
                        "the machine still is in this wire: of its steps {done} {} done; it resumes at step {from} without homing",
                        if done == 1 { "is" } else { "are" }
                    ));
                    lines.extend(making.stands_at_pause(done));
                    break self.ask_again(making, lines)?;
                }
                (Resume::Arm { from }, None) => {
                    lines.push(format!(
                        "of its steps {} {} done: it resumes at step {from}; leave the wire as it is",
                        from - 1,
                        if from == 2 { "is" } else { "are" }
                    ));
                    lines.extend(self.rest_of(making, from)?);
                    lines.extend(making.stands_at_pause(from - 1));
                    if making.homes {
                        let reference = making.run.session().reference();
                        lines.push(first(reference, "see that the wire is out of the way of the bend axis"));
                    }
                    break self.ask_again(making, lines)?;
                }
            }
        };
        if self.request.accept_settings && !making.run.session().differences().is_empty() {
            let session = making.run.session();
            let accepted = session.accept_differences(&permit);
            accepted.map_err(|error| refused(session, error, "a wire was about to resume"))?;
        }
        Ok(Settling::Resume(permit))
    }

    /// What was said before counts, unless the person takes it back now.
    fn ask_what_was_said(&self, making: &mut Making) -> Result<(), LiveProblem> {
        let Some((first, question)) = said_before(self, &making.run) else { return Ok(()) };
        if self.progress.is_so(&question) == Some(false) {
            making.run.take_back(first)?;
        }
        Ok(())
    }

    fn ask_again(&self, making: &mut Making, lines: Vec<String>) -> Result<Permit, LiveProblem> {
        let (question, confirmed) = ("May the machine move and resume?", self.request.answers.confirmed);
        ask_permit(making.run.session(), self.progress, PermitKind::Wire, lines, question, confirmed)
    }

    /// The wire that is not over. When none is, those that are finished are reported.
    /// From here on it is open for this caller alone.
    pub fn interrupted(&self, response: &mut RunResponse) -> Result<Option<Interrupted>, OperationError> {
        let (mut open, mut over) = (Vec::new(), Vec::new());
        for wire in self.wanted() {
            let Some(kept) = self.last(wire)? else {
                response.left.push(wire);
                response.left_because = Some(LeftBecause::NothingToResume);
                continue;
            };
            match &kept.read {
                Ok(written) if written.state.is_over() => over.push((wire, kept)),
                _ => open.push((wire, kept)),
            }
        }
        if open.len() > 1 {
            let wires = open.iter().map(|(wire, _)| *wire).collect();
            return Err(LiveProblem::SeveralUnfinished { wires }.into());
        }
        let Some((wire, kept)) = open.pop() else {
            if over.is_empty() {
                return Err(LiveProblem::NothingBegun { input: InputName::Resume }.into());
            }
            for (wire, kept) in over {
                let done = kept.read.as_ref().map(|written| written.state.done).unwrap_or_default();
                let made = done == kept.read.as_ref().map_or(0, |written| written.state.heading.steps);
                let done_by =
                    kept.read.as_ref().map(|written| written.state.heading.done_by).unwrap_or_default();
                let outcome = if made { RunOutcome::ended_before(done_by) } else { RunOutcome::Abandoned };
                response.wires.push(self.untouched(wire, &kept.id, outcome, done, done_by)?);
            }
            return Ok(None);
        };
        if let Err(error) = kept.read {
            return Err(self.unreadable(wire, error).into());
        }
        let journal = Journal::open(&kept.path).map_err(LiveProblem::from)?;
        Ok(Some(Interrupted { wire, id: kept.id, journal }))
    }

    fn stop_contradiction(
        &self,
        making: &mut Making,
        reason: &str,
        decided: bool,
    ) -> Result<(), OperationError> {
        let question = format!("{reason}. Stop the machine now, and say step by step what was done?");
        if !decided && self.progress.confirm(&question) != Some(true) {
            let run = self.target(making.wire);
            return Err(LiveProblem::Contradiction { reason: reason.to_owned(), run }.into());
        }
        let (_, noted) = making.run.stop();
        noted.map_err(LiveProblem::from)?;
        // The machine reports that it has stopped before it can be asked to home.
        let begun = Instant::now();
        while making.run.session().standstill() == Some(Standstill::Awaited) && begun.elapsed() < STOPPING {
            making.run.advance().map_err(LiveProblem::from)?;
            std::thread::sleep(crate::live::PAUSE);
        }
        if making.run.session().standstill() != Some(Standstill::Confirmed) {
            return Err(LiveProblem::MayMove { during: "it was in the wire of before" }.into());
        }
        // A person has asked for this one, and so it ends nothing that follows.
        let _ = making.run.session().take_stop();
        Ok(())
    }

    fn settled(&self, making: &mut Making, settled: Settled) -> Result<WireRun, OperationError> {
        if settled == Settled::AllMade {
            making.run.settle().map_err(LiveProblem::from)?;
        }
        let done_by = making.run.journal_state().heading.done_by;
        let outcome = if settled == Settled::Abandoned {
            RunOutcome::Abandoned
        } else {
            RunOutcome::ended_before(done_by)
        };
        self.untouched(making.wire, &making.id, outcome, making.run.journal_state().done, done_by)
    }
}
