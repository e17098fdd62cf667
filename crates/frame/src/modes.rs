//! How a frame vibrates.

use crate::assembly::Assembly;
use crate::error::ModesError;
use crate::member_set::MemberSet;

/// What modes are looked for.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeSearch {
    /// How many modes that bend something.
    pub count: usize,
    /// Where the search starts, Hz: a tenth to a fifth of the lowest expected frequency. The answer does not depend on it.
    pub shift_hz: f64,
    /// Of each member, the strut that it is a piece of, as [`Pieces::struts`](crate::Pieces) has it; empty where each member is
    /// a strut of its own.
    pub struts: Vec<usize>,
}

/// What a mode is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ModeKind {
    /// The frame, or a part of it, moves without bending: there is nothing that holds it.
    Rigid,
    /// The frame bends.
    Global,
    /// One strut holds more than half of the kinetic energy between its ends.
    Local {
        /// Which one, as in [`ModeSearch::struts`].
        strut: usize,
    },
}

/// A way in which a frame vibrates.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// Hz.
    pub frequency_hz: f64,
    /// What it is.
    pub kind: ModeKind,
    /// Of each node, mm and radian, so that the modal mass is 1 t. Modes of equal frequency come in any mixture.
    pub shape: Vec<[f64; 6]>,
}

pub(crate) fn find(
    assembly: &Assembly,
    members: &MemberSet,
    search: &ModeSearch,
) -> Result<Vec<Mode>, ModesError> {
    let _ = (assembly, members, search);
    unimplemented!("skeleton")
}
