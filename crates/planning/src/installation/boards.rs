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

/// The machines that are connected, each by the id of its profile.
#[derive(Debug, Clone, Default)]
pub struct Boards(Arc<Mutex<BTreeMap<String, Board>>>);

impl Boards {
    /// The one with a profile.
    pub fn of(&self, machine: &str) -> Option<Board> {
        self.all().get(machine).cloned()
    }

    /// A machine has answered.
    pub fn met(&self, machine: &str, board: Board) -> Met {
        self.all().insert(machine.to_owned(), board);
        Met { boards: self.clone(), machine: machine.to_owned() }
    }

    fn all(&self) -> MutexGuard<'_, BTreeMap<String, Board>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// A machine is connected as long as this is kept.
#[derive(Debug)]
pub struct Met {
    boards: Boards,
    machine: String,
}

impl Met {
    /// It says so from now on.
    pub fn says(&self, limits: &Limits) {
        if let Some(board) = self.boards.all().get_mut(&self.machine) {
            board.limits.clone_from(limits);
        }
    }
}

impl Drop for Met {
    fn drop(&mut self) {
        self.boards.all().remove(&self.machine);
    }
}
