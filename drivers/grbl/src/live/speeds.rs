//! What the speed override of grbl can be, and the real-time commands that change it.

use crate::settings::{Moves, Settings};

pub(super) const FEED_FULL: u8 = 0x90;
const FEED_PLUS_10: u8 = 0x91;
const FEED_MINUS_10: u8 = 0x92;
const FEED_PLUS_1: u8 = 0x93;
const FEED_MINUS_1: u8 = 0x94;
pub(super) const RAPID_FULL: u8 = 0x95;
const RAPID_HALF: u8 = 0x96;
const RAPID_QUARTER: u8 = 0x97;
/// From here on a step of ten and some of one back are fewer than steps of one alone.
const COARSE: i32 = 6;
/// A report that was under way when a step was sent, one in which it may not show yet, and as many again.
pub(super) const REPORTS: u8 = 5;
/// What rapid moves can have.
const RAPIDS: [u8; 3] = [25, 50, 100];

/// How fast it is, percent of what the program says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Speeds {
    /// Moves with a feed rate.
    pub feed: u8,
    /// Rapid moves: 100, 50 or 25.
    pub rapid: u8,
}

pub(super) const FULL: Speeds = Speeds { feed: 100, rapid: 100 };

impl Speeds {
    /// The values of an `Ov` field; what it does to the spindle comes after these.
    pub fn reported(values: &str) -> Option<Self> {
        let mut values = values.split(',').map(str::parse);
        Some(Self { feed: values.next()?.ok()?, rapid: values.next()?.ok()? })
    }

    /// What the machine can do of a speed that is asked for. Of rapid moves the next one in that direction.
    pub fn nearest(self, percent: u8) -> Self {
        let rapid = if percent > self.rapid {
            RAPIDS.into_iter().find(|rapid| *rapid >= percent)
        } else {
            RAPIDS.into_iter().rev().find(|rapid| *rapid <= percent).or(Some(RAPIDS[0]))
        };
        Self { feed: percent, rapid: rapid.unwrap_or(FULL.rapid) }
    }

    /// That of the moves of a program.
    pub const fn of_moves(self, settings: &Settings) -> u8 {
        match settings.moves {
            Moves::FeedRate => self.feed,
            Moves::Rapid => self.rapid,
        }
    }

    /// One step of each kind towards what is wanted.
    pub fn towards(self, wanted: Self) -> Vec<u8> {
        let by = i32::from(wanted.feed) - i32::from(self.feed);
        let feed = match by {
            0 => None,
            _ if wanted.feed == FULL.feed => Some(FEED_FULL),
            COARSE.. => Some(FEED_PLUS_10),
            1.. => Some(FEED_PLUS_1),
            _ if by <= -COARSE => Some(FEED_MINUS_10),
            _ => Some(FEED_MINUS_1),
        };
        let rapid = (wanted.rapid != self.rapid).then_some(match wanted.rapid {
            100 => RAPID_FULL,
            50 => RAPID_HALF,
            _ => RAPID_QUARTER,
        });
        feed.into_iter().chain(rapid).collect()
    }
}

/// What is known of it.
#[derive(Debug)]
pub(super) struct SpeedOverride {
    /// What the machine has; none before it has said so or was told all of it.
    pub now: Option<Speeds>,
    /// Whether its reports have it at all: that is chosen where grbl is compiled.
    pub reported: bool,
    pub wanted: Option<Speeds>,
    /// How many more reports may come without the effect of the step that was sent; 0 where none is on its way.
    pub awaited: u8,
    /// What was reported to the program.
    pub told: u8,
}

impl Default for SpeedOverride {
    fn default() -> Self {
        Self { now: None, reported: false, wanted: None, awaited: 0, told: 100 }
    }
}

impl SpeedOverride {
    /// A reset ends it.
    pub fn was_reset(&mut self) {
        (self.now, self.wanted, self.awaited) = (Some(FULL), None, 0);
    }
}
