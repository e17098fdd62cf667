//! The loop that makes a wire.

use std::time::Duration;

use wirebend_driver_api::{Event, GoingOn, Run};

use super::account::Account;
use super::clock::Clock;
use super::error::JobError;
use super::feed::Feed;
use super::journal::{Entry, Journal, ToldBy, What};
use super::pace::Pace;
use super::progress::{Overview, Progress};
use super::record::Record;
use super::resume::{Resume, Settled};
use super::work::Work;
use crate::session::{Armed, Confirmed, Purpose, Session, State, StopHandle, turned};

/// A wire that is made, or taken up again: a session, a journal, and the steps.
///
/// It is begun by [`JobRun::start`], which is where a person's yes goes in, and then made by calling
/// [`JobRun::advance`] again and again, every few milliseconds to a few hundred. No call waits for the machine.
pub struct JobRun {
    pub(super) session: Session,
    pub(super) journal: Journal,
    pub(super) work: Work,
    pub(super) clock: Box<dyn Clock>,
    begun: Duration,
    pub(super) pace: Pace,
    pub(super) armed: Option<Armed>,
    pub(super) feed: Feed,
    /// A stop is written down once.
    pub(super) stop_noted: bool,
    /// And so is what came of it.
    pub(super) standstill_noted: bool,
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
    /// [`Session::connect_resuming`] with the token of its account, where it has one.
    ///
    /// # Errors
    /// [`JobError::OtherWire`] when the journal is not of this wire, [`JobError::Steps`], [`JobError::Journal`].
    pub fn new(
        session: Session,
        mut journal: Journal,
        work: Work,
        clock: Box<dyn Clock>,
    ) -> Result<Self, JobError> {
        work.fits(&journal.account().heading)?;
        if !journal.account().is_over() {
            let going_on = going_on(&session);
            let what = What::Connected { identity: session.identity().to_owned(), going_on };
            journal.add(Entry { at: clock.stamp(), what })?;
        }
        let pace = Pace::new(work.estimates.clone(), work.run.steps);
        let begun = clock.now();
        let (armed, feed) = (None, Feed::default());
        Ok(Self {
            session,
            journal,
            work,
            clock,
            begun,
            pace,
            armed,
            feed,
            stop_noted: false,
            standstill_noted: false,
        })
    }

    /// What may be done now. A step that was ended in its middle is in no doubt where the machine can tell how far it is.
    #[must_use]
    pub fn resume_from(&self) -> Resume {
        match Resume::decide(self.journal.account(), going_on(&self.session)) {
            Resume::Ask { in_doubt, .. } if self.sure_part().is_some() => Resume::TakeUp { from: in_doubt },
            resume => resume,
        }
    }

    /// Begins the wire, takes it up after the last step that was made, or goes on where the machine is: whatever
    /// [`JobRun::resume_from`] says. From here on [`JobRun::advance`] moves the machine.
    ///
    /// # Errors
    /// [`JobError`]; nothing moves then.
    pub fn start(&mut self, confirmed: Confirmed) -> Result<(), JobError> {
        match self.resume_from() {
            Resume::Contradiction(contradiction) => return Err(contradiction.into()),
            Resume::Ask { in_doubt, .. } => return Err(JobError::InDoubt { step: in_doubt }),
            Resume::Nothing(settled) => {
                if settled == Settled::AllMade {
                    self.note(What::Finished)?;
                }
                return Err(JobError::Nothing(settled));
            }
            Resume::GoOn { .. } => {
                self.catch_up()?;
                let (run, begun) = (self.work.run.clone(), self.account().part.rotate_deg);
                let armed = self.session.take_up(run, &self.work.steps, begun, confirmed)?;
                self.begun(armed, true)?;
                self.go_on_where_it_holds()?;
            }
            Resume::TakeUp { from } => {
                if let Some((n, part)) = self.sure_part() {
                    self.note(part.told_by(n, ToldBy::Machine))?;
                }
                let (after, part) = (from - 1, self.account().part);
                let rotate_at_deg = turned(&self.work.steps, after) + part.rotate_deg;
                let run = Run { after, rotate_at_deg, fed_mm: part.feed_mm, ..self.work.run.clone() };
                let armed = self.session.arm(Purpose::Wire(run), confirmed)?;
                self.begun(armed, false)?;
            }
        }
        Ok(())
    }

    fn begun(&mut self, armed: Armed, going_on: bool) -> Result<(), JobError> {
        let what =
            What::Armed { token: armed.token().map(str::to_owned), after: self.account().done, going_on };
        self.note(what)?;
        (self.armed, self.feed) = (Some(armed), Feed::default());
        (self.stop_noted, self.standstill_noted) = (false, false);
        Ok(())
    }

