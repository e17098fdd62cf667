//! Wires: armed, started, paused, finished; declined; resumed by the command line.

use serde_json::json;
use wirebend_operation::{
    Answer, Decided, Decision, MachineEvent, Move, OperationError, OperatorEvent, Order, OrderName, Outcome,
    Phase, QuestionKind, RunHow, RunOutcome,
};
use wirebend_planning::{Input, PartOfStep};

use crate::shop::{Seat, Shop, abandon};

const DRY: Order = Order::DryRun { wire: 0, accept_settings: false, despite_errors: false };

/// So many wires are stopped, or windows closed, until one leaves a step in doubt.
const TRIES: usize = 20;

/// What was fed and bent by hand sticks out of the nozzle, and the first bends of the wire would lie beyond it.
#[test]
fn a_wire_that_was_moved_by_hand_is_no_new_one() {
    let shop = Shop::new();
    let (seat, job) = (shop.simulated("sim:max"), shop.cube("wirebend-kit"));
    seat.home();
    let told = |answer| {
        seat.arm(&job);
        let asked = seat.says(answer);
        seat.until_state(|state| state.question.is_none() && !state.busy);
        asked.lines.iter().any(|line| line.contains("fed or bent by hand"))
    };
    let jog = |moves| {
        seat.order(&json!({"order": "jog", "moves": moves, "record": false}));
        seat.until_state(|state| state.phase == Phase::Ready && !state.busy);
    };
    assert!(!told(Answer::No));
    jog(json!([{"move": "rotate", "deg": 90.0}]));
    assert!(!told(Answer::No), "turning the head does nothing to the wire");
    jog(json!([{"move": "feed", "mm": 10.0}, {"move": "bend", "deg": 45.0}]));
    seat.home();
    assert!(told(Answer::No), "homing cuts nothing off");
    assert!(told(Answer::Yes), "after a no there is no new wire");
    seat.order(&json!({"order": "disarm"}));
    seat.until_phase(Phase::Ready);
    assert!(!told(Answer::No));
}

#[test]
fn a_wire_is_armed_started_paused_and_made() {
    let shop = Shop::new();
    let (seat, job) = (shop.simulated("sim:max"), shop.cube("wirebend-kit"));
    seat.home();
    seat.arm(&job);
    let question = seat.says(Answer::No);
    assert_eq!(question.kind, QuestionKind::Arm);
    // 8 edges of 30 mm; 7 bends; 225 mm of wire and 400 mm that cannot be fed.
    for said in ["8 steps, 7 bends", "load at least 625 mm", "between 0.0° and 90.0°"] {
        assert!(question.lines.iter().any(|line| line.contains(said)), "{said}: {:?}", question.lines);
    }
    // It was homed just now.
    assert!(!question.lines.iter().any(|line| line.contains("reference")), "{:?}", question.lines);
    assert_eq!(seat.until_phase(Phase::Ready).question, None);
    assert_eq!(seat.refused(Order::Start).0, "not-now");

    seat.arm(&job);
    seat.says(Answer::Yes);
    let armed = seat.until_phase(Phase::Armed);
    assert!(armed.can.contains(&OrderName::Start) && armed.can.contains(&OrderName::Disarm));
    assert_eq!(armed.wire.map(|wire| (wire.made, wire.of)), Some((0, 8)));
    seat.order(&json!({"order": "disarm"}));
    seat.until_phase(Phase::Ready);

    seat.start(&job);
    assert_eq!(seat.until_phase(Phase::Making).can, [OrderName::Pause, OrderName::Speed]);
    seat.until_made(2);
    seat.order(&json!({"order": "pause"}));
    let holding = seat.until_phase(Phase::Holding);
    assert_eq!(holding.can, [OrderName::Resume, OrderName::Speed]);
    assert_eq!(seat.refused(Order::Home).0, "not-now");
    seat.order(&json!({"order": "speed", "percent": 40}));
    seat.until_state(|state| state.speed_percent == Some(40));
    seat.order(&json!({"order": "resume"}));
    seat.until_phase(Phase::Making);
    let refused = seat.refused(Order::Speed { percent: 5 });
    assert!(refused.0 == "value" && refused.1.contains("10 to 200"), "{refused:?}");
    let made = seat.until_run();
    assert_eq!((made.wires[0].outcome, made.wires[0].made), (RunOutcome::Made, 8));
    let worst = made.wires[0].worst_deviation_mm().unwrap();
    assert!(worst < 0.5, "the pause is not seen in the wire: {worst} mm");
    let ready = seat.until_phase(Phase::Ready);
    assert_eq!((ready.unfinished, ready.wire.map(|wire| wire.made)), (None, Some(8)));
    let record = shop.record();
    assert_eq!((record.outcome, record.made, record.interruptions.len()), (Outcome::Finished, 8, 0));

    // A second piece on the same connection: the head was left turned, and so it homes first.
    seat.arm(&job);
    let question = seat.says(Answer::Yes);
    assert!(question.lines.iter().any(|line| line.contains("the machine homes")));
    seat.until_phase(Phase::Armed);
    seat.order(&json!({"order": "start"}));
    seat.until_phase(Phase::Homing);
    assert_eq!(seat.until_run().wires[0].outcome, RunOutcome::Made);
}

