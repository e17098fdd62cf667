//! The dynamic program against every choice, and what it asks about a step against the check of the whole program.

use proptest::prelude::*;

use super::super::SearchOptions;
use super::super::tests::{body, machine, options, planned};
use super::*;
use crate::bend::{Step, program_of_path};
use crate::clearance::{MovesWith, StockWire, passages};
use crate::plan::PlanOptions;
use crate::route::Route;
use crate::simulate::scheduled_start;
use crate::testing::{chain, deg, mm};
use crate::units::Length;
use crate::wireframe::VertexId;

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

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
        let wire = StockWire { diameter: mm(3.0), bend_radius: mm(3.0), tail: mm(400.0), margin: Length::ZERO, hangs: None };
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
        let first = Orientation::of_degrees(orientation);
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
    let positions = (-3..=4).map(|eighths| deg(f64::from(eighths) * 45.0));
    let mut choices: Vec<Vec<(Angle, bool)>> = positions
        .flat_map(|position| crate::schedule::head_angles(position, &machine.head))
        .map(|first| vec![first])
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
        let wire = StockWire {
            diameter: mm(3.0),
            bend_radius: mm(3.0),
            tail: mm(400.0),
            margin: Length::ZERO,
            hangs: None,
        };
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

/// On one side of the head is something that the wire may not be bent into, and beside the machine on the other: the first bend
/// goes to the negative side, with the head turned.
#[test]
fn the_first_bend_may_go_to_either_side_wherever_the_part_stands() {
    let corner = chain(&[[0., 0., 0.], [60., 0., 0.], [60., 60., 0.]]);
    let bodies = vec![
        body(MovesWith::Head, [20.0, 20.0, 20.0], [15.0, 35.0, 0.0]),
        body(MovesWith::Frame, [20.0, 20.0, 20.0], [15.0, -35.0, 0.0]),
    ];
    let mut machine = machine(bodies);
    (machine.head.min, machine.head.max) = (deg(-60.0), deg(60.0));
    let one = options(SearchOptions { max_wires: 1, ..SearchOptions::default() });
    let wires = planned(&corner, &machine, &one);
    let made = wires[0].scheduled.as_ref().unwrap().steps[0];
    assert!(wires[0].searched.unwrap().found && made.bend < Angle::ZERO, "{made:?}");
    assert_eq!(made.rotate.abs(), deg(45.0));
}
