//! Where the peg meets wire that is bent within its reach.
//!
//! The setback takes the leg beyond the pin to be straight as far as the peg touches it. A corner that is nearer has turned
//! the wire out of the peg's way, or into it: the peg then touches another place, at another position of the axis.
//!
//! The wire beyond the leg is kept in the frame of the leg's end: x along the leg, away from the pin, y to the side of the
//! bend, as seen along the peg. What of it lies above or below the peg is left out.

use nalgebra::{Point2, Point3, Vector2, Vector3};

use super::feed::corner;
use super::setback::PegGeometry;
use super::shape::{Orbit, Shape};
use crate::bend::Frame;
use crate::units::{Angle, Length};

/// A chord of an arc that is seen from the side is off by no more than this, mm.
const CHORD_ERROR: f64 = 0.005;
/// Planes that are off by less than this are one: the sine of a hundredth of the finest step of a head.
const IN_PLANE: f64 = 1e-6;
/// The peg is looked for from here on, radians from zero to the side of the bend: beside the pin.
const FROM: f64 = -1.75;
/// A way of the axis is looked at in parts of so many radians that the wire is bent.
const PART: f64 = 0.26;

/// A wire as it is formed bend by bend, for what the peg of the next bend meets.
#[derive(Debug, Clone)]
pub(super) struct FormedWire {
    radius: Length,
    near: f64,
    half_peg: f64,
    steps: Vec<FormedStep>,
}

/// What a step left.
#[derive(Debug, Clone, Copy)]
struct FormedStep {
    /// Straight wire before the arc of the bend, mm.
    straight: f64,
    rotate: Angle,
    bend: Angle,
}

/// The wire beyond the leg of a bend, as far as the peg may meet it. Empty where the leg goes on straight as far as it reaches.
#[derive(Debug, Clone, Default)]
pub(super) struct Beyond(pub(super) Vec<Piece>);

/// Straight wire or an arc of it, flat.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece {
    pub shape: Shape,
    /// Whether a bend of another plane or to the other side is between it and the leg, or is this piece.
    pub past_other: bool,
}

/// So long before it touches the wire the peg comes out: the firmware's 18.25° are 5° before the 13.25° of the published head.
const CLEAR: f64 = 5.0 * std::f64::consts::PI / 180.0;
/// Less room than this, from one piece of wire to the next, is none.
const LEAST_ROOM: f64 = 2.0 * std::f64::consts::PI / 180.0;

/// Places of the axis that differ by less are one, radians.
const SAME: f64 = 1e-6;

/// Where the peg touches.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Touch {
    /// Position of the axis, radians towards the side of the bend.
    pub axis: f64,
    /// From where on there is room for the peg, radians towards the side of the bend.
    pub room_from: f64,
    /// Whether it touches beyond a bend of another plane or to the other side.
    pub past_other: bool,
}

impl FormedWire {
    /// A wire of which nothing is formed.
    pub fn new(peg: &PegGeometry) -> Self {
        Self {
            radius: Length::computed(peg.pin),
            near: peg.farthest() + 2.0 * peg.pin,
            half_peg: peg.peg_length.mm() / 2.0,
            steps: Vec::new(),
        }
    }

    /// What stays straight of a segment between two corners, mm. Not negative.
    pub(super) fn straight(&self, segment: Length, before: Angle, bend: Angle) -> f64 {
        (segment - corner(self.radius, before) - corner(self.radius, bend)).mm().max(0.0)
    }

    /// Adds the wire of a step: so much of it straight, mm, and then its bend.
    pub(super) fn push(&mut self, straight: f64, rotate: Angle, bend: Angle) {
        self.steps.push(FormedStep { straight, rotate, bend });
    }

