//! The plane of a flat wire, and from which side it is seen.

use nalgebra::{Matrix3, Point3, SymmetricEigen, Vector3};
use wirebend_core::units::{Angle, Length};

/// A view along a direction: what is to the right, and what is up. Both are unit vectors at right angles.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct View {
    pub right: Vector3<f64>,
    pub up: Vector3<f64>,
}

impl View {
    /// Towards the eye.
    pub fn normal(&self) -> Vector3<f64> {
        self.right.cross(&self.up)
    }

    /// From the side that `normal`, a unit vector, points to. Up is z as far as it can be; seen along z, x is to the
    /// right.
    fn from(normal: Vector3<f64>) -> Option<Self> {
        let within = |axis: Vector3<f64>| (axis - normal * normal.dot(&axis)).try_normalize(1e-9);
        if normal.z.abs() > 0.5 {
            let right = within(Vector3::x())?;
            return Some(Self { right, up: normal.cross(&right) });
        }
        let up = within(Vector3::z())?;
        Some(Self { right: up.cross(&normal), up })
    }

    pub fn point(&self, point: Point3<f64>) -> [f64; 2] {
        self.vector(point.coords)
    }

    pub fn vector(&self, vector: Vector3<f64>) -> [f64; 2] {
        [self.right.dot(&vector), self.up.dot(&vector)]
    }
}

/// The view of a wire that is flat: no point is farther than `tolerance` from one plane. It is seen from the side on
/// which its first bend, beyond `straight`, is positive: there the wire turns left. `None` where it is not flat.
pub(super) fn of_flat(path: &[Point3<f64>], tolerance: Length, straight: Angle) -> Option<View> {
    #[allow(clippy::cast_precision_loss)] // as many as a wire has vertices
    let count = path.len().max(1) as f64;
    let middle = path.iter().map(|point| point.coords).sum::<Vector3<f64>>() / count;
    let from_middle = || path.iter().map(move |point| point.coords - middle);
    let spread: Matrix3<f64> = from_middle().map(|v| v * v.transpose()).sum();
    let axes = SymmetricEigen::new(spread);
    let normal: Vector3<f64> = axes.eigenvectors.column(axes.eigenvalues.imin()).into();
    let along: Vector3<f64> = axes.eigenvectors.column(axes.eigenvalues.imax()).into();
    let aside = |v: Vector3<f64>| v - along * along.dot(&v);
    // A straight wire lies in every plane along it: seen from above if it can be.
    let normal = if from_middle().all(|v| aside(v).norm() <= 1e-6) {
        aside(Vector3::z()).try_normalize(0.1).or_else(|| aside(Vector3::y()).try_normalize(0.1))?
    } else {
        normal.try_normalize(0.0)?
    };
    if from_middle().any(|v| v.dot(&normal).abs() > tolerance.mm()) {
        return None;
    }
    // Folded straight back, a wire has turned to no side.
    let min = straight.rad().abs().max(1e-6).sin();
    let turn = path.windows(3).find_map(|three| {
        let axis =
            (three[1] - three[0]).try_normalize(0.0)?.cross(&(three[2] - three[1]).try_normalize(0.0)?);
        (axis.norm() > min).then(|| axis.dot(&normal))
    });
    View::from(if turn.unwrap_or_default() < 0.0 { -normal } else { normal })
}

/// Points laid into the plane of a view: to the right, up, and zero.
pub(super) fn laid(path: &[Point3<f64>], view: &View) -> Vec<Point3<f64>> {
    path.iter().map(|&point| view.point(point)).map(|[x, y]| Point3::new(x, y, 0.0)).collect()
}
