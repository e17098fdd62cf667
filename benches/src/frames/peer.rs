//! What others say of the same frames, `benches/peers/frames.py`.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, ensure};
use nalgebra::Vector3;
use serde_json::{Value, json};
use wirebend_frame::Model;

/// mm/s².
pub const GRAVITY: Vector3<f64> = Vector3::new(0.0, 0.0, -9806.65);
/// Where the search for modes begins, Hz.
pub const SHIFT_HZ: f64 = 100.0;
/// So many modes of each frame.
pub const MODES: usize = 3;

/// A frame as peers read it; of one that is built `first` members stand at the beginning.
pub fn written(folder: &Path, model: &Model, first: usize) -> Result<PathBuf> {
    let section = model.sections[0];
    let nodes: Vec<[f64; 3]> = model.nodes.iter().map(|node| [node.x, node.y, node.z]).collect();
    let members: Vec<[usize; 2]> = model.members.iter().map(|member| [member.a.0, member.b.0]).collect();
    let supports: Vec<usize> = model.supports.iter().map(|support| support.node.0).collect();
    let file = folder.join("frame.json");
    let frame = json!({
        "nodes_mm": nodes, "members": members, "clamped": supports, "radius_mm": section.radius, "e_mpa": section.e,
        "g_mpa": section.g, "density_t_mm3": section.density, "gravity_mm_s2": -GRAVITY.z, "modes": MODES,
        "shift_hz": SHIFT_HZ, "first": first,
    });
    std::fs::write(&file, frame.to_string())?;
    Ok(file)
}

/// What a peer prints, as JSON.
pub fn ask(python: &str, task: &[&str], file: &Path) -> Result<Value> {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("peers/frames.py");
    // Ours has one core; so have theirs.
    let done = Command::new(python)
        .arg(script)
        .args(task)
        .arg(file)
        .envs([("OPENBLAS_NUM_THREADS", "1"), ("OMP_NUM_THREADS", "1")])
        .output()
        .with_context(|| format!("{python} cannot be started"))?;
    ensure!(done.status.success(), "{task:?}: {}", String::from_utf8_lossy(&done.stderr));
    Ok(serde_json::from_slice(&done.stdout)?)
}
