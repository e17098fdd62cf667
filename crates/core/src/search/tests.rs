use nalgebra::{Isometry3, UnitQuaternion, Vector3};
use wirebend_collide::Solid;

use super::*;
use crate::checks::Fact;
use crate::clearance::{Body, MovesWith};
use crate::plan::{DoublingChoice, Machine, PlanObserver, PlanOptions, Stage, WirePlan, plan_wires};
use crate::simulate::scheduled_start;
use crate::testing::{chain, deg, mm, published_machine, wireframe};
use crate::units::Length;
use crate::wireframe::Edit;

/// A box of so many mm about a point.
pub(super) fn body(moves_with: MovesWith, size: [f64; 3], at: [f64; 3]) -> Body {
    let [name, entry, source] = ["body", "shapes", "the test"].map(str::to_owned);
    Body {
        name,
        entry,
        source,
        moves_with,
        solid: Solid::Box { half: Vector3::from(size) / 2.0 },
        at: Isometry3::translation(at[0], at[1], at[2]),
        contact_zone: Length::ZERO,
        vertex_zone: Length::ZERO,
        measured: true,
    }
}

pub(super) fn machine(all: Vec<Body>) -> Machine {
    let mut machine = published_machine();
    machine.bodies.all = all;
    machine
}

pub(super) fn options(search: SearchOptions) -> PlanOptions {
    PlanOptions { doubling: DoublingChoice::Cheapest, search: Some(search), ..PlanOptions::default() }
}

pub(super) fn planned(frame: &Wireframe, machine: &Machine, options: &PlanOptions) -> Vec<WirePlan> {
    let components = frame.components();
    plan_wires(frame, &components[0], machine, options, |_| ())
}

/// Every edge of a frame is passed by the wires together, and those that are doubled once more.
fn assert_covers(frame: &Wireframe, wires: &[WirePlan]) {
    let mut passed: Vec<EdgeId> =
        wires.iter().flat_map(|wire| &wire.route.as_ref().unwrap().traversals).map(|one| one.edge).collect();
    for wire in wires {
        for pair in wire.route.as_ref().unwrap().traversals.windows(2) {
            assert_eq!(pair[0].to, pair[1].from, "a wire has a gap");
        }
    }
    passed.sort_unstable();
    passed.dedup();
    assert_eq!(passed.len(), frame.edge_count());
}

/// A stair in one plane.
fn stair() -> Wireframe {
    chain(&[[0., 0., 0.], [60., 0., 0.], [60., 60., 0.], [120., 60., 0.], [120., 120., 0.]])
}

/// Were a wall not avoided by the other side, machines with one wall would make nothing.
#[test]
fn a_wire_is_bent_to_the_side_where_there_is_no_wall() {
    for side in [1.0, -1.0] {
        let wall = body(MovesWith::Frame, [400.0, 4.0, 400.0], [0.0, 50.0 * side, 0.0]);
        let machine = machine(vec![wall]);
        let hook = chain(&[[0., 0., 0.], [100., 0., 0.], [100., 60., 0.]]);
        let wires = planned(&hook, &machine, &options(SearchOptions::default()));
        assert_eq!(wires.len(), 1);
        assert!(wires[0].searched.unwrap().found);
        assert_eq!(wires[0].contacts.as_deref(), Some(&[][..]));
        let bend = wires[0].scheduled.as_ref().unwrap().steps[0].bend;
        assert!(bend.rad() * side < 0.0, "a wall at {side}: bent by {bend:?}");
    }
}

/// A part between two walls has to stand upright.
#[test]
fn the_part_is_turned_where_only_that_helps() {
    let walls = [1.0, -1.0].map(|side| body(MovesWith::Frame, [400.0, 4.0, 400.0], [0.0, 50.0 * side, 0.0]));
    let machine = machine(walls.to_vec());
    let wires = planned(&stair(), &machine, &options(SearchOptions::default()));
    assert!(wires[0].searched.unwrap().found, "{:?}", wires[0].diagnostics);
    let scheduled = wires[0].scheduled.as_ref().unwrap();
    assert_eq!(scheduled.steps[0].rotate.abs(), deg(90.0));
    // It is still the same part: bent by the machine it lies where it was designed.
    let start = scheduled_start(wires[0].start, &scheduled.steps);
    let made = crate::bend::replay(start, &scheduled.steps);
    for (made, designed) in made.iter().zip(&wires[0].path) {
        assert!((made - designed).norm() < 1e-9, "{made} is not {designed}");
    }
}

