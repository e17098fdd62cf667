//! What was read beside what was meant.

use nalgebra::Point3;
use wirebend_core::bend::{Convention, Frame, Sign, Step, replay};

use crate::cases::proper_misfits;
use crate::exports::bounds::{Off, of_vertices};
use crate::exports::is_flat;

/// How the numbers of a column are rounded.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Rounding {
    /// Each to its nearest number.
    Each,
    /// So that what they add up to is the nearest number.
    Sum,
}

/// What the last bits of a float may do, in units of the last digit.
const BITS: f64 = 1e-4;

/// Asserts that the numbers of an axis are those that were meant, to half of the last digit.
#[track_caller]
pub fn assert_numbers(about: &str, read: &[f64], meant: &[f64], digit: f64, rounding: Rounding) {
    assert_eq!(read.len(), meant.len(), "{about}");
    let (mut sum_read, mut sum_meant) = (0.0, 0.0);
    for (n, (read, meant)) in read.iter().zip(meant).enumerate() {
        match rounding {
            Rounding::Each => (sum_read, sum_meant) = (*read, *meant),
            Rounding::Sum => {
                sum_read += read;
                sum_meant += meant;
            }
        }
        let off = (sum_read - sum_meant).abs();
        assert!(off <= digit * (0.5 + BITS), "{about}, step {n}: {sum_read} for {sum_meant}");
    }
}

/// Feeds in mm, rotations and bends in degrees.
pub fn axes(steps: &[Step]) -> [Vec<f64>; 3] {
    [
        steps.iter().map(|step| step.feed.mm()).collect(),
        steps.iter().map(|step| step.rotate.deg()).collect(),
        steps.iter().map(|step| step.bend.deg()).collect(),
    ]
}

/// Asserts that the steps of a machine are those that were meant: feed, rotation and bend, each rounded in its way.
#[track_caller]
pub fn assert_steps(about: &str, read: &[Step], meant: &[Step], digit: f64, rounding: [Rounding; 3]) {
    let names = ["feed", "rotate", "bend"];
    for (((read, meant), name), rounding) in axes(read).iter().zip(&axes(meant)).zip(names).zip(rounding) {
        assert_numbers(&format!("{about}: {name}"), read, meant, digit, rounding);
    }
}

/// Asserts that each vertex of a wire is where it was meant, within its bound, and that its mirror image is not it.
/// Both start at the same point in the same direction.
#[track_caller]
pub fn assert_same_wire(case: &str, made: &[Point3<f64>], meant: &[Point3<f64>], off: &[Off]) {
    let farthest = assert_near(case, made, meant, off);
    assert_handed(case, made, meant, farthest);
}

/// Asserts that each vertex is where it was meant, and gives the largest bound, mm.
#[track_caller]
pub fn assert_near(case: &str, made: &[Point3<f64>], meant: &[Point3<f64>], off: &[Off]) -> f64 {
    assert_eq!(made.len(), meant.len(), "{case}");
    let bounds = of_vertices(meant, off);
    for (k, ((made, meant), bound)) in made.iter().zip(meant).zip(&bounds).enumerate() {
        let found = (made - meant).norm();
        assert!(found <= *bound, "{case}: vertex {k} is {found} mm off, more than {bound}");
    }
    bounds.into_iter().fold(0.0, f64::max)
}

/// Asserts that a wire can be turned and shifted onto what was meant, as far as rounding goes (mm), and that its mirror
/// image misses it by ten times that, unless the wire is flat: then its mirror image is itself, turned over.
///
/// Of all turns the one with the least squares is tried, so that no other one fits better. Only a flat wire
/// lies on its image: of others the vertices say where each point of the image would have to be.
#[track_caller]
pub fn assert_handed(case: &str, made: &[Point3<f64>], meant: &[Point3<f64>], rounding: f64) {
    let itself = root_mean_square(&proper_misfits(meant, made));
    assert!(itself <= rounding, "{case}: {itself} mm, more than {rounding}");
    let mirror: Vec<Point3<f64>> = made.iter().map(|p| Point3::new(-p.x, p.y, p.z)).collect();
    let image = root_mean_square(&proper_misfits(meant, &mirror));
    if is_flat(case) {
        assert!(image <= rounding, "{case} is not flat: {image} mm");
    } else {
        assert!(
            image > 10.0 * rounding,
            "{case}: the mirror image fits to {image} mm, rounding is {rounding}"
        );
    }
}

fn root_mean_square(values: &[f64]) -> f64 {
    #[allow(clippy::cast_precision_loss)] // as many as a wire has vertices
    let count = values.len() as f64;
    (values.iter().map(|value| value * value).sum::<f64>() / count).sqrt()
}

/// The path of a program from the standard start.
pub fn path(steps: &[Step]) -> Vec<Point3<f64>> {
    replay(Frame::default(), steps)
}

/// The steps of the mirror image.
pub fn other_hand(steps: &[Step]) -> Vec<Step> {
    let mirror = Convention { rotate: Sign::Opposite, ..Convention::default() };
    steps.iter().map(|&step| mirror.apply(step)).collect()
}
