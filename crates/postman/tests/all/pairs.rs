//! Pairs of things beside those that another's solver finds.

use proptest::prelude::*;
use wirebend_postman::cheapest_pairs;

/// Costs of all pairs of an even number of things, of which many are the same and some are far larger than others.
fn any_costs() -> impl Strategy<Value = (usize, Vec<i64>)> {
    (1_usize..30).prop_flat_map(|half| {
        let cost = prop_oneof![Just(0), Just(1), 0..10_i64, 0..100_000_i64, Just(1 << 35), Just(1 << 46)];
        (Just(2 * half), prop::collection::vec(cost, 4 * half * half))
    })
}

fn pairs(count: usize, costs: &[i64]) -> Vec<u32> {
    let cost = |a: u32, b: u32| costs[a as usize * count + b as usize].cast_unsigned();
    cheapest_pairs(u32::try_from(count).unwrap(), cost)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn pairs_cost_as_little_as_another_solver_finds((count, mut costs) in any_costs()) {
        for a in 0..count {
            for b in 0..a {
                costs[a * count + b] = costs[b * count + a];
            }
        }
        let sum = |mates: &[usize]| -> i64 { mates.iter().enumerate().map(|(a, &b)| costs[a * count + b]).sum() };
        let mates: Vec<usize> = pairs(count, &costs).into_iter().map(|mate| mate as usize).collect();
        for (a, &b) in mates.iter().enumerate() {
            prop_assert!(a != b && mates[b] == a, "{:?}", mates);
        }
        let other = integer_blossom::min_weight_perfect_matching(&costs, count);
        prop_assert_eq!(sum(&mates), sum(&other));
    }
}

/// Its dual falls below zero: it is near one that has a partner already, and far from all others.
#[test]
fn a_dual_may_be_negative() {
    let at = |a: usize, b: usize| match (a.min(b), a.max(b)) {
        (0, 1..=3) => 0,
        (2, 3) => 600,
        _ => 1000,
    };
    let costs: Vec<i64> = (0..16).map(|k| at(k / 4, k % 4)).collect();
    let mates = pairs(4, &costs);
    assert_eq!(mates, [1, 0, 3, 2], "the others cost 1000, not 600");
}

#[test]
fn what_has_no_partner_is_its_own() {
    assert_eq!(pairs(0, &[]), Vec::<u32>::new());
    assert_eq!(pairs(1, &[0]), [0]);
}
