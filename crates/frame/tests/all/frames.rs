//! Frames to test with, and how their files are read.

use std::path::Path;

use nalgebra::{Point3, Vector3};
use wirebend_frame::{Load, Material, Member, Model, NodeId, Section, SectionId, Support};

/// The ABS of FrameFab (Huang et al. 2016): struts of radius 0.75 mm.
pub const ABS: Material = Material { e: 3457.0, g: 1294.0, density: 1.21e-9, yield_strength: 40.0 };

/// The PLA of `assembly_instances` and conmech: 12.2582 kN/m³ of weight, here with g 9.80665 m/s².
pub const PLA: Material =
    Material { e: 3500.0, g: 2400.0, density: 12.2582e-6 / 9806.65, yield_strength: 36.0 };

/// The steel wire of Bend-Forming: ν 0.29, diameter 0.9 mm.
pub const STEEL: Material =
    Material { e: 200_000.0, g: 200_000.0 / 2.58, density: 7.8e-9, yield_strength: 1000.0 };

/// The weight with the g of FrameFab's sources, 9.80633 m/s².
pub fn framefab_weight() -> Load {
    Load { gravity: Vector3::new(0.0, 0.0, -9806.33), ..Load::default() }
}

/// A file of this crate with a section and clamped feet.
pub fn frame(file: &str, section: Section) -> Model {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
    let text = std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut model = Model { sections: vec![section], ..Model::default() };
    for line in text.lines() {
        let mut words = line.split_whitespace();
        let letter = words.next();
        let numbers: Vec<f64> = words.map(|word| word.parse().expect("a number")).collect();
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "whole numbers from 1")]
        let node = |k: usize| NodeId(numbers[k] as usize - 1);
        match letter {
            Some("v") => model.nodes.push(Point3::new(numbers[0], numbers[1], numbers[2])),
            Some("l") => model.members.push(Member::new(node(0), node(1), SectionId(0))),
            // A pillar of FrameFab: a strut whose second end is a foot on the ground.
            Some("p") => {
                model.members.push(Member::new(node(0), node(1), SectionId(0)));
                model.supports.push(Support::clamped(node(1)));
            }
            Some("s") => model.supports.push(Support::clamped(node(0))),
            _ => {}
        }
    }
    model
}

/// FrameFab's bunny: 91 nodes, 167 struts and 12 pillars.
pub fn bunny() -> Model {
    frame("tests/data/framefab/bunny0507_.pwf", Section::round(1.5, &ABS))
}

/// A straight member of steel wire along `span`, cut into pieces, not held.
pub fn beam(span: Vector3<f64>) -> Model {
    Model {
        nodes: vec![Point3::origin(), Point3::from(span)],
        members: vec![Member::new(NodeId(0), NodeId(1), SectionId(0))],
        sections: vec![Section::round(0.9, &STEEL)],
        supports: Vec::new(),
    }
}

/// Whether two figures differ by at most this share of the second.
#[track_caller]
pub fn assert_close(found: f64, expected: f64, share: f64) {
    assert!(
        (found - expected).abs() <= share * expected.abs(),
        "{found} instead of {expected} within {share}"
    );
}
