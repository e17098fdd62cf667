//! Replay: the path that a program makes.

use nalgebra::Point3;

use super::{Frame, Step};

/// The vertices (mm) that a program makes, from `start`: its position, then one after each feed.
///
/// ```
/// use nalgebra::Point3;
/// use wirebend_core::bend::{Frame, Step, replay};
/// use wirebend_core::units::{Angle, Length};
/// let feed = Length::from_mm(10.0)?;
/// let corner = Step { feed, bend: Angle::from_deg(90.0)?, ..Step::default() };
/// let end = Step { feed, ..Step::default() };
/// let path = replay(Frame::default(), &[corner, end]);
/// assert!((path[2] - Point3::new(10.0, 10.0, 0.0)).norm() < 1e-12);
/// # Ok::<(), wirebend_core::units::NotFinite>(())
/// ```
#[must_use]
pub fn replay(start: Frame, steps: &[Step]) -> Vec<Point3<f64>> {
    let mut frame = start;
    let mut path = vec![frame.position];
    for step in steps {
        frame.feed(step.feed);
        path.push(frame.position);
        frame.rotate(step.rotate);
        frame.bend(step.bend);
    }
    path
}