/// Two walls close to each other leave room for a flat part alone, and only where it lies along them: they may be tilted by any angle.
#[test]
fn a_flat_part_is_turned_into_a_gap_that_is_tilted_by_any_angle() {
    for tilt in [10.0_f64, 22.0, 30.0, 58.0, -37.0, -80.0] {
        let turned = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), tilt.to_radians());
        let wall = |z: f64| Body {
            at: Isometry3::from_parts((turned * Vector3::new(0.0, 0.0, z)).into(), turned),
            ..body(MovesWith::Frame, [400.0, 600.0, 10.0], [0.0; 3])
        };
        let machine = machine(vec![wall(13.0), wall(-13.0)]);
        let one = options(SearchOptions { max_wires: 1, ..SearchOptions::default() });
        let wires = planned(&stair(), &machine, &one);
        assert!(wires[0].searched.unwrap().found, "{tilt}: {:?}", wires[0].diagnostics);
        assert!(wires[0].contacts.as_ref().unwrap().is_empty());
        // Also where the walk has to stay as it is.
        let settled = vec![wires[0].route.clone().unwrap()];
        let kept = planned(&stair(), &machine, &PlanOptions { settled, ..one });
        assert!(kept[0].contacts.as_ref().unwrap().is_empty(), "{tilt}: {:?}", kept[0].diagnostics);
    }
}

/// A channel leaves no room for any bend.
#[test]
fn what_cannot_be_found_is_said_with_the_bend_that_is_in_the_way() {
    let walls = [
        body(MovesWith::Frame, [400.0, 4.0, 400.0], [0.0, 30.0, 0.0]),
        body(MovesWith::Frame, [400.0, 4.0, 400.0], [0.0, -30.0, 0.0]),
        body(MovesWith::Frame, [400.0, 400.0, 4.0], [0.0, 0.0, 30.0]),
        body(MovesWith::Frame, [400.0, 400.0, 4.0], [0.0, 0.0, -30.0]),
    ];
    let machine = machine(walls.to_vec());
    let search = SearchOptions { max_wires: 1, effort: 800, ..SearchOptions::default() };
    let wires = planned(&stair(), &machine, &options(search));
    let searched = wires[0].searched.unwrap();
    assert!(!searched.found && searched.exhausted);
    let said = wires[0].diagnostics.iter().find(|said| said.code() == crate::checks::Code::NoClearProgram);
    assert_eq!(said.unwrap().location.vertices.len(), 1);
    // The best that there is comes with what it meets.
    assert!(!wires[0].contacts.as_ref().unwrap().is_empty());
    assert_covers(&stair(), &wires);
}

/// A part that is too long for the room on either side of the machine is made of two.
#[test]
fn further_wires_are_used_where_one_cannot_be() {
    let comb = chain(&[
        [0., 0., 0.],
        [120., 0., 0.],
        [120., 100., 0.],
        [160., 100., 0.],
        [160., 0., 0.],
        [280., 0., 0.],
    ]);
    let walls = [
        body(MovesWith::Frame, [4.0, 400.0, 400.0], [-70.0, 0.0, 0.0]),
        body(MovesWith::Frame, [60.0, 400.0, 4.0], [0.0, 0.0, -40.0]),
    ];
    let machine = machine(walls.to_vec());
    let one = planned(
        &comb,
        &machine,
        &options(SearchOptions { max_wires: 1, effort: 800, ..SearchOptions::default() }),
    );
    assert!(!one[0].searched.unwrap().found);
    let said = helps(&one);
    let more = said.found.iter().find(|help| help.change == Change::MoreWires).expect("two were tried");
    // Where the wire is to be cut: each begins and ends at a vertex, and together they pass every edge once.
    let mut passed: Vec<EdgeId> =
        more.routes.iter().flat_map(|route| &route.traversals).map(|one| one.edge).collect();
    passed.sort_unstable();
    assert_eq!((more.routes.len(), passed), (2, comb.edges().map(|(id, _)| id).collect()));
    assert!(!said.ended && said.tried.contains(&ChangeKind::Moved), "{said:?}");
    let wires = planned(&comb, &machine, &options(SearchOptions::default()));
    assert_eq!(wires.len(), 2);
    for wire in &wires {
        assert!(wire.searched.unwrap().found && wire.contacts.as_ref().unwrap().is_empty());
        assert!(wire.is_feasible(), "{:?}", wire.diagnostics);
    }
    assert_covers(&comb, &wires);
}

