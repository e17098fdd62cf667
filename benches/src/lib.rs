//! What the benchmarks are run on and compared with.

pub mod bender;
pub mod frames;

use std::time::Instant;

use anyhow::{Context, Result};
use wirebend_core::plan::Machine;
use wirebend_core::wireframe::Wireframe;
use wirebend_files::read::{Format, ReadOptions, read};
use wirebend_planning::machine::Setup;
use wirebend_profile::Library;

/// The machine of the WireBend-kit paper with the wire that it usually bends.
///
/// # Errors
/// When it does not ship.
pub fn machine() -> Result<Machine> {
    let library = Library::shipped()?;
    let machine = library.machine("wirebend-kit")?;
    let material = library.material(machine.profile.default_material.as_deref().context("a material")?)?;
    Ok(Setup::new(machine, material)?.model)
}

/// A design of `examples/`. `faces`: the edges of its faces are meant.
///
/// # Errors
/// When it cannot be read.
pub fn design(name: &str, faces: bool) -> Result<Wireframe> {
    let path = format!("{}/../examples/{name}.obj", env!("CARGO_MANIFEST_DIR"));
    let bytes = std::fs::read(&path).with_context(|| path.clone())?;
    let options = ReadOptions { face_edges: faces, ..ReadOptions::default() };
    Ok(read(&bytes, name, Some(Format::Obj), &options)?.wireframe)
}

/// The median of so many runs, in milliseconds, and what the last gave.
///
/// # Errors
/// Those of the work.
pub fn timed<T>(runs: usize, mut work: impl FnMut() -> Result<T>) -> Result<(f64, T)> {
    let mut times = Vec::with_capacity(runs);
    let mut last = None;
    for _ in 0..runs {
        let begin = Instant::now();
        last = Some(work()?);
        times.push(begin.elapsed().as_secs_f64() * 1000.0);
    }
    times.sort_by(f64::total_cmp);
    Ok((times[times.len() / 2], last.context("nothing was run")?))
}
