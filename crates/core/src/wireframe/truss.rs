//! Tetrahedral trusses: two layers of a triangular lattice joined by diagonals, as Bend-Forming makes them from one wire.
//!
//! A lattice point has whole coordinates (a, b, c) along three directions 120° apart. In the top layer a + b + c = 1, so that the
//! three points nearest to the axis form a triangle; N rings are the points with all of them in [-N, N + 1]. The bottom layer is
//! the top one turned by 180° about the axis, a depth H below.

use std::ops::RangeInclusive;

use nalgebra::Point3;

use super::graph::{Vertex, VertexId, Wireframe, WireframeError};
use crate::units::Length;

/// Most rings of a truss: 60,000 vertices and 270,000 struts. The largest that was ever proposed has about 500.
pub const MAX_RINGS: u32 = 100;

/// Whole coordinates in the top layer's sense.
type Lattice = [i32; 3];

/// Why there is no such truss.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum TrussError {
    /// Too many rings.
    #[error("{0} rings; a truss has at most {MAX_RINGS}")]
    Rings(u32),
    /// A strut without length.
    #[error("struts of {0}; they are longer than 0")]
    Strut(Length),
    /// No depth.
    #[error("a depth of {0}; it is more than 0")]
    Depth(Length),
    /// Larger than any wireframe.
    #[error(transparent)]
    Wireframe(#[from] WireframeError),
}

/// The depth at which the diagonals are as long as the struts of the faces: that of regular tetrahedra, strut·√(2/3).
#[must_use]
pub fn regular_depth(strut: Length) -> Length {
    Length::computed(strut.mm() * (2.0_f64 / 3.0).sqrt())
}

/// The struts of the faces that are as long as the diagonals at this depth: those of regular tetrahedra, depth·√(3/2).
#[must_use]
pub fn regular_strut(depth: Length) -> Length {
    Length::computed(depth.mm() * 1.5_f64.sqrt())
}

/// A truss with `rings` around its middle triangle (none: an octahedron), whose faces have struts of length `strut`, `depth`
/// apart; the bottom face lies in z = 0, the middle on the z axis. 6(N + 1)² vertices, 27N² + 39N + 12 struts; (2N + 1) struts across.
///
/// Top vertices come first, then those of the bottom in the same order; edges rise by their vertices.
///
/// ```
/// use wirebend_core::{units::Length, wireframe::{regular_depth, tetrahedral_truss}};
/// let strut = Length::from_mm(100.0)?;
/// let truss = tetrahedral_truss(3, strut, regular_depth(strut))?;
/// assert_eq!((truss.vertex_count(), truss.edge_count()), (96, 372));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`TrussError`].
pub fn tetrahedral_truss(rings: u32, strut: Length, depth: Length) -> Result<Wireframe, TrussError> {
    if rings > MAX_RINGS {
        return Err(TrussError::Rings(rings));
    }
    if strut <= Length::ZERO {
        return Err(TrussError::Strut(strut));
    }
    if depth <= Length::ZERO {
        return Err(TrussError::Depth(depth));
    }
    let layer = Layer::new(rings);
    let mut truss = Wireframe::new();
    for (side, z) in [(1.0, depth.mm()), (-1.0, 0.0)] {
        for &at in &layer.points {
            truss.add_vertex(Vertex::at(position(at, strut.mm(), side, z)))?;
        }
    }
    let count = u32::try_from(layer.points.len()).unwrap_or(u32::MAX);
    for (i, &at) in (0..).zip(&layer.points) {
        // The first half of a ring of neighbours: the other half has this point as theirs.
        for j in layer.neighbours(at).filter(|j| *j > i) {
            truss.add_edge(VertexId(i), VertexId(j))?;
        }
        for j in layer.below(at) {
            truss.add_edge(VertexId(i), VertexId(count + j))?;
        }
    }
    for (i, &at) in (0..).zip(&layer.points) {
        for j in layer.neighbours(at).filter(|j| *j > i) {
            truss.add_edge(VertexId(count + i), VertexId(count + j))?;
        }
    }
    Ok(truss)
}

/// The points of a layer, in the order of their coordinates.
struct Layer {
    range: RangeInclusive<i32>,
    points: Vec<Lattice>,
}

impl Layer {
    fn new(rings: u32) -> Self {
        let rings = i32::try_from(rings).unwrap_or(i32::MAX - 1);
        let range = -rings..=rings + 1;
        let pairs = range.clone().flat_map(|a| range.clone().map(move |b| [a, b, 1 - a - b]));
        let points = pairs.filter(|[_, _, c]| range.contains(c)).collect();
        Self { range, points }
    }

    /// The place of a point; none outside of the layer.
    fn place(&self, at: Lattice) -> Option<u32> {
        let inside = at.iter().all(|part| self.range.contains(part));
        let place = inside.then(|| self.points.binary_search(&at).ok()).flatten()?;
        u32::try_from(place).ok()
    }

    /// Points of the same layer one strut away, rising.
    fn neighbours(&self, [a, b, c]: Lattice) -> impl Iterator<Item = u32> {
        let around = [[-1, 0, 1], [-1, 1, 0], [0, -1, 1], [0, 1, -1], [1, -1, 0], [1, 0, -1]];
        around.into_iter().filter_map(move |[da, db, dc]| self.place([a + da, b + db, c + dc]))
    }

    /// Points of the turned layer that a diagonal leads to, rising: top plus bottom is one lattice step.
    fn below(&self, [a, b, c]: Lattice) -> impl Iterator<Item = u32> {
        let steps = [[0, 1, 1], [1, 0, 1], [1, 1, 0]];
        steps.into_iter().filter_map(move |[sa, sb, sc]| self.place([sa - a, sb - b, sc - c]))
    }
}

/// `side` is 1 in the top layer and -1 in the bottom one.
fn position(at: Lattice, strut_mm: f64, side: f64, z_mm: f64) -> Point3<f64> {
    let [a, b, c] = at.map(f64::from);
    let x = strut_mm / 2.0 * (c - b);
    let y = strut_mm / 3.0_f64.sqrt() * (a - f64::midpoint(b, c));
    Point3::new(side * x, side * y, z_mm)
}
