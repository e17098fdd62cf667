use proptest::prelude::*;

use super::*;
use crate::checks::tests::only;
use crate::checks::{Code, check_design};
use crate::testing::{chain, mm, wireframe};
use crate::wireframe::Wireframe;

/// What the checks of a design say of wire 3 mm thick.
fn said(w: &Wireframe) -> Vec<Diagnostic> {
    let components = w.components();
    check_design(&Design {
        wireframe: w,
        components: &components,
        weld_tolerance: mm(1e-3),
        diameter: mm(3.0),
    })
}

fn meetings(w: &Wireframe) -> Vec<Diagnostic> {
    said(w).into_iter().filter(|diagnostic| diagnostic.code() == Code::EdgesMeet).collect()
}

/// A wire whose last straight part passes its first at a height, 50 mm from both ends of the first.
fn passing(height: f64) -> Wireframe {
    chain(&[[0., 0., 0.], [100., 0., 0.], [100., 60., 0.], [50., 60., height], [50., -40., height]])
}

#[test]
fn a_wire_drawn_through_itself_is_an_error_with_its_place() {
    let found = said(&passing(0.0));
    let meeting = only(&found, Code::EdgesMeet);
    assert!(meeting.is_error());
    assert_eq!(meeting.remedies, [Remedy::JoinEdges, Remedy::MoveApart]);
    let Fact::EdgesMeet { edges, near, from, along, distance, .. } = meeting.fact else { panic!() };
    assert_eq!((edges, near), ([EdgeId(0), EdgeId(3)], [None, None]));
    assert_eq!(from, [VertexId(0), VertexId(3)]);
    assert!((along[0].mm() - 50.0).abs() < 1e-9 && (along[1].mm() - 60.0).abs() < 1e-9, "{along:?}");
    assert!(distance.mm() < 1e-9);
}

/// Up to half the diameter the middle of one wire is inside of the other; from the diameter on they are apart.
#[test]
fn how_bad_it_is_depends_on_the_distance() {
    for (height, severity) in [
        (1.4, Some(Severity::Error)),
        (1.6, Some(Severity::Warning)),
        (2.9, Some(Severity::Warning)),
        (3.1, None),
    ] {
        let found = meetings(&passing(height));
        assert_eq!(found.first().map(|meeting| meeting.severity), severity, "{height} mm");
        let near = found.first().map(|meeting| meeting.remedies[0].clone());
        assert_eq!(near == Some(Remedy::FastenThere), severity == Some(Severity::Warning), "{height} mm");
    }
}

#[test]
fn a_crossing_with_a_vertex_is_a_joint() {
    let joined = wireframe(
        &[[0.; 3], [50., 0., 0.], [100., 0., 0.], [100., 60., 0.], [50., 60., 0.], [50., -40., 0.]],
        &[(0, 1), (1, 2), (2, 3), (3, 4), (4, 1), (1, 5)],
    );
    assert_eq!(said(&joined), []);
}

/// All edges of a vertex are close to what it lies on: that is one thing to fix, not one for each.
#[test]
fn a_vertex_on_an_edge_is_said_once() {
    let points = [[0.; 3], [100., 0., 0.], [50., 0.2, 0.], [20., 60., 0.], [80., 60., 0.], [50., 60., 40.]];
    let several = wireframe(&points, &[(0, 1), (2, 3), (2, 4), (2, 5)]);
    let found = said(&several);
    let meeting = only(&found, Code::EdgesMeet);
    assert!(meeting.is_error() && meeting.remedies[0] == Remedy::JoinEdges, "{meeting:?}");
    assert_eq!(meeting.location.vertices, [VertexId(2)]);
    // The free end of a wire can be cut shorter or welded on.
    let end = wireframe(&points, &[(0, 1), (2, 3)]);
    let found = said(&end);
    assert_eq!(only(&found, Code::EdgesMeet).severity, Severity::Warning);
}

#[test]
fn vertices_that_nearly_meet_are_said_once_and_can_be_merged() {
    let apart = |by: f64| {
        wireframe(
            &[[0.; 3], [50., 0., 0.], [50., 60., 0.], [50. + by, 0., 0.], [120., 0., 0.], [80., -60., 0.]],
            &[(0, 1), (1, 2), (3, 4), (3, 5)],
        )
    };
    let found = said(&apart(0.4));
    let meeting = only(&found, Code::EdgesMeet);
    assert_eq!(
        (meeting.severity, &meeting.location.vertices[..]),
        (Severity::Warning, &[VertexId(1), VertexId(3)][..])
    );
    assert!(meeting.remedies.contains(&Remedy::MergeVertices));
    assert_eq!(meetings(&apart(3.2)), []);
    // Within the weld tolerance another check has them merged, also where whole edges lie on each other.
    let twice = wireframe(
        &[[0.; 3], [80., 0., 0.], [80., 80., 0.], [0., 0., 5e-4], [80., 5e-4, 0.], [0., 80., 0.]],
        &[(0, 1), (1, 2), (3, 4), (3, 5)],
    );
    assert_eq!(meetings(&twice), []);
    let found = said(&apart(5e-4));
    only(&found, Code::CoincidentVertices);
    assert!(found.iter().all(|diagnostic| diagnostic.code() != Code::EdgesMeet), "{found:#?}");
}

