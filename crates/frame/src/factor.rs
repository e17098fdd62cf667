//! A frame whose stiffness is factored: ready for any number of loads.

use crate::assembly::Assembly;
use crate::error::{SolveError, Unstable};
use crate::load::Load;
use crate::member_set::MemberSet;
use crate::response::Response;

/// The factored stiffness of some members of an assembly.
pub struct Factor<'a> {
    assembly: &'a Assembly,
    members: MemberSet,
}

impl<'a> Factor<'a> {
    pub(crate) fn new(assembly: &'a Assembly, members: &MemberSet) -> Result<Self, Unstable> {
        Ok(Self { assembly, members: members.clone() })
    }

    /// The members that are there.
    #[must_use]
    pub fn members(&self) -> &MemberSet {
        &self.members
    }

    /// What the frame does under a load.
    ///
    /// # Errors
    /// A load on a member or node that is not there; a displacement beyond ten times the size of the model.
    pub fn solve(&self, load: &Load) -> Result<Response, SolveError> {
        let _ = (load, self.assembly);
        unimplemented!("skeleton")
    }

    /// Displacements alone, for many cases of forces and moments at nodes at once: `forces[case][node]`, in the model's axes.
    /// What acts at a node that is held or not there is left out. Nothing is checked.
    #[must_use]
    pub fn displacements(&self, forces: &[Vec<[f64; 6]>]) -> Vec<Vec<[f64; 6]>> {
        let _ = forces;
        unimplemented!("skeleton")
    }
}
