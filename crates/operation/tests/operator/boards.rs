//! A real port: a board at a terminal.

use std::time::Instant;

use serde_json::json;
use wirebend_operation::{Answer, MachineEvent, Move, OperatorEvent, Order, Phase, QuestionKind};
use wirebend_planning::plan::CheckRequest;
use wirebend_planning::{DesignInput, NoProgress, PlanChoices};

use crate::bender::Bender;
use crate::board::Board;
use crate::grbl_model::Build;
use crate::shop::{Seat, Shop};

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

/// The driver does not answer: the stop is at the port anyway, and the next one is connected.
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

fn at_rest(shop: &Shop, board: &Board) -> Seat {
    let seat = shop.connect("wirebend-kit", Some(&board.port));
    seat.until_phase(Phase::Connected);
    seat
}

/// A board whose port is opened has forgotten where its head stands: the next window knows it, shows it, and has it turned
/// back.
#[test]
fn where_the_head_was_left_is_known_to_the_next_window() {
    let (shop, board) = (Shop::new(), Board::new(true));
    let seat = at_rest(&shop, &board);
    seat.order(&json!({"order": "home"}));
    seat.says(Answer::Yes);
    seat.until_phase(Phase::Ready);
    seat.operator.order(Order::Jog { moves: vec![Move::Rotate { deg: 30.0 }], record: false }).unwrap();
    seat.until(|event| matches!(event, OperatorEvent::Jogged { .. }).then_some(()));
    // Its cable allows a turn.
    seat.until_phase(Phase::Ready);
    seat.operator.order(Order::Jog { moves: vec![Move::Rotate { deg: 331.0 }], record: false }).unwrap();
    let (code, message) = seat.until_problem();
    assert!(code == "head-too-far" && message.contains("361.0°"), "{message}");
    seat.until_phase(Phase::Ready);
    drop(seat);

    let seat = at_rest(&shop, &board);
    seat.order(&json!({"order": "home"}));
    // A user who has turned it by hand meanwhile says so.
    let question = seat.says(Answer::Head(30.0));
    assert!(question.lines[0].contains("left at 30.0°"), "{question:?}");
    assert!((question.head.unwrap().left_at_deg.unwrap() - 30.0).abs() < 0.03);
    let question = seat.says(Answer::Yes);
    assert_eq!(question.kind, QuestionKind::Move);
    let told = question.lines.join("\n");
    assert!(told.contains("turned back to zero first") && told.contains("as you have said"), "{told}");
    let stands = |event: &OperatorEvent| match event {
        OperatorEvent::Machine(MachineEvent::Position(position)) => Some(position.rotate_deg),
        _ => None,
    };
    seat.until(|event| stands(event).filter(|deg| deg.abs() < 0.05));
}

/// Its record cannot be believed: a person looks, and what they say is counted. Nothing moves before that.
#[test]
fn where_nobody_knows_where_the_head_stands_a_person_is_asked() {
    let (shop, board) = (Shop::new(), Board::new(true));
    let seat = at_rest(&shop, &board);
    seat.order(&json!({"order": "home"}));
    seat.says(Answer::Yes);
    seat.until_phase(Phase::Ready);
    drop(seat);
    std::fs::write(shop.head_record(), "damaged").unwrap();

    let seat = at_rest(&shop, &board);
    for order in [json!({"order": "home"}), json!({"order": "jog", "moves": [{"move": "home"}]})] {
        seat.order(&order);
        let question = seat.until_question();
        let head = question.head.clone().unwrap();
        assert_eq!((question.kind, head.range_deg), (QuestionKind::Head, [-360.0, 360.0]));
        assert_eq!(head.left_at_deg, None);
        assert!(question.lines[0].contains("damaged"), "{question:?}");
        for wrong in [Answer::Yes, Answer::Head(361.0), Answer::Head(f64::NAN)] {
            assert_eq!(
                seat.operator.answer(question.id, wrong).unwrap_err().code(),
                "wrong-answer",
                "{wrong:?}"
            );
        }
        seat.operator.answer(question.id, Answer::No).unwrap();
        seat.until_phase(Phase::Connected);
    }
    seat.arm(&shop.cube("wirebend-kit"));
    // Its settings are all zero.
    assert_eq!(seat.until_problem().0, "settings-differ");
    seat.until_phase(Phase::Connected);
    seat.order(&json!({"order": "home"}));
    seat.says(Answer::Head(-45.0));
    let told = seat.says(Answer::Yes).lines.join("\n");
    assert!(told.contains("left at -45.0°"), "{told}");
    seat.until_phase(Phase::Ready);
    assert!(std::fs::read_to_string(shop.head_record()).unwrap().contains("0.0"), "it stands at zero now");
}

/// As long as a machine is connected, what it says of itself is part of every plan for it, the check of the window among them.
#[test]
fn what_a_connected_board_says_of_its_axes_is_planned_with() {
    let shop = Shop::new();
    let bender = Bender::new(Build { bend_travel: Some(60.0), bend_rate: Some(100.0), ..Build::default() });
    let check = || {
        let design = DesignInput::file(crate::shop::root().join("examples/u-sample.obj"));
        let choices = PlanChoices { machine: Some("grbl-bender".to_owned()), ..PlanChoices::default() };
        let request = CheckRequest { design, choices };
        let checked = wirebend_planning::plan::check(&shop.app, &request, &NoProgress).unwrap();
        serde_json::to_value(checked).unwrap()
    };
    let alone = check();
    assert_eq!(alone["feasible"], json!(true), "{alone:#}");
    let seat = shop.connect("grbl-bender", Some(&bender.port));
    seat.until_phase(Phase::Connected);
    let connected = check();
    let found = connected["diagnostics"].as_array().unwrap();
    let [first, second] = &found[..] else { panic!("{connected:#}") };
    for bend in [first, second] {
        assert_eq!(bend["code"], "bend_out_of_reach", "{connected:#}");
        let source = bend["limit_source"].as_str().unwrap();
        assert!(
            source.contains("$132") && source.contains(&format!("machine at {}", bender.port)),
            "{source}"
        );
    }
    drop(seat);
    assert_eq!(check(), alone, "it is not connected any more");
}
