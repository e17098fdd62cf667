//! A strut as textbooks have it: a straight beam with six degrees of freedom at each end, in axes of its own that are turned to those
//! of the design (Przemieniecki, Theory of Matrix Structural Analysis, 1968, chapter 5; no shear deformation).

use std::f64::consts::PI;

use nalgebra::{Matrix3, Point3, SMatrix, SVector, Vector3};

use crate::Section;

/// What happens at both ends along and about x, y and z: displacements and rotations, or forces and moments.
pub(crate) type Ends = SVector<f64, 12>;
type Matrix12 = SMatrix<f64, 12, 12>;

/// A strut in the axes of the design; N, mm, radian.
pub(crate) struct Beam {
    pub stiffness: Matrix12,
    /// The forces and moments at its ends that stand for its weight.
    pub weight: Ends,
}

impl Beam {
    pub fn new([a, b]: [Point3<f64>; 2], section: &Section, gravity: &Vector3<f64>) -> Self {
        let (length, axes) = ((b - a).norm(), axes(&(b - a)));
        let mut turn = Matrix12::zeros();
        for part in 0..4 {
            turn.fixed_view_mut::<3, 3>(3 * part, 3 * part).copy_from(&axes);
        }
        let line = axes * gravity * (section.density_t_mm3 * PI * section.radius_mm.powi(2));
        Self {
            stiffness: turn.transpose() * stiffness(length, section) * turn,
            weight: turn.transpose() * spread(length, &line),
        }
    }
}

/// The axes of a beam as rows: x along it, y and z across.
fn axes(along: &Vector3<f64>) -> Matrix3<f64> {
    let x = along.normalize();
    let z = x.cross(&Vector3::ith(x.iamin(), 1.0)).normalize();
    Matrix3::from_rows(&[x.transpose(), z.cross(&x).transpose(), z.transpose()])
}

/// The stiffness of a beam in its own axes: displacements along x, y and z at 0, 1 and 2 and rotations about them at 3, 4 and 5 of one
/// end, six places farther those of the other.
fn stiffness(length: f64, section: &Section) -> Matrix12 {
    let (area, inertia) = (PI * section.radius_mm.powi(2), PI * section.radius_mm.powi(4) / 4.0);
    let stretch = section.e_mpa * area / length;
    let twist = section.g_mpa * 2.0 * inertia / length;
    let bend = section.e_mpa * inertia / length;
    let (shear, mixed) = (12.0 * bend / length.powi(2), 6.0 * bend / length);
    let upper = [
        (0, 0, stretch),
        (0, 6, -stretch),
        (6, 6, stretch),
        (3, 3, twist),
        (3, 9, -twist),
        (9, 9, twist),
        // Bent in the plane of x and y.
        (1, 1, shear),
        (1, 5, mixed),
        (1, 7, -shear),
        (1, 11, mixed),
        (5, 5, 4.0 * bend),
        (5, 7, -mixed),
        (5, 11, 2.0 * bend),
        (7, 7, shear),
        (7, 11, -mixed),
        (11, 11, 4.0 * bend),
        // In that of x and z a turn about y lowers what is ahead.
        (2, 2, shear),
        (2, 4, -mixed),
        (2, 8, -shear),
        (2, 10, -mixed),
        (4, 4, 4.0 * bend),
        (4, 8, mixed),
        (4, 10, 2.0 * bend),
        (8, 8, shear),
        (8, 10, mixed),
        (10, 10, 4.0 * bend),
    ];
    let mut stiffness = Matrix12::zeros();
    for (row, column, value) in upper {
        stiffness[(row, column)] = value;
        stiffness[(column, row)] = value;
    }
    stiffness
}

/// The forces and moments at its ends that stand for a load along a beam, N/mm, all in its own axes.
fn spread(length: f64, line: &Vector3<f64>) -> Ends {
    let half = line * (length / 2.0);
    let moment = Vector3::new(0.0, -line.z, line.y) * (length * length / 12.0);
    let mut ends = Ends::zeros();
    for (at, part) in [half, moment, half, -moment].iter().enumerate() {
        ends.fixed_rows_mut::<3>(3 * at).copy_from(part);
    }
    ends
}
