//! Perfect matching of least cost, exact.

use wirebend_postman::cheapest_pairs;

/// Up to this many things the best for every set of those that may be left is found: that is faster than what takes more.
const FEW: usize = 12;

/// Pairs up things `0..count` (an even number) so that the sum of the costs is least. `cost` is asked
/// for each pair, lower index first; `None` forbids the pair. Where no perfect matching avoids the
/// forbidden pairs, those that it needs are left out of the result. Each pair of the result has its
/// lower index first, and they are in ascending order.
pub(super) fn min_cost_pairs(
    count: usize,
    cost: impl Fn(usize, usize) -> Option<i64>,
) -> Vec<(usize, usize)> {
    let mut costs = vec![FORBIDDEN; count * count];
    let mut dearest = 0;
    for a in 0..count {
        for b in a + 1..count {
            if let Some(cost) = cost(a, b) {
                costs[a * count + b] = cost;
                dearest = dearest.max(cost);
            }
        }
    }
    // One forbidden pair costs more than all allowed ones together.
    let forbidden = dearest.saturating_mul(i64::try_from(count / 2).unwrap_or(i64::MAX)).saturating_add(1);
    for cost in &mut costs {
        if *cost == FORBIDDEN {
            *cost = forbidden;
        }
    }
    let mates = if count <= FEW { of_few(&costs, count) } else { of_many(&costs, count) };
    let pairs = mates.into_iter().enumerate();
    pairs.filter(|&(a, b)| a < b && costs[a * count + b] < forbidden).collect()
}

/// Marks a pair until the price of forbidden ones is known.
const FORBIDDEN: i64 = -1;

/// The partner of each thing in the cheapest of all ways to pair them, `FEW` at most; the first of equals.
fn of_few(costs: &[i64], count: usize) -> Vec<usize> {
    let mut least = Least { costs, count, of: vec![(UNKNOWN, 0); 1 << count] };
    let mut left = (1 << count) - 1;
    least.find(left);
    let mut mates = vec![0; count];
    while left != 0 {
        let a = left.trailing_zeros() as usize;
        let b = least.of[left].1;
        (mates[a], mates[b]) = (b, a);
        left &= !(1 << a | 1 << b);
    }
    mates
}

/// The partner of each thing in the cheapest of all ways to pair them.
fn of_many(costs: &[i64], count: usize) -> Vec<usize> {
    let cost = |a: u32, b: u32| costs[a as usize * count + b as usize].unsigned_abs();
    let mates = cheapest_pairs(u32::try_from(count).unwrap_or(u32::MAX), cost);
    mates.into_iter().map(|mate| mate as usize).collect()
}

const UNKNOWN: i64 = -1;

/// For each set of things, a bit each, the least cost of pairing them and the partner of the first then.
struct Least<'a> {
    costs: &'a [i64],
    count: usize,
    of: Vec<(i64, usize)>,
}

impl Least<'_> {
    fn find(&mut self, set: usize) -> i64 {
        if set == 0 || self.of[set].0 != UNKNOWN {
            return self.of[set].0.max(0);
        }
        let a = set.trailing_zeros() as usize;
        let others = set & (set - 1);
        let mut best = (i64::MAX, a);
        let mut untried = others;
        while untried != 0 {
            let b = untried.trailing_zeros() as usize;
            untried &= untried - 1;
            let cost = self.costs[a * self.count + b] + self.find(others & !(1 << b));
            if cost < best.0 {
                best = (cost, b);
            }
        }
        self.of[set] = best;
        best.0
    }
}

#[cfg(test)]
mod tests {
    use integer_blossom::min_weight_perfect_matching;
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn a_forbidden_pair_is_left_out_where_nothing_else_is_possible() {
        // 0 and 1 are the two ends of a wire; they may not meet, and 2 and 3 may.
        let pairs = min_cost_pairs(4, |a, b| ((a, b) != (0, 1)).then_some(10));
        assert_eq!(pairs.len(), 2);
        assert!(!pairs.contains(&(0, 1)));
        assert_eq!(min_cost_pairs(2, |_, _| None), []);
    }

    proptest! {
        #[test]
        fn all_ways_to_match_agree(costs in prop::collection::vec(0..1000_i64, FEW * FEW), half in 1..=FEW / 2) {
            let count = 2 * half;
            let total = |mates: Vec<usize>| -> i64 {
                mates.iter().enumerate().filter(|&(a, &b)| a < b).map(|(a, &b)| costs[a * count + b]).sum()
            };
            let costs = &costs[..count * count];
            let other = total(min_weight_perfect_matching(costs, count));
            prop_assert_eq!(total(of_few(costs, count)), other);
            prop_assert_eq!(total(of_many(costs, count)), other);
        }
    }
}
