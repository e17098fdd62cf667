//! How a wire is interrupted: failures and stops, each written down once, and what came of them.

use wirebend_driver_api::DriverError;
use wirebend_error::ErrorRemedy;

use super::super::entry::EntryKind;
use super::super::error::JobError;
use super::super::progress::Progress;
use super::JobRun;
use crate::session::{Phase, SessionError, Standstill, StopOutcome, StoppedBy};

impl JobRun {
    /// Writes down where each corner lies beside the design, which stands for what the machine has told, and how far each vertex of the design
    /// is from the wire, mm, where it can be found on it.
    ///
    /// # Errors
    /// [`JobError::Journal`].
    pub fn note_made(
        &mut self,
        corners_mm: Vec<[f64; 3]>,
        deviations_mm: Option<Vec<f64>>,
    ) -> Result<(), JobError> {
        self.note(EntryKind::Made { corners_mm, deviations_mm })
    }

    /// The driver failed: what it said before it did counts.
    pub(super) fn failed(&mut self, error: &SessionError, told: &mut Vec<Progress>) -> Result<(), JobError> {
        self.catch_up()?;
        let fault = DriverError::new(error.code().as_str(), error.to_string(), "");
        self.faulted(fault, error.remedies(), None, told)
    }

    pub(super) fn faulted(
        &mut self,
        error: DriverError,
        remedies: Vec<ErrorRemedy>,
        in_doubt: Option<u32>,
        told: &mut Vec<Progress>,
    ) -> Result<(), JobError> {
        self.note_not_taken()?;
        self.note(EntryKind::Fault { error: error.clone(), in_doubt })?;
        let in_doubt = self.journal_state().in_doubt().map(|steps| (*steps.start(), *steps.end()));
        self.estimator.holds(self.clock.now());
        self.window.halt();
        told.push(Progress::Fault { error, remedies, in_doubt });
        Ok(())
    }

    /// Steps that were reported where this did not hear it.
    pub(super) fn catch_up(&mut self) -> Result<(), JobError> {
        for n in self.journal_state().done + 1..=self.session.progress().1 {
            self.note(EntryKind::Done { n })?;
        }
        Ok(())
    }

    /// A stop by whomever is written down once.
    pub(super) fn notice_stop(&mut self, told: &mut Vec<Progress>) -> Result<(), JobError> {
        if !matches!(self.session.phase(), Phase::Stopping | Phase::Stopped) || self.stop_noted {
            return Ok(());
        }
        self.was_stopped(told)
    }

    pub(super) fn was_stopped(&mut self, told: &mut Vec<Progress>) -> Result<(), JobError> {
        if self.stop_noted {
            return Ok(());
        }
        let by = self.session.last_stop().map(|outcome| outcome.by);
        self.stopped(by)?;
        told.push(Progress::Stopped { by });
        Ok(())
    }

    /// Whether the machine stands is written down once it is known.
    pub(super) fn notice_standstill(&mut self, told: &mut Vec<Progress>) -> Result<(), JobError> {
        let confirmed = match self.session.standstill() {
            Some(Standstill::Confirmed) => true,
            Some(Standstill::NotConfirmed) => false,
            Some(Standstill::Awaited) | None => return Ok(()),
        };
        if self.standstill_noted {
            return Ok(());
        }
        self.standstill_noted = true;
        told.push(Progress::Standstill { confirmed });
        if self.journal_state().is_over() { Ok(()) } else { self.note(EntryKind::Standstill { confirmed }) }
    }

    pub(super) fn stopped(&mut self, by: Option<StoppedBy>) -> Result<(), JobError> {
        self.catch_up()?;
        if !self.journal_state().is_over() {
            self.note_not_taken()?;
        }
        (self.armed, self.stop_noted) = (None, true);
        self.window.halt();
        self.estimator.holds(self.clock.now());
        if self.journal_state().is_over() { Ok(()) } else { self.note(EntryKind::Stopped { by }) }
    }

    /// Stops the machine, and writes that down. The stop comes first, and has been brought about whatever the
    /// second part of the answer is.
    pub fn stop(&mut self) -> (StopOutcome, Result<(), JobError>) {
        let outcome = self.session.stop();
        let noted = self.stopped(Some(outcome.by));
        (outcome, noted)
    }

    /// Writes down a stop that came before the wire was begun, or that has ended the driver, and what came of it.
    ///
    /// # Errors
    /// [`JobError::Journal`].
    pub fn note_stop(&mut self) -> Result<(), JobError> {
        let mut told = Vec::new();
        self.was_stopped(&mut told)?;
        self.notice_standstill(&mut told)
    }
}
