//! Programs that meet nothing: how many designs have one that is found within some seconds, with one wire and with up to two. Each is
//! shown beside the first program, as it comes without a search.
//!
//! Arguments: how many random frames, how many seconds each search has, and one design by its name.

#![allow(clippy::print_stdout, reason = "its output is the table")]

mod frame;

use std::fmt::Write;
use std::time::{Duration, Instant};

use anyhow::{Context, Result, ensure};
use wirebend_benches::bender::nearest;
use wirebend_benches::{design, machine};
use wirebend_core::clearance::{Obstacle, passages};
use wirebend_core::plan::{
    DoublingChoice, Machine, PlanObserver, PlanOptions, Searched, Stage, WirePlan, plan_wires,
};
use wirebend_core::search::{Obstruction, SearchOptions, SearchProgress};
use wirebend_core::wireframe::Wireframe;

/// So many random frames are searched.
const FRAMES: u64 = 50;
/// How long each is searched at most, s.
const SECONDS: f64 = 10.0;
/// With so many wires at most.
const WIRES: [usize; 2] = [1, 2];

/// The bender that checks what is found is looked at this many times 0.05 degrees and mm apart.
const STRIDE: f64 = 10.0;
/// It may come this much nearer than it should, mm, as in the comparison of contacts.
const EXACT: f64 = 0.01;

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
    let seconds = arguments.next().map_or(Ok(SECONDS), |number| number.parse())?;
    let only = arguments.next();
    let time = Duration::try_from_secs_f64(seconds)?;
    let machine = machine()?;
    println!(
        "{:<16} {:>6} {:>6} | {:>8} {:>9} | {:>9} {:>8} {:>7} {:>8} | with up to 2",
        "design", "edges", "bends", "contacts", "check, ms", "one wire", "checks", "s", "length"
    );
    let mut examples = Tally::default();
    for &(name, faces) in DESIGNS {
        if only.as_ref().is_none_or(|only| only == name) {
            examples.add(&show(name, &design(name, faces)?, &machine, time)?);
        }
    }
    let mut random = Tally::default();
    for seed in 0..frames {
        let edges = 10 + usize::try_from(seed)? % 51;
        let wireframe = frame::random(seed, edges)?;
        random.add(&show(&format!("frame {seed}"), &wireframe, &machine, time)?);
    }
    for (what, tally) in [("examples", examples), ("random frames", random)] {
        let Tally { designs, first, clear: [one, two] } = tally;
        println!(
            "{designs} {what}: {first} meet nothing as first found; found within {seconds} s: {one} with one wire, {two} with one or two"
        );
    }
    Ok(())
}

/// How many designs have a program that meets nothing.
#[derive(Default)]
struct Tally {
    designs: usize,
    /// As first found.
    first: usize,
    /// With so many wires as [`WIRES`] has.
    clear: [usize; 2],
}

impl Tally {
    fn add(&mut self, shown: &Shown) {
        self.designs += 1;
        self.first += usize::from(shown.first_clear);
        let [one, two] = shown.clear;
        self.clear[0] += usize::from(one);
        self.clear[1] += usize::from(one || two);
    }
}

struct Shown {
    first_clear: bool,
    clear: [bool; 2],
}

/// Ends a search when its time is over.
struct Timed {
    until: Instant,
}

impl PlanObserver for Timed {
    fn done(&mut self, _: Stage) {}

    fn searching(&mut self, _: SearchProgress, _: u64) -> bool {
        Instant::now() < self.until
    }

    /// What would help is not asked here.
    fn trying(&mut self, _: u64, _: u64) -> bool {
        false
    }
}

