//! Which parts of a chain are asked about.

use crate::chain::{Chain, Interval, Run};

/// Parts of a chain, and the runs of its tree in which they lie, so that nothing else of it is looked at.
#[derive(Debug, Clone)]
pub struct Parts<'a> {
    chain: &'a Chain,
    intervals: Vec<Interval>,
    /// In the order of the chain. Each counts as a whole, but for single pieces that count in part.
    runs: Vec<Run>,
}

impl<'a> Parts<'a> {
    /// These intervals of a chain, which are in order and apart from each other. One that only touches an end of the chain counts nothing.
    #[must_use]
    pub fn of(chain: &'a Chain, intervals: Vec<Interval>) -> Self {
        let mut parts = Self { chain, intervals, runs: Vec::new() };
        if let Some(all) = chain.all() {
            parts.gather(all);
        }
        parts
    }

    /// A whole chain.
    #[must_use]
    pub fn whole(chain: &'a Chain) -> Self {
        Self::of(chain, vec![Interval { from: 0.0, to: f64::INFINITY }])
    }

    /// The chain.
    #[must_use]
    pub const fn chain(&self) -> &'a Chain {
        self.chain
    }

    /// The intervals.
    #[must_use]
    pub fn intervals(&self) -> &[Interval] {
        &self.intervals
    }

    pub(crate) fn runs(&self) -> &[Run] {
        &self.runs
    }

    /// What counts of an interval.
    pub(crate) fn within(&self, interval: Interval) -> impl Iterator<Item = Interval> {
        let clipped = move |part: &Interval| Interval {
            from: part.from.max(interval.from),
            to: part.to.min(interval.to),
        };
        self.at(interval).map(clipped)
    }

    /// Those that have a point in an interval.
    fn at(&self, interval: Interval) -> impl Iterator<Item = &Interval> {
        let after = self.intervals.partition_point(|part| part.to < interval.from);
        self.intervals[after..].iter().take_while(move |part| part.from <= interval.to)
    }

    /// Adds the runs of a run that count.
    fn gather(&mut self, run: Run) {
        let chain = self.chain;
        let extent = chain.extent(run);
        // What only touches it counts in its neighbour, unless one of both is no more than a point.
        let counts = |part: &&Interval| {
            let is_point = part.from >= part.to || extent.from >= extent.to;
            is_point || (part.from < extent.to && part.to > extent.from)
        };
        let Some(part) = self.at(extent).find(counts) else { return };
        let is_whole = part.from <= extent.from && part.to >= extent.to;
        match chain.halves(run) {
            Some(halves) if !is_whole => halves.into_iter().for_each(|half| self.gather(half)),
            _ => self.runs.push(run),
        }
    }
}
