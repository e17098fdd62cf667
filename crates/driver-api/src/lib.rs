//! The boundary between the program and its machine drivers.
//!
//! A driver is a shared library with one exported C function, [`ENTRY_SYMBOL`], that returns a
//! [`Table`]. Everything that crosses the boundary is JSON: a [`Description`], settings, a [`Call`]
//! with its reply, an [`Event`]. `include/wirebend_driver.h` says the same for C, and `schema/` holds
//! the JSON Schema of every message.
//!
//! In Rust a driver implements [`MachineDriver`] (and [`MachineSession`] when it moves a machine) and
//! ends with [`export_driver!`]; nothing in it is unsafe. [`conformance`] reports whether it keeps the
//! rules.
//!
//! Lengths are millimetres, angles degrees. Which way is positive: see [`Step`].
//!
//! **Threads.** The program runs every driver in a process of its own and calls it from one thread, one
//! function at a time. A driver may have threads of its own.
//!
//! **Time.** A call starts something and returns; what becomes of it comes by `poll`. Only `encode` may
//! take long. Deadlines are in [`deadline`]; a driver that misses one is ended.

#![deny(missing_docs)]

mod abi;
mod bench;
mod call;
pub mod conformance;
mod console;
pub mod deadline;
mod description;
mod dispatch;
mod driver;
mod error;
mod event;
mod glue;
mod job;
mod limits;
mod number;
mod port;
mod schemas;
#[cfg(feature = "serial")]
pub mod serial;
mod table;
#[cfg(feature = "transcript")]
pub mod transcript;

pub use abi::{ABI_MAJOR, ABI_MINOR, Buffer, Bytes, ENTRY_SYMBOL, Entry, OK, REFUSED, Table};
pub use bench::{Bench, BenchBender, BenchNoise, BenchWire, Spread};
pub use call::{
    ArmedReply, Axis, Batch, Call, Encode, Encoded, EncodedFile, Motion, Note, NumberedStep, Run, SPEEDS,
    Sent,
};
pub use console::{ConsoleLine, LONGEST_CONSOLE_LINE};
pub use description::{Capability, Content, Description, Files, FormatDescription};
pub use driver::{MachineDriver, MachineSession};
pub use error::DriverError;
pub use event::{Direction, DoneBy, Event, HeadBy, PausedBy, ReferenceBy, ResumeState, SettingCheck};
pub use glue::table;
pub use job::{DesignStep, Job, MachineRef, MaterialRef, Step, Wire};
pub use limits::{AxisLimit, AxisRate, Beyond, Extent, Lack, Limits};
pub use number::{fixed, is_zero};
pub use port::{Port, Ports, Usb};
pub use schemas::message_schemas;
pub use table::{Reply, SafeTable, TableError};

/// What the expansion of [`export_driver!`] needs.
#[doc(hidden)]
pub use dispatch::describe_json;
