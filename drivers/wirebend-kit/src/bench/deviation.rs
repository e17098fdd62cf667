//! The wire that came out beside the one that was designed.

use nalgebra::{Matrix3, Rotation3, Vector3};

use super::made::Made;

/// A designed vertex that turns by less is no bend, where the wire has fewer. Degrees.
const NO_BEND_DEG: f64 = 0.01;
/// Corners that turn by more show the plane of their bend. Degrees.
const SHOWS_PLANE_DEG: f64 = 0.5;

/// How far a wire is from its design, vertex by vertex. Differences are bent minus designed.
#[derive(Debug, Clone, PartialEq)]
pub struct Deviations {
    /// Which of the designed vertices are compared: all but those on a straight, which have no bend.
    pub vertices: Vec<usize>,
    /// Distances with first vertex, first direction and plane of the first bend in place, as the wire looks when
    /// it is held by its start.
    pub from_start_mm: Vec<f64>,
    /// Distances after the best turn and shift, without mirroring (least squares, Kabsch 1976).
    pub fitted_mm: Vec<f64>,
    /// Of the angle at each vertex but the ends.
    pub angle_deg: Vec<f64>,
    /// Of the length of each edge.
    pub edge_mm: Vec<f64>,
}

impl Deviations {
    /// The largest distance with the start in place.
    #[must_use]
    pub fn worst_from_start_mm(&self) -> f64 {
        self.from_start_mm.iter().copied().fold(0.0, f64::max)
    }

    /// The largest distance after the best fit.
    #[must_use]
    pub fn worst_fitted_mm(&self) -> f64 {
        self.fitted_mm.iter().copied().fold(0.0, f64::max)
    }
}

/// Why a wire cannot be compared with a design.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum CompareError {
    /// The wire has more bends than the design, or fewer.
    #[error(
        "the design has {designed} vertices and the wire {made}; compare it with the path that its program was \
         made from, and see the incidents and doubts of the bench"
    )]
    Count {
        /// Vertices of the design, without those on a straight.
        designed: usize,
        /// Ends and bends of the wire.
        made: usize,
    },
    /// A designed vertex is not a place.
    #[error("vertex {vertex} of the design is not a finite place; correct it")]
    NotFinite { vertex: usize },
}

impl Made {
    /// Compares the corners of the wire with the vertices of a design in mm, which may lie anywhere in
    /// space. A vertex at which the design does not turn may be a corner of the wire or not.
    ///
    /// The plane of the first bend is that of the first corner at which both turn by more than half a
    /// degree; where there is none, the wire's twist about its first edge is not known and taken as fitting.
    ///
    /// # Errors
    /// [`CompareError`] where the wire has another number of bends, or the design a vertex nowhere.
    pub fn deviations(&self, design: &[[f64; 3]]) -> Result<Deviations, CompareError> {
        let is_nowhere = |place: &[f64; 3]| place.iter().any(|x| !x.is_finite());
        if let Some(vertex) = design.iter().position(is_nowhere) {
            return Err(CompareError::NotFinite { vertex });
        }
        let made: Vec<Vector3<f64>> = self.corners().into_iter().map(Into::into).collect();
        let all: Vec<Vector3<f64>> = design.iter().map(|&place| place.into()).collect();
        let mut vertices: Vec<usize> = (0..all.len()).collect();
        if all.len() != made.len() {
            let turns = turns_deg(&all);
            let is_end = |i: usize| i == 0 || i + 1 == all.len();
            vertices.retain(|&i| is_end(i) || turns[i - 1] > NO_BEND_DEG);
        }
        if vertices.len() != made.len() {
            return Err(CompareError::Count { designed: vertices.len(), made: made.len() });
        }
        let design: Vec<Vector3<f64>> = vertices.iter().map(|&i| all[i]).collect();
        let (wanted, turned) = (turns_deg(&design), turns_deg(&made));
        let edges = lengths(&made).zip(lengths(&design));
        Ok(Deviations {
            vertices,
            from_start_mm: distances(&design, &made, design[0], made[0], from_start(&design, &made)),
            fitted_mm: distances(&design, &made, middle(&design), middle(&made), best_turn(&design, &made)),
            angle_deg: turned.iter().zip(&wanted).map(|(turned, wanted)| turned - wanted).collect(),
            edge_mm: edges.map(|(made, designed)| made - designed).collect(),
        })
    }
}

