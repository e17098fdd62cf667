use wirebend_driver_api::Capability;

use super::*;
use crate::session::OrderName;

/// An order, and whether it begins with homing.
#[derive(Debug, PartialEq)]
struct Order(OrderName, bool);

impl ActorOrder for Order {
    fn name(&self) -> OrderName {
        self.0
    }

    fn wish(&self) -> Option<Wish> {
        match self.0 {
            OrderName::Pause => Some(Wish::Pause),
            OrderName::Resume => Some(Wish::Resume),
            OrderName::Speed => Some(Wish::Speed(50)),
            _ => None,
        }
    }

    fn homes_first(&self) -> bool {
        self.1
    }
}

fn snapshot(phase: Phase, stops: u64) -> Snapshot {
    let abilities = [Capability::Home, Capability::Jog].into_iter().collect();
    let orders = Orders::of(phase, &abilities, ReferenceBy::Machine);
    Snapshot {
        phase,
        simulated: false,
        identity: "kit".to_owned(),
        position: None,
        speed_percent: None,
        wire: None,
        orders,
        stops,
    }
}

fn at_rest(phase: Phase) -> ActorState<Order> {
    let mut state = ActorState::connecting();
    state.rest(Some(&snapshot(phase, 0)));
    state
}

fn why_not(state: &mut ActorState<Order>, order: OrderName) -> Option<Because> {
    state.take_order(Order(order, false)).err().map(|refused| refused.because)
}

/// Were it still to be carried out, a machine would move because of what was said before it was stopped.
#[test]
fn a_stop_throws_away_what_was_ordered() {
    let mut state = at_rest(Phase::Ready);
    assert_eq!(why_not(&mut state, OrderName::Home), None);
    state.wish = Some(Wish::Resume);
    state.stop_begins(0);
    assert_eq!((state.order.take(), state.wish, state.phase()), (None, None, Phase::Stopping));
    assert_eq!(why_not(&mut state, OrderName::Home), Some(Because::Stopping));
}

/// A person puts their hands in the machine by what they read.
#[test]
fn what_was_seen_before_a_stop_does_not_count_after_it() {
    let mut state = at_rest(Phase::Ready);
    assert_eq!(why_not(&mut state, OrderName::Home), None);
    state.publish(&snapshot(Phase::Homing, 0));
    assert_eq!(state.phase(), Phase::Homing);
    state.stop_begins(0);
    state.publish(&snapshot(Phase::Homing, 0));
    assert_eq!(state.phase(), Phase::Stopping, "it was seen before the stop");
    state.publish(&snapshot(Phase::Stopped, 1));
    assert_eq!((state.phase(), state.busy()), (Phase::Stopped, true));
    state.publish(&snapshot(Phase::Moving, 1));
    assert_eq!(state.phase(), Phase::Stopped, "what is left of the order moves nothing");
    assert_eq!(why_not(&mut state, OrderName::Home), Some(Because::Busy));
    state.stop_begins(1);
    state.rest(Some(&snapshot(Phase::Stopped, 1)));
    assert_eq!(state.phase(), Phase::Stopping, "there is another stop");
    state.rest(Some(&snapshot(Phase::Stopped, 2)));
    assert_eq!((state.phase(), state.busy()), (Phase::Stopped, false));
    assert_eq!(why_not(&mut state, OrderName::Home), None);
}

/// Between two pieces of a row nothing moves, and the next one would be begun.
#[test]
fn an_order_between_two_motions_has_to_be_stopped() {
    let mut state = at_rest(Phase::Ready);
    assert!(!state.is_at_work());
    assert_eq!(why_not(&mut state, OrderName::Home), None);
    assert!(state.order.take().is_some());
    for phase in [Phase::Ready, Phase::Homing, Phase::Armed] {
        state.publish(&snapshot(phase, 0));
        assert!(state.is_at_work(), "{phase:?}");
    }
    state.rest(Some(&snapshot(Phase::Ready, 0)));
    assert!(!state.is_at_work());
}

#[test]
fn one_order_is_carried_out_at_a_time() {
    let mut state = at_rest(Phase::Ready);
    assert_eq!(why_not(&mut state, OrderName::Home), None);
    assert_eq!(why_not(&mut state, OrderName::Jog), Some(Because::Busy));
    // What says more of it comes first.
    assert_eq!(why_not(&mut state, OrderName::Start), Some(Because::NoWireArmed));
    assert_eq!(state.view().orders.why_not(OrderName::Jog), Some(Because::Busy));
    state.publish(&snapshot(Phase::Homing, 0));
    assert_eq!(state.view().orders.why_not(OrderName::Jog), Some(Because::Homing));
    assert_eq!(why_not(&mut state, OrderName::Jog), Some(Because::Homing));
}

#[test]
fn nothing_is_taken_while_a_person_is_asked_nor_after_the_end() {
    let mut state = at_rest(Phase::Ready);
    state.question_open = true;
    assert_eq!(why_not(&mut state, OrderName::Home), Some(Because::QuestionOpen));
    state.end(Phase::Closed);
    assert_eq!(why_not(&mut state, OrderName::Home), Some(Because::NotConnected));
    assert_eq!(state.view().orders, Orders::none(Because::NotConnected));
}

#[test]
fn what_begins_with_homing_needs_none_before() {
    let mut state = at_rest(Phase::Connected);
    assert_eq!(why_not(&mut state, OrderName::Jog), Some(Because::NotHomed));
    assert_eq!(state.take_order(Order(OrderName::Jog, true)), Ok(()));
    assert_eq!(state.order, Some(Order(OrderName::Jog, true)));
}

/// They are for the order that is being carried out.
#[test]
fn pausing_and_resuming_wait_for_no_order() {
    for (phase, order, wish) in [
        (Phase::Making, OrderName::Pause, Wish::Pause),
        (Phase::Holding, OrderName::Resume, Wish::Resume),
        (Phase::Making, OrderName::Speed, Wish::Speed(50)),
        (Phase::Holding, OrderName::Speed, Wish::Speed(50)),
    ] {
        let mut state = ActorState::<Order>::connecting();
        let mut snapshot = snapshot(phase, 0);
        let abilities = [Capability::Pause, Capability::Resume, Capability::Speed].into_iter().collect();
        snapshot.orders = Orders::of(phase, &abilities, ReferenceBy::Machine);
        state.publish(&snapshot);
        assert_eq!(why_not(&mut state, order), None);
        assert_eq!((state.order.is_none(), state.busy()), (true, true));
        assert_eq!((state.take_wish(), state.take_wish()), (Some(wish), None));
    }
}

/// A pause that another speed took the place of would be lost.
#[test]
fn another_speed_takes_the_place_of_no_pause() {
    let mut state = ActorState::<Order>::connecting();
    let mut snapshot = snapshot(Phase::Making, 0);
    let abilities = [Capability::Pause, Capability::Speed].into_iter().collect();
    snapshot.orders = Orders::of(Phase::Making, &abilities, ReferenceBy::Machine);
    state.publish(&snapshot);
    for order in [OrderName::Pause, OrderName::Speed] {
        assert_eq!(why_not(&mut state, order), None);
    }
    let taken = [state.take_wish(), state.take_wish(), state.take_wish()];
    assert_eq!(taken, [Some(Wish::Pause), Some(Wish::Speed(50)), None]);
}
