//! A member that is bowed: one element for a circular arc, exact for slender beams.

use nalgebra::{Matrix3, Matrix3x6, Matrix6, Point3, RowVector6, SMatrix, Vector3, Vector6};

use crate::element::Vector12;
use crate::section::Section;
use crate::stress::SectionForces;

/// A stiffness of a member: forces and moments at its ends for displacements and rotations of them, in the model's axes.
pub type EndStiffness = SMatrix<f64, 12, 12>;

/// Half the opening below which an arc is straight, radian.
const STRAIGHT: f64 = 1e-9;

/// At so many places along it stresses count.
const PLACES: u8 = 20;

/// Places and weights of Gauss and Legendre from 0 to 1, exact to the ninth power of the length.
const GAUSS: [(f64, f64); 5] = [
    (0.046_910_077_030_668_004, 0.118_463_442_528_094_54),
    (0.230_765_344_947_158_45, 0.239_314_335_249_683_24),
    (0.5, 0.284_444_444_444_444_44),
    (0.769_234_655_052_841_6, 0.239_314_335_249_683_24),
    (0.953_089_922_969_332, 0.118_463_442_528_094_54),
];

/// A round wire along a flat circular arc between two points; straight where it does not rise.
///
/// It takes the place of a chain of short straight members between the same two nodes: without load between its ends both say the
/// same, as short as the members may be.
#[derive(Debug, Clone, PartialEq)]
pub struct Arc {
    a: Point3<f64>,
    b: Point3<f64>,
    /// From the chord's middle to the highest point, mm.
    rise: Vector3<f64>,
    /// Half of what the arc turns, radian.
    half_opening: f64,
    section: Section,
    stiffness: EndStiffness,
    /// The mean square of stresses, of what `b` takes.
    squares: Matrix6<f64>,
}

impl Arc {
    /// An arc from `a` to `b`, mm, whose middle is `rise` away from that of its chord; only what is across the chord counts. The
    /// ends are apart and the section is round, or the figures mean nothing.
    #[must_use]
    pub fn new(a: Point3<f64>, b: Point3<f64>, rise: Vector3<f64>, section: &Section) -> Self {
        let chord = (b - a).normalize();
        let rise = rise - chord * chord.dot(&rise);
        let half_opening = 2.0 * (2.0 * rise.norm() / (b - a).norm()).atan();
        let (stiffness, squares) = (EndStiffness::zeros(), Matrix6::zeros());
        let mut arc = Self { a, b, rise, half_opening, section: *section, stiffness, squares };
        arc.stiffness = arc.stiffness_of_ends();
        arc.squares = arc.squares_of_stresses();
        arc
    }

    /// Along the wire, mm.
    #[must_use]
    pub fn length(&self) -> f64 {
        let chord = (self.b - self.a).norm();
        if self.half_opening < STRAIGHT { chord } else { chord * self.half_opening / self.half_opening.sin() }
    }

    /// The point at a share of the length, from 0 at `a` to 1 at `b`, and the direction there.
    #[must_use]
    pub fn at(&self, share: f64) -> (Point3<f64>, Vector3<f64>) {
        let along = self.b - self.a;
        let chord = along.normalize();
        if self.half_opening < STRAIGHT {
            return (self.a + along * share, chord);
        }
        let up = self.rise.normalize();
        let radius = along.norm() / (2.0 * self.half_opening.sin());
        let angle = self.half_opening * (2.0 * share - 1.0);
        let middle = self.a + along / 2.0;
        let place =
            middle + chord * (radius * angle.sin()) + up * (radius * (angle.cos() - self.half_opening.cos()));
        (place, chord * angle.cos() - up * angle.sin())
    }

    /// Its stiffness: what the displacements and rotations of `a`, then `b`, take as forces and moments. For a straight member it is
    /// the textbook matrix.
    #[must_use]
    pub fn stiffness(&self) -> &EndStiffness {
        &self.stiffness
    }

    /// The forces and moments at its ends when they move so, in the model's axes.
    #[must_use]
    pub fn end_forces(&self, ends: &[f64; 12]) -> [f64; 12] {
        (self.stiffness * Vector12::from(*ends)).into()
    }

    /// The mean of the square of the von Mises stress over four points of the surface, a right angle apart, at 20 places along it, in the square of MPa,
    /// from the forces and moments at its ends. Of four such points half of the largest bending stress squared counts, whichever they
    /// are.
    #[must_use]
    pub fn mean_stress_square(&self, ends: &[f64; 12]) -> f64 {
        let at_b = Vector6::from_column_slice(&ends[6..]);
        at_b.dot(&(self.squares * at_b))
    }

