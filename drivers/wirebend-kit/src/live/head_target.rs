//! Turns of the head in whole steps of its motor, so that it stands as near as it can to where the program has it: turns that are
//! rounded one by one add up to more than the firmware lets it turn.

use crate::settings::steps;

/// Where the head was sent, degrees from its zero, and where its motor stands for it, steps.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct HeadTarget {
    deg: f64,
    at: i32,
}

impl HeadTarget {
    pub fn at(deg: f64, steps_per_deg: f64) -> Self {
        Self { deg, at: steps(deg * steps_per_deg) }
    }

    /// The steps of a turn from there.
    pub fn turn(&mut self, by_deg: f64, steps_per_deg: f64) -> i32 {
        let before = self.at;
        *self = Self::at(self.deg + by_deg, steps_per_deg);
        self.at - before
    }

    pub const fn steps(self) -> i32 {
        self.at
    }
}
