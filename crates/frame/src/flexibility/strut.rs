//! A strut that is added to what stands, or taken away.

use std::ops::AddAssign;

use nalgebra::{Matrix6, Vector3, Vector6};

use crate::assembly::Assembly;
use crate::element::{Element, Vector12};
use crate::model::MemberId;

/// Where a strut is.
pub(super) enum Place {
    /// Its base stands without it, its tip does not.
    Hangs(Strut),
    /// Both ends stand without it.
    Joins(Strut),
}

/// A strut from a node that stands without it.
pub(super) struct Strut {
    element: Element,
    /// The node that stands.
    pub base: usize,
    /// The other.
    pub tip: usize,
    /// How the tip gives way while the base is clamped.
    pub gives: Matrix6<f64>,
    /// The forces at base and tip that stand for its weight.
    pub weight: Vector12,
}

impl Strut {
    pub fn new(assembly: &Assembly, member: MemberId, from_a: bool, gravity: Vector3<f64>) -> Self {
        let model = assembly.model();
        let ends = &model.members[member.0];
        let section = assembly.section(member);
        let (base, tip, element) = if from_a {
            (ends.a.0, ends.b.0, assembly.elements[member.0])
        } else {
            let span = model.nodes[ends.a.0] - model.nodes[ends.b.0];
            (ends.b.0, ends.a.0, Element::new(span, section, ends.up))
        };
        let weight = element.spread(&(gravity * assembly.weight(member)));
        Self { element, base, tip, gives: element.cantilever(section), weight }
    }

    /// Adds a force at the tip to its weight.
    pub fn add_at_tip(&mut self, force: &Vector3<f64>) {
        self.weight.fixed_rows_mut::<3>(6).add_assign(force);
    }

    /// The force and moment at the base that its whole weight amounts to.
    pub fn weight_at_base(&self) -> Vector6<f64> {
        self.weight.fixed_rows::<6>(0) + self.carried_back(&self.weight_of_tip())
    }

    /// The force and moment at the tip that stand for its weight.
    pub fn weight_of_tip(&self) -> Vector6<f64> {
        self.weight.fixed_rows::<6>(6).into_owned()
    }

    /// How a tip that hangs moves under the weight of the strut when the base moves so.
    pub fn tip_moves(&self, base: &[f64; 6]) -> [f64; 6] {
        (self.carried(&Vector6::from(*base)) + self.gives * self.weight_of_tip()).into()
    }

    /// H: how the tip moves with the base.
    pub fn carried(&self, base: &Vector6<f64>) -> Vector6<f64> {
        self.element.carried(base)
    }

    /// Hᵀ: what a force and moment at the tip are at the base.
    pub fn carried_back(&self, tip: &Vector6<f64>) -> Vector6<f64> {
        self.element.carried_back(tip)
    }

    /// H times the columns of a matrix.
    pub fn carried_all(&self, columns: &Matrix6<f64>) -> Matrix6<f64> {
        let mut all = *columns;
        for mut column in all.column_iter_mut() {
            let carried = self.carried(&column.clone_owned());
            column.copy_from(&carried);
        }
        all
    }
}
