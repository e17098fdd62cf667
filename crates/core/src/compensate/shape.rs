//! Pieces of wire, flat, and the circle on which a peg goes about them.

use nalgebra::{Point2, Vector2};

/// Straight wire or an arc of it.
#[derive(Debug, Clone, Copy)]
pub(super) enum Shape {
    Line {
        from: Point2<f64>,
        along: Vector2<f64>,
        length: f64,
    },
    /// `begin` points from the centre to where the arc begins; it goes on by `sweep` radians.
    Arc {
        centre: Point2<f64>,
        radius: f64,
        begin: f64,
        sweep: f64,
    },
}

/// The circle on which the peg goes.
pub(super) struct Orbit {
    pub centre: Point2<f64>,
    pub radius: f64,
    /// From the centre of the peg to a centreline that it touches.
    pub reach: f64,
}

impl Orbit {
    pub fn at(&self, angle: f64) -> Point2<f64> {
        self.centre + Vector2::new(angle.cos(), angle.sin()) * self.radius
    }

    /// Where the peg's centre is at a distance from a point.
    fn at_distance(&self, point: Point2<f64>, distance: f64, mut found: impl FnMut(f64)) {
        let away = point - self.centre;
        let far = away.norm();
        let cos = (self.radius.powi(2) + far.powi(2) - distance.powi(2)) / (2.0 * self.radius * far);
        if far > 1e-12 && cos.abs() <= 1.0 {
            let (towards, by) = (away.y.atan2(away.x), cos.acos());
            found(towards + by);
            found(towards - by);
        }
    }
}

impl Shape {
    /// Each place on the orbit from which the peg touches this, and more.
    pub fn touched_by(&self, orbit: &Orbit, mut found: impl FnMut(f64)) {
        match *self {
            Self::Line { from, along, length } => {
                let normal = Vector2::new(-along.y, along.x);
                let towards = normal.y.atan2(normal.x);
                for side in [-orbit.reach, orbit.reach] {
                    let cos = ((from - orbit.centre).dot(&normal) + side) / orbit.radius;
                    if cos.abs() > 1.0 {
                        continue;
                    }
                    for at in [towards + cos.acos(), towards - cos.acos()] {
                        let foot = (orbit.at(at) - from).dot(&along);
                        if (-1e-9..=length + 1e-9).contains(&foot) {
                            found(at);
                        }
                    }
                }
                for end in [from, from + along * length] {
                    orbit.at_distance(end, orbit.reach, &mut found);
                }
            }
            Self::Arc { centre, radius, .. } => {
                for distance in [radius + orbit.reach, radius - orbit.reach] {
                    if distance > 0.0 {
                        orbit.at_distance(centre, distance, |at| {
                            if self.faces(orbit.at(at)) {
                                found(at);
                            }
                        });
                    }
                }
            }
        }
    }

    /// Whether a point lies in the sector of an arc.
    fn faces(&self, point: Point2<f64>) -> bool {
        let Self::Arc { centre, begin, sweep, .. } = *self else { return true };
        let out = point - centre;
        let turned = (sweep.signum() * (out.y.atan2(out.x) - begin)).rem_euclid(std::f64::consts::TAU);
        turned <= sweep.abs() + 1e-9 || turned >= std::f64::consts::TAU - 1e-9
    }

    pub fn distance(&self, point: Point2<f64>) -> f64 {
        match *self {
            Self::Line { from, along, length } => {
                let foot = (point - from).dot(&along).clamp(0.0, length);
                (point - (from + along * foot)).norm()
            }
            Self::Arc { centre, radius, .. } if self.faces(point) => ((point - centre).norm() - radius).abs(),
            // Its ends are those of its neighbours.
            Self::Arc { .. } => f64::INFINITY,
        }
    }
}
