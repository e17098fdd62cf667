//! Gathers the figures of a benchmark run: ours as criterion measured them, the program as a process,
//! and a peer's on the same models. Usage: `figures PROGRAM PEER-PYTHON`.

#![allow(clippy::print_stdout, reason = "its output is the table")]

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

use anyhow::{Context, Result, ensure};
use serde_json::Value;

/// How often the program is started.
const STARTS: usize = 40;
const LARGE_STARTS: usize = 7;
/// How often the peer solves each model.
const PEER_RUNS: &str = "20";
const MODELS: [&str; 5] = ["bunny", "teapot", "truss-1", "truss-2", "truss-3"];

fn main() -> Result<()> {
    let mut arguments = std::env::args().skip(1);
    let program = arguments.next().context("name the program to time")?;
    let peer = arguments.next().context("name the peer's Python")?;
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");

    println!();
    println!("{:<60} {:>10}   {:>9}", "median of this machine", "measured", "aim");
    let row =
        |what: &str, measured: f64, aim: f64| println!("{what:<60} {measured:>7.2} ms   < {aim:>4.0} ms");
    row("bunny: read, check, route, program, compensate", criterion_ms(&root, "plan/bunny")?, 5.0);
    row("column of 1000 edges: the same", criterion_ms(&root, "plan/column-1000-edges")?, 5.0);
    let bunny = root.join("examples/bunny.obj");
    row("`wirebend plan` of the bunny, as a process", process_ms(&program, &bunny, STARTS)?, 60.0);
    let folder = tempfile::tempdir()?;
    let mesh = folder.path().join("mesh.txt");
    let making = Command::new(&peer)
        .arg(root.join("benches/peers/joins.py"))
        .args(["make", "delaunay-sphere", "100000"])
        .arg(&mesh)
        .status()?;
    ensure!(making.success(), "the mesh cannot be made");
    let mesh = mesh.with_extension("txt.obj");
    row("the same of a mesh of 100,000 edges", process_ms(&program, &mesh, LARGE_STARTS)?, 1000.0);

    row(
        "live check of 1000 edges, 95 of 100 within",
        criterion_p95_ms(&root, "live-check/column-1000-edges")?,
        16.0,
    );

    row(
        "live check of 10,000 edges with a proposal, 95 of 100 within",
        criterion_p95_ms(&root, "live-check/sheet-10000-edges")?,
        50.0,
    );
    row(
        "the same with bends that no route avoids",
        criterion_p95_ms(&root, "live-check/spikes-10000-edges")?,
        50.0,
    );

    row(
        "live check of 200 edges for collisions, 95 of 100 within",
        criterion_p95_ms(&root, "live-collisions/column-200-edges")?,
        100.0,
    );
    row(
        "the same cancelled: until it has ended, 95 of 100 means within",
        criterion_p95_ms(&root, "live-collisions/given-up")?,
        10.0,
    );

    row("start of a driver's process", criterion_ms(&root, "driver/start")?, 50.0);
    let (here, there) = ("driver-encode-1000/in-process", "driver-encode-1000/child-process");
    let (here, there) = (criterion_ms(&root, here)?, criterion_ms(&root, there)?);
    row("job of 1000 steps: child process over in process", there - here, 3.0);
    row("STOP of a driver that hangs", criterion_ms(&root, "driver/stop-of-one-that-hangs")?, 150.0);

    println!();
    println!("{:<10} {:>12} {:>12} {:>8}   aim ≥ 100", "model", "ours", "NetworkX", "ratio");
    for model in MODELS {
        let ours = criterion_ms(&root, &format!("euler/{model}"))?;
        let (theirs, length) = peer_ms(&peer, &root, model)?;
        println!("{model:<10} {ours:>9.3} ms {theirs:>9.3} ms {:>7.0}x   both {length:.1} mm", theirs / ours);
    }
    Ok(())
}

/// The median of a benchmark that has just been run.
fn criterion_ms(root: &Path, name: &str) -> Result<f64> {
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), PathBuf::from);
    let file = target.join("criterion").join(name).join("new/estimates.json");
    let text = std::fs::read_to_string(&file)
        .with_context(|| format!("{}: run the benchmarks first", file.display()))?;
    let estimates: Value = serde_json::from_str(&text)?;
    let nanoseconds = estimates["median"]["point_estimate"].as_f64().context("no median")?;
    Ok(nanoseconds / 1e6)
}

/// What 95 of 100 samples of a benchmark that has just been run stay within, each the mean of its iterations.
fn criterion_p95_ms(root: &Path, name: &str) -> Result<f64> {
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root.join("target"), PathBuf::from);
    let file = target.join("criterion").join(name).join("new/sample.json");
    let text = std::fs::read_to_string(&file)
        .with_context(|| format!("{}: run the benchmarks first", file.display()))?;
    let sample: Value = serde_json::from_str(&text)?;
    let numbers = |key: &str| {
        sample[key].as_array().map(|all| all.iter().filter_map(Value::as_f64).collect::<Vec<_>>())
    };
    let (times, iterations) =
        (numbers("times").context("no times")?, numbers("iters").context("no iterations")?);
    let mut each: Vec<f64> = times.iter().zip(&iterations).map(|(ns, count)| ns / count / 1e6).collect();
    each.sort_by(f64::total_cmp);
    each.get(each.len() * 95 / 100).copied().context("no samples")
}

fn process_ms(program: &str, wireframe: &Path, starts: usize) -> Result<f64> {
    let mut times = Vec::with_capacity(starts);
    for _ in 0..starts {
        let started = Instant::now();
        let done = Command::new(program)
            .args(["plan", "--face-edges", "--double", "--machine", "wirebend-kit", "--json"])
            .arg(wireframe)
            .output()
            .with_context(|| format!("{program} cannot be started"))?;
        times.push(started.elapsed().as_secs_f64() * 1000.0);
        // It is not feasible on this machine, which is status 4.
        ensure!(done.status.code() == Some(4), "{}", String::from_utf8_lossy(&done.stderr));
    }
    times.sort_by(f64::total_cmp);
    Ok(times[starts / 2])
}

/// The peer's median, and the length that both have to agree on.
fn peer_ms(peer: &str, root: &Path, model: &str) -> Result<(f64, f64)> {
    let done = Command::new(peer)
        .arg(root.join("benches/peers/euler_networkx.py"))
        .args(["--runs", PEER_RUNS])
        .arg(root.join(format!("examples/{model}.obj")))
        .output()
        .with_context(|| format!("{peer} cannot be started"))?;
    ensure!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let found: Value = serde_json::from_slice(&done.stdout)?;
    let figure = |name: &str| found[name].as_f64().with_context(|| format!("the peer gives no {name}"));
    Ok((figure("median_ms")?, figure("open_length_mm")?))
}
