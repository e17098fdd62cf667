//! Curves cut to what can be made, against samples that the cut has not seen.

use std::f64::consts::TAU;

use super::*;
use proptest::prelude::*;

use super::super::distance_to_segment;

fn mm(value: f64) -> Length {
    Length::from_mm(value).unwrap()
}

fn limit(shortest: f64) -> EdgeLimit {
    EdgeLimit { shortest: mm(shortest), bend_radius: Length::ZERO }
}

/// A part of a circle about the origin, as close points.
fn arc(radius: f64, from_deg: f64, sweep_deg: f64) -> Vec<Point3<f64>> {
    let at = |k: u32| (from_deg + sweep_deg * f64::from(k) / 360.0).to_radians();
    (0..=360).map(|k| Point3::new(radius * at(k).cos(), radius * at(k).sin(), 0.0)).collect()
}

fn edges(cut: &CurveCut, ring: bool) -> Vec<f64> {
    let mut line = cut.points.clone();
    line.extend(ring.then(|| cut.points[0]));
    line.windows(2).map(|pair| (pair[1] - pair[0]).norm()).collect()
}

fn distance(point: &Point3<f64>, line: &[Point3<f64>]) -> f64 {
    line.windows(2).map(|pair| distance_to_segment(point, &pair[0], &pair[1])).fold(f64::INFINITY, f64::min)
}

#[test]
fn a_circle_becomes_a_regular_polygon_half_inside_and_half_outside() {
    // Six edges of the circle's radius or more: with corners at R and edges at R·cos 30° it is equally far off both for
    // R = 2r/(1 + cos 30°).
    let cut = cut_curve(&arc(25.0, 0.0, 360.0), CurveEnds::Ring, mm(0.1), &limit(26.0), 0);
    assert_eq!(cut.points.len(), 6);
    let outer = 2.0 * 25.0 / (1.0 + 30_f64.to_radians().cos());
    for (point, edge) in cut.points.iter().zip(edges(&cut, true)) {
        assert!((point.coords.norm() - outer).abs() < 0.02, "{} is not {outer}", point.coords.norm());
        assert!((edge - outer).abs() < 0.02);
    }
    assert!((cut.deviation.mm() - (outer - 25.0)).abs() < 0.02);
    assert_eq!(cut.too_short, 0);
}

#[test]
fn a_circle_without_room_for_a_triangle_is_named() {
    let cut = cut_curve(&arc(3.0, 0.0, 360.0), CurveEnds::Ring, mm(0.1), &limit(20.0), 0);
    assert_eq!((cut.points.len(), cut.too_short), (3, 3));
    assert!(cut.deviation.mm() < 1.1, "a triangle is r/3 off: {}", cut.deviation.mm());
}

#[test]
fn a_large_circle_has_as_few_edges_as_the_tolerance_asks_for() {
    // Shared by both sides, an edge of 0.4 mm sagitta is 0.2 mm off: 2·acos(1 - 0.4/500) each.
    let cut = cut_curve(&arc(500.0, 0.0, 360.0), CurveEnds::Ring, mm(0.2), &limit(5.0), 0);
    let wanted = TAU / (2.0 * (1.0 - 0.4_f64 / 500.0).acos());
    assert!(cut.deviation <= mm(0.2));
    #[allow(clippy::cast_precision_loss)] // below a hundred
    let count = cut.points.len() as f64;
    assert!((wanted..1.1 * wanted).contains(&count), "{count} edges, not {wanted}");
}

#[test]
fn a_small_fillet_becomes_the_corner_of_its_lines() {
    // From (5, 0) along x onto the circle about (0, 0) and off it along -y: the lines meet at (5, 5).
    let curve: Vec<_> = arc(5.0, 0.0, 90.0);
    let ends = CurveEnds::Open([Some(Vector3::y()), Some(-Vector3::x())]);
    let cut = cut_curve(&curve, ends, mm(0.1), &limit(20.0), 0);
    assert_eq!(cut.points.len(), 1);
    assert!((cut.points[0] - Point3::new(5.0, 5.0, 0.0)).norm() < 1e-9);
    assert!((cut.deviation.mm() - 5.0 * (2_f64.sqrt() - 1.0)).abs() < 1e-3);
}

#[test]
fn the_ends_of_a_fillet_slide_along_its_lines() {
    // Of one edge between its ends the arc is 20·(1 - cos 45°) = 5.86 off.
    let ends = CurveEnds::Open([Some(Vector3::y()), Some(-Vector3::x())]);
    let cut = cut_curve(&arc(20.0, 0.0, 90.0), ends, mm(0.1), &limit(20.0), 0);
    let [first, last] = cut.points[..] else { panic!("{:?}", cut.points) };
    assert!((first.x - 20.0).abs() < 1e-9 && first.y > 0.0, "on its line: {first}");
    assert!((last.y - 20.0).abs() < 1e-9 && last.x > 0.0, "on its line: {last}");
    assert!((last - first).norm() >= 20.0);
    assert!(cut.deviation.mm() < 2.0, "{}", cut.deviation.mm());
}

