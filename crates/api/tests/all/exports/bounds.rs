//! How far a wire may be from what was meant when each of its commands is rounded.
//!
//! Change the commands from the first to the last, one at a time. When a command is changed, what follows it still
//! has the shape that was meant. A feed that is off by d shifts all of that by d. An angle that is off by e, in
//! radians, swings it about an axis through the corner, so that no vertex moves farther than e times its distance
//! from that corner. So for vertex k, with corner j at the end of feed j,
//!
//! `|made - meant| ≤ Σ(j ≤ k) d_j + Σ(j < k) e_j · |vertex k - corner j|`.

use nalgebra::Point3;
use wirebend_core::bend::Step;

/// What rounding may do to each step: its feed in mm, its two angles together in degrees.
#[derive(Debug, Clone, Copy)]
pub struct Off {
    pub feed_mm: f64,
    pub angles_deg: f64,
}

/// The bound of each vertex, mm; `corners` are the vertices as they are meant: one, and one after each feed.
pub fn of_vertices(corners: &[Point3<f64>], off: &[Off]) -> Vec<f64> {
    assert_eq!(corners.len(), off.len() + 1);
    // Replaying a program loses the last bits of a float, and bends that no axis resolves.
    let length: f64 = corners.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum();
    let arithmetic = 1e-9 * length + 1e-6;
    let of_vertex = |(k, vertex): (usize, &Point3<f64>)| {
        let fed: f64 = off[..k].iter().map(|off| off.feed_mm).sum();
        let before = corners.iter().skip(1).zip(off).take(k.saturating_sub(1));
        let swung: f64 =
            before.map(|(corner, off)| off.angles_deg.to_radians() * (vertex - corner).norm()).sum();
        arithmetic + fed + swung
    };
    corners.iter().enumerate().map(of_vertex).collect()
}

/// How far a corner of this radius (mm) moves along its wire when its bend is off by so many degrees:
/// the difference of r·tan(θ/2), which is larger to the sharper side.
pub fn of_corner(radius_mm: f64, step: &Step, off_deg: f64) -> f64 {
    let corner = |deg: f64| radius_mm * (deg.to_radians() / 2.0).tan();
    let bend = step.bend.abs().deg();
    if bend == 0.0 { 0.0 } else { corner(bend + off_deg) - corner(bend) }
}
