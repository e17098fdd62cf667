//! How long frames take to solve and to vibrate, and peers on the same frames, whose displacements and frequencies have to agree.
//! Usage: `frames PEER-PYTHON`.

#![allow(clippy::print_stdout, reason = "its output is the table")]

use std::path::Path;
use std::time::Instant;

use anyhow::{Context, Result, ensure};
use wirebend_benches::frames::models;
use wirebend_benches::frames::peer::{GRAVITY, MODES, SHIFT_HZ, ask, written};
use wirebend_benches::timed;
use wirebend_frame::{Assembly, Flexibility, Load, MemberId, ModeKind, ModeSearch, Model, Pieces};

/// The median of so many runs is taken; of large frames of so many.
const RUNS: usize = 21;
const RUNS_OF_LARGE: usize = 5;
/// Programs for frames that are asked, and libraries.
const PEERS: &[&str] = &["pyconmech", "pynite", "opensees", "scipy", "scipy-best"];
const LARGE_PEERS: &[&str] = &["opensees", "scipy", "scipy-best"];
/// From so many members on a frame is large: peers that loop over members in Python take minutes.
const LARGE: usize = 1000;
/// Ours and a peer's displacements and frequencies agree so well, as a share.
const SAME: f64 = 1e-6;

fn main() -> Result<()> {
    let python = std::env::args().nth(1).context("name the peers' Python")?;
    let folder = tempfile::tempdir()?;
    println!(
        "{:<22} {:>8} {:>8} {:>10} {:>10} {:>10}   peers: build + solve, as many times ours",
        "frames, self-weight", "members", "unknowns", "analysed", "solved", "together"
    );
    for (name, model) in models::standing()? {
        solved(&python, folder.path(), name, &model)?;
    }
    println!();
    tried("bunny", &models::bunny()?)?;
    println!();
    for (name, rings) in
        [("truss 1, free, 4 pieces", 1), ("truss 3, free, 4 pieces", 3), ("truss 5, free, 4 pieces", 5)]
    {
        vibrating(&python, folder.path(), name, &Pieces::new(&models::truss(rings), 4))?;
    }
    Ok(())
}

/// One frame under its own weight, by us and by peers.
fn solved(python: &str, folder: &Path, name: &str, model: &Model) -> Result<()> {
    let is_large = model.members.len() > LARGE;
    let runs = if is_large { RUNS_OF_LARGE } else { RUNS };
    let load = Load { gravity: GRAVITY, ..Load::default() };
    let (analysed, assembly) = timed(runs, || Ok(Assembly::new(model)?))?;
    let all = assembly.all();
    let (factored, response) = timed(runs, || Ok(assembly.factor(&all)?.solve(&load)?))?;
    let unknowns = 6 * (model.nodes.len() - model.supports.len());
    print!(
        "{name:<22} {:>8} {unknowns:>8} {analysed:>7.2} ms {factored:>7.2} ms {:>7.2} ms  ",
        model.members.len(),
        analysed + factored
    );
    let file = written(folder, model, 0)?;
    let peers: &[&str] = if is_large { LARGE_PEERS } else { PEERS };
    for peer in peers {
        let theirs = ask(python, &["solve", peer], &file)?;
        if theirs.get("absent").is_some() {
            print!(" {peer} cannot be loaded here;");
            continue;
        }
        let [build, solve, most] = ["build_ms", "solve_ms", "max_mm"].map(|key| theirs[key].as_f64());
        let (build, solve) = (build.context("no time")?, solve.context("no time")?);
        let (most, ours) = (most.context("no displacement")?, response.max_displacement().1);
        ensure!((most / ours - 1.0).abs() < SAME, "{name}: {ours} mm, {peer} {most} mm");
        print!(" {peer} {build:.1} + {solve:.1} ms, {:.0}x", solve / factored);
        print!(", {:.0}x in all", (build + solve) / (analysed + factored));
        match wanted(peer, model) {
            Some(times) => print!(" ({times}x wanted);"),
            None => print!(";"),
        }
    }
    println!();
    Ok(())
}

