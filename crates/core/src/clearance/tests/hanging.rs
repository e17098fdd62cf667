//! A wire that hangs as its own weight makes it.

use super::*;
use crate::estimate::WireModel;

/// Wire of aluminium, 3 mm: 1.8716e-4 N/mm and E I of 270.5e3 N mm².
const ALUMINIUM: WireModel = WireModel {
    diameter: Length::computed(3.0),
    density_kg_per_m3: 2700.0,
    youngs_modulus_gpa: 68.03,
    price_per_mm: None,
};

fn hanging(steps: &[Step], bodies: &Bodies, hangs: Option<WireModel>) -> Vec<Deep> {
    let bend = BendModel::default();
    let wire = StockWire { hangs, ..wire() };
    all_of(Clearance::new((Frame::default(), steps), None, passages(steps), wire, bodies, &bend))
}

/// A table 3 mm below a straight wire: the end of the wire sinks onto it where w L⁴ / (8 E I) is 3 mm, at 431.5 mm of it.
#[test]
fn a_wire_that_hangs_sinks_onto_a_table_where_a_cantilever_would() {
    let table = Solid::Box { half: Vector3::new(600.0, 100.0, 5.0) };
    let at = Isometry3::translation(0.0, 0.0, -1.5 - 3.0 - 5.0);
    let bodies = Bodies { all: vec![body(MovesWith::Frame, table, at)], ..Bodies::default() };
    let steps = [step(1.0, 0.0, 0.0), step(499.0, 0.0, 0.0), step(10.0, 0.0, 0.0)];
    assert!(hanging(&steps, &bodies, None).is_empty());
    let found = hanging(&steps, &bodies, Some(ALUMINIUM));
    let first = found.first().expect("it sinks onto the table");
    let [w, ei] = [1.8716e-4, 270.5e3];
    let wanted = f64::powf(8.0 * ei * 3.0 / w, 0.25) - 1.0;
    assert_eq!((first.step, first.phase), (1, Phase::Feed));
    // A shape is within a tenth of a millimetre, and so is the contact: the end sinks by twice as much within 7.2 mm of feed.
    assert!((0.0..7.2).contains(&(wanted - first.fed.mm())), "{first:?} instead of {wanted}");
    // At 500 mm it has sunk by 5.4 mm, of which 2.4 mm are into the table.
    assert!((first.depth.mm() - 2.406).abs() < 0.1 + 0.05 * 2.406, "{first:?}");
}

/// A wire so stiff that it does not sag meets the same things at the same moments as one that keeps its shape.
#[test]
fn a_stiff_wire_that_hangs_meets_what_one_that_keeps_its_shape_meets() {
    let stiff = WireModel { youngs_modulus_gpa: 1e9, ..ALUMINIUM };
    let wall = Solid::Box { half: Vector3::new(5.0, 200.0, 200.0) };
    let bodies = Bodies {
        all: vec![
            body(MovesWith::Frame, wall, Isometry3::translation(60.0, 0.0, 0.0)),
            body(MovesWith::Head, wall, Isometry3::translation(0.0, 220.0, 0.0)),
        ],
        ..Bodies::default()
    };
    let steps = [
        step(40.0, 0.0, 90.0),
        step(55.0, 70.0, -60.0),
        step(80.0, -20.0, 100.0),
        step(60.0, 15.0, 45.0),
        step(30.0, 0.0, 0.0),
    ];
    let (rigid, stiff) = (hanging(&steps, &bodies, None), hanging(&steps, &bodies, Some(stiff)));
    assert!(!rigid.is_empty());
    assert_eq!(rigid.len(), stiff.len(), "{rigid:?} {stiff:?}");
    for (one, other) in rigid.iter().zip(&stiff) {
        assert_eq!(
            (one.step, one.phase, one.obstacle, one.leg),
            (other.step, other.phase, other.obstacle, other.leg)
        );
        assert!((one.passed - other.passed).abs() < 1e-3, "{one:?} {other:?}");
        assert!((one.depth.mm() - other.depth.mm()).abs() < 0.1 + 0.05 * one.depth.mm(), "{one:?} {other:?}");
    }
}

/// Two walls, 0.5 mm beyond the wire at its side: a wire that hangs in another way is not known to 0.5 mm, which is no contact, and hides
/// none. It is bent into a wall later.
#[test]
fn what_only_may_be_met_for_all_that_is_known_of_the_shape_is_not_met() {
    let wall = Solid::Box { half: Vector3::new(1500.0, 10.0, 1500.0) };
    let walls = [912.0, -912.0].map(|y| body(MovesWith::Frame, wall, Isometry3::translation(0.0, y, 0.0)));
    let bodies = Bodies { all: walls.to_vec(), ..Bodies::default() };
    let bend = BendModel::default();
    let steps =
        [step(900.0, 0.0, 90.0), step(300.0, 0.0, 30.0), step(200.0, 0.0, -50.0), step(200.0, 0.0, 0.0)];
    let first = |hangs, margin| {
        let wire = StockWire { hangs, margin: mm(margin), ..wire() };
        Clearance::new((Frame::default(), &steps), None, passages(&steps), wire, &bodies, &bend)
            .first_contacts()
    };
    let rigid = first(None, 0.0);
    let first_hit = |found: &[FirstContact]| {
        let hit = found.iter().find(|one| one.hits())?;
        Some((hit.contact.step, hit.depth.mm()))
    };
    let (step, depth) = first_hit(&rigid).expect("it is bent into a wall");
    for margin in [0.0, 1.0, 3.0] {
        let hanging = first(Some(ALUMINIUM), margin);
        let (of, deep) = first_hit(&hanging).unwrap_or_else(|| panic!("{margin} mm: {hanging:?}"));
        assert_eq!(of, step, "{margin} mm: {hanging:?}");
        assert!((deep - depth).abs() < 0.1 * depth, "{margin} mm: {deep} {depth}");
        let met = |found: &[FirstContact]| found.iter().map(|one| one.contact.obstacle).collect::<Vec<_>>();
        assert!(margin > 0.0 || met(&hanging) == met(&rigid), "{hanging:?} {rigid:?}");
    }
}
