//! Programs that meet nothing: how many designs have one, with how many wires, and how long the search for it takes. Each is shown
//! beside the first program, as it comes without a search.
//!
//! Arguments: how many random frames, how many steps may be checked for each number of wires, and one design by its name.

#![allow(clippy::print_stdout, reason = "its output is the table")]

mod frame;

use std::time::Instant;

use anyhow::{Context, Result, ensure};
use wirebend_benches::bender::nearest;
use wirebend_benches::{design, machine};
use wirebend_core::clearance::passages;
use wirebend_core::plan::{DoublingChoice, Machine, PlanOptions, WirePlan, plan_wires};
use wirebend_core::search::SearchOptions;
use wirebend_core::units::Length;
use wirebend_core::wireframe::Wireframe;

/// So many random frames are searched.
const FRAMES: u64 = 50;
/// How many steps are checked for each number of wires: some seconds.
const EFFORT: u64 = 5000;

/// The bender that checks what is found is looked at this many times 0.05 degrees and mm apart.
const STRIDE: f64 = 10.0;
/// It may come this much nearer than it should, mm: its peg follows the wire exactly, that of the check in straight parts.
const EXACT: f64 = 0.05;

/// Designs of `examples/`, and whether the edges of their faces are meant.
const DESIGNS: &[(&str, bool)] = &[
    ("cube", false),
    ("cube-8-edges", false),
    ("house", false),
    ("phone-stand", false),
    ("cup-holder", false),
    ("spring", false),
    ("truss-0", false),
    ("truss-1", false),
    ("isogrid", false),
    ("truss-2", false),
    ("truss-3", false),
    ("teapot", true),
    ("bunny", true),
];

fn main() -> Result<()> {
    let mut arguments = std::env::args().skip(1);
    let frames = arguments.next().map_or(Ok(FRAMES), |number| number.parse())?;
    let effort = arguments.next().map_or(Ok(EFFORT), |number| number.parse())?;
    let only = arguments.next();
    let machine = machine()?;
    println!(
        "{:<16} {:>6} {:>6} | {:>8} {:>9} | {:>6} {:>6} {:>8} {:>9} {:>8}",
        "design", "edges", "bends", "contacts", "check, ms", "clear", "wires", "checks", "ms", "length"
    );
    for &(name, faces) in DESIGNS {
        if only.as_ref().is_none_or(|only| only == name) {
            show(name, &design(name, faces)?, &machine, effort)?;
        }
    }
    let mut clear = [0; 3];
    let mut first_clear = 0;
    for seed in 0..frames {
        let edges = 10 + usize::try_from(seed)? % 51;
        let wireframe = frame::random(seed, edges)?;
        let shown = show(&format!("frame {seed}"), &wireframe, &machine, effort)?;
        first_clear += usize::from(shown.first_clear);
        if shown.clear {
            clear[shown.wires.min(3) - 1] += 1;
        }
    }
    println!("{frames} frames: {first_clear} clear as first found; clear with 1, 2, more wires: {clear:?}");
    Ok(())
}

struct Shown {
    first_clear: bool,
    clear: bool,
    wires: usize,
}

fn show(name: &str, wireframe: &Wireframe, machine: &Machine, effort: u64) -> Result<Shown> {
    let components = wireframe.components();
    let component = components.first().context("a component")?;
    let first = PlanOptions {
        doubling: DoublingChoice::Cheapest,
        contacts: Some(Length::ZERO),
        ..PlanOptions::default()
    };
    let begin = Instant::now();
    let plain = plan_wires(wireframe, component, machine, &first, |_| ());
    let plain_ms = begin.elapsed().as_secs_f64() * 1000.0;
    let searching = SearchOptions { effort, ..SearchOptions::default() };
    let wanted = PlanOptions { search: Some(searching), ..first };
    let begin = Instant::now();
    let found = plan_wires(wireframe, component, machine, &wanted, |_| ());
    let ms = begin.elapsed().as_secs_f64() * 1000.0;
    let contacts = |wires: &[WirePlan]| -> usize {
        let of_wire =
            |wire: &WirePlan| wire.contacts.iter().flatten().map(|first| 1 + first.later).sum::<usize>();
        wires.iter().map(of_wire).sum()
    };
    let bends: usize = plain.iter().filter_map(|wire| Some(wire.nominal.as_ref()?.bend_count())).sum();
    let searched = found.first().and_then(|wire| wire.searched);
    let clear = searched.is_some_and(|searched| searched.found);
    ensure!(!clear || contacts(&found) == 0, "{name}: what is found is refused by the check");
    if clear {
        for wire in &found {
            let (Some(scheduled), Some(nominal), Some(route)) = (&wire.scheduled, &wire.nominal, &wire.route)
            else {
                continue;
            };
            let passages = passages(wireframe, &route.traversals, &nominal.spans);
            let nearest = nearest(machine, &scheduled.steps, passages, STRIDE);
            let apart = nearest.map_or(f64::INFINITY, |(_, least)| least - machine.wire.diameter.mm() / 2.0);
            ensure!(apart > -EXACT, "{name}: the bender meets {nearest:?}");
        }
    }
    let length: f64 = found.iter().filter_map(|wire| Some(wire.nominal.as_ref()?.length().mm())).sum();
    println!(
        "{name:<16} {:>6} {bends:>6} | {:>8} {plain_ms:>9.1} | {clear:>6} {:>6} {:>8} {ms:>9.1} {length:>8.0} {}",
        component.edges.len(),
        contacts(&plain),
        found.len(),
        searched.map_or(0, |searched| searched.checks),
        if clear { String::new() } else { format!("{} contacts left", contacts(&found)) },
    );
    Ok(Shown { first_clear: contacts(&plain) == 0, clear, wires: found.len() })
}
