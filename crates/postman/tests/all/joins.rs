//! Joins of graphs, against all joins that there are and against another solver.

use proptest::prelude::*;
use wirebend_postman::{Broken, Graph, GraphError, Join, NoJoin, cheapest_join, cheapest_joins, verify};

type Edges = Vec<(u32, u32, u64)>;

fn graph(vertices: usize, edges: &[(u32, u32, u64)]) -> Graph {
    Graph::new(vertices, edges).unwrap()
}

/// Distances between all vertices; none where no path leads.
fn distances(vertices: usize, edges: &[(u32, u32, u64)]) -> Vec<Vec<Option<u64>>> {
    let mut all = vec![vec![None; vertices]; vertices];
    for (v, row) in all.iter_mut().enumerate() {
        row[v] = Some(0);
    }
    for &(a, b, weight) in edges {
        for (a, b) in [(a as usize, b as usize), (b as usize, a as usize)] {
            all[a][b] = Some(all[a][b].map_or(weight, |known: u64| known.min(weight)));
        }
    }
    for via in 0..vertices {
        for a in 0..vertices {
            for b in 0..vertices {
                if let (Some(to), Some(from)) = (all[a][via], all[via][b]) {
                    all[a][b] = Some(all[a][b].map_or(to + from, |known| known.min(to + from)));
                }
            }
        }
    }
    all
}

/// What a pair without a path costs: more than all others together.
const NO_PATH: i64 = 1_000_000;

/// The least that pairs of the vertices cost, with so many left; another's solver, on all distances.
fn least(vertices: usize, edges: &[(u32, u32, u64)], odd: &[u32], left: usize) -> Option<u64> {
    let all = distances(vertices, edges);
    let count = odd.len() + left;
    let cost = |a: usize, b: usize| match (odd.get(a), odd.get(b)) {
        (Some(&a), Some(&b)) => all[a as usize][b as usize].map_or(NO_PATH, u64::cast_signed),
        (None, None) => NO_PATH,
        _ => 0,
    };
    let costs: Vec<i64> = (0..count * count).map(|at| cost(at / count, at % count)).collect();
    let mates = integer_blossom::min_weight_perfect_matching(&costs, count);
    let sum: i64 = mates.iter().enumerate().map(|(a, &b)| cost(a, b)).sum();
    (sum < NO_PATH).then_some(sum.cast_unsigned() / 2)
}

fn proved(graph: &Graph, odd: &[u32], left: usize) -> Join {
    let join = cheapest_join(graph, odd, left).unwrap();
    assert_eq!(join.left.len(), left);
    assert_eq!(verify(graph, odd, &join), Ok(()));
    join
}

