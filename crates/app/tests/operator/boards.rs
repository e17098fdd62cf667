//! A real port: a board at a terminal.

use std::time::Instant;

use serde_json::json;
use wirebend_app::{Answer, Move, OperatorEvent, Order, Phase};

use crate::board::Board;
use crate::shop::Shop;

/// The board is opened once, moved jog by jog, and left to one window at a time.
#[test]
fn a_board_stays_connected_and_is_nobody_elses() {
    let (shop, board) = (Shop::new(), Board::new(true));
    let seat = shop.connect("wirebend-kit", Some(&board.port));
    let state = seat.until_phase(Phase::Connected);
    assert!(!state.simulated);
    assert!(!state.settings.is_empty(), "those of the board are all zero");
    let other = shop.connect("wirebend-kit", Some(&board.port));
    let (_, message) = other.until_problem();
    assert!(message.contains(&board.port), "{message}");
    other.until_phase(Phase::Failed);
    drop(other);

    seat.order(&json!({"order": "home"}));
    seat.says(Answer::Yes);
    seat.until_phase(Phase::Ready);
    for _ in 0..3 {
        seat.operator.order(Order::Jog { moves: vec![Move::Feed { mm: 1.0 }], record: false }).unwrap();
        seat.until(|event| matches!(event, OperatorEvent::Jogged { .. }).then_some(()));
        seat.until_phase(Phase::Ready);
    }
    let begun = Instant::now();
    assert!(seat.operator.stop());
    assert!(board.stopped_at() >= begun, "the stop is at the port");
    seat.until_phase(Phase::Stopped);
}

/// Nobody answers: the stop is at the port all the same, and the next one is connected.
#[test]
fn a_board_that_does_not_answer_is_let_go() {
    let (shop, board) = (Shop::new(), Board::new(false));
    let seat = shop.connect("wirebend-kit", Some(&board.port));
    seat.until_state(|state| state.doing.as_deref() == Some("connecting"));
    assert!(seat.operator.stop());
    let _ = board.stopped_at();
    assert_eq!(seat.until_problem().0, "stopped");
    let failed = seat.until_phase(Phase::Failed);
    assert!(failed.problem.is_some());
}
