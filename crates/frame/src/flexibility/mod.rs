//! What one strut more or less does to the sag of a frame that is being built.
//!
//! F = K⁻¹ is kept for what stands. Node j that hangs on i by one strut has `F_j* = H F_i*` and `F_jj = H F_ii Hᵀ + C`, with H the rigid
//! transport and C the flexibility of the cantilever; all else sees the weight of the strut alone. A strut between two nodes that
//! stand is a change of rank six, with G = [-H, 1]: F - F Gᵀ (C + G F Gᵀ)⁻¹ G F (Woodbury). Both give the displacements under weight
//! for the price of the rows of F of the two nodes.

mod store;
mod strut;

use nalgebra::Vector3;

use crate::assembly::Assembly;
use crate::error::Unstable;
use crate::load::{Load, NodeMass};
use crate::loads;
use crate::member_set::MemberSet;
use crate::model::{MemberId, NodeId};
use crate::parts;
use store::Store;
use strut::{Place, Strut};

/// From so many nodes on the rows of F come from the factored stiffness when they are needed: they would take 72 MB.
const DENSE_NODES: usize = 500;

/// Where a step of refinement moves a node by more than this share of the sag, F has lost digits and is made anew. That is so when
/// a long arm is tied down: what is left of F is small beside what rounding was of it before.
const DRIFT: f64 = 1e-10;

/// After so many changes F is made anew in any case.
const CHANGES: usize = 16;

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
/// A strut that hangs on one end, or joins two nodes that stand, is tried without factoring anything, unless an end of it is a support
/// that holds some displacements and rotations and not all. What stands is known to about nine digits; what is tried to five
/// or more, since a strut that carries a soft frame is the small difference of large flexibilities.
pub struct Flexibility<'a> {
    assembly: &'a Assembly,
    /// Gravity, and masses at nodes.
    weight: Load,
    /// Of each node, its mass, t.
    mass: Vec<f64>,
    standing: MemberSet,
    /// Of each node, how many members that stand touch it.
    touching: Vec<usize>,
    /// Of each node, how many of its displacements and rotations are held.
    held: Vec<usize>,
    /// Of each node, mm and radian.
    displacements: Vec<[f64; 6]>,
    store: Store<'a>,
    /// How many since F was made anew.
    changes: usize,
}

/// What a change makes of the displacements.
struct Outcome {
    displacements: Vec<[f64; 6]>,
    sag: Sag,
}

impl<'a> Flexibility<'a> {
    /// Nothing stands yet. `gravity` is the acceleration, mm/s².
    #[must_use]
    pub fn new(assembly: &'a Assembly, gravity: Vector3<f64>) -> Self {
        Self::with_masses(assembly, gravity, &[])
    }

    /// Nothing stands yet; masses at nodes weigh something as soon as a member that stands ends there.
    #[must_use]
    pub fn with_masses(assembly: &'a Assembly, gravity: Vector3<f64>, masses: &[NodeMass]) -> Self {
        let nodes = assembly.model().nodes.len();
        let mut mass = vec![0.0; nodes];
        for at in masses {
            if let Some(sum) = mass.get_mut(at.node.0) {
                *sum += at.mass;
            }
        }
        let equations = &assembly.equations.of_node;
        let held: Vec<usize> =
            equations.iter().map(|of| of.iter().filter(|&&k| k == crate::equations::NONE).count()).collect();
        let free = held.iter().filter(|&&count| count < 6).count();
        Self {
            assembly,
            weight: Load { gravity, masses: masses.to_vec(), ..Load::default() },
            mass,
            standing: MemberSet::empty(assembly.model().members.len()),
            touching: vec![0; nodes],
            held,
            displacements: vec![[0.0; 6]; nodes],
            store: Store::new(nodes, free <= DENSE_NODES),
            changes: 0,
        }
    }

    /// These members stand.
    ///
    /// # Errors
    /// They do not.
    pub fn of(assembly: &'a Assembly, gravity: Vector3<f64>, members: &MemberSet) -> Result<Self, Unstable> {
        let mut flexibility = Self::new(assembly, gravity);
        flexibility.make_anew(members.clone())?;
        Ok(flexibility)
    }

    /// The members that stand.
    #[must_use]
    pub fn standing(&self) -> &MemberSet {
        &self.standing
    }

    /// Whether a node stands: a member that stands touches it, or it is held altogether.
    #[must_use]
    pub fn stands(&self, node: NodeId) -> bool {
        self.touching[node.0] > 0 || self.is_clamped(node.0)
    }

    fn is_clamped(&self, node: usize) -> bool {
        self.held[node] == 6
    }

    /// The sag of what stands; zero of nothing.
    #[must_use]
    pub fn sag(&self) -> Sag {
        sag(&self.displacements).0
    }

    /// The displacements under their own weight of all nodes of the model, mm and radian; zero of those that do not stand.
    #[must_use]
    pub fn displacements(&self) -> &[[f64; 6]] {
        &self.displacements
    }

