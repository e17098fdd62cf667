//! An interrupted wire, gone on with as its journal and the machine allow.

use std::time::Instant;

use wirebend_driver_host::api::Capability;
use wirebend_driver_host::jobs::{JobRun, Journal, Resume, Settled};

use super::about::about;
use super::making::{Making, Watch};
use super::report::{RunOutcome, RunResponse};
use super::task::Task;
use crate::live::{Connection, Unnamed, Yes};
use crate::runs::Kept;
use crate::{AppError, Decision, Doubt, LiveProblem};

/// How long a stop may take to be told.
const STOPPING: std::time::Duration = std::time::Duration::from_secs(2);

impl Task<'_> {
    /// Goes on with the wire that was interrupted; says so when there is none.
    pub fn resume(&self, decided: Option<Decision>) -> Result<RunResponse, AppError> {
        let mut response = self.response();
        let Some((wire, kept)) = self.interrupted(&mut response)? else { return Ok(response) };
        // From here on nobody else has it.
        let journal = Journal::open(&kept.path).map_err(LiveProblem::from)?;
        let account = kept.read.ok().map(|written| written.account);
        let token = account.as_ref().and_then(|account| account.token.as_deref());
        let begun_at = account.as_ref().map_or("", |account| account.heading.port.as_str());
        let at = self.at(token, Unnamed::SimulateAgain(begun_at));
        let mut connection = self.app.connect(&at, self.progress)?;
        connection.require_settings(self.setup.machine_id(), self.request.accept_settings)?;
        response.port = Some(connection.port.clone());
        response.identity = Some(connection.session.identity().to_owned());
        let homes = connection.session.driver().description().can(Capability::Home);
        let lines = about(self, &connection, wire, false)?;
        let Connection { session, mut hearing, .. } = connection;
        let work = self.work(wire)?;
        let run = JobRun::new(session, journal, work, Box::new(self.clock)).map_err(LiveProblem::from)?;
        let mut making = Making { task: self, wire, id: kept.id, run, watch: Watch::default() };
        // What was said with the request was said of the first step in doubt alone.
        let mut decided = decided;
        let yes = loop {
            match making.run.resume_from() {
                Resume::Contradiction(contradiction) => {
                    self.stop_contradiction(&mut making, &contradiction.to_string(), decided.is_some())?;
                }
                Resume::Ask { in_doubt, last } => {
                    self.decide(&mut making, in_doubt, last, decided.take())?;
                }
                Resume::Nothing(settled) => {
                    response.wires.push(self.settled(&mut making, settled)?);
                    return Ok(response);
                }
                Resume::GoOn { from, done } => {
                    let mut lines = lines;
                    lines.push(format!(
                        "the machine still is in this wire, and has made {done} steps: it goes on at step {from} without homing"
                    ));
                    break self.ask_again(lines)?;
                }
                Resume::TakeUp { from } => {
                    let mut lines = lines;
                    lines.push(format!(
                        "{} steps are made: it goes on at step {from}; leave the wire as it is",
                        from - 1
                    ));
                    if homes {
                        lines.push("first the machine searches its reference: see that the wire is out of the way of the bend axis".to_owned());
                    }
                    break self.ask_again(lines)?;
                }
            }
        };
        if self.request.accept_settings && !making.run.session().differences().is_empty() {
            making.run.session().accept_differences(yes.confirmed()?);
        }
        let (made, session) = making.go(&mut hearing, &yes, &mut response)?;
        response.wires.push(made);
        drop(session);
        response.notes.append(&mut hearing.warnings);
        Ok(response)
    }

    fn ask_again(&self, lines: Vec<String>) -> Result<Yes, LiveProblem> {
        Yes::ask(self.progress, lines, "May the machine move and go on?", self.request.confirmed)
    }

    /// The wire that is not over. When none is, those that are made are told.
    fn interrupted(&self, response: &mut RunResponse) -> Result<Option<(usize, Kept)>, AppError> {
        let (mut open, mut over) = (Vec::new(), Vec::new());
        for wire in self.wanted() {
            let Some(kept) = self.last(wire)? else { continue };
            match &kept.read {
                Ok(written) if written.account.is_over() => over.push((wire, kept)),
                _ => open.push((wire, kept)),
            }
        }
        if open.len() > 1 {
            let wires = open.iter().map(|(wire, _)| *wire).collect();
            return Err(LiveProblem::SeveralUnfinished { wires }.into());
        }
        let Some((wire, kept)) = open.pop() else {
            if over.is_empty() {
                return Err(LiveProblem::NothingBegun { option: "--resume" }.into());
            }
            for (wire, kept) in over {
                let done = kept.read.as_ref().map(|written| written.account.done).unwrap_or_default();
                let made = done == kept.read.as_ref().map_or(0, |written| written.account.heading.steps);
                let outcome = if made { RunOutcome::MadeBefore } else { RunOutcome::Abandoned };
                response.wires.push(self.untouched(wire, &kept.id, outcome, done)?);
            }
            return Ok(None);
        };
        if let Err(error) = kept.read {
            let abandon = self.command(wire, "--abandon");
            return Err(LiveProblem::DamagedJournal { error, abandon }.into());
        }
        Ok(Some((wire, kept)))
    }

    /// A person looks whether a step was made.
    fn decide(
        &self,
        making: &mut Making,
        step: u32,
        last: u32,
        decided: Option<Decision>,
    ) -> Result<(), AppError> {
        let (designed, told) = self.step(making.wire, step)?;
        let of = making.run.account().heading.steps;
        let doubt = Doubt { wire: making.wire, step, of, last, designed, told };
        let said = decided.or_else(|| self.progress.decide(&doubt));
        let Some(said) = said else {
            let command = self.command(making.wire, "--resume");
            return Err(LiveProblem::InDoubt { doubt: Box::new(doubt), command }.into());
        };
        making.run.decide(step, said == Decision::Made).map_err(LiveProblem::from)?;
        Ok(())
    }

    fn stop_contradiction(&self, making: &mut Making, reason: &str, decided: bool) -> Result<(), AppError> {
        let question = format!("{reason}. Stop the machine now, and say step by step what was made?");
        if !decided && self.progress.confirm(&question) != Some(true) {
            let command = self.command(making.wire, "--resume");
            return Err(LiveProblem::Contradiction { reason: reason.to_owned(), command }.into());
        }
        let (_, noted) = making.run.stop();
        noted.map_err(LiveProblem::from)?;
        // The machine tells that it has stopped before it can be asked to home.
        let begun = Instant::now();
        while begun.elapsed() < STOPPING && making.run.session().poll().is_ok_and(|events| events.is_empty())
        {
            std::thread::sleep(crate::live::PAUSE);
        }
        Ok(())
    }

    fn settled(&self, making: &mut Making, settled: Settled) -> Result<super::WireRun, AppError> {
        if settled == Settled::AllMade {
            // Nothing moves: that the wire is made is written down.
            let nothing = Yes::where_nothing_moves().confirmed()?;
            let _ = making.run.start(nothing);
        }
        let outcome =
            if settled == Settled::Abandoned { RunOutcome::Abandoned } else { RunOutcome::MadeBefore };
        self.untouched(making.wire, &making.id, outcome, making.run.account().done)
    }
}
