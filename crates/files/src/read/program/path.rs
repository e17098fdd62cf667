//! The wireframe that a wire makes.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::{Point3, Vector3};
use wirebend_core::units::Length;
use wirebend_core::wireframe::{
    Vertex, VertexId, Welder, Wireframe, WireframeError, crossings, points_passed,
};

/// The wireframe that a path makes.
#[derive(Debug, Clone, PartialEq)]
pub struct PathWireframe {
    pub wireframe: Wireframe,
    /// The path as its vertices, without repeats in a row.
    pub traversal: Vec<VertexId>,
    /// How many of its vertices are points of the path; the others are where it crosses itself.
    pub corners: usize,
}

/// The wireframe that a path (mm) makes.
///
/// A point within `weld` of a vertex that is there already is that vertex, so a path that comes
/// back to a node gives one vertex, and two passes along a strut one edge. A straight that passes
/// within `weld` of a vertex, or crosses another there, goes through it: programs have one feed
/// for both of its parts. Vertices are in the order of their first visit, from 0; crossings at
/// which the path never turns come last.
///
/// # Errors
/// The index of the first point that is NaN, infinite or beyond a kilometre.
pub fn wireframe_of_path(
    path: &[Point3<f64>],
    weld: Length,
) -> Result<PathWireframe, (usize, WireframeError)> {
    let mut corners =
        Corners { welder: Welder::new(weld), wireframe: Wireframe::new(), positions: Vec::new() };
    let mut turns: Vec<usize> = Vec::new();
    for (k, point) in path.iter().enumerate() {
        let corner = corners.put(*point).map_err(|error| (k, error))?;
        if turns.last() != Some(&corner) {
            turns.push(corner);
        }
    }
    let mut straights: Vec<[usize; 2]> = turns.windows(2).map(|pair| ordered([pair[0], pair[1]])).collect();
    straights.sort_unstable();
    straights.dedup();
    let pieces: Vec<_> = straights.iter().map(|ends| ends.map(|end| corners.positions[end])).collect();
    let (turned, last) = (corners.positions.len(), path.len().saturating_sub(1));
    for crossing in crossings(&pieces, weld) {
        corners.put(crossing).map_err(|error| (last, error))?;
    }
    let mut passed = points_passed(&pieces, &corners.positions, weld);
    for (through, ends) in passed.iter_mut().zip(&straights) {
        through.retain(|corner| !ends.contains(corner));
    }
    straighten(&mut corners.positions, (&straights, &passed), weld);

    let id = |corner: usize| VertexId(u32::try_from(corner).unwrap_or(u32::MAX));
    let mut wireframe = Wireframe::new();
    for position in &corners.positions {
        wireframe.add_vertex(Vertex::at(*position)).map_err(|error| (last, error))?;
    }
    let mut traversal: Vec<VertexId> = turns.first().copied().map(id).into_iter().collect();
    let mut joined = BTreeSet::new();
    for (k, pair) in turns.windows(2).enumerate() {
        let ends = ordered([pair[0], pair[1]]);
        let mut through = straights.binary_search(&ends).map_or_else(|_| Vec::new(), |at| passed[at].clone());
        if ends[0] != pair[0] {
            through.reverse();
        }
        for corner in through.into_iter().chain([pair[1]]) {
            let (before, next) = (traversal.last().copied().unwrap_or(id(corner)), id(corner));
            if joined.insert((before.min(next), before.max(next))) {
                wireframe.add_edge(before, next).map_err(|error| (k + 1, error))?;
            }
            traversal.push(next);
        }
    }
    Ok(PathWireframe { wireframe, traversal, corners: turned })
}

/// So often vertices are moved: each time about half of what they are off is left, where two straights pass one.
const ROUNDS: usize = 30;

