//! How the wire lies in the machine.

use nalgebra::{Matrix3, Point3, Rotation3, Unit, UnitQuaternion, Vector3};

use crate::bend::{Frame, Step};
use crate::units::Angle;

/// Directions whose cross product is shorter than this are on one line.
const ON_ONE_LINE: f64 = 1e-6;

/// How the wire lies in the machine while it runs a step. The point of the wire that is just leaving lies at the bend
/// point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// From the frame of the design to the frame of the machine, while the wire is fed and the head rotates.
    pub turn: UnitQuaternion<f64>,
    /// The axis through the bend point about which the wire that is out then turns, in the frame of the machine.
    pub bend_axis: Unit<Vector3<f64>>,
    /// How far it turns, right-handed.
    pub bend: Angle,
}

impl Pose {
    /// The turn when so much of the bend is done, from 0 to 1.
    #[must_use]
    pub fn turned(&self, bent: f64) -> UnitQuaternion<f64> {
        UnitQuaternion::from_axis_angle(&self.bend_axis, self.bend.rad() * bent) * self.turn
    }
}

/// The poses of the wire that steps bend from `start`: one a step.
///
/// ```
/// use nalgebra::Vector3;
/// use wirebend_core::bend::{Frame, Step};
/// use wirebend_core::motion::poses;
/// use wirebend_core::units::{Angle, Length};
/// let feed = Length::from_mm(10.0)?;
/// let corner = Step { feed, bend: Angle::from_deg(90.0)?, ..Step::default() };
/// let pose = poses(Frame::default(), &[corner])[0];
/// // What was fed along x lies on +x of the machine, seen from the bend point, and is bent to +y.
/// assert!((pose.turned(0.0) * -Vector3::x() - Vector3::x()).norm() < 1e-12);
/// assert!((pose.turned(1.0) * -Vector3::x() - Vector3::y()).norm() < 1e-12);
/// # Ok::<(), wirebend_core::units::NotFinite>(())
/// ```
#[must_use]
pub fn poses(start: Frame, steps: &[Step]) -> Vec<Pose> {
    let (mut frame, mut head) = (start, Angle::ZERO);
    let pose = |step: &Step| {
        let turn = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), head.rad()) * at_reference(&frame);
        frame.rotate(step.rotate);
        head -= step.rotate;
        let pose = Pose { turn, bend_axis: bend_axis(head), bend: step.bend };
        frame.bend(step.bend);
        pose
    };
    steps.iter().map(pose).collect()
}

/// The poses of a wire that is known by its ends and corners in mm, as a machine has bent it: one a step, fewer where there
/// are fewer points.
///
/// It is shown as it is, although its `steps` asked for something else: they say only which way to fold back, where the
/// points leave it open. `start`: the frame in which the steps begin, for the axis about which the first of them bends. A
/// part without length has no direction of its own; the wire continues as before.
#[must_use]
pub fn poses_of_points(points: &[Point3<f64>], start: &Frame, steps: &[Step]) -> Vec<Pose> {
    let mut directions: Vec<Vector3<f64>> = Vec::with_capacity(steps.len());
    for pair in points.windows(2).take(steps.len()) {
        let own = (pair[1] - pair[0]).try_normalize(1e-12);
        directions.push(own.or_else(|| directions.last().copied()).unwrap_or_else(Vector3::x));
    }
    let first = directions.first().copied().unwrap_or_else(Vector3::x);
    let frame = Frame::looking(start.position, first, start.b().cross(&first)).unwrap_or(*start);
    let (mut turn, mut head) = (at_reference(&frame), Angle::ZERO);
    let mut poses = Vec::with_capacity(directions.len());
    for (k, step) in steps.iter().take(directions.len()).enumerate() {
        head -= step.rotate;
        let still = (bend_axis(head), Angle::ZERO);
        let (bend_axis, bend) =
            directions.get(k + 1).map_or(still, |&next| bend_to(turn * next, head, step.bend));
        let pose = Pose { turn, bend_axis, bend };
        turn = pose.turned(1.0);
        poses.push(pose);
    }
    poses
}

/// From the frame of the design to that of the machine whose head is at its reference: the wire travels along -x, and since
/// the wire that is out turns against the turtle, the axis of its bends is -z.
fn at_reference(frame: &Frame) -> UnitQuaternion<f64> {
    let rows = [-frame.t().transpose(), frame.n().transpose(), -frame.b().transpose()];
    UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(Matrix3::from_rows(&rows)))
}

/// The head's z when it has turned about +x.
pub(crate) fn bend_axis(head: Angle) -> Unit<Vector3<f64>> {
    Unit::new_unchecked(Vector3::new(0.0, -head.rad().sin(), head.rad().cos()))
}

/// What takes the next direction to the direction of travel the shortest way; a fold back goes the way of its bend.
fn bend_to(next: Vector3<f64>, head: Angle, bend: Angle) -> (Unit<Vector3<f64>>, Angle) {
    let across = next.cross(&-Vector3::x());
    let angle = Angle::computed(across.norm().atan2(-next.x));
    if let Some(axis) = Unit::try_new(across, ON_ONE_LINE) {
        return (axis, angle);
    }
    let folds = next.x > 0.0;
    let angle = if bend < Angle::ZERO { -angle } else { angle };
    (bend_axis(head), if folds { angle } else { Angle::ZERO })
}
