use proptest::prelude::*;

use super::*;
use crate::testing::{deg, mm};

/// 3 mm wire with 1.8716e-4 N/mm, as published.
fn wire() -> WireModel {
    WireModel { diameter: mm(3.0), density_kg_per_m3: 2700.0, youngs_modulus_gpa: 68.03, price_per_mm: None }
}

/// w, E I and G J of that wire, from the formulas of a handbook: N/mm and N mm².
fn figures() -> [f64; 3] {
    let area = std::f64::consts::PI * 1.5 * 1.5;
    let second_moment = std::f64::consts::PI * 1.5_f64.powi(4) / 4.0;
    let shear = 68.03e3 / (2.0 * 1.33);
    [2700.0e-9 * area * 9.80665, 68.03e3 * second_moment, shear * 2.0 * second_moment]
}

fn step(feed: f64, rotate: f64, bend: f64) -> Step {
    Step { feed: mm(feed), rotate: deg(rotate), bend: deg(bend) }
}

fn sag(steps: &[Step]) -> Sag {
    max_sag(Frame::default(), steps, &wire()).unwrap()
}

fn close(found: f64, wanted: f64) -> bool {
    (found - wanted).abs() <= 1e-9 * wanted.abs()
}

#[test]
fn a_straight_wire_sags_as_a_cantilever() {
    let [w, ei, _] = figures();
    for length in [1.0, 200.0, 500.0] {
        let found = sag(&[step(length, 0.0, 0.0)]);
        assert!(close(found.deflection.mm(), w * f64::powi(length, 4) / (8.0 * ei)), "{found:?}");
    }
    // In pieces it is the same wire.
    let pieces = sag(&[step(100.0, 0.0, 0.0), step(150.0, 30.0, 0.0), step(250.0, 0.0, 0.0)]);
    assert_eq!(pieces.step, 2);
    assert!(close(pieces.deflection.mm(), w * f64::powi(500.0, 4) / (8.0 * ei)));
}

/// A leg with an arm across at its end, in the plane of the table: the arm twists the leg.
#[test]
fn an_arm_to_the_side_twists_the_leg() {
    let [w, ei, gj] = figures();
    let (arm, leg) = (150.0_f64, 300.0_f64);
    let found = sag(&[step(arm, 0.0, 90.0), step(leg, 0.0, 0.0)]);
    let bent =
        w * leg.powi(4) / (8.0 * ei) + w * arm * leg.powi(3) / (3.0 * ei) + w * arm.powi(4) / (8.0 * ei);
    let twisted = (w * arm * arm / 2.0) * leg / gj * arm;
    assert_eq!(found.step, 1);
    assert!(close(found.deflection.mm(), bent + twisted), "{found:?} instead of {}", bent + twisted);
}

/// The same with the head turned, so that the arm stands upright or hangs: it only presses on the leg, and swings with its slope.
#[test]
fn an_upright_arm_twists_nothing() {
    let [w, ei, _] = figures();
    let (arm, leg) = (150.0_f64, 300.0_f64);
    let down = w * leg.powi(4) / (8.0 * ei) + w * arm * leg.powi(3) / (3.0 * ei);
    let slope = w * leg.powi(3) / (6.0 * ei) + w * arm * leg * leg / (2.0 * ei);
    for turn in [90.0, -90.0] {
        let found = sag(&[step(arm, turn, 90.0), step(leg, 0.0, 0.0)]);
        let wanted = down.hypot(arm * slope);
        assert!(close(found.deflection.mm(), wanted), "{found:?} instead of {wanted}");
    }
}

/// A wire of straight parts from the origin on, held at its end.
fn free_end(ways: &[Vector3<f64>], down: &Vector3<f64>) -> Vector3<f64> {
    let mut points = vec![Point3::new(7.0, -40.0, 12.0)];
    for way in ways {
        points.push(points[points.len() - 1] + way);
    }
    let hanging = HangingWire::new(points, &wire()).unwrap();
    hanging.displacement(0, &hanging.held_at(ways.len()), down)
}

#[test]
fn a_wire_that_hangs_straight_down_does_not_sag() {
    let ways = [Vector3::new(0.0, 0.0, 200.0), Vector3::new(0.0, 0.0, 300.0)];
    for down in [-Vector3::z(), Vector3::z()] {
        assert!(free_end(&ways, &down).norm() < 1e-12);
    }
    assert!(free_end(&ways, &Vector3::x()).norm() > 5.0);
}