/// Moves vertices onto the straights that pass them: otherwise rounded figures make slight bends of these. None is moved by more than
/// `weld`. `straights`: by their ends; `passed`: what each of them passes.
fn straighten(
    positions: &mut [Point3<f64>],
    (straights, passed): (&[[usize; 2]], &[Vec<usize>]),
    weld: Length,
) {
    let meant = positions.to_vec();
    for _ in 0..ROUNDS {
        let mut moves: BTreeMap<usize, (Vector3<f64>, f64)> = BTreeMap::new();
        for (ends, through) in straights.iter().zip(passed) {
            let [from, to] = ends.map(|end| positions[end]);
            let way = (to - from).normalize();
            for &corner in through {
                let off = positions[corner] - from;
                let (sum, count) = moves.entry(corner).or_default();
                (*sum, *count) = (*sum + way * way.dot(&off) - off, *count + 1.0);
            }
        }
        for (corner, (sum, count)) in moves {
            let to = positions[corner] + sum / count;
            if (to - meant[corner]).norm() <= weld.mm() {
                positions[corner] = to;
            }
        }
    }
}

struct Corners {
    welder: Welder,
    wireframe: Wireframe,
    positions: Vec<Point3<f64>>,
}

impl Corners {
    /// The vertex at a point, by its number.
    fn put(&mut self, point: Point3<f64>) -> Result<usize, WireframeError> {
        let next = self.positions.len();
        let corner = self.welder.put(u32::try_from(next).unwrap_or(u32::MAX), point) as usize;
        if corner == next {
            self.wireframe.add_vertex(Vertex::at(point))?;
            self.positions.push(point);
        }
        Ok(corner)
    }
}

fn ordered([one, other]: [usize; 2]) -> [usize; 2] {
    [one.min(other), one.max(other)]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(points: &[[f64; 2]]) -> (Wireframe, Vec<u32>) {
        let path: Vec<Point3<f64>> = points.iter().map(|[x, y]| Point3::new(*x, *y, 0.0)).collect();
        let PathWireframe { wireframe, traversal, .. } =
            wireframe_of_path(&path, Length::from_mm(1e-3).unwrap()).unwrap();
        (wireframe, traversal.iter().map(|id| id.0).collect())
    }

    /// Out along one feed of 20 mm, and back over its middle: the strut ends where another pass turns.
    #[test]
    fn a_straight_goes_through_the_corners_of_other_passes() {
        let (wireframe, traversal) = of(&[[0., 0.], [20., 0.], [20., 10.], [10., 0.], [0., 0.]]);
        assert_eq!((wireframe.vertex_count(), wireframe.edge_count()), (4, 4));
        assert_eq!(traversal, [0, 3, 1, 2, 3, 0]);
        // The other way along it too.
        let (_, traversal) = of(&[[20., 0.], [0., 0.], [0., 10.], [10., 0.], [10., 5.]]);
        assert_eq!(traversal, [0, 3, 1, 2, 3, 4]);
    }

    /// Rounded by 0.01 mm, the wire passes its corner as straight as it is.
    #[test]
    fn a_corner_lies_on_the_straight_that_passes_it() {
        let path = [[0., 0., 0.], [20., 0., 0.], [20., 10., 0.], [10., 0.01, 0.], [0., 10., 0.]];
        let weld = Length::from_mm(0.02).unwrap();
        let found = wireframe_of_path(&path.map(Point3::from), weld).unwrap();
        assert_eq!(found.traversal.iter().map(|id| id.0).collect::<Vec<_>>(), [0, 3, 1, 2, 3, 4]);
        let corner = found.wireframe.vertex(VertexId(3)).unwrap().position;
        assert!((corner - Point3::new(10.0, 0.0, 0.0)).norm() < 1e-9, "{corner}");
    }

    /// A node of four struts through which the wire goes straight both times.
    #[test]
    fn straights_that_cross_meet() {
        let (wireframe, traversal) = of(&[[0., 0.], [20., 0.], [20., 10.], [10., 10.], [10., -10.]]);
        assert_eq!((wireframe.vertex_count(), wireframe.edge_count()), (6, 6));
        assert_eq!(traversal, [0, 5, 1, 2, 3, 5, 4]);
        // Beside each other they do not.
        let path = [[0., 0., 0.], [20., 0., 0.], [20., 10., 0.01], [10., 10., 0.01], [10., -10., 0.01]];
        let beside = wireframe_of_path(&path.map(Point3::from), Length::from_mm(1e-3).unwrap()).unwrap();
        assert_eq!((beside.wireframe.vertex_count(), beside.wireframe.edge_count()), (5, 4));
        assert_eq!(beside.corners, 5);
    }
}
