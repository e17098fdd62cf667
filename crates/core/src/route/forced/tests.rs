use integer_blossom::min_weight_perfect_matching;
use nalgebra::Point3;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

use super::*;
use crate::route::doubling;
use crate::wireframe::Vertex;

/// So many graphs are tried.
const GRAPHS: usize = 300;

/// Points of a plane, each joined with those near it, so that many have their edges on one side.
fn any_wireframe() -> impl Strategy<Value = Wireframe> {
    prop::collection::vec(prop::array::uniform2(0.0..100.0_f64), 6..16).prop_map(|points| {
        let mut w = Wireframe::new();
        let at = |p: [f64; 2]| Point3::new(p[0], p[1], 0.0);
        let ids: Vec<VertexId> = points.iter().map(|&p| w.add_vertex(Vertex::at(at(p))).unwrap()).collect();
        for (k, &p) in points.iter().enumerate() {
            for (j, &q) in points[..k].iter().enumerate() {
                if (at(p) - at(q)).norm() < 45.0 {
                    w.add_edge(ids[j], ids[k]).unwrap();
                }
            }
        }
        w
    })
}

/// The least length in nm that is travelled once more so that all ends of all vertices can be paired within the limit, none
/// where they cannot. Whatever is added is a set of walks, each from one of the ends to another, at the same vertex or not: a
/// perfect matching of all ends at once.
fn least_together(pairing: &Pairing) -> Option<i64> {
    const NONE: i64 = 1 << 45;
    let mut detours = Detours::new(pairing);
    let ends: Vec<End> = (0..pairing.end_count()).collect();
    let count = ends.len();
    let mut costs = vec![NONE; count * count];
    for &p in &ends {
        let Some(from) = pairing.link_end(p) else {
            let here =
                ends.iter().filter(|&&q| !pairing.is_wire_end(q) && pairing.vertex(q) == pairing.vertex(p));
            here.for_each(|&q| (costs[p * count + q], costs[q * count + p]) = (0, 0));
            continue;
        };
        detours.search.begin();
        detours.go_on(from, 0, None);
        let mut arrived = vec![(0, from)];
        while let Some((length, leaving)) = detours.search.next() {
            arrived.push((length, leaving ^ 1));
            detours.go_on(leaving ^ 1, length, Some(leaving));
        }
        for &q in ends.iter().filter(|&&q| q != p) {
            let Some(to) = pairing.link_end(q) else { continue };
            let last = |&&(_, end): &&(i64, End)| {
                pairing.vertex(end) == pairing.vertex(to) && pairing.follows(end, to)
            };
            if let Some((length, _)) = arrived.iter().find(last) {
                costs[p * count + q] = *length;
            }
        }
    }
    let mates = min_weight_perfect_matching(&costs, count);
    let length: i64 = mates.iter().enumerate().map(|(p, &q)| costs[p * count + q]).sum();
    (length < NONE).then_some(length / 2)
}

/// One of these with detours around all of its forced bends, if there are any: what they and what the best together add.
fn added(w: &Wireframe) -> Option<(i64, i64)> {
    let component = w.components().into_iter().max_by_key(|part| part.edges.len())?;
    let options = RouteOptions {
        doubled: doubling(w, &component, None, false).ok()?.edges,
        max_bend: Some(Angle::from_deg(155.0).unwrap()),
        ..RouteOptions::default()
    };
    let network = Network::new(w, &component);
    let Layout { copies, wire_ends } = layout(&network, &component, &options).unwrap();
    let pairing = Pairing::new(&network, &copies, &wire_ends, options.max_bend);
    // A closed wire has its ends where one bend is left out, which is no matter of detours.
    let forced = if wire_ends.is_empty() { Vec::new() } else { forced(w, &pairing) };
    let detours: Vec<Doubling> = forced.into_iter().map(|bend| bend.detour).collect::<Option<_>>()?;
    let link = |edge: &EdgeId| network.links.iter().find(|link| link.id == *edge);
    let one_by_one = detours.iter().flat_map(|detour| &detour.edges).filter_map(link);
    Some((one_by_one.map(|link| link.length_nm).sum(), least_together(&pairing)?))
}

/// What a person pays for detours, in wire: no more than twice the least, as the comment says.
#[test]
fn detours_add_up_to_twice_the_least_that_does_together() {
    let mut runner = TestRunner::deterministic();
    let drawn = (0..GRAPHS).map(|_| any_wireframe().new_tree(&mut runner).unwrap().current());
    let added: Vec<(i64, i64)> =
        drawn.filter_map(|w| added(&w)).filter(|&(one_by_one, _)| one_by_one > 0).collect();
    assert!(added.iter().all(|(one_by_one, together)| one_by_one >= together), "{added:?}");
    let sum = |of: fn(&(i64, i64)) -> i64| added.iter().map(of).sum::<i64>();
    let (one_by_one, together) = (sum(|both| both.0), sum(|both| both.1));
    assert!(5 * added.len() > GRAPHS / 2 && 10 * one_by_one <= 22 * together, "{one_by_one} for {together}");
}
