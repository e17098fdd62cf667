//! The wire that moves by hand bend, followed by what the machine reports.

use wirebend_driver_host::Phase;

use super::event::OperatorEvent;
use super::shared::Shared;
use super::shared_state::SharedState;
use crate::by_hand::WireByHand;
use crate::{MachineEvent, Move};

impl Shared {
    /// A move by hand begins.
    pub fn begin_move(&self, one: Move) {
        let mut kept = self.lock();
        let position = kept.state.position;
        kept.by_hand.begin(one, position);
    }

    pub fn by_hand(&self) -> WireByHand {
        self.lock().by_hand.clone()
    }
}

impl SharedState {
    /// Follows what is reported.
    pub fn follow_by_hand(&mut self, event: &OperatorEvent) {
        match event {
            OperatorEvent::State(state) => match state.phase {
                // They begin with a wire of their own, or without any.
                Phase::Connecting | Phase::Homing | Phase::Making | Phase::Closed => self.by_hand.forget(),
                Phase::Moving => {}
                _ if state.busy => {}
                _ => self.by_hand.interrupt(),
            },
            OperatorEvent::Machine(MachineEvent::Position(position)) => self.by_hand.position(*position),
            OperatorEvent::Jogged { made } => self.by_hand.made(*made),
            _ => {}
        }
    }
}
