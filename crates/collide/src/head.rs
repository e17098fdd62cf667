//! A tool head, convex and round about its axis, that is carried along a line, against a straight piece.

use nalgebra::{Point3, UnitVector3, Vector3};

use crate::DirectionSet;

/// A convex solid of revolution. Its tip is the origin; it stands on its tip along its axis, and reaches up to its height.
#[derive(Debug, Clone, PartialEq)]
pub struct Head {
    /// The lines of its outline as half planes: outside of each its value is the distance from it.
    faces: Vec<Face>,
    /// The farthest of it from the tip.
    reach: f64,
    outline: Vec<[f64; 2]>,
}

/// A line of the outline: `across · ρ + along · z - offset` is above 0 outside, ρ the distance from the axis.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Face {
    across: f64,
    along: f64,
    offset: f64,
}

/// Why an outline is none of a head.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum HeadError {
    /// Two points are the least.
    #[error("the outline has {0} points, and a solid needs 2 at least")]
    TooFew(usize),
    /// It begins elsewhere.
    #[error("the outline begins at z {0}, and the tip is at 0")]
    Tip(f64),
    /// A figure is not finite, a radius is negative, or a point is not above the one before.
    #[error(
        "point {0} of the outline is not above the one before it with a radius from 0, both finite, and at least one radius above 0"
    )]
    Point(usize),
    /// The solid is hollowed out there.
    #[error("the outline is bent inwards at point {0}, and a head is convex")]
    Hollow(usize),
}

