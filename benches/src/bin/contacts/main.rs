//! Contacts of random programs with the machine: how long they take, and whether a bender that only pushes, turns and winds points
//! finds the same.

#![allow(clippy::print_stdout, reason = "its output is the table")]

mod brute;
mod peer;

use std::time::Instant;

use anyhow::{Context, Result, ensure};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use wirebend_benches::{design, machine};
use wirebend_core::bend::{Frame, Step};
use wirebend_core::clearance::{Clearance, Contact, Passage, StockWire};
use wirebend_core::plan::{DoublingChoice, Machine, PlanOptions, clearance as clearance_of, plan_wires};
use wirebend_core::units::{Angle, Length};
use wirebend_core::wireframe::{EdgeId, VertexId};

/// So many programs are compared with the bender.
const PROGRAMS: u64 = 1000;
/// How many bends the programs have whose time is measured.
const BENDS: [usize; 4] = [10, 100, 300, 1000];
/// The least of so many runs is taken.
const RUNS: usize = 5;

fn main() -> Result<()> {
    let machine = machine()?;
    let mut arguments = std::env::args().skip(1);
    let python = arguments.next().context("name the peer's Python")?;
    let programs = arguments.next().map_or(Ok(PROGRAMS), |number| number.parse())?;
    println!("{:>8} {:>14} {:>14} {:>10}", "bends", "all, ms", "first, ms", "contacts");
    for bends in BENDS {
        let steps = program(u64::try_from(bends)?, bends)?;
        show(&bends.to_string(), || Ok(clearance(&machine, &steps)))?;
    }
    let bunny = design("bunny", true)?;
    let options = PlanOptions { doubling: DoublingChoice::Cheapest, ..PlanOptions::default() };
    let component = &bunny.components()[0];
    let plan = plan_wires(&bunny, component, &machine, &options, |_| ());
    let plan = plan.first().context("a wire")?;
    show("bunny", || clearance_of(&bunny, &machine, plan).context("a program"))?;
    peer::compare(&machine, &python)?;
    brute::compare(&machine, programs)
}

fn show<'a>(name: &str, made: impl Fn() -> Result<Clearance<'a>>) -> Result<()> {
    let mut best = (f64::INFINITY, f64::INFINITY, 0);
    for _ in 0..RUNS {
        let begin = Instant::now();
        let found = made()?.first_contacts();
        let all = begin.elapsed().as_secs_f64() * 1000.0;
        let begin = Instant::now();
        let mut one = made()?;
        let first = (0..one.steps()).find_map(|step| one.contacts_of(step).first().copied());
        let first_ms = begin.elapsed().as_secs_f64() * 1000.0;
        ensure!(first.is_some() != found.is_empty(), "the first contact is one of all");
        let contacts = found.iter().map(|first| 1 + first.later).sum::<usize>();
        best = (best.0.min(all), best.1.min(first_ms), contacts);
    }
    println!("{name:>8} {:>14.2} {:>14.2} {:>10}", best.0, best.1, best.2);
    Ok(())
}

/// A program of so many bends, each of another size and plane.
fn program(seed: u64, bends: usize) -> Result<Vec<Step>> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut steps = Vec::with_capacity(bends + 1);
    for _ in 0..bends {
        let size = random.random_range(15.0..120.0);
        steps.push(Step {
            feed: Length::from_mm(random.random_range(25.0..60.0))?,
            rotate: Angle::from_deg(random.random_range(-150.0..150.0))?,
            bend: Angle::from_deg(if random.random_bool(0.5) { size } else { -size })?,
        });
    }
    steps.push(Step { feed: Length::from_mm(40.0)?, ..Step::default() });
    Ok(steps)
}

/// Each step runs along an edge of its own.
fn passages(steps: &[Step]) -> Vec<Vec<(Passage, Length)>> {
    let passage = |(k, step): (u32, &Step)| {
        vec![(Passage { edge: EdgeId(k), from: VertexId(k), to: VertexId(k + 1) }, step.feed)]
    };
    (0..).zip(steps).map(passage).collect()
}

fn stock(machine: &Machine) -> StockWire {
    StockWire {
        diameter: machine.wire.diameter,
        bend_radius: machine.bend_radius,
        tail: machine.limits.tail.value,
        margin: Length::ZERO,
        hangs: None,
    }
}

fn clearance<'a>(machine: &'a Machine, steps: &[Step]) -> Clearance<'a> {
    let bend = &machine.compensation.bend;
    Clearance::new((Frame::default(), steps), None, passages(steps), stock(machine), &machine.bodies, bend)
}

/// All contacts of a program.
fn contacts(mut clearance: Clearance) -> Vec<Contact> {
    (0..clearance.steps()).flat_map(|step| clearance.contacts_of(step)).collect()
}
