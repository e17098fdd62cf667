//! A step that may be run in several ways: to either side, with the head some whole or half turns further.

use nalgebra::{UnitQuaternion, Vector3};
use wirebend_collide::first_contact;

use super::asked::{Asked, EXACT, Strokes};
use super::body::{Body, MovesWith};
use super::contact::Obstacle;
use super::stroke::{Phase, StepRun};
use super::wire::Clearance;
use crate::units::{Angle, Length};

/// A part of a step, by what it depends on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StepPart {
    /// The wire is fed past what stands still.
    FeedPastFrame,
    /// The wire is fed past head and peg, which stand where the bend before has left them.
    FeedPastHead,
    /// The head turns.
    Rotate,
    /// All that belongs to the bend, from the approach of the peg to its return.
    Bend,
}

impl StepPart {
    fn has(self, phase: Phase) -> bool {
        match self {
            Self::FeedPastFrame | Self::FeedPastHead => phase == Phase::Feed,
            Self::Rotate => phase == Phase::Rotate,
            Self::Bend => phase > Phase::Rotate,
        }
    }

    fn concerns(self, body: &Body) -> bool {
        let still = body.moves_with == MovesWith::Frame;
        match self {
            Self::FeedPastFrame => still,
            Self::FeedPastHead | Self::Rotate => !still,
            Self::Bend => true,
        }
    }
}

impl Clearance<'_> {
    /// The same with the whole part turned right-handed about +x of the machine, the way the wire leaves it: the head then
    /// bends it at other angles.
    #[must_use]
    pub fn turned(mut self, by: Angle) -> Self {
        let turn = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), by.rad());
        for lie in &mut self.lies {
            lie.turn = turn * lie.turn;
        }
        self
    }

    /// Something that the wire meets in a part of a step that is run so: the stock or a measured body if it meets one of
    /// them, else a body that is only estimated.
    #[must_use]
    pub fn obstacle(&self, step: usize, part: StepPart, run: &StepRun) -> Option<Obstacle> {
        let told = self.bend.command(run.bend).unwrap_or(run.bend);
        let moves = self.moves_of(step, run, told)?;
        let strokes = Strokes::new(self, &moves);
        let bodies = || self.bodies.all.iter().enumerate().map(|(k, body)| (Obstacle::Body(k), body));
        let sure = bodies().filter(|(_, body)| body.measured);
        let estimated = bodies().filter(|(_, body)| !body.measured);
        let stock = (Obstacle::Stock, self.stock.get(step)?);
        let all = [stock].into_iter().chain(sure).chain(estimated);
        let mut all = all.filter(|(_, body)| part.concerns(body));
        let meets = |mut asked: Asked, one: (Obstacle, &Body)| {
            let mut wanted = strokes.past(one).filter(|strokes| part.has(strokes[0].phase));
            wanted.any(|strokes| asked.ask(one, strokes, EXACT, first_contact).is_some())
        };
        let asked = || Asked::new(self, step, &strokes);
        // What may come near at a vertex is more with a clearance: what is hit there counts, too.
        let touches = |one: (Obstacle, &Body)| {
            one.0 == Obstacle::Stock && self.wire.margin > Length::ZERO && meets(asked().touching(), one)
        };
        all.find_map(|one| (meets(asked(), one) || touches(one)).then_some(one.0))
    }
}
