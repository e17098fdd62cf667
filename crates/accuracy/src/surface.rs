//! How far groups of points are from where they should be, after what a person would set right first: a plane for each face, or a
//! motion of the whole.
//!
//! Both are linear: displacements are small against the frame. What is set right is then a subspace, found once, and what is left of
//! any displacement is a projection. That gives sums over many errors as well as single wires.

use nalgebra::{DMatrix, Point3, Vector3};

/// A direction that adds less than this to those before it, in parts of its length, adds nothing.
const NOTHING_NEW: f64 = 1e-9;

/// Points, a way to measure each of them, and what is set right before that.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    parts: Vec<Part>,
}

/// What is measured of one face, or of the whole.
#[derive(Debug, Clone, PartialEq)]
struct Part {
    /// Indices of the points.
    points: Vec<usize>,
    /// What counts: the way along this direction, or every way.
    normal: Option<Vector3<f64>>,
    /// Orthonormal columns: what is set right.
    free: DMatrix<f64>,
}

impl Surface {
    /// Faces, each as indices of its points: displacements count across the plane that fits the points best, from the plane that fits
    /// the displaced ones best. A face of fewer than three points, or of points on one line, is left out.
    #[must_use]
    pub fn faces(points: &[Point3<f64>], faces: &[Vec<usize>]) -> Self {
        Self { parts: faces.iter().filter_map(|face| Part::face(points, face)).collect() }
    }

    /// These points together: displacements count in every direction, after the motion of the whole that fits them best.
    #[must_use]
    pub fn whole(points: &[Point3<f64>], those: &[usize]) -> Self {
        Self { parts: vec![Part::whole(points, those)] }
    }

    /// How many faces have a plane; one of the whole.
    #[must_use]
    pub fn face_count(&self) -> usize {
        self.parts.len()
    }

    /// The mean over the faces of the RMS of what is left, mm; of the whole its RMS. Zero where there is nothing to measure.
    #[must_use]
    pub fn rms(&self, displacements: &[Vector3<f64>]) -> f64 {
        let each = self.parts.iter().map(|part| part.mean_square(displacements).sqrt());
        mean(each, self.parts.len())
    }

    /// For each face the mean of the squares of what is left, mm².
    pub fn mean_squares(&self, displacements: &[Vector3<f64>]) -> impl Iterator<Item = f64> {
        self.parts.iter().map(|part| part.mean_square(displacements))
    }

    /// Displacements without what is set right, mm; of points that are not measured nothing. Of faces only what is across them is left.
    #[must_use]
    pub fn remainder(&self, displacements: &[Vector3<f64>]) -> Vec<Vector3<f64>> {
        let mut remainder = vec![Vector3::zeros(); displacements.len()];
        for part in &self.parts {
            let left = part.left(displacements);
            let width = part.normal.map_or(3, |_| 1);
            for (&point, of) in part.points.iter().zip(left.chunks(width)) {
                let way = part.normal.map_or_else(|| Vector3::from_column_slice(of), |normal| normal * of[0]);
                if let Some(at) = remainder.get_mut(point) {
                    *at += way;
                }
            }
        }
        remainder
    }

    /// What is left at each point that is measured, in the order of the faces, mm: the distance from where it should be.
    #[must_use]
    pub fn distances(&self, displacements: &[Vector3<f64>]) -> Vec<f64> {
        self.parts.iter().flat_map(|part| part.distances(displacements)).collect()
    }
}

