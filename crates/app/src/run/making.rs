//! The loop that makes one wire, and what becomes of it.

use std::time::{Duration, Instant, SystemTime};

use wirebend_driver_host::api::{DriverError, PausedBy};
use wirebend_driver_host::jobs::{JobError, JobRun, Progress as Told, Resume, Standing};
use wirebend_driver_host::{Session, Standstill, StoppedBy};

use super::report::{RunOutcome, RunProblem, RunResponse, StoppedIn, WireRun};
use super::task::Task;
use crate::live::{Hearing, PAUSE, StopWatch, Yes, await_standstill, home, stop_of};
use crate::simulate::KeptWire;
use crate::{AppError, LiveProblem, News, Wish};

/// How often a front end hears how far the wire is, at least.
const NEWS: Duration = Duration::from_millis(200);
/// A program that was away for longer has not watched the machine, as when the computer slept: who said yes then may
/// have their hands in it now. A second of silence, after which a machine holds, a busy computer has now and then.
const AWAY: Duration = Duration::from_secs(10);

/// One wire in the making.
pub(super) struct Making<'t, 'a> {
    pub task: &'t Task<'a>,
    pub wire: usize,
    pub id: String,
    /// Whether the machine searches its reference before it begins or takes the wire up.
    pub homes: bool,
    pub run: JobRun,
    pub watch: Watch,
}

/// Whether the program has watched the machine all the time. By the time of day, since that goes on while the
/// computer sleeps.
#[derive(Default)]
pub(super) struct Watch {
    looked: Option<SystemTime>,
    /// When it came back.
    away: Option<Instant>,
}

impl Watch {
    fn look(&mut self) {
        let now = SystemTime::now();
        let before = self.looked.replace(now);
        // A clock that was set back says nothing.
        let gap = before.and_then(|before| now.duration_since(before).ok()).unwrap_or_default();
        if gap > AWAY {
            self.away = Some(Instant::now());
        }
    }

    /// Whether it was away shortly before.
    fn was_away(&self) -> bool {
        self.away.is_some_and(|back| back.elapsed() < AWAY)
    }
}

/// What was heard besides what the journal has.
#[derive(Default)]
struct Heard {
    stopped_by: Option<StoppedBy>,
    fault: Option<DriverError>,
    /// Why it was stopped where nobody has asked for that.
    held: Option<RunProblem>,
    corners_mm: Vec<[f64; 3]>,
}

impl Making<'_, '_> {
    /// Begins the wire, or goes on with it, and makes it to its end or to where it is interrupted. The session is
    /// given back whatever becomes of it.
    pub fn go(
        mut self,
        hearing: &mut Hearing,
        yes: &Yes,
        response: &mut RunResponse,
    ) -> (Option<Session>, Result<(), AppError>) {
        let made = self.make(hearing, yes, response).map(|made| response.wires.push(made));
        (Some(self.into_session()), made)
    }

    pub fn into_session(self) -> Session {
        self.run.into_parts().0
    }

    fn make(
        &mut self,
        hearing: &mut Hearing,
        yes: &Yes,
        response: &mut RunResponse,
    ) -> Result<WireRun, AppError> {
        let mut heard = Heard::default();
        let driven = self.begin(hearing, yes).and_then(|()| self.drive(hearing, &mut heard));
        let standstill = self.see_it_stand(hearing);
        // What failed while a stop was on its way is its doing.
        let made = driven.is_ok() && self.run.account().standing == Standing::Finished;
        let stop = if made { None } else { stop_of(self.run.session()) };
        match driven {
            Ok(()) | Err(AppError::Live(LiveProblem::Stopped { .. })) => {}
            Err(AppError::Live(LiveProblem::Job(error @ JobError::Journal(_)))) => {
                let stands = standstill.is_none_or(|standstill| standstill == Standstill::Confirmed);
                let (error, resume) = (Box::new(error), self.task.command(self.wire, "--resume"));
                return Err(LiveProblem::Unrecorded { error, stands, resume }.into());
            }
            Err(AppError::Live(error @ (LiveProblem::Held { .. } | LiveProblem::Unstopped { .. }))) => {
                heard.held = Some(RunProblem::from(&error));
            }
            Err(_) if stop.is_some() => {}
            Err(AppError::Live(LiveProblem::Fault(error))) => heard.fault = Some(error),
            // The search for the reference has failed, and the machine was stopped for it.
            Err(AppError::Live(error)) if standstill.is_some() => heard.held = Some(RunProblem::from(&error)),
            Err(error) => {
                self.keep(response)?;
                return Err(error);
            }
        }
        // One that came before the wire was begun the loop does not know of.
        if stop.is_some() && !self.run.account().is_over() {
            self.run.note_stop().map_err(LiveProblem::from)?;
        }
        heard.stopped_by = heard.stopped_by.or(stop.map(|outcome| outcome.by));
        let deviations_mm = self.deviations(&heard)?;
        if let Some(deviations) = &deviations_mm {
            self.run.note_deviations(deviations.clone()).map_err(LiveProblem::from)?;
        }
        self.keep(response)?;
        self.report(&heard, standstill, deviations_mm)
    }

