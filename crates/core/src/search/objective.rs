//! Which of several programs that meet nothing is the best.

use std::collections::BTreeSet;

use super::{BestSoFar, Found};
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

/// How good wires are: of two the smaller one is better.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Order {
    /// The sum of weights, in millionths.
    sum: u128,
    /// How many there are.
    wires: usize,
    /// The length of the edges that they run along again, µm.
    doubled: u64,
    /// What their turns and bends take.
    nanoseconds: i64,
}

impl Order {
    /// What of it is told while the search goes on.
    #[allow(clippy::cast_precision_loss)] // kilometres
    pub fn so_far(self) -> BestSoFar {
        BestSoFar { wires: self.wires, doubled: Length::computed(self.doubled as f64 / 1000.0) }
    }
}

impl Objective {
    /// How good wires are.
    pub(super) fn order(self, wireframe: &Wireframe, found: &Found) -> Order {
        let mut passed = BTreeSet::new();
        let all = found.wires.iter().flat_map(|wire| &wire.route.traversals);
        let again = all.filter(|traversal| !passed.insert(traversal.edge));
        let added: Length = again.map(|traversal| wireframe.edge_length(traversal.edge)).sum();
        let nanoseconds: i64 = found.wires.iter().map(|wire| wire.nanoseconds).sum();
        // Sums in another order differ by less than a thousandth of a millimetre.
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // whole and not negative
        let doubled = (added.mm() * 1000.0).round() as u64;
        let wires = found.wires.len();
        Order { sum: self.sum(wires, doubled, nanoseconds), wires, doubled, nanoseconds }
    }

    /// Whether so many wires can be better than a program of this order: without anything doubled and in no time.
    pub(super) fn may_pay(self, wires: usize, best: &Order) -> bool {
        self == Self::InOrder || self.sum(wires, 0, 0) < best.sum
    }

    fn sum(self, wires: usize, micrometres: u64, nanoseconds: i64) -> u128 {
        let Self::Weighed(Weights { wire, doubled_mm, second }) = self else { return 0 };
        u128::from(wire) * wires as u128 * 1_000_000
            + u128::from(doubled_mm) * u128::from(micrometres) * 1000
            + u128::from(second) * u128::from(nanoseconds.unsigned_abs()) / 1000
    }
}
