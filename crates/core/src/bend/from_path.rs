//! The nominal program of a path.

use nalgebra::Point3;

use super::{Frame, NominalProgram, Step};
use crate::units::{Angle, Length};

/// Why a path has no program.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum PathError {
    /// A path needs two points.
    #[error("a path needs at least 2 points, this one has {0}")]
    TooShort(usize),
    /// Two successive points are the same.
    #[error("points {0} and {next} of the path are the same: a segment without length has no direction", next = .0 + 1)]
    NoDirection(usize),
}

/// The program that makes a path (points in mm), and the frame that it starts from.
///
/// Replaying the program from that frame gives the path back, with its handedness. Bends are in
/// [0°, 180°]; the rotation before a bend is the signed angle between its plane and the last valid
/// one, and the first bend has none. Where the direction changes by no more than `straight`, the
/// feed continues and the plane is carried over; the next bend starts from the direction that the
/// wire really has, so directions do not drift. A fold back is a bend of 180° in the plane of the
/// bend before it.
///
/// # Errors
/// [`PathError`] when the path has fewer than two points or a segment without length.
pub fn program_of_path(path: &[Point3<f64>], straight: Angle) -> Result<(Frame, NominalProgram), PathError> {
    if path.len() < 2 {
        return Err(PathError::TooShort(path.len()));
    }
    let mut directions = Vec::with_capacity(path.len() - 1);
    for (k, pair) in path.windows(2).enumerate() {
        directions.push((pair[1] - pair[0]).try_normalize(0.0).ok_or(PathError::NoDirection(k))?);
    }
    // n of the first frame looks to the side of the first real bend, which then needs no rotation.
    let first = directions[0];
    let side = directions.iter().find(|d| first.cross(d).norm() > straight.rad().sin().abs().max(1e-12));
    let start =
        Frame::looking(path[0], first, side.copied().unwrap_or_default()).ok_or(PathError::NoDirection(0))?;

    let mut frame = start;
    let mut program = NominalProgram::default();
    let mut feed = Length::ZERO;
    let mut from = 0;
    for (k, pair) in path.windows(2).enumerate() {
        feed += Length::computed((pair[1] - pair[0]).norm());
        let Some(&next) = directions.get(k + 1) else { break };
        let (along, aside) = (frame.t().dot(&next), next - frame.t() * frame.t().dot(&next));
        let bend = Angle::computed(aside.norm().atan2(along));
        if bend <= straight {
            continue;
        }
        // Folded straight back, no plane is given: keep the one that there is.
        let folded = Angle::HALF_TURN - bend <= straight;
        let rotate = if folded {
            Angle::ZERO
        } else {
            Angle::computed(aside.dot(&frame.b()).atan2(aside.dot(&frame.n()))).wrapped()
        };
        let first_bend = program.steps.is_empty();
        let step = Step {
            feed,
            rotate: if first_bend { Angle::ZERO } else { rotate },
            bend: if folded { Angle::HALF_TURN } else { bend },
        };
        frame.rotate(step.rotate);
        frame.bend(step.bend);
        program.steps.push(step);
        program.spans.push(from..k + 1);
        from = k + 1;
        feed = Length::ZERO;
    }
    program.steps.push(Step { feed, ..Step::default() });
    program.spans.push(from..directions.len());
    Ok((start, program))
}
