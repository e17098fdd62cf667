//! Pieces in a row that the machine cuts off.

use serde_json::{Value, json};
use wirebend_operation::{Answer, Order, Phase, QuestionKind, Repeat, RunOutcome};

#[cfg(target_os = "linux")]
use crate::bender::Bender;
#[cfg(target_os = "linux")]
use crate::grbl_model::Build;
use crate::shop::{Seat, Shop};

/// A machine with a cutter.
fn shop(cutter_mm: f64, jams_at: u32) -> Shop {
    Shop::odd(
        "hostile",
        |folder| json!({"machine": folder.join("kept"), "cutter_mm": cutter_mm, "jams_at": jams_at}),
    )
}

/// How many pieces the machine in the file has cut off.
fn cuts(shop: &Shop) -> u64 {
    let kept = std::fs::read(shop.folder.path().join("kept")).unwrap();
    serde_json::from_slice::<Value>(&kept).unwrap()["cuts"].as_u64().unwrap()
}

fn connected(shop: &Shop) -> Seat {
    let seat = shop.connect("odd", Some("anywhere"));
    seat.until_phase(Phase::Connected);
    seat
}

fn arm(shop: &Shop, seat: &Seat, repeat: Repeat) {
    let order = Order::Arm { wire: Some(0), repeat, accept_settings: false, despite_errors: false };
    seat.operator.order_wire(order, shop.cube("odd")).unwrap();
}

/// 225 mm of wire in a piece, 400 mm that cannot be fed, and 12.5 mm to the cutter.
const WIRE_MM: f64 = 2.0 * 226.0 + 637.5;

#[test]
fn a_row_is_permitted_once_as_long_as_there_is_wire() {
    let shop = shop(12.5, 0);
    let seat = connected(&shop);
    assert_eq!(seat.operator.state().cutter_mm, Some(12.5));
    arm(&shop, &seat, Repeat { pieces: 4, stock_mm: Some(WIRE_MM), cut: true });
    let asked = seat.says(Answer::Yes);
    for said in ["piece 1 of 4", "fed farther by 12.5 mm", "hands away", "without a question"] {
        assert!(asked.lines.iter().any(|line| line.contains(said)), "{said}: {:?}", asked.lines);
    }
    seat.until_phase(Phase::Armed);
    seat.order(&json!({"order": "start"}));
    for made in 1..=3 {
        assert_eq!(seat.until_run().pieces.made, made);
    }
    // The wire does not suffice for the fourth, and the three are cut off.
    let asked = seat.until_question();
    assert_eq!((asked.kind, cuts(&shop)), (QuestionKind::Piece, 3));
    assert_eq!(asked.question, "Is new wire loaded, and may the machine move?");
    seat.operator.answer(asked.id, Answer::Yes).unwrap();
    assert_eq!(seat.until_run().pieces.made, 4);
    seat.until_phase(Phase::Ready);
    assert_eq!(cuts(&shop), 4);
}

/// A person says yes to the wires that follow without a question, too.
#[test]
fn what_is_known_of_each_wire_of_a_row_is_told_before_the_first() {
    let shop = shop(12.5, 0);
    let seat = connected(&shop);
    let repeat = Repeat { pieces: 1, stock_mm: Some(5000.0), cut: true };
    let order = Order::Arm { wire: None, repeat, accept_settings: false, despite_errors: false };
    seat.operator.order_wire(order, shop.job("two-parts.obj", "odd")).unwrap();
    let asked = seat.says(Answer::Yes);
    assert!(asked.lines.iter().any(|line| line.starts_with("wire 2: ")), "{:?}", asked.lines);
    seat.until_phase(Phase::Armed);
    seat.order(&json!({"order": "start"}));
    assert_eq!([seat.until_run().wires[0].wire, seat.until_run().wires[0].wire], [0, 1]);
    seat.until_phase(Phase::Ready);
    assert_eq!(cuts(&shop), 2);
}