/// A piece, a motion and how they are told apart.
#[derive(Debug, Clone, Copy)]
pub struct Passage<'a> {
    /// The way of the tip: from where to where.
    pub motion: [&'a Point3<f64>; 2],
    /// The ends of the piece.
    pub piece: [&'a Point3<f64>; 2],
    /// It is met where it comes nearer to the head's surface than this, mm; below 0: where it is deeper inside.
    pub limit: f64,
    /// How much more than that may be missed, mm, above 0.
    pub tolerance: f64,
}

/// A part of the motion and a part of the piece, by their middles and halves, and the directions that are still open there.
struct Cell {
    middle: [f64; 2],
    half: [f64; 2],
    open: DirectionSet,
}

impl Head {
    /// A head by its outline from the tip upwards: `[z, radius]` of each corner, mm.
    ///
    /// ```
    /// use wirebend_collide::Head;
    /// // A cone of 30° to each side of its axis, 20 mm high, then a rod.
    /// let head = Head::new(&[[0.0, 0.0], [20.0, 11.547], [100.0, 11.547]])?;
    /// assert!(Head::new(&[[0.0, 5.0], [20.0, 3.0], [30.0, 5.0]]).is_err());
    /// # Ok::<(), wirebend_collide::HeadError>(())
    /// ```
    ///
    /// # Errors
    /// [`HeadError`] where this is not the outline of a convex solid that begins at its tip.
    pub fn new(outline: &[[f64; 2]]) -> Result<Self, HeadError> {
        let [first, .., top] = outline else { return Err(HeadError::TooFew(outline.len())) };
        if first[0] != 0.0 {
            return Err(HeadError::Tip(first[0]));
        }
        let mut faces = vec![
            Face { across: 0.0, along: -1.0, offset: 0.0 },
            Face { across: 0.0, along: 1.0, offset: top[0] },
        ];
        for (k, &[z, r]) in outline.iter().enumerate() {
            let rises = k.checked_sub(1).is_none_or(|before| z > outline[before][0]);
            if !(z.is_finite() && r.is_finite() && r >= 0.0 && rises) {
                return Err(HeadError::Point(k));
            }
        }
        if outline.iter().all(|&[_, r]| r <= 0.0) {
            return Err(HeadError::Point(outline.len() - 1));
        }
        let mut last = f64::INFINITY;
        for (k, ends) in outline.windows(2).enumerate() {
            let [[low, from], [high, to]] = [ends[0], ends[1]];
            let slope = (to - from) / (high - low);
            // Rounded figures of one straight line are no hollow.
            if slope > last + 1e-6 {
                return Err(HeadError::Hollow(k));
            }
            last = slope;
            let (across, along) = (1.0 / slope.hypot(1.0), -slope / slope.hypot(1.0));
            faces.push(Face { across, along, offset: across * from + along * low });
        }
        let reach = outline.iter().map(|&[z, r]| z.hypot(r)).fold(0.0, f64::max);
        Ok(Self { faces, reach, outline: outline.to_vec() })
    }

    /// Its outline from the tip upwards: `[z, radius]` of each corner, mm.
    #[must_use]
    pub fn outline(&self) -> &[[f64; 2]] {
        &self.outline
    }

    /// No point of it is farther than this from its tip, mm.
    #[must_use]
    pub const fn reach(&self) -> f64 {
        self.reach
    }

    /// A bound below the signed distance of a point, seen from the tip, from the head that stands along `axis`; inside the head it is
    /// exact. A convex function that changes by no more than the point moves.
    #[must_use]
    pub fn min_distance(&self, from_tip: &Vector3<f64>, axis: &UnitVector3<f64>) -> f64 {
        let z = from_tip.dot(axis);
        let rho = (from_tip.norm_squared() - z * z).max(0.0).sqrt();
        self.faces.iter().map(|face| face.at(rho, z)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// In which of the directions `asked` a head meets the piece while it is carried along the motion, its axis in that direction all the
    /// time. In the other directions no point of the piece is ever deeper than `tolerance` below the limit.
    ///
    /// The square of the parts of motion and piece is halved, each time the way along which the bound falls more, until each direction is
    /// decided. The bound below the distance is convex, and so no less than its tangent plane in the middle of a cell.
    #[must_use]
    pub fn meets(
        &self,
        passage: &Passage<'_>,
        directions: &[UnitVector3<f64>],
        asked: DirectionSet,
    ) -> DirectionSet {
        let [from, to] = passage.motion;
        let [begin, end] = passage.piece;
        let (way, along) = (to - from, end - begin);
        let (way_length, along_length) = (way.norm(), along.norm());
        let mut met = DirectionSet::default();
        let mut rises = Vec::new();
        let mut cells = Vec::with_capacity(64);
        cells.push(Cell { middle: [0.5; 2], half: [0.5; 2], open: asked });
        while let Some(Cell { middle, half, open }) = cells.pop() {
            let open = open.without(met);
            if open.is_empty() {
                continue;
            }
            let at = (begin - from) + along * middle[1] - way * middle[0];
            let spread = half[0] * way_length + half[1] * along_length;
            let squared = at.norm_squared();
            let near = (self.reach + spread + passage.limit).max(0.0);
            if squared >= near * near {
                continue;
            }
            let seen = Seen { squared, way: at.dot(&way), along: at.dot(&along) };
            if rises.is_empty() {
                rises = rises_along(directions, asked, [&(begin - from), &way, &along]);
            }
            let mut left = DirectionSet::default();
            let mut falls = [0.0; 2];
            for index in open.iter() {
                let Some(&[begins, up_way, up_along]) = rises.get(index) else { continue };
                let z = begins + up_along * middle[1] - up_way * middle[0];
                let rho = (seen.squared - z * z).max(0.0).sqrt();
                let (distance, face) = self.nearest(rho, z);
                if distance < passage.limit {
                    met.insert(index);
                } else if distance - spread < passage.limit {
                    let slopes = face.slopes(&seen, rho, z, [up_way, up_along]);
                    let fall = [0, 1].map(|k| half[k] * slopes[k].abs());
                    let most = fall[0] + fall[1];
                    if distance - most < passage.limit && most >= passage.tolerance {
                        left.insert(index);
                        falls = [falls[0] + fall[0], falls[1] + fall[1]];
                    }
                }
            }
            if left.is_empty() {
                continue;
            }
            let k = usize::from(falls[0] < falls[1]);
            for side in [-0.5, 0.5] {
                let (mut middle, mut halved) = (middle, half);
                middle[k] += side * half[k];
                halved[k] *= 0.5;
                cells.push(Cell { middle, half: halved, open: left });
            }
        }
        met
    }

    /// The bound at a point, and the face that gives it.
    fn nearest(&self, rho: f64, z: f64) -> (f64, &Face) {
        let (mut best, mut distance) = (&self.faces[0], f64::NEG_INFINITY);
        for face in &self.faces {
            let value = face.at(rho, z);
            if value > distance {
                (best, distance) = (face, value);
            }
        }
        (distance, best)
    }
}

impl Face {
    fn at(&self, rho: f64, z: f64) -> f64 {
        self.across * rho + self.along * z - self.offset
    }

    /// How the distance from it changes over the motion and over the piece, which go up by so much.
    fn slopes(&self, seen: &Seen, rho: f64, z: f64, [up_way, up_along]: [f64; 2]) -> [f64; 2] {
        // On the axis the slope across is any up to 1, and 0 is one of them.
        let out = if rho > 1e-9 { 1.0 / rho } else { 0.0 };
        let across = [(seen.way - z * up_way) * out, (seen.along - z * up_along) * out];
        let slope = |across: f64, up: f64| self.across * across + self.along * up;
        [slope(across[0], up_way), slope(across[1], up_along)]
    }
}

/// How far up each of these goes along each of the directions asked.
fn rises_along<const N: usize>(
    directions: &[UnitVector3<f64>],
    asked: DirectionSet,
    of: [&Vector3<f64>; N],
) -> Vec<[f64; N]> {
    let mut rises = vec![[0.0; N]; directions.len()];
    for index in asked.iter() {
        if let (Some(axis), Some(rises)) = (directions.get(index), rises.get_mut(index)) {
            *rises = of.map(|vector| vector.dot(axis));
        }
    }
    rises
}

/// A point as it is seen from the tip, and how it moves.
struct Seen {
    squared: f64,
    way: f64,
    along: f64,
}