    /// From the flexibility of `b` with `a` held, the integral of what a force at `b` bends, twists and stretches along the arc.
    fn stiffness_of_ends(&self) -> EndStiffness {
        // Rotations times the length are as large as displacements, and the inverse is as good as it can be.
        let scale = (self.b - self.a).norm();
        let ways =
            Matrix6::from_diagonal(&Vector6::new(1.0, 1.0, 1.0, 1.0 / scale, 1.0 / scale, 1.0 / scale));
        let yields = ways * self.flexibility() * ways;
        let held = ways * yields.try_inverse().unwrap_or_else(Matrix6::zeros) * ways;
        let mut carried = Matrix6::identity();
        carried.fixed_view_mut::<3, 3>(3, 0).copy_from(&(self.b - self.a).cross_matrix());
        let mut all = EndStiffness::zeros();
        all.fixed_view_mut::<6, 6>(0, 0).copy_from(&(carried * held * carried.transpose()));
        all.fixed_view_mut::<6, 6>(0, 6).copy_from(&-(carried * held));
        all.fixed_view_mut::<6, 6>(6, 0).copy_from(&-(held * carried.transpose()));
        all.fixed_view_mut::<6, 6>(6, 6).copy_from(&held);
        (all + all.transpose()) / 2.0
    }

    /// How `b` moves and turns for a force and a moment there while `a` is held.
    fn flexibility(&self) -> Matrix6<f64> {
        let Section { area, iy, j, e, g, .. } = self.section;
        let mut flexibility = Matrix6::zeros();
        for (share, weight) in GAUSS {
            let (place, along) = self.at(share);
            let axis = along * along.transpose();
            let stretches = axis / (e * area);
            let turns = axis / (g * j) + (Matrix3::identity() - axis) / (e * iy);
            let lever = (self.b - place).cross_matrix();
            let length = self.length() * weight;
            let mut add = |row, column, part: Matrix3<f64>| {
                let mut view = flexibility.fixed_view_mut::<3, 3>(row, column);
                view += part * length;
            };
            add(0, 0, stretches + lever.transpose() * turns * lever);
            add(0, 3, lever.transpose() * turns);
            add(3, 0, turns * lever);
            add(3, 3, turns);
        }
        flexibility
    }

    /// The form that makes the mean square of stresses of what `b` takes.
    fn squares_of_stresses(&self) -> Matrix6<f64> {
        let Section { area, radius, iy, j, .. } = self.section;
        let mut squares = Matrix6::zeros();
        for place in 0..PLACES {
            let (place, along) = self.at((f64::from(place) + 0.5) / f64::from(PLACES));
            let mut moment = Matrix3x6::zeros();
            moment.fixed_view_mut::<3, 3>(0, 0).copy_from(&(self.b - place).cross_matrix());
            moment.fixed_view_mut::<3, 3>(0, 3).copy_from(&Matrix3::identity());
            let mut axial = RowVector6::zeros();
            axial.fixed_view_mut::<1, 3>(0, 0).copy_from(&along.transpose());
            let torque = along.transpose() * moment;
            let twisting = torque.transpose() * torque;
            let bending = moment.transpose() * moment - twisting;
            squares += axial.transpose() * axial / (area * area);
            squares +=
                bending * (radius * radius / (2.0 * iy * iy)) + twisting * (3.0 * radius * radius / (j * j));
        }
        squares / f64::from(PLACES)
    }

