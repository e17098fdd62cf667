//! Pause points: the machine stands there until a person says that it may go on.

use std::time::{Duration, Instant};

use serde_json::json;
use wirebend_operation::{
    Answer, MachineEvent, OperatorEvent, Order, Outcome, Phase, QuestionKind, RunHow, RunOutcome,
};
use wirebend_planning::Input;
use wirebend_planning::pauses::StepPause;

use crate::shop::{Seat, Shop};

/// A controller that hears nothing for a second holds.
const LONGER_THAN_SILENCE: Duration = Duration::from_millis(1500);

/// A wire of 8 steps that waits after its third and its fifth.
fn pausing(shop: &Shop) -> Input {
    let pause = |after, note: &str| StepPause { wire: 0, after, note: note.to_owned() };
    let pauses = vec![pause(3, "turn the part"), pause(5, "clip the joint")];
    shop.pausing("cube-8-edges.obj", "wirebend-kit", pauses)
}

/// Nothing but the figures of the wire is heard for a while, and they stay.
fn stands(seat: &Seat, step: u32) {
    let begun = Instant::now();
    while begun.elapsed() < LONGER_THAN_SILENCE {
        match seat.events.recv_timeout(Duration::from_millis(50)) {
            Ok(OperatorEvent::Machine(event @ (MachineEvent::Paused { .. } | MachineEvent::Resumed))) => {
                panic!("it is looked at all the time: {event:?}")
            }
            Ok(OperatorEvent::Machine(MachineEvent::Wire { made, sent, .. })) => {
                assert_eq!((made, sent), (step, step));
            }
            _ => {}
        }
    }
    let state = seat.operator.state();
    assert_eq!(state.wire.map(|wire| (wire.made, wire.sent)), Some((step, step)));
    assert_eq!(state.phase, Phase::Making);
}

#[test]
fn a_wire_stands_at_its_pause_points_until_a_person_says_that_it_goes_on() {
    let shop = Shop::new();
    let (seat, job) = (shop.simulated("sim:max"), pausing(&shop));
    seat.arm(&job);
    let lines = seat.says(Answer::Yes).lines;
    for line in ["it waits after step 3: turn the part", "it waits after step 5: clip the joint"] {
        assert!(lines.iter().any(|said| said == line), "{lines:?}");
    }
    seat.until_phase(Phase::Armed);
    seat.order(&json!({"order": "start"}));
    let asked = seat.until_question();
    assert_eq!(asked.kind, QuestionKind::Pause);
    assert_eq!(asked.question, "turn the part: is that done, and may the machine resume?");
    assert_eq!(asked.lines, ["the machine stands after step 3 of 8"]);
    stands(&seat, 3);
    assert_eq!(seat.refused(Order::Pause).0, "question-open");
    seat.operator.answer(asked.id, Answer::Yes).unwrap();
    seat.operator.answer(asked.id, Answer::Yes).unwrap_err();

    // Without a yes it is stopped, and its rest can be bent later.
    let asked = seat.until_question();
    assert_eq!(seat.operator.state().wire.map(|wire| wire.made), Some(5));
    seat.operator.answer(asked.id, Answer::No).unwrap();
    let run = seat.until_run();
    assert_eq!((run.wires[0].outcome, run.wires[0].made), (RunOutcome::Stopped, 5));
    assert_eq!((run.wires[0].in_doubt, run.wires[0].problem.is_none()), (None, true));
    let stopped = seat.until_state(|state| !state.busy && state.unfinished.is_some());
    assert_eq!(stopped.unfinished.map(|left| left.made), Some(5));

    // Who says that it resumes has read what is to be done where it stands, and is not asked again.
    seat.resume(&job);
    let asked = seat.says(Answer::Yes);
    assert_eq!(asked.kind, QuestionKind::Resume);
    let line = "it stands at a pause point, do this first: clip the joint";
    assert!(asked.lines.iter().any(|said| said == line), "{:?}", asked.lines);
    let run = seat.until_run();
    assert_eq!((run.wires[0].outcome, run.wires[0].made), (RunOutcome::Made, 8));
    let record = shop.record();
    assert_eq!(record.outcome, Outcome::Finished);
    let confirmed: Vec<(u32, &str)> =
        record.pauses.iter().map(|pause| (pause.after, pause.note.as_str())).collect();
    assert_eq!(confirmed, [(3, "turn the part"), (5, "clip the joint")]);
}

/// A stop is possible all the time, and a yes that comes after it moves nothing.
#[test]
fn a_wire_that_waits_can_be_stopped() {
    let shop = Shop::new();
    let (seat, job) = (shop.simulated("sim:max"), pausing(&shop));
    seat.start(&job);
    let asked = seat.until_question();
    assert!(seat.operator.stop());
    seat.operator.answer(asked.id, Answer::Yes).unwrap_err();
    let run = seat.until_run();
    assert_eq!((run.wires[0].outcome, run.wires[0].made), (RunOutcome::Stopped, 3));
}

/// A script says yes to one wire, and not to what a person has to do in its middle.
#[test]
fn without_a_person_it_is_stopped_at_each_pause_point() {
    let shop = Shop::new();
    let job = pausing(&shop);
    let made = shop.run(&job, "sim:max", RunHow::Begin).unwrap();
    assert_eq!((made.wires[0].outcome, made.wires[0].made), (RunOutcome::Stopped, 3));
    let problem = made.wires[0].problem.clone().unwrap();
    assert!(problem.code == "not-confirmed" && problem.message.contains("turn the part"), "{problem:?}");
    let made = shop.run(&job, "sim:max", RunHow::Resume { decided: None }).unwrap();
    assert_eq!((made.wires[0].outcome, made.wires[0].made), (RunOutcome::Stopped, 5));
    let made = shop.run(&job, "sim:max", RunHow::Resume { decided: None }).unwrap();
    assert_eq!((made.wires[0].outcome, made.wires[0].made), (RunOutcome::Made, 8));
}
