//! The loop that runs a wire.

mod ending;
mod in_doubt;
mod pausing;
mod play;
mod send_window;

use wirebend_driver_api::{Event, ResumeState, Run, Step};

use super::clock::Clock;
use super::entry::{Entry, EntryKind, ToldBy};
use super::error::JobError;
use super::journal::Journal;
use super::journal_state::JournalState;
use super::progress::{Overview, Progress};
use super::record::Record;
use super::resume::{Resume, Settled};
use super::time_estimator::TimeEstimator;
use super::wire_job::{StepTime, WireJob};
use super::work_time::WorkTime;
use crate::error::advice_of;
use crate::session::{Armed, Permit, Phase, Session, StopHandle, turned};
use send_window::SendWindow;

/// A wire that is being bent, or was reattached: a session, a journal, and the steps.
///
/// It is begun by [`JobRun::start`], which is where a person's yes goes in, and then run by calling
/// [`JobRun::advance`] again and again, every few milliseconds to a few hundred. No call waits for the machine.
pub struct JobRun {
    session: Session,
    journal: Journal,
    work: WireJob,
    clock: Box<dyn Clock>,
    time: WorkTime,
    estimator: TimeEstimator,
    armed: Option<Armed>,
    window: SendWindow,
    /// The step in which the wire begins or goes on, and how much more it turns than its rest does.
    turns_more: (u32, f64),
    /// A stop is written down once.
    stop_noted: bool,
    /// The result of a standstill is written down once.
    standstill_noted: bool,
}

impl std::fmt::Debug for JobRun {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("JobRun")
            .field("session", &self.session)
            .field("journal", &self.journal)
            .finish_non_exhaustive()
    }
}

impl JobRun {
    /// For a machine that has answered. A journal that was interrupted needs a session by
    /// [`Session::connect_resuming`] with the token of its state, where it has one.
    ///
    /// # Errors
    /// [`JobError::OtherWire`] when the journal is not of this wire, [`JobError::Steps`], [`JobError::Journal`].
    pub fn new(
        session: Session,
        mut journal: Journal,
        work: WireJob,
        clock: Box<dyn Clock>,
    ) -> Result<Self, JobError> {
        work.fits(&journal.state().heading)?;
        if !journal.state().is_over() {
            let resume = resume_state(&session);
            let what = EntryKind::Connected { identity: session.identity().to_owned(), resume };
            journal.add(Entry { at: clock.stamp(), what })?;
        }
        let (time, begun) = (WorkTime::of(journal.entries()), clock.now());
        let estimates = work.estimates.iter().map(StepTime::total).collect();
        let mut estimator = TimeEstimator::new(estimates, work.run.steps);
        if let Some(percent) = session.snapshot().speed_percent {
            estimator.goes_at(percent, begun);
        }
        let (armed, window) = (None, SendWindow::default());
        Ok(Self {
            session,
            journal,
            work,
            clock,
            time,
            estimator,
            armed,
            window,
            turns_more: (0, 0.0),
            stop_noted: false,
            standstill_noted: false,
        })
    }

    /// What may be done now. A step that was ended in its middle is in no doubt where the machine has counted how far it is.
    #[must_use]
    pub fn resume_from(&self) -> Resume {
        match Resume::decide(self.journal.state(), resume_state(&self.session)) {
            Resume::Ask { in_doubt, .. } if self.sure_part().is_some() => Resume::Arm { from: in_doubt },
            resume => resume,
        }
    }

    /// Begins the wire, resumes it after the last step that is done, or reattaches where the machine is: whatever
    /// [`JobRun::resume_from`] says. From here on [`JobRun::advance`] moves the machine.
    ///
    /// # Errors
    /// [`JobError`]; nothing moves then.
    pub fn start(&mut self, permit: Permit) -> Result<(), JobError> {
        match self.resume_from() {
            Resume::Contradiction(contradiction) => return Err(contradiction.into()),
            Resume::Ask { in_doubt, .. } => return Err(JobError::InDoubt { step: in_doubt }),
            Resume::Nothing(settled) => {
                self.settle()?;
                return Err(JobError::Nothing(settled));
            }
            Resume::Reattach { .. } => {
                self.catch_up()?;
                let JournalState { done, part, .. } = *self.journal_state();
                // The step in hand is the one in which the wire went on.
                if self.armed_after() == Some(done) {
                    self.turns_more = (done + 1, self.turns_more_after(done, part));
                }
                let begun = part.rotate_deg - self.turns_more_in(done + 1);
                let run = self.work.run.clone();
                let armed = self.session.reattach(run, &self.work.steps, begun, permit)?;
                self.begun(armed, true)?;
                self.resume_where_it_holds()?;
            }
            Resume::Arm { from } => {
                if let Some((n, part)) = self.sure_part() {
                    self.note(part.told_by(n, ToldBy::Machine))?;
                }
                let (after, part) = (from - 1, self.journal_state().part);
                let more = self.turns_more_after(after, part);
                let rotate_at_deg = turned(&self.work.steps, after) + part.rotate_deg - more;
                let run = Run { after, rotate_at_deg, fed_mm: part.feed_mm, ..self.work.run.clone() };
                let armed = self.session.arm(run, permit)?;
                self.turns_more = (from, more);
                self.estimator.goes_on(after, self.work.time_of(after, part));
                self.begun(armed, false)?;
            }
        }
        Ok(())
    }

