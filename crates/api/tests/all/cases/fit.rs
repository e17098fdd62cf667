//! How well one path lies on another. A mirror image stays one: it is never reflected to fit.

use nalgebra::{Matrix3, Point3, Vector3};

/// For every point how far `b` is from `a` (mm), once `b` is turned and shifted to lie on `a` with the least
/// squares (Kabsch 1976, with the sign that keeps the motion proper).
pub fn proper_misfits(a: &[Point3<f64>], b: &[Point3<f64>]) -> Vec<f64> {
    assert_eq!(a.len(), b.len());
    #[allow(clippy::cast_precision_loss)]
    let mean =
        |points: &[Point3<f64>]| points.iter().map(|p| p.coords).sum::<Vector3<f64>>() / points.len() as f64;
    let (ma, mb) = (mean(a), mean(b));
    let covariance: Matrix3<f64> =
        a.iter().zip(b).map(|(p, q)| (q.coords - mb) * (p.coords - ma).transpose()).sum();
    let svd = covariance.svd(true, true);
    let (u, v_t) = (svd.u.unwrap(), svd.v_t.unwrap());
    let sign = (v_t.transpose() * u.transpose()).determinant().signum();
    // The least singular direction is flipped where the best fit would mirror.
    let least = svd.singular_values.imin();
    let mut diagonal = Vector3::repeat(1.0);
    diagonal[least] = sign;
    let rotation = v_t.transpose() * Matrix3::from_diagonal(&diagonal) * u.transpose();
    assert!(rotation.determinant() > 0.0, "a turn, not a reflection");
    a.iter().zip(b).map(|(p, q)| ((p.coords - ma) - rotation * (q.coords - mb)).norm()).collect()
}
