//! Exit statuses.

pub const DONE: u8 = 0;
/// Wrong use.
pub const USAGE: u8 = 2;
pub const BAD_INPUT: u8 = 3;
/// Not feasible on this machine.
pub const NOT_FEASIBLE: u8 = 4;
/// Machine, driver or computer failure.
pub const FAILURE: u8 = 5;
/// A machine was stopped, or its driver was lost, and the machine has not confirmed that it stands.
pub const MAY_MOVE: u8 = 6;
/// Stopped by the person.
pub const STOPPED: u8 = 130;
