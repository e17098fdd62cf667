//! How a frame vibrates: the lowest modes of K x = ω² M x, with the consistent mass of the members and masses
//! at nodes.
//!
//! Rigid motions are written down, not searched for; the others are found by shift-invert Lanczos in blocks (Golub, Underwood
//! 1977; Grimes, Lewis, Simon 1994). Hundreds of modes of single struts may crowd within 2 % of the lowest, and modes of symmetric
//! frames are equal in pairs, so that iteration in a small subspace does not converge.

mod basis;
mod bending;
mod lanczos;
mod local;
mod mass;
mod rigid;

use std::f64::consts::TAU;

use crate::assembly::Assembly;
use crate::error::ModesError;
use crate::load::NodeMass;
use crate::member_set::MemberSet;
use crate::model::SectionId;
use mass::Mass;

/// What modes are looked for.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeSearch {
    /// How many modes that bend something; fewer are given where the model has fewer.
    pub count: usize,
    /// Where the search starts, Hz: a tenth to a fifth of the lowest expected frequency. The answer does not depend on it.
    pub shift_hz: f64,
    /// Of each member, the strut that it is a piece of, as [`Pieces::struts`](crate::Pieces) has it; empty where each member is
    /// a strut of its own.
    pub struts: Vec<usize>,
    /// Masses at nodes. A node at which no member that is there ends has none.
    pub masses: Vec<NodeMass>,
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

impl Assembly {
    /// The lowest modes of some of the members, by rising frequency: first the rigid ones, then as many as asked for.
    ///
    /// # Errors
    /// No member; a shift that is not above zero; a section without density; a search that does not come to an end.
    pub fn modes(&self, members: &MemberSet, search: &ModeSearch) -> Result<Vec<Mode>, ModesError> {
        find(self, members, search)
    }
}

fn find(assembly: &Assembly, members: &MemberSet, search: &ModeSearch) -> Result<Vec<Mode>, ModesError> {
    check(assembly, members, search)?;
    let mass = Mass::new(assembly, members, &search.masses);
    let rigid = rigid::motions(assembly, members, &mass);
    let bending = bending::find(assembly, members, search, &mass, &rigid)?;

    let interiors = local::Interiors::new(assembly, members, &search.struts);
    let mut modes = Vec::with_capacity(rigid.len() + bending.len());
    for (vector, floats) in rigid.iter().map(|v| (v, true)).chain(bending.iter().map(|v| (v, false))) {
        let shape = shape(assembly, vector);
        let squared = twice_energy(assembly, members, &shape).max(0.0);
        let kind = if floats { ModeKind::Rigid } else { interiors.kind(assembly, members, &shape) };
        modes.push(Mode { frequency_hz: squared.sqrt() / TAU, kind, shape });
    }
    modes[rigid.len()..].sort_by(|one, other| one.frequency_hz.total_cmp(&other.frequency_hz));
    Ok(modes)
}

fn check(assembly: &Assembly, members: &MemberSet, search: &ModeSearch) -> Result<(), ModesError> {
    if members.is_empty() {
        return Err(ModesError::NoMembers);
    }
    if !(search.shift_hz.is_finite() && search.shift_hz > 0.0) {
        return Err(ModesError::Shift { shift_hz: search.shift_hz });
    }
    let all = assembly.model().members.len();
    if !search.struts.is_empty() && search.struts.len() != all {
        return Err(ModesError::Struts { struts: search.struts.len(), members: all });
    }
    let masses = &search.masses;
    let is_mass =
        |of: &NodeMass| of.mass.is_finite() && of.mass >= 0.0 && of.node.0 < assembly.model().nodes.len();
    if let Some(wrong) = masses.iter().find(|of| !is_mass(of)) {
        return Err(ModesError::Mass { node: wrong.node });
    }
    let weightless = members.iter().find(|&member| assembly.section(member).density <= 0.0);
    weightless.map_or(Ok(()), |member| {
        let section: SectionId = assembly.model().members[member.0].section;
        Err(ModesError::Weightless { section })
    })
}

/// How nodes move in a solution of the equations.
fn shape(assembly: &Assembly, vector: &[f64]) -> Vec<[f64; 6]> {
    let mut shape = vec![[0.0; 6]; assembly.model().nodes.len()];
    for (value, freedom) in vector.iter().zip(&assembly.equations.freedoms) {
        let unit = if freedom.axis < 3 { 1.0 } else { assembly.rotation_unit };
        shape[freedom.node][freedom.axis] = value / unit;
    }
    shape
}

/// xᵀ K x, which of a modal mass of 1 is ω².
fn twice_energy(assembly: &Assembly, members: &MemberSet, shape: &[[f64; 6]]) -> f64 {
    let of =
        |member: crate::MemberId| assembly.elements[member.0].twice_energy(&assembly.ends(member, shape));
    members.iter().map(of).sum()
}