    /// Writes down that the wire is done where all of its steps are and that was not heard any more. Nothing moves.
    ///
    /// # Errors
    /// [`JobError::Journal`].
    pub fn settle(&mut self) -> Result<(), JobError> {
        if self.resume_from() == Resume::Nothing(Settled::AllMade) {
            self.note(EntryKind::Finished)?;
        }
        Ok(())
    }

    fn begun(&mut self, armed: Armed, resumed: bool) -> Result<(), JobError> {
        let what = EntryKind::Armed {
            token: armed.token().map(str::to_owned),
            after: self.journal_state().done,
            resumed,
        };
        self.note(what)?;
        (self.armed, self.window) = (Some(armed), SendWindow::default());
        (self.stop_noted, self.standstill_noted) = (false, false);
        self.tell_times();
        Ok(())
    }

    /// A person's yes was for all of it, a hold from the time without a program included.
    fn resume_where_it_holds(&mut self) -> Result<(), JobError> {
        if self.session.phase() == Phase::Holding {
            self.resume()?;
        }
        Ok(())
    }

    /// Takes what the machine reports, writes it down, and sends what there is room for. Waits for nothing but
    /// the disk and the driver's answers.
    ///
    /// # Errors
    /// [`JobError::Journal`] when nothing can be written down any more: nothing is sent then; stop the machine.
    /// What goes wrong with machine and driver is no error but [`Progress::Fault`].
    pub fn advance(&mut self) -> Result<Vec<Progress>, JobError> {
        let mut told = Vec::new();
        if self.is_over() {
            return Ok(told);
        }
        match self.session.poll() {
            Ok(events) => {
                for event in events {
                    self.take(event, &mut told)?;
                }
            }
            // It was reported before, and only the result of the stop is awaited.
            Err(_) if self.window.halted() && self.session.standstill().is_some() => {}
            // A stop that has ended the driver.
            Err(_) if self.session.last_stop().is_some() => self.was_stopped(&mut told)?,
            Err(error) => self.failed(&error, &mut told)?,
        }
        self.notice_stop(&mut told)?;
        self.notice_standstill(&mut told)?;
        if matches!(self.session.phase(), Phase::Armed | Phase::Making) {
            self.send_more(&mut told)?;
        }
        self.tell_times();
        Ok(told)
    }

    /// How long the wire takes is in the session's snapshot with how far it is.
    fn tell_times(&mut self) {
        let Overview { elapsed, remaining, .. } = self.overview();
        self.session.note_times(elapsed, remaining);
    }

    fn take(&mut self, event: Event, told: &mut Vec<Progress>) -> Result<(), JobError> {
        let now = self.clock.now();
        match event {
            Event::Done { n } => {
                self.note(EntryKind::Done { n })?;
                let more = self.journal_state().accepted > n;
                self.estimator.made(n, now, more);
                self.window.one_made();
                told.push(Progress::Made { n, of: self.work.run.steps });
            }
            Event::Finished if self.session.is_done() => {
                self.note(EntryKind::Finished)?;
                told.push(Progress::Finished);
            }
            Event::Paused { by } => {
                self.note(EntryKind::Paused)?;
                self.estimator.holds(now);
                told.push(Progress::Paused { by });
            }
            Event::Resumed => {
                self.note(EntryKind::Resumed)?;
                self.estimator.works(now);
                told.push(Progress::Resumed);
            }
            Event::Made { wire_mm, corners_mm } => {
                self.note(EntryKind::Made { corners_mm: corners_mm.clone(), deviations_mm: None })?;
                told.push(Progress::Wire { wire_mm, corners_mm });
            }
            Event::Fault { error, in_doubt, .. } => {
                let remedies = advice_of(&error);
                self.faulted(error, remedies, in_doubt, told)?;
            }
            // Of a machine that contradicts the journal nothing is settled by it.
            Event::PartMade { step: n, made, exact }
                if self.journal_state().in_doubt().is_some_and(|steps| *steps.start() == n) =>
            {
                // It tells what it has done of what it was sent.
                let more = self.turns_more_in(n);
                let of_step =
                    |made: Step| Step { rotate_deg: play::turned_of_step(made.rotate_deg, more), ..made };
                self.note(EntryKind::PartMade { n, made: made.map(of_step), exact })?;
            }
            Event::Speed { percent } => self.estimator.goes_at(percent, now),
            Event::Position(step) => told.push(Progress::Position(step)),
            Event::Console { direction, text } => told.push(Progress::Console { direction, text }),
            Event::Warning(error) => told.push(Progress::Warning(error)),
            _ => {}
        }
        Ok(())
    }

