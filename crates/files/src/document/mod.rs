//! The project documents: `.wirebend`, which is edited, and `.wbjob`, which never changes.
//!
//! Both are JSON with a format, a version and no unknown keys; each value type here is also the
//! source of a JSON Schema under `schema/`.

mod change;
mod change_file;
mod collision;
mod construction;
mod error;
mod hash;
mod ids;
mod job;
mod joint;
mod layout;
mod look;
mod packed;
mod part;
mod pause;
mod project;
mod save;
mod schema;
mod snapshot;
mod stencil;
mod version;
mod walk;
mod wireframe;

pub use change::{DocumentChange, Replaced, StaleChange};
pub use collision::{Clearance, CollisionSettings};
pub use construction::ConstructionLine;
pub use error::DocumentError;
pub use hash::sha256_hex;
pub use ids::{Pin, PinTarget, StencilId};
pub use job::{Job, JobContents, JobStep, JobWire};
pub use joint::{JointFile, JointKindFile};
pub use look::{Colour, Look, NoColour};
pub use part::PartLook;
pub use pause::{JobPause, PausePoint, pause_note};
pub use project::{Document, SourceFile, WireCount};
pub use save::save_atomically;
pub use schema::schemas;
pub use snapshot::ProfileSnapshot;
pub use stencil::{PlacedStencil, PlacementFile, StencilSource};
pub(crate) use version::without_place;
pub use walk::Walk;