    /// The wire beyond the leg of the next bend, before which the head turns by `rotate`. `leg`: how long that leg is at
    /// least, mm.
    ///
    /// Wire that leaves the peg's reach and comes back is not followed: that it is met is a collision.
    pub(super) fn beyond(&self, rotate: Angle, side: f64, leg: f64) -> Beyond {
        let mut pieces = Vec::new();
        if leg >= self.near {
            return Beyond(pieces);
        }
        let mut frame = Frame::default();
        frame.rotate(rotate);
        let mut past_other = false;
        for step in self.steps.iter().rev() {
            let turn = Angle::computed(side * step.bend.rad());
            // Wire that lies on itself is no corner, and a finding of its own.
            if turn.abs().deg() > super::FOLD_DEG {
                return Beyond(pieces);
            }
            if turn != Angle::ZERO {
                let is_flat = frame.b().cross(&Vector3::z()).norm() < IN_PLANE;
                past_other |= !is_flat || turn.rad() * frame.b().z < 0.0;
                self.arc(&mut frame, turn, is_flat, |shape| pieces.push(Piece { shape, past_other }));
            }
            let from = frame.position;
            frame.feed(Length::computed(step.straight));
            self.line(from, frame.position, |shape| pieces.push(Piece { shape, past_other }));
            if frame.position.coords.norm() > self.near {
                return Beyond(pieces);
            }
            frame.rotate(step.rotate);
        }
        // Where the wire ends.
        let end = frame.position;
        self.line(end, end, |shape| pieces.push(Piece { shape, past_other }));
        Beyond(pieces)
    }

    fn arc(&self, frame: &mut Frame, turn: Angle, is_flat: bool, mut add: impl FnMut(Shape)) {
        let radius = self.radius.mm();
        let begin = *frame;
        let along = |by: f64| {
            let mut there = begin;
            let inward = begin.n() * turn.signum();
            let centre = begin.position + inward * radius;
            there.bend(Angle::computed(by));
            there.position = centre - there.n() * turn.signum() * radius;
            there
        };
        *frame = along(turn.rad());
        if is_flat {
            if begin.position.z.abs() > self.half_peg {
                return;
            }
            let out = -begin.n() * turn.signum();
            let centre = begin.position - out * radius;
            let sweep = turn.rad() * begin.b().z.signum();
            add(Shape::Arc { centre: centre.xy(), radius, begin: out.y.atan2(out.x), sweep });
            return;
        }
        let largest = 2.0 * (1.0 - CHORD_ERROR / radius).clamp(-1.0, 1.0).acos();
        let chords = (turn.rad().abs() / largest).ceil().max(1.0);
        let mut from = begin.position;
        let mut chord = 0.0;
        while chord < chords {
            chord += 1.0;
            let to = along(turn.rad() * chord / chords).position;
            self.line(from, to, &mut add);
            from = to;
        }
    }

    /// What of a straight piece is as high as the peg.
    fn line(&self, from: Point3<f64>, to: Point3<f64>, mut add: impl FnMut(Shape)) {
        let whole = to - from;
        let at = |z: f64| (z - from.z) / whole.z;
        let (low, high) = if whole.z.abs() > 1e-12 {
            let (one, other) = (at(-self.half_peg), at(self.half_peg));
            (one.min(other).max(0.0), one.max(other).min(1.0))
        } else if from.z.abs() <= self.half_peg {
            (0.0, 1.0)
        } else {
            return;
        };
        if low > high {
            return;
        }
        let (from, whole) = ((from + whole * low).xy(), whole.xy() * (high - low));
        let length = whole.norm();
        let along = if length > 1e-12 { whole / length } else { Vector2::x() };
        add(Shape::Line { from, along, length });
    }
}

