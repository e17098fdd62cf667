//! What one strut more or less does to the sag of a frame that is being built.

use nalgebra::Vector3;

use crate::assembly::Assembly;
use crate::error::Unstable;
use crate::member_set::MemberSet;
use crate::model::{MemberId, NodeId};

/// How far a frame sags under its own weight.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sag {
    /// The largest displacement of a node, mm.
    pub max_displacement: f64,
    /// The node that moves so far.
    pub node: NodeId,
}

/// The flexibility of what stands of a frame, and its sag under its own weight.
///
/// A strut that hangs on one end, or joins two nodes that stand, is tried without factoring anything.
pub struct Flexibility<'a> {
    assembly: &'a Assembly,
    gravity: Vector3<f64>,
    standing: MemberSet,
}

impl<'a> Flexibility<'a> {
    /// Nothing stands yet. `gravity` is the acceleration, mm/s².
    #[must_use]
    pub fn new(assembly: &'a Assembly, gravity: Vector3<f64>) -> Self {
        Self { assembly, gravity, standing: MemberSet::empty(assembly.model().members.len()) }
    }

    /// These members stand.
    ///
    /// # Errors
    /// They do not.
    pub fn of(assembly: &'a Assembly, gravity: Vector3<f64>, members: &MemberSet) -> Result<Self, Unstable> {
        Ok(Self { assembly, gravity, standing: members.clone() })
    }

    /// The members that stand.
    #[must_use]
    pub fn standing(&self) -> &MemberSet {
        &self.standing
    }

    /// Whether a node stands: a member that stands touches it, or it is a support.
    #[must_use]
    pub fn stands(&self, node: NodeId) -> bool {
        let _ = (node, self.assembly, self.gravity);
        unimplemented!("skeleton")
    }

    /// The sag of what stands; zero of nothing.
    #[must_use]
    pub fn sag(&self) -> Sag {
        unimplemented!("skeleton")
    }

    /// The displacements under their own weight of all nodes of the model, mm and radian.
    #[must_use]
    pub fn displacements(&self) -> Vec<[f64; 6]> {
        unimplemented!("skeleton")
    }

    /// The sag with one member more, which is not added. A member that stands changes nothing.
    ///
    /// # Errors
    /// Neither of its ends stands.
    pub fn try_add(&self, member: MemberId) -> Result<Sag, Unstable> {
        let _ = member;
        unimplemented!("skeleton")
    }

    /// Adds a member.
    ///
    /// # Errors
    /// Neither of its ends stands; then nothing is changed.
    pub fn add(&mut self, member: MemberId) -> Result<Sag, Unstable> {
        let _ = member;
        unimplemented!("skeleton")
    }

    /// The sag with one member less, which is not taken away. A member that does not stand changes nothing.
    ///
    /// # Errors
    /// What is left does not stand.
    pub fn try_remove(&self, member: MemberId) -> Result<Sag, Unstable> {
        let _ = member;
        unimplemented!("skeleton")
    }

    /// Takes a member away.
    ///
    /// # Errors
    /// What is left would not stand; then nothing is changed.
    pub fn remove(&mut self, member: MemberId) -> Result<Sag, Unstable> {
        let _ = member;
        unimplemented!("skeleton")
    }
}
