//! Splines of DXF drawings, against their definition.

use std::f64::consts::FRAC_1_SQRT_2;

use super::drawn::{assert_on, chain, edges, points, with_tolerance};
use nalgebra::{Point3, Vector3};
use wirebend_files::read::Imported;

use super::dxf::{drawing, of};
use super::{import, notes};

/// The definition by Cox and de Boor.
fn basis(knots: &[f64], k: usize, degree: usize, t: f64) -> f64 {
    if degree == 0 {
        return f64::from(u8::from(knots[k] <= t && t < knots[k + 1]));
    }
    let part = |up: f64, over: f64, of: usize| {
        if over > 0.0 { up / over * basis(knots, of, degree - 1, t) } else { 0.0 }
    };
    part(t - knots[k], knots[k + degree] - knots[k], k)
        + part(knots[k + degree + 1] - t, knots[k + degree + 1] - knots[k + 1], k + 1)
}

#[test]
fn a_spline_is_within_the_tolerance_of_its_definition() {
    // Cubic, knots uneven and not clamped, weights uneven.
    let knots = [0.0, 1.0, 2.0, 4.0, 5.0, 5.0, 7.0, 8.0, 9.0, 12.0];
    let control =
        [[0., 0., 0.], [10., 20., 5.], [30., -20., 0.], [40., 10., 9.], [60., 0., 0.], [70., 30., 1.]];
    let weights = [1.0, 2.0, 0.5, 1.0, 3.0, 1.0];
    let list = |code: u8, values: &[f64]| values.iter().map(|v| format!(" {code} {v}")).collect::<String>();
    let placed: String = control.iter().map(|[x, y, z]| format!(" 10 {x} 20 {y} 30 {z}")).collect();
    let text = format!("0 SPLINE 70 4 71 3{}{}{placed}", list(40, &knots), list(41, &weights));
    let imported = with_tolerance("a.dxf", &drawing(&text), 0.02);
    let path = points(&imported);
    for step in 0..400 {
        let t = 4.0 + (7.0 - 4.0) * f64::from(step) / 400.0;
        let shares: Vec<f64> = (0..6).map(|k| basis(&knots, k, 3, t) * weights[k]).collect();
        let sum: Vector3<f64> = (0..6).map(|k| Vector3::from(control[k]) * shares[k]).sum();
        let at = Point3::from(sum / shares.iter().sum::<f64>());
        let near = path.windows(2).map(|pair| {
            let along = pair[1] - pair[0];
            let share = ((at - pair[0]).dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
            (at - (pair[0] + along * share)).norm()
        });
        let near = near.fold(f64::INFINITY, f64::min);
        assert!(near < 0.02 + 1e-9, "{near} mm off at {t}");
    }
    // A quarter circle of radius 10 as a rational curve.
    let text = format!(
        "0 SPLINE 70 4 71 2 40 0 40 0 40 0 40 1 40 1 40 1 41 1 41 {FRAC_1_SQRT_2} 41 1 10 10 20 0 10 10 20 10 10 0 20 10"
    );
    assert_on(&of(&text), 0.1, |point| point.coords.norm() - 10.0);
}

fn fitted(flags: u8, points: &[[f64; 3]], more: &str, tolerance: f64) -> Imported {
    let placed: String = points.iter().map(|[x, y, z]| format!("11 {x} 21 {y} 31 {z} ")).collect();
    with_tolerance(
        "a.dxf",
        &drawing(&format!("0 SPLINE 70 {flags} 71 3 74 {} {more} {placed}", points.len())),
        tolerance,
    )
}

fn distance(path: &[Point3<f64>], at: &Point3<f64>) -> f64 {
    let near = path.windows(2).map(|pair| {
        let along = pair[1] - pair[0];
        let share = ((at - pair[0]).dot(&along) / along.norm_squared()).clamp(0.0, 1.0);
        (at - (pair[0] + along * share)).norm()
    });
    near.fold(f64::INFINITY, f64::min)
}

#[test]
fn a_spline_of_fit_points_runs_smoothly_through_them() {
    let line = fitted(8, &[[0., 0., 0.], [3., 4., 0.], [6., 8., 0.], [15., 20., 0.]], "", 0.01);
    assert_eq!(
        edges(&line),
        chain(&[[0.; 3], [3., 4., 0.], [6., 8., 0.], [15., 20., 0.]]),
        "on a line nothing bends"
    );
    let expected = [
        "1 spline without control points: a cubic one is laid through its fit points",
        "1 curve made straight edges within the tolerance",
    ];
    assert_eq!(notes(&line.notes), expected);

    // Natural, by hand: three points with both chords 5 long. Slopes m0, m1, m2: 2 m0 + m1 = 3 c0/5, and m0 + 4 m1 + m2
    // = 3 (c0 + c1)/5, and m1 + 2 m2 = 3 c1/5, with chords c0 = (3, 4), c1 = (3, -4). In y the sum of the outer two is
    // 2 (m0 + m2) + 2 m1 = 0, so m1 = 0 and m0 = 1.2, m2 = -1.2; in x all are 0.6.
    // At the middle of the first piece: (P0 + P1)/2 + 5 (m0 - m1)/8 = (1.5, 2 + 0.75).
    let arch = fitted(8, &[[0., 0., 0.], [3., 4., 0.], [6., 0., 0.]], "", 0.001);
    let path = points(&arch);
    for at in [[0., 0.], [1.5, 2.75], [3., 4.], [4.5, 2.75], [6., 0.]] {
        let off = distance(&path, &Point3::new(at[0], at[1], 0.0));
        assert!(off < 0.0011, "{off} mm from {at:?}");
    }
    // With ends that go up and down, of any length: m0 = (0, 1), m2 = (0, -1), so m1 = ((3·6/5)/4, 0) = (0.9, 0), and the
    // middle of the first piece is at (1.5 + 5 (0 - 0.9)/8, 2 + 5 (1 - 0)/8).
    let arch =
        fitted(8, &[[0., 0., 0.], [3., 4., 0.], [6., 0., 0.]], "12 0 22 7 32 0 13 0 23 -0.1 33 0", 0.001);
    let off = distance(&points(&arch), &Point3::new(0.9375, 2.625, 0.0));
    assert!(off < 0.0011, "{off}");
    // Doubled points and a single one.
    let same = fitted(8, &[[0., 0., 0.], [0., 0., 0.], [3., 4., 0.], [6., 0., 0.]], "", 0.001);
    assert_eq!(points(&same).len(), path.len());
    assert!(import("a.dxf", drawing("0 SPLINE 70 8 71 3 74 1 11 0 21 0 31 0")).is_err());
}

/// Points on a circle of 10: a closed cubic through 24 of them is within 10·(15°)⁴/384 = 0.0001 mm of it, and through
/// 8 within a hundred times as much (81-fold by the fourth power).
#[test]
fn a_closed_spline_of_fit_points_has_no_corner() {
    for (count, within) in [(24_u32, 0.0002), (8, 0.015)] {
        let on = |k: u32| (f64::from(k) * std::f64::consts::TAU / f64::from(count)).sin_cos();
        let mut circle: Vec<[f64; 3]> = (0..count).map(|k| [10.0 * on(k).1, 10.0 * on(k).0, 2.0]).collect();
        let open = circle.clone();
        circle.push(circle[0]);
        for points_given in [open, circle] {
            let imported = fitted(9, &points_given, "", 0.001);
            assert_eq!(imported.wireframe.vertex_count(), imported.wireframe.edge_count(), "it is closed");
            for point in points(&imported) {
                let off = point.x.hypot(point.y) - 10.0;
                assert!(off.abs() < within, "{count}: {off}");
            }
        }
    }
}
