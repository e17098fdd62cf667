//! A step that was ended in its middle: which one, and how much of it was made.

use wirebend_driver_api::{Event, Step};

use super::making::{Hold, Making};
use super::protocol::{Phase, Protocol};
use crate::settings::Settings;

/// A step that was ended in its middle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cut {
    step: u32,
    /// Where feed and head stood as it began, and the bend axis as the wire began, in mm and degrees as positions are told;
    /// nothing where nobody can tell how far it is.
    from: Option<Step>,
    /// What it feeds and turns, mm and degrees, and what cannot be told apart there.
    whole: [f64; 2],
    tolerance: [f64; 2],
    /// It stood before it was reset, and has lost no steps by it.
    exact: bool,
}

/// How an end treats what moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Manner {
    /// Slowed down, then reset at rest.
    Gently,
    /// Reset in motion: grbl itself says that it may have lost steps.
    AtOnce,
    /// It has met something, or lost its power: what it counts need not be where it stands.
    Blindly,
}

impl Cut {
    fn of(making: &Making, settings: &Settings, manner: Manner) -> Option<Self> {
        let (step, from, end) = making.under_way()?;
        let units = [settings.feed_units_per_mm, settings.rotate_units_per_deg];
        let whole = std::array::from_fn(|axis| (end[axis] - from[axis]) / units[axis]);
        let tolerance = making.tolerance().map_or([0.0; 2], |all| [all[0] / units[0], all[1] / units[1]]);
        let began = making.began_at.filter(|_| manner != Manner::Blindly);
        let from = began.map(|began| Step {
            feed_mm: began.feed_mm + from[0] / settings.feed_units_per_mm,
            rotate_deg: began.rotate_deg + from[1] / settings.rotate_units_per_deg,
            bend_deg: began.bend_deg,
        });
        let exact = manner == Manner::Gently || making.hold == Hold::Held;
        Some(Self { step, from, whole, tolerance, exact })
    }

    /// It was reset before it stood.
    pub fn in_motion(self) -> Self {
        Self { exact: false, ..self }
    }
}

impl Protocol {
    /// The wire that is made ends now; what was noted of its end before counts.
    pub(super) fn cut(&mut self, manner: Manner) {
        if let Phase::Making(making) = &self.phase {
            self.cut = Cut::of(making, &self.settings, manner);
        }
    }

    /// It stands: how far the step was that was cut.
    pub(super) fn tell_cut(&mut self) {
        let Some(Cut { step, from, whole, tolerance, exact }) = self.cut.take() else { return };
        let now = self.machine.position(&self.settings);
        // Motors make whole steps: what stands where a whole one ends has made it.
        let made = |axis: usize, made: f64| {
            if (made - whole[axis]).abs() <= tolerance[axis] { whole[axis] } else { made }
        };
        let made = from.zip(now).map(|(from, now)| Step {
            feed_mm: made(0, now.feed_mm - from.feed_mm),
            rotate_deg: made(1, now.rotate_deg - from.rotate_deg),
            bend_deg: now.bend_deg - from.bend_deg,
        });
        self.event(Event::PartMade { step, made, exact });
    }
}