fn show(name: &str, wireframe: &Wireframe, machine: &Machine, time: Duration) -> Result<Shown> {
    let components = wireframe.components();
    let component = components.first().context("a component")?;
    let first = PlanOptions { doubling: DoublingChoice::Cheapest, contacts: true, ..PlanOptions::default() };
    let begin = Instant::now();
    let plain = plan_wires(wireframe, component, machine, &first, |_| ());
    let plain_ms = begin.elapsed().as_secs_f64() * 1000.0;
    let bends: usize = plain.iter().filter_map(|wire| Some(wire.nominal.as_ref()?.bend_count())).sum();
    let mut line = format!(
        "{name:<16} {:>6} {bends:>6} | {:>8} {plain_ms:>9.1}",
        component.edges.len(),
        contacts(&plain)
    );
    let mut in_the_way = String::new();
    let mut clear = [false; 2];
    for (clear, max_wires) in clear.iter_mut().zip(WIRES) {
        // One wire has all of the time; with two each number has its share of steps.
        let defaults = SearchOptions::default();
        let effort = if max_wires > 1 { defaults.effort } else { u64::MAX };
        let wanted =
            PlanOptions { search: Some(SearchOptions { effort, max_wires, ..defaults }), ..first.clone() };
        let begin = Instant::now();
        let found = plan_wires(wireframe, component, machine, &wanted, Timed { until: begin + time });
        let seconds = begin.elapsed().as_secs_f64();
        let searched = found.first().and_then(|wire| wire.searched);
        *clear = searched.is_some_and(|searched| searched.found);
        if *clear {
            check(name, wireframe, machine, &found)?;
        }
        let length: f64 = found.iter().filter_map(|wire| Some(wire.nominal.as_ref()?.length().mm())).sum();
        let came_to = match *clear {
            true if max_wires == 1 => "found".to_owned(),
            true => format!("{} wires", found.len()),
            false => format!("{} left", contacts(&found)),
        };
        if !*clear && max_wires == 1 {
            in_the_way = searched.map_or_else(
                || "not searched: its first program cannot be bent".to_owned(),
                |searched| obstacle(machine, &searched),
            );
        }
        let checks = searched.map_or(0, |searched| searched.checks);
        write!(line, " | {came_to:>9} {checks:>8} {seconds:>7.1} {length:>8.0}")?;
    }
    println!("{line} {in_the_way}");
    Ok(Shown { first_clear: contacts(&plain) == 0, clear })
}

/// What is in the way of one wire where the search came farthest.
fn obstacle(machine: &Machine, searched: &Searched) -> String {
    let Some(Obstruction { passed, of, obstacle, .. }) = searched.obstruction else {
        return "one wire: nothing is known to be in the way".to_owned();
    };
    let what = match obstacle {
        Some(Obstacle::Body(index)) => {
            machine.bodies.all.get(index).map_or("a body", |body| body.name.as_str())
        }
        Some(Obstacle::Stock) => "its own wire",
        None => "the turn of the head",
    };
    let all = if searched.exhausted { ", every walk tried" } else { "" };
    format!("one wire: {what} at edge {passed} of {of}{all}")
}

fn contacts(wires: &[WirePlan]) -> usize {
    let of_wire =
        |wire: &WirePlan| wire.contacts.iter().flatten().map(|first| 1 + first.later).sum::<usize>();
    wires.iter().map(of_wire).sum()
}

/// That neither the check nor the bender of points refuses what was found.
fn check(name: &str, wireframe: &Wireframe, machine: &Machine, found: &[WirePlan]) -> Result<()> {
    ensure!(contacts(found) == 0, "{name}: what is found is refused by the check");
    for wire in found {
        let (Some(scheduled), Some(nominal), Some(route)) = (&wire.scheduled, &wire.nominal, &wire.route)
        else {
            continue;
        };
        let passages = passages(wireframe, &route.traversals, &nominal.spans);
        let nearest = nearest(machine, &scheduled.steps, passages, STRIDE);
        let apart = nearest.map_or(f64::INFINITY, |(_, least)| least - machine.wire.diameter.mm() / 2.0);
        ensure!(apart > -EXACT, "{name}: the bender meets {nearest:?}");
    }
    Ok(())
}