/// A piece that still hangs in the machine would be bent into the next one.
#[test]
fn nothing_follows_a_piece_that_is_not_cut_off() {
    let shop = shop(12.5, 2);
    let seat = connected(&shop);
    arm(&shop, &seat, Repeat { pieces: 4, stock_mm: Some(5000.0), cut: true });
    seat.says(Answer::Yes);
    seat.until_phase(Phase::Armed);
    seat.order(&json!({"order": "start"}));
    assert_eq!(seat.until_run().wires[0].problem.as_ref().map(|problem| problem.code.as_str()), None);
    let (_, message) = seat.until_problem();
    assert!(message.contains("the cutter has not come back"), "{message}");
    let run = seat.until_run();
    assert_eq!((run.pieces.made, run.pieces.of), (2, 4));
    assert!(run.wires[0].problem.is_some(), "{run:?}");
    seat.until_phase(Phase::Failed);
    // It is what is wrong also after an order that came to nothing.
    seat.order(&json!({"order": "home"}));
    seat.says(Answer::No);
    let failed = seat.until_phase(Phase::Failed);
    assert!(failed.problem.is_some_and(|problem| problem.message.contains("the cutter has not come back")));
    // The wire is somewhere on its way to the cutter.
    seat.order(&json!({"order": "home"}));
    seat.says(Answer::Yes);
    seat.until_phase(Phase::Ready);
    seat.arm(&shop.cube("odd"));
    let asked = seat.says(Answer::No);
    assert!(asked.lines.iter().any(|line| line.contains("fed or bent by hand before")), "{:?}", asked.lines);
    assert_eq!(cuts(&shop), 2);
}

/// The controller is reset, which turns the cutter off; the piece that is made stays made, and no other is begun.
#[cfg(target_os = "linux")]
#[test]
fn a_stop_while_the_wire_is_cut_ends_the_row() {
    let settings = json!({"homing": "switches", "cut": ["M8", "G4 P0.1", "M9"], "cutter_mm": 400.0});
    let shop = Shop::with_machine("cuts", "grbl-bender", &settings);
    let bender = Bender::new(Build { steps_a_turn: 8, ..Build::default() });
    let seat = shop.connect("cuts", Some(&bender.port));
    seat.until_phase(Phase::Connected);
    let repeat = Repeat { pieces: 3, stock_mm: Some(5000.0), cut: true };
    let order = Order::Arm { wire: Some(0), repeat, accept_settings: false, despite_errors: false };
    seat.operator.order_wire(order, shop.job("u-sample.obj", "cuts")).unwrap();
    seat.says(Answer::Yes);
    seat.until_phase(Phase::Armed);
    seat.order(&json!({"order": "start"}));
    seat.until_state(|state| state.doing.as_deref() == Some("cutting the wire off") && state.may_move);
    assert!(seat.operator.stop());
    let (code, _) = seat.until_problem();
    assert_eq!(code, "stopped");
    let run = seat.until_run();
    assert_eq!((run.pieces.made, run.wires[0].outcome), (1, RunOutcome::Made));
    let standstill = serde_json::to_value(run.wires[0].standstill).unwrap();
    assert_eq!(standstill, "confirmed");
    seat.until_phase(Phase::Stopped);
    assert!(bender.model.end().cuts.is_empty(), "it was on its way to the cutter");
}

#[test]
fn what_the_cutter_cannot_cut_off_is_refused_before_the_wire() {
    let row = Repeat { pieces: 2, stock_mm: None, cut: true };
    let without = Shop::odd("hostile", |folder| json!({"machine": folder.join("kept")}));
    let seat = connected(&without);
    assert_eq!(seat.operator.state().cutter_mm, None);
    arm(&without, &seat, row);
    assert_eq!(seat.until_problem().0, "no-cutter");
    seat.until_phase(Phase::Connected);
    // The cube ends 30 mm after its last corner, less what the bend there takes.
    let behind = shop(-40.0, 0);
    let seat = connected(&behind);
    arm(&behind, &seat, row);
    let (code, message) = seat.until_problem();
    assert!(code == "end-too-short" && message.contains("40.0 mm inside the machine"), "{message}");
    let behind = shop(-20.0, 0);
    let seat = connected(&behind);
    arm(&behind, &seat, row);
    let asked = seat.says(Answer::No);
    assert!(asked.lines.iter().any(|line| line.contains("pulled back by 20.0 mm")), "{:?}", asked.lines);
}
