//! Sets within each other: of each the next larger one around it, whose number is higher.

use crate::graph::NONE;

/// The width of each set and of all around it.
pub(crate) fn around(parents: &[u32], widths: &[i64]) -> Vec<i64> {
    let mut around = widths.to_vec();
    for (set, &parent) in parents.iter().enumerate().rev().filter(|&(_, &parent)| parent != NONE) {
        around[set] += around[parent as usize];
    }
    around
}

/// The widths of all that is around two sets, or is one of them around the other, by what is around each.
pub(crate) fn common(parents: &[u32], around: &[i64], mut a: u32, mut b: u32) -> i64 {
    while a != b {
        let inner = if a < b { &mut a } else { &mut b };
        *inner = parents[*inner as usize];
    }
    if a == NONE { 0 } else { around[a as usize] }
}
