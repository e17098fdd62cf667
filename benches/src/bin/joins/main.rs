//! The cheapest join of the odd vertices of large graphs, each in a process of its own, and peers' on the same graphs; and the
//! routes of wireframes with these edges. Usage: `joins PEER-PYTHON`, or `joins --one FILE` for one graph, `joins --tour OBJ` for
//! one wireframe.

#![allow(clippy::print_stdout, reason = "its output is the table")]

mod tour;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

use anyhow::{Context, Result, ensure};
use serde_json::{Value, json};
use wirebend_benches::timed;
use wirebend_postman::{Graph, Join, cheapest_join, verify};

/// From, to and length.
type Weighted = (u32, u32, u64);

const FAMILIES: [&str; 6] = ["delaunay-sphere", "graded-mesh", "geometric", "icosphere", "isogrid", "truss"];
/// Edges, and what the closed join may take.
const SIZES: [(u32, f64); 4] = [(1000, 1.0), (10_000, 10.0), (100_000, 150.0), (1_000_000, 5000.0)];
/// Where the peer is asked too: equal struts, and lengths of every size, keep it busy for minutes beyond, others for seconds.
const PEER_UP_TO: u32 = 100_000;
const PEER_IS_SLOW_WITH: [&str; 2] = ["graded-mesh", "truss"];
const PEER_UP_TO_WHERE_SLOW: u32 = 20_000;
/// So many random graphs are compared with NetworkX.
const RANDOM_GRAPHS: &str = "200";
/// Trusses of so many rings are compared with `PyMatching`, which takes minutes for the last.
const RINGS: [u32; 4] = [10, 20, 30, 40];
/// Wireframes of the examples whose bends are counted, besides those of the families.
const EXAMPLES: [&str; 4] = ["cube", "truss-3", "bunny", "teapot"];

fn main() -> Result<()> {
    let mut arguments = std::env::args().skip(1);
    let first = arguments.next().context("name the peer's Python")?;
    if first == "--one" {
        return one(&arguments.next().context("name the graph's file")?);
    }
    if first == "--tour" {
        return tour::one(&arguments.next().context("name the wireframe's file")?);
    }
    let peers = Path::new(env!("CARGO_MANIFEST_DIR")).join("peers/joins.py");
    let folder = tempfile::tempdir()?;
    let ask = |task: &[&str], file: &Path| run(Command::new(&first).arg(&peers).args(task).arg(file));
    random_graphs(&first, &peers)?;
    trusses(&ask, folder.path())?;
    println!();
    println!(
        "{:<16} {:>9} {:>8} {:>11} {:>8} {:>11} {:>8} {:>7} {:>14} {:>7}",
        "joins", "edges", "odd", "closed", "aim", "open", "proof", "MiB", "PyMatching", "ratio"
    );
    let mut wireframes: Vec<PathBuf> =
        EXAMPLES.iter().map(|name| peers.join(format!("../../../examples/{name}.obj"))).collect();
    for family in FAMILIES {
        let mut grown = Vec::new();
        for (edges, aim) in SIZES {
            let file = folder.path().join(format!("{family}-{edges}.txt"));
            ask(&["make", family, &edges.to_string()], &file)?;
            let ours = run(Command::new(std::env::current_exe()?).arg("--one").arg(&file))?;
            let figure = |name: &str| ours[name].as_f64().with_context(|| format!("no {name}"));
            let closed = figure("closed_ms")?;
            grown.push((figure("edges")?.ln(), closed.ln()));
            wireframes.push(file.with_extension("txt.obj"));
            let most = if PEER_IS_SLOW_WITH.contains(&family) { PEER_UP_TO_WHERE_SLOW } else { PEER_UP_TO };
            let peer = if edges <= most {
                let theirs = ask(&["join"], &file)?;
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
                "{family:<16} {:>9.0} {:>8.0} {closed:>8.2} ms {aim:>5} ms {:>8.2} ms {:>5.1} ms {:>7.0} {peer}",
                figure("edges")?,
                figure("odd")?,
                figure("open_ms")?,
                figure("proof_ms")?,
                figure("peak_mib")?,
            );
        }
        println!("{family:<16} grows with the edges to the power of {:.2}, wanted up to 1.2", slope(&grown));
    }
    tours(&wireframes)
}

/// The slope of the straight line with the least squares.
fn slope(points: &[(f64, f64)]) -> f64 {
    let count: f64 = points.iter().map(|_| 1.0).sum();
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
    let (x, y) = (mean(|point| point.0), mean(|point| point.1));
    let (across, along) = points.iter().fold((0.0, 0.0), |(across, along), point| {
        (across + (point.0 - x) * (point.1 - y), along + (point.0 - x).powi(2))
    });
    across / along
}

