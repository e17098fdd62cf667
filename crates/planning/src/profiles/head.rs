//! The bend head of a machine with a bent wire in it, as it is drawn with its dimensions.

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_core::compensate::PegGeometry;
use wirebend_profile::{BendFigures, MachineFigures};

use crate::machine::{deg, mm};
use crate::{Installation, PlanningError};

/// What the wire is drawn as: a right angle, which all that has a dimension is seen at.
const DRAWN_DEG: f64 = 90.0;

/// A bend head from above. Frame: the origin is where a bend begins, x along the wire that comes, y to the side of a positive
/// bend.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct HeadReport {
    /// Diameter of the wire, mm.
    pub wire_mm: f64,
    /// Radius of the pin that the wire wraps, mm.
    pub pin_radius_mm: f64,
    /// Its peg; absent where the bend axis itself is the bend.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub peg: Option<PegReport>,
}

/// The peg of a bend head.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct PegReport {
    pub radius_mm: f64,
    /// Radius R of its orbit, mm.
    pub orbit_radius_mm: f64,
    /// Offset s of the orbit's centre along the wire, mm.
    pub orbit_offset_mm: f64,
    /// Where it is while the wire is bent to a right angle, mm; null where it does not get there.
    pub at_mm: Option<[f64; 2]>,
    /// Where its axis is then, degrees; null likewise.
    pub axis_deg: Option<f64>,
}

impl Installation {
    /// The head of a machine with a wire in it; without a wire the machine's own.
    pub fn head(&self, machine: &str, material: Option<&str>) -> Result<HeadReport, PlanningError> {
        let machine = self.library.machine(machine)?;
        let own = machine.profile.default_material.as_deref().map_or("", String::as_str);
        let wire = self.library.material(material.unwrap_or(own))?.figures()?;
        report(&machine.figures()?, wire.diameter_mm)
    }
}

fn report(figures: &MachineFigures, wire_mm: f64) -> Result<HeadReport, PlanningError> {
    let peg = match figures.bend {
        BendFigures::Direct { .. } => None,
        BendFigures::Peg { rod_radius_mm, orbit_radius_mm, orbit_offset_mm, .. } => {
            let half = wire_mm / 2.0;
            let geometry = PegGeometry::new(
                mm(orbit_radius_mm)?,
                mm(orbit_offset_mm)?,
                mm(figures.pin_radius_mm + half)?,
                mm(rod_radius_mm + half)?,
            );
            let axis = match geometry {
                Ok(geometry) => geometry.axis_for(deg(DRAWN_DEG)?),
                Err(_) => None,
            };
            let at = |axis: wirebend_core::units::Angle| {
                let (sin, cos) = axis.rad().sin_cos();
                [orbit_offset_mm + orbit_radius_mm * cos, orbit_radius_mm * sin]
            };
            Some(PegReport {
                radius_mm: rod_radius_mm,
                orbit_radius_mm,
                orbit_offset_mm,
                at_mm: axis.map(at),
                axis_deg: axis.map(wirebend_core::units::Angle::deg),
            })
        }
    };
    Ok(HeadReport { wire_mm, pin_radius_mm: figures.pin_radius_mm, peg })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bent to a right angle, the leg's outside is half the wire beyond its centreline, and the peg touches it there.
    #[test]
    fn the_peg_touches_the_leg_of_a_right_angle() {
        let app = Installation::new(&[]).unwrap();
        let head = app.head("wirebend-kit", None).unwrap();
        let peg = head.peg.unwrap();
        let [x, y] = peg.at_mm.unwrap();
        let leg = head.pin_radius_mm + head.wire_mm / 2.0;
        assert!((x - (leg + head.wire_mm / 2.0 + peg.radius_mm)).abs() < 1e-9, "{x}");
        // On its orbit, and as far along the leg as docs/physics.md has it: 16.94 mm behind the end of the arc.
        assert!(((x - peg.orbit_offset_mm).hypot(y) - peg.orbit_radius_mm).abs() < 1e-9);
        assert!((y - leg - 16.94).abs() < 0.005, "{y}");
        assert!((peg.axis_deg.unwrap() - 102.240).abs() < 0.0005);
    }

    #[test]
    fn a_machine_whose_axis_is_the_bend_has_no_peg() {
        let app = Installation::new(&[]).unwrap();
        assert_eq!(app.head("table-bender", None).unwrap().peg, None);
    }
}
