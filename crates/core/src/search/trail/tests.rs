use proptest::prelude::*;

use super::*;
use crate::testing::wireframe;
use crate::wireframe::VertexId;

/// How many wires a multigraph needs at least, by trying every walk.
fn fewest(passes: &Passes, used: &mut Vec<bool>, here: Option<usize>) -> usize {
    if used.iter().all(|&used| used) {
        return 0;
    }
    let mut fewest_of_all = usize::MAX;
    for pass in 0..used.len() {
        if used[pass] {
            continue;
        }
        for end in passes.all[pass].ends {
            used[pass] = true;
            let begins = usize::from(here != Some(end));
            let rest = fewest(passes, used, Some(passes.all[pass].other(end)));
            used[pass] = false;
            fewest_of_all = fewest_of_all.min(begins + rest);
        }
    }
    fewest_of_all
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// Were it too low, the search would run into walks that cannot be ended; too high, it would leave out good ones.
    #[test]
    fn the_number_of_wires_that_are_needed_is_that_of_trying_everything(
        edges in prop::collection::vec((0_usize..5, 0_usize..5), 1..6),
        here in prop::option::of(0_usize..5),
    ) {
        let points: Vec<[f64; 3]> = (0..5_u32).map(|k| [f64::from(k), f64::from(k * k), 0.0]).collect();
        let edges: Vec<(usize, usize)> = edges.into_iter().filter(|(a, b)| a != b).collect();
        prop_assume!(!edges.is_empty());
        let mut frame = wireframe(&points, &[]);
        let ids: Vec<VertexId> = frame.vertices().map(|(id, _)| id).collect();
        for &(a, b) in &edges {
            frame.add_edge(ids[a], ids[b]).unwrap();
        }
        let component = Component { vertices: ids, edges: frame.edges().map(|(id, _)| id).collect() };
        let passes = Passes::new(&frame, &component, &[]);
        let mut used = vec![false; passes.all.len()];
        let needed = passes.wires_needed(&used, here);
        // A wire that continues counts, too: it began before.
        let tried = fewest(&passes, &mut used, here) + usize::from(here.is_some());
        prop_assert_eq!(needed, tried);
    }
}