/// Distances once the wire is turned about one of its points, which is laid on one of the design.
fn distances(
    design: &[Vector3<f64>],
    made: &[Vector3<f64>],
    design_about: Vector3<f64>,
    made_about: Vector3<f64>,
    turn: Rotation3<f64>,
) -> Vec<f64> {
    let placed = |point: &Vector3<f64>| design_about + turn * (point - made_about);
    design.iter().zip(made).map(|(wanted, point)| (placed(point) - wanted).norm()).collect()
}

fn lengths(points: &[Vector3<f64>]) -> impl Iterator<Item = f64> {
    points.windows(2).map(|pair| (pair[1] - pair[0]).norm())
}

/// The angle at each vertex but the ends, 0 to 180. Zero beside an edge of no length.
fn turns_deg(points: &[Vector3<f64>]) -> Vec<f64> {
    let turn = |three: &[Vector3<f64>]| {
        let (before, behind) = (three[1] - three[0], three[2] - three[1]);
        before.cross(&behind).norm().atan2(before.dot(&behind)).to_degrees()
    };
    points.windows(3).map(turn).collect()
}

fn middle(points: &[Vector3<f64>]) -> Vector3<f64> {
    // Both have two points at least.
    let count = points.iter().fold(0.0, |count, _| count + 1.0);
    points.iter().sum::<Vector3<f64>>() / count
}

/// The turn that lays the first edge and the first plane of the wire on those of the design.
fn from_start(design: &[Vector3<f64>], made: &[Vector3<f64>]) -> Rotation3<f64> {
    let shows = |turn: &f64| *turn > SHOWS_PLANE_DEG;
    let both = turns_deg(design).iter().zip(&turns_deg(made)).position(|(a, b)| shows(a) && shows(b));
    let frames = both.and_then(|corner| Some((frame(design, corner)?, frame(made, corner)?)));
    if let Some((design, made)) = frames {
        return design * made.inverse();
    }
    let edge = |points: &[Vector3<f64>]| points[1] - points[0];
    Rotation3::rotation_between(&edge(made), &edge(design))
        .unwrap_or_else(|| Rotation3::from_axis_angle(&any_normal(&edge(made)), std::f64::consts::PI))
}

/// Along the first edge, with the plane of a corner.
fn frame(points: &[Vector3<f64>], corner: usize) -> Option<Rotation3<f64>> {
    let t = (points[1] - points[0]).try_normalize(1e-9)?;
    let across = (points[corner + 1] - points[corner]).cross(&(points[corner + 2] - points[corner + 1]));
    let b = (across - t * across.dot(&t)).try_normalize(1e-9)?;
    Some(Rotation3::from_matrix_unchecked(Matrix3::from_columns(&[t, b.cross(&t), b])))
}

fn any_normal(edge: &Vector3<f64>) -> nalgebra::Unit<Vector3<f64>> {
    let least = if edge.x.abs() < edge.y.abs() { Vector3::x() } else { Vector3::y() };
    nalgebra::Unit::try_new(edge.cross(&least), 1e-12).unwrap_or_else(Vector3::z_axis)
}

/// The turn with the least sum of squared distances about the middles; no mirroring.
fn best_turn(design: &[Vector3<f64>], made: &[Vector3<f64>]) -> Rotation3<f64> {
    let (design_middle, made_middle) = (middle(design), middle(made));
    let pairs = design.iter().zip(made);
    let covariance: Matrix3<f64> =
        pairs.map(|(wanted, point)| (point - made_middle) * (wanted - design_middle).transpose()).sum();
    let parts = covariance.try_svd(true, true, f64::EPSILON, 1000);
    let Some((u, v)) = parts.and_then(|svd| Some((svd.u?, svd.v_t?.transpose()))) else {
        return from_start(design, made);
    };
    let handed = (v * u.transpose()).determinant().signum();
    let keep = Matrix3::from_diagonal(&Vector3::new(1.0, 1.0, handed));
    Rotation3::from_matrix_unchecked(v * keep * u.transpose())
}
