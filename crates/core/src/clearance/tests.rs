use nalgebra::{Isometry3, Point3, Rotation3, Vector3};
use proptest::prelude::*;
use wirebend_collide::Solid;

use super::bender::{Bender, RADIUS};
use super::*;
use crate::bend::{Frame, Step};
use crate::compensate::BendModel;
use crate::testing::{deg, mm, published_machine};
use crate::units::{Angle, Length};
use crate::wireframe::{EdgeId, VertexId};

mod hanging;
mod stock;

const WIRE: StockWire = StockWire {
    diameter: Length::ZERO,
    bend_radius: Length::ZERO,
    tail: Length::ZERO,
    margin: Length::ZERO,
    hangs: None,
};

fn wire() -> StockWire {
    StockWire { diameter: mm(3.0), bend_radius: mm(RADIUS), tail: mm(400.0), ..WIRE }
}

fn step(feed: f64, rotate: f64, bend: f64) -> Step {
    Step { feed: mm(feed), rotate: deg(rotate), bend: deg(bend) }
}

fn body(moves_with: MovesWith, solid: Solid, at: Isometry3<f64>) -> Body {
    let [name, entry, source] = ["body", "shapes", "the test"].map(str::to_owned);
    Body {
        name,
        entry,
        moves_with,
        solid,
        at,
        contact_zone: Length::ZERO,
        vertex_zone: Length::ZERO,
        source,
        measured: true,
    }
}

/// A route that visits a vertex of its own with each step.
fn passages(steps: &[Step]) -> Vec<Vec<(Passage, Length)>> {
    let passage = |(k, step): (u32, &Step)| {
        vec![(Passage { edge: EdgeId(k), from: VertexId(k), to: VertexId(k + 1) }, step.feed)]
    };
    (0..).zip(steps).map(passage).collect()
}

fn all_contacts(steps: &[Step], bodies: &Bodies, bend: &BendModel) -> Vec<Deep> {
    all_of(Clearance::new((Frame::default(), steps), None, passages(steps), wire(), bodies, bend))
}

/// A contact with its depth.
#[derive(Debug)]
struct Deep {
    contact: Contact,
    depth: Length,
}

impl std::ops::Deref for Deep {
    type Target = Contact;
    fn deref(&self) -> &Contact {
        &self.contact
    }
}

fn all_of(mut clearance: Clearance) -> Vec<Deep> {
    let mut all = Vec::new();
    for step in 0..clearance.steps() {
        for contact in clearance.contacts_of(step) {
            all.push(Deep { contact, depth: clearance.depth(&contact) });
        }
    }
    all
}

/// Distance of a point from a body by sampling none of the code of the sweep: as the solid says, which has tests of its own.
fn distance(body: &Body, at: &Point3<f64>, head: f64) -> f64 {
    let turned = if body.moves_with == MovesWith::Head { head } else { 0.0 };
    let at = Rotation3::from_axis_angle(&Vector3::x_axis(), -turned) * at;
    body.solid.distance(&(body.at.inverse() * at))
}

/// The first contact of each step as the bender sees it, and the least distance of each step.
fn sampled(steps: &[Step], body: &Body, bend: &BendModel) -> Vec<(Option<(Phase, f64)>, f64)> {
    let mut bender = Bender { points: vec![Point3::origin()], head: 0.0, bends_before: 0.0 };
    steps
        .iter()
        .map(|step| {
            let pressed = bend.springback.as_ref().map_or(step.bend, |model| model.bend_to(step.bend));
            let (mut first, mut least) = (None, f64::INFINITY);
            bender.run(step, pressed.abs().rad(), &mut |phase, passed, points, head| {
                let near = points.iter().map(|at| distance(body, at, head)).fold(f64::INFINITY, f64::min);
                least = least.min(near);
                if near < 1.5 && first.is_none() {
                    first = Some((phase, passed));
                }
            });
            (first, least)
        })
        .collect()
}

fn program() -> impl Strategy<Value = Vec<Step>> {
    let bend = prop_oneof![15.0..120.0_f64, -120.0..-15.0_f64];
    prop::collection::vec((25.0..90.0_f64, -150.0..150.0_f64, bend), 1..5).prop_map(|steps| {
        let bends = steps.into_iter().map(|(feed, rotate, bend)| step(feed, rotate, bend));
        bends.chain([step(40.0, 0.0, 0.0)]).collect()
    })
}