#[test]
fn a_hairpin_does_not_become_a_spike() {
    // The lines of a turn of 178° meet 5·tan 89° = 286 mm away.
    let turn = 178_f64.to_radians();
    let ends = CurveEnds::Open([Some(Vector3::y()), Some(Vector3::new(-turn.sin(), turn.cos(), 0.0))]);
    let curve = arc(5.0, 0.0, 178.0);
    let cut = cut_curve(&curve, ends, mm(0.1), &limit(20.0), 0);
    for corner in &cut.points {
        assert!(distance(corner, &curve) <= 20.0, "{corner} is far off a curve of 5 mm");
    }
    assert!(cut.too_short > 0, "a turn of 15.5 mm has no room for an edge of 20 mm: {cut:?}");
}

#[test]
fn no_corner_is_farther_from_its_curve_than_an_edge_is_long() {
    // Lines at 110° to a circle of 60 mm meet 60·(1/cos 55° - 1) = 44.6 mm outside of it.
    let turn = 110_f64.to_radians();
    let ends = CurveEnds::Open([Some(Vector3::y()), Some(Vector3::new(-turn.sin(), turn.cos(), 0.0))]);
    let cut = cut_curve(&arc(60.0, 0.0, 110.0), ends, mm(0.1), &limit(40.0), 0);
    assert!(cut.points.len() > 1 && cut.too_short == 0, "{cut:?}");
    assert!(cut.deviation.mm() < 40.0, "{cut:?}");
}

#[test]
fn as_many_edges_are_made_as_are_asked_for() {
    let ends = CurveEnds::Open([None, None]);
    let shallow = arc(27.5, 63.0, 54.0);
    let one = cut_curve(&shallow, ends, mm(0.1), &limit(20.0), 0);
    assert_eq!((one.points.len(), one.too_short), (2, 0));
    let two = cut_curve(&shallow, ends, mm(0.1), &limit(20.0), 2);
    assert_eq!((two.points.len(), two.too_short), (3, 2), "{two:?}");
    assert_eq!((two.points[0], two.points[2]), (shallow[0], shallow[360]));
}

#[test]
fn sharp_corners_leave_room_for_their_arcs() {
    let limit = EdgeLimit { shortest: mm(20.0), bend_radius: mm(3.0) };
    assert!((limit.between(1.0, 1.5) - 20.0).abs() < 1e-12);
    // 120°: 3·(tan 60° - 1) more at each end.
    let each = 3.0 * (3_f64.sqrt() - 1.0);
    assert!((limit.between(TAU / 3.0, TAU / 3.0) - 20.0 - 2.0 * each).abs() < 1e-9);
}

#[test]
fn what_is_no_curve_is_given_back() {
    let ends = CurveEnds::Open([None, None]);
    assert_eq!(cut_curve(&[], ends, mm(1.0), &limit(5.0), 0).points, []);
    let one = [Point3::origin(); 3];
    assert_eq!(cut_curve(&one, ends, mm(1.0), &limit(5.0), 0).points, one);
}

/// The point of a Bézier spline.
fn on_spline(control: &[Point3<f64>], t: f64) -> Point3<f64> {
    let mut points = control.to_vec();
    while points.len() > 1 {
        points = points.windows(2).map(|pair| pair[0] + (pair[1] - pair[0]) * t).collect();
    }
    points[0]
}

