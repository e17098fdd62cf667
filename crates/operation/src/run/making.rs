//! The loop that runs one wire, and what becomes of it.

use std::time::{Duration, Instant};

use wirebend_driver_host::api::PausedBy;
use wirebend_driver_host::jobs::{JobError, JobRun, JobState, PartMade, Progress as Told, Resume};
use wirebend_driver_host::{Permit, Session, Standstill, StoppedBy, report_of};
use wirebend_error::{ErrorCode, ProblemReport};

use super::absence::{Watch, ask_after_absence, may_surprise};
use super::report::{RunOutcome, RunResponse, StoppedIn, WireRun};
use super::step_watch::StepWatch;
use super::task::Task;
use crate::live::{MachineObserver, PAUSE, StopWatch, await_standstill, home, stop_of};
use crate::{LiveProblem, MachineEvent, OperationError, Wish};
use wirebend_planning::simulate::KeptWire;

/// How long a machine is looked at where it is not known whether it holds.
const LOOK_AGAIN: Duration = Duration::from_millis(600);
/// One wire that is being bent.
pub(super) struct Making<'t, 'a> {
    pub task: &'t Task<'a>,
    pub wire: usize,
    pub id: String,
    /// Whether the machine homes before it begins or resumes the wire.
    pub homes: bool,
    pub run: JobRun,
    pub watch: Watch,
    pub steps: StepWatch,
    /// The step after which the wire stands at a pause point of which a person was told before they said that it resumes.
    pub past_pause: Option<u32>,
}

/// A wire that a simulated machine has bent, beside its design.
struct Bent {
    corners_mm: Vec<[f64; 3]>,
    /// How far each vertex of the design is from it, where they can be found on it.
    deviations_mm: Option<Vec<f64>>,
}

/// What was heard besides what the journal has.
#[derive(Default)]
pub(super) struct Heard {
    stopped_by: Option<StoppedBy>,
    fault: Option<ProblemReport>,
    /// Why it was stopped without a request.
    pub held: Option<ProblemReport>,
    corners_mm: Vec<[f64; 3]>,
    /// How far the machine was with its step, as the journal had it when this part began.
    part_made_before: Option<PartMade>,
}

impl Making<'_, '_> {
    /// Begins the wire, or resumes it, and runs it to its end or to where it is interrupted. The session is
    /// given back whatever becomes of it.
    pub fn go(
        mut self,
        observer: &mut MachineObserver,
        permit: Permit,
        response: &mut RunResponse,
    ) -> (Option<Session>, Result<(), OperationError>) {
        let made = self.make(observer, permit, response).map(|made| response.wires.push(made));
        (Some(self.into_session()), made)
    }

    pub fn into_session(self) -> Session {
        self.run.into_parts().0
    }

    fn make(
        &mut self,
        observer: &mut MachineObserver,
        permit: Permit,
        response: &mut RunResponse,
    ) -> Result<WireRun, OperationError> {
        let part_made_before = self.run.journal_state().part_made;
        let mut heard = Heard { part_made_before, ..Heard::default() };
        let driven = self.begin(observer, permit).and_then(|()| self.drive(observer, &mut heard));
        let standstill = self.see_it_stand(observer);
        // What failed while a stop was on its way is its doing.
        let made = driven.is_ok() && self.run.journal_state().standing == JobState::Finished;
        let stop = if made { None } else { stop_of(self.run.session()) };
        match driven {
            Ok(()) | Err(OperationError::Live(LiveProblem::Stopped { .. })) => {}
            Err(OperationError::Live(LiveProblem::Job(error @ JobError::Journal(_)))) => {
                let stands = standstill.is_none_or(|standstill| standstill == Standstill::Confirmed);
                let (error, run) = (Box::new(error), self.task.target(self.wire));
                return Err(LiveProblem::Unrecorded { error, stands, run }.into());
            }
            Err(OperationError::Live(error @ (LiveProblem::Held { .. } | LiveProblem::Unstopped { .. }))) => {
                heard.held = Some(ProblemReport::from(&error));
            }
            Err(_) if stop.is_some() => {}
            Err(OperationError::Live(LiveProblem::Fault(error))) => heard.fault = Some(error),
            // Homing has failed, and the machine was stopped for it.
            Err(OperationError::Live(error)) if standstill.is_some() => {
                heard.held = Some(ProblemReport::from(&error));
            }
            Err(error) => {
                self.keep(response)?;
                return Err(error);
            }
        }
        // One that came before the wire was begun the loop does not know of.
        if stop.is_some() && !self.run.journal_state().is_over() {
            self.run.note_stop().map_err(LiveProblem::from)?;
        }
        heard.stopped_by = heard.stopped_by.or(stop.map(|outcome| outcome.by));
        let made = self.made(&heard)?;
        let deviations_mm = made.as_ref().and_then(|made| made.deviations_mm.clone());
        if let Some(Bent { corners_mm, deviations_mm }) = made {
            self.run.note_made(corners_mm, deviations_mm).map_err(LiveProblem::from)?;
        }
        self.keep(response)?;
        self.report(&heard, standstill, deviations_mm)
    }

