//! What is bent to be measured.

use crate::bend::Step;
use crate::schedule::ScheduledProgram;
use crate::units::{Angle, Length};

/// What is measured of a step of a coupon.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Measured {
    /// Its bend.
    Bend,
    /// The side that its feed makes, between the bend before and its own.
    Side,
    /// The turn of the head before its bend.
    Turn {
        /// Whether it goes against the turn before.
        reverses: bool,
    },
}

/// A piece of wire to bend and measure.
#[derive(Debug, Clone, PartialEq)]
pub struct Coupon {
    /// What is bent. The side of each bend is part of it: it is not scheduled again.
    pub program: ScheduledProgram,
    /// What is measured: steps from 0.
    pub measured: Vec<(usize, Measured)>,
}

impl Coupon {
    fn new(steps: Vec<Step>, measured: Vec<(usize, Measured)>) -> Self {
        let head = steps.iter().scan(Angle::ZERO, |head, step| {
            *head += step.rotate;
            Some(*head)
        });
        Self { program: ScheduledProgram { head: head.collect(), steps }, measured }
    }

    /// Wire in it, before what bends take or give.
    #[must_use]
    pub fn length(&self) -> Length {
        self.program.steps.iter().map(|step| step.feed).sum()
    }
}

/// Which coupons are bent.
#[derive(Debug, Clone, PartialEq)]
pub struct CouponPlan {
    /// Angles of the ladder: each is bent to both sides.
    pub angles: Vec<Angle>,
    /// Sides of the U-shapes; with two lengths the feed's scale is told apart from the wire in a bend.
    pub sides: Vec<Length>,
    /// The turn of the twist pair; none without a head that turns.
    pub turn: Option<Angle>,
    /// Straight wire before, between and behind bends: longer than the peg reaches, or its leg is bent where it pushes.
    pub edge: Length,
}

impl CouponPlan {
    /// What the head turns before the first bend of the twist pair, the same way as then: the wire as a whole. It takes up the backlash,
    /// which the wire before has left on the other side. No head has as much: a calibration takes 5° for far off.
    pub const LEAD: Angle = Angle::computed(15.0_f64.to_radians());

    /// The coupons, each to be bent as often as repeats are wanted.
    ///
    /// An angle of the ladder is a Z: both its bends, to one side and the other, so that it stays flat. A side is a U of
    /// two right angles. The twist pair turns the head between three right angles there and back, after [`CouponPlan::LEAD`].
    #[must_use]
    pub fn coupons(&self) -> Vec<Coupon> {
        let right = Angle::computed(std::f64::consts::FRAC_PI_2);
        let bend = |feed: Length, rotate: Angle, bend: Angle| Step { feed, rotate, bend };
        let end = bend(self.edge, Angle::ZERO, Angle::ZERO);
        let z = |&angle: &Angle| {
            let steps = vec![bend(self.edge, Angle::ZERO, angle), bend(self.edge, Angle::ZERO, -angle), end];
            Coupon::new(steps, vec![(0, Measured::Bend), (1, Measured::Bend)])
        };
        let u = |&side: &Length| {
            let steps = vec![bend(self.edge, Angle::ZERO, right), bend(side, Angle::ZERO, right), end];
            Coupon::new(steps, vec![(1, Measured::Side)])
        };
        let twist = |turn: Angle| {
            let lead = if turn < Angle::ZERO { -Self::LEAD } else { Self::LEAD };
            let steps = vec![
                bend(self.edge, lead, right),
                bend(self.edge, turn, right),
                bend(self.edge, -turn, right),
                end,
            ];
            let measured =
                vec![(1, Measured::Turn { reverses: false }), (2, Measured::Turn { reverses: true })];
            Coupon::new(steps, measured)
        };
        let angles = self.angles.iter().map(z);
        angles.chain(self.sides.iter().map(u)).chain(self.turn.map(twist)).collect()
    }

    /// Wire for all coupons, each bent so often.
    #[must_use]
    pub fn wire_needed(&self, repeats: i32) -> Length {
        self.coupons().iter().map(|coupon| coupon.length().times(repeats)).sum()
    }
}