fn obstacle() -> impl Strategy<Value = Body> {
    let moves = prop_oneof![Just(MovesWith::Frame), Just(MovesWith::Head)];
    let solid = (any::<bool>(), prop::array::uniform3(5.0..25.0_f64)).prop_map(|(round, [a, b, c])| {
        if round {
            Solid::Cylinder { radius: a, half_length: b }
        } else {
            Solid::Box { half: Vector3::new(a, b, c) }
        }
    });
    (
        moves,
        solid,
        prop::array::uniform3(-1.0..1.0_f64),
        50.0..120.0_f64,
        prop::array::uniform3(-2.0..2.0_f64),
    )
        .prop_map(|(moves, solid, way, far, lie)| {
            // Beside the axis of the wire: what is on it is asked about with a contact zone.
            let way = Vector3::new(way[0], way[1], way[2] + 1.5).normalize() * far;
            body(moves, solid, Isometry3::new(way, Vector3::from(lie)))
        })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(8))]

    #[test]
    fn contacts_are_those_of_a_bender_that_winds_wire_around_a_pin(steps in program(), body in obstacle()) {
        let bend = published_machine().compensation.bend;
        let bodies = Bodies { all: vec![body.clone()], ..Bodies::default() };
        let found = all_contacts(&steps, &bodies, &bend);
        let sampled = sampled(&steps, &body, &bend);
        let mut before = false;
        for (k, (first, least)) in sampled.into_iter().enumerate() {
            let contact = found.iter().find(|one| one.step == k && one.obstacle == Obstacle::Body(0));
            match (contact, first) {
                // It goes on from the step before, or comes nearer than a point of the sampled wire by its spacing.
                (None, Some((Phase::Feed, passed))) if before && passed < 0.01 => {}
                (None, None) => prop_assert!(least > 1.5 - 1e-6),
                (None, Some(at)) => prop_assert!(false, "step {k} misses the contact at {at:?}, {least}"),
                (Some(found), None) => prop_assert!(found.depth.mm() < 0.2, "{found:?} but {least}"),
                (Some(found), Some((phase, passed))) => {
                    // The axis of a peg goes unevenly while the wire bends evenly.
                    let pressed = bend.springback.as_ref().unwrap().bend_to(steps[k].bend);
                    let own = if phase == Phase::Bend { found.bent.rad() / pressed.rad() } else { found.passed };
                    prop_assert!((found.phase, own) <= (phase, passed + 0.001), "{found:?} {phase:?} {passed}");
                    let depth = 1.5 - least;
                    prop_assert!((found.depth.mm() - depth).abs() < 0.3 + 0.06 * depth, "{found:?}, depth {depth}");
                    if found.phase == phase && depth > 0.5 {
                        prop_assert!(passed - own < 0.2, "{found:?} {passed}");
                    }
                }
            }
            before = first.is_some();
        }
    }
}

#[test]
fn a_wire_bent_down_to_a_table_meets_it_at_the_angle_of_the_right_triangle() {
    // 100 mm beyond the bend, which winds around the pin: the end drops r (1 - cos β) + (l - r β) sin β.
    let table = body(
        MovesWith::Frame,
        Solid::Box { half: Vector3::new(500.0, 500.0, 5.0) },
        Isometry3::translation(0.0, 0.0, -65.0),
    );
    let bodies = Bodies { all: vec![table], ..Bodies::default() };
    let bend = BendModel { springback: None, setback: None, axis_limit: None, before_zero: false };
    // The bend turns towards -z once the head has turned by -90° about the wire.
    let steps = [step(50.0, 0.0, 0.5), step(100.0, 90.0, 90.0), step(30.0, 0.0, 0.0)];
    let found = all_contacts(&steps, &bodies, &bend);
    let contact = found.first().expect("60 mm below the wire is a table");
    assert_eq!((contact.step, contact.phase, contact.obstacle), (1, Phase::Bend, Obstacle::Body(0)));
    let tangent = RADIUS * (deg(0.5).rad() / 2.0).tan();
    let length =
        150.0 - RADIUS + RADIUS * std::f64::consts::FRAC_PI_2 - 2.0 * tangent + RADIUS * deg(0.5).rad();
    let drop = |bent: f64| RADIUS * (1.0 - bent.cos()) + (length - RADIUS * bent) * bent.sin();
    let (mut low, mut high) = (0.0, 1.5);
    for _ in 0..60 {
        let middle = f64::midpoint(low, high);
        if drop(middle) < 60.0 - 1.5 { low = middle } else { high = middle }
    }
    // 0.5° out of the plane moves the end by less than 0.5 mm down.
    assert!(
        (contact.bent.rad() - low).abs() < 0.005,
        "{} instead of {}",
        contact.bent.deg(),
        low.to_degrees()
    );
    assert!(contact.leg == 0 && contact.along.mm() < 1e-6, "{contact:?}");
}