/// Points on a circle, from one angle to another, degrees.
fn arc(radius: f64, from: u32, to: u32, z: impl Fn(f64) -> f64) -> Vec<[f64; 3]> {
    let points = (from..=to).map(f64::from);
    points.map(|at| [radius * at.to_radians().cos(), radius * at.to_radians().sin(), z(at)]).collect()
}

/// Every edge is a sixth of a millimetre long, so that dozens are within the diameter of each.
#[test]
fn a_curve_of_short_edges_does_not_meet_itself_along_the_curve() {
    assert_eq!(meetings(&chain(&arc(10.0, 0, 300, |_| 0.0))), []);
    // A spring with a pitch of 5 mm, and one with a pitch of 2 mm, whose turns lie on each other.
    assert_eq!(meetings(&chain(&arc(10.0, 0, 700, |at| at / 72.0))), []);
    let tight = meetings(&chain(&arc(10.0, 0, 700, |at| at / 180.0)));
    assert!(!tight.is_empty() && tight.iter().all(|meeting| !meeting.is_error()), "{tight:?}");
    // The same curve once around and through itself.
    let mut through = arc(10.0, 0, 300, |_| 0.0);
    through.extend([[12.0, 0.5, 0.0], [-30.0, 0.5, 0.0]]);
    assert!(meetings(&chain(&through)).iter().any(Diagnostic::is_error));
}

/// What other checks are for: sharp corners, folds, edges drawn twice, edges without length.
#[test]
fn corners_and_doubled_edges_are_left_to_their_checks() {
    for bend in [90.0_f64, 155.0, 179.0, 180.0] {
        let way = bend.to_radians();
        let corner = chain(&[[0.; 3], [80., 0., 0.], [80. + 80. * way.cos(), 80. * way.sin(), 0.]]);
        assert_eq!(meetings(&corner), [], "{bend} degrees");
        // With a chamfer of half a millimetre, as far as it is no fold.
        let turned = [80.5 + 80. * way.cos(), 80. * way.sin(), 0.];
        let chamfered = chain(&[[0.; 3], [80., 0., 0.], [80.5, 0.0, 0.], turned]);
        assert!(bend > 150.0 || meetings(&chamfered).is_empty(), "{bend} degrees");
    }
    let twice = wireframe(&[[0.; 3], [80., 0., 0.]], &[(0, 1), (1, 0)]);
    assert_eq!(meetings(&twice), []);
    let point = chain(&[[0.; 3], [80., 0., 0.], [80., 0., 0.], [80., 80., 0.]]);
    assert_eq!(meetings(&point), []);
    assert_eq!(meetings(&Wireframe::new()), []);
}

/// A narrow U of which the legs lie in each other, though a short edge joins them.
#[test]
fn legs_that_lie_along_each_other_meet_however_they_are_joined() {
    let narrow = chain(&[[60., 0., 0.], [0., 0., 0.], [0., 1., 0.], [60., 1., 0.]]);
    assert!(meetings(&narrow)[0].is_error());
    // Side by side from end to end, and nothing joins them.
    let beside = wireframe(&[[0.; 3], [80., 0., 0.], [0., 1., 0.], [80., 1., 0.]], &[(0, 1), (2, 3)]);
    assert!(only(&said(&beside), Code::EdgesMeet).is_error());
    // So they do where they are not quite parallel; it says how close they come.
    let tapered = wireframe(&[[0.; 3], [80., 0., 0.], [0., 1., 0.], [80., 1.1, 0.]], &[(0, 1), (2, 3)]);
    let found = said(&tapered);
    let meeting = only(&found, Code::EdgesMeet);
    let Fact::EdgesMeet { near, distance, .. } = meeting.fact else { panic!() };
    assert!(meeting.is_error() && near == [None, None] && (distance.mm() - 1.0).abs() < 1e-9, "{meeting:?}");
    let wide = chain(&[[60., 0., 0.], [0., 0., 0.], [0., 3.1, 0.], [60., 3.1, 0.]]);
    assert_eq!(meetings(&wide), []);
    // Two edges of one vertex, where a third one lets the wire pass without a fold: the shorter one lies in the other, or
    // comes out of it.
    let beside = |y: f64| {
        let points = [[0.; 3], [80., 0., 0.], [60., y, 0.], [0., 60., 0.], [60., 60., 0.]];
        meetings(&wireframe(&points, &[(0, 1), (0, 2), (0, 3), (2, 4)]))
    };
    let inside = beside(1.0);
    assert_eq!((inside.len(), &inside[0].location.vertices[..]), (1, &[VertexId(2)][..]));
    assert!(inside[0].is_error());
    assert_eq!(beside(4.0), []);
}

