use super::*;
use crate::testing::{deg, mm};
use crate::wireframe::EdgeId;

/// 3 mm wire of aluminium.
fn wire() -> WireModel {
    WireModel { diameter: mm(3.0), density_kg_per_m3: 2700.0, youngs_modulus_gpa: 68.03, price_per_mm: None }
}

fn step(feed: f64, rotate: f64, bend: f64) -> Step {
    Step { feed: mm(feed), rotate: deg(rotate), bend: deg(bend) }
}

/// A square that closes: what it has bent is held at the vertex where it began, and its free end should lie there.
#[test]
fn a_joint_is_off_by_what_the_part_sags_where_the_wire_comes_back() {
    let steps =
        [step(100.0, 0.0, 90.0), step(100.0, 0.0, 90.0), step(100.0, 0.0, 90.0), step(100.0, 0.0, 0.0)];
    let passage =
        |k: u32, to: u32| vec![(Passage { edge: EdgeId(k), from: VertexId(k), to: VertexId(to) }, mm(100.0))];
    let closed = [passage(0, 1), passage(1, 2), passage(2, 3), passage(3, 0)];
    let joint = max_joint_sag((Frame::default(), &steps), &closed, &wire()).unwrap();
    assert_eq!((joint.step, joint.vertex), (3, VertexId(0)));
    // The square lies level. By a unit load at its free end, with w s⁴ taken out: 2/3 from bending and 2 from twisting.
    let (side, stiff) = (100.0_f64, 68.03e3 * std::f64::consts::PI / 64.0 * 3.0_f64.powi(4));
    let weight = 2700.0e-9 * std::f64::consts::PI / 4.0 * 9.0 * 9.80665;
    let wanted = weight * side.powi(4) * (2.0 / 3.0 / stiff + 2.0 * 1.33 / stiff);
    assert!((joint.off.mm() - wanted).abs() < 1e-9 * wanted, "{joint:?} instead of {wanted}");
    let open = [passage(0, 1), passage(1, 2), passage(2, 3), passage(3, 4)];
    assert_eq!(max_joint_sag((Frame::default(), &steps), &open, &wire()), None);
}
