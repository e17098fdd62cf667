//! How a stencil lies in the design.

use nalgebra::{Matrix3, Point3, Rotation3, Unit, Vector3};

use super::Stencil;
use crate::units::{Angle, Length};

/// A surface is scaled and turned about the middle of its box, and that is moved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placement {
    shift: Vector3<f64>,
    turn_deg: [f64; 3],
    scale: f64,
}

/// Why numbers are no placement.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum PlacementError {
    /// It would lie nowhere, or too far away to be drawn exactly.
    #[error("a stencil can be moved by no more than {farthest} mm, not by {0} mm", farthest = Placement::FARTHEST_MM)]
    Shift(f64),
    /// An angle that is none.
    #[error("{0}° is no angle to turn by: it has to be a finite number")]
    Turn(f64),
    /// It would vanish, be turned inside out, or be larger than anything that is bent.
    #[error("a stencil can be scaled by {least} to {most}, not by {0}", least = Placement::SCALES[0], most = Placement::SCALES[1])]
    Scale(f64),
}

impl Default for Placement {
    fn default() -> Self {
        Self { shift: Vector3::zeros(), turn_deg: [0.0; 3], scale: 1.0 }
    }
}

impl Placement {
    /// How far a stencil can be moved along an axis, mm.
    pub const FARTHEST_MM: f64 = 100_000.0;
    /// By how much one can be scaled.
    pub const SCALES: [f64; 2] = [0.001, 1000.0];

    /// A placement from how far it is moved along x, y and z in mm, how far it is turned about the x axis, then about the y
    /// axis, then about the z axis of the design in degrees, and its scale.
    ///
    /// # Errors
    /// [`PlacementError`] names the first number that is none.
    pub fn new(shift_mm: [f64; 3], turn_deg: [f64; 3], scale: f64) -> Result<Self, PlacementError> {
        let near = -Self::FARTHEST_MM..=Self::FARTHEST_MM;
        if let Some(&by) = shift_mm.iter().find(|by| !near.contains(*by)) {
            return Err(PlacementError::Shift(by));
        }
        if let Some(&turn) = turn_deg.iter().find(|turn| !turn.is_finite()) {
            return Err(PlacementError::Turn(turn));
        }
        if !(Self::SCALES[0]..=Self::SCALES[1]).contains(&scale) {
            return Err(PlacementError::Scale(scale));
        }
        Ok(Self { shift: shift_mm.into(), turn_deg, scale })
    }

    /// How far it is moved, mm.
    #[must_use]
    pub fn shift_mm(&self) -> [f64; 3] {
        self.shift.into()
    }

    /// How far it is turned about x, then y, then z, degrees.
    #[must_use]
    pub const fn turn_deg(&self) -> [f64; 3] {
        self.turn_deg
    }

    /// Its scale.
    #[must_use]
    pub const fn scale(&self) -> f64 {
        self.scale
    }

    /// It turned once more, right-handed about an axis of the design through its middle.
    #[must_use]
    pub fn turned(&self, axis: Unit<Vector3<f64>>, by: Angle) -> Self {
        let turn = Rotation3::from_axis_angle(&axis, by.rad()) * self.rotation();
        let (x, y, z) = turn.euler_angles();
        // A quarter of a turn is to be one, not 89.99999999999999.
        let round = |rad: f64| (rad.to_degrees() * 1e9).round() / 1e9;
        Self { turn_deg: [x, y, z].map(round), ..*self }
    }

    fn rotation(&self) -> Rotation3<f64> {
        let turn = self.turn_deg.map(f64::to_radians);
        Rotation3::from_euler_angles(turn[0], turn[1], turn[2])
    }

    /// The rows of the matrix that takes a point of the surface, in mm, to where it lies in the design. `middle`: of the surface.
    #[must_use]
    pub fn matrix(&self, middle: Point3<f64>) -> [[f64; 4]; 3] {
        let linear: Matrix3<f64> = self.rotation().into_inner() * self.scale;
        let shift = middle.coords + self.shift - linear * middle.coords;
        [0, 1, 2].map(|row| [linear[(row, 0)], linear[(row, 1)], linear[(row, 2)], shift[row]])
    }
}

impl Stencil {
    /// The middle of the box around it.
    #[must_use]
    pub fn middle(&self) -> Point3<f64> {
        let [low, high] = self.bounds();
        nalgebra::center(&low, &high)
    }

    /// How far the box reaches along x, y and z.
    #[must_use]
    pub fn size(&self) -> [Length; 3] {
        let [low, high] = self.bounds();
        [0, 1, 2].map(|axis| Length::computed(high[axis] - low[axis]))
    }

    /// The surface where it lies in the design.
    #[must_use]
    pub fn placed(&self, placement: &Placement) -> Self {
        if *placement == Placement::default() {
            return self.clone();
        }
        let rows = placement.matrix(self.middle());
        let along = |row: &[f64; 4], at: &Point3<f64>| row[0] * at.x + row[1] * at.y + row[2] * at.z + row[3];
        let place = |at: &Point3<f64>| Point3::from(rows.each_ref().map(|row| along(row, at)));
        Self::of_parts(self.vertices.iter().map(place).collect(), self.faces.clone())
    }
}

