//! What programs are compensated with, written down a second time and apart from the bench: the law of
//! sines for setback, a constant for springback, tangents and arcs for the feed.

use nalgebra::{Rotation3, Unit, Vector3};

use super::hand::Hand;

/// Mean springback of the published machine, degrees.
const SPRINGBACK_DEG: f64 = 10.23;

/// A step of a nominal program.
#[derive(Debug, Clone, Copy, Default)]
pub struct Step {
    pub feed_mm: f64,
    pub rotate_deg: f64,
    pub bend_deg: f64,
}

#[derive(Debug, Clone, Copy)]
pub struct Compensation {
    pub feed: bool,
    pub setback: bool,
    pub springback: bool,
}

pub const ALL: Compensation = Compensation { feed: true, setback: true, springback: true };
pub const NONE: Compensation = Compensation { feed: false, setback: false, springback: false };

impl Compensation {
    /// The bend axis' place for a bend: orbit 20.4 about 12, wrapped at 3, peg at 4.675.
    pub fn axis_deg(self, bend_deg: f64) -> f64 {
        let wanted = bend_deg.abs() + if self.springback { SPRINGBACK_DEG } else { 0.0 };
        let theta = wanted.to_radians();
        let argument = (12.0 * theta.sin() - 4.675 - 3.0 * (1.0 - theta.cos())) / 20.4;
        bend_deg.signum() * if self.setback { wanted + argument.asin().to_degrees() } else { wanted }
    }

    /// The feed that ends with the arc of a bend: centreline at 3.0, neutral fibre at 2.4.
    pub fn feed_mm(self, edge_mm: f64, before_deg: f64, bend_deg: f64) -> f64 {
        let tangent = |deg: f64| 3.0 * (deg.abs().to_radians() / 2.0).tan();
        let lost = tangent(before_deg) + tangent(bend_deg) - 2.4 * bend_deg.abs().to_radians();
        if self.feed { edge_mm - lost } else { edge_mm }
    }

    pub fn run(self, program: &[Step], hand: &mut Hand) {
        let mut before_deg = 0.0;
        for step in program {
            hand.feed(self.feed_mm(step.feed_mm, before_deg, step.bend_deg));
            hand.rotate(step.rotate_deg);
            if step.bend_deg != 0.0 {
                hand.press(self.axis_deg(step.bend_deg));
            }
            before_deg = step.bend_deg;
        }
    }
}

/// The nominal program of a path without straight joints: angles from 0 to 180, dihedrals between planes.
pub fn program_of(path: &[[f64; 3]]) -> Vec<Step> {
    let edges: Vec<Vector3<f64>> =
        path.windows(2).map(|pair| Vector3::from(pair[1]) - Vector3::from(pair[0])).collect();
    let mut plane: Option<Vector3<f64>> = None;
    let mut steps = Vec::new();
    for pair in edges.windows(2) {
        let (edge, next) = (pair[0], pair[1]);
        let normal = edge.cross(&next).normalize();
        let rotate =
            plane.map_or(0.0, |old| old.cross(&normal).dot(&edge.normalize()).atan2(old.dot(&normal)));
        let bend = edge.cross(&next).norm().atan2(edge.dot(&next));
        steps.push(Step {
            feed_mm: edge.norm(),
            rotate_deg: rotate.to_degrees(),
            bend_deg: bend.to_degrees(),
        });
        plane = Some(normal);
    }
    steps.extend(edges.last().map(|edge| Step { feed_mm: edge.norm(), ..Step::default() }));
    steps
}

/// The turtle, word by word: along t; the frame about t; the frame about b.
pub fn replay(program: &[Step]) -> Vec<[f64; 3]> {
    let mut at = Vector3::zeros();
    let (mut t, mut b) = (Vector3::x(), Vector3::z());
    let mut path = vec![at.into()];
    for step in program {
        at += t * step.feed_mm;
        path.push(at.into());
        b = Rotation3::from_axis_angle(&Unit::new_normalize(t), step.rotate_deg.to_radians()) * b;
        t = Rotation3::from_axis_angle(&Unit::new_normalize(b), step.bend_deg.to_radians()) * t;
    }
    path
}