    /// Where the machine was stopped, or its driver was lost: waits until it stands, or that cannot be known.
    fn see_it_stand(&mut self, observer: &mut MachineObserver) -> Option<Standstill> {
        let mut watch = StopWatch::default();
        while self.run.session().standstill() == Some(Standstill::Awaited) {
            // What cannot be written down any more is seen anyway.
            if self.look(observer, &mut Heard::default()).is_err() {
                return await_standstill(self.run.session(), observer, || false);
            }
            watch.look(self.run.session(), observer);
        }
        self.run.session().standstill()
    }

    fn begin(&mut self, observer: &mut MachineObserver, permit: Permit) -> Result<(), OperationError> {
        match self.run.resume_from() {
            Resume::Reattach { .. } => self.look_again(observer)?,
            _ if self.homes => home(self.run.session(), observer, &permit)?,
            _ => {}
        }
        observer.progress.stage("bending the wire");
        let started = match self.past_pause {
            Some(after) => self.run.start_past_pause(permit, after),
            None => self.run.start(permit),
        };
        started.map_err(LiveProblem::from)?;
        observer.publish(self.run.session());
        if let Some(position) = self.run.session().snapshot().position {
            self.steps.position(self.task.setup.signs.canonical(position));
        }
        Ok(())
    }

    /// While the user was asked, the machine was not looked at: it may hold since.
    fn look_again(&mut self, observer: &mut MachineObserver) -> Result<(), OperationError> {
        let begun = Instant::now();
        while begun.elapsed() < LOOK_AGAIN {
            let mut heard = Heard::default();
            self.look(observer, &mut heard)?;
            if let Some(error) = heard.fault {
                return Err(LiveProblem::Fault(error).into());
            }
        }
        Ok(())
    }

    fn drive(&mut self, observer: &mut MachineObserver, heard: &mut Heard) -> Result<(), OperationError> {
        let mut watch = StopWatch::default();
        while !self.run.is_over() {
            watch.look(self.run.session(), observer);
            if let Some(wish) = observer.progress.wish() {
                self.grant(wish, observer);
            }
            // Before anything more is sent: only some machines hold by themselves where nobody looks at them.
            if self.watch.look() && may_surprise(&mut self.run) {
                ask_after_absence(&mut self.run, observer)?;
                // The time in which the question was open is no absence, and one yes is enough where the machine holds, too.
                self.watch = Watch::default();
                continue;
            }
            let hold = match self.look(observer, heard)? {
                None => self.ask_at_pause(observer, heard)?,
                hold => hold,
            };
            match hold {
                Some(PausedBy::Silence) => self.resume_held(observer, self.watch.was_away())?,
                Some(PausedBy::Machine) => self.resume_held(observer, true)?,
                // The user who paused it resumes it.
                Some(PausedBy::Program) | None => {}
            }
        }
        Ok(())
    }

    /// What cannot be granted now ends nothing: a driver that failed over it is heard of at the next turn.
    fn grant(&mut self, wish: Wish, observer: &mut MachineObserver) {
        let granted = match wish {
            Wish::Pause => self.run.pause(),
            Wish::Resume => self.run.resume(),
            Wish::Speed(percent) => self.run.set_speed(percent),
        };
        if let Err(error) = granted.map_err(LiveProblem::from)
            && self.run.session().last_stop().is_none()
        {
            observer.warn(ProblemReport::from(&error));
        }
    }

    /// Lets the loop take one turn; why the machine holds, if it has begun to.
    pub(super) fn look(
        &mut self,
        observer: &mut MachineObserver,
        heard: &mut Heard,
    ) -> Result<Option<PausedBy>, OperationError> {
        self.watch.look();
        let advanced = self.run.advance();
        observer.publish(self.run.session());
        let told = match advanced {
            Ok(told) => told,
            Err(error) => {
                // What cannot be written down is not run.
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
                Told::Position(position) => {
                    observer.position(position);
                    self.steps.position(self.task.setup.signs.canonical(position));
                    let made = self.run.overview().made;
                    observer.progress.in_step(self.steps.in_step(made));
                }
                Told::Console { direction, text } => observer.console(direction, &text),
                Told::Warning(error) => observer.warn(report_of(&error)),
                Told::Paused { by } => {
                    hold = Some(by);
                    observer.progress.event(&MachineEvent::Paused { by });
                }
                Told::Resumed => {
                    hold = None;
                    observer.progress.event(&MachineEvent::Resumed);
                }
                Told::Wire { corners_mm, .. } => heard.corners_mm = corners_mm,
                Told::Stopped { by } => heard.stopped_by = by,
                Told::Fault { error, remedies, .. } => {
                    heard.fault = Some(ProblemReport { remedies, ..report_of(&error) });
                }
                Told::Made { n, of } => {
                    tracing::info!("step {n} of {of} is done");
                }
                // It is read from the session at the end.
                Told::Standstill { .. } | Told::Sent { .. } | Told::Finished => {}
            }
        }
        Ok(hold)
    }

