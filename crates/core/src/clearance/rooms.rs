//! The rooms in which a body stays, whatever moves: what does not enter them cannot meet it.

use nalgebra::{Isometry3, Point3, Translation3, UnitVector3, Vector2, Vector3};
use wirebend_collide::{Ring, Sector, Solid, Walls, to_solid};

use super::body::{Bodies, Body, MovesWith};

/// The rooms of a body.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rooms {
    /// While the wire is fed. With the peg at rest; the head is at its reference where it carries the body.
    pub lane: Lane,
    /// None where the head does not carry the body.
    pub carried: Option<Carried>,
}

/// The rooms of a body that the head carries.
#[derive(Debug, Clone, Copy)]
pub(super) struct Carried {
    /// With the peg at rest.
    pub about_wire: Turned,
    /// Wherever the peg goes.
    pub about_bend_axis: Turned,
}

impl Rooms {
    pub fn new(body: &Body, bodies: &Bodies) -> Self {
        let (pivot, stroke) = (bodies.pivot.mm(), bodies.peg_stroke.mm());
        let peg = body.moves_with == MovesWith::Peg;
        let at_rest = Translation3::new(0.0, 0.0, if peg { -stroke } else { 0.0 }) * body.at;
        let about_bend_axis = || {
            if !peg {
                return Turned::around(&body.solid, &body.at, Axis::Bend);
            }
            let about_pivot = Translation3::new(-pivot, 0.0, 0.0) * body.at;
            let Ring { along: [low, high], from_axis: [near, far] } =
                Ring::around(&body.solid, &about_pivot, &Axis::Bend.direction());
            let near = (near - pivot.abs()).max(pivot.abs() - far).max(0.0);
            let ring = Ring { along: [low - stroke, high], from_axis: [near, far + pivot.abs()] };
            Turned { ring, sector: None }
        };
        let carried = body.moves_with != MovesWith::Frame;
        Self {
            lane: Lane::around(&body.solid, &at_rest),
            carried: carried.then(|| Carried {
                about_wire: Turned::around(&body.solid, &at_rest, Axis::Wire),
                about_bend_axis: about_bend_axis(),
            }),
        }
    }
}

/// What things turn about: an axis through the bend point.
#[derive(Debug, Clone, Copy)]
pub(super) enum Axis {
    /// x.
    Wire,
    /// z of the head.
    Bend,
}

impl Axis {
    fn direction(self) -> UnitVector3<f64> {
        match self {
            Self::Wire => Vector3::x_axis(),
            Self::Bend => Vector3::z_axis(),
        }
    }

    fn across(self) -> [UnitVector3<f64>; 2] {
        match self {
            Self::Wire => [Vector3::y_axis(), Vector3::z_axis()],
            Self::Bend => [Vector3::x_axis(), Vector3::y_axis()],
        }
    }
}

/// Where a body is about an axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct Turned {
    ring: Ring,
    /// None where it is not known, or all around.
    sector: Option<Sector>,
}

impl Turned {
    pub fn around(solid: &Solid, at: &Isometry3<f64>, axis: Axis) -> Self {
        Self {
            ring: Ring::around(solid, at, &axis.direction()),
            sector: Sector::around(solid, at, axis.across()),
        }
    }

    /// The room while it turns from one angle to another, radians. `strays`: how far from there it may be besides, mm.
    pub fn swing(self, angles: [f64; 2], strays: f64) -> Swing {
        let mut ring = self.ring;
        ring.from_axis = [ring.from_axis[0] - strays, ring.from_axis[1] + strays];
        Swing { ring, walls: self.sector.and_then(|sector| sector.swept(angles)), strays }
    }
}

/// The room of a body that turns about an axis.
#[derive(Debug, Clone, Copy)]
pub(super) struct Swing {
    ring: Ring,
    walls: Option<Walls>,
    /// How far from between the walls it may be, mm.
    strays: f64,
}

impl Swing {
    /// A bound below the distance of a point: where it is along the axis, and the vector to it from there.
    pub fn distance(&self, along: f64, across: Vector2<f64>) -> f64 {
        let from_walls = self.walls.map(|walls| walls.distance(across) - self.strays);
        self.ring.distance(along, across.norm()).max(from_walls.unwrap_or(f64::NEG_INFINITY))
    }

    /// The same for all points of a straight piece.
    pub fn distance_of_piece(&self, ends: [(f64, Vector2<f64>); 2]) -> f64 {
        let from_walls =
            self.walls.map(|walls| walls.distance_of_piece(ends.map(|(_, across)| across)) - self.strays);
        self.ring.distance_of_piece(ends).max(from_walls.unwrap_or(f64::NEG_INFINITY))
    }
}

/// How exact the distance of a piece from a lane is, mm.
const LANE_EXACT: f64 = 1e-3;
/// What is along x but for so much of the cosine is along x.
const ALONG: f64 = 1e-14;

/// The room of a body along x: the body itself where it lies along x, otherwise a box around it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lane {
    middle: Vector3<f64>,
    /// With y, z and x of the machine as its axes.
    solid: Solid,
}

impl Lane {
    fn around(solid: &Solid, at: &Isometry3<f64>) -> Self {
        let half = |axis: UnitVector3<f64>| solid.half_extent(&(at.inverse() * axis));
        let half = Vector3::new(half(Vector3::y_axis()), half(Vector3::z_axis()), half(Vector3::x_axis()));
        let lies_along = (at.rotation * Vector3::z_axis()).x.abs() > 1.0 - ALONG;
        let is_box = matches!(solid, Solid::Box { .. });
        let solid = if lies_along && !is_box { *solid } else { Solid::Box { half } };
        Self { middle: at.translation.vector, solid }
    }

    /// The room of what stays in this one while the wire is fed: as the wire sees it, it goes against x.
    pub fn fed(self, by: f64) -> Self {
        let more = by / 2.0;
        let solid = match self.solid {
            Solid::Box { half } => Solid::Box { half: half + Vector3::z() * more },
            Solid::Cylinder { radius, half_length } => {
                Solid::Cylinder { radius, half_length: half_length + more }
            }
            Solid::Capsule { radius, half_length } => {
                Solid::Capsule { radius, half_length: half_length + more }
            }
        };
        Self { middle: self.middle - Vector3::x() * more, solid }
    }

    /// A bound below the distance of a point.
    pub fn distance(&self, at: &Point3<f64>) -> f64 {
        self.solid.distance(&self.placed(at))
    }

    /// The same for all points of a straight piece.
    pub fn distance_of_piece(&self, ends: [Point3<f64>; 2]) -> f64 {
        let [from, to] = ends.map(|end| self.placed(&end));
        to_solid([&from, &to], &self.solid, LANE_EXACT).distance - LANE_EXACT
    }

    fn placed(&self, at: &Point3<f64>) -> Point3<f64> {
        (at - self.middle).yzx()
    }
}
