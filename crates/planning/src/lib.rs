//! From a document and profiles to checks, plans, comparisons, simulations and exports.
//!
//! The only bridge from profiles to the stages of `wirebend-core`, and from the stages to jobs of drivers. Every
//! function takes the [`Installation`] and plain values; nothing is kept from one call to the next.

#![allow(clippy::missing_errors_doc, clippy::must_use_candidate, reason = "not published")]

pub mod as_given;
pub mod bodies;
pub mod calibrate;
pub mod catalogue;
pub mod choices;
pub mod collisions;
pub mod compare;
mod contacts;
pub mod curves;
pub mod design;
pub mod drivers;
pub mod dump;
pub mod error;
pub mod export;
pub mod frame;
pub mod generate;
pub mod import;
pub mod installation;
pub mod job;
pub mod machine;
pub mod misnamed;
pub mod output;
pub mod pauses;
pub mod picture;
pub mod plan;
pub mod playback;
pub mod profiles;
pub mod program;
pub mod progress;
pub mod report;
pub mod sequence;
pub mod signs;
pub mod simulate;
pub mod stage;
pub mod stencil;
pub mod text;
mod turning_back;
pub mod wires;

pub use choices::PlanChoices;
pub use contacts::collision_margin;
pub use curves::{CurvesReport, MachineEdges, ShortestEdge};
pub use design::{DesignInput, Input};
pub use error::{DriverProblem, ErrorKind, PlanningError, StencilFileError};
pub use export::ExportFormat;
pub use installation::{DriverFolders, Installation};
pub use output::Output;
pub use progress::{BestSoFar, FoundSoFar, NoProgress, Progress};
pub use report::{DiagnosticReport, JobStep, NoteReport, PartOfStep, PlanReport, shown_deg};
pub use stage::StageName;
