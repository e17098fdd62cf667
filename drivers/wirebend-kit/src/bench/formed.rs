//! Where the peg pushes wire that is bent within its reach: the peg goes round in small steps, and the wire is pressed until
//! it is clear of it, point by point. No formula is shared with what compensates.
//!
//! Lengths are mm, angles radians. As in `contact`, the wire is bent to the left of the head, here in the frame of the leg's end:
//! x along the leg away from the pin, y to the left.

use std::f64::consts::PI;

use nalgebra::{Rotation2, Rotation3, Vector2, Vector3};

use super::chain::Chain;
use super::contact::{Contact, rising_root};

/// Between two points of the wire, mm.
const SPACING: f64 = 0.1;
/// Half the rod of the peg: wire farther above or below passes it, mm.
const HALF_ROD: f64 = 13.0;
/// The peg goes round in steps of so much, radians: a quarter of a degree.
const STEP: f64 = 0.004;
/// Peg and wire that overlap by less only touch, mm: half of what is between two points.
const TOUCH: f64 = SPACING / 2.0;
/// The wire gives way in steps of so much.
const YIELD: f64 = 0.002;

/// The wire beyond a leg, as points.
#[derive(Debug)]
pub(super) struct Formed {
    /// From the pin to where the wire is bent, while nothing is wrapped.
    straight: f64,
    points: Vec<Vector2<f64>>,
}

/// How the peg holds a wire.
#[derive(Debug, Clone, Copy)]
pub(super) struct Held {
    /// Angle of the leg.
    pub leg: f64,
    /// From the pin to the place that the peg touches.
    pub arm: f64,
}

/// What the peg does to a wire.
#[derive(Debug, Clone, Copy)]
pub(super) enum Met {
    Held(Held),
    /// It has not reached the wire.
    NotYet,
    /// It passes the wire, or finds no room beside it.
    Past,
}

impl Formed {
    /// What lies beyond the leg, for a head at `head` that bends to `side`; nothing where the leg is straight as far as the
    /// peg reaches. `off_centre`: from the neutral fibre to the centreline.
    pub fn beyond(chain: &Chain, contact: &Contact, head: f64, side: f64, off_centre: f64) -> Option<Self> {
        let mut pieces = chain.pieces.iter().rev();
        let mut straight = chain.tail;
        if chain.at_pin(head).is_some() {
            let piece = pieces.next()?;
            straight += piece.arc.fibre + piece.straight;
        }
        let near = contact.farthest();
        let mut axes = Rotation3::identity();
        let mut at = Vector3::zeros();
        let mut towards = head;
        let mut is_bent = false;
        let mut points = Vec::new();
        let mut lay = |length: f64, turn: f64, axes: &mut Rotation3<f64>| {
            let parts = (length / SPACING).ceil().max(1.0);
            let half = Rotation3::from_axis_angle(&Vector3::z_axis(), turn / parts / 2.0);
            let mut part = 0.0;
            while part < parts && at.norm() < near {
                *axes *= half;
                at += *axes * Vector3::x() * (length / parts);
                *axes *= half;
                if at.z.abs() <= HALF_ROD {
                    points.push(at.xy());
                }
                part += 1.0;
            }
            at.norm() < near
        };
        for piece in pieces {
            let turn = side * piece.arc.turn;
            if turn == 0.0 && !is_bent {
                straight += piece.arc.fibre + piece.straight;
                continue;
            }
            is_bent = true;
            axes *= Rotation3::from_axis_angle(&Vector3::x_axis(), towards - piece.arc.head);
            towards = piece.arc.head;
            let bulge = off_centre * turn.abs();
            if straight >= near
                || !lay(piece.arc.fibre + bulge, turn, &mut axes)
                || !lay(piece.straight, 0.0, &mut axes)
            {
                break;
            }
        }
        (straight < near).then_some(Self { straight, points })
    }

