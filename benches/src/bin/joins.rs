//! The cheapest join of the odd vertices of large graphs, each in a process of its own, and a peer's on the same graphs. Usage:
//! `joins PEER-PYTHON`, or `joins --one FILE` for one graph.

#![allow(clippy::print_stdout, reason = "its output is the table")]

use std::path::Path;
use std::process::Command;
use std::time::Instant;

use anyhow::{Context, Result, ensure};
use serde_json::{Value, json};
use wirebend_postman::{Graph, cheapest_join, verify};

const FAMILIES: [&str; 6] = ["delaunay-sphere", "graded-mesh", "geometric", "icosphere", "isogrid", "truss"];
/// Edges, and what the closed join may take.
const SIZES: [(u32, f64); 4] = [(1000, 1.0), (10_000, 10.0), (100_000, 150.0), (1_000_000, 5000.0)];
/// Where the peer is asked too: equal struts keep it busy for minutes beyond, other graphs for seconds.
const PEER_UP_TO: u32 = 100_000;
const PEER_UP_TO_IN_TRUSSES: u32 = 20_000;

fn main() -> Result<()> {
    let mut arguments = std::env::args().skip(1);
    let first = arguments.next().context("name the peer's Python")?;
    if first == "--one" {
        return one(&arguments.next().context("name the graph's file")?);
    }
    let peers = Path::new(env!("CARGO_MANIFEST_DIR")).join("peers/joins.py");
    let folder = tempfile::tempdir()?;
    println!();
    println!(
        "{:<16} {:>9} {:>8} {:>11} {:>8} {:>11} {:>8} {:>7} {:>14} {:>7}",
        "joins", "edges", "odd", "closed", "aim", "open", "proof", "MiB", "PyMatching", "ratio"
    );
    for family in FAMILIES {
        for (edges, aim) in SIZES {
            let file = folder.path().join(format!("{family}-{edges}.txt"));
            run(Command::new(&first).arg(&peers).args(["make", family, &edges.to_string()]).arg(&file))?;
            let ours = run(Command::new(std::env::current_exe()?).arg("--one").arg(&file))?;
            let figure = |name: &str| ours[name].as_f64().with_context(|| format!("no {name}"));
            let closed = figure("closed_ms")?;
            let most = if family == "truss" { PEER_UP_TO_IN_TRUSSES } else { PEER_UP_TO };
            let peer = if edges <= most {
                let theirs = run(Command::new(&first).arg(&peers).arg("join").arg(&file))?;
                let weight = theirs["weight_nm"].as_u64().context("the peer gives no weight")?;
                let least = ours["weight_nm"].as_u64().context("no weight")?;
                // One that rounds its weights may miss the cheapest by a little, and is never below it.
                let agrees = if theirs["is_exact"] == true { weight == least } else { weight >= least };
                ensure!(agrees, "{family} of {edges} edges: {least} nm, PyMatching {weight} nm");
                let theirs = theirs["median_ms"].as_f64().context("the peer gives no time")?;
                format!("{theirs:>11.2} ms {:>6.1}x", theirs / closed)
            } else {
                String::new()
            };
            println!(
                "{family:<16} {:>9} {:>8} {closed:>8.2} ms {aim:>5} ms {:>8.2} ms {:>5.1} ms {:>7.0} {peer}",
                ours["edges"],
                ours["odd"],
                figure("open_ms")?,
                figure("proof_ms")?,
                figure("peak_mib")?,
            );
        }
    }
    Ok(())
}

/// What a process prints: JSON, or nothing.
fn run(command: &mut Command) -> Result<Value> {
    let done = command.output().with_context(|| format!("{command:?} cannot be started"))?;
    ensure!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    Ok(if done.stdout.is_empty() { Value::Null } else { serde_json::from_slice(&done.stdout)? })
}

/// The median of so many tries, in milliseconds, and what the last gave.
fn timed<T>(tries: usize, mut work: impl FnMut() -> Result<T>) -> Result<(f64, T)> {
    let mut times = Vec::with_capacity(tries);
    let mut last = None;
    for _ in 0..tries {
        let started = Instant::now();
        last = Some(work()?);
        times.push(started.elapsed().as_secs_f64() * 1000.0);
    }
    times.sort_by(f64::total_cmp);
    Ok((times[times.len() / 2], last.context("nothing was tried")?))
}

/// One graph: prints its figures.
fn one(file: &str) -> Result<()> {
    let text = std::fs::read_to_string(file).with_context(|| file.to_owned())?;
    let edge = |line: &str| -> Result<(u32, u32, u64)> {
        let mut words = line.split_whitespace();
        let mut next = || words.next().with_context(|| format!("{line}: three numbers are expected"));
        Ok((next()?.parse()?, next()?.parse()?, next()?.parse()?))
    };
    let edges: Vec<(u32, u32, u64)> = text.lines().map(edge).collect::<Result<_>>()?;
    drop(text);
    let vertices = edges.iter().map(|&(a, b, _)| a.max(b) as usize + 1).max().unwrap_or(0);
    let tries = if edges.len() > 200_000 { 1 } else { 9 };
    let (closed_ms, (graph, odd, closed)) = timed(tries, || {
        let graph = Graph::new(vertices, &edges)?;
        let odd = graph.odd();
        let join = cheapest_join(&graph, &odd, 0)?;
        Ok((graph, odd, join))
    })?;
    let (open_ms, open) = timed(tries, || Ok(cheapest_join(&graph, &odd, odd.len().min(2))?))?;
    let (proof_ms, ()) = timed(tries, || Ok(verify(&graph, &odd, &closed)?))?;
    verify(&graph, &odd, &open)?;
    println!(
        "{}",
        json!({
            "edges": edges.len(), "odd": odd.len(), "weight_nm": closed.weight, "closed_ms": closed_ms,
            "open_ms": open_ms, "proof_ms": proof_ms, "peak_mib": peak_mib()?,
        })
    );
    Ok(())
}

/// The most memory that this process has had.
fn peak_mib() -> Result<f64> {
    let status =
        std::fs::read_to_string("/proc/self/status").context("this system does not tell its memory")?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:")).context("no peak")?;
    let kib: f64 = line.trim().trim_end_matches(" kB").parse()?;
    Ok(kib / 1024.0)
}