/// What is said to help was tried: with the vertex there, a program is found.
#[test]
fn the_least_move_that_helps_is_named() {
    // Its end comes down onto the first strut, whichever way it is bent.
    let hook = chain(&[[0., 0., 0.], [100., 0., 0.], [100., 60., 0.], [50., 60., 0.], [50., 1.5, 0.]]);
    let machine = machine(Vec::new());
    let one = options(SearchOptions { max_wires: 1, effort: 800, ..SearchOptions::default() });
    let wires = planned(&hook, &machine, &one);
    let moved = helps(&wires).found.into_iter().find_map(|help| match help.change {
        Change::Moved(moved) => Some(moved),
        _ => None,
    });
    let moved = moved.expect("a little farther away it can be bent");
    assert!(moved.by <= mm(5.0), "{moved:?}");
    let mut elsewhere = hook.clone();
    let place = Edit::Place { vertex: moved.vertex, position: moved.to };
    elsewhere.commit(&place.resolve(&hook).unwrap()).unwrap();
    assert!(planned(&elsewhere, &machine, &one)[0].searched.unwrap().found);
    // What the design holds fixed is not moved.
    let mut held = hook.clone();
    let all = Edit::SetSupport { vertices: hook.vertices().map(|(id, _)| id).collect(), support: true };
    held.commit(&all.resolve(&hook).unwrap()).unwrap();
    let said = helps(&planned(&held, &machine, &one)).found;
    assert!(!said.iter().any(|help| matches!(help.change, Change::Moved(_))), "{said:?}");
}

/// A search that does not begin is not passed over in silence.
#[test]
fn bends_that_no_route_avoids_are_said_to_come_first() {
    let sharp = chain(&[[0., 0., 0.], [100., 0., 0.], [0., 5., 0.]]);
    let wires = planned(&sharp, &machine(Vec::new()), &options(SearchOptions::default()));
    assert!(wires[0].searched.is_none());
    let said = wires[0].diagnostics.iter().find(|said| said.code() == crate::checks::Code::NoClearProgram);
    assert_eq!(said.expect("that it was not searched").location.vertices, [VertexId(1)]);
}

fn helps(wires: &[WirePlan]) -> Helps {
    let facts = wires.iter().flat_map(|wire| &wire.diagnostics).map(|found| &found.fact);
    let mut helps = facts.filter_map(|fact| {
        if let Fact::NoClearProgram { helps, .. } = fact { Some(helps.clone()) } else { None }
    });
    helps.next().expect("that nothing was found")
}

/// Two triangles on a common edge, between a wall and a ceiling: from either of the two odd corners every walk hits something. Run along
/// the common edge twice, the wire may begin at the others.
#[test]
fn an_edge_that_helps_when_it_is_run_along_twice_is_named() {
    let corners = [[20., 60., 0.], [40., 80., 100.], [40., 100., 0.], [0., 60., 80.]];
    let triangles = wireframe(&corners, &[(1, 0), (2, 0), (3, 0), (3, 1), (3, 2)]);
    let walls = [
        body(MovesWith::Frame, [4.0, 400.0, 400.0], [100.0, 0.0, 0.0]),
        body(MovesWith::Frame, [400.0, 400.0, 4.0], [0.0, 0.0, 100.0]),
    ];
    let machine = machine(walls.to_vec());
    let search = Some(SearchOptions { max_wires: 1, effort: 4000, ..SearchOptions::default() });
    let one = PlanOptions { search, ..PlanOptions::default() };
    let without = planned(&triangles, &machine, &one);
    let searched = without[0].searched.unwrap();
    assert!(!searched.found && searched.exhausted, "{searched:?}");
    let said = helps(&without);
    let twice = said.found.iter().find(|help| help.change.kind() == ChangeKind::Doubled);
    let Some(Change::Doubled { edges, added }) = twice.map(|help| &help.change) else { panic!("{said:?}") };
    assert_eq!((&edges[..], *added), (&[EdgeId(2)][..], triangles.edge_length(EdgeId(2))));
    let with = PlanOptions { doubling: DoublingChoice::Accepted(edges.clone()), ..one };
    assert!(planned(&triangles, &machine, &with)[0].searched.unwrap().found);
}