    /// The sag with one member more, which is not added. A member that stands changes nothing.
    ///
    /// # Errors
    /// Neither of its ends stands, or it moves by what is no finite number.
    pub fn try_add(&self, member: MemberId) -> Result<Sag, Unstable> {
        if self.standing.contains(member) {
            return Ok(self.sag());
        }
        match self.place(member)? {
            Some(place) => Ok(self.added(&place)?.sag),
            None => Ok(self.factored(&self.with(member))?.sag),
        }
    }

    /// Adds a member. Of one that stands already nothing changes.
    ///
    /// # Errors
    /// Neither of its ends stands, or it moves by what is no finite number; then nothing is changed.
    pub fn add(&mut self, member: MemberId) -> Result<Sag, Unstable> {
        if self.standing.contains(member) {
            return Ok(self.sag());
        }
        let with = self.with(member);
        match self.place(member)? {
            Some(place) if self.store.is_dense() => {
                self.displacements = self.added(&place)?.displacements;
                self.store.add(&place);
                self.took(member, with)?;
            }
            _ => self.make_anew(with)?,
        }
        Ok(self.sag())
    }

    /// The sag with one member less, which is not taken away. A member that does not stand changes nothing.
    ///
    /// # Errors
    /// What is left does not stand.
    pub fn try_remove(&self, member: MemberId) -> Result<Sag, Unstable> {
        if !self.standing.contains(member) {
            return Ok(self.sag());
        }
        let without = self.without(member);
        parts::check(self.assembly, &without)?;
        let place = self.place_of_standing(member);
        match place.and_then(|place| self.removed(&place)) {
            Some(outcome) => Ok(outcome.sag),
            None => Ok(self.factored(&without)?.sag),
        }
    }

    /// Takes a member away. Of one that does not stand nothing changes.
    ///
    /// # Errors
    /// What is left would not stand; then nothing is changed.
    pub fn remove(&mut self, member: MemberId) -> Result<Sag, Unstable> {
        if !self.standing.contains(member) {
            return Ok(self.sag());
        }
        let without = self.without(member);
        parts::check(self.assembly, &without)?;
        let place = self.place_of_standing(member).filter(|_| self.store.is_dense());
        let outcome = place.and_then(|place| Some((self.removed(&place)?, place)));
        match outcome {
            Some((outcome, place)) => {
                self.displacements = outcome.displacements;
                self.store.remove(&place);
                self.took(member, without)?;
            }
            None => self.make_anew(without)?,
        }
        Ok(self.sag())
    }

    fn with(&self, member: MemberId) -> MemberSet {
        let mut with = self.standing.clone();
        with.insert(member);
        with
    }

    fn without(&self, member: MemberId) -> MemberSet {
        let mut without = self.standing.clone();
        without.remove(member);
        without
    }

    /// Notes that a member was added or taken away, and refines the displacements.
    fn took(&mut self, member: MemberId, standing: MemberSet) -> Result<(), Unstable> {
        let ends = &self.assembly.model().members[member.0];
        for node in [ends.a.0, ends.b.0] {
            if standing.contains(member) {
                self.touching[node] += 1;
            } else {
                self.touching[node] -= 1;
            }
        }
        self.standing = standing;
        let more = self.store.under(&self.left_over());
        let ((moved, finite), all) = (sag(&more), self.sag());
        self.changes += 1;
        if self.changes >= CHANGES || !finite || moved.max_displacement > DRIFT * all.max_displacement {
            return self.make_anew(self.standing.clone());
        }
        self.displacements.iter_mut().flatten().zip(more.iter().flatten()).for_each(|(u, more)| *u += more);
        Ok(())
    }

    /// What the weight leaves at nodes when the forces of members are taken away.
    fn left_over(&self) -> Vec<[f64; 6]> {
        let mut rest = self.weight(&self.standing);
        for member in self.standing.iter() {
            let forces =
                self.assembly.elements[member.0].forces(&self.assembly.ends(member, &self.displacements));
            loads::add(self.assembly, &mut rest, member, &-forces);
        }
        rest
    }

    /// Where a member that does not stand would be; `None` where only factoring tells.
    fn place(&self, member: MemberId) -> Result<Option<Place>, Unstable> {
        let ends = &self.assembly.model().members[member.0];
        let (a, b) = (ends.a, ends.b);
        if !self.stands(a) && !self.stands(b) && self.held[a.0] + self.held[b.0] == 0 {
            return Err(Unstable::PartWithoutSupport { node: a.min(b), members: vec![member] });
        }
        if self.is_half_held(a) || self.is_half_held(b) {
            return Ok(None);
        }
        Ok(Some(match (self.stands(a), self.stands(b)) {
            (true, true) => Place::Joins(self.strut(member, true)),
            (true, false) => self.hangs(member, true),
            _ => self.hangs(member, false),
        }))
    }