/// A cantilever, by a handbook: w / (24 E I) · (x⁴ - 4 L³ x + 3 L⁴), x from the free end.
#[test]
fn every_point_of_a_straight_wire_moves_as_that_of_a_cantilever() {
    let [w, ei, _] = figures();
    let length = 500.0_f64;
    let points = (0..=5).map(|k| Point3::new(100.0 * f64::from(k), 3.0, -8.0)).collect();
    let hanging = HangingWire::new(points, &wire()).unwrap();
    for (k, held) in [(3, hanging.held_at(5)), (3, hanging.held_beyond(4, Vector3::x() * 100.0))] {
        for point in 0..=k {
            let x = hanging.points[point].x;
            let wanted = w / (24.0 * ei) * (x.powi(4) - 4.0 * length.powi(3) * x + 3.0 * length.powi(4));
            let found = hanging.displacement(point, &held, &-Vector3::z());
            assert!(
                (found + Vector3::z() * wanted).norm() < 1e-9 * wanted,
                "{found} instead of {wanted} at {x}"
            );
        }
    }
    assert!(hanging.displacement(5, &hanging.held_at(5), &-Vector3::z()).norm() < 1e-12);
}

#[test]
fn a_large_sag_is_only_indicated() {
    assert!(!sag(&[step(500.0, 0.0, 0.0)]).is_indicated());
    let long = sag(&[step(2000.0, 0.0, 0.0)]);
    assert!(long.is_indicated() && close(long.reach.mm(), 2000.0), "{long:?}");
}

#[test]
fn a_wire_of_no_thickness_or_no_length_has_no_sag() {
    let none = WireModel { diameter: Length::ZERO, ..wire() };
    assert_eq!(max_sag(Frame::default(), &[step(100.0, 0.0, 0.0)], &none), None);
    assert_eq!(max_sag(Frame::default(), &[], &wire()), None);
    assert_eq!(sag(&[step(0.0, 0.0, 90.0)]).deflection, Length::ZERO);
}

/// By virtual work with lumps of weight: what a unit load at the free end, in each direction, says of it.
fn by_unit_loads(ways: &[Vector3<f64>], down: &Vector3<f64>) -> Vector3<f64> {
    const LUMPS: u32 = 60;
    let [w, ei, gj] = figures();
    let mut lumps: Vec<(Vector3<f64>, Vector3<f64>, f64)> = Vec::new();
    let mut end = Vector3::zeros();
    for way in ways {
        let length = way.norm();
        for k in 0..LUMPS {
            let middle = (f64::from(k) + 0.5) / f64::from(LUMPS);
            lumps.push((end + way * middle, way / length, length / f64::from(LUMPS)));
        }
        end += way;
    }
    let mut work = Vector3::zeros();
    for (k, &(here, along, length)) in lumps.iter().enumerate() {
        let free_side = lumps[..k].iter().map(|&(at, _, size)| (at - here).cross(down) * (w * size));
        let real: Vector3<f64> = free_side.fold(Vector3::zeros(), |sum, one| sum + one)
            + (-along * (length / 4.0)).cross(down) * (w * length / 2.0);
        for axis in 0..3 {
            let unit = (-here).cross(&Vector3::ith(axis, 1.0));
            let twisting = real.dot(&along) * unit.dot(&along);
            work[axis] += length * ((real.dot(&unit) - twisting) / ei + twisting / gj);
        }
    }
    work
}

proptest! {
    #[test]
    fn a_bent_wire_sags_as_unit_loads_say(
        corners in prop::collection::vec(prop::array::uniform3(-200.0..200.0_f64), 1..5),
        down in prop::array::uniform3(-1.0..1.0_f64),
    ) {
        let ways: Vec<Vector3<f64>> = corners.into_iter().map(Vector3::from).filter(|way| way.norm() > 20.0).collect();
        let Some(down) = Vector3::from(down).try_normalize(0.1) else { return Ok(()) };
        prop_assume!(!ways.is_empty());
        let (found, wanted) = (free_end(&ways, &down), by_unit_loads(&ways, &down));
        let length: f64 = ways.iter().map(Vector3::norm).sum();
        let [w, ei, _] = figures();
        // The lumps are off by some parts in a thousand of what the whole length would sag.
        let scale = w * length.powi(4) / (8.0 * ei);
        prop_assert!((found - wanted).norm() <= 2e-3 * scale + 1e-12, "{found} instead of {wanted}");
    }

    /// The largest sag is that of some moment, and no moment has a larger one.
    #[test]
    fn no_moment_has_a_larger_sag(
        made in prop::collection::vec((20.0..150.0_f64, -180.0..180.0_f64, -150.0..150.0_f64), 1..6),
        moment in 0.0..1.0_f64,
    ) {
        let steps: Vec<Step> = made.into_iter().map(|(feed, rotate, bend)| step(feed, rotate, bend)).collect();
        let largest = sag(&steps);
        let mut ways = Vec::new();
        let mut frame = Frame::default();
        for (made, pose) in steps.iter().zip(poses(Frame::default(), &steps)) {
            ways.push(frame.t() * made.feed.mm());
            frame.feed(made.feed);
            frame.rotate(made.rotate);
            frame.bend(made.bend);
            let down = pose.turned(moment).inverse() * -Vector3::z();
            prop_assert!(free_end(&ways, &down).norm() <= largest.deflection.mm() * 1.001);
        }
    }
}