    /// The machine holds, and this program was not asked for it.
    fn resume_held(&mut self, observer: &mut MachineObserver, ask: bool) -> Result<(), OperationError> {
        let question = if self.watch.was_away() {
            "the machine holds: this program was away for a while. May it resume?"
        } else {
            "the machine was paused at the machine itself. May it resume?"
        };
        let said = if ask { observer.progress.confirm(question) } else { Some(true) };
        if self.run.session().last_stop().is_some() {
            return Ok(());
        }
        match said {
            Some(true) => self.run.resume().map_err(LiveProblem::from)?,
            // The person who paused it is at the machine, and resumes it there.
            None if !self.watch.was_away() => {}
            Some(false) | None => {
                let message = "the machine held, and it was not confirmed that it may resume: it was stopped"
                    .to_owned();
                observer.warn(ProblemReport::new(ErrorCode::Held, message, Vec::new()));
                self.run.stop().1.map_err(LiveProblem::from)?;
            }
        }
        Ok(())
    }

    /// The wire as a simulated machine has bent it.
    fn made(&self, heard: &Heard) -> Result<Option<Bent>, OperationError> {
        if heard.corners_mm.is_empty() {
            return Ok(None);
        }
        let kept = KeptWire::new(&self.task.file, self.task.wire(self.wire)?, &self.task.setup)?;
        let (corners_mm, deviations_mm) = kept.compare(&heard.corners_mm);
        Ok(Some(Bent { corners_mm, deviations_mm }))
    }

    /// Writes the record.
    pub fn keep(&self, response: &mut RunResponse) -> Result<(), OperationError> {
        let path = self.task.folder.path().join(format!("{}.journal", self.id));
        self.task.keep(self.run.record().as_ref(), &path, self.wire, response)
    }

    /// The step that was stopped in its middle, where the machine counts how far it was. `before`: what was known of it at first.
    fn stopped_in(&self, before: Option<PartMade>) -> Result<Option<StoppedIn>, OperationError> {
        let signs = self.task.setup.signs;
        let part_made = self.run.journal_state().part_made;
        let (told, told_now) = (part_made.and_then(|told| told.made), part_made != before);
        let Some((doubtful, told)) = self.run.doubtful().zip(told) else { return Ok(None) };
        let Some(counted) = doubtful.counted else { return Ok(None) };
        let (_, of) = self.task.step(self.wire, doubtful.step)?;
        Ok(Some(StoppedIn {
            step: doubtful.step,
            made: self.task.part(counted),
            of,
            bend_at_deg: told_now.then(|| signs.canonical(told).bend_deg),
            sure: !doubtful.measure,
        }))
    }

    fn report(
        &self,
        heard: &Heard,
        standstill: Option<Standstill>,
        deviations_mm: Option<Vec<f64>>,
    ) -> Result<WireRun, OperationError> {
        let state = self.run.journal_state();
        let done_by = state.heading.done_by;
        let outcome = match state.standing {
            JobState::Finished => RunOutcome::ended(done_by),
            JobState::Abandoned => RunOutcome::Abandoned,
            JobState::Stopped => RunOutcome::Stopped,
            // What fails while a stop is on its way is its doing.
            JobState::Faulted if state.stopped => RunOutcome::Stopped,
            _ => RunOutcome::Failed,
        };
        let over = state.is_over();
        let untouched = self.task.untouched(self.wire, &self.id, outcome, state.done, done_by)?;
        let stopped_in = self.stopped_in(heard.part_made_before)?.filter(|_| !over);
        let sure = stopped_in.as_ref().is_some_and(|step| step.sure);
        let in_doubt = state.in_doubt().filter(|_| !sure);
        Ok(WireRun {
            in_doubt: in_doubt.map(|steps| [*steps.start(), *steps.end()]),
            stopped_in,
            elapsed_s: self.run.overview().elapsed.as_secs_f64(),
            stopped_by: heard.stopped_by.filter(|_| !over),
            standstill,
            problem: heard
                .fault
                .clone()
                .filter(|_| outcome == RunOutcome::Failed)
                .or_else(|| heard.held.clone()),
            deviations_mm,
            // Where nothing of a wire is made there is nothing to resume.
            resumable: (!over && !state.is_blank()).then(|| self.task.target(self.wire)),
            ..untouched
        })
    }
}
