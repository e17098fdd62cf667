//! What can be worked out once for a model, whichever of its members are there.

use nalgebra::Matrix3;

use crate::error::{ModelError, ModesError, Unstable};
use crate::factor::Factor;
use crate::load::Load;
use crate::member_set::MemberSet;
use crate::model::{MemberId, Model};
use crate::modes::{Mode, ModeSearch};

/// A model that was checked, with the pattern of its stiffness.
pub struct Assembly {
    model: Model,
}

impl Assembly {
    /// Checks a model and works out the pattern of its stiffness, which serves every [`MemberSet`].
    ///
    /// # Errors
    /// A node, member, section or support that describes no frame, by its place in the model.
    pub fn new(model: &Model) -> Result<Self, ModelError> {
        Ok(Self { model: model.clone() })
    }

    /// The model.
    #[must_use]
    pub fn model(&self) -> &Model {
        &self.model
    }

    /// All its members.
    #[must_use]
    pub fn all(&self) -> MemberSet {
        MemberSet::all(self.model.members.len())
    }

    /// Factors the stiffness of some of the members. Nodes that none of them touches take no part.
    ///
    /// # Errors
    /// A part that nothing holds, or that can move without bending anything.
    pub fn factor(&self, members: &MemberSet) -> Result<Factor<'_>, Unstable> {
        Factor::new(self, members)
    }

    /// The lowest modes of some of the members, by rising frequency: first the rigid ones, then as many as asked for.
    ///
    /// # Errors
    /// No member; a shift that is not above zero; a section without density; a search that does not come to an end.
    pub fn modes(&self, members: &MemberSet, search: &ModeSearch) -> Result<Vec<Mode>, ModesError> {
        let _ = (members, search);
        unimplemented!("skeleton")
    }

    /// mm.
    #[must_use]
    pub fn length(&self, member: MemberId) -> f64 {
        let _ = member;
        unimplemented!("skeleton")
    }

    /// The local axes of a member as rows: x from `a` to `b`, y, z.
    #[must_use]
    pub fn axes(&self, member: MemberId) -> Matrix3<f64> {
        let _ = member;
        unimplemented!("skeleton")
    }

    /// The forces and moments at the ends of a member that move so, `K_e q`, all in the model's axes.
    #[must_use]
    pub fn end_forces(&self, member: MemberId, ends: &[f64; 12]) -> [f64; 12] {
        let _ = (member, ends);
        unimplemented!("skeleton")
    }

    /// The forces and moments at nodes that stand for a load, `f - Σ K_e q0` with the fixed-end forces of what acts along members.
    #[must_use]
    pub fn nodal_forces(&self, members: &MemberSet, load: &Load) -> Vec<[f64; 6]> {
        let _ = (members, load);
        unimplemented!("skeleton")
    }

    /// The mass of some of the members, t.
    #[must_use]
    pub fn mass(&self, members: &MemberSet) -> f64 {
        let _ = members;
        unimplemented!("skeleton")
    }
}