/// Nothing of a wire is left armed when the machine was moved since.
#[test]
fn a_move_by_hand_disarms() {
    let shop = Shop::new();
    let (seat, job) = (shop.simulated("sim:max"), shop.cube("wirebend-kit"));
    seat.home();
    seat.arm(&job);
    seat.says(Answer::Yes);
    seat.until_phase(Phase::Armed);
    seat.operator.order(Order::Jog { moves: vec![Move::Rotate { deg: 20.0 }], record: false }).unwrap();
    seat.until_phase(Phase::Ready);
    assert_eq!(seat.refused(Order::Start).0, "not-now");
}

#[test]
fn what_is_no_wire_of_this_machine_is_refused() {
    let shop = Shop::new();
    let seat = shop.simulated("sim:max");
    let arm = |job, wire| seat.operator.order_wire(crate::shop::arm(wire, false), job).unwrap();
    arm(shop.cube("wirebend-kit"), 1);
    assert_eq!(seat.until_problem().0, "no-wire");
    seat.until_phase(Phase::Connected);
    arm(shop.cube("howtomechatronics"), 0);
    let (code, message) = seat.until_problem();
    assert_eq!(code, "other-machine");
    assert!(message.contains("'howtomechatronics', not 'wirebend-kit'"), "{message}");
    seat.until_phase(Phase::Connected);
    let job = shop.cube("wirebend-kit");
    seat.operator.order_wire(abandon(0), job.clone()).unwrap();
    assert_eq!(seat.until_problem().0, "nothing-begun");
    seat.until_phase(Phase::Connected);
    seat.resume(&job);
    assert_eq!(seat.until_problem().0, "nothing-begun");
}

/// As soon as it is settled how much of the first step is in the wire, no step counts as sent; the wire is in the machine all the same.
#[test]
fn a_wire_with_a_part_of_its_first_step_is_no_new_one() {
    let (_shop, seat, job) = stopped_in_its_first_feed();

    seat.resume(&job);
    let part = PartOfStep { feed_mm: 5.0, rotate_deg: 0.0 };
    assert_eq!(seat.says(Answer::Part(part)).kind, QuestionKind::Doubt);
    seat.says(Answer::No);
    let declined = seat.until_state(|state| state.question.is_none() && !state.busy);
    let unfinished = declined.unfinished.expect("5 mm of it are fed");
    assert_eq!((unfinished.made, unfinished.in_doubt), (0, None));
    seat.arm(&job);
    assert_eq!(seat.until_problem().0, "unfinished");
    seat.until_state(|state| !state.busy);

    seat.resume(&job);
    while seat.says(Answer::Yes).kind != QuestionKind::Resume {}
    let run = seat.until_run();
    assert_eq!((run.wires[0].outcome, run.wires[0].made), (RunOutcome::Made, 8));
}

/// A wire that was stopped where a person has to measure how much of its first step is made, and not where the machine is sure of it.
fn stopped_in_its_first_feed() -> (Shop, Seat, Input) {
    for _ in 0..TRIES {
        let shop = Shop::new();
        let (seat, job) = (shop.simulated("sim:10"), shop.cube("wirebend-kit"));
        seat.start(&job);
        // Of a step that it has not begun nothing is in doubt.
        seat.until(|event| match event {
            OperatorEvent::Machine(MachineEvent::Wire { in_step, .. }) => (*in_step > 0.0).then_some(()),
            _ => None,
        });
        assert!(seat.operator.stop());
        let run = seat.until_run();
        seat.until_phase(Phase::Stopped);
        let wire = &run.wires[0];
        if let Some([first, _]) = wire.in_doubt {
            assert_eq!(first, 1);
            return (shop, seat, job);
        }
        // It came after that feed: then the machine is sure, or the step is done.
        assert!(wire.made > 0 || wire.stopped_in.as_ref().is_some_and(|step| step.sure), "{wire:?}");
    }
    panic!("none of {TRIES} wires was stopped in its first feed");
}

/// A window is closed in the middle of a wire, after so many steps.
fn leave_after(shop: &Shop, job: &Input, made: u32) {
    let seat = shop.simulated("sim:10");
    seat.start(job);
    seat.until_made(made);
}

/// A wire that was left in the middle of a step, and what the command line says of it.
fn left_in_a_step(job: &Input) -> (Shop, OperationError) {
    for _ in 0..TRIES {
        let shop = Shop::new();
        leave_after(&shop, job, 1);
        if let Err(asked) = shop.run(job, "sim:10", RunHow::Resume { decided: None }) {
            return (shop, asked);
        }
    }
    panic!("none of {TRIES} windows was closed within a step");
}