    /// How the peg holds the wire with the axis at the second of `axis`, which came out with it at the first; the wire stood at `leg`
    /// before. `wrapped` says how much of the straight
    /// is round the pin for a leg, and `given` where a leg really is that a machine which does not give would hold.
    pub fn held(
        &self,
        contact: &Contact,
        leg: f64,
        [from, axis]: [f64; 2],
        wrapped: impl Fn(f64) -> f64,
        given: impl Fn(f64) -> f64,
    ) -> Met {
        let gap = |leg: f64, axis: f64| self.nearest(contact, leg, axis, wrapped(leg)).0 - contact.reach();
        let mut at = from.min(axis);
        while gap(leg, at) < 0.0 {
            at += STEP;
            if at > axis {
                return Met::Past;
            }
        }
        let mut held = leg;
        let mut touched = false;
        loop {
            let before = held;
            while gap(held, at) < 0.0 {
                touched = true;
                held += YIELD;
                if held - before > 0.5 || held > PI {
                    return Met::Past;
                }
            }
            if at >= axis {
                break;
            }
            at = (at + STEP).min(axis);
        }
        if !touched {
            while at < PI && gap(held, at) >= 0.0 {
                at += STEP;
            }
            return if at < PI { Met::NotYet } else { Met::Past };
        }
        // The last step went a little too far.
        let leg = rising_root(held - 2.0 * YIELD, held, |leg| gap(leg, axis)).max(leg);
        // The peg is where it touches the leg that it really holds.
        let really = given(leg);
        let wrapped = wrapped(leg);
        let nearest = |axis: f64| self.nearest(contact, really, axis, wrapped);
        let from = axis - 2.0 * (leg - really).max(0.0);
        let axis = rising_root(from, axis, |axis| contact.reach() - nearest(axis).0);
        Met::Held(Held { leg, arm: nearest(axis).1 })
    }

    /// Whether the peg with the axis at `axis` is where wire is.
    pub fn overlaps(&self, contact: &Contact, leg: f64, axis: f64, wrapped: f64) -> bool {
        self.nearest(contact, leg, axis, wrapped).0 < contact.reach() - TOUCH
    }

    /// From the peg to the nearest point of the wire, of which so much is round the pin, and from the pin to that point.
    fn nearest(&self, contact: &Contact, leg: f64, axis: f64, wrapped: f64) -> (f64, f64) {
        let length = (self.straight - wrapped).max(0.0);
        let peg =
            Rotation2::new(-leg) * (contact.peg(axis) - contact.end_of_arc(leg)) - Vector2::x() * length;
        let foot = Vector2::x() * peg.x.clamp(-length, 0.0);
        let pin = Vector2::x() * -length;
        let all = self.points.iter().copied().chain([foot]);
        all.map(|point| ((peg - point).norm(), (point - pin).norm()))
            .min_by(|one, other| one.0.total_cmp(&other.0))
            .unwrap_or((f64::INFINITY, 0.0))
    }
}

#[cfg(test)]
mod tests {
    use super::super::chain::{Arc, Piece};
    use super::super::settings::Bender;
    use super::*;

    /// Pieces from the tip to the pin: straight wire, and an arc of so many degrees and mm of centreline behind it.
    fn chain(pieces: &[(f64, f64, f64)], tail: f64) -> Chain {
        let piece = |&(straight, turn, fibre): &(f64, f64, f64)| Piece {
            straight,
            arc: Arc { turn: f64::to_radians(turn), fibre, head: 0.0 },
        };
        Chain { pieces: pieces.iter().map(piece).collect(), tail }
    }

    /// The places of the axis were worked out with formulas apart from this: there the peg holds the leg at the angle beside it.
    #[test]
    fn the_peg_holds_a_formed_wire_where_it_is_said_to() {
        let contact = Contact::new(&Bender::PUBLISHED, 1.5).unwrap();
        let corner = 3.0 * 15.0_f64.to_radians().tan();
        let arc = |turn: f64| 3.0 * f64::abs(turn).to_radians();
        let bent = |edge: f64, turn: f64| chain(&[(80.0, turn, arc(turn))], edge - 2.0 * corner);
        let small = |before: usize| {
            let mut pieces = vec![(60.0, 7.5, arc(7.5))];
            pieces.resize(before, (6.1611, 7.5, arc(7.5)));
            chain(&pieces, 6.1611)
        };
        let mut rows = vec![(40.23, bent(20.4, 30.0), 56.726), (40.23, bent(25.0, -30.0), 39.289)];
        rows.extend(
            [23.403, 29.746, 33.499, 34.657].into_iter().zip(1..).map(|(axis, k)| (17.73, small(k), axis)),
        );
        for (pressed, chain, axis) in rows {
            let formed = Formed::beyond(&chain, &contact, 0.0, 1.0, 0.0).unwrap();
            // Farther from zero than beside straight wire, since one corner is bent towards it.
            let axes = [-40.0, axis].map(f64::to_radians);
            let Met::Held(held) = formed.held(&contact, 0.0, axes, |_| 0.0, |leg| leg) else {
                panic!("not held at {axis}")
            };
            assert!(
                (held.leg.to_degrees() - pressed).abs() < 0.05,
                "{} for {pressed}",
                held.leg.to_degrees()
            );
        }
    }
}
