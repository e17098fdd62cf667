//! Profiles of machines, strut builders, materials and noise: what a machine can do and how a wire behaves, as data.
//!
//! One JSON file a profile. A file may inherit from one parent and then sets only what it changes;
//! every measured or published figure says where it comes from. A file that is wrong is refused
//! with its line, what was expected and what to do; nothing is guessed.
//!
//! Enter at [`Library`]: [`Library::shipped`] has the profiles inside the program,
//! [`Library::add_folder`] adds a person's own, [`Library::machine`] and its siblings resolve one,
//! [`Library::explain`] says which file set what, [`Library::child_text`] starts a new one.
//! The crate knows no stage of the pipeline: figures are plain `f64` with the unit in the key.
//!
//! ```
//! let library = wirebend_profile::Library::shipped()?;
//! let machine = library.machine("wirebend-kit")?;
//! let figures = machine.figures()?;
//! assert!((figures.limits.max_bend_deg - 155.0).abs() < 1e-9);
//! # Ok::<(), wirebend_profile::ProfileError>(())
//! ```

#![deny(missing_docs)]

mod check;
mod child;
mod error;
mod explain;
mod figures;
mod heading;
mod kind;
mod layer;
mod library;
mod machine;
mod material;
mod merge;
mod noise;
mod position;
mod profile;
mod resolve;
mod resolved;
mod rules;
mod schema;
mod shape;
mod shipped;
mod sourced;
mod strut_builder;

pub use check::{Checked, check_file, check_text};
pub use child::{Child, written};
pub use error::{Place, ProfileError};
pub use explain::{Ancestor, Explained, ExplainedValue, Overridden};
pub use figures::machine::{BendFigures, LimitFigures, MachineFigures};
pub use figures::strut_builder::{StrutBuilderFigures, WorkspaceFigures};
pub use figures::{Complete, ErrorFigures, MaterialFigures, NoiseFigures};
pub use kind::{Kind, MAX_FILE_BYTES, SCHEMA_VERSION, is_slug};
pub use library::{Added, Library, Listing};
pub use machine::{
    Bend, BendMethod, Compensation, Driver, Export, Feed, Limits, MachineProfile, MachineTag, Rotate, Signs,
    Time, Wire,
};
pub use material::{LossPoint, MaterialProfile, MaterialTag, Springback};
pub use merge::Origin;
pub use noise::{AngleError, LengthError, NoiseProfile, NoiseTag, RatioError};
pub use profile::{Profile, to_text};
pub use resolved::Resolved;
pub use schema::{schema, schema_files};
pub use shape::{Part, Shape, Solid};
pub use sourced::{Noted, Reference, Sign, Sourced};
pub use strut_builder::{
    ApproachAngles, BuildSpeed, HeadDirections, HeadPoint, StrutBuilderProfile, StrutBuilderTag,
    StrutProcess, ToolHead, Workspace,
};
