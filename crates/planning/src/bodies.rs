//! The bodies of a machine, from its profile.

use nalgebra::{Isometry3, Rotation3, Translation3, UnitQuaternion, Vector3};
use wirebend_core::clearance::{self, Bodies, Body, MovesWith};
use wirebend_core::compensate::PegGeometry;
use wirebend_core::units::{Angle, Length};
use wirebend_profile::{BendFigures, MachineFigures, Part, Shape};

/// How far a peg that is in stays from the wire that passes over it, mm.
const CLEAR_MM: f64 = 1.0;

/// The bodies of a machine, which goes by its id, with a wire of a diameter in it.
pub fn bodies(machine: &str, shapes: &[Shape], figures: &MachineFigures, diameter_mm: f64) -> Bodies {
    let pushes = shapes.iter().find(|shape| shape.part == Part::Peg && shape.contact_zone_mm > 0.0);
    let pivot_mm = pivot_mm(figures);
    let peg_rest = match figures.bend {
        // Its axis is at zero where the peg is on the wire's axis.
        BendFigures::Peg { .. } => 0.0,
        BendFigures::Direct { .. } => pushes.map_or(0.0, |peg| peg.at_mm[1].atan2(peg.at_mm[0] - pivot_mm)),
    };
    // A peg for which nothing waits stays out.
    let retracts = figures.fixed_per_bend_s > 0.0;
    let stroke_mm = if retracts { peg_top_mm(shapes) + diameter_mm / 2.0 + CLEAR_MM } else { 0.0 };
    Bodies {
        all: shapes.iter().map(|shape| body(machine, shape)).collect(),
        pivot: length(pivot_mm),
        peg_stroke: length(stroke_mm),
        peg_rest: Angle::from_rad(peg_rest).unwrap_or_default(),
        approach: PegGeometry::clear_before_touch(),
    }
}

/// Where the axis that the peg turns about crosses x, mm.
#[must_use]
pub fn pivot_mm(figures: &MachineFigures) -> f64 {
    match figures.bend {
        BendFigures::Peg { orbit_offset_mm, .. } => orbit_offset_mm,
        BendFigures::Direct { .. } => 0.0,
    }
}

/// How long the peg is that touches the wire; nothing where no shape says so.
#[must_use]
pub fn peg_length(shapes: &[Shape]) -> Option<Length> {
    let lengths = shapes
        .iter()
        .filter(|shape| shape.part == Part::Peg && shape.contact_zone_mm > 0.0)
        .filter_map(|shape| match shape.solid {
            wirebend_profile::Solid::Cylinder { length_mm, .. } => Some(length_mm),
            wirebend_profile::Solid::Box { .. } => None,
        });
    lengths.max_by(f64::total_cmp).map(length)
}

fn body(machine: &str, shape: &Shape) -> Body {
    let solid = match shape.solid {
        wirebend_profile::Solid::Box { size_mm } => {
            clearance::Solid::Box { half: Vector3::from(size_mm) / 2.0 }
        }
        wirebend_profile::Solid::Cylinder { radius_mm, length_mm } => {
            clearance::Solid::Cylinder { radius: radius_mm, half_length: length_mm / 2.0 }
        }
    };
    let turn = UnitQuaternion::from_rotation_matrix(&turn_of(shape));
    Body {
        name: shape.name.clone(),
        moves_with: match shape.part {
            Part::Frame => MovesWith::Frame,
            Part::Head => MovesWith::Head,
            Part::Peg => MovesWith::Peg,
        },
        solid,
        at: Isometry3::from_parts(Translation3::from(shape.at_mm), turn),
        contact_zone: length(shape.contact_zone_mm),
        vertex_zone: length(shape.vertex_zone_mm),
        entry: format!("{machine}, shapes: {}", shape.name),
        source: shape.source.clone(),
        measured: shape.measured,
    }
}

/// Takes z to the axis of a shape the shortest way; none where it points along -z, as both solids are the same upside down.
fn turn_of(shape: &Shape) -> Rotation3<f64> {
    Rotation3::rotation_between(&Vector3::z(), &Vector3::from(shape.axis)).unwrap_or_else(Rotation3::identity)
}

/// A figure of a profile, which are all finite.
fn length(mm: f64) -> Length {
    Length::from_mm(mm).unwrap_or_default()
}

/// How far the peg's bodies, each in a box along its own axes, reach beyond the middle of the wire along the bend axis while
/// the peg is out, mm: it goes in by as much, and by what the wire takes, to let the wire pass. 0 without such bodies.
#[must_use]
pub fn peg_top_mm(shapes: &[Shape]) -> f64 {
    let top = |shape: &Shape| {
        let half = match shape.solid {
            wirebend_profile::Solid::Box { size_mm } => size_mm.map(|size| size / 2.0),
            wirebend_profile::Solid::Cylinder { radius_mm, length_mm } => {
                [radius_mm, radius_mm, length_mm / 2.0]
            }
        };
        let row = turn_of(shape).matrix().row(2).abs().transpose();
        shape.at_mm[2] + row.dot(&Vector3::from(half))
    };
    shapes.iter().filter(|shape| shape.part == Part::Peg).map(top).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use wirebend_profile::Solid;

    use super::*;

    /// Were it too low, a peg that is in would be drawn across the wire.
    #[test]
    fn the_top_of_a_peg_is_that_of_its_highest_body_however_that_lies() {
        let peg = |part, length_mm, z, axis| Shape {
            name: "rod".to_owned(),
            part,
            solid: Solid::Cylinder { radius_mm: 3.0, length_mm },
            at_mm: [32.0, 0.0, z],
            axis,
            contact_zone_mm: 0.0,
            vertex_zone_mm: 0.0,
            source: "the test".to_owned(),
            measured: false,
        };
        let upright = peg(Part::Peg, 20.0, 0.0, [0.0, 0.0, 1.0]);
        let upside_down = peg(Part::Peg, 20.0, 1.0, [0.0, 0.0, -2.0]);
        let lying = peg(Part::Peg, 20.0, 5.0, [1.0, 0.0, 0.0]);
        let head = peg(Part::Head, 90.0, 0.0, [0.0, 0.0, 1.0]);
        for (shapes, top) in [
            (vec![], 0.0),
            (vec![head.clone()], 0.0),
            (vec![upright.clone()], 10.0),
            (vec![upright.clone(), upside_down], 11.0),
            (vec![lying, head], 8.0),
            (vec![peg(Part::Peg, 2.0, -30.0, [0.0, 0.0, 1.0])], 0.0),
        ] {
            assert!((peg_top_mm(&shapes) - top).abs() < 1e-12, "{shapes:?}");
        }
    }
}