    /// Where a member that stands is, by what is left without it; `None` where only factoring tells.
    fn place_of_standing(&self, member: MemberId) -> Option<Place> {
        let ends = &self.assembly.model().members[member.0];
        if self.is_half_held(ends.a) || self.is_half_held(ends.b) {
            return None;
        }
        let stays = |node: NodeId| self.touching[node.0] > 1 || self.is_clamped(node.0);
        match (stays(ends.a), stays(ends.b)) {
            (true, true) => Some(Place::Joins(self.strut(member, true))),
            (true, false) => Some(self.hangs(member, true)),
            (false, true) => Some(self.hangs(member, false)),
            (false, false) => None,
        }
    }

    fn strut(&self, member: MemberId, from_a: bool) -> Strut {
        Strut::new(self.assembly, member, from_a, self.weight.gravity)
    }

    /// A strut whose tip stands by it alone: the mass there comes and goes with it.
    fn hangs(&self, member: MemberId, from_a: bool) -> Place {
        let mut strut = self.strut(member, from_a);
        let weight = self.weight.gravity * self.mass[strut.tip];
        strut.add_at_tip(&weight);
        Place::Hangs(strut)
    }

    fn is_half_held(&self, node: NodeId) -> bool {
        (1..6).contains(&self.held[node.0])
    }

    fn added(&self, place: &Place) -> Result<Outcome, Unstable> {
        let mut displacements = self.displacements.clone();
        match place {
            Place::Hangs(strut) => {
                self.store.act(strut.base, &strut.weight_at_base(), &mut displacements);
                displacements[strut.tip] = strut.tip_moves(&displacements[strut.base]);
            }
            Place::Joins(strut) => self.store.join(strut, &mut displacements),
        }
        self.outcome(displacements)
    }

    /// `None` where a member is so much of the stiffness that what is left has to be factored.
    fn removed(&self, place: &Place) -> Option<Outcome> {
        let mut displacements = self.displacements.clone();
        match place {
            Place::Hangs(strut) => {
                self.store.act(strut.base, &-strut.weight_at_base(), &mut displacements);
                displacements[strut.tip] = [0.0; 6];
            }
            Place::Joins(strut) => self.store.part(strut, &mut displacements)?,
        }
        self.outcome(displacements).ok()
    }

    /// The displacements of some members, by factoring their stiffness.
    fn factored(&self, members: &MemberSet) -> Result<Outcome, Unstable> {
        let displacements = if members.is_empty() {
            vec![[0.0; 6]; self.displacements.len()]
        } else {
            let factor = self.assembly.factor(members)?;
            factor.displacements(&[self.weight(members)]).swap_remove(0)
        };
        self.outcome(displacements)
    }

    /// What displacements make of the sag, where they are finite.
    fn outcome(&self, displacements: Vec<[f64; 6]>) -> Result<Outcome, Unstable> {
        match sag(&displacements) {
            (sag, true) => Ok(Outcome { displacements, sag }),
            (sag, false) => Err(Unstable::TooSoft {
                node: sag.node,
                displacement_mm: f64::INFINITY,
                size_mm: self.assembly.size(),
            }),
        }
    }

    /// The forces at nodes that stand for the weight of some members.
    fn weight(&self, members: &MemberSet) -> Vec<[f64; 6]> {
        // Weight acts on what is there, and is finite where gravity and masses are.
        self.assembly
            .nodal_forces(members, &self.weight)
            .unwrap_or_else(|_| vec![[f64::NAN; 6]; self.displacements.len()])
    }

    fn make_anew(&mut self, members: MemberSet) -> Result<(), Unstable> {
        let weight = self.weight(&members);
        self.store.fill(self.assembly, &members)?;
        match self.outcome(self.store.under(&weight)) {
            Ok(outcome) => self.displacements = outcome.displacements,
            Err(unstable) => {
                self.store.fill(self.assembly, &self.standing)?;
                return Err(unstable);
            }
        }
        self.touching.fill(0);
        for member in members.iter() {
            let ends = &self.assembly.model().members[member.0];
            self.touching[ends.a.0] += 1;
            self.touching[ends.b.0] += 1;
        }
        self.standing = members;
        self.changes = 0;
        Ok(())
    }
}

/// The node that moves farthest, and whether all figures are finite; otherwise it is the first where one is not. Ties go to the first.
fn sag(displacements: &[[f64; 6]]) -> (Sag, bool) {
    let mut most = (0.0, 0);
    for (k, u) in displacements.iter().enumerate() {
        let squared = u[0] * u[0] + u[1] * u[1] + u[2] * u[2];
        if !squared.is_finite() || !u.iter().all(|value| value.is_finite()) {
            return (Sag { max_displacement: f64::INFINITY, node: NodeId(k) }, false);
        }
        if squared > most.0 {
            most = (squared, k);
        }
    }
    (Sag { max_displacement: most.0.sqrt(), node: NodeId(most.1) }, true)
}