/// Another edge becomes the nearest one between two samples, 0.05 mm farther off than at either.
#[test]
fn the_place_that_is_farthest_off_may_lie_between_samples() {
    let control = [
        Point3::new(-7.449_010_080_704_71, -10.436_134_260_267_12, 32.207_528_009_892_08),
        Point3::new(21.508_391_695_970_9, 36.790_080_841_454_91, 15.061_904_647_626_681),
        Point3::new(-1.739_886_124_029_823_1, -53.710_001_052_684_81, 22.413_199_826_508_8),
        Point3::new(-17.817_414_173_645_663, 12.928_766_765_019_967, 16.756_559_455_063_663),
    ];
    let at = |parts: u32| (0..=parts).map(move |k| on_spline(&control, f64::from(k) / f64::from(parts)));
    let curve: Vec<_> = at(400).collect();
    let limit = limit(22.633_292_041_298_382);
    let cut = cut_curve(&curve, CurveEnds::Open([None, None]), mm(0.02), &limit, 0);
    let off = at(20_000).map(|point| distance(&point, &cut.points)).fold(0.0, f64::max);
    assert!(off <= cut.deviation.mm() + 2e-2, "{off}, said {}", cut.deviation.mm());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]
    #[test]
    fn no_edge_is_too_short_and_no_point_farther_off_than_said(
        control in prop::collection::vec(prop::array::uniform3(-60.0..60.0_f64).prop_map(Point3::from), 4..5),
        shortest in 2.0..40.0_f64,
        tolerance in 0.02..2.0_f64,
    ) {
        let point = |t: f64| on_spline(&control, t);
        let curve: Vec<_> = (0..=400).map(|k| point(f64::from(k) / 400.0)).collect();
        let cut = cut_curve(&curve, CurveEnds::Open([None, None]), mm(tolerance), &limit(shortest), 0);
        prop_assert_eq!(cut.points[0], curve[0]);
        prop_assert_eq!(cut.points[cut.points.len() - 1], curve[400]);
        for k in 0..=333 {
            let off = distance(&point(f64::from(k) / 333.0), &cut.points);
            // A step of these curves is 2 mm at most, and its chord a hundredth off.
            prop_assert!(off <= cut.deviation.mm() + 2e-2, "{} off, said {}", off, cut.deviation.mm());
        }
        for corner in &cut.points {
            prop_assert!(distance(corner, &curve) <= cut.deviation.mm() + 1e-6);
        }
        let length: f64 = curve.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum();
        let short = edges(&cut, false).iter().filter(|&&edge| edge < shortest - 1e-6).count();
        prop_assert_eq!(short > 0, cut.too_short > 0);
        let reach = (curve[400] - curve[0]).norm();
        prop_assert!(short == 0 || reach < shortest || length < shortest, "{:?}", edges(&cut, false));
    }

    #[test]
    fn ends_slide_on_their_lines_and_leave_room_for_bends(
        (radius, sweep) in (3.0..80.0_f64, 20.0..178.0_f64),
        shortest in 5.0..40.0_f64,
        bend_radius in 0.0..6.0_f64,
    ) {
        let turn = sweep.to_radians();
        let lines = [Vector3::y(), Vector3::new(-turn.sin(), turn.cos(), 0.0)];
        let curve: Vec<_> = arc(radius, 0.0, sweep).into_iter().step_by(8).collect();
        let limit = EdgeLimit { shortest: mm(shortest), bend_radius: mm(bend_radius) };
        let cut = cut_curve(&curve, CurveEnds::Open(lines.map(Some)), mm(0.1), &limit, 0);
        let (first, last) = (cut.points[0], cut.points[cut.points.len() - 1]);
        // Onwards on the line that leads to the curve, and back on the one that leads away.
        for (end, from, way) in [(first, curve[0], lines[0]), (last, curve[45], -lines[1])] {
            let by = end - from;
            prop_assert!(by.cross(&way).norm() < 1e-6 * radius && by.dot(&way) > -1e-9, "{}", by);
        }
        // The lines, up to the curve, are no way off: they go on from its ends.
        let mut line = vec![curve[0]];
        line.extend_from_slice(&cut.points);
        line.push(curve[45]);
        for point in &curve {
            prop_assert!(distance(point, &line) <= cut.deviation.mm() + 1e-6);
        }
        for corner in &cut.points {
            prop_assert!(distance(corner, &curve) <= cut.deviation.mm() + 1e-6);
        }
        // Each edge beside its turns, reckoned anew.
        let ways: Vec<_> = [lines[0]]
            .into_iter()
            .chain(cut.points.windows(2).map(|pair| pair[1] - pair[0]))
            .chain([lines[1]])
            .collect();
        let lacks = |three: &[Vector3<f64>]| {
            let arc = |turn: f64| bend_radius * ((turn.min(3.0) / 2.0).tan() - 1.0).max(0.0);
            let needed = shortest + arc(three[0].angle(&three[1])) + arc(three[1].angle(&three[2]));
            three[1].norm() < needed - 1e-4
        };
        let short = ways.windows(3).filter(|three| lacks(three)).count();
        prop_assert_eq!(short, cut.too_short, "{:?}", cut);
    }

    #[test]
    fn a_ring_is_cut_like_an_open_curve(
        (a, b) in (5.0..80.0_f64, 5.0..80.0_f64),
        shortest in 5.0..30.0_f64,
    ) {
        let curve: Vec<_> = (0..=240)
            .map(|k| TAU * f64::from(k) / 240.0)
            .map(|t| Point3::new(a * t.cos(), b * t.sin(), 0.0))
            .collect();
        let cut = cut_curve(&curve, CurveEnds::Ring, mm(0.1), &limit(shortest), 0);
        let mut line = cut.points.clone();
        line.push(cut.points[0]);
        for point in &curve {
            prop_assert!(distance(point, &line) <= cut.deviation.mm() + 1e-6);
        }
        let short = edges(&cut, true).iter().filter(|&&edge| edge < shortest - 1e-6).count();
        prop_assert_eq!(short > 0, cut.too_short > 0);
        // A triangle of the least edges lies within a circle of 3·s/2 of circumference or more.
        prop_assert!(short == 0 || a.min(b) * TAU < 4.5 * shortest, "{:?}", edges(&cut, true));
    }
}