/// Random graphs: as cheap as NetworkX's, closed and open, each with its proof.
fn random_graphs(python: &str, peers: &Path) -> Result<()> {
    let done = Command::new(python).arg(peers).args(["random", RANDOM_GRAPHS]).output()?;
    ensure!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    let mut count = 0;
    for line in String::from_utf8(done.stdout)?.lines() {
        let given: Value = serde_json::from_str(line)?;
        let edges: Vec<Weighted> = serde_json::from_value(given["edges"].clone())?;
        let graph = Graph::new(given["vertices"].as_u64().context("no vertices")?.try_into()?, &edges)?;
        for (kind, left) in [("closed", 0), ("open", 2)] {
            let join = proved(&graph, left)?;
            ensure!(given[kind] == join.weight, "{kind}: {} against NetworkX, {line}", join.weight);
        }
        count += 1;
    }
    println!("{count} random graphs: closed and open as NetworkX, every one proved");
    Ok(())
}

/// The cheapest join of the odd vertices, of which so many are left where there are so many.
fn proved(graph: &Graph, left: usize) -> Result<Join> {
    let odd = graph.odd();
    let join = cheapest_join(graph, &odd, odd.len().min(left))?;
    verify(graph, &odd, &join)?;
    Ok(join)
}

/// Trusses of equal struts: as cheap as those of `PyMatching`, closed and open, and how long both take.
fn trusses(ask: &impl Fn(&[&str], &Path) -> Result<Value>, folder: &Path) -> Result<()> {
    for rings in RINGS {
        let file = folder.join(format!("rings-{rings}.txt"));
        ask(&["make", "rings", &(27 * rings * rings).to_string()], &file)?;
        let (vertices, edges) = edges_of(&file)?;
        let graph = Graph::new(vertices, &edges)?;
        print!("truss of {rings} rings, {} edges:", edges.len());
        for (kind, left, task) in
            [("closed", 0, &["join", "--runs", "1"][..]), ("open", 2, &["join", "--runs", "1", "--open"])]
        {
            let started = Instant::now();
            let join = proved(&graph, left)?;
            let ours = started.elapsed().as_secs_f64() * 1000.0;
            let theirs = ask(task, &file)?;
            ensure!(theirs["weight_nm"] == join.weight, "{kind}: {} nm, PyMatching {theirs}", join.weight);
            let ms = theirs["median_ms"].as_f64().context("the peer gives no time")?;
            print!(" {kind} as PyMatching, {ours:.1} ms for its {ms:.0};");
        }
        println!();
    }
    Ok(())
}

/// Read, join and tour of wireframes, and the bends of the tours that are beyond 155 degrees.
fn tours(wireframes: &[PathBuf]) -> Result<()> {
    println!();
    println!(
        "{:<24} {:>9} {:>11} {:>10} {:>10} {:>10} {:>10} {:>10} {:>6} {:>8} {:>8} {:>10}",
        "tours",
        "edges",
        "its text",
        "read",
        "join",
        "tour",
        "open",
        "tour",
        "MiB",
        "> 155°",
        "forced",
        "at random"
    );
    for file in wireframes {
        let found = run(Command::new(std::env::current_exe()?).arg("--tour").arg(file))?;
        let figure =
            |kind: &str, name: &str| found[kind][name].as_f64().with_context(|| format!("no {name}"));
        let name = file.file_name().and_then(|name| name.to_str()).context("a file without a name")?;
        println!(
            "{:<24} {:>9.0} {:>8.2} ms {:>7.2} ms {:>7.2} ms {:>7.2} ms {:>7.2} ms {:>7.2} ms {:>6.0} {:>8.0} {:>8.0} {:>10.1}",
            name.split('.').next().unwrap_or(name),
            found["edges"].as_f64().context("no edges")?,
            found["text_ms"].as_f64().context("no time")?,
            found["read_ms"].as_f64().context("no time")?,
            figure("closed", "join_ms")?,
            figure("closed", "tour_ms")?,
            figure("open", "join_ms")?,
            figure("open", "tour_ms")?,
            found["peak_mib"].as_f64().context("no memory")?,
            figure("open", "sharp")?,
            figure("open", "forced")?,
            figure("open", "sharp_at_random")?,
        );
    }
    Ok(())
}

/// What a process prints: JSON, or nothing.
fn run(command: &mut Command) -> Result<Value> {
    let done = command.output().with_context(|| format!("{command:?} cannot be started"))?;
    ensure!(done.status.success(), "{}", String::from_utf8_lossy(&done.stderr));
    Ok(if done.stdout.is_empty() { Value::Null } else { serde_json::from_slice(&done.stdout)? })
}

/// The number of vertices and the edges of a file.
fn edges_of(file: &Path) -> Result<(usize, Vec<Weighted>)> {
    let text = std::fs::read_to_string(file).with_context(|| file.display().to_string())?;
    let edge = |line: &str| -> Result<Weighted> {
        let mut words = line.split_whitespace();
        let mut next = || words.next().with_context(|| format!("{line}: three numbers are expected"));
        Ok((next()?.parse()?, next()?.parse()?, next()?.parse()?))
    };
    let edges: Vec<Weighted> = text.lines().map(edge).collect::<Result<_>>()?;
    let vertices = edges.iter().map(|&(a, b, _)| a.max(b) as usize + 1).max().unwrap_or(0);
    Ok((vertices, edges))
}

/// One graph: prints its figures.
fn one(file: &str) -> Result<()> {
    let (vertices, edges) = edges_of(Path::new(file))?;
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
