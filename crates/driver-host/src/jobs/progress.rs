//! What the loop tells whoever calls it.

use std::time::Duration;

use wirebend_driver_api::{Direction, DriverError, PausedBy, Step};

use super::account::Standing;
use crate::session::{State, StoppedBy};

/// Something that happened, in order.
#[derive(Debug, Clone, PartialEq)]
pub enum Progress {
    /// Steps up to this one were taken by the driver.
    Sent {
        /// The last.
        n: u32,
    },
    /// A step was made.
    Made {
        /// Which.
        n: u32,
        /// How many the wire has.
        of: u32,
    },
    /// Where the axes are, in the machine's signs.
    Position(Step),
    /// A line to or from the machine.
    Console {
        /// Which way it went.
        direction: Direction,
        /// The line.
        text: String,
    },
    /// Something that a person should know and that ends nothing.
    Warning(DriverError),
    /// The machine holds.
    Paused {
        /// Why.
        by: PausedBy,
    },
    /// The machine goes on.
    Resumed,
    /// The wire as a simulated machine made it, mm, in the frame of the turtle at its start.
    Wire {
        /// Points along its middle.
        wire_mm: Vec<[f64; 3]>,
        /// Its ends and corners.
        corners_mm: Vec<[f64; 3]>,
    },
    /// The wire is made. The last that is told.
    Finished,
    /// A stop was sent, or the machine was stopped at the machine itself.
    Stopped {
        /// Who brought it about; `None` for the machine itself.
        by: Option<StoppedBy>,
    },
    /// What came of a stop, or of the stop that follows the loss of a driver. The last that is told.
    Standstill {
        /// Whether the machine has confirmed that it stands.
        confirmed: bool,
    },
    /// The run is over, or takes no more steps; what was sent before may still be made, and is told.
    Fault {
        /// What happened and what to do.
        error: DriverError,
        /// The steps of which nobody knows whether they were made: the first and the last.
        in_doubt: Option<(u32, u32)>,
    },
}

/// How a wire stands, at a moment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Overview {
    /// How many steps the wire has.
    pub of: u32,
    /// The last that the driver has taken.
    pub sent: u32,
    /// The last that was made.
    pub made: u32,
    /// Since this run was begun, with pauses.
    pub elapsed: Duration,
    /// What is estimated to be left, without pauses.
    pub remaining: Duration,
    /// The state of the session.
    pub state: State,
    /// What was written down last.
    pub standing: Standing,
}
