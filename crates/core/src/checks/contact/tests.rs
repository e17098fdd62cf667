use nalgebra::{Isometry3, Vector3};
use wirebend_collide::Solid;

use super::super::tests::on;
use super::super::{Code, Diagnostic, Fact, Severity};
use crate::clearance::{Bodies, Body, MovesWith};
use crate::plan::PlanOptions;
use crate::testing::{chain, mm, published_machine};
use crate::units::Length;
use crate::wireframe::VertexId;

/// A wall so far from the bend point.
fn wall(x: f64) -> Body {
    let half = Vector3::new(5.0, 200.0, 200.0);
    Body {
        name: "wall".to_owned(),
        moves_with: MovesWith::Frame,
        solid: Solid::Box { half },
        at: Isometry3::translation(x + half.x, 0.0, 0.0),
        contact_zone: Length::ZERO,
        vertex_zone: Length::ZERO,
        entry: "shapes".to_owned(),
        source: "the test".to_owned(),
        measured: true,
    }
}

/// What is said of a wall so far from the bend point, when a wire 3 mm thick is fed towards it until its first leg, which
/// stands across, has its centreline at 60 mm.
fn wall_at(x: f64, margin: f64) -> Vec<Diagnostic> {
    let mut machine = published_machine();
    machine.bodies = Bodies { all: vec![wall(x)], ..Bodies::default() };
    let corner = chain(&[[0., 0., 0.], [40., 0., 0.], [40., 60., 0.]]);
    let options = PlanOptions { contacts: true, clearance: mm(margin), ..PlanOptions::default() };
    let mut found = on(&machine, &corner, &options);
    found.retain(|diagnostic| diagnostic.code() == Code::MeetsMachine);
    found
}

/// A measured body that the wire hits is an error; that it comes nearer than asked is a warning.
#[test]
fn what_is_too_near_is_said_and_only_what_hits_is_an_error() {
    for (gap, margin, severity, depth) in [
        (1.0, 0.0, None, 0.0),
        (1.0, 0.9, None, 0.0),
        (1.0, 1.5, Some(Severity::Warning), -1.0),
        (-0.5, 0.0, Some(Severity::Error), 0.5),
        // What only just is hit is hit, with a margin too.
        (-0.006, 0.0, Some(Severity::Error), 0.006),
        (-0.006, 12.0, Some(Severity::Error), 0.006),
        (0.02, 12.0, Some(Severity::Warning), -0.02),
        (-0.5, 1.5, Some(Severity::Error), 0.5),
        (5.0, 12.0, Some(Severity::Warning), -5.0),
        (-0.5, 12.0, Some(Severity::Error), 0.5),
    ] {
        let found = wall_at(60.0 + 1.5 + gap, margin);
        assert_eq!(
            found.first().map(|hit| hit.severity),
            severity,
            "{gap} mm apart, {margin} mm asked: {found:?}"
        );
        let Some(Fact::MeetsMachine { meeting, .. }) = found.first().map(|hit| &hit.fact) else { continue };
        let said = meeting.depth;
        // Depths are found to a twentieth, however far the wire has to stay away.
        let exact = f64::min(0.05 * (depth + margin) + 0.02, 0.05 * f64::max(-gap, 0.0) + 0.04);
        assert!((said.mm() - depth).abs() <= exact, "{said} instead of {depth}");
    }
}

/// A wire that comes near a wall in one step, and hits it in a later one.
#[test]
fn what_is_near_at_first_does_not_hide_what_is_hit_later() {
    let mut machine = published_machine();
    machine.bodies = Bodies { all: vec![wall(67.0)], ..Bodies::default() };
    let stairs = chain(&[[0., 0., 0.], [40., 0., 0.], [40., 60., 0.], [40., 60., 60.], [140., 60., 60.]]);
    let hit_with = |margin: f64| {
        let options = PlanOptions { contacts: true, clearance: mm(margin), ..PlanOptions::default() };
        let found = on(&machine, &stairs, &options);
        let hits = found.into_iter().filter(|one| one.code() == Code::MeetsMachine && one.is_error());
        hits.map(|one| (one.location.step, one.fact)).collect::<Vec<_>>()
    };
    let without = hit_with(0.0);
    assert_eq!(without.len(), 1, "{without:?}");
    for margin in [2.0, 8.0, 60.0] {
        let with = hit_with(margin);
        assert_eq!((with.len(), with[0].0), (1, without[0].0), "{margin} mm: {with:?}");
    }
}

/// A wire that touches what is still to be bent, and has it go through its middle later: with the same feed that touches it, or in a step
/// of its own. Lifted by a few millimetres, so that it does not touch, it is the same wire.
#[test]
fn what_is_touched_at_first_does_not_hide_what_goes_through_the_middle_later() {
    let both =
        [[80., 120., 40.], [0., 120., -40.], [0., 60., 0.], [0., 0., 0.], [40., 0., 0.], [40., 60., 0.]];
    let same_feed = |z: f64| [&[[100., -30., z], [100., 40., z]][..], &both].concat();
    let later = |z: f64| [&[[100., -70., z], [100., -15., z], [120., 60., 60.]][..], &both].concat();
    let found = |corners: &[[f64; 3]]| {
        let options = PlanOptions { contacts: true, start: Some(VertexId(0)), ..PlanOptions::default() };
        let mut found = on(&published_machine(), &chain(corners), &options);
        found.retain(|diagnostic| diagnostic.code() == Code::MeetsStock);
        let [one] = &found[..] else { panic!("{found:?}") };
        let Fact::MeetsStock(meeting) = &one.fact else { unreachable!("by its code") };
        (one.severity, one.location.step, meeting.depth.mm())
    };
    for (touches, lifted) in [(same_feed(2.2), same_feed(4.5)), (later(2.2), later(6.0))] {
        let (with, without) = (found(&touches), found(&lifted));
        assert_eq!((with.0, with.1), (Severity::Error, without.1), "{with:?} {without:?}");
        assert!((with.2 - without.2).abs() < 0.1 && with.2 > 2.5, "{with:?} {without:?}");
    }
}