    /// Holds the machine.
    ///
    /// # Errors
    /// [`JobError::Session`].
    pub fn pause(&mut self) -> Result<(), JobError> {
        Ok(self.session.pause()?)
    }

    /// Bends at so many percent of the programmed speed.
    ///
    /// # Errors
    /// [`JobError::Session`].
    pub fn set_speed(&mut self, percent: u8) -> Result<(), JobError> {
        Ok(self.session.set_speed(percent)?)
    }

    /// Resumes after a pause.
    ///
    /// # Errors
    /// [`JobError::Session`], [`JobError::NotBegun`].
    pub fn resume(&mut self) -> Result<(), JobError> {
        let armed = self.armed.as_ref().ok_or(JobError::NotBegun)?;
        Ok(self.session.resume(armed)?)
    }

    /// What stops the machine from any thread.
    #[must_use]
    pub fn stop_handle(&self) -> StopHandle {
        self.session.stop_handle()
    }

    /// A person gives the wire up. The machine has to be at rest.
    ///
    /// # Errors
    /// [`JobError::AtWork`], [`JobError::Journal`].
    pub fn abandon(&mut self) -> Result<(), JobError> {
        if self.is_at_work() {
            return Err(JobError::AtWork);
        }
        self.note(EntryKind::Abandoned)
    }

    /// Whether the machine still runs steps, or would after a resume.
    fn is_in_hand(&self) -> bool {
        resume_state(&self.session).is_some() || self.is_at_work()
    }

    /// Whether the machine may run steps of this wire.
    #[must_use]
    pub const fn is_at_work(&self) -> bool {
        self.session.phase().is_in_a_wire()
    }

    /// Whether [`JobRun::advance`] has nothing more to do: the wire is finished or given up, or the machine was stopped
    /// or failed, and has to be homed or connected anew. Not as long as a machine that may move was not heard of.
    #[must_use]
    pub fn is_over(&self) -> bool {
        let phase = self.session.phase();
        let (sent, done) = self.session.progress();
        if self.session.standstill().is_some() && !self.standstill_noted {
            return false;
        }
        self.journal_state().is_over()
            // Steps accepted before the refusal still run and are reported.
            || self.window.halted() && (phase == Phase::Failed || sent == done)
            || phase == Phase::Stopped && self.stop_noted
    }

    #[must_use]
    pub fn overview(&self) -> Overview {
        let (state, now) = (self.journal_state(), self.clock.now());
        Overview {
            of: self.work.run.steps,
            sent: state.accepted,
            made: state.done,
            elapsed: self.time.until(now),
            remaining: self.estimator.remaining(state.done, now),
            phase: self.session.phase(),
            standing: state.standing,
        }
    }

    /// What the journal comes to.
    #[must_use]
    pub const fn journal_state(&self) -> &JournalState {
        self.journal.state()
    }

    /// What was done so far, for the record beside the journal.
    #[must_use]
    pub fn record(&self) -> Option<Record> {
        Record::of(self.journal.entries())
    }

    /// The session, such as to home the machine before [`JobRun::start`].
    pub const fn session(&mut self) -> &mut Session {
        &mut self.session
    }

    #[must_use]
    pub fn into_parts(self) -> (Session, Journal) {
        (self.session, self.journal)
    }

    fn note(&mut self, what: EntryKind) -> Result<(), JobError> {
        self.time.take(&what, self.clock.now());
        Ok(self.journal.add(Entry { at: self.clock.stamp(), what })?)
    }

    /// Steps are about to be sent, or were.
    fn sending(&mut self) {
        self.estimator.works(self.clock.now());
    }
}

/// Where the machine is in the wire, as long as it is one that was not reattached.
fn resume_state(session: &Session) -> Option<ResumeState> {
    let (accepted, done) = session.progress();
    (session.phase() == Phase::Interrupted).then_some(ResumeState { accepted, done })
}
