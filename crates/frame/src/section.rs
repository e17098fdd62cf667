//! What a member is made of, and its cross-section.

/// A material that follows Hooke's law, the same in all directions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Young's modulus, MPa.
    pub e: f64,
    /// Shear modulus, MPa.
    pub g: f64,
    /// `t/mm³`: 7800 `kg/m³` are 7.8e-9.
    pub density: f64,
    /// The stress at which it yields, MPa.
    pub yield_strength: f64,
}

/// A cross-section, constant along its member, and what it is made of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Section {
    /// mm².
    pub area: f64,
    /// Second moment of area about local y, mm⁴.
    pub iy: f64,
    /// Second moment of area about local z, mm⁴.
    pub iz: f64,
    /// Torsion constant, mm⁴; of a round section the polar moment of area.
    pub j: f64,
    /// How far the outermost fibre is from the centreline, mm; stresses are those at this distance.
    pub radius: f64,
    /// Young's modulus, MPa.
    pub e: f64,
    /// Shear modulus, MPa.
    pub g: f64,
    /// `t/mm³`.
    pub density: f64,
    /// The stress at which it yields, MPa.
    pub yield_strength: f64,
}

impl Section {
    /// A solid round wire of this diameter, mm.
    ///
    /// ```
    /// # use wirebend_frame::{Material, Section};
    /// let steel = Material { e: 200_000.0, g: 77_500.0, density: 7.8e-9, yield_strength: 1000.0 };
    /// let wire = Section::round(2.0, &steel);
    /// assert!((wire.area - std::f64::consts::PI).abs() < 1e-12);
    /// assert!((wire.iy - std::f64::consts::FRAC_PI_4).abs() < 1e-12);
    /// ```
    #[must_use]
    pub fn round(diameter: f64, material: &Material) -> Self {
        let radius = diameter / 2.0;
        let area = std::f64::consts::PI * radius * radius;
        let i = area * radius * radius / 4.0;
        Self {
            area,
            iy: i,
            iz: i,
            j: 2.0 * i,
            radius,
            e: material.e,
            g: material.g,
            density: material.density,
            yield_strength: material.yield_strength,
        }
    }

    /// Whether all directions across the member are alike, so that its local y and z do not matter.
    #[allow(clippy::float_cmp, reason = "a section is round when it was made so")]
    pub(crate) fn is_round(&self) -> bool {
        self.iy == self.iz
    }
}
