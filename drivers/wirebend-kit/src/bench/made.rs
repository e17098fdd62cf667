//! The wire that came out, as a shape.

use std::f64::consts::PI;

use nalgebra::{Rotation3, Vector3};

use super::chain::{Arc, Chain};
use super::incident::ModelWarning;

/// Below this turn the corner is the middle of the arc: the tangents are parallel. Radians.
const STRAIGHT: f64 = 1e-9;
/// Beyond this turn the tangents of an arc meet far away, if at all. Radians, 170 degrees.
const FOLD: f64 = 170.0 / 180.0 * PI;
/// Finest and coarsest error of a drawn arc, mm.
const TOLERANCES: (f64, f64) = (1e-4, 10.0);

/// A bend as it stayed in the wire.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MadeBend {
    /// Its angle, with the sign of the press: positive turns t towards n.
    pub angle_deg: f64,
    /// How the head stood, right-handed about t.
    pub head_deg: f64,
    /// Radius of the centreline. Infinite where nothing of the bend stayed.
    pub radius_mm: f64,
}

/// The wire that came out. Its tip, which came out first, is the origin; it leaves that along +x, and
/// where the head stood at zero for a positive bend it turns towards +y. Lengths are mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Made {
    pub(super) chain: Chain,
    /// From the neutral fibre of an arc out to its centreline.
    pub(super) off_centre: f64,
    pub(super) doubts: Vec<ModelWarning>,
}

/// A turtle on the centreline.
#[derive(Debug, Clone, Copy)]
struct Turtle {
    at: Vector3<f64>,
    /// Columns t, n, b with the head at zero.
    plane: Rotation3<f64>,
}

impl Turtle {
    fn t(&self) -> Vector3<f64> {
        self.plane * Vector3::x()
    }

    fn forward(&mut self, length: f64) {
        self.at += self.t() * length;
    }
}

/// What the turtle passes.
enum Part {
    Straight(f64),
    Arc(Arc),
}

impl Made {
    /// Length of the wire that came out, along the fibre that keeps its length.
    #[must_use]
    pub fn length_mm(&self) -> f64 {
        self.chain.length()
    }

    /// The bends in the order in which they lie in the wire. A press of which nothing stayed is one of 0
    /// degrees.
    #[must_use]
    pub fn bends(&self) -> Vec<MadeBend> {
        let bend = |arc: &Arc| MadeBend {
            angle_deg: arc.turn.to_degrees(),
            head_deg: arc.head.to_degrees(),
            radius_mm: self.radius(arc).unwrap_or(f64::INFINITY),
        };
        self.chain.pieces.iter().map(|piece| bend(&piece.arc)).collect()
    }

    /// Where the model was weaker than usual.
    #[must_use]
    pub fn warnings(&self) -> &[ModelWarning] {
        &self.doubts
    }

    /// The wire's middle as a polyline from its tip to the nozzle, whose points lie on it and whose arcs
    /// are off by `tolerance_mm` at most (0.0001 to 10; what lies outside, or is no number, is taken as
    /// the nearest of these). At least one point; no two neighbours are one.
    #[must_use]
    pub fn centreline(&self, tolerance_mm: f64) -> Vec<[f64; 3]> {
        let tolerance = tolerance_mm.max(TOLERANCES.0).min(TOLERANCES.1);
        let mut turtle = start();
        let mut points = vec![turtle.at];
        for part in self.parts() {
            let pieces = match &part {
                Part::Straight(_) => 1,
                Part::Arc(arc) => self.chords(arc, tolerance),
            };
            let before = turtle;
            for i in 1..=pieces {
                turtle = before;
                self.pass(&mut turtle, &part, f64::from(i) / f64::from(pieces));
                if points.last().is_none_or(|last| *last != turtle.at) {
                    points.push(turtle.at);
                }
            }
        }
        points.into_iter().map(Into::into).collect()
    }