impl Part {
    fn face(points: &[Point3<f64>], face: &[usize]) -> Option<Self> {
        let at: Vec<Point3<f64>> = face.iter().filter_map(|&k| points.get(k).copied()).collect();
        let centre = centre(&at)?;
        let spread: DMatrix<f64> = DMatrix::from_fn(3, at.len(), |row, column| (at[column] - centre)[row]);
        let svd = spread.svd(true, false);
        let (ways, sizes) = (svd.u?, svd.singular_values);
        let [across, second, first] = order(sizes.as_slice())?;
        if sizes[second] <= NOTHING_NEW * sizes[first] {
            return None;
        }
        let way = |k: usize| Vector3::new(ways[(0, k)], ways[(1, k)], ways[(2, k)]);
        let columns = [
            vec![1.0; at.len()],
            at.iter().map(|p| (p - centre).dot(&way(first))).collect(),
            at.iter().map(|p| (p - centre).dot(&way(second))).collect(),
        ];
        Some(Self { points: face.to_vec(), normal: Some(way(across)), free: orthonormal(at.len(), &columns) })
    }

    fn whole(points: &[Point3<f64>], those: &[usize]) -> Self {
        let points: Vec<Point3<f64>> = those.iter().filter_map(|&k| points.get(k).copied()).collect();
        let centre = centre(&points).unwrap_or_else(Point3::origin);
        let along = (0..3).map(|axis| {
            let way: Vector3<f64> = Vector3::ith(axis, 1.0);
            points.iter().flat_map(|_| [way.x, way.y, way.z]).collect::<Vec<f64>>()
        });
        let about = (0..3).map(|axis| {
            let axis: Vector3<f64> = Vector3::ith(axis, 1.0);
            let turned = points.iter().map(|p| axis.cross(&(p - centre)));
            turned.flat_map(|way| [way.x, way.y, way.z]).collect::<Vec<f64>>()
        });
        let columns: Vec<Vec<f64>> = along.chain(about).collect();
        let free = orthonormal(3 * points.len(), &columns);
        Self { points: those.to_vec(), normal: None, free }
    }

    /// What is left of the displacements: a figure for each point of a face, three for each point of the whole.
    fn left(&self, displacements: &[Vector3<f64>]) -> Vec<f64> {
        let moved = self.points.iter().map(|&k| displacements.get(k).copied().unwrap_or_default());
        let mut left: Vec<f64> = match self.normal {
            Some(normal) => moved.map(|way| way.dot(&normal)).collect(),
            None => moved.flat_map(|way| [way.x, way.y, way.z]).collect(),
        };
        for column in self.free.column_iter() {
            let share: f64 = column.iter().zip(&left).map(|(a, b)| a * b).sum();
            for (left, way) in left.iter_mut().zip(&column) {
                *left -= share * way;
            }
        }
        left
    }

    fn distances(&self, displacements: &[Vector3<f64>]) -> Vec<f64> {
        let left = self.left(displacements);
        let width = left.len() / self.points.len().max(1);
        left.chunks(width.max(1)).map(|of| of.iter().map(|x| x * x).sum::<f64>().sqrt()).collect()
    }

    fn mean_square(&self, displacements: &[Vector3<f64>]) -> f64 {
        mean(self.left(displacements).iter().map(|x| x * x), self.points.len())
    }
}

#[allow(clippy::cast_precision_loss)] // points are far fewer than 2^52
fn mean(values: impl Iterator<Item = f64>, count: usize) -> f64 {
    values.sum::<f64>() / count.max(1) as f64
}

fn centre(points: &[Point3<f64>]) -> Option<Point3<f64>> {
    let axis = |axis: usize| mean(points.iter().map(|p| p[axis]), points.len());
    (!points.is_empty()).then(|| Point3::new(axis(0), axis(1), axis(2)))
}

/// The places of three figures, the least foremost; `None` where there are not three.
fn order(sizes: &[f64]) -> Option<[usize; 3]> {
    let mut places: Vec<usize> = (0..sizes.len()).collect();
    places.sort_by(|&a, &b| sizes[a].total_cmp(&sizes[b]));
    places.try_into().ok()
}