/// The middle of the part where both lie along each other is farther from the crossing than their diameter.
#[test]
fn edges_that_cross_at_a_small_angle_meet_where_they_cross() {
    let crossing = wireframe(&[[0.; 3], [100., 0., 0.], [20., -2., 0.8], [100., 4., 0.8]], &[(0, 1), (2, 3)]);
    let found = said(&crossing);
    let meeting = only(&found, Code::EdgesMeet);
    let Fact::EdgesMeet { distance, along, .. } = meeting.fact else { panic!() };
    assert!(
        (distance.mm() - 0.8).abs() < 1e-9 && (along[0].mm() - 140.0 / 3.0).abs() < 1e-9,
        "{distance:?} {along:?}"
    );
    assert!(meeting.is_error());
}

/// Where a person with a ruler would find two edges too close.
struct Measured {
    least: f64,
    /// The exact distance is less by this at most.
    step: f64,
}

const SAMPLES: u32 = 60;

/// The least distance of points of two edges, each shortened by half of what the walks between their ends fall short of
/// four diameters; none where nothing is left.
fn measured(ends: [[[f64; 3]; 2]; 2], walks: [[f64; 2]; 2], diameter: f64) -> Option<Measured> {
    let short = |walk: f64| ((4.0 * diameter - walk) / 2.0).max(0.0);
    let cut_of = |side: usize, end: usize| {
        let of_one = [0, 1].map(|other| if side == 0 { walks[end][other] } else { walks[other][end] });
        short(of_one[0].min(of_one[1]))
    };
    let points = |side: usize| {
        let [from, to] = ends[side].map(nalgebra::Point3::from);
        let length = (to - from).norm();
        let (low, high) = (cut_of(side, 0), length - cut_of(side, 1));
        let at = move |k: u32| {
            from + (to - from) * ((low + (high - low) * f64::from(k) / f64::from(SAMPLES)) / length)
        };
        (low <= high).then(|| ((0..=SAMPLES).map(at).collect::<Vec<_>>(), high - low))
    };
    let ((one, first), (other, second)) = (points(0)?, points(1)?);
    let pairs = one.iter().flat_map(|p| other.iter().map(move |q| (p - q).norm()));
    let least = pairs.fold(f64::INFINITY, f64::min);
    Some(Measured { least, step: (first + second) / f64::from(SAMPLES) / 2.0 })
}

proptest! {
    /// Against every pair, point by point, with the walks between all vertices.
    #[test]
    fn every_close_pair_is_found_and_no_other(
        points in prop::collection::vec(prop::array::uniform3(-12.0..12.0_f64), 12),
        drawn in prop::collection::btree_set((0..12_usize, 0..12_usize), 1..16),
        diameter in 0.5..4.0_f64,
    ) {
        let drawn: Vec<(usize, usize)> = drawn.into_iter().filter(|(a, b)| a < b).collect();
        let w = wireframe(&points, &drawn);
        let length = |(a, b): (usize, usize)| (nalgebra::Point3::from(points[a]) - nalgebra::Point3::from(points[b])).norm();
        let mut walks = [[f64::INFINITY; 12]; 12];
        for (vertex, row) in walks.iter_mut().enumerate() {
            row[vertex] = 0.0;
        }
        for &(a, b) in &drawn {
            walks[a][b] = length((a, b));
            walks[b][a] = walks[a][b];
        }
        for (via, from, to) in (0..12).flat_map(|via| (0..144).map(move |k| (via, k / 12, k % 12))) {
            walks[from][to] = walks[from][to].min(walks[from][via] + walks[via][to]);
        }
        let found = close::Layout::of(&w, mm(1e-3)).close(diameter);
        for (one, &(a, b)) in drawn.iter().enumerate() {
            for (other, &(c, d)) in drawn.iter().enumerate().skip(one + 1) {
                if [a, b].contains(&c) || [a, b].contains(&d) {
                    continue;
                }
                let close = found.iter().find(|close| close.edges == [one, other]);
                let between = [[walks[a][c], walks[a][d]], [walks[b][c], walks[b][d]]];
                let wanted = measured([[points[a], points[b]], [points[c], points[d]]], between, diameter);
                prop_assert_eq!(close.is_some() && wanted.is_none(), false, "joined: {:?}", close);
                let Some(wanted) = wanted else { continue };
                match close {
                    Some(close) => {
                        prop_assert!(close.distance < diameter && close.distance <= wanted.least + 1e-9);
                        prop_assert!(wanted.least <= close.distance + wanted.step + 1e-9);
                    }
                    None => prop_assert!(wanted.least >= diameter - 1e-9, "{one} and {other}: {}", wanted.least),
                }
            }
        }
    }
}
