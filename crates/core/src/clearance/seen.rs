//! A motion as a body of the machine sees it.

use nalgebra::{
    IsometryMatrix3, Matrix3, Point3, Rotation3, Translation3, UnitQuaternion, Vector2, Vector3, convert,
};
use wirebend_collide::Motion;

use super::body::{Bodies, Body, MovesWith};
use super::rooms::{Axis, Carried, Lane, Rooms, Swing, Turned};
use super::stroke::{Phase, State, Stroke};

/// How the wire moves past a body.
#[derive(Debug, Clone, Copy)]
enum Course {
    /// It goes along x, into the room that the body has to itself.
    Straight(Lane),
    /// The head, with x as its axis, turns about it.
    AboutWire(Swing),
    /// It and the peg turn about the bend axis, z of the head.
    AboutBendAxis(Swing),
}

/// Strokes of one phase, each in an even share of the time, as a body sees them.
pub(super) struct Seen<'a> {
    strokes: &'a [Stroke],
    /// How many strokes there are.
    count: f64,
    moves_with: MovesWith,
    pivot: f64,
    /// Of the bend, mm.
    radius: f64,
    course: Course,
    /// From the frame of the design to that in which things move.
    from_design: IsometryMatrix3<f64>,
    /// From that frame to the body's.
    into_body: IsometryMatrix3<f64>,
    fastest: Fastest,
}

/// How fast things move at most, per time of all strokes, and how far the wire is bent at most: mm and radians.
#[derive(Default)]
struct Fastest {
    fed: f64,
    head: f64,
    /// The wire, seen from the body, about where it leaves the pin.
    turn: f64,
    axis: f64,
    peg_in: f64,
    bent: f64,
}

impl Fastest {
    fn of(strokes: &[Stroke], count: f64, moves_with: MovesWith) -> Self {
        let mut fastest = Self::default();
        for Stroke { from, to, side, .. } in strokes {
            let with_axis = if moves_with == MovesWith::Peg { to.axis - from.axis } else { 0.0 };
            let raise = |most: &mut f64, moved: f64| *most = most.max(moved.abs() * count);
            raise(&mut fastest.fed, to.fed - from.fed);
            raise(&mut fastest.head, to.head - from.head);
            raise(&mut fastest.turn, side * (to.bent - from.bent) - with_axis);
            raise(&mut fastest.axis, with_axis);
            if moves_with == MovesWith::Peg {
                raise(&mut fastest.peg_in, to.peg_in - from.peg_in);
            }
            fastest.bent = fastest.bent.max(from.bent).max(to.bent);
        }
        fastest
    }
}

