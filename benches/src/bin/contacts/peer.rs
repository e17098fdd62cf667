//! The same contacts by FCL, which samples the motions.

use std::io::Write as _;
use std::process::Command;
use std::time::Instant;

use anyhow::{Context, Result, ensure};
use nalgebra::Isometry3;
use serde_json::{Value, json};
use wirebend_benches::bender::Bender;
use wirebend_core::clearance::{MovesWith, Obstacle, Phase, Solid};
use wirebend_core::plan::Machine;

/// The peer sees what is 2 degrees and 2 mm apart.
const STRIDE: f64 = 40.0;
/// How many bends the program has.
const BENDS: usize = 300;

/// Compares the times for a program, and which bodies are met in which steps.
pub fn compare(machine: &Machine, python: &str) -> Result<()> {
    let steps = super::program(u64::try_from(BENDS)?, BENDS)?;
    let bodies = &machine.bodies.all;
    let mut bender = Bender::new(machine, &steps, super::passages(&steps), STRIDE);
    let mut rows: Vec<f64> = Vec::new();
    for (k, step) in steps.iter().enumerate() {
        // The peer has a wire of its own.
        bender.forget();
        bender.run(step, &[], &mut |(phase, _), bender| {
            for (index, body) in bodies.iter().enumerate() {
                let moves = matches!(phase, Phase::Feed | Phase::Rotate | Phase::Bend);
                if moves || body.moves_with == MovesWith::Peg {
                    let legs = k + usize::from(phase != Phase::Feed);
                    let legs = legs.saturating_sub(usize::from(body.contact_zone.mm() > 0.0));
                    rows.extend(
                        [k, index, legs].map(|number| f64::from(u32::try_from(number).unwrap_or(u32::MAX))),
                    );
                    rows.extend(row(&(bender.wire().inverse() * bender.placed(body))));
                }
            }
        });
    }
    let header = json!({
        "radius_mm": machine.wire.diameter.mm() / 2.0,
        "corners": bender.corners().map(|at| [at.x, at.y, at.z]).collect::<Vec<_>>(),
        "solids": bodies.iter().map(|body| solid(&body.solid)).collect::<Vec<_>>(),
        "lag": bodies.iter().map(|body| u8::from(body.contact_zone.mm() > 0.0)).collect::<Vec<_>>(),
    });
    let mut file = tempfile::NamedTempFile::new()?;
    writeln!(file, "{header}")?;
    file.write_all(&rows.iter().flat_map(|number| number.to_le_bytes()).collect::<Vec<_>>())?;
    let script = concat!(env!("CARGO_MANIFEST_DIR"), "/peers/contacts.py");
    let output = Command::new(python).arg(script).arg(file.path()).output().context(python.to_owned())?;
    ensure!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let theirs: Value = serde_json::from_slice(&output.stdout)?;
    let peer = theirs["seconds"].as_f64().context("seconds")?;
    let touching: Vec<(usize, usize)> = serde_json::from_value(theirs["touching"].clone())?;

    let mut best = f64::INFINITY;
    for _ in 0..super::RUNS {
        let begin = Instant::now();
        std::hint::black_box(super::contacts(super::clearance(machine, &steps)));
        best = best.min(begin.elapsed().as_secs_f64());
    }
    println!(
        "{BENDS} bends: FCL, sampled at 2 degrees and 2 mm, {peer:.2} s; ours, exact, {:.1} ms: 1/{:.0}",
        best * 1000.0,
        peer / best
    );
    // A contact that goes on is reported once, so that each step is asked about alone.
    let mut clearance = super::clearance(machine, &steps);
    let mut ours = Vec::new();
    for step in 0..steps.len() {
        let of_step = clearance.first_contacts_in(step..step + 1, |_| true).unwrap_or_default();
        let of_step = of_step.into_iter().filter_map(|first| match first.contact.obstacle {
            Obstacle::Body(index) => Some((step, index)),
            Obstacle::Stock => None,
        });
        ours.extend(of_step);
    }
    let both = touching.iter().filter(|one| ours.contains(one)).count();
    println!(
        "steps and bodies that touch: FCL {}, of these ours {both}; ours {}, which begin in them",
        touching.len(),
        ours.len()
    );
    Ok(())
}

fn solid(solid: &Solid) -> Value {
    match *solid {
        Solid::Box { half } => json!({ "box": [half.x * 2.0, half.y * 2.0, half.z * 2.0] }),
        Solid::Cylinder { radius, half_length } => json!({ "cylinder": [radius, half_length * 2.0] }),
        Solid::Capsule { radius, half_length } => json!({ "capsule": [radius, half_length * 2.0] }),
    }
}

fn row(at: &Isometry3<f64>) -> impl Iterator<Item = f64> {
    let matrix = at.to_homogeneous();
    (0..12).map(move |k| matrix[(k / 4, k % 4)])
}
