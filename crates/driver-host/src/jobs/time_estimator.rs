//! How long a wire still takes: what was estimated, scaled by how long it has taken so far.

use std::time::Duration;

/// Estimates of a wire's steps against the clock.
#[derive(Debug, Clone)]
pub(super) struct TimeEstimator {
    /// Of each step, in order.
    estimates: Vec<Duration>,
    /// Estimated time of the steps that were measured, and what they took at the programmed speed.
    estimated: Duration,
    measured: Duration,
    /// The moment from which the step under way counts; none while the machine holds or nothing is under way.
    since: Option<Duration>,
    /// What of it was done before that, as the time that it takes at the programmed speed.
    before: Duration,
    /// After how many steps the wire goes on, and what of the next one was done before, as it was estimated.
    begun: (u32, Duration),
    /// How fast the machine is, of the programmed speed.
    speed: f64,
}

/// Without any estimate, seconds. It only shapes a bar that is scaled at once.
const UNKNOWN: Duration = Duration::from_secs(10);

impl TimeEstimator {
    /// `estimates` may be fewer than there are steps: those that are missing are taken for what the others are
    /// on average.
    pub fn new(mut estimates: Vec<Duration>, steps: u32) -> Self {
        let count = u32::try_from(estimates.len()).unwrap_or(u32::MAX).max(1);
        let mean = estimates.iter().sum::<Duration>() / count;
        let fill = if mean.is_zero() { UNKNOWN } else { mean };
        estimates.resize(usize::try_from(steps).unwrap_or(usize::MAX), fill);
        Self {
            estimates,
            estimated: Duration::ZERO,
            measured: Duration::ZERO,
            since: None,
            before: Duration::ZERO,
            begun: (0, Duration::ZERO),
            speed: 1.0,
        }
    }

    /// The machine has something to do; nothing changes where it already had.
    pub fn works(&mut self, now: Duration) {
        self.since.get_or_insert(now);
    }

    /// The machine holds: that time counts for nothing.
    pub fn holds(&mut self, now: Duration) {
        self.before = self.under_way(now);
        self.since = None;
    }

    /// The machine is slower or faster from now on.
    pub fn goes_at(&mut self, percent: u8, now: Duration) {
        self.before = self.under_way(now);
        self.since = self.since.map(|_| now);
        self.speed = f64::from(percent.max(1)) / 100.0;
    }

    /// The wire goes on in the step after the first `done`, of which so much was done before.
    pub const fn goes_on(&mut self, done: u32, made: Duration) {
        self.begun = (done, made);
    }

    /// A step is done; `more`: the machine has another one already.
    pub fn made(&mut self, n: u32, now: Duration, more: bool) {
        self.holds(now);
        self.measured += std::mem::take(&mut self.before);
        self.estimated += self.estimate(n);
        self.since = more.then_some(now);
    }

    /// What the steps after `done` will take.
    pub fn remaining(&self, done: u32, now: Duration) -> Duration {
        let skip = usize::try_from(done).unwrap_or(usize::MAX);
        let begun = if done == self.begun.0 { self.begun.1 } else { Duration::ZERO };
        let left = self.estimates.iter().skip(skip).sum::<Duration>().saturating_sub(begun);
        let scaled = if self.estimated.is_zero() {
            left
        } else {
            // Both are far below what a float counts exactly.
            left.mul_f64(self.measured.as_secs_f64() / self.estimated.as_secs_f64())
        };
        scaled.saturating_sub(self.under_way(now)).div_f64(self.speed)
    }

    /// What of the step under way is done.
    fn under_way(&self, now: Duration) -> Duration {
        let since = self.since.map_or(Duration::ZERO, |since| now.saturating_sub(since));
        self.before + since.mul_f64(self.speed)
    }

    /// What is left of a step where the wire goes on in it, or all of it.
    fn estimate(&self, n: u32) -> Duration {
        let at = usize::try_from(n).unwrap_or(usize::MAX).wrapping_sub(1);
        let whole = self.estimates.get(at).copied().unwrap_or_default();
        if n == self.begun.0.saturating_add(1) { whole.saturating_sub(self.begun.1) } else { whole }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const fn s(seconds: u64) -> Duration {
        Duration::from_secs(seconds)
    }

    /// Steps of 10, 20 and 30 s. The first takes 15 s: half as long again, so 75 s are left of 50.
    #[test]
    fn what_is_left_is_scaled_by_what_was_measured() {
        let mut pace = TimeEstimator::new(vec![s(10), s(20), s(30)], 3);
        assert_eq!(pace.remaining(0, s(100)), s(60));
        pace.works(s(100));
        assert_eq!(pace.remaining(0, s(104)), s(56));
        pace.made(1, s(115), true);
        assert_eq!(pace.remaining(1, s(115)), s(75));
        assert_eq!(pace.remaining(1, s(120)), s(70));
    }

    /// Over lunch the machine holds; that says nothing of how fast it is.
    #[test]
    fn a_pause_does_not_count() {
        let mut pace = TimeEstimator::new(vec![s(10), s(20)], 2);
        pace.works(s(0));
        pace.holds(s(4));
        assert_eq!(pace.remaining(0, s(3600)), s(26));
        pace.works(s(3600));
        pace.made(1, s(3606), false);
        assert_eq!(pace.remaining(1, s(9999)), s(20));
    }

    /// Half of the first step at full speed, the other half at a tenth of it: 5 and 50 s. The second takes ten times as long as it would,
    /// and not ten times as long as the first has taken.
    #[test]
    fn a_speed_counts_from_when_it_is_set() {
        let mut pace = TimeEstimator::new(vec![s(10), s(20)], 2);
        pace.works(s(0));
        pace.goes_at(10, s(5));
        assert_eq!(pace.remaining(0, s(5)), s(250));
        pace.made(1, s(55), true);
        assert_eq!(pace.remaining(1, s(55)), s(200));
        assert_eq!(pace.remaining(1, s(155)), s(100));
        pace.goes_at(200, s(155));
        assert_eq!(pace.remaining(1, s(155)), s(5));
    }

    #[test]
    fn a_step_that_takes_longer_is_not_less_than_nothing() {
        let mut pace = TimeEstimator::new(vec![s(10)], 1);
        pace.works(s(0));
        assert_eq!(pace.remaining(0, s(50)), s(0));
        pace.made(1, s(50), false);
        assert_eq!(pace.remaining(1, s(50)), s(0));
    }

    /// Of the first 10 s are 8 done: the rest takes 3, half as long again as it should.
    #[test]
    fn what_was_done_before_does_not_count() {
        let mut pace = TimeEstimator::new(vec![s(10), s(20)], 2);
        pace.goes_on(0, s(8));
        assert_eq!(pace.remaining(0, s(0)), s(22));
        pace.works(s(0));
        pace.made(1, s(3), false);
        assert_eq!(pace.remaining(1, s(3)), s(30));
    }

    #[test]
    fn missing_estimates_are_those_of_the_others() {
        assert_eq!(TimeEstimator::new(vec![s(10), s(20)], 4).remaining(0, s(0)), s(60));
        assert_eq!(TimeEstimator::new(Vec::new(), 2).remaining(1, s(0)), UNKNOWN);
    }
}