impl<'a> Seen<'a> {
    pub fn new(strokes: &'a [Stroke], body: &Body, rooms: &Rooms, bodies: &Bodies) -> Option<Self> {
        let Stroke { phase, lie, from, to, radius, .. } = *strokes.first()?;
        let count = strokes.iter().map(|_| 1.0).sum();
        let fastest = Fastest::of(strokes, count, body.moves_with);
        let lying = Translation3::new(from.fed, 0.0, 0.0) * lie.turn * Translation3::from(-lie.begin.coords);
        let carried = body.moves_with != MovesWith::Frame;
        let into_head = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), -from.head);
        let at_rest =
            Translation3::new(0.0, 0.0, if body.moves_with == MovesWith::Peg { -from.peg_in } else { 0.0 });
        let (course, from_design, placed) = match (phase, rooms.carried) {
            (Phase::Feed, _) => {
                let from_design = if carried { into_head * lying } else { lying };
                (Course::Straight(rooms.lane.fed(to.fed - from.fed)), from_design, at_rest * body.at)
            }
            (Phase::Rotate, Some(Carried { about_wire, .. })) => {
                let swing = about_wire.swing([from.head, to.head], 0.0);
                (Course::AboutWire(swing), lying, at_rest * body.at)
            }
            (_, carried_rooms) => {
                let placed = if carried { body.at } else { into_head * body.at };
                let about = || Turned::around(&body.solid, &placed, Axis::Bend);
                let about_bend_axis = carried_rooms.map_or_else(about, |rooms| rooms.about_bend_axis);
                // The wire rolls around the pin, so that it comes nearer to the bend axis or goes away from it by up to this.
                let rolls = radius * fastest.bent * fastest.bent / 2.0;
                let swing = about_bend_axis.swing(bent_back(strokes), rolls);
                (Course::AboutBendAxis(swing), into_head * lying, placed)
            }
        };
        Some(Self {
            strokes,
            count,
            moves_with: body.moves_with,
            pivot: bodies.pivot.mm(),
            radius,
            course,
            from_design: convert(from_design),
            into_body: convert(placed.inverse()),
            fastest,
        })
    }

    /// The stroke that runs at a time, and how far it is then.
    pub fn stroke_at(&self, time: f64) -> (&'a Stroke, f64) {
        let (mut index, mut time) = (0, time * self.count);
        while time > 1.0 && index + 1 < self.strokes.len() {
            (index, time) = (index + 1, time - 1.0);
        }
        (&self.strokes[index], time)
    }

    /// How the wire has moved, in the frame in which it does; as the peg sees it where the body is of the peg.
    fn moved(&self, state: &State, side: f64) -> IsometryMatrix3<f64> {
        match self.course {
            Course::Straight(_) => {
                let fed = state.fed - self.strokes[0].from.fed;
                return IsometryMatrix3::from_parts(Translation3::new(fed, 0.0, 0.0), Rotation3::identity());
            }
            Course::AboutWire(_) => {
                let turn = Rotation3::from_axis_angle(&Vector3::x_axis(), -state.head);
                return IsometryMatrix3::from_parts(Translation3::identity(), turn);
            }
            Course::AboutBendAxis(_) => {}
        }
        let (sin, cos) = state.bent.sin_cos();
        let radius = self.radius;
        let arc = radius * state.bent;
        let leaves = Vector3::new(radius * sin - arc * cos, side * (radius * (1.0 - cos) - arc * sin), 0.0);
        let rolled = IsometryMatrix3::from_parts(leaves.into(), about_z(side * sin, cos));
        if self.moves_with != MovesWith::Peg {
            return rolled;
        }
        let (sin, cos) = (-state.axis).sin_cos();
        let pivot = Vector3::x() * self.pivot;
        let back = about_z(sin, cos);
        let shift = Vector3::new(self.pivot, 0.0, state.peg_in) - back * pivot;
        IsometryMatrix3::from_parts(shift.into(), back) * rolled
    }
}

impl Motion for Seen<'_> {
    fn pose(&self, time: f64) -> IsometryMatrix3<f64> {
        let (stroke, time) = self.stroke_at(time);
        self.into_body * self.moved(&stroke.at(time), stroke.side) * self.from_design
    }

    fn max_travel(&self, centre: &Point3<f64>, radius: f64) -> f64 {
        let (at, fastest) = (self.from_design * centre, &self.fastest);
        match self.course {
            Course::Straight(_) => fastest.fed,
            Course::AboutWire(_) => fastest.head * (at.yz().coords.norm() + radius),
            Course::AboutBendAxis(_) => {
                // It turns about where it leaves the pin, a point that goes along the wire.
                let rolled = self.radius * fastest.bent;
                let arm = [0.0, rolled].map(|rolled| Vector2::new(at.x - rolled, at.y).norm());
                let turned = fastest.turn * (arm[0].max(arm[1]) + radius);
                turned + fastest.axis * (self.pivot.abs() + rolled) + fastest.peg_in
            }
        }
    }

    fn min_distance(&self, at: &Point3<f64>) -> f64 {
        let at = self.from_design * at;
        match self.course {
            Course::Straight(lane) => lane.distance(&at),
            Course::AboutWire(swing) => swing.distance(at.x, at.yz().coords),
            Course::AboutBendAxis(swing) => swing.distance(at.z, at.xy().coords),
        }
    }

    fn min_distance_of_piece(&self, ends: [&Point3<f64>; 2]) -> f64 {
        let ends = ends.map(|end| self.from_design * end);
        match self.course {
            Course::Straight(lane) => lane.distance_of_piece(ends),
            Course::AboutWire(swing) => swing.distance_of_piece(ends.map(|at| (at.x, at.yz().coords))),
            Course::AboutBendAxis(swing) => swing.distance_of_piece(ends.map(|at| (at.z, at.xy().coords))),
        }
    }
}

/// From where to where a body turns about the bend axis as the wire sees it, which turns the other way.
fn bent_back(strokes: &[Stroke]) -> [f64; 2] {
    let turned = |Stroke { from, to, side, .. }: &Stroke| [-side * from.bent, -side * to.bent];
    let all = || strokes.iter().flat_map(turned);
    [all().fold(f64::INFINITY, f64::min), all().fold(f64::NEG_INFINITY, f64::max)]
}

