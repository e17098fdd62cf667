//! Forces in a cross-section and the stresses that they make.

use crate::section::Section;

/// What one side of a cut across a member does to the other, in the member's local axes. The cut face looks along +x.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct SectionForces {
    /// Tension, N; negative is compression.
    pub axial: f64,
    /// Shear along local y, N.
    pub shear_y: f64,
    /// Shear along local z, N.
    pub shear_z: f64,
    /// Moment about local x, N mm.
    pub torque: f64,
    /// Moment about local y, N mm.
    pub moment_y: f64,
    /// Moment about local z, N mm.
    pub moment_z: f64,
}

/// Stresses in the outermost fibre, MPa.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Stress {
    /// Along the member, without sign.
    pub normal: f64,
    /// From torsion.
    pub shear: f64,
    /// √(normal² + 3 shear²).
    pub von_mises: f64,
}

impl SectionForces {
    /// The bending moment, whatever its direction, N mm.
    #[must_use]
    pub fn moment(&self) -> f64 {
        self.moment_y.hypot(self.moment_z)
    }

    /// The largest stresses on the surface: |N|/A + M r/I and T r/J. The shear of bending is left out, as it is none in the
    /// outermost fibre. Of a section that is not round the moments are added as if both were worst at one place.
    #[must_use]
    pub fn stress(&self, section: &Section) -> Stress {
        let bending = if section.is_round() {
            self.moment() / section.iy
        } else {
            self.moment_y.abs() / section.iy + self.moment_z.abs() / section.iz
        };
        Stress::of(
            self.axial.abs() / section.area + bending * section.radius,
            self.torque * section.radius / section.j,
        )
    }

    /// The stresses at one place of the surface of a round section, by its angle from local y towards z, radian.
    #[must_use]
    pub fn stress_at(&self, section: &Section, angle: f64) -> Stress {
        let (y, z) = (section.radius * angle.cos(), section.radius * angle.sin());
        let normal =
            self.axial / section.area + self.moment_y * z / section.iy - self.moment_z * y / section.iz;
        Stress::of(normal.abs(), self.torque * section.radius / section.j)
    }
}

impl Stress {
    fn of(normal: f64, shear: f64) -> Self {
        let shear = shear.abs();
        Self { normal, shear, von_mises: normal.hypot(shear * 3.0_f64.sqrt()) }
    }
}