/// Ends the trials of changes after some.
struct Impatient(usize);

impl PlanObserver for Impatient {
    fn done(&mut self, _stage: Stage) {}

    fn trying(&mut self, checks: u64, of: u64) -> bool {
        assert!(checks <= of, "{checks} of {of}");
        self.0 = self.0.saturating_sub(1);
        self.0 > 0
    }
}

/// Whoever ends the trials, or the search before them, is not told that what was not tried does not help.
#[test]
fn what_was_not_tried_is_not_said_to_have_been() {
    let hook = chain(&[[0., 0., 0.], [100., 0., 0.], [100., 60., 0.], [50., 60., 0.], [50., 1.5, 0.]]);
    let machine = machine(Vec::new());
    let one = options(SearchOptions { max_wires: 1, effort: 800, ..SearchOptions::default() });
    let components = hook.components();
    let all = helps(&planned(&hook, &machine, &one));
    assert!(!all.ended && !all.tried.is_empty());
    let few = helps(&plan_wires(&hook, &components[0], &machine, &one, Impatient(1)));
    assert!(few.ended && few.found.is_empty() && few.tried.is_empty(), "{few:?}");
    let none = helps(&plan_wires(&hook, &components[0], &machine, &one, Ended));
    assert_eq!(none, Helps { ended: true, ..Helps::default() });
}

/// Ends a search as soon as it is asked.
struct Ended;

impl PlanObserver for Ended {
    fn done(&mut self, _stage: Stage) {}

    fn searching(&mut self, _progress: SearchProgress, _of: u64) -> bool {
        false
    }
}

/// A square with a diagonal and a path that crosses above it: its four corners are odd.
fn crossed_square() -> Wireframe {
    let a = 80.0;
    let corners = [[0., 0., 0.], [a, 0., 0.], [a, a, 0.], [0., a, 0.], [a / 2., a / 2., 60.]];
    wireframe(&corners, &[(0, 1), (1, 2), (2, 3), (3, 0), (0, 2), (1, 4), (4, 3)])
}

/// Notes what a search has found.
#[derive(Default)]
struct Watched {
    best: Vec<BestSoFar>,
    /// Whether the search is ended as soon as it has found something.
    ends: bool,
}

impl PlanObserver for &mut Watched {
    fn done(&mut self, _stage: Stage) {}

    fn searching(&mut self, progress: SearchProgress, _of: u64) -> bool {
        self.best.extend(progress.best);
        !self.ends || progress.best.is_none()
    }
}

