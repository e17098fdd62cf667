use nalgebra::{Isometry3, Vector3};
use proptest::prelude::*;
use wirebend_collide::Solid;

use super::heads::Orientation;
use super::trail::Passes;
use super::*;
use crate::bend::{Step, program_of_path};
use crate::checks::Fact;
use crate::clearance::{Body, Clearance, MovesWith, StepPart, StepRun, passages};
use crate::plan::{DoublingChoice, Machine, PlanObserver, PlanOptions, Stage, WirePlan, plan_wires};
use crate::simulate::scheduled_start;
use crate::testing::{chain, deg, mm, published_machine, wireframe};
use crate::units::Length;
use crate::wireframe::Edit;

/// A box of so many mm about a point.
fn body(moves_with: MovesWith, size: [f64; 3], at: [f64; 3]) -> Body {
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

fn machine(all: Vec<Body>) -> Machine {
    let mut machine = published_machine();
    machine.bodies.all = all;
    machine
}

fn options(search: SearchOptions) -> PlanOptions {
    PlanOptions { doubling: DoublingChoice::Cheapest, search: Some(search), ..PlanOptions::default() }
}

fn planned(frame: &Wireframe, machine: &Machine, options: &PlanOptions) -> Vec<WirePlan> {
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
    assert_eq!(helps(&one).wires, Some(2), "two were tried");
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
    let moved = helps(&wires).moved.expect("a little farther away it can be bent");
    assert!(moved.by <= mm(5.0), "{moved:?}");
    let mut elsewhere = hook.clone();
    let place = Edit::Place { vertex: moved.vertex, position: moved.to };
    elsewhere.commit(&place.resolve(&hook).unwrap()).unwrap();
    assert!(planned(&elsewhere, &machine, &one)[0].searched.unwrap().found);
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
    let mut helps = facts
        .filter_map(|fact| if let Fact::NoClearProgram { helps, .. } = fact { Some(*helps) } else { None });
    helps.next().expect("that nothing was found")
}

/// Ends a search as soon as it is asked.
struct Ended;

impl PlanObserver for Ended {
    fn done(&mut self, _stage: Stage) {}

    fn searching(&mut self, _checks: u64, _of: u64) -> bool {
        false
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

/// How many wires a multigraph needs at least, by trying every walk.
fn fewest(passes: &Passes, used: &mut Vec<bool>, here: Option<usize>) -> usize {
    if used.iter().all(|&used| used) {
        return 0;
    }
    let mut fewest_of_all = usize::MAX;
    for pass in 0..used.len() {
        if used[pass] {
            continue;
        }
        for end in passes.all[pass].ends {
            used[pass] = true;
            let begins = usize::from(here != Some(end));
            let rest = fewest(passes, used, Some(passes.all[pass].other(end)));
            used[pass] = false;
            fewest_of_all = fewest_of_all.min(begins + rest);
        }
    }
    fewest_of_all
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    /// Were it too low, the search would run into walks that cannot be ended; too high, it would leave out good ones.
    #[test]
    fn the_number_of_wires_that_are_needed_is_that_of_trying_everything(
        edges in prop::collection::vec((0_usize..5, 0_usize..5), 1..6),
        here in prop::option::of(0_usize..5),
    ) {
        let points: Vec<[f64; 3]> = (0..5_u32).map(|k| [f64::from(k), f64::from(k * k), 0.0]).collect();
        let edges: Vec<(usize, usize)> = edges.into_iter().filter(|(a, b)| a != b).collect();
        prop_assume!(!edges.is_empty());
        let mut frame = wireframe(&points, &[]);
        let ids: Vec<VertexId> = frame.vertices().map(|(id, _)| id).collect();
        for &(a, b) in &edges {
            frame.add_edge(ids[a], ids[b]).unwrap();
        }
        let component = Component { vertices: ids, edges: frame.edges().map(|(id, _)| id).collect() };
        let passes = Passes::new(&frame, &component, &[]);
        let mut used = vec![false; passes.all.len()];
        let needed = passes.wires_needed(&used, here);
        // A wire that continues counts, too: it began before.
        let tried = fewest(&passes, &mut used, here) + usize::from(here.is_some());
        prop_assert_eq!(needed, tried);
    }

    /// What the search asks of parts of a step is what the check says of the whole program.
    #[test]
    fn the_search_and_the_check_agree(
        turns in prop::collection::vec((30.0_f64..80.0, -170.0_f64..170.0, 20.0_f64..120.0), 2..6),
        flips in prop::collection::vec(any::<bool>(), 6),
        orientation in prop::sample::select(vec![0.0, 90.0, -45.0]),
    ) {
        let mut steps: Vec<Step> = turns
            .iter()
            .map(|&(feed, rotate, bend)| Step { feed: mm(feed), rotate: deg(rotate), bend: deg(bend) })
            .collect();
        steps.push(Step { feed: mm(40.0), ..Step::default() });
        let path = crate::bend::replay(crate::bend::Frame::default(), &steps);
        let points: Vec<[f64; 3]> = path.iter().map(|point| [point.x, point.y, point.z]).collect();
        let frame = chain(&points);
        let bodies = vec![
            body(MovesWith::Head, [60.0, 30.0, 10.0], [-40.0, 0.0, -20.0]),
            body(MovesWith::Frame, [30.0, 90.0, 90.0], [-90.0, 0.0, 0.0]),
            body(MovesWith::Frame, [300.0, 200.0, 6.0], [0.0, 0.0, -70.0]),
        ];
        let machine = machine(bodies);
        let (start, program) = program_of_path(&path, machine.straight).unwrap();
        let route = Route::through(&frame, &(0..u32::try_from(path.len()).unwrap()).map(VertexId).collect::<Vec<_>>()).unwrap();
        let passages = passages(&frame, &route.traversals, &program.spans);
        let bend = &machine.compensation.bend;
        let wire = StockWire { diameter: mm(3.0), bend_radius: mm(3.0), tail: mm(400.0), margin: Length::ZERO };
        // A schedule: each bend to a side, with the head as near to zero as that allows.
        let bends: Vec<usize> = (0..program.steps.len()).filter(|&k| program.steps[k].bend != Angle::ZERO).collect();
        let mut unflipped = deg(orientation);
        let mut chosen = Vec::new();
        for (k, &step) in bends.iter().enumerate() {
            if k > 0 {
                unflipped = (unflipped + program.steps[step].rotate).wrapped();
            }
            let flipped = flips[k];
            let half = if flipped { Angle::HALF_TURN } else { Angle::ZERO };
            chosen.push(((unflipped + half).wrapped(), flipped));
        }
        let scheduled = crate::schedule::build(&program, &bends, &chosen);
        let begins = scheduled_start(start, &scheduled.steps);
        let mut whole = Clearance::new((begins, &scheduled.steps), None, passages.clone(), wire, &machine.bodies, bend);
        let (first_head, first_flipped) = chosen[0];
        let first = Orientation { head: first_head, flipped: first_flipped };
        let parts = Clearance::new((start, &program.steps), None, passages, wire, &machine.bodies, bend)
            .turned(first.turn());
        let mut head = Angle::ZERO;
        for (k, step) in scheduled.steps.iter().enumerate() {
            let said = !whole.contacts_of(k).is_empty();
            let to = head + step.rotate;
            let run = |head: [Angle; 2]| StepRun { head: head.map(|head| -head), bend: step.bend };
            let asked = [
                (StepPart::FeedPastFrame, [head, head]),
                (StepPart::FeedPastHead, [head, head]),
                (StepPart::Rotate, [head, to]),
                (StepPart::Bend, [to, to]),
            ];
            let meets = asked.into_iter().any(|(part, head)| parts.obstacle(k, part, &run(head)).is_some());
            // What is met on and on is said once.
            prop_assert!(meets || !said, "step {k} meets something that the search does not see");
            let is_new = k == 0 || !meets || said || parts.obstacle(k, StepPart::FeedPastFrame, &run([head, head])).is_some()
                || parts.obstacle(k, StepPart::FeedPastHead, &run([head, head])).is_some();
            prop_assert!(is_new, "step {k} meets something that the check does not see");
            head = to;
        }
    }
}

/// The dynamic program against every choice of signs and windings, each run through the whole check.
#[test]
fn no_other_choice_of_signs_and_windings_is_better() {
    let points =
        [[0., 0., 0.], [60., 0., 0.], [60., 50., 0.], [60., 50., 60.], [10., 60., 80.], [10., 120., 60.]];
    let frame = chain(&points);
    let bodies = vec![
        body(MovesWith::Head, [60.0, 30.0, 10.0], [-40.0, 0.0, -22.0]),
        body(MovesWith::Frame, [300.0, 300.0, 6.0], [60.0, 0.0, -80.0]),
    ];
    let machine = machine(bodies);
    let route = Route::through(&frame, &(0..6).map(VertexId).collect::<Vec<_>>()).unwrap();
    let search = SearchOptions::default();
    let kept = PlanOptions { settled: vec![route.clone()], ..options(search) };
    let best = planned(&frame, &machine, &kept).remove(0);
    let program = best.nominal.clone().unwrap();
    let passages = passages(&frame, &route.traversals, &program.spans);
    let bends: Vec<usize> = (0..program.steps.len() - 1).collect();
    let bend_seconds = |bend: Angle| {
        machine.compensation.bend.command(bend).map_or(0.0, |command| machine.time.bend_seconds(command))
    };
    let seconds = |steps: &[Step]| -> f64 {
        let turns: f64 = steps.iter().map(|step| step.rotate.abs().deg() / 131.3).sum();
        turns + steps.iter().map(|step| bend_seconds(step.bend)).sum::<f64>()
    };
    let (mut tried, mut clear) = (0, 0);
    let mut choices: Vec<Vec<(Angle, bool)>> = orientations(&machine.head, true)
        .iter()
        .map(|orientation| vec![(orientation.head, orientation.flipped)])
        .collect();
    while let Some(chosen) = choices.pop() {
        if chosen.len() < bends.len() {
            let half = |flipped: bool| if flipped { Angle::HALF_TURN } else { Angle::ZERO };
            let (head, flipped) = chosen[chosen.len() - 1];
            let unflipped = (head - half(flipped) + program.steps[chosen.len()].rotate).wrapped();
            for (head, flipped) in crate::schedule::head_angles(unflipped, &machine.head) {
                choices.push([chosen.as_slice(), &[(head, flipped)]].concat());
            }
            continue;
        }
        tried += 1;
        let scheduled = crate::schedule::build(&program, &bends, &chosen);
        let begins = scheduled_start(best.start, &scheduled.steps);
        let wire =
            StockWire { diameter: mm(3.0), bend_radius: mm(3.0), tail: mm(400.0), margin: Length::ZERO };
        let bend = &machine.compensation.bend;
        let clearance =
            Clearance::new((begins, &scheduled.steps), None, passages.clone(), wire, &machine.bodies, bend);
        if clearance.first_contacts().is_empty() {
            clear += 1;
            let best = seconds(&best.scheduled.as_ref().unwrap().steps);
            assert!(best <= seconds(&scheduled.steps) + 1e-6, "{chosen:?} is faster");
        }
    }
    assert!(clear > 0 && clear < tried, "{clear} of {tried}: the bodies decide something");
    assert!(best.contacts.as_ref().unwrap().is_empty());
}

/// Whoever weighs a wire less than what is doubled, as where wires are tied anyway, gets two wires instead of a doubled edge.
#[test]
fn weights_choose_between_wires_and_doubled_edges() {
    let a = 80.0;
    let points = [[0., 0., 0.], [a, 0., 0.], [a, a, 0.], [0., a, 0.]];
    // A square with a diagonal and a path that crosses above it: its four corners are odd.
    let corners: Vec<[f64; 3]> = points.iter().copied().chain([[a / 2., a / 2., 60.]]).collect();
    let frame = wireframe(&corners, &[(0, 1), (1, 2), (2, 3), (3, 0), (0, 2), (1, 4), (4, 3)]);
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