    /// The forces in a cut at a share of the length, from the forces and moments at its ends in the model's axes. Local y and z
    /// are any: the bending moment and the shear stand in y alone.
    #[must_use]
    pub fn forces_at(&self, ends: &[f64; 12], share: f64) -> SectionForces {
        let (place, along) = self.at(share);
        let force = Vector3::new(ends[6], ends[7], ends[8]);
        let moment = Vector3::new(ends[9], ends[10], ends[11]) + (self.b - place).cross(&force);
        let (axial, torque) = (force.dot(&along), moment.dot(&along));
        SectionForces {
            axial,
            shear_y: (force - along * axial).norm(),
            shear_z: 0.0,
            torque,
            moment_y: (moment - along * torque).norm(),
            moment_z: 0.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Material;

    /// The wire of the Bend-Forming prototypes and a strut of their truss.
    const STRUT: f64 = 61.237_243_57;

    fn steel() -> Section {
        let e = 200_000.0;
        let material = Material { e, g: e / 2.58, density: 7.8e-9, yield_strength: 500.0 };
        Section::round(0.9, &material)
    }

    fn along_x(rise: f64) -> Arc {
        let end = Point3::new(STRUT, 0.0, 0.0);
        Arc::new(Point3::origin(), end, Vector3::new(0.0, rise * STRUT, 0.0), &steel())
    }

    fn near(value: f64, expected: f64, part: f64) {
        assert!((value / expected - 1.0).abs() < part, "{value} instead of {expected}");
    }

    #[test]
    fn without_a_rise_it_is_the_textbook_beam() {
        let (k, s) = (*along_x(0.0).stiffness(), steel());
        let l = STRUT;
        near(k[(0, 0)], s.e * s.area / l, 1e-11);
        near(k[(1, 1)], 12.0 * s.e * s.iz / l.powi(3), 1e-9);
        near(k[(1, 5)], 6.0 * s.e * s.iz / l.powi(2), 1e-9);
        near(k[(2, 4)], -6.0 * s.e * s.iy / l.powi(2), 1e-9);
        near(k[(3, 3)], s.g * s.j / l, 1e-11);
        near(k[(5, 5)], 4.0 * s.e * s.iz / l, 1e-9);
        near(k[(5, 11)], 2.0 * s.e * s.iz / l, 1e-9);
        near(k[(3, 9)], -s.g * s.j / l, 1e-11);
    }

    /// The tangent of a flat arc: 8/15 of (rise over radius of gyration)² where its ends turn, 4/45 where they do not; the arc is not
    /// quite flat.
    #[test]
    fn a_bow_takes_axial_stiffness_as_a_flat_arc_loses_it() {
        let (bowed, s) = (*along_x(0.03).stiffness(), steel());
        let straight = s.e * s.area / STRUT;
        let slender = 0.03 * STRUT / (0.9 / 4.0);
        near(bowed[(6, 6)], straight / (1.0 + 4.0 / 45.0 * slender * slender), 0.02);
        // The ends free to turn: the rotations about z condensed out.
        let turns = bowed.select_columns(&[5, 11]).select_rows(&[5, 11]);
        let between = bowed.select_columns(&[6]).select_rows(&[5, 11]);
        let pinned = bowed[(6, 6)] - (between.transpose() * turns.try_inverse().unwrap() * &between)[(0, 0)];
        near(pinned, straight / (1.0 + 8.0 / 15.0 * slender * slender), 0.02);
    }

    #[test]
    fn it_is_in_balance_and_moves_freely_as_a_whole() {
        let arc = Arc::new(
            Point3::new(1.0, 2.0, 3.0),
            Point3::new(20.0, -7.0, 30.0),
            Vector3::new(1.0, 1.0, 0.5),
            &steel(),
        );
        let k = arc.stiffness();
        let (shift, turn) = (Vector3::new(0.1, -0.2, 0.3), Vector3::new(0.02, 0.03, -0.01));
        let at_b = shift + turn.cross(&(arc.b - arc.a));
        let moved: Vec<f64> = [shift, turn, at_b, turn].iter().flat_map(|v| v.iter().copied()).collect();
        let forces = k * nalgebra::SVector::<f64, 12>::from_column_slice(&moved);
        assert!(forces.norm() < 1e-9 * k.norm() * 0.4, "{forces}");
    }

    /// The highest point and the length of the arc of a circle through its ends.
    #[test]
    fn its_middle_is_where_it_rises_to() {
        let arc = along_x(0.03);
        let (top, along) = arc.at(0.5);
        assert!((top - Point3::new(STRUT / 2.0, 0.03 * STRUT, 0.0)).norm() < 1e-12);
        assert!((along - Vector3::x()).norm() < 1e-12);
        let pieces: f64 = (0..1000)
            .map(|k| {
                let at = |k: i32| arc.at(f64::from(k) / 1000.0).0;
                (at(k + 1) - at(k)).norm()
            })
            .sum();
        near(arc.length(), pieces, 1e-6);
        assert!((arc.at(1.0).0 - Point3::new(STRUT, 0.0, 0.0)).norm() < 1e-12);
    }

    /// A cut carries what the end pulls: a straight tie under 10 N, and its bending moment falling to the end.
    #[test]
    fn a_cut_carries_what_the_ends_take() {
        let tie =
            along_x(0.0).forces_at(&[-10.0, 0.0, 0.0, 0.0, 0.0, 0.0, 10.0, 0.0, 0.0, 0.0, 0.0, 0.0], 0.3);
        assert!((tie.axial - 10.0).abs() < 1e-12 && tie.moment() < 1e-12);
        let ends = [0.0, -2.0, 0.0, 0.0, 0.0, -2.0 * STRUT, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0];
        let moment = |share| along_x(0.0).forces_at(&ends, share).moment();
        near(moment(0.0), 2.0 * STRUT, 1e-12);
        near(moment(0.75), 0.5 * STRUT, 1e-12);
    }

    /// The mean over four points and twenty places, one after the other.
    #[test]
    fn stresses_are_those_of_its_surface() {
        let (arc, section) = (along_x(0.03), steel());
        let ends = arc.end_forces(&[0.0, 0.0, 0.0, 0.01, 0.02, -0.01, -0.05, 0.1, 0.2, 0.0, 0.03, 0.02]);
        let mut sum = 0.0;
        for place in 0..20 {
            let forces = arc.forces_at(&ends, (f64::from(place) + 0.5) / 20.0);
            for quarter in 0..4 {
                let angle = 0.3 + std::f64::consts::FRAC_PI_2 * f64::from(quarter);
                sum += forces.stress_at(&section, angle).von_mises.powi(2) / 80.0;
            }
        }
        near(arc.mean_stress_square(&ends), sum, 1e-9);
    }
}