#[test]
fn a_body_with_a_contact_zone_may_touch_the_wire_that_it_bends_and_no_other() {
    let pin = |zone: f64| Bodies {
        all: vec![Body {
            contact_zone: mm(zone),
            ..body(
                MovesWith::Head,
                Solid::Cylinder { radius: 1.5, half_length: 7.0 },
                Isometry3::translation(0.0, 3.0, 0.0),
            )
        }],
        ..Bodies::default()
    };
    let bend = BendModel { springback: None, setback: None, axis_limit: None, before_zero: false };
    let corner = [step(60.0, 0.0, 90.0), step(60.0, 0.0, 0.0)];
    assert!(!all_contacts(&corner, &pin(0.0), &bend).is_empty());
    assert!(all_contacts(&corner, &pin(10.0), &bend).is_empty());
}

#[test]
fn the_peg_comes_out_on_the_side_from_which_it_bends() {
    let machine = published_machine();
    let peg = body(
        MovesWith::Peg,
        Solid::Cylinder { radius: 3.175, half_length: 10.0 },
        Isometry3::translation(32.4, 0.0, 0.0),
    );
    let bodies = Bodies {
        all: vec![peg],
        pivot: mm(12.0),
        peg_stroke: mm(15.0),
        approach: deg(5.0),
        peg_rest: Angle::ZERO,
    };
    // Straight wire of 60 mm: the peg may not touch it before it bends, and does not reach it while it is in.
    for side in [1.0, -1.0] {
        let steps = [step(60.0, 0.0, 90.0 * side), step(60.0, 0.0, 0.0)];
        let found = all_contacts(&steps, &bodies, &machine.compensation.bend);
        let contact = found.first().expect("it bends by touching");
        assert_eq!(contact.phase, Phase::Bend, "{contact:?}");
        assert!(contact.bent.abs().deg() < 0.5 && contact.passed < 0.1, "{contact:?}");
    }
}

#[test]
fn arcs_that_do_not_fit_and_folds_are_rounded_as_far_as_there_is_room() {
    let bodies = Bodies::default();
    let bend = BendModel { springback: None, setback: None, axis_limit: None, before_zero: false };
    let steps = [step(1.0, 0.0, 120.0), step(2.0, 0.0, 120.0), step(30.0, 0.0, 180.0), step(0.0, 0.0, 0.0)];
    // No figure that is not one.
    for contact in all_contacts(&steps, &bodies, &bend) {
        assert!(contact.depth.mm().is_finite() && contact.passed.is_finite(), "{contact:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 32, ..ProptestConfig::default() })]

    /// Threads share the steps of a wire: what they find together must be what one finds alone.
    #[test]
    fn a_wire_that_is_shared_out_meets_what_it_meets_as_a_whole(
        steps in program(),
        one in obstacle(),
        other in obstacle(),
        size in 1_usize..4,
    ) {
        let bodies = Bodies { all: vec![one, other], ..Bodies::default() };
        let bend = BendModel { springback: None, setback: None, axis_limit: None, before_zero: false };
        let made = || Clearance::new((Frame::default(), &steps), None, passages(&steps), wire(), &bodies, &bend);
        let mut shared = made();
        let parts: Vec<_> = (0..steps.len())
            .step_by(size)
            .map(|from| shared.first_contacts_in(from..steps.len().min(from + size), |_| true).unwrap())
            .collect();
        prop_assert_eq!(made().merged(parts), made().first_contacts());
        prop_assert_eq!(made().first_contacts_while(|step| step + 1 < steps.len()), None);
    }
}
