//! What the loop reports to its caller.

use std::time::Duration;

use wirebend_driver_api::{Direction, DriverError, PausedBy, Step};
use wirebend_error::ErrorRemedy;

use super::journal_state::JobState;
use crate::session::{Phase, StoppedBy};

/// Something that happened, in order.
#[derive(Debug, Clone, PartialEq)]
pub enum Progress {
    /// Steps up to this one were taken by the driver.
    Sent {
        /// The last.
        n: u32,
    },
    /// A step is done.
    Made {
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
    Paused { by: PausedBy },
    /// The machine resumes.
    Resumed,
    /// The wire as a simulated machine bent it, mm, in the frame of the turtle at its start.
    Wire {
        /// Points along its middle.
        wire_mm: Vec<[f64; 3]>,
        /// Its ends and corners.
        corners_mm: Vec<[f64; 3]>,
    },
    /// The wire is finished. The last that is reported.
    Finished,
    /// A stop was sent, or the machine was stopped at the machine itself.
    Stopped {
        /// What caused it; `None` for the machine itself.
        by: Option<StoppedBy>,
    },
    /// What came of a stop, or of the stop that follows the loss of a driver. The last that is reported.
    Standstill {
        /// Whether the machine has confirmed that it stands.
        confirmed: bool,
    },
    /// The run is over, or takes no more steps; what was sent before may still be run, and is reported.
    Fault {
        error: DriverError,
        /// What can be done about it.
        remedies: Vec<ErrorRemedy>,
        /// The steps in doubt, of which it is not known whether they were done: the first and the last.
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
    /// The last that is done.
    pub made: u32,
    /// How long the machine was at work on it, in all of its parts, without pauses.
    pub elapsed: Duration,
    /// What is estimated to be left, without pauses.
    pub remaining: Duration,
    /// What the machine is in.
    pub phase: Phase,
    /// What was written down last.
    pub standing: JobState,
}