/// A turn about z.
fn about_z(sin: f64, cos: f64) -> Rotation3<f64> {
    Rotation3::from_matrix_unchecked(Matrix3::new(cos, -sin, 0.0, sin, cos, 0.0, 0.0, 0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_PI_2;

    use nalgebra::{Isometry3, Point3, Vector3};
    use proptest::prelude::*;
    use wirebend_collide::{Motion, Solid};

    use super::super::body::{Bodies, Body, MovesWith};
    use super::super::centreline::Lie;
    use super::super::stroke::{Moves, strokes};
    use super::{Rooms, Seen};
    use crate::testing::{deg, mm, published_machine};
    use crate::units::{Angle, Length};

    fn body(moves_with: MovesWith, solid: Solid, at: Isometry3<f64>) -> Body {
        let [name, entry, source] = ["", "", ""].map(str::to_owned);
        let (contact_zone, vertex_zone) = (Length::ZERO, Length::ZERO);
        Body { name, moves_with, solid, at, contact_zone, vertex_zone, entry, source, measured: true }
    }

    fn solid() -> impl Strategy<Value = Solid> {
        prop_oneof![
            prop::array::uniform3(1.0..60.0_f64).prop_map(|half| Solid::Box { half: half.into() }),
            (1.0..60.0_f64, 1.0..60.0_f64)
                .prop_map(|(radius, half_length)| Solid::Cylinder { radius, half_length }),
            (1.0..60.0_f64, 1.0..60.0_f64)
                .prop_map(|(radius, half_length)| Solid::Capsule { radius, half_length }),
        ]
    }

    proptest! {
        /// A bound that is not one would hide a contact.
        #[test]
        fn no_point_comes_nearer_or_moves_faster_than_its_bounds_say(
            solid in solid(),
            at in prop::array::uniform3(-120.0..120.0_f64),
            // A body that lies along x keeps its shape where others get a box around them.
            lie in prop_oneof![prop::array::uniform3(-3.0..3.0_f64), Just([0.0, FRAC_PI_2, 0.0]), Just([0.0; 3])],
            design in prop::array::uniform3(-3.0..3.0_f64),
            points in prop::collection::vec(prop::array::uniform3(-200.0..200.0_f64), 2),
            (fed, head, bend) in (1.0..90.0_f64, prop::array::uniform2(-180.0..180.0_f64), -130.0..130.0_f64),
        ) {
            let machine = published_machine();
            let bodies = Bodies {
                all: Vec::new(), pivot: mm(12.0), peg_stroke: mm(25.0), peg_rest: Angle::ZERO, approach: deg(10.0),
            };
            let model = &machine.compensation.bend;
            let moves = Moves {
                lie: Lie { turn: nalgebra::UnitQuaternion::new(design.into()), begin: Point3::new(5.0, -3.0, 8.0) },
                radius: 3.0,
                fed,
                head: head.map(deg),
                bend: deg(bend),
                pressed: model.springback.as_ref().unwrap().bend_to(deg(bend)).abs(),
                told: model.command(deg(bend)).unwrap_or(deg(bend)),
                approach: None,
            };
            let all = strokes(&moves, &bodies, model.setback.as_ref(), true);
            let points: Vec<Point3<f64>> = points.into_iter().map(Point3::from).collect();
            for moves_with in [MovesWith::Frame, MovesWith::Head, MovesWith::Peg] {
                let body = body(moves_with, solid, Isometry3::new(at.into(), Vector3::from(lie)));
                let rooms = Rooms::new(&body, &bodies);
                for phase in all.chunk_by(|one, other| one.phase == other.phase) {
                    if !phase[0].moves(moves_with) {
                        continue;
                    }
                    let seen = Seen::new(phase, &body, &rooms, &bodies).unwrap();
                    let ends = [&points[0], &points[1]];
                    let [least, of_piece] = [seen.min_distance(ends[0]), seen.min_distance_of_piece(ends)];
                    let most = seen.max_travel(ends[0], 0.0);
                    let mut before = seen.pose(0.0) * ends[0];
                    for k in 0..=200 {
                        let pose = seen.pose(f64::from(k) / 200.0);
                        let now = pose * ends[0];
                        prop_assert!(least <= body.solid.distance(&now) + 1e-6, "{moves_with:?} {:?}", phase[0].phase);
                        prop_assert!((now - before).norm() <= most / 200.0 + 1e-6, "{moves_with:?} {:?}", phase[0].phase);
                        for part in 0..=10 {
                            let at = ends[0] + (ends[1] - ends[0]) * (f64::from(part) / 10.0);
                            prop_assert!(of_piece <= body.solid.distance(&(pose * at)) + 1e-6, "{moves_with:?} {:?}", phase[0].phase);
                        }
                        before = now;
                    }
                }
            }
        }
    }
}
