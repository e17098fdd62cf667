//! How near a head comes to a strut on its way, by sampling.

use nalgebra::{Point3, Vector3};

/// How many places of a motion and of a strut are looked at in each round.
const PLACES: u32 = 30;
/// So often the neighbourhood of the nearest place is looked at again.
const ROUNDS: usize = 4;
/// So many places to each side of it.
const BESIDE: f64 = 3.0;

/// The least distance between the surface of a head and a strut while the tip goes from one place to another, mm; below 0 inside. Only
/// that it is more than `enough` where that is plain from the middles.
pub(crate) fn nearest(
    outline: &[[f64; 2]],
    axis: &Vector3<f64>,
    motion: [Point3<f64>; 2],
    strut: [Point3<f64>; 2],
    enough: f64,
) -> f64 {
    let corners = corners(outline);
    let (way, along) = (motion[1] - motion[0], strut[1] - strut[0]);
    let at = |s: f64, t: f64| distance(&corners, axis, &(strut[0] + along * t - (motion[0] + way * s)));
    // No point moves farther from the middles than half of both.
    let half = f64::midpoint(way.norm(), along.norm());
    let far = at(0.5, 0.5) - half;
    if far > enough {
        return far;
    }
    let mut least = f64::INFINITY;
    let mut window = [[0.0, 1.0]; 2];
    for _ in 0..ROUNDS {
        let mut nearest = (f64::INFINITY, [0.0; 2]);
        for s in places(window[0]) {
            for t in places(window[1]) {
                let mm = at(s, t);
                if mm < nearest.0 {
                    nearest = (mm, [s, t]);
                }
            }
        }
        least = least.min(nearest.0);
        // No place is farther from one that was looked at than half of what is between two.
        let far = least - half / f64::from(PLACES);
        if far > enough {
            return far;
        }
        // The head is convex: what is nearer still is around the nearest.
        window = [0, 1].map(|k| {
            let reach = BESIDE * (window[k][1] - window[k][0]) / f64::from(PLACES);
            [(nearest.1[k] - reach).max(0.0), (nearest.1[k] + reach).min(1.0)]
        });
    }
    least
}

fn places([low, high]: [f64; 2]) -> impl Iterator<Item = f64> {
    (0..=PLACES).map(move |k| low + (high - low) * f64::from(k) / f64::from(PLACES))
}

/// The corners of half of the head in a plane through its axis, from the axis to the axis.
fn corners(outline: &[[f64; 2]]) -> Vec<[f64; 2]> {
    [&[[0.0, 0.0]], outline, &[[outline[outline.len() - 1][0], 0.0]]].concat()
}

/// The distance of a point, seen from the tip, from the surface of the head, below 0 inside: in the plane through the axis.
fn distance(corners: &[[f64; 2]], axis: &Vector3<f64>, from_tip: &Vector3<f64>) -> f64 {
    let (z, rho) = (from_tip.dot(axis), from_tip.cross(axis).norm());
    let [mut beyond, mut apart] = [f64::NEG_INFINITY, f64::INFINITY];
    for ends in corners.windows(2) {
        let [[from_z, from_rho], [to_z, to_rho]] = [ends[0], ends[1]];
        let (up, out) = (to_z - from_z, to_rho - from_rho);
        let length = up.hypot(out);
        if length > 0.0 {
            let (dz, drho) = (z - from_z, rho - from_rho);
            beyond = beyond.max((drho * up - dz * out) / length);
            let part = ((dz * up + drho * out) / (length * length)).clamp(0.0, 1.0);
            apart = apart.min((dz - part * up).hypot(drho - part * out));
        }
    }
    if beyond < 0.0 { beyond } else { apart }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// FrameFab's head: a cone of 30° to each side of its axis, 20 mm high, then a cylinder.
    const HEAD: [[f64; 2]; 3] = [[0.0, 0.0], [20.0, 11.547], [120.0, 11.547]];

    fn assert_near(found: f64, wanted: f64) {
        assert!((found - wanted).abs() < 1e-4, "{found} instead of {wanted}");
    }

    #[test]
    fn a_point_is_as_far_from_the_head_as_from_its_nearest_face() {
        let head = corners(&HEAD);
        let of = |x: f64, z: f64| distance(&head, &Vector3::z(), &Vector3::new(x, 0.0, z));
        // Below the tip, beside the cylinder, over the top, and inside, where the axis of the cone is at half its height from its side.
        for (x, z, wanted) in [(3.0, -4.0, 5.0), (21.547, 70.0, 10.0), (0.0, 123.0, 3.0), (0.0, 10.0, -5.0)] {
            assert_near(of(x, z), wanted);
        }
        // A head with a flat end.
        let rod = corners(&[[0.0, 5.0], [50.0, 5.0]]);
        let flat = |z: f64| distance(&rod, &Vector3::z(), &Vector3::new(1.0, 0.0, z));
        assert_near(flat(-2.0), 2.0);
        assert_near(flat(1.0), -1.0);
    }

    /// The tip goes along x and passes under the end of a strut, 10 mm below it and 5 mm beside: there the cone is 5.77 mm wide.
    #[test]
    fn a_strut_is_met_in_the_middle_of_the_way_and_not_at_its_ends() {
        let strut = [Point3::new(61.3, 5.0, 10.0), Point3::new(61.3, 5.0, 0.0)];
        let ends = [Point3::origin(), Point3::new(120.0, 0.0, 0.0)];
        let on_the_way = nearest(&HEAD, &Vector3::z(), ends, strut, 0.0);
        assert_near(on_the_way, 5.0 * 30_f64.to_radians().cos() - 10.0 * 30_f64.to_radians().sin());
        for end in ends {
            assert!(nearest(&HEAD, &Vector3::z(), [end; 2], strut, 0.0) > 20.0);
        }
    }
}