/// How many times as long a peer is to take: to solve, and `SciPy`'s `spsolve` in all.
fn wanted(peer: &str, model: &Model) -> Option<u32> {
    match (peer, model.members.len()) {
        ("pyconmech", ..500) => Some(50),
        ("pyconmech", _) => Some(80),
        ("pynite", ..500) => Some(200),
        ("scipy", 1000..) => Some(5),
        _ => None,
    }
}

/// Every strut of a frame tried that can be added to half of it, and taken away from the whole.
fn tried(name: &str, model: &Model) -> Result<()> {
    let assembly = Assembly::new(model)?;
    let mut growing = Flexibility::new(&assembly, GRAVITY);
    let mut tries = 0_u32;
    let begin = Instant::now();
    while growing.standing().len() < model.members.len() {
        let mut best = (f64::INFINITY, None);
        for member in (0..model.members.len()).map(MemberId) {
            if growing.standing().contains(member) {
                continue;
            }
            if let Ok(sag) = growing.try_add(member) {
                tries += 1;
                if sag.max_displacement < best.0 {
                    best = (sag.max_displacement, Some(member));
                }
            }
        }
        growing.add(best.1.context("nothing can be added")?)?;
    }
    let ms = begin.elapsed().as_secs_f64() * 1000.0;
    println!("{name}: the stiffest order, {tries} struts tried, {ms:.1} ms");
    let begin = Instant::now();
    let mut standing = 0_u32;
    for member in (0..model.members.len()).map(MemberId) {
        standing += u32::from(growing.try_remove(member).is_ok());
    }
    let ms = begin.elapsed().as_secs_f64() * 1000.0;
    println!(
        "{name}: {standing} of {} struts can be taken away from the whole, {ms:.1} ms",
        model.members.len()
    );
    // As many frames factored as there are steps of an order, each but one strut more.
    let begin = Instant::now();
    let mut members = assembly.all();
    for member in (0..model.members.len()).rev().map(MemberId) {
        if members.remove(member) && assembly.factor(&members).is_err() {
            members.insert(member);
        }
    }
    let ms = begin.elapsed().as_secs_f64() * 1000.0;
    println!("{name}: {} frames factored, each with one strut less, {ms:.1} ms", model.members.len());
    Ok(())
}

/// The lowest modes of a frame that floats, by us and by `SciPy`.
fn vibrating(python: &str, folder: &Path, name: &str, cut: &Pieces) -> Result<()> {
    let search =
        ModeSearch { count: MODES, shift_hz: SHIFT_HZ, struts: cut.struts.clone(), masses: Vec::new() };
    let (ours, modes) = timed(RUNS_OF_LARGE, || {
        let assembly = Assembly::new(&cut.model)?;
        Ok(assembly.modes(&assembly.all(), &search)?)
    })?;
    let bending: Vec<f64> =
        modes.iter().filter(|mode| mode.kind != ModeKind::Rigid).map(|mode| mode.frequency_hz).collect();
    let unknowns = 6 * cut.model.nodes.len();
    print!("{name}: {unknowns} unknowns, {:.3} Hz, {ours:.0} ms;", bending[0]);
    let file = written(folder, &cut.model, 0)?;
    for peer in ["eigsh", "eigsh-symmetric"] {
        let theirs = ask(python, &["modes", peer], &file)?;
        let ms = theirs["ms"].as_f64().context("no time")?;
        let found: Vec<f64> = serde_json::from_value(theirs["hz"].clone())?;
        for (ours, theirs) in bending.iter().zip(&found) {
            ensure!((theirs / ours - 1.0).abs() < SAME, "{name}: {ours} Hz, {peer} {theirs} Hz");
        }
        print!(" {peer} {ms:.0} ms, {:.1}x;", ms / ours);
        if peer == "eigsh" {
            print!(" (8x wanted, and 700 ms for 5 rings);");
        }
    }
    println!();
    Ok(())
}
