//! Moments in a job, by what can be seen of it, and what is done at them.

use wirebend_driver_api::Axis;

use super::Bender;
use super::pulses::{Pulse, lines};
use wirebend_tests_firmware::board::{Board, MS};

/// What a line does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    Feed,
    /// Turns the head; swings where the line does not turn it.
    Rotate,
    /// Waits for the peg to come out.
    Peg,
    Swing,
    /// Brings the bend axis back to zero.
    Return,
}

/// A moment: so many pulses of the job, and some time after the last of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Moment {
    pub pulses: usize,
    pub cycles: u64,
}

/// Longer than between two pulses of a move, shorter than the peg takes.
const GAP: u64 = 25 * MS;

impl Moment {
    /// In a line, from 0, of a job that was run before: so many per cent of a phase. A line without a bend only feeds.
    pub fn of(job: &[Pulse], line: usize, phase: Phase, percent: usize) -> Self {
        let range = lines(job)[line].clone();
        let moves = moves(&job[range.clone()]);
        let at = |index: usize| {
            let (start, end) = moves[index];
            Self { pulses: range.start + start + (end - start) * percent / 100, cycles: 0 }
        };
        let is = |index: usize, axis| job[range.start + moves[index].0].axis == axis;
        let turns = moves.len() > 1 && is(1, Axis::Rotate);
        // To the near side, with the peg the other way, off the wire and back.
        let near = if turns { 2 } else { 1 };
        match phase {
            _ if moves.len() == 1 => at(0),
            Phase::Feed => at(0),
            Phase::Rotate if turns => at(1),
            Phase::Peg => Self { pulses: range.start + moves[near].1, cycles: GAP },
            Phase::Rotate | Phase::Swing => at(near + 1),
            Phase::Return => at(moves.len() - 1),
        }
    }
}

/// Runs of pulses one way on one axis, without a break.
fn moves(pulses: &[Pulse]) -> Vec<(usize, usize)> {
    let same = |a: &Pulse, b: &Pulse| a.axis == b.axis && a.forward == b.forward && b.at - a.at < GAP;
    let mut start = 0;
    let runs = pulses.chunk_by(same).map(|run| {
        start += run.len();
        (start - run.len(), start)
    });
    runs.collect()
}

type When<B> = Box<dyn FnMut(&Bender<B>) -> bool + Send>;
type Then<B> = Box<dyn FnOnce(&mut Bender<B>) + Send>;

/// What is done when something is so.
pub(super) struct Watch<B> {
    when: When<B>,
    then: Then<B>,
}

impl<B: Board> Bender<B> {
    /// Does something as soon as something is so: looked at after every pulse and every millisecond.
    pub fn watch(
        &mut self,
        when: impl FnMut(&Self) -> bool + Send + 'static,
        then: impl FnOnce(&mut Self) + Send + 'static,
    ) {
        self.watches.push(Watch { when: Box::new(when), then: Box::new(then) });
    }

    /// Does something at a moment of the job.
    pub fn at(&mut self, moment: Moment, then: impl FnOnce(&mut Self) + Send + 'static) {
        let reached = move |bender: &Self| {
            let last = bender.pulses.last().map_or(0, |pulse| pulse.at);
            bender.pulses.job().len() >= moment.pulses && bender.board.now() >= last + moment.cycles
        };
        self.watch(reached, then);
    }

    pub(super) fn look(&mut self) {
        for mut watch in std::mem::take(&mut self.watches) {
            if (watch.when)(self) {
                (watch.then)(self);
            } else {
                self.watches.push(watch);
            }
        }
    }
}