/// A graph with a few parts, ties, loops and parallel edges.
fn any_graph() -> impl Strategy<Value = (usize, Edges)> {
    (2_usize..40).prop_flat_map(|vertices| {
        let end = 0..u32::try_from(vertices).unwrap();
        let weight = prop_oneof![Just(10_u64), 0..4_u64, 1..1000_u64];
        let edges = prop::collection::vec((end.clone(), end, weight), 1..3 * vertices);
        (Just(vertices), edges)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn a_join_costs_as_little_as_another_solver_finds((vertices, edges) in any_graph(), wires in 0_usize..4) {
        let graph = graph(vertices, &edges);
        let odd = graph.odd();
        let left = (2 * wires).min(odd.len());
        let join = cheapest_join(&graph, &odd, left).unwrap();
        prop_assert_eq!(join.left.len(), left);
        prop_assert_eq!(verify(&graph, &odd, &join), Ok(()));
        prop_assert_eq!(Some(join.weight), least(vertices, &edges, &odd, left));
    }

    #[test]
    fn any_vertices_can_be_joined(
        (vertices, edges) in any_graph(),
        chosen in prop::collection::vec(any::<bool>(), 40),
        left in 0_usize..4,
    ) {
        let graph = graph(vertices, &edges);
        let odd: Vec<u32> = (0..u32::try_from(vertices).unwrap()).filter(|&v| chosen[v as usize]).collect();
        match cheapest_join(&graph, &odd, left) {
            Ok(join) => {
                prop_assert_eq!(verify(&graph, &odd, &join), Ok(()));
                prop_assert_eq!(Some(join.weight), least(vertices, &edges, &odd, left));
            }
            Err(NoJoin::Apart(_)) => prop_assert_eq!(None, least(vertices, &edges, &odd, left)),
            Err(error) => prop_assert_eq!(error, NoJoin::Parity { left, odd: odd.len() }),
        }
    }
}

proptest! {
    /// Each further wire saves as much as it can, and none costs more than the one before has saved.
    #[test]
    fn the_cost_of_more_wires_falls_ever_more_slowly((vertices, edges) in any_graph(), wires in 0_usize..6) {
        let graph = graph(vertices, &edges);
        let odd = graph.odd();
        let joins = cheapest_joins(&graph, &odd, (2 * wires).min(odd.len())).unwrap();
        prop_assert_eq!(joins.len(), wires.min(odd.len() / 2) + 1);
        for (k, join) in joins.iter().enumerate() {
            prop_assert_eq!(join.left.len(), 2 * k);
            prop_assert_eq!(verify(&graph, &odd, join), Ok(()));
            prop_assert_eq!(Some(join.weight), least(vertices, &edges, &odd, 2 * k));
        }
        for three in joins.windows(3) {
            prop_assert!(three[0].weight - three[1].weight >= three[1].weight - three[2].weight);
        }
    }
}

/// A square lattice of equal edges: everything is a tie.
fn lattice(side: u32) -> (usize, Edges) {
    let mut edges = Vec::new();
    for row in 0..side {
        for column in 0..side {
            let at = row * side + column;
            if column + 1 < side {
                edges.push((at, at + 1, 1_000_000));
            }
            if row + 1 < side {
                edges.push((at, at + side, 1_000_000));
            }
        }
    }
    ((side * side) as usize, edges)
}

#[test]
fn a_lattice_of_equal_edges_is_joined_along_its_border() {
    for side in [3, 4, 5, 10, 41, 100] {
        let (vertices, edges) = lattice(side);
        let graph = graph(vertices, &edges);
        let odd = graph.odd();
        assert_eq!(odd.len(), 4 * (side as usize - 2));
        let closed = proved(&graph, &odd, 0);
        // Each of the border's vertices but the corners is paired with its neighbour; between an odd number of them and the next
        // there is a corner.
        let apart = if side % 2 == 1 { 4 } else { 0 };
        assert_eq!(closed.weight / 1_000_000, u64::from(2 * (side - 2)) + apart / 2);
        assert!(proved(&graph, &odd, 2).weight < closed.weight);
    }
}

#[test]
fn what_is_even_needs_nothing() {
    let ring: Edges = (0..5).map(|k| (k, (k + 1) % 5, 7)).collect();
    let graph = graph(5, &ring);
    assert_eq!(graph.odd(), Vec::<u32>::new());
    assert_eq!(proved(&graph, &[], 0).edges, Vec::<u32>::new());
}

#[test]
fn two_odd_vertices_are_left_or_joined_by_the_shortest_path() {
    let path: Edges = vec![(0, 1, 5), (1, 2, 5), (0, 2, 20)];
    let graph = graph(3, &path);
    assert_eq!(proved(&graph, &[0, 2], 0).edges, [0, 1]);
    assert_eq!(proved(&graph, &[0, 2], 2).edges, Vec::<u32>::new());
}

#[test]
fn what_cannot_be_joined_is_said() {
    let apart = graph(4, &[(0, 1, 1), (2, 3, 1)]);
    assert_eq!(cheapest_join(&apart, &[0, 2], 0), Err(NoJoin::Apart(0)));
    assert_eq!(cheapest_join(&apart, &[0, 1, 2], 0), Err(NoJoin::Parity { left: 0, odd: 3 }));
    assert_eq!(cheapest_join(&apart, &[0, 0], 0), Err(NoJoin::NoSet(0)));
    assert_eq!(cheapest_join(&apart, &[9, 0], 0), Err(NoJoin::NoSet(9)));
}

/// Edges without length make stand-ins each other's partners: as many are left all the same.
#[test]
fn as_many_are_left_as_were_asked_for() {
    let edges = [
        (2, 1, 10),
        (0, 2, 1),
        (2, 1, 0),
        (0, 3, 10),
        (0, 3, 10),
        (1, 2, 10),
        (1, 3, 10),
        (1, 2, 10),
        (1, 3, 10),
        (1, 3, 0),
    ];
    let graph = graph(4, &edges);
    assert_eq!(graph.odd(), [0, 1, 2, 3]);
    for left in [0, 2, 4] {
        assert_eq!(proved(&graph, &[0, 1, 2, 3], left).left.len(), left);
    }
}

#[test]
fn what_is_no_graph_is_refused() {
    let refused = |vertices, edges: &[_]| Graph::new(vertices, edges).unwrap_err();
    assert_eq!(refused(2, &[(0, 1, 1), (1, 2, 1)]), GraphError::NoVertex { edge: 1, vertex: 2, vertices: 2 });
    let half = 1 << 57;
    assert_eq!(refused(2, &[(0, 1, half), (0, 1, half)]), GraphError::TooHeavy { edge: 1 });
    assert_eq!(refused(2, &[(0, 1, u64::MAX), (0, 1, 1)]), GraphError::TooHeavy { edge: 0 });
    assert_eq!(refused(1 << 30, &[]), GraphError::TooMany(1 << 30));
    // As heavy as may be: nothing overflows.
    let heavy = graph(2, &[(0, 1, half)]);
    assert_eq!(proved(&heavy, &[0, 1], 0).weight, half);
}

/// A proof holds for one answer alone: whatever is changed in it, or in the answer, is found.
#[test]
fn a_broken_certificate_is_refused() {
    let (vertices, edges) = lattice(6);
    let graph = graph(vertices, &edges);
    let odd = graph.odd();
    for left in [0, 2] {
        let join = proved(&graph, &odd, left);
        let broken = |change: &dyn Fn(&mut Join)| {
            let mut join = join.clone();
            change(&mut join);
            verify(&graph, &odd, &join).unwrap_err()
        };
        assert!(matches!(broken(&|join| join.edges.truncate(join.edges.len() - 1)), Broken::NoJoin(_)));
        assert!(matches!(broken(&|join| join.certificate.widths[0] = -4), Broken::Negative(0)));
        assert!(matches!(broken(&|join| join.certificate.parents.truncate(3)), Broken::Shape));
        assert!(matches!(broken(&|join| join.edges[0] = 1000), Broken::Shape));
        assert!(matches!(broken(&|join| join.certificate.widths[0] = i64::MAX), Broken::Shape));
        assert!(matches!(broken(&|join| join.certificate.depths[0] = i64::MIN), Broken::Shape));
        assert!(matches!(broken(&|join| join.weight += 1), Broken::Weight { .. }));
        if left > 0 {
            assert!(matches!(broken(&|join| join.left[0] = join.left[1]), Broken::Left(_)));
            assert!(matches!(broken(&|join| join.left[0] = 0), Broken::Left(0)));
        }
        for set in 0..join.certificate.widths.len() {
            broken(&|join| join.certificate.widths[set] += 4);
            broken(&|join| join.certificate.widths[set] -= 4);
        }
        for vertex in 0..vertices {
            let moved =
                broken_or_equal(&graph, &odd, &join, |join| join.certificate.depths[vertex] += 4_000_000);
            assert!(moved || !odd.contains(&u32::try_from(vertex).unwrap()));
        }
        // A longer way round is a join too, and not the cheapest.
        let around = broken(&|join| {
            for edge in [0, 1, 6, 7] {
                match join.edges.iter().position(|&known| known == edge) {
                    Some(at) => drop(join.edges.remove(at)),
                    None => join.edges.push(edge),
                }
            }
        });
        assert!(matches!(around, Broken::NotTight { .. } | Broken::NoJoin(_)), "{around}");
    }
}

/// Whether a change is found.
fn broken_or_equal(graph: &Graph, odd: &[u32], join: &Join, change: impl Fn(&mut Join)) -> bool {
    let mut changed = join.clone();
    change(&mut changed);
    verify(graph, odd, &changed).is_err()
}
