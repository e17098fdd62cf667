//! Every pulse since the power came on, and the lines of a job in them.

use std::ops::Range;

use wirebend_driver_api::Axis;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Pulse {
    /// When, in cycles.
    pub at: u64,
    pub axis: Axis,
    pub forward: bool,
}

#[derive(Debug, Clone, Default)]
pub struct Pulses {
    all: Vec<Pulse>,
    /// Index of the first of the feed.
    first_feed: Option<usize>,
}

impl Pulses {
    pub fn push(&mut self, pulse: Pulse) {
        if pulse.axis == Axis::Feed && self.first_feed.is_none() {
            self.first_feed = Some(self.all.len());
        }
        self.all.push(pulse);
    }

    pub fn last(&self) -> Option<Pulse> {
        self.all.last().copied()
    }

    pub fn len(&self) -> usize {
        self.all.len()
    }

    pub fn all(&self) -> &[Pulse] {
        &self.all
    }

    /// From the first pulse of the feed on: what is before belongs to homing.
    pub fn job(&self) -> &[Pulse] {
        &self.all[self.first_feed.unwrap_or(self.all.len())..]
    }
}

/// Pulses forward less those back.
pub fn net(pulses: &[Pulse], axis: Axis) -> i64 {
    let mine = pulses.iter().filter(|pulse| pulse.axis == axis);
    mine.map(|pulse| if pulse.forward { 1 } else { -1 }).sum()
}

/// Axis and direction of each: what a motor has done, whenever that was.
pub fn ways(pulses: &[Pulse]) -> Vec<(Axis, bool)> {
    pulses.iter().map(|pulse| (pulse.axis, pulse.forward)).collect()
}

/// The lines of a job: each begins with its feed.
pub fn lines(job: &[Pulse]) -> Vec<Range<usize>> {
    let begins = |at: &usize| job[*at].axis == Axis::Feed && (*at == 0 || job[*at - 1].axis != Axis::Feed);
    let starts: Vec<usize> = (0..job.len()).filter(begins).collect();
    let ends = starts.iter().skip(1).copied().chain([job.len()]);
    starts.iter().copied().zip(ends).map(|(start, end)| start..end).collect()
}
