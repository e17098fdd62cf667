//! Curves as straight edges, against their equations.

use super::*;
use proptest::prelude::*;

fn mm(value: f64) -> Length {
    Length::from_mm(value).unwrap()
}

fn deg(value: f64) -> Angle {
    Angle::from_deg(value).unwrap()
}

fn any_point() -> impl Strategy<Value = Point3<f64>> {
    prop::array::uniform3(-50.0..50.0_f64).prop_map(Point3::from)
}

fn distance_to_polyline(point: &Point3<f64>, line: &[Point3<f64>]) -> f64 {
    let near = line.windows(2).map(|pair| distance_to_segment(point, &pair[0], &pair[1]));
    near.fold(f64::INFINITY, f64::min)
}

/// The definition by Cox and de Boor, one basis function at a time.
fn basis(knots: &[f64], k: usize, degree: usize, t: f64) -> f64 {
    if degree == 0 {
        return if knots[k] <= t && t < knots[k + 1] { 1.0 } else { 0.0 };
    }
    let part = |up: f64, over: f64, of: usize| {
        if over > 0.0 { up / over * basis(knots, of, degree - 1, t) } else { 0.0 }
    };
    part(t - knots[k], knots[k + degree] - knots[k], k)
        + part(knots[k + degree + 1] - t, knots[k + degree + 1] - knots[k + 1], k + 1)
}

#[test]
fn a_tolerance_larger_than_the_circle_leaves_a_square() {
    let circle = EllipticArc {
        centre: Point3::new(1.0, 2.0, 3.0),
        u: Vector3::x(),
        v: Vector3::y(),
        start: Angle::ZERO,
        sweep: deg(-360.0),
    };
    let points = circle.flatten(mm(9.0));
    assert_eq!(points.len(), 5);
    assert!((points[1] - Point3::new(1.0, 1.0, 3.0)).norm() < 1e-12, "backwards: {}", points[1]);
}

#[test]
fn what_is_no_spline_is_refused() {
    let point = |x: f64| Point3::new(x, 0.0, 0.0);
    let line = vec![point(0.0), point(1.0)];
    let new = |degree, knots: &[f64], weights: &[f64]| {
        Spline::new(degree, knots.to_vec(), line.clone(), weights.to_vec()).map(|_| ())
    };
    assert_eq!(new(1, &[0., 0., 1., 1.], &[]), Ok(()));
    assert_eq!(new(0, &[0., 0., 1.], &[]), Err(SplineError::Degree { degree: 0, points: 2 }));
    assert_eq!(new(2, &[0., 0., 1., 1.], &[]), Err(SplineError::Degree { degree: 2, points: 2 }));
    assert_eq!(new(1, &[0., 1., 1.], &[]), Err(SplineError::KnotCount { knots: 3, expected: 4 }));
    assert_eq!(new(1, &[0., 1., 0., 1.], &[]), Err(SplineError::Knot { knot: 2 }));
    assert_eq!(new(1, &[0., f64::NAN, 1., 1.], &[]), Err(SplineError::Knot { knot: 1 }));
    assert_eq!(new(1, &[0., 1., 1., 2.], &[]), Err(SplineError::Knot { knot: 1 }));
    assert_eq!(new(1, &[0., 0., 1., 1.], &[1.0]), Err(SplineError::Weights));
    assert_eq!(new(1, &[0., 0., 1., 1.], &[1.0, 0.0]), Err(SplineError::Weights));
    assert_eq!(
        Spline::bezier(vec![point(0.0)]),
        Err(SplineError::Degree { degree: 0, points: 1 }),
        "a point is no curve"
    );
}

#[test]
fn a_quarter_circle_of_weights_is_one() {
    // Middle weight cos 45°: the conic of Piegl and Tiller.
    let control =
        vec![Point3::new(10.0, 0.0, 0.0), Point3::new(10.0, 10.0, 0.0), Point3::new(0.0, 10.0, 0.0)];
    let weights = vec![1.0, 0.5_f64.sqrt(), 1.0];
    let spline = Spline::new(2, vec![0., 0., 0., 1., 1., 1.], control, weights).unwrap();
    let points = spline.flatten(mm(0.01), 10_000).unwrap();
    assert!(points.len() > 9);
    for point in &points {
        assert!((point.coords.norm() - 10.0).abs() < 1e-12, "{point}");
    }
    for pair in points.windows(2) {
        assert!(nalgebra::center(&pair[0], &pair[1]).coords.norm() > 10.0 - 0.01);
    }
    // Whoever has less room hears so before it is used up.
    let max_points = points.len() - 1;
    assert_eq!(spline.flatten(mm(0.01), max_points), Err(SplineError::TooManyPoints { max_points }));
}

proptest! {
    #[test]
    fn an_arc_stays_within_the_tolerance(
        (centre, u, v) in (any_point(), any_point(), any_point()),
        (start, sweep) in (-400.0..400.0_f64, -360.0..360.0_f64),
        tolerance in 0.01..5.0_f64,
    ) {
        let arc = EllipticArc { centre, u: u.coords, v: v.coords, start: deg(start), sweep: deg(sweep) };
        let points = arc.flatten(mm(tolerance));
        prop_assert!((points[0] - arc.point(deg(start))).norm() < 1e-9);
        prop_assert!((points[points.len() - 1] - arc.point(deg(start + sweep))).norm() < 1e-9);
        for k in 0..=500 {
            let point = arc.point(deg(start + sweep * f64::from(k) / 500.0));
            prop_assert!(distance_to_polyline(&point, &points) <= tolerance + 1e-9);
        }
    }

    #[test]
    fn a_spline_is_what_its_definition_says(
        degree in 1_usize..6,
        control in prop::collection::vec((any_point(), 0.2..4.0_f64), 6..12),
        steps in prop::collection::vec(prop_oneof![Just(0.0), 0.1..3.0_f64], 18),
        tolerance in 0.01..1.0_f64,
    ) {
        let (control, weights): (Vec<Point3<f64>>, Vec<f64>) = control.into_iter().unzip();
        let knots: Vec<f64> = steps
            .iter()
            .scan(0.0, |sum, step| { *sum += step; Some(*sum) })
            .take(control.len() + degree + 1)
            .collect();
        let Ok(spline) = Spline::new(degree, knots.clone(), control.clone(), weights.clone()) else { return Ok(()) };
        let points = spline.flatten(mm(tolerance), 1_000_000).unwrap();
        let (from, to) = (knots[degree], knots[control.len()]);
        for k in 0..200 {
            let t = from + (to - from) * f64::from(k) / 200.0;
            let (mut sum, mut weight) = (Vector3::zeros(), 0.0);
            for (n, point) in control.iter().enumerate() {
                let share = basis(&knots, n, degree, t) * weights[n];
                sum += point.coords * share;
                weight += share;
            }
            let off = distance_to_polyline(&Point3::from(sum / weight), &points);
            prop_assert!(off <= tolerance + 1e-6, "{off} mm off at {t}");
        }
    }
}
