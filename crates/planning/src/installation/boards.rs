//! What connected machines say of themselves.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use wirebend_driver_host::api::Limits;

/// A machine that is connected.
#[derive(Debug, Clone, PartialEq)]
pub struct Board {
    pub port: String,
    /// What it says of its axes.
    pub limits: Limits,
}

/// The machines that are connected.
#[derive(Debug, Clone, Default)]
pub struct Boards(Arc<Mutex<Connected>>);

#[derive(Debug, Default)]
struct Connected {
    /// How many there were so far.
    count: u64,
    /// By the number of their connection, with the id of their profile.
    boards: BTreeMap<u64, (String, Board)>,
}

impl Boards {
    /// The one with a profile; the last that was connected, where there are several.
    pub fn of(&self, machine: &str) -> Option<Board> {
        let connected = self.connected();
        let mut of_it = connected.boards.values().rev().filter(|(id, _)| id == machine);
        of_it.next().map(|(_, board)| board.clone())
    }

    /// A machine has answered.
    pub fn met(&self, machine: &str, board: Board) -> Met {
        let mut connected = self.connected();
        connected.count += 1;
        let number = connected.count;
        connected.boards.insert(number, (machine.to_owned(), board));
        Met { boards: self.clone(), number }
    }

    fn connected(&self) -> MutexGuard<'_, Connected> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A machine is connected as long as this is kept.
#[derive(Debug)]
pub struct Met {
    boards: Boards,
    number: u64,
}

impl Met {
    /// It says so from now on.
    pub fn says(&self, limits: &Limits) {
        if let Some((_, board)) = self.boards.connected().boards.get_mut(&self.number) {
            board.limits.clone_from(limits);
        }
    }
}

impl Drop for Met {
    fn drop(&mut self) {
        self.boards.connected().boards.remove(&self.number);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// While a machine is connected, a wire is simulated for its profile.
    #[test]
    fn a_connection_that_ends_takes_no_other_with_it() {
        let boards = Boards::default();
        let at = |port: &str| Board { port: port.to_owned(), limits: Limits::default() };
        let first = boards.met("kit", at("/dev/ttyACM0"));
        let second = boards.met("kit", at("/dev/ttyACM1"));
        assert_eq!(boards.of("kit"), Some(at("/dev/ttyACM1")));
        drop(second);
        assert_eq!(boards.of("kit"), Some(at("/dev/ttyACM0")));
        assert_eq!(boards.of("other"), None);
        drop(first);
        assert_eq!(boards.of("kit"), None);
    }
}
