//! Perfect matching of least cost, exact.

use integer_blossom::min_weight_perfect_matching;

/// Up to this many things every way to pair them is tried: 105 ways for 8.
const FEW: usize = 8;

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
    let mates =
        if count <= FEW { try_all(&costs, count) } else { min_weight_perfect_matching(&costs, count) };
    let pairs = mates.into_iter().enumerate();
    pairs.filter(|&(a, b)| a < b && costs[a * count + b] < forbidden).collect()
}

/// Marks a pair until the price of forbidden ones is known.
const FORBIDDEN: i64 = -1;

/// The partner of each thing in the cheapest of all ways to pair them, `FEW` at most; the first of equals.
fn try_all(costs: &[i64], count: usize) -> Vec<usize> {
    fn go(costs: &[i64], spent: i64, mates: &mut [usize], best: &mut (i64, [usize; FEW])) {
        let count = mates.len();
        let Some(a) = mates.iter().position(|&mate| mate == count) else {
            best.0 = spent;
            best.1[..count].copy_from_slice(mates);
            return;
        };
        for b in a + 1..count {
            let total = spent + costs[a * count + b];
            if mates[b] == count && total < best.0 {
                (mates[a], mates[b]) = (b, a);
                go(costs, total, mates, best);
                (mates[a], mates[b]) = (count, count);
            }
        }
    }
    let mut best = (i64::MAX, [0; FEW]);
    go(costs, 0, &mut [count; FEW][..count], &mut best);
    best.1[..count].to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

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
        fn both_ways_to_match_agree(costs in prop::collection::vec(0..1000_i64, 64), half in 1..4_usize) {
            let count = 2 * half;
            let total = |mates: Vec<usize>| -> i64 {
                mates.iter().enumerate().filter(|&(a, &b)| a < b).map(|(a, &b)| costs[a * count + b]).sum()
            };
            let costs = &costs[..count * count];
            prop_assert_eq!(total(try_all(costs, count)), total(min_weight_perfect_matching(costs, count)));
        }
    }
}
