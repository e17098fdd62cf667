//! A wire that can be started.

use wirebend_driver_host::Permit;
use wirebend_driver_host::api::DoneBy;

use super::state::WireState;
use crate::run::Task;

/// Wires to the first of which a person has said yes.
pub(super) struct ArmedWire<'a> {
    pub task: Task<'a>,
    /// The first.
    pub wire: usize,
    pub done_by: DoneBy,
    pub permit: Permit,
}

impl ArmedWire<'_> {
    /// Nothing of it is bent yet.
    pub fn state(&self) -> WireState {
        WireState::of(&self.task, self.wire, self.task.request.job.stem(), 0, self.done_by)
    }
}