impl Beyond {
    /// Whether the leg goes on straight as far as the peg reaches.
    pub(super) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl PegGeometry {
    /// The farthest from the bend point that a peg can touch wire, mm.
    pub(super) fn farthest(&self) -> f64 {
        self.offset.abs() + self.orbit_radius + self.peg
    }

    /// How long a wire that is straight has to be so that the peg touches it, where one of `lead` is too short.
    pub(super) fn least_lead(&self, lead: Length) -> Length {
        let meets = self.meets();
        if lead < meets { meets } else { Length::computed(self.near()) }
    }

    /// How long straight wire has to be at its beginning so that the peg meets any of it, however far it is bent.
    #[must_use]
    pub fn meets(&self) -> Length {
        Length::computed(self.offset + self.orbit_radius - self.peg)
    }

    /// Where the peg touches straight wire, from the pin, mm.
    fn near(&self) -> f64 {
        self.offset + (self.orbit_radius.powi(2) - self.peg.powi(2)).sqrt()
    }

    /// Where the peg first touches a wire that is pressed to `pressed` radians, coming from the near side. `leg`: straight
    /// wire from the pin to what lies beyond, mm. Nothing where it passes without touching.
    pub(super) fn touch(&self, pressed: f64, leg: f64, beyond: &Beyond) -> Option<Touch> {
        if beyond.is_empty() {
            return self.axis(pressed).map(|axis| Touch { axis, room_from: FROM, past_other: false });
        }
        // The centre of the orbit as the end of the leg sees it, turned with it.
        let (sin, cos) = pressed.sin_cos();
        let out = Vector2::new(self.offset - self.pin * sin, -self.pin * (1.0 - cos));
        let centre = Point2::new(out.x * cos + out.y * sin - leg, out.y * cos - out.x * sin);
        let orbit = Orbit { centre, radius: self.orbit_radius, reach: self.peg };
        let own = Shape::Line { from: Point2::new(-leg, 0.0), along: Vector2::x(), length: leg };
        let pieces = || beyond.0.iter().copied().chain([Piece { shape: own, past_other: false }]);
        // The peg comes out where there is room for it.
        let room = |from: f64| {
            let peg = orbit.at(from - pressed);
            pieces().all(|piece| piece.shape.distance(peg) >= self.peg)
        };
        let mut from = FROM;
        while !room(from) {
            from += 0.1;
            if from > 0.0 {
                return None;
            }
        }
        let mut first: Option<Touch> = None;
        let whole = std::f64::consts::TAU;
        for piece in pieces() {
            piece.shape.touched_by(&orbit, |at| {
                let axis = from + (at + pressed - from).rem_euclid(whole);
                if first.is_none_or(|first| axis < first.axis) {
                    first = Some(Touch { axis, room_from: from, past_other: piece.past_other });
                }
            });
        }
        first.filter(|touch| touch.axis < std::f64::consts::PI)
    }

    /// Where the peg touches wire that is straight, radians towards the side of the bend: below zero.
    fn touches_straight(&self) -> f64 {
        -(self.peg / self.orbit_radius).asin()
    }

    /// A bend of straight wire is slight up to here: as far beyond zero as the peg touches that wire before it.
    pub(super) fn slight(&self) -> Angle {
        Angle::computed(-self.touches_straight())
    }

    /// How far before zero the bend axis stands when the peg comes out beside straight wire.
    #[must_use]
    pub fn near_side(&self) -> Angle {
        Angle::computed(CLEAR - self.touches_straight())
    }

    /// How far before it touches the wire the peg comes out.
    #[must_use]
    pub fn clear_before_touch() -> Angle {
        Angle::computed(CLEAR)
    }

    /// Where the peg has to come out so that it is clear of wire that is bent within its reach, radians towards the side of the bend:
    /// below zero. `Ok(None)` where the place for straight wire will do, `Err` where there is no room.
    pub(super) fn approach(&self, leg: f64, beyond: &Beyond) -> Result<Option<f64>, NoRoom> {
        let touch = self.touch(0.0, leg, beyond).ok_or(NoRoom)?;
        if touch.axis - touch.room_from < LEAST_ROOM {
            return Err(NoRoom);
        }
        let on_straight = self.touches_straight();
        let at = (touch.axis - CLEAR).max(f64::midpoint(touch.room_from, touch.axis));
        if touch.axis >= on_straight - SAME && touch.room_from <= on_straight - CLEAR {
            return Ok(None);
        }
        if at < 0.0 { Ok(Some(at)) } else { Err(NoRoom) }
    }

    /// The same where the axis only ever moves forward on the way there. `leg`: how long it is where the wire is pressed so far.
    pub(super) fn pressing(&self, pressed: f64, leg: impl Fn(f64) -> f64, beyond: &Beyond) -> Option<Touch> {
        let end = self.touch(pressed, leg(pressed), beyond)?;
        let parts = (pressed / PART).ceil();
        let (mut part, mut before) = (0.0, f64::NEG_INFINITY);
        while part < parts {
            let at = pressed * part / parts;
            let on_the_way = self.touch(at, leg(at), beyond)?;
            if on_the_way.axis <= before {
                return None;
            }
            before = on_the_way.axis;
            part += 1.0;
        }
        (end.axis > before).then_some(end)
    }
}

/// The peg finds no room beside the wire.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct NoRoom;
