//! The smallest frames that show one difficulty each: straight joints, a strut travelled twice, two components,
//! mirror images.

use super::{Example, Point};

pub(super) fn all() -> Vec<Example> {
    vec![
        collinear(),
        fold_back(),
        two_parts(),
        chiral("mirror-left.obj", 1.0),
        chiral("mirror-right.obj", -1.0),
    ]
}

fn collinear() -> Example {
    Example::wire(
        "collinear.obj",
        &[
            "Chain with straight joints before each bend: x, then y, then z, then -x.",
            "Five feeds end without a bend; each of the three bends is in another plane than the one before.",
        ],
        vec![
            [0.0, 0.0, 0.0],
            [30.0, 0.0, 0.0],
            [60.0, 0.0, 0.0],
            [90.0, 0.0, 0.0],
            [90.0, 40.0, 0.0],
            [90.0, 80.0, 0.0],
            [90.0, 120.0, 0.0],
            [90.0, 120.0, 35.0],
            [90.0, 120.0, 70.0],
            [50.0, 120.0, 70.0],
        ],
    )
}

fn fold_back() -> Example {
    Example::frame(
        "fold-back.obj",
        &[
            "T: two arms of 40 mm and a leaf of 30 mm at one vertex. Four odd vertices: the leaf is the cheapest strut to double,",
            "so the wire goes there and folds back by 180 degrees.",
        ],
        vec![[0.0, 0.0, 0.0], [-40.0, 0.0, 0.0], [40.0, 0.0, 0.0], [0.0, -30.0, 0.0]],
        vec![vec![1, 0, 2], vec![0, 3]],
    )
}

fn two_parts() -> Example {
    Example::frame(
        "two-parts.obj",
        &["Two components, so two wires: a square of 40 mm and, 100 mm away, a Z of three edges."],
        vec![
            [0.0, 0.0, 0.0],
            [40.0, 0.0, 0.0],
            [40.0, 40.0, 0.0],
            [0.0, 40.0, 0.0],
            [140.0, 0.0, 0.0],
            [180.0, 0.0, 0.0],
            [140.0, 40.0, 0.0],
            [180.0, 40.0, 0.0],
        ],
        vec![vec![0, 1, 2, 3, 0], vec![4, 5, 6, 7]],
    )
}

/// `side` 1 or -1: the sign of z, so that the two files are mirror images in the plane z = 0.
fn chiral(file: &str, side: f64) -> Example {
    let points: [Point; 6] = [
        [0.0, 0.0, 0.0],
        [50.0, 0.0, 0.0],
        [50.0, 40.0, 0.0],
        [80.0, 40.0, side * 40.0],
        [95.0, 85.0, side * 40.0],
        [45.0, 85.0, side * 75.0],
    ];
    Example::wire(
        file,
        &[
            "One of two mirror images in the plane z = 0 (mirror-left.obj, mirror-right.obj): same feeds, same angles, opposite rotations.",
        ],
        points.to_vec(),
    )
}

#[cfg(test)]
mod tests {
    use super::super::measure::{edge_lengths, handedness, odd_vertices, turns};
    use super::*;

    #[test]
    fn mirror_images_differ_in_handedness_only() {
        let (left, right) = (chiral("left", 1.0), chiral("right", -1.0));
        assert_eq!(edge_lengths(&left), edge_lengths(&right));
        assert_eq!(turns(&left), turns(&right));
        for (l, r) in left.points.windows(4).zip(right.points.windows(4)) {
            assert!(handedness(l).abs() > 1.0, "four points in one plane have no handedness");
            assert!((handedness(l) + handedness(r)).abs() < 1e-9, "not a mirror image");
        }
    }

    #[test]
    fn collinear_has_five_straight_joints_and_three_bends() {
        let turns = turns(&collinear());
        assert_eq!(turns.iter().filter(|deg| **deg < 1e-9).count(), 5);
        assert_eq!(turns.iter().filter(|deg| (**deg - 90.0).abs() < 1e-9).count(), 3);
    }

    #[test]
    fn fold_back_cannot_be_one_wire_without_doubling() {
        assert_eq!(odd_vertices(&fold_back()), 4);
    }
}
