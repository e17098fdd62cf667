//! Which of several programs that meet nothing is the best.

use std::collections::BTreeSet;

use super::Found;
use crate::units::Length;
use crate::wireframe::Wireframe;

/// What makes one program better than another.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Objective {
    /// Fewer wires first, then less that is doubled, then less time.
    #[default]
    InOrder,
    /// The least sum of these; in order where that is the same.
    Weighed(Weights),
}

/// What each part of a program costs, in a unit that whoever sets them chooses.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Weights {
    /// A wire.
    pub wire: u32,
    /// A millimetre that is doubled.
    pub doubled_mm: u32,
    /// A second of turns of the head and of bends. Feeds are as long as the design and what is doubled.
    pub second: u32,
}

/// Of two the smaller one is better: the sum of weights in millionths, the number of wires, what is doubled, ns.
pub(super) type Order = (u128, usize, Length, i64);

impl Objective {
    /// How good wires are.
    pub(super) fn order(self, wireframe: &Wireframe, found: &Found) -> Order {
        let mut passed = BTreeSet::new();
        let all = found.wires.iter().flat_map(|wire| &wire.route.traversals);
        let again = all.filter(|traversal| !passed.insert(traversal.edge));
        let added: Length = again.map(|traversal| wireframe.edge_length(traversal.edge)).sum();
        let nanoseconds: i64 = found.wires.iter().map(|wire| wire.nanoseconds).sum();
        // Sums in another order differ by less than a thousandth of a millimetre.
        let micrometres = (added.mm() * 1000.0).round();
        let sum = self.sum(found.wires.len(), micrometres, nanoseconds);
        (sum, found.wires.len(), Length::computed(micrometres), nanoseconds)
    }

    /// Whether so many wires can be better than a program of this order: without anything doubled and in no time.
    pub(super) fn may_pay(self, wires: usize, best: &Order) -> bool {
        self == Self::InOrder || self.sum(wires, 0.0, 0) < best.0
    }

    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // whole and not negative
    fn sum(self, wires: usize, micrometres: f64, nanoseconds: i64) -> u128 {
        let Self::Weighed(Weights { wire, doubled_mm, second }) = self else { return 0 };
        u128::from(wire) * wires as u128 * 1_000_000
            + u128::from(doubled_mm) * micrometres as u128 * 1000
            + u128::from(second) * u128::from(nanoseconds.unsigned_abs()) / 1000
    }
}