/// Columns of length one across each other that span the same as those given.
fn orthonormal(rows: usize, columns: &[Vec<f64>]) -> DMatrix<f64> {
    let mut kept: Vec<Vec<f64>> = Vec::new();
    for column in columns {
        let size = column.iter().map(|x| x * x).sum::<f64>().sqrt();
        let mut left = column.clone();
        // Twice is enough: what rounding leaves the first time is gone.
        for _ in 0..2 {
            for before in &kept {
                let share: f64 = before.iter().zip(&left).map(|(a, b)| a * b).sum();
                left.iter_mut().zip(before).for_each(|(left, before)| *left -= share * before);
            }
        }
        let rest = left.iter().map(|x| x * x).sum::<f64>().sqrt();
        if rest > NOTHING_NEW * size {
            for x in &mut left {
                *x /= rest;
            }
            kept.push(left);
        }
    }
    DMatrix::from_fn(rows, kept.len(), |row, column| kept[column][row])
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn square() -> Vec<Point3<f64>> {
        [[0.0, 0.0], [10.0, 0.0], [10.0, 10.0], [0.0, 10.0]].map(|[x, y]| Point3::new(x, y, 3.0)).to_vec()
    }

    /// Lifted by 1 mm at two opposite corners, a square stays half a millimetre off its best plane: (1, 0, 1, 0) less the mean.
    #[test]
    fn a_twisted_square_is_off_its_plane_by_half_the_lift() {
        let faces = Surface::faces(&square(), &[vec![0, 1, 2, 3]]);
        let lifted = [1.0, 0.0, 1.0, 0.0].map(|z| Vector3::new(0.0, 0.0, z));
        assert!((faces.rms(&lifted) - 0.5).abs() < 1e-12);
        let slid = [1.0, -2.0, 3.0, 0.5].map(|x| Vector3::new(x, 2.0 * x, 0.0));
        assert!(faces.rms(&slid) < 1e-12, "ways within the plane do not count");
    }

    #[test]
    fn two_faces_count_as_their_mean() {
        let points: Vec<_> = square().into_iter().chain(square()).collect();
        let faces = Surface::faces(&points, &[vec![0, 1, 2, 3], vec![4, 5, 6, 7]]);
        let lifts = [1.0, 0.0, 1.0, 0.0, 3.0, 0.0, 3.0, 0.0];
        let lifted: Vec<_> = lifts.iter().map(|&z| Vector3::new(0.0, 0.0, z)).collect();
        assert!((faces.rms(&lifted) - 1.0).abs() < 1e-12);
        assert!(faces.distances(&lifted)[4..].iter().all(|off| (off - 1.5).abs() < 1e-12));
    }

    #[test]
    fn a_face_on_one_line_is_no_face() {
        let line: Vec<_> = (0..4).map(|k| Point3::new(f64::from(k), 0.0, 0.0)).collect();
        let faces = Surface::faces(&line, &[vec![0, 1, 2, 3], vec![0, 1]]);
        assert!(faces.rms(&[Vector3::z(); 4]).abs() < 1e-12);
        assert!(faces.distances(&[Vector3::z(); 4]).is_empty());
        assert_eq!(faces.face_count(), 0);
        assert_eq!(Surface::faces(&square(), &[vec![0, 1, 2, 3]]).face_count(), 1);
    }

    proptest! {
        /// Whatever holds a frame in place turns and shifts it as a whole; no figure may depend on that.
        #[test]
        fn a_motion_of_the_whole_is_no_error(shift in prop::array::uniform3(-2.0..2.0_f64), turn in prop::array::uniform3(-0.01..0.01_f64)) {
            let mut points = square();
            points.push(Point3::new(2.0, 3.0, -7.0));
            let (shift, turn) = (Vector3::from(shift), Vector3::from(turn));
            let moved: Vec<_> = points.iter().map(|p| shift + turn.cross(&p.coords)).collect();
            prop_assert!(Surface::whole(&points, &[0, 1, 2, 3, 4]).rms(&moved) < 1e-10);
            prop_assert!(Surface::faces(&points, &[vec![0, 1, 2, 3]]).rms(&moved) < 1e-10);
        }
    }
}