    /// A person's yes was for all of it, a hold from the time when nobody was there included.
    fn go_on_where_it_holds(&mut self) -> Result<(), JobError> {
        if self.session.state() == State::Paused {
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
            // It was told before, and only what came of the stop is awaited.
            Err(_) if self.feed.halted() && self.session.standstill().is_some() => {}
            // A stop that has ended the driver.
            Err(_) if self.session.last_stop().is_some() => self.was_stopped(&mut told)?,
            Err(error) => self.failed(&error, &mut told)?,
        }
        self.notice_stop(&mut told)?;
        self.notice_standstill(&mut told)?;
        if matches!(self.session.state(), State::Armed | State::Running) {
            self.send_more(&mut told)?;
        }
        Ok(told)
    }

    fn take(&mut self, event: Event, told: &mut Vec<Progress>) -> Result<(), JobError> {
        let now = self.clock.now();
        match event {
            Event::Done { n } => {
                self.note(What::Done { n })?;
                let more = self.account().accepted > n;
                self.pace.made(n, now, more);
                self.feed.one_made();
                told.push(Progress::Made { n, of: self.work.run.steps });
            }
            Event::Finished if self.session.state() == State::Done => {
                self.note(What::Finished)?;
                told.push(Progress::Finished);
            }
            Event::Paused { by } => {
                self.note(What::Paused)?;
                self.pace.holds(now);
                told.push(Progress::Paused { by });
            }
            Event::Resumed => {
                self.note(What::Resumed)?;
                self.pace.works(now);
                told.push(Progress::Resumed);
            }
            Event::Made { wire_mm, corners_mm } => {
                self.note(What::Made { corners_mm: corners_mm.clone(), deviations_mm: None })?;
                told.push(Progress::Wire { wire_mm, corners_mm });
            }
            Event::Fault { error, in_doubt, .. } => self.faulted(error, in_doubt, told)?,
            // Of a machine that contradicts the journal nothing is settled by it.
            Event::PartMade { step: n, made, exact }
                if self.account().in_doubt().is_some_and(|steps| *steps.start() == n) =>
            {
                self.note(What::PartMade { n, made, exact })?;
            }
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

    /// Goes on after a pause.
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
        self.note(What::Abandoned)
    }

    /// Writes down how far each corner is from the design, mm.
    ///
    /// # Errors
    /// [`JobError::Journal`].
    pub fn note_deviations(&mut self, deviations_mm: Vec<f64>) -> Result<(), JobError> {
        self.note(What::Made { corners_mm: Vec::new(), deviations_mm: Some(deviations_mm) })
    }

    /// Whether the machine still makes steps, or would if it were let.
    pub(super) fn is_in_hand(&self) -> bool {
        going_on(&self.session).is_some() || self.is_at_work()
    }

    /// Whether the machine may make steps of this wire.
    #[must_use]
    pub const fn is_at_work(&self) -> bool {
        matches!(self.session.state(), State::Running | State::Paused | State::Interrupted)
    }

    /// Whether [`JobRun::advance`] has nothing more to do: the wire is made or given up, or the machine was stopped
    /// or failed, and has to be homed or connected anew. Not as long as a machine that may move was not heard of.
    #[must_use]
    pub fn is_over(&self) -> bool {
        let state = self.session.state();
        let (sent, done) = self.session.progress();
        if self.session.standstill().is_some() && !self.standstill_noted {
            return false;
        }
        self.account().is_over()
            // What was taken before a refusal is still made, and heard of.
            || self.feed.halted() && (state == State::Faulted || sent == done)
            || state == State::Stopped && self.stop_noted
    }

    /// How it stands.
    #[must_use]
    pub fn overview(&self) -> Overview {
        let (account, now) = (self.account(), self.clock.now());
        Overview {
            of: self.work.run.steps,
            sent: account.accepted,
            made: account.done,
            elapsed: now.saturating_sub(self.begun),
            remaining: self.pace.remaining(account.done, now),
            state: self.session.state(),
            standing: account.standing,
        }
    }

    /// What the journal comes to.
    #[must_use]
    pub const fn account(&self) -> &Account {
        self.journal.account()
    }

    /// What was made so far, for the record beside the journal.
    #[must_use]
    pub fn record(&self) -> Option<Record> {
        Record::of(self.journal.entries())
    }

    /// The session, such as to home the machine before [`JobRun::start`].
    pub const fn session(&mut self) -> &mut Session {
        &mut self.session
    }

    /// The session and the journal.
    #[must_use]
    pub fn into_parts(self) -> (Session, Journal) {
        (self.session, self.journal)
    }

    pub(super) fn note(&mut self, what: What) -> Result<(), JobError> {
        Ok(self.journal.add(Entry { at: self.clock.stamp(), what })?)
    }

    /// Steps are about to be sent, or were.
    pub(super) fn sending(&mut self) {
        self.pace.works(self.clock.now());
    }
}

/// Where the machine is in the wire, as long as it is one that nobody has taken up.
fn going_on(session: &Session) -> Option<GoingOn> {
    let (accepted, done) = session.progress();
    (session.state() == State::Interrupted).then_some(GoingOn { accepted, done })
}
