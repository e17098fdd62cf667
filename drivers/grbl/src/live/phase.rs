//! The phases of a connection, and what each has to remember.

use std::time::Duration;

use super::jog_row::JogRow;
use super::wire_run::WireRun;

#[derive(Debug)]
pub(super) enum Phase {
    /// Nothing that grbl would send has come yet.
    Greeting(Greeting),
    /// The driver asks for version, settings and state.
    Reading(Reading),
    Ready,
    /// The homing cycle, or zero set where the axes stand.
    Homing {
        since: Duration,
    },
    /// One axis jogs; since when it has been stopping.
    Jogging {
        stopping: Option<Duration>,
        row: JogRow,
    },
    /// What was bent is cut off.
    Cutting(JogRow),
    /// A line that a person has typed is awaited.
    Console(Typed),
    /// Armed for a wire, or running it.
    Running(Box<WireRun>),
    /// Decelerating after a fault, so that the reset that follows loses no steps.
    Halting {
        since: Duration,
    },
    /// Reset; the greeting and the first status report are awaited.
    Resetting(Reset),
    /// The controller does not answer. STOP can still be sent.
    NotResponding,
    /// The port is closed, or about to be.
    Closed,
}

/// What has been sent to wake the controller up.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Attempt {
    None,
    /// An empty line and a status query.
    EmptyLine,
    Reset,
}

/// Waiting for the greeting, or for any other sign of grbl.
#[derive(Debug, Clone, Copy)]
pub(super) struct Greeting {
    pub since: Duration,
    pub attempt: Attempt,
    /// The empty line has been answered. Before that, its answer could be mistaken for that of another line.
    pub line_answered: bool,
    /// The program has asked for a stop meanwhile.
    pub stop: bool,
}

impl Greeting {
    pub const fn at(since: Duration) -> Self {
        Self { since, attempt: Attempt::None, line_answered: false, stop: false }
    }
}

/// What the driver is waiting for: `$I`, then `$$`, then a status report.
#[derive(Debug, Clone, Copy)]
pub(super) enum Reading {
    Build { since: Duration, stop: bool },
    Settings { since: Duration, stop: bool },
    State { since: Duration, stop: bool },
}

impl Reading {
    pub const fn parts(self) -> (Duration, bool) {
        match self {
            Self::Build { since, stop } | Self::Settings { since, stop } | Self::State { since, stop } => {
                (since, stop)
            }
        }
    }
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Reset {
    /// The program has asked for it, and hears when it is over.
    pub stop: bool,
    pub since: Duration,
    pub tries: u32,
    pub greeted: bool,
}

/// What is awaited of a line that was sent.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Typed {
    /// The report that `?` is answered with.
    Report,
    /// The answer to a question.
    Answer,
    /// The answer to a command, then rest.
    Rest { moves: bool, held: bool },
    /// The settings, which are read again after a command.
    Settings { moves: bool },
}

impl Typed {
    /// Whether something may move.
    pub const fn may_move(self) -> bool {
        matches!(self, Self::Rest { .. })
    }
}
