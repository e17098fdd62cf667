//! A machine without switches: what a person says of where its axes stand holds until the place is lost.

use serde_json::json;
use wirebend_operation::{Answer, Move, OperatorEvent, Order, OrderName, Phase, QuestionKind};

use crate::bender::Bender;
use crate::grbl_model::Model;
use crate::shop::{Seat, Shop};

const ZERO: &str = "Does every axis stand at zero?";

fn connected(shop: &Shop, bender: &Bender) -> Seat {
    let seat = shop.connect("grbl-bender", Some(&bender.port));
    seat.until_phase(Phase::Connected);
    seat
}

/// Stopped in the middle of the first bend.
fn stopped_in_a_bend(seat: &Seat, bender: &Bender) {
    seat.until(|_| (bender.model.now().pin_out && bender.model.now().at[2] > 30.0).then_some(()));
    assert!(seat.operator.stop());
    seat.until_phase(Phase::Stopped);
}

#[track_caller]
fn asked(seat: &Seat, question: &str, answer: Answer) {
    let asked = seat.until_question();
    assert_eq!(asked.question, question, "{asked:?}");
    seat.operator.answer(asked.id, answer).unwrap();
}

/// Homing moves nothing, so that the user is not asked whether something may move; but each time where the axes stand.
#[test]
fn a_person_is_asked_each_time_that_the_place_is_lost() {
    let (shop, bender) = (Shop::new(), Bender::without_switches());
    let seat = connected(&shop, &bender);
    seat.order(&json!({"order": "home"}));
    asked(&seat, ZERO, Answer::No);
    seat.until_phase(Phase::Connected);
    seat.order(&json!({"order": "home"}));
    let question = seat.says(Answer::Yes);
    assert_eq!((question.kind, question.question.as_str()), (QuestionKind::Move, ZERO));
    assert!(question.lines.iter().any(|line| line.contains("nothing moves for this")), "{question:?}");
    seat.until_phase(Phase::Ready);
    // A yes to where the axes stand is none to a move.
    seat.operator.order(Order::Jog { moves: vec![Move::Bend { deg: 10.0 }], record: false }).unwrap();
    asked(&seat, "May the machine move?", Answer::Yes);
    seat.until(|event| matches!(event, OperatorEvent::Jogged { .. }).then_some(()));
    seat.until_phase(Phase::Ready);
    assert_eq!(bender.stands(), "[0.000, 0.000, 10.000]");
    // It is not at zero any more: before a wire they are asked again.
    seat.start(&shop.job("u-sample.obj", "grbl-bender"));
    asked(&seat, ZERO, Answer::No);
    seat.until_phase(Phase::Ready);
    assert_eq!(bender.stands(), "[0.000, 0.000, 10.000]", "something has moved");
}

/// The axes are brought back to zero by jogging, and not taken to be there before a person has said so.
#[test]
fn after_a_stop_the_axes_can_be_jogged_back_and_the_wire_goes_on() {
    let (shop, bender) = (Shop::new(), Bender::without_switches());
    let seat = connected(&shop, &bender);
    let job = shop.job("u-sample.obj", "grbl-bender");
    seat.start(&job);
    asked(&seat, ZERO, Answer::Yes);
    stopped_in_a_bend(&seat, &bender);
    let stopped = bender.stands();
    assert!(seat.operator.state().can.contains(&OrderName::Jog), "{:?}", seat.operator.state());
    seat.resume(&job);
    // Feed and head have done their part: the machine knows what is left.
    asked(&seat, "May the machine move and resume?", Answer::Yes);
    asked(&seat, ZERO, Answer::No);
    seat.until_phase(Phase::Stopped);
    assert_eq!(bender.stands(), stopped, "something has moved");
    // The bend axis is jogged back, by the position that it was sent to.
    let moves = vec![Move::Bend { deg: -bender.model.now().at[2] }];
    seat.operator.order(Order::Jog { moves, record: false }).unwrap();
    asked(&seat, "May the machine move?", Answer::Yes);
    asked(&seat, "May these moves count from where the axes stand now?", Answer::Yes);
    seat.until_phase(Phase::Ready);
    let [_, rotated, bent] = bender.model.now().at;
    // The first bend of a U needs no rotation. Half a step of the model.
    assert!(rotated.abs() < 0.007 && bent.abs() < 0.007, "{}", bender.stands());
    seat.resume(&job);
    asked(&seat, "May the machine move and resume?", Answer::Yes);
    asked(&seat, ZERO, Answer::Yes);
    let wire = seat.until_run().wires.remove(0);
    assert_eq!(wire.made, wire.steps, "{wire:?}");
    seat.until_phase(Phase::Ready);
    let bends = bender.model.end().bends;
    assert!(bends.iter().all(|[_, _, bend]| bend.abs() <= 120.0), "{bends:?}");
}

/// What a person said before an alarm, or before the board has started anew, says nothing of where the axes stand after it.
#[test]
fn an_alarm_and_a_board_that_starts_anew_lose_the_place() {
    for happens in [Model::hit_limit, Model::cut_power] {
        let (shop, bender) = (Shop::new(), Bender::without_switches());
        let seat = connected(&shop, &bender);
        let job = shop.job("u-sample.obj", "grbl-bender");
        seat.start(&job);
        asked(&seat, ZERO, Answer::Yes);
        seat.until(|_| (bender.model.now().pin_out && bender.model.now().at[2] > 30.0).then_some(()));
        happens(&bender.model);
        seat.until_problem();
        seat.until_phase(Phase::Failed);
        let stands = bender.stands();
        seat.resume(&job);
        let doubt = seat.until_question();
        seat.operator.answer(doubt.id, Answer::NotMade).unwrap();
        asked(&seat, "May the machine move and resume?", Answer::Yes);
        asked(&seat, ZERO, Answer::No);
        seat.until_phase(Phase::Connected);
        assert_eq!(bender.stands(), stands, "something has moved");
    }
}