    /// The wire's ends, and between them the point for each bend where the straights before and behind it
    /// meet: what a design has for vertices. Arcs that follow each other in one plane with no straight
    /// between them are one bend. The corner of a bend of more than 170 degrees is the middle of its arc.
    #[must_use]
    pub fn corners(&self) -> Vec<[f64; 3]> {
        let mut turtle = start();
        let mut corners = vec![turtle.at];
        let parts: Vec<Part> = self.parts().collect();
        let mut rest = parts.as_slice();
        while let Some(part) = rest.first() {
            let run = match part {
                Part::Straight(_) => 1,
                Part::Arc(_) => arcs_in_a_row(rest),
            };
            let before = turtle;
            for part in &rest[..run] {
                self.pass(&mut turtle, part, 1.0);
            }
            if let Part::Arc(arc) = part {
                let mut middle = before;
                if run == 1 {
                    self.pass(&mut middle, part, 0.5);
                    corners.push(self.corner_of_arc(arc, &before, middle.at));
                } else {
                    corners.push(corner_of_lines(&before, &turtle));
                }
            }
            rest = &rest[run..];
        }
        corners.push(turtle.at);
        corners.into_iter().map(Into::into).collect()
    }

    fn parts(&self) -> impl Iterator<Item = Part> {
        let pieces = self.chain.pieces.iter();
        let bends = pieces.flat_map(|piece| [Part::Straight(piece.straight), Part::Arc(piece.arc)]);
        bends.chain([Part::Straight(self.chain.tail)]).filter(|part| !matches!(part, Part::Straight(0.0)))
    }

    /// Moves a turtle over a fraction of a part.
    fn pass(&self, turtle: &mut Turtle, part: &Part, fraction: f64) {
        let arc = match part {
            Part::Straight(length) => return turtle.forward(length * fraction),
            Part::Arc(arc) => arc,
        };
        let Some(radius) = self.radius(arc) else { return turtle.forward(arc.fibre * fraction) };
        let turn = arc.turn * fraction;
        let head = Rotation3::from_axis_angle(&Vector3::x_axis(), arc.head);
        let frame = turtle.plane * head;
        let (sin, cos) = turn.abs().sin_cos();
        turtle.at += frame * Vector3::new(sin, turn.signum() * (1.0 - cos), 0.0) * radius;
        let bent = frame * Rotation3::from_axis_angle(&Vector3::z_axis(), turn);
        turtle.plane = bent * head.inverse();
    }

    /// Radius of an arc's centreline; none where it is straight.
    fn radius(&self, arc: &Arc) -> Option<f64> {
        let turn = arc.turn.abs();
        (turn > STRAIGHT && arc.fibre > 0.0).then(|| arc.fibre / turn + self.off_centre)
    }

    fn chords(&self, arc: &Arc, tolerance: f64) -> u32 {
        let Some(radius) = self.radius(arc) else { return 1 };
        // The rise of an arc over its chord is r·(1 - cos(half of its angle)).
        let widest = 2.0 * (1.0 - (tolerance / radius).min(1.0)).acos();
        let chords = (arc.turn.abs() / widest).ceil().clamp(1.0, 1e5);
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 1 to 100000")]
        let chords = chords as u32;
        chords
    }

    fn corner_of_arc(&self, arc: &Arc, before: &Turtle, middle: Vector3<f64>) -> Vector3<f64> {
        match self.radius(arc) {
            Some(radius) if arc.turn.abs() <= FOLD => {
                before.at + before.t() * (radius * (arc.turn.abs() / 2.0).tan())
            }
            _ => middle,
        }
    }
}

/// At the wire's tip.
fn start() -> Turtle {
    Turtle { at: Vector3::zeros(), plane: Rotation3::identity() }
}

/// How many arcs follow each other in one plane from the first of the parts, with no straight between.
fn arcs_in_a_row(parts: &[Part]) -> usize {
    let Some(Part::Arc(first)) = parts.first() else { return 1 };
    let same = |part: &&Part| matches!(part, Part::Arc(arc) if (arc.head - first.head).sin().abs() < 1e-9);
    parts.iter().take_while(same).count()
}

/// Where two lines in a plane meet; the middle between their points where they are parallel, or nearly, or
/// fold back.
fn corner_of_lines(before: &Turtle, behind: &Turtle) -> Vector3<f64> {
    let between = behind.at - before.at;
    let across = behind.t() - before.t() * before.t().dot(&behind.t());
    let squared = across.norm_squared();
    if squared < 1e-6 || before.t().dot(&behind.t()) < FOLD.cos() {
        return before.at + between / 2.0;
    }
    behind.at - behind.t() * (between.dot(&across) / squared)
}
