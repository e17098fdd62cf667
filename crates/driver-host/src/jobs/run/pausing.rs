//! Pause points: nothing that comes after one is sent before a person has said that the wire goes on.

use super::super::entry::EntryKind;
use super::super::error::JobError;
use super::super::wire_job::PauseAfter;
use super::JobRun;
use crate::session::{Permit, Phase};

impl JobRun {
    /// The next pause point of which nobody has said that the wire goes on past it.
    #[must_use]
    pub fn pause_ahead(&self) -> Option<&PauseAfter> {
        let state = self.journal_state();
        let is_ahead = |pause: &&PauseAfter| pause.after > state.confirmed && pause.after >= state.done;
        self.work.pauses.iter().find(is_ahead)
    }

    /// The pause point at which the machine waits, or holds: it has come to rest, and is sent nothing more.
    #[must_use]
    pub fn waits_at(&self) -> Option<&PauseAfter> {
        let (sent, done) = self.session.progress();
        let rests = sent == done && !self.window.halted();
        let in_wire = matches!(self.session.phase(), Phase::Armed | Phase::Making | Phase::Holding);
        self.pause_ahead().filter(|pause| in_wire && rests && pause.after == done)
    }

    /// The last step that may be sent.
    pub(super) fn last_to_send(&self) -> u32 {
        let (sent, _) = self.session.progress();
        self.pause_ahead().map_or(self.work.run.steps, |pause| pause.after.max(sent))
    }

    /// A person has done what is to be done at the pause point at which the machine waits: the next steps are sent.
    ///
    /// # Errors
    /// [`JobError::NotWaiting`] where it does not wait, [`JobError::Session`] where the permit does not hold any more,
    /// [`JobError::Journal`].
    pub fn go_on(&mut self, permit: Permit) -> Result<(), JobError> {
        let pause = self.waits_at().ok_or(JobError::NotWaiting)?.clone();
        self.session.goes_on(permit)?;
        self.note_confirmed(pause)
    }

    /// [`JobRun::start`] of a wire that stands at the pause point after a step, of which the person was told with the question:
    /// their yes is for what is to be done there, too.
    ///
    /// # Errors
    /// As [`JobRun::start`].
    pub fn start_past_pause(&mut self, permit: Permit, after: u32) -> Result<(), JobError> {
        self.start(permit)?;
        let stands = self.journal_state().done == after;
        let told = self.pause_ahead().filter(|pause| stands && pause.after == after).cloned();
        told.map_or(Ok(()), |pause| self.note_confirmed(pause))
    }

    fn note_confirmed(&mut self, PauseAfter { after, note }: PauseAfter) -> Result<(), JobError> {
        self.note(EntryKind::PauseConfirmed { after, note })
    }
}
