//! Finds machine drivers, verifies them, runs each in a process of its own, and keeps the session with a
//! machine.
//!
//! Enter at [`DriverRegistry::look`] (which drivers there are), [`Driver::start`] (one of them, running) and
//! [`Session::connect`] (a machine). What a driver does to itself (a crash, a hang, a flood, a leak)
//! ends its process and becomes a [`HostError`]; nothing else is touched by it.
//!
//! An [`Actor`] has the thread of a machine that stays connected: it takes orders one at a time, and says how the machine stands.
//! [`jobs`] runs a wire through a session and keeps a journal of it, so that an interruption of whatever kind
//! costs no more than looking at a few steps.
//!
//! A program that uses this crate gives its own executable as the process of a driver: it hands the
//! arguments after [`CHILD_COMMAND`] to [`child_main`] before it does anything else.

mod actor;
mod child;
mod confine;
mod driver;
mod ending;
mod error;
mod frame;
pub mod jobs;
mod library;
mod process;
mod registry;
mod session;
mod trust;

pub use actor::{Actor, ActorClient, ActorOrder, ActorView, Next, NotTaken, Wish};
pub use child::child_main;
pub use driver::{Driver, Examined, Launch, OpenDriver};
pub use error::{HostError, advice_of, report_of};
pub use registry::{DiscoveredDriver, DriverRegistry, LibraryRefusal, Place, Places, TrustStatus};
pub use session::{
    Armed, Because, Confirmation, HeadKeeper, HeadPlace, OrderName, Orders, Permit, PermitKind,
    PermitRequest, Phase, RefusedOrder, Session, SessionError, Simulation, Snapshot, Standstill, StopHandle,
    StopLine, StopLineError, StopOutcome, StoppedBy, WireProgress,
};
pub use trust::{Fingerprint, TrustError, TrustStore};

/// What drivers and this program say to each other.
pub use wirebend_driver_api as api;

/// The first argument of a process that is a driver's.
pub const CHILD_COMMAND: &str = "driver-child";