/// The journals are the same: what the window has begun the command line resumes, and the other way round.
#[test]
fn an_interrupted_wire_is_gone_on_with_wherever_a_person_likes() {
    let shop = Shop::new();
    let job = shop.cube("wirebend-kit");
    leave_after(&shop, &job, 2);
    let step = shop.record().made + 1;
    let decided = Some(Decided { step, what: Decision::NotMade });
    let made = shop.run(&job, "sim:max", RunHow::Resume { decided }).unwrap();
    assert_eq!(made.wires[0].outcome, RunOutcome::Made);
    assert_eq!(shop.record().outcome, Outcome::Finished);

    // There is no user to confirm that a second one may resume: it is stopped where the user cannot be asked.
    let (shop, asked) = left_in_a_step(&job);
    assert_eq!(asked.code(), "in-doubt");
    // A new window offers it by itself.
    let seat = shop.connect("wirebend-kit", Some("sim:10"));
    let left = seat.until_phase(Phase::Connected).unfinished.unwrap();
    assert_eq!((left.wire, left.of, left.in_doubt.is_some()), (0, 8, true));
    // It is known whose wire it is before anyone confirms that it resumes.
    seat.resume(&job);
    seat.says(Answer::No);
    assert_eq!(seat.until_problem().0, "in-doubt");
    let wire = seat.until_phase(Phase::Connected).wire.unwrap();
    assert_eq!((wire.job_hash, wire.name, wire.made), (left.job_hash, left.name, left.made));
    seat.arm(&job);
    assert_eq!(seat.until_problem().0, "unfinished");
    seat.until_phase(Phase::Connected);
    // Its wire may still be in the machine.
    seat.operator.order_wire(DRY, job.clone()).unwrap();
    assert_eq!(seat.until_problem().0, "unfinished");
    seat.until_phase(Phase::Connected);
    // So it may be for a dry run of another job.
    let other = shop.job("house.obj", "wirebend-kit");
    seat.operator.order_wire(DRY, other).unwrap();
    let (code, said) = seat.until_problem();
    assert!(code == "unfinished" && said.contains("may still be in the machine"), "{code}: {said}");
    seat.until_phase(Phase::Connected);
    seat.operator.order_wire(abandon(0), job.clone()).unwrap();
    assert_eq!(seat.until_run().wires[0].outcome, RunOutcome::Abandoned);
    assert_eq!(seat.until_state(|state| state.unfinished.is_none() && !state.busy).phase, Phase::Connected);
    seat.arm(&job);
    seat.says(Answer::No);
}

/// The journal of a wire is damaged: without a way to give the wire up it could never be bent again.
#[test]
fn a_wire_whose_journal_is_damaged_is_given_up() {
    let shop = Shop::new();
    let job = shop.cube("wirebend-kit");
    leave_after(&shop, &job, 1);
    let runs = std::fs::read_dir(shop.folder.path().join("runs")).unwrap();
    let is_journal = |path: &std::path::PathBuf| path.extension().is_some_and(|end| end == "journal");
    let journal = runs.map(|entry| entry.unwrap().path()).find(is_journal).unwrap();
    let text = std::fs::read_to_string(&journal).unwrap();
    std::fs::write(&journal, text.replacen("wirebend-kit", "wirebend-kat", 1)).unwrap();
    let seat = shop.simulated("sim:max");
    seat.arm(&job);
    assert_eq!(seat.until_problem().0, "journal-damaged");
    let left = seat.until_phase(Phase::Connected).unfinished.unwrap();
    assert_eq!((left.resumable, left.wire, left.made, left.of), (false, 0, 0, 8));
    seat.operator.order_wire(abandon(left.wire), job.clone()).unwrap();
    // It is not known how much of it was bent, and so it is none of the wires that are reported.
    let given_up = seat.until_run();
    assert!(given_up.wires.is_empty() && given_up.notes[0].code == "set-aside", "{given_up:?}");
    assert_eq!(seat.until_state(|state| !state.busy).unfinished, None);
    seat.arm(&job);
    seat.says(Answer::No);
}

/// Half of a wire that lies in a real machine is not finished by a simulated one.
#[test]
fn a_wire_of_a_real_machine_does_not_go_on_where_nobody_has_named_one() {
    let shop = Shop::new();
    let job = shop.cube("wirebend-kit");
    leave_after(&shop, &job, 1);
    let seat = shop.connect("wirebend-kit", None);
    assert_eq!(seat.until_phase(Phase::Connected).port.as_deref(), Some("sim"));
    seat.resume(&job);
    let (code, message) = seat.until_problem();
    assert_eq!(code, "begun-elsewhere");
    assert!(message.contains("sim:10"), "{message}");
}

/// On a machine that was not homed the start of a wire does it; a person reads that before.
#[test]
fn a_wire_finds_its_reference_where_nobody_has_homed() {
    let shop = Shop::odd("hostile", |_| json!({}));
    let job = shop.cube("odd");
    let seat = shop.connect("odd", Some("anywhere"));
    seat.until_phase(Phase::Connected);
    seat.arm(&job);
    let question = seat.says(Answer::Yes);
    assert!(question.lines.iter().any(|line| line.contains("the machine homes")), "{:?}", question.lines);
    seat.until_phase(Phase::Armed);
    seat.order(&json!({"order": "start"}));
    seat.until_phase(Phase::Homing);
    seat.until_made(8);
    assert_eq!(seat.until_run().wires[0].outcome, RunOutcome::Made);
}
