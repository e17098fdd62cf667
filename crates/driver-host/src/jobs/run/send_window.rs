//! Sending: in windows, each written down before it goes out.

use wirebend_driver_api::NumberedStep;

use super::super::entry::EntryKind;
use super::super::error::JobError;
use super::super::progress::Progress;
use super::JobRun;
use crate::error::HostError;
use crate::session::SessionError;

/// The most steps that are sent and not done. Each of them is in doubt when the machine is lost, so that a person
/// has to look; and a machine is never without work for want of one.
const WINDOW: u32 = 4;

/// How much the driver takes.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct SendWindow {
    /// What it said that it would take more; nothing is known before it was sent anything.
    room: Option<u32>,
    /// It knows that the wire ends.
    ended: bool,
    /// It has failed or refused: nothing more is sent.
    halted: bool,
    /// It has not answered what was sent last: it is not known what it has taken of that.
    unanswered: bool,
}

impl SendWindow {
    pub fn one_made(&mut self) {
        self.room = self.room.map(|room| room.saturating_add(1));
    }

    pub const fn halt(&mut self) {
        self.halted = true;
    }

    pub const fn halted(self) -> bool {
        self.halted
    }
}

impl JobRun {
    /// Sends as many steps as there is room for.
    pub(super) fn send_more(&mut self, told: &mut Vec<Progress>) -> Result<(), JobError> {
        let (sent, done) = self.session.progress();
        let total = self.work.run.steps;
        let in_hand = sent.saturating_sub(done);
        // A driver that has nothing in hand takes a step, whatever it said of its room.
        let room = self.window.room.map_or(WINDOW, |room| room.max(u32::from(in_hand == 0)));
        let count = room.min(WINDOW.saturating_sub(in_hand)).min(self.last_to_send() - sent);
        let at_end = sent == total;
        if self.window.halted || self.window.ended || (count == 0 && !at_end) {
            return Ok(());
        }
        let last = sent + count;
        let intended = self.journal_state().sent;
        if last > intended {
            self.note(EntryKind::Intent { from: intended + 1, to: last })?;
        }
        self.sending();
        let batch: Vec<NumberedStep> = (sent + 1..=last)
            .zip(self.steps_after(sent))
            .map(|(n, step)| NumberedStep { n, step: self.to_send(n, step) })
            .collect();
        let Some(armed) = &self.armed else { return Err(JobError::NotBegun) };
        self.window.unanswered = true;
        match self.session.send(armed, &batch) {
            Ok(taken) => {
                self.window.room = Some(taken.free);
                self.window.ended = taken.accepted == total;
                if taken.accepted > self.journal_state().accepted {
                    self.note(EntryKind::Accepted { n: taken.accepted })?;
                    told.push(Progress::Sent { n: taken.accepted });
                }
                self.window.unanswered = false;
                Ok(())
            }
            // A stop came first: it is reported by itself.
            Err(SessionError::Stale | SessionError::Host(HostError::StoppedBefore { .. })) => {
                self.window.unanswered = false;
                Ok(())
            }
            Err(error) => {
                // Refused is answered: it has taken none of them, and runs what it had taken before.
                self.window.unanswered = !matches!(error, SessionError::Host(HostError::Refused { .. }));
                self.failed(&error, told)
            }
        }
    }

    /// What was about to be sent and was not taken is in no doubt, where the driver has said so.
    pub(super) fn note_not_taken(&mut self) -> Result<(), JobError> {
        let after = self.session.progress().0;
        // Of a wire that was not begun this time the session knows nothing.
        if self.armed.is_none() || self.window.unanswered || after >= self.journal_state().sent {
            return Ok(());
        }
        self.note(EntryKind::NotTaken { after })
    }

    fn steps_after(&self, sent: u32) -> impl Iterator<Item = wirebend_driver_api::Step> {
        self.work.steps.iter().copied().skip(usize::try_from(sent).unwrap_or(usize::MAX))
    }
}
