//! What the commands of a program leave is computed once, not once for each wire that is drawn: the cube of 8 edges, with and without.

use std::ops::ControlFlow;
use std::time::Instant;

use anyhow::{Result, ensure};
use wirebend_core::plan::Machine;
use wirebend_core::simulate::{ImperfectWire, SimulationInput, simulate, wire_of_run};

use super::{errors, with_wire};

const RUNS: u32 = 200;
/// The least of so many times is taken.
const TIMES: usize = 20;
/// At least so many times as fast: for each wire the inversion is nearly all of the work.
const AIM: f64 = 30.0;

pub(super) fn measure(machine: &Machine) -> Result<()> {
    with_wire("cube-8-edges", false, machine, |_, input| compare(input))
}

fn compare(input: &SimulationInput) -> Result<()> {
    let (mut once, mut each) = (f64::INFINITY, f64::INFINITY);
    let (mut together, mut alone) = (Vec::new(), Vec::new());
    simulate(input, &errors(), RUNS, 1, |wire| {
        together.push(wire.clone());
        ControlFlow::Continue(())
    })?;
    for _ in 0..TIMES {
        let begin = Instant::now();
        simulate(input, &errors(), RUNS, 1, |_| ControlFlow::Continue(()))?;
        once = once.min(begin.elapsed().as_secs_f64());
        let begin = Instant::now();
        alone = one_by_one(input)?;
        each = each.min(begin.elapsed().as_secs_f64());
    }
    println!("{RUNS} wires of the cube of 8 edges");
    println!(
        "  commands turned back once {:.2} ms, for each wire {:.2} ms: {:.1} times as fast; the same wires bit for bit",
        1000.0 * once,
        1000.0 * each,
        each / once
    );
    ensure!(together.len() == alone.len(), "as many wires");
    ensure!(together.iter().zip(&alone).all(|(one, other)| is_same(one, other)), "other wires come out");
    ensure!(each / once >= AIM, "{:.1} times as fast, {AIM} wanted", each / once);
    Ok(())
}

/// The same wires, with the commands turned back for each, on as many processors.
fn one_by_one(input: &SimulationInput) -> Result<Vec<ImperfectWire>> {
    let threads = u32::try_from(std::thread::available_parallelism()?.get())?.min(RUNS);
    let part = RUNS.div_ceil(threads);
    let wires =
        |first: u32| (first..(first + part).min(RUNS)).map(|run| wire_of_run(input, &errors(), 1, run));
    let mut all = Vec::with_capacity(RUNS as usize);
    std::thread::scope(|scope| {
        let work = |first| scope.spawn(move || wires(first).collect::<Result<Vec<_>, _>>());
        let parts: Vec<_> = (0..RUNS).step_by(part as usize).map(work).collect();
        for part in parts {
            all.extend(part.join().map_err(|_| anyhow::anyhow!("a thread failed"))??);
        }
        Ok(all)
    })
}

fn is_same(one: &ImperfectWire, other: &ImperfectWire) -> bool {
    let bits = |wire: &ImperfectWire| -> Vec<[u64; 3]> {
        wire.points.iter().map(|point| [point.x, point.y, point.z].map(f64::to_bits)).collect()
    };
    bits(one) == bits(other) && one == other
}
