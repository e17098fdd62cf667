//! The wire that moves by hand bend, since the machine was homed or connected.

use wirebend_core::bend::Step;
use wirebend_core::units::{Angle, Length};
use wirebend_planning::JobStep;
use wirebend_planning::playback::{PlayedWire, played_by_hand};

use crate::order::Move;

/// A feed that stands for none at all, mm: two bends at one place have their directions by it, and it is too small to see.
const HAIR_MM: f64 = 1e-3;

/// The moves that shaped it, and the one that is under way.
#[derive(Debug, Clone, Default)]
pub struct WireByHand {
    moves: Vec<Move>,
    under_way: Option<UnderWay>,
    /// Where the last move has ended: positions are reported more seldom than moves are done.
    ended: Option<JobStep>,
}

/// A move that is under way.
#[derive(Debug, Clone, Copy)]
struct UnderWay {
    ordered: Move,
    /// Where the axes were before, and where they are.
    from: JobStep,
    now: JobStep,
    /// The largest part of a bend that was reached: the wire stays bent when the axis goes back.
    bent: f64,
}

impl WireByHand {
    /// How many moves are done.
    pub const fn moves(&self) -> usize {
        self.moves.len()
    }

    /// A move begins; `position`: where the axes were last reported.
    pub fn begin(&mut self, ordered: Move, position: Option<JobStep>) {
        let from = self.ended.or(position);
        self.under_way = from.map(|from| UnderWay { ordered, from, now: from, bent: 0.0 });
    }

    /// The axes are reported to be here, in canonical signs.
    pub fn position(&mut self, now: JobStep) {
        if let Some(move_now) = &mut self.under_way {
            move_now.now = now;
            move_now.bent = move_now.bent.max(move_now.bend_axis());
        }
    }

    /// A move is done.
    pub fn made(&mut self, one: Move) {
        if one == Move::Home {
            return self.forget();
        }
        self.ended = self.under_way.take().map(|move_made| move_made.end());
        self.moves.push(one);
    }

    /// A move that was refused or stopped goes no farther, and where it has left the axes is reported.
    pub fn interrupt(&mut self) {
        if self.under_way.take().is_some() {
            self.ended = None;
        }
    }

    /// A wire begins anew.
    pub fn forget(&mut self) {
        *self = Self::default();
    }

    /// The wire on its machine, with what is done of the move that is under way. It is the wire as ordered: without
    /// springback, which only the wire itself knows.
    pub fn played(&self) -> PlayedWire {
        let part = self.under_way.map(|move_now| move_now.part());
        let mut steps = steps_of(self.moves.iter().copied().chain(part));
        let bending = match (self.under_way, part) {
            (Some(bend), Some(Move::Bend { deg })) if deg != 0.0 => {
                // Nothing comes after it yet.
                steps.pop();
                Some(angle(bend.bend_axis_deg()))
            }
            _ => None,
        };
        played_by_hand(&steps, bending)
    }
}

impl UnderWay {
    /// Where the axes are when it is done.
    fn end(&self) -> JobStep {
        let from = self.from;
        match self.ordered {
            Move::Feed { mm } => JobStep { feed_mm: from.feed_mm + mm, ..from },
            Move::Rotate { deg } => JobStep { rotate_deg: from.rotate_deg + deg, ..from },
            // Its axis goes back to where it was.
            Move::Bend { .. } | Move::Home => from,
        }
    }

    /// The part of a bend that its axis has gone, from 0 to 1: its peg may come from the other side first.
    fn bend_axis(&self) -> f64 {
        match self.ordered {
            Move::Bend { deg } if deg != 0.0 => {
                ((self.now.bend_deg - self.from.bend_deg) / deg).clamp(0.0, 1.0)
            }
            _ => 0.0,
        }
    }

    /// The same in degrees.
    fn bend_axis_deg(&self) -> f64 {
        match self.ordered {
            Move::Bend { deg } => deg * self.bend_axis(),
            _ => 0.0,
        }
    }

    fn part(&self) -> Move {
        let (from, now) = (self.from, self.now);
        match self.ordered {
            Move::Home => Move::Home,
            Move::Feed { .. } => Move::Feed { mm: now.feed_mm - from.feed_mm },
            Move::Rotate { .. } => Move::Rotate { deg: now.rotate_deg - from.rotate_deg },
            Move::Bend { deg } => Move::Bend { deg: deg * self.bent },
        }
    }
}

/// Moves as steps of a program: a bend ends one. Feeding and rotating do not disturb each other, so that between two bends
/// only their sums count. What is drawn back behind a bend is left out: the machine cannot do it to the wire either.
fn steps_of(moves: impl Iterator<Item = Move>) -> Vec<Step> {
    let (mut steps, mut fed, mut rotated) = (Vec::new(), 0.0, 0.0);
    let step = |fed: f64, rotated: f64, bend: f64| Step {
        feed: Length::from_mm(fed.max(HAIR_MM)).unwrap_or_default(),
        rotate: angle(rotated),
        bend: angle(bend),
    };
    for one in moves {
        match one {
            Move::Feed { mm } => fed += mm,
            Move::Rotate { deg } => rotated += deg,
            Move::Bend { deg } if deg != 0.0 => {
                steps.push(step(fed, rotated, deg));
                (fed, rotated) = (0.0, 0.0);
            }
            Move::Bend { .. } | Move::Home => {}
        }
    }
    steps.push(step(fed, rotated, 0.0));
    steps
}

/// A machine reports finite numbers.
fn angle(deg: f64) -> Angle {
    Angle::from_deg(deg).unwrap_or_default()
}

#[cfg(test)]
mod tests;
