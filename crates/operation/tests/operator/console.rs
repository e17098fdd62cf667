//! Lines that a person types for a machine.

use serde_json::json;
use wirebend_operation::{
    Answer, Because, MachineEvent, OperatorEvent, Order, OrderName, Phase, QuestionKind, RefusedOrder,
};

use crate::bender::Bender;
use crate::shop::{Seat, Shop, arm};

fn typed(line: &str) -> Order {
    Order::Console { line: line.to_owned() }
}

/// What is sent for a line and answered, until the machine is done with it. Nobody is asked.
fn said(seat: &Seat, line: &str) -> Vec<(bool, String)> {
    seat.operator.order(typed(line)).unwrap();
    let mut said = Vec::new();
    loop {
        match seat.next() {
            OperatorEvent::Machine(MachineEvent::Console { to_machine, text }) => {
                said.push((to_machine, text));
            }
            OperatorEvent::State(state) if !state.busy => return said,
            OperatorEvent::Question(asked) => panic!("{asked:?}"),
            _ => {}
        }
    }
}

#[test]
fn a_question_is_answered_and_the_machine_stays_homed() {
    let (shop, bender) = (Shop::new(), Bender::without_switches());
    let seat = shop.connect("grbl-bender", Some(&bender.port));
    seat.until_phase(Phase::Connected);
    let lines = said(&seat, "$#");
    let texts: Vec<&str> = lines.iter().map(|(_, text)| text.as_str()).collect();
    assert_eq!(texts, ["$#", "[G54:0.000,0.000,0.000]", "[PRB:0.000,0.000,0.000:0]", "ok"]);
    assert_eq!(lines.iter().map(|(to, _)| *to).collect::<Vec<_>>(), [true, false, false, false]);
    assert_eq!(seat.operator.state().phase, Phase::Connected);
    let lines = said(&seat, "?");
    assert!(lines.iter().any(|(to, text)| !to && text.starts_with("<Idle|")), "{lines:?}");
}

/// Were it not asked, a line that somebody tries out would move a machine in which there are hands; were the machine taken to be
/// where it was, the next wire would begin elsewhere.
#[test]
fn what_may_move_is_asked_about_each_time_and_the_machine_is_homed_again() {
    let (shop, bender) = (Shop::new(), Bender::without_switches());
    let seat = shop.connect("grbl-bender", Some(&bender.port));
    seat.until_phase(Phase::Connected);
    seat.order(&json!({"order": "home"}));
    seat.says(Answer::Yes);
    seat.until_phase(Phase::Ready);
    for turn in 1..=2 {
        seat.operator.order(typed("G91 G1 Z5 F500")).unwrap();
        let asked = seat.until_question();
        assert_eq!(asked.kind, QuestionKind::Console);
        assert!(asked.lines.iter().any(|line| line == "line: G91 G1 Z5 F500"), "{asked:?}");
        seat.operator.answer(asked.id, Answer::Yes).unwrap();
        let state = seat.until_phase(Phase::Connected);
        let at = state.position.unwrap().bend_deg;
        assert!((at - f64::from(5 * turn)).abs() < 0.1, "{at}");
    }
    let state = seat.operator.state();
    assert!(state.can.contains(&OrderName::Home) && state.can.contains(&OrderName::Console));
    // What is said of zero counts again, and no is no.
    seat.operator.order(typed("G91 G1 Z-5 F500")).unwrap();
    seat.says(Answer::No);
    seat.until_phase(Phase::Connected);
    assert_eq!(bender.stands(), "[0.000, 0.000, 10.000]");
}

#[test]
fn what_the_driver_does_not_pass_on_is_said_and_the_machine_stays_as_it_is() {
    let shop = Shop::new();
    let seat = shop.simulated("sim:max");
    seat.home();
    for (line, words) in
        [("M1,100,0,0", "numbers the lines"), ("", "empty"), ("C4\u{7f}", "control"), ("größe", "ASCII")]
    {
        seat.operator.order(typed(line)).unwrap();
        let (code, message) = seat.until_problem();
        assert_eq!(code, "driver-refused", "{line}");
        assert!(message.contains(words), "{line}: {message}");
        assert_eq!(seat.until_state(|state| !state.busy).phase, Phase::Ready);
    }
    let lines = said(&seat, "version");
    assert!(lines.iter().any(|(to, text)| !to && text.starts_with('o')), "{lines:?}");
    let lines = said(&seat, "status");
    let letters: Vec<char> = lines.iter().filter_map(|(_, text)| text.chars().next()).collect();
    assert_eq!(letters, ['Q', 't']);
    assert_eq!(seat.operator.state().phase, Phase::Ready);
    // A setting that is stored is one that differs from the profile's, until the machine is set again.
    let lines = said(&seat, "W4,1500");
    assert!(lines.contains(&(false, "v4,1500".to_owned())), "{lines:?}");
    let state = seat.operator.state();
    assert_eq!(state.phase, Phase::Connected);
    assert!(state.settings.iter().any(|one| one.name.contains("feed_rate")), "{:?}", state.settings);
}

#[test]
fn nothing_is_typed_while_a_wire_is_armed_or_bent() {
    let shop = Shop::new();
    let seat = shop.simulated("sim:10");
    let because = |seat: &Seat| {
        let cannot = seat.operator.state().cannot;
        let refused = cannot.into_iter().find(|RefusedOrder { order, .. }| *order == OrderName::Console);
        refused.map(|refused| refused.because)
    };
    assert_eq!(because(&seat), None);
    seat.operator.order_wire(arm(0, false), shop.cube("wirebend-kit")).unwrap();
    seat.says(Answer::Yes);
    seat.until_phase(Phase::Armed);
    assert_eq!(because(&seat), Some(Because::WireArmed));
    assert_eq!(seat.refused(typed("status")).0, "not-now");
    seat.order(&json!({"order": "start"}));
    seat.until_phase(Phase::Making);
    assert_eq!(because(&seat), Some(Because::WireUnderWay));
    assert!(seat.operator.stop());
    seat.until_phase(Phase::Stopped);
    assert_eq!(said(&seat, "status").len(), 2, "after a stop, too");
}