    /// Where the machine was stopped, or its driver was lost: waits until it stands, or nobody will know.
    fn see_it_stand(&mut self, hearing: &mut Hearing) -> Option<Standstill> {
        let mut watch = StopWatch::default();
        while self.run.session().standstill() == Some(Standstill::Awaited) {
            // What cannot be written down any more is seen all the same.
            if self.look(hearing, &mut Heard::default()).is_err() {
                return await_standstill(self.run.session(), hearing, || false);
            }
            watch.look(self.run.session(), hearing);
        }
        self.run.session().standstill()
    }

    fn begin(&mut self, hearing: &mut Hearing, yes: &Yes) -> Result<(), AppError> {
        match self.run.resume_from() {
            Resume::GoOn { .. } => self.look_again(hearing)?,
            _ if self.homes => home(self.run.session(), hearing, yes)?,
            _ => {}
        }
        hearing.progress.stage("making the wire");
        self.run.start(yes.confirmed()?).map_err(LiveProblem::from)?;
        Ok(())
    }

    /// While a person was asked, nobody has looked: the machine may hold since.
    fn look_again(&mut self, hearing: &mut Hearing) -> Result<(), AppError> {
        let begun = Instant::now();
        while begun.elapsed() < NEWS * 3 {
            let mut heard = Heard::default();
            self.look(hearing, &mut heard)?;
            if let Some(error) = heard.fault {
                return Err(LiveProblem::Fault(error).into());
            }
        }
        Ok(())
    }

    fn drive(&mut self, hearing: &mut Hearing, heard: &mut Heard) -> Result<(), AppError> {
        let mut told = None;
        let mut watch = StopWatch::default();
        while !self.run.is_over() {
            watch.look(self.run.session(), hearing);
            if let Some(wish) = hearing.progress.wish() {
                self.grant(wish, hearing);
            }
            let hold = self.look(hearing, heard)?;
            if told.is_none_or(|at: Instant| at.elapsed() > NEWS) {
                told = Some(Instant::now());
                self.tell(hearing);
            }
            match hold {
                Some(PausedBy::Silence) => self.go_on(hearing, self.watch.was_away())?,
                Some(PausedBy::Machine) => self.go_on(hearing, true)?,
                // Whoever asked for it lets it go on.
                Some(PausedBy::Program) | None => {}
            }
        }
        self.tell(hearing);
        Ok(())
    }

    /// What cannot be granted now ends nothing: a driver that failed over it is heard of at the next turn.
    fn grant(&mut self, wish: Wish, hearing: &mut Hearing) {
        let granted = match wish {
            Wish::Pause => self.run.pause(),
            Wish::Resume => self.run.resume(),
        };
        if let Err(error) = granted.map_err(LiveProblem::from)
            && self.run.session().last_stop().is_none()
        {
            hearing.warn(error.code(), &error.to_string());
        }
    }

    /// Lets the loop take one turn; why the machine holds, if it has begun to.
    fn look(&mut self, hearing: &mut Hearing, heard: &mut Heard) -> Result<Option<PausedBy>, AppError> {
        self.watch.look();
        let told = match self.run.advance() {
            Ok(told) => told,
            Err(error) => {
                // What cannot be written down is not made.
                if self.run.session().standstill().is_none() {
                    let _ = self.run.stop();
                }
                return Err(LiveProblem::from(error).into());
            }
        };
        let mut hold = None;
        if told.is_empty() {
            std::thread::sleep(PAUSE);
        }
        for one in told {
            match one {
                Told::Position(position) => hearing.position(position),
                Told::Console { direction, text } => hearing.console(direction, &text),
                Told::Warning(error) => hearing.warn(&error.code, &error.to_string()),
                Told::Paused { by } => {
                    hold = Some(by);
                    hearing.progress.news(&News::Paused { by });
                }
                Told::Resumed => {
                    hold = None;
                    hearing.progress.news(&News::Resumed);
                }
                Told::Wire { corners_mm, .. } => heard.corners_mm = corners_mm,
                Told::Stopped { by } => heard.stopped_by = by,
                Told::Fault { error, .. } => heard.fault = Some(error),
                Told::Made { n, of } => {
                    tracing::info!("step {n} of {of} is made");
                    self.tell(hearing);
                }
                // It is read from the session at the end.
                Told::Standstill { .. } | Told::Sent { .. } | Told::Finished => {}
            }
        }
        Ok(hold)
    }

