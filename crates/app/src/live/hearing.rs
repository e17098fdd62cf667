//! Who hears of a machine, and what is kept of what it says.

use wirebend_driver_host::Session;
use wirebend_driver_host::api::{Direction, Event, SettingCheck};

use super::LiveProblem;
use super::head::{self, Known};
use super::person::Zero;
use crate::drivers::{Met, Signs};
use crate::{News, NoteReport, Progress};

/// Who hears of a machine, and what has to be kept of it.
pub(crate) struct Hearing<'a> {
    pub progress: &'a dyn Progress,
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

impl Drop for Hearing<'_> {
    fn drop(&mut self) {
        self.progress.disconnected();
    }
}

impl Hearing<'_> {
    /// The axes do not stand where they did.
    pub const fn moved(&mut self) {
        self.at_zero = false;
    }

    /// A person's word that every axis stands at zero: what they have said before counts once, and not for a head that was
    /// left elsewhere, which they may not have thought of.
    pub(super) fn said_zero(&mut self, session: &Session, wanted: Zero) -> Result<(), LiveProblem> {
        let contradicted = head::contradiction(session, self).filter(|_| wanted == Zero::Wire);
        if std::mem::take(&mut self.at_zero) && contradicted.is_none() {
            return Ok(());
        }
        self.progress.news(&News::About { lines: head::zero_lines(session, self, wanted) });
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
            Event::Warning(error) => self.warn(&error.code, &error.to_string()),
            Event::Position(position) => self.position(*position),
            Event::Console { direction, text } => self.console(*direction, text),
            _ => {}
        }
    }

    pub fn warn(&mut self, code: &str, message: &str) {
        let known = self.warnings.iter_mut().find(|note| note.code == code && note.message == message);
        if let Some(note) = known {
            note.count += 1;
        } else {
            let (code, message) = (code.to_owned().into(), message.to_owned());
            self.warnings.push(NoteReport { code, count: 1, message });
        }
        self.progress.news(&News::Warning { code: code.to_owned(), message: message.to_owned() });
    }

    pub fn position(&self, position: wirebend_driver_host::api::Step) {
        self.progress.news(&News::Position(self.signs.canonical(position)));
    }

    pub fn console(&self, direction: Direction, text: &str) {
        let to_machine = direction == Direction::ToMachine;
        tracing::debug!("{} {text}", if to_machine { "->" } else { "<-" });
        self.progress.news(&News::Console { to_machine, text: text.to_owned() });
    }
}
