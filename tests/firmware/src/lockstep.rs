//! The core on a computer and the binary of the board make the same of a job, pulse by pulse.

#![allow(clippy::unwrap_used)] // a test may stop at what cannot be
#![allow(clippy::print_stdout)] // figures, for --nocapture

use crate::board::{Avr, Board, Host, MS, Observation, What};
use crate::job::Job;

/// How far an interval between two pulses of a move may differ from the other's, cycles of 62.5 ns: each pulse waits
/// for the interrupts before it, of which there may be two, and none takes 120 cycles.
const JITTER: u64 = 240;
/// The longest interval of a move: its first, 1912017 / sqrt(4000 steps/s²) ticks of 8 cycles. The peg alone takes
/// 500 ms, so two pulses that are closer and alike are of one move.
const ONE_MOVE: u64 = 20 * MS;

/// Steps of the lines of a job, from a file of `tests/all/controller/steps`.
///
/// # Panics
/// When it is no such file.
#[must_use]
pub fn lines(file: &str) -> Vec<[i32; 3]> {
    let rows = file.lines().skip(1).map(|row| row.split(',').map(|n| n.parse().unwrap()).collect::<Vec<_>>());
    rows.map(|row| row.try_into().unwrap()).collect()
}

fn make<B: Board>(lines: &[[i32; 3]]) -> Job<B> {
    let mut job = Job::<B>::ready();
    job.make(lines);
    // At the start, where the core has no say.
    job.table.seen.retain(|seen| seen.what != What::Motors(false));
    job
}

/// How far the intervals between pulses of one move differ, cycles: the most.
fn jitter(host: &[Observation], avr: &[Observation]) -> u64 {
    let mut worst = 0;
    for (host, avr) in host.windows(2).zip(avr.windows(2)) {
        let (expected, found) = (host[1].at - host[0].at, avr[1].at - avr[0].at);
        let pulses = matches!(host[0].what, What::Pulse { .. });
        if pulses && host[0].what == host[1].what && expected < ONE_MOVE {
            worst = worst.max(expected.abs_diff(found));
        }
    }
    worst
}

/// Runs a job on both and compares everything that is seen.
///
/// # Panics
/// At the first difference.
pub fn in_lockstep(name: &str, lines: &[[i32; 3]]) {
    let (host, avr) = (make::<Host>(lines), make::<Avr>(lines));
    let (host_seen, avr_seen) = (&host.table.seen, &avr.table.seen);
    for (i, (host, avr)) in host_seen.iter().zip(avr_seen).enumerate() {
        assert_eq!(host.what, avr.what, "{name}: number {i} of what is seen; core {host:?}, board {avr:?}");
    }
    assert_eq!(host_seen.len(), avr_seen.len(), "{name}: one does more than the other");
    let sum = |axis: usize| lines.iter().map(|line| i64::from(line[axis])).sum::<i64>();
    assert_eq!(host.table.counted[..2], [sum(0), sum(1)], "{name}: what was asked and what was done");
    let uno = &avr.table.board.uno;
    assert_eq!((uno.overruns(), uno.lost_sending()), (0, 0), "{name}: bytes lost");
    let worst = jitter(host_seen, avr_seen);
    let seconds = avr.table.board.now() / (1000 * MS);
    println!(
        "{name}: {} lines, {} pulses alike in {seconds} s of the machine; intervals differ by {worst} cycles at most",
        lines.len(),
        host.table.pulses()
    );
    assert!(worst <= JITTER, "{name}: {worst} cycles");
}