impl FromIterator<Stencil> for Stencil {
    /// Several surfaces as one: the vertices of each after those of the one before it.
    fn from_iter<I: IntoIterator<Item = Self>>(surfaces: I) -> Self {
        let (mut vertices, mut faces) = (Vec::new(), Vec::new());
        for surface in surfaces {
            let first = u32::try_from(vertices.len()).unwrap_or(u32::MAX);
            faces.extend(
                surface.faces.into_iter().map(|face| {
                    face.into_iter().map(|corner| corner.saturating_add(first)).collect::<Vec<_>>()
                }),
            );
            vertices.extend(surface.vertices);
        }
        Self::of_parts(vertices, faces)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn surface() -> Stencil {
        let corners = [[0.0, 0.0, 0.0], [4.0, 0.0, 0.0], [4.0, 2.0, 0.0], [0.0, 2.0, 6.0]];
        Stencil::new(corners.map(Point3::from).to_vec(), vec![vec![0, 1, 2], vec![0, 2, 3]]).unwrap()
    }

    #[test]
    fn it_turns_about_x_first_and_about_z_last() {
        let placement = Placement::new([0.0; 3], [90.0, 0.0, 90.0], 1.0).unwrap();
        // About x the way up, z, becomes -y; about z that becomes x.
        let up = Point3::from(surface().middle().coords + Vector3::z());
        let rows = placement.matrix(surface().middle());
        let x = rows[0][0] * up.x + rows[0][1] * up.y + rows[0][2] * up.z + rows[0][3];
        assert!((x - (surface().middle().x + 1.0)).abs() < 1e-12, "{x}");
    }

    #[test]
    fn what_is_no_placement_is_named() {
        assert_eq!(Placement::new([0.0, 2e5, 0.0], [0.0; 3], 1.0), Err(PlacementError::Shift(2e5)));
        assert!(matches!(Placement::new([f64::NAN; 3], [0.0; 3], 1.0), Err(PlacementError::Shift(_))));
        assert!(matches!(
            Placement::new([0.0; 3], [f64::INFINITY, 0.0, 0.0], 1.0),
            Err(PlacementError::Turn(_))
        ));
        for scale in [0.0, -1.0, f64::NAN, 2000.0] {
            assert!(matches!(Placement::new([0.0; 3], [0.0; 3], scale), Err(PlacementError::Scale(_))));
        }
    }

    #[test]
    fn several_surfaces_are_one_with_the_faces_of_each() {
        let placement = Placement::new([10.0, 0.0, 0.0], [0.0; 3], 1.0).unwrap();
        let both: Stencil = [surface(), surface().placed(&placement)].into_iter().collect();
        assert_eq!(both.faces()[2..], [vec![4, 5, 6], vec![4, 6, 7]]);
        assert_eq!(both.vertices()[5], Point3::new(14.0, 0.0, 0.0));
    }

    #[test]
    fn quarters_of_a_turn_add_up_to_whole_figures() {
        let quarter = Angle::from_deg(90.0).unwrap();
        let turned = Placement::default().turned(Vector3::z_axis(), quarter);
        assert_eq!(turned, Placement::new([0.0; 3], [0.0, 0.0, 90.0], 1.0).unwrap());
        assert_eq!(turned.turned(Vector3::y_axis(), quarter).turned(Vector3::y_axis(), -quarter), turned);
    }

    proptest! {
        /// Every place of the surface goes where a turn about the axis through its middle takes it.
        #[test]
        fn a_further_turn_is_about_an_axis_of_the_design(
            turn in prop::array::uniform3(-360.0..360.0_f64),
            upright in prop::bool::ANY,
            axis in 0_usize..3,
            deg in -720.0..720.0_f64,
        ) {
            // With y turned by a quarter x and z turn about the same axis.
            let turn = if upright { [turn[0], 90.0, turn[2]] } else { turn };
            let axis = [Vector3::x_axis(), Vector3::y_axis(), Vector3::z_axis()][axis];
            let before = Placement::new([3.0, -5.0, 7.0], turn, 1.5).unwrap();
            let after = surface().placed(&before.turned(axis, Angle::from_deg(deg).unwrap()));
            let (before, middle) = (surface().placed(&before), surface().middle() + Vector3::new(3.0, -5.0, 7.0));
            let (sin, cos) = deg.to_radians().sin_cos();
            for (was, is) in before.vertices().iter().zip(after.vertices()) {
                let arm = was - middle;
                let aside = axis.into_inner() * axis.dot(&arm);
                let expected = middle + aside + (arm - aside) * cos + axis.cross(&arm) * sin;
                prop_assert!((is - expected).norm() < 1e-6, "{is} {expected}");
            }
        }

        /// Angles and proportions stay, and the middle goes where it is moved: whatever the numbers.
        #[test]
        fn lengths_are_scaled_and_the_middle_is_moved(
            shift in prop::array::uniform3(-500.0..500.0_f64),
            turn in prop::array::uniform3(-360.0..360.0_f64),
            scale in 0.01..50.0_f64,
        ) {
            let (before, placement) = (surface(), Placement::new(shift, turn, scale).unwrap());
            let after = before.placed(&placement);
            for (a, b) in [(0, 1), (0, 3), (1, 2), (2, 3)] {
                let long = |of: &Stencil| (of.vertices()[a] - of.vertices()[b]).norm();
                prop_assert!((long(&after) - scale * long(&before)).abs() < 1e-9 * scale.max(1.0) * 100.0);
            }
            let rows = placement.matrix(before.middle());
            let middle = before.middle();
            for axis in 0..3 {
                let at = rows[axis][0] * middle.x + rows[axis][1] * middle.y + rows[axis][2] * middle.z + rows[axis][3];
                prop_assert!((at - middle[axis] - shift[axis]).abs() < 1e-9 * scale.max(1.0) * 100.0);
            }
        }
    }
}