/// The same question has the same answer, and a search that is ended still gives a program.
#[test]
fn a_search_is_repeatable_and_can_be_ended() {
    let machine = machine(vec![body(MovesWith::Head, [80.0, 30.0, 30.0], [-60.0, 0.0, -25.0])]);
    let frame = wireframe(
        &[[0., 0., 0.], [50., 0., 0.], [50., 50., 0.], [0., 50., 0.], [25., 25., 40.]],
        &[(0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (1, 4), (2, 4), (3, 4)],
    );
    let few = SearchOptions { effort: 200, ..SearchOptions::default() };
    let [one, other] = [(); 2].map(|()| planned(&frame, &machine, &options(few.clone())));
    assert_eq!(one, other);
    let components = frame.components();
    let ended = plan_wires(&frame, &components[0], &machine, &options(few), Ended);
    assert_covers(&frame, &ended);
}

/// Whoever sees what is found so far and ends the search there gets just that.
#[test]
fn a_search_that_is_ended_gives_what_it_had_found_by_then() {
    let frame = crossed_square();
    let machine = machine(vec![body(MovesWith::Head, [80.0, 30.0, 30.0], [-60.0, 0.0, -25.0])]);
    let components = frame.components();
    let mut watched = Watched { ends: true, ..Watched::default() };
    let wires =
        plan_wires(&frame, &components[0], &machine, &options(SearchOptions::default()), &mut watched);
    let [BestSoFar { wires: count, doubled }] = watched.best[..] else { panic!("{:?}", watched.best) };
    let searched = wires[0].searched.unwrap();
    assert!(searched.found && searched.ended, "{searched:?}");
    assert_eq!((wires.len(), count), (1, 1));
    assert!(doubled > Length::ZERO);
    let run: Length = wires
        .iter()
        .flat_map(|wire| &wire.route.as_ref().unwrap().traversals)
        .map(|one| frame.edge_length(one.edge))
        .sum();
    let once: Length = components[0].edges.iter().map(|&edge| frame.edge_length(edge)).sum();
    assert!((run.mm() - once.mm() - doubled.mm()).abs() < 1e-3, "{run} {once} {doubled}");
    assert_covers(&frame, &wires);
}

/// What is told while it goes on gets better only, also from one number of wires to the next, and is never better than what comes of it.
#[test]
fn what_is_found_so_far_never_gets_worse() {
    let frame = crossed_square();
    let machine = machine(vec![body(MovesWith::Head, [80.0, 30.0, 30.0], [-60.0, 0.0, -25.0])]);
    let weights = |wire, doubled_mm| Objective::Weighed(Weights { wire, doubled_mm, second: 0 });
    for (objective, wire) in [
        (Objective::InOrder, 1e6),
        (weights(10, 1), 10.0),
        (weights(60, 1), 60.0),
        (weights(1000, 1), 1000.0),
    ] {
        let search = SearchOptions { objective, effort: 2000, ..SearchOptions::default() };
        let mut watched = Watched::default();
        let wires = plan_wires(&frame, &frame.components()[0], &machine, &options(search), &mut watched);
        #[allow(clippy::cast_precision_loss)] // a few
        let cost = |wires: usize, doubled: Length| wires as f64 * wire + doubled.mm();
        let told: Vec<f64> = watched.best.iter().map(|best| cost(best.wires, best.doubled)).collect();
        assert!(!told.is_empty() && told.is_sorted_by(|one, next| next <= one), "{objective:?} {told:?}");
        let routes = || wires.iter().flat_map(|wire| &wire.route.as_ref().unwrap().traversals);
        let run: Length = routes().map(|one| frame.edge_length(one.edge)).sum();
        let doubled = Length::computed(run.mm() - frame.total_length().mm());
        let last = told.last().unwrap();
        assert!(cost(wires.len(), doubled) <= last + 1e-3, "{objective:?} {told:?} {doubled}");
    }
}

/// Whoever weighs a wire less than what is doubled, as where wires are tied anyway, gets two wires instead of a doubled edge.
#[test]
fn weights_choose_between_wires_and_doubled_edges() {
    let frame = crossed_square();
    let machine = machine(Vec::new());
    let with = |objective| {
        let search = SearchOptions { objective, effort: 2000, ..SearchOptions::default() };
        let wires = planned(&frame, &machine, &options(search));
        assert!(wires[0].searched.unwrap().found, "{:?}", wires[0].diagnostics);
        assert_covers(&frame, &wires);
        let passes: usize = wires.iter().map(|wire| wire.route.as_ref().unwrap().traversals.len()).sum();
        (wires.len(), passes - frame.edge_count())
    };
    let weights = |wire, doubled_mm| Objective::Weighed(Weights { wire, doubled_mm, second: 0 });
    assert_eq!(with(Objective::InOrder), (1, 1));
    assert_eq!(with(weights(1_000, 1)), (1, 1), "80 mm are less than a wire");
    assert_eq!(with(weights(10, 1)), (2, 0), "80 mm are more than a wire");
    assert_eq!(with(weights(0, 0)), (1, 1), "where nothing counts the order does");
}