    /// The machine holds, and nobody has asked this program for it.
    fn go_on(&mut self, hearing: &mut Hearing, ask: bool) -> Result<(), AppError> {
        let question = if self.watch.was_away() {
            "the machine holds: this program was away for a while. May it go on?"
        } else {
            "the machine was made to hold at the machine itself. May it go on?"
        };
        let said = if ask { hearing.progress.confirm(question) } else { Some(true) };
        if self.run.session().last_stop().is_some() {
            return Ok(());
        }
        match said {
            Some(true) => self.run.resume().map_err(LiveProblem::from)?,
            // Whoever made it hold is there, and lets it go on at the machine.
            None if !self.watch.was_away() => {}
            Some(false) | None => {
                hearing.warn("held", "the machine held, and nobody said that it may go on: it was stopped");
                self.run.stop().1.map_err(LiveProblem::from)?;
            }
        }
        Ok(())
    }

    fn tell(&self, hearing: &Hearing) {
        let overview = self.run.overview();
        hearing.progress.news(&News::Wire {
            wire: self.wire,
            made: overview.made,
            sent: overview.sent,
            of: overview.of,
            elapsed_s: overview.elapsed.as_secs_f64(),
            remaining_s: overview.remaining.as_secs_f64(),
        });
    }

    fn deviations(&self, heard: &Heard) -> Result<Option<Vec<f64>>, AppError> {
        if heard.corners_mm.is_empty() {
            return Ok(None);
        }
        let kept = KeptWire::new(&self.task.file, self.task.wire(self.wire)?, &self.task.setup)?;
        Ok(kept.deviations_mm(&heard.corners_mm))
    }

    /// Writes the record.
    pub fn keep(&self, response: &mut RunResponse) -> Result<(), AppError> {
        let path = self.task.folder.path().join(format!("{}.journal", self.id));
        self.task.keep(self.run.record().as_ref(), &path, self.wire, response)
    }

    /// The step that was stopped in its middle, where the machine counts how far it was.
    fn stopped_in(&self) -> Result<Option<StoppedIn>, AppError> {
        let signs = self.task.setup.signs;
        let told = self.run.account().part_made.and_then(|told| told.made);
        let Some((doubtful, told)) = self.run.doubtful().zip(told) else { return Ok(None) };
        let Some(counted) = doubtful.counted else { return Ok(None) };
        let (_, of) = self.task.step(self.wire, doubtful.step)?;
        Ok(Some(StoppedIn {
            step: doubtful.step,
            made: signs.part(counted),
            of,
            bend_at_deg: signs.canonical(told).bend_deg,
            sure: !doubtful.measure,
        }))
    }

    fn report(
        &self,
        heard: &Heard,
        standstill: Option<Standstill>,
        deviations_mm: Option<Vec<f64>>,
    ) -> Result<WireRun, AppError> {
        let account = self.run.account();
        let done_by = account.heading.done_by;
        let outcome = match account.standing {
            Standing::Finished => RunOutcome::ended(done_by),
            Standing::Abandoned => RunOutcome::Abandoned,
            Standing::Stopped => RunOutcome::Stopped,
            // What fails while a stop is on its way is its doing.
            Standing::Faulted if account.stopped => RunOutcome::Stopped,
            _ => RunOutcome::Failed,
        };
        let over = account.is_over();
        let untouched = self.task.untouched(self.wire, &self.id, outcome, account.done, done_by)?;
        let fault = heard.fault.as_ref().map(RunProblem::from);
        let stopped_in = self.stopped_in()?.filter(|_| !over);
        let sure = stopped_in.as_ref().is_some_and(|step| step.sure);
        let in_doubt = account.in_doubt().filter(|_| !sure);
        Ok(WireRun {
            in_doubt: in_doubt.map(|steps| [*steps.start(), *steps.end()]),
            stopped_in,
            elapsed_s: self.run.overview().elapsed.as_secs_f64(),
            stopped_by: heard.stopped_by.filter(|_| !over),
            standstill,
            problem: fault.filter(|_| outcome == RunOutcome::Failed).or_else(|| heard.held.clone()),
            deviations_mm,
            // Of a wire of which nothing was sent there is nothing to go on with.
            resume: (!over && account.sent > 0).then(|| self.task.command(self.wire, "--resume")),
            ..untouched
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Were a sleep not noticed, a machine would go on by itself under the hands of whoever opens the lid.
    #[test]
    fn a_program_that_slept_was_away() {
        let mut watch = Watch::default();
        watch.look();
        watch.look();
        assert!(!watch.was_away());
        watch.looked = SystemTime::now().checked_sub(AWAY * 2);
        watch.look();
        assert!(watch.was_away());
        // A clock that was set back is no sleep.
        let mut watch = Watch { looked: SystemTime::now().checked_add(AWAY * 2), away: None };
        watch.look();
        assert!(!watch.was_away());
    }
}
