//! The rounds of a search for so many wires: from every start, with more and more chance in the order of moves and in what is doubled.

use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::heads::Orientation;
use super::objective::Order;
use super::trail::Passes;
use super::walk::Walk;
use super::{
    Bender, Found, Obstruction, SearchOptions, SearchTask, farther, orientations, orientations_between,
};
use crate::route::doubling_weighed;
use crate::wireframe::{Component, EdgeId, Wireframe};

/// How far the weights of edges are from their lengths in each round, as a share of them, over and over. The first doubling is the
/// cheapest, the next ones are equally short, and some are longer: a doubled edge costs less than a further wire.
const SPREADS: [f64; 10] = [0.0, 1e-6, 1e-6, 1e-6, 1e-6, 0.1, 1e-6, 0.3, 1e-6, 0.6];

/// From so many starts and orientations at most a round begins; of more, chance takes some.
const MAX_BEGINS: usize = 16;

/// A search for so many wires.
pub(super) struct Search<'a> {
    pub wireframe: &'a Wireframe,
    pub component: &'a Component,
    pub bender: &'a Bender<'a>,
    pub task: &'a SearchTask<'a>,
    pub options: &'a SearchOptions,
    pub wires: usize,
    /// How many steps were checked.
    pub checks: u64,
    /// Whether every walk was tried.
    pub exhausted: bool,
    /// What was in the way where it came farthest.
    pub obstruction: Option<Obstruction>,
}

impl<'a> Search<'a> {
    pub const fn new(
        (wireframe, component): (&'a Wireframe, &'a Component),
        bender: &'a Bender<'a>,
        task: &'a SearchTask<'a>,
        options: &'a SearchOptions,
        wires: usize,
    ) -> Self {
        Self {
            wireframe,
            component,
            bender,
            task,
            options,
            wires,
            checks: 0,
            exhausted: false,
            obstruction: None,
        }
    }

    /// The best wires that it finds: after the first ones it goes on for as long again.
    /// `should_continue` is told how many steps were checked, and how good the best is.
    pub fn run(&mut self, should_continue: &mut dyn FnMut(u64, Option<Order>) -> bool) -> Option<Found> {
        let mut rng = ChaCha8Rng::seed_from_u64(self.options.seed);
        let mut best: Option<(Found, Order)> = None;
        let order_of = |best: &Option<(Found, Order)>| best.as_ref().map(|(_, order)| *order);
        let mut until = self.options.effort;
        for round in 0.. {
            let spread = SPREADS[round % SPREADS.len()];
            // Doubled for fewer wires, there are some left that may begin anywhere.
            let wires = self.wires - (round / 2) % self.wires;
            let Some(doubled) = self.doubled(wires, spread, &mut rng) else { break };
            let passes = Passes::new(self.wireframe, self.component, &doubled);
            let none = vec![false; passes.all.len()];
            if passes.wires_needed(&none, None) > self.wires {
                break;
            }
            let (begins, are_all) = self.begins(&passes, round > 0, &mut rng);
            if begins.is_empty() {
                break;
            }
            let is_settled = self.task.doubled.is_some() || doubled.is_empty();
            let mut exhausted = self.wires == 1 && is_settled && are_all;
            for begin in begins {
                let noise = f64::from(u32::try_from(round.min(8)).unwrap_or(8)) / 2.0;
                let known = order_of(&best);
                let goes_on = &mut |checks| should_continue(checks, known);
                let (found, all) = self.descend(&passes, (begin, noise), until, &mut rng, goes_on);
                exhausted &= all;
                if let Some(found) = found {
                    if best.is_none() {
                        until = until.min(2 * self.checks);
                    }
                    let order = self.options.objective.order(self.wireframe, &found);
                    if best.as_ref().is_none_or(|(_, best)| order < *best) {
                        best = Some((found, order));
                    }
                }
                if self.checks >= until || !should_continue(self.checks, order_of(&best)) {
                    return best.map(|(found, _)| found);
                }
            }
            // All trails of a wire were looked at, with the part in every position that is tried: there are others between these.
            if exhausted && round > 0 {
                let goes_on = &mut |checks| should_continue(checks, None);
                let between = best.is_none().then(|| self.between(&passes, until, &mut rng, goes_on));
                return best.map(|(found, _)| found).or(between.flatten());
            }
        }
        best.map(|(found, _)| found)
    }

    /// The same with the part standing about the wire between the positions that were tried, closer and closer.
    fn between(
        &mut self,
        passes: &Passes,
        until: u64,
        rng: &mut ChaCha8Rng,
        should_continue: &mut dyn FnMut(u64) -> bool,
    ) -> Option<Found> {
        let starts = self.starts(passes);
        let mut exhausted = true;
        for orientation in orientations_between(self.bender.head) {
            for &start in &starts {
                let begin = ((start, orientation), 0.0);
                let (found, all) = self.descend(passes, begin, until, rng, should_continue);
                exhausted &= all;
                if found.is_some() || self.checks >= until || !should_continue(self.checks) {
                    return found;
                }
            }
        }
        self.exhausted = exhausted;
        None
    }

    /// What one descent finds, with so much chance in the order of moves; and whether it has looked at all trails from there.
    fn descend(
        &mut self,
        passes: &Passes,
        (begin, noise): ((usize, Orientation), f64),
        until: u64,
        rng: &mut ChaCha8Rng,
        should_continue: &mut dyn FnMut(u64) -> bool,
    ) -> (Option<Found>, bool) {
        let mut walk = Walk::new(self.wireframe, self.bender, passes, self.wires, rng);
        let before = self.checks;
        let found = walk
            .descend(begin, noise, &mut |checks| before + checks < until && should_continue(before + checks));
        // Where nothing can be checked at all, it must come to an end, too.
        self.checks += walk.checks.max(1);
        self.obstruction = farther(self.obstruction, walk.obstruction);
        (found, walk.exhausted)
    }

    /// Where a wire may begin.
    fn starts(&self, passes: &Passes) -> Vec<usize> {
        let none = vec![false; passes.all.len()];
        let chosen = self.task.start.and_then(|start| passes.vertices.binary_search(&start).ok());
        chosen.map_or_else(|| passes.starts(&none), |start| vec![start])
    }

    /// Which edges are passed once more, for so many wires.
    fn doubled(&self, wires: usize, spread: f64, rng: &mut ChaCha8Rng) -> Option<Vec<EdgeId>> {
        let task = self.task;
        if let Some(doubled) = task.doubled {
            return Some(doubled.to_vec());
        }
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss)]
        // up to 1e15 nm
        let mut weigh = |length: u64| {
            let more = if spread > 0.0 { spread * rng.random::<f64>() } else { 0.0 };
            length + (length as f64 * more) as u64
        };
        let ends = (task.start, task.closed);
        Some(doubling_weighed(self.wireframe, self.component, ends, wires, &mut weigh).ok()?.edges)
    }

    /// Where wires may begin and how they stand, in an order of chance; and whether these are all.
    fn begins(
        &self,
        passes: &Passes,
        turned: bool,
        rng: &mut ChaCha8Rng,
    ) -> (Vec<(usize, Orientation)>, bool) {
        let starts = self.starts(passes);
        let orientations = orientations(self.bender.head, turned);
        let mut begins: Vec<(usize, Orientation)> = orientations
            .into_iter()
            .flat_map(|orientation| starts.iter().map(move |&start| (start, orientation)))
            .collect();
        for k in (1..begins.len()).rev() {
            begins.swap(k, rng.random_range(0..=k));
        }
        let count = begins.len();
        begins.truncate(MAX_BEGINS);
        (begins, count <= MAX_BEGINS)
    }
}
