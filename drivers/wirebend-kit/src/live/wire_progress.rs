//! The wire that is being bent, in its own numbers and in those of the controller's session.

use std::collections::VecDeque;
use std::fmt;

use wirebend_driver_api::{Run, Step};

/// A session and the steps of the wire that were done before it: what a journal keeps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Token {
    pub session: u16,
    /// How often the controller had started: it has lost nothing as long as that is so.
    pub boots: u32,
    pub after: u32,
}

impl Token {
    /// What this driver has written; `None` for what another has.
    pub fn parse(text: &str) -> Option<Self> {
        let mut parts = text.split('-');
        let session = parts.next()?.parse().ok().filter(|session| (1..u16::MAX).contains(session))?;
        let (boots, after) = (parts.next()?.parse().ok()?, parts.next()?.parse().ok()?);
        parts.next().is_none().then_some(Self { session, boots, after })
    }
}

impl fmt::Display for Token {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}-{}-{}", self.session, self.boots, self.after)
    }
}

/// A step as it was given.
#[derive(Debug, Clone, Copy)]
struct GivenStep {
    step: Step,
    /// What it feeds and turns, in steps of the motors: without `turn`, which comes before the first.
    motors: [i32; 2],
}

/// Steps are counted from 1; line n of the session is step `after + n`.
#[derive(Debug)]
pub(super) struct WireProgress {
    after: u32,
    pub steps: u32,
    pub given: u32,
    pub done: u32,
    /// The last step was given.
    pub closed: bool,
    /// Where the head stands before the next step, steps.
    pub rotate_at: i32,
    /// What the head has to turn besides with the next step, steps.
    pub turn: i32,
    /// Where the head stands was reported, or asked.
    pub placed: bool,
    /// Where feed and head stand when the first of `lines` begins, steps; nothing where that is not known, as in a session
    /// of before.
    began: Option<[i32; 2]>,
    /// The steps that were given and not done.
    lines: VecDeque<GivenStep>,
}

impl WireProgress {
    pub fn new(run: &Run, rotate_at: i32) -> Self {
        let Run { after, steps, .. } = *run;
        Self {
            after,
            steps,
            given: after,
            done: after,
            closed: false,
            rotate_at,
            turn: 0,
            placed: false,
            began: None,
            lines: VecDeque::new(),
        }
    }

    /// In a session that has taken and done lines already.
    pub fn resumed(token: Token, last: u32, done: u32) -> Self {
        let after = token.after;
        Self {
            after,
            steps: u32::MAX,
            given: after.saturating_add(last),
            done: after.saturating_add(done),
            closed: false,
            rotate_at: 0,
            turn: 0,
            placed: true,
            began: None,
            lines: VecDeque::new(),
        }
    }

    /// Where the axes stand before the first step: the feed as the controller counts it, the head as the wire does.
    pub const fn begins_at(&mut self, fed: i32) {
        self.began = Some([fed, self.rotate_at]);
    }

    /// A step was given.
    pub fn give(&mut self, n: u32, step: Step, motors: [i32; 2]) {
        self.given = n;
        self.lines.push_back(GivenStep { step, motors });
    }

    /// The steps that are done by now and were not before.
    pub fn made(&mut self, line: u32) -> std::ops::RangeInclusive<u32> {
        let from = self.done + 1;
        self.done = self.done.max(self.after.saturating_add(line)).min(self.given);
        for _ in from..=self.done {
            let given = self.lines.pop_front();
            self.began =
                self.began.zip(given).map(|([fed, turned], GivenStep { motors: [feed, rotate], .. })| {
                    [fed.wrapping_add(feed), turned.wrapping_add(rotate)]
                });
        }
        from..=self.done
    }

    /// How much of the step under way is fed and turned where the motors stand here, mm and degrees. `per`: steps for each.
    pub fn part_made(&self, at: [i32; 2], per: [f64; 2]) -> Option<[f64; 2]> {
        let (began, GivenStep { step, motors }) = (self.began?, *self.lines.front()?);
        let whole = [step.feed_mm, step.rotate_deg];
        Some(std::array::from_fn(|axis| {
            let made = f64::from(at[axis].wrapping_sub(began[axis]));
            match motors[axis] {
                0 => made / per[axis],
                // Motors do whole steps: what is done of them is done of the step.
                all => whole[axis] * made / f64::from(all),
            }
        }))
    }

    pub fn is_finished(&self) -> bool {
        self.closed && self.done == self.steps
    }

    /// The step in doubt, of which it is not known whether it was done.
    pub fn in_doubt(&self) -> Option<u32> {
        (self.given > self.done).then_some(self.done + 1)
    }
}
