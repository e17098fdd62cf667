//! What axes can be told: multiples of the least that they go. What is left over is taken to be made up for by the next step, as a driver
//! does that counts where its axes are.

use crate::compensate::ToldStep;
use crate::units::{Angle, Length};

/// The least that each axis goes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resolution {
    /// Of a feed; above zero.
    pub feed: Length,
    /// Of a rotation; above zero.
    pub rotate: Angle,
    /// Of a bend; above zero.
    pub bend: Angle,
}

impl Resolution {
    /// Commands as the axes make them. What rounding takes from a feed or a rotation is given to the next, so that neither is ever off by
    /// more than half a step in all; what it takes from a bend is given to the next in the same plane.
    #[must_use]
    pub fn rounded(&self, told: &[ToldStep]) -> Vec<ToldStep> {
        let [mut feed, mut rotate, mut bends] =
            [self.feed.mm(), self.rotate.deg(), self.bend.deg()].map(Axis::new);
        let mut turned = Angle::ZERO;
        let round = |told: &ToldStep| {
            let mut told = *told;
            told.step.feed = Length::computed(feed.next(told.step.feed.mm()));
            told.step.rotate = degrees(rotate.next(told.step.rotate.deg()));
            turned = (turned + told.step.rotate).wrapped();
            if told.bends() && (told.approach.is_some() || told.step.bend.abs().deg() > NO_BEND_DEG) {
                bends.turn(turned);
                turned = Angle::ZERO;
                told.step.bend = degrees(bends.next(told.step.bend.deg()));
            }
            told
        };
        told.iter().map(round).collect()
    }
}

/// An axis with what it still owes.
struct Axis {
    step: f64,
    owed: f64,
}

/// What angles of the same plane may differ by, degrees.
const SAME_PLANE_DEG: f64 = 1e-6;
/// A bend below this is what arithmetic leaves of none, degrees.
const NO_BEND_DEG: f64 = 1e-9;
/// Decimals of steps that count: fewer than arithmetic is exact to, so that a half is a half.
const DECIMALS: f64 = 1e9;

fn degrees(deg: f64) -> Angle {
    Angle::from_deg(deg).unwrap_or_default()
}

impl Axis {
    const fn new(step: f64) -> Self {
        Self { step, owed: 0.0 }
    }

    fn next(&mut self, value: f64) -> f64 {
        let exact = value + self.owed;
        // Halves go to the even side, so that what is owed never makes a feed of zero turn back.
        let steps = (exact / self.step * DECIMALS).round() / DECIMALS;
        let made = steps.round_ties_even() * self.step;
        self.owed = exact - made;
        made
    }

    /// The plane of the bends has turned: after half a turn a bend to the other side goes on the same way round.
    fn turn(&mut self, by: Angle) {
        let from_half = by.abs().deg() - 180.0;
        if from_half.abs() < SAME_PLANE_DEG {
            self.owed = -self.owed;
        } else if by.abs().deg() > SAME_PLANE_DEG {
            self.owed = 0.0;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bend::Step;
    use crate::testing::{deg, mm};

    fn rounded(steps: &[(f64, f64, f64)]) -> Vec<(f64, f64, f64)> {
        let told: Vec<ToldStep> = steps
            .iter()
            .map(|&(feed, rotate, bend)| Step { feed: mm(feed), rotate: deg(rotate), bend: deg(bend) }.into())
            .collect();
        let whole = Resolution { feed: mm(1.0), rotate: deg(1.0), bend: deg(1.0) };
        let shown = |value: f64| value.round() + 0.0;
        whole
            .rounded(&told)
            .iter()
            .map(|told| {
                let Step { feed, rotate, bend } = told.step;
                for (value, whole) in [(feed.mm(), shown(feed.mm())), (bend.deg(), shown(bend.deg()))] {
                    assert!((value - whole).abs() < 1e-9, "{value}");
                }
                (shown(feed.mm()), shown(rotate.deg()), shown(bend.deg()))
            })
            .collect()
    }

    /// By hand: 10.4 three times are 31.2, and 31 are made; a third of a degree is lost nowhere.
    #[test]
    fn what_is_left_over_goes_to_the_next_of_the_axis() {
        let told = [(10.4, 0.0, 20.4), (10.4, 0.0, 20.4), (10.4, 0.0, 0.0)];
        assert_eq!(rounded(&told), [(10.0, 0.0, 20.0), (11.0, 0.0, 21.0), (10.0, 0.0, 0.0)]);
    }

    /// A half of a step is not lost to the last bits of a float, nor is it more than a half then.
    #[test]
    fn halves_go_to_the_even_side() {
        let tenth = Resolution { feed: mm(0.1), rotate: deg(1.0), bend: deg(1.0) };
        let told: Vec<ToldStep> = [(0.75, 7.5), (0.0, 62.5), (0.0, 122.5)]
            .map(|(feed, bend)| Step { feed: mm(feed), rotate: deg(90.0), bend: deg(bend) }.into())
            .into();
        let made = tenth.rounded(&told).into_iter().map(|told| (told.step.feed.mm(), told.step.bend.deg()));
        for ((feed, bend), (of_feed, of_bend)) in made.zip([(0.8, 8.0), (0.0, 62.0), (0.0, 122.0)]) {
            assert!((feed - of_feed).abs() < 1e-9 && (bend - of_bend).abs() < 1e-9, "{feed} {bend}");
            assert!(feed >= 0.0, "{feed}");
        }
    }

    /// Out of the plane of a bend what it lacks would only spoil the next one; after half a turn that is the same plane.
    #[test]
    fn a_bend_owes_nothing_to_another_plane() {
        let told = [(10.0, 0.0, 20.4), (10.0, 90.0, 20.4), (10.0, 180.0, -20.4)];
        assert_eq!(rounded(&told), [(10.0, 0.0, 20.0), (10.0, 90.0, 20.0), (10.0, 180.0, -21.0)]);
    }
}
