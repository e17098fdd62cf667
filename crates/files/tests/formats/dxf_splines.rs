//! Splines of DXF drawings, against their definition.

use std::f64::consts::FRAC_1_SQRT_2;

use super::drawn::{assert_on, chain, edges, points, with_tolerance};
use nalgebra::{Point3, Vector3};

use super::dxf::{drawing, of};
use super::notes;

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

#[test]
fn a_spline_of_fit_points_is_joined_and_says_so() {
    let imported = of("0 SPLINE 70 8 71 3 74 3 11 0 21 0 31 0 11 5 21 5 31 1 11 9 21 0 31 0");
    assert_eq!(edges(&imported), chain(&[[0.0; 3], [5.0, 5.0, 1.0], [9.0, 0.0, 0.0]]));
    let expected = ["1 spline without control points: its fit points are joined by straight edges"];
    assert_eq!(notes(&imported.notes), expected);
}
