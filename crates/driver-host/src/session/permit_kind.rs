//! What a person can permit.

use std::fmt;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PermitKind {
    /// One wire: homing before it, accepting settings that differ, and one arming or reattaching, which uses it up.
    Wire,
    /// Wires one after the other, each cut off: a permit for each of them, and every cut.
    Row,
    /// Moves by hand: homing, and arming for moves by hand.
    ByHand,
    /// What follows a pause point of a wire, once.
    Continue,
    /// Writing settings, once.
    Settings,
    /// One line of the console that may move or change something, once.
    Console,
}

impl fmt::Display for PermitKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Wire => "bending a wire",
            Self::Row => "bending wires one after the other",
            Self::ByHand => "moves by hand",
            Self::Continue => "continuing a wire after a pause point",
            Self::Settings => "writing settings",
            Self::Console => "a line of the console",
        })
    }
}
