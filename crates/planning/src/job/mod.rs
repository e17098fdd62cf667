//! Jobs: whether a file is one, and what drivers and sessions are given of it.

mod collisions;
mod driver;
mod work;

use std::path::Path;

use wirebend_files::document::Job;
use wirebend_files::read::decode;

use crate::error::PlanningError;

pub use collisions::JobCollisions;
pub(crate) use collisions::contact_options;
pub(crate) use collisions::scheduled;
pub use driver::{Stages, job};
pub use work::{SimulatedAs, opened, work};

/// Whether bytes are a job: by name, or by the mark that every job has near its start.
pub fn is_job(name: &str, bytes: &[u8]) -> bool {
    let start = decode(&bytes[..bytes.len().min(4096)]);
    Path::new(name).extension().is_some_and(|extension| extension.eq_ignore_ascii_case("wbjob"))
        || (start.trim_start().starts_with('{') && start.contains("\"wbjob\""))
}

/// Opens a job; its hash has to fit.
pub fn open_job(name: &str, bytes: &[u8]) -> Result<Job, PlanningError> {
    // Of nothing at all its name says enough.
    if !is_job(name, bytes) && !decode(bytes).trim().is_empty() {
        return Err(PlanningError::NotAJob { name: name.to_owned() });
    }
    Ok(Job::open(bytes, name)?)
}
