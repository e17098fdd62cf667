//! Who observes a machine, and what is kept of what it says.

use wirebend_driver_host::api::{Direction, Event, SettingCheck};
use wirebend_driver_host::{Session, report_of};
use wirebend_error::ProblemReport;

use super::head::{self, Known};
use super::person::Zero;
use crate::FrontEnd;
use crate::MachineEvent;
use crate::error::LiveProblem;
use wirebend_planning::NoteReport;
use wirebend_planning::installation::Met;
use wirebend_planning::signs::Signs;

/// Who observes a machine, and what has to be kept of it.
pub struct MachineObserver<'a> {
    pub progress: &'a dyn FrontEnd,
    pub(super) signs: Signs,
    pub warnings: Vec<NoteReport>,
    /// What the machine last said of its settings.
    pub settings: Vec<SettingCheck>,
    /// A person has said that every axis stands at zero. It counts once, and not after a move.
    pub(super) at_zero: bool,
    /// What that was said for.
    pub(super) zero_for: Zero,
    /// What is kept of the head; nothing of a simulated machine's.
    pub(super) head: Option<Known>,
    /// It is connected.
    pub(super) board: Option<Met>,
}

impl Drop for MachineObserver<'_> {
    fn drop(&mut self) {
        self.progress.disconnected();
    }
}

impl MachineObserver<'_> {
    /// Reports how the machine stands.
    pub fn publish(&self, session: &Session) {
        self.progress.snapshot(&session.snapshot());
    }

    /// The axes do not stand where they did.
    pub const fn moved(&mut self) {
        self.at_zero = false;
    }

    /// A person's word that every axis stands at zero: what they have said before counts once, and not for a head that was
    /// left elsewhere, which they may not have thought of.
    pub(super) fn said_zero(&mut self, session: &Session, wanted: Zero) -> Result<(), LiveProblem> {
        let known = self.head.as_ref();
        let contradicted = head::contradiction(session, known).filter(|_| wanted == Zero::Wire);
        if std::mem::take(&mut self.at_zero) && contradicted.is_none() {
            return Ok(());
        }
        let lines = head::zero_lines(session, self.head.as_ref(), wanted);
        self.progress.event(&MachineEvent::About { lines });
        match self.progress.confirm(wanted.question()) {
            Some(true) => Ok(()),
            Some(false) => Err(LiveProblem::Declined),
            None => Err(contradicted.unwrap_or(LiveProblem::ZeroNotConfirmed)),
        }
    }

    pub(super) fn hear(&mut self, event: &Event) {
        match event {
            Event::Connected { settings, .. } => self.settings.clone_from(settings),
            Event::SettingsWritten { settings, limits } => {
                self.settings.clone_from(settings);
                self.board.iter().for_each(|board| board.says(limits));
            }
            Event::Warning(error) => self.warn(report_of(error)),
            Event::Position(position) => self.position(*position),
            Event::Console { direction, text } => self.console(*direction, text),
            _ => {}
        }
    }

    pub fn warn(&mut self, report: ProblemReport) {
        let ProblemReport { code, message, remedies } = report.clone();
        let known = self.warnings.iter_mut().find(|note| note.code == code && note.message == message);
        if let Some(note) = known {
            note.count += 1;
        } else {
            self.warnings.push(NoteReport { code: code.into(), count: 1, message, remedies });
        }
        self.progress.event(&MachineEvent::Warning(report));
    }

    pub fn position(&self, position: wirebend_driver_host::api::Step) {
        self.progress.event(&MachineEvent::Position(self.signs.canonical(position)));
    }

    pub fn console(&self, direction: Direction, text: &str) {
        let to_machine = direction == Direction::ToMachine;
        tracing::debug!("{} {text}", if to_machine { "->" } else { "<-" });
        self.progress.event(&MachineEvent::Console { to_machine, text: text.to_owned() });
    }
}
