//! Finds machine drivers, verifies them, runs each in a process of its own, and keeps the session with a
//! machine.
//!
//! Enter at [`Shelf::look`] (which drivers there are), [`Driver::start`] (one of them, running) and
//! [`Session::connect`] (a machine). What a driver does to itself (a crash, a hang, a flood, a leak)
//! ends its process and becomes a [`HostError`]; nothing else is touched by it.
//!
//! [`jobs`] makes a wire through a session and keeps a journal of it, so that an interruption of whatever kind
//! costs no more than looking at a few steps.
//!
//! A program that uses this crate gives its own executable as the process of a driver: it hands the
//! arguments after [`CHILD_COMMAND`] to [`child_main`] before it does anything else.

mod child;
mod confine;
mod driver;
mod ending;
mod error;
mod frame;
pub mod jobs;
mod library;
mod process;
mod session;
mod shelf;
mod trust;

pub use child::child_main;
pub use driver::{Driver, Examined, Launch, OpenDriver};
pub use error::HostError;
pub use session::{
    Armed, Asked, Confirmed, HeadKeeper, HeadPlace, Purpose, Session, SessionError, Standstill, State,
    StopHandle, StopLine, StopLineError, StopOutcome, StoppedBy,
};
pub use shelf::{Found, Place, Places, Shelf, Verdict};
pub use trust::{Fingerprint, TrustError, TrustStore};

/// What drivers and this program say to each other.
pub use wirebend_driver_api as api;

/// The first argument of a process that is a driver's.
pub const CHILD_COMMAND: &str = "driver-child";
