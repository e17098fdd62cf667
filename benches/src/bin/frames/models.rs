//! Frames to be measured with.

use std::path::Path;

use anyhow::{Context, Result};
use nalgebra::Point3;
use wirebend_frame::{Material, Member, Model, NodeId, Pieces, Section, SectionId, Support};

/// FrameFab's ABS.
const ABS: Material = Material { e: 3457.0, g: 1294.0, density: 1.21e-9, yield_strength: 40.0 };
/// Bend-Forming's wire.
const STEEL: Material =
    Material { e: 200_000.0, g: 200_000.0 / 2.58, density: 7.8e-9, yield_strength: 1000.0 };
/// The length of the struts of Bend-Forming's truss, mm, and its depth.
const STRUT: f64 = 61.237_243_569_579_45;
const DEPTH: f64 = 50.0;

/// Frames on clamped feet.
pub fn standing() -> Result<Vec<(&'static str, Model)>> {
    let fertility = read("crates/frame/tests/data/fertility.txt")?;
    let on_feet = |rings| {
        let mut model = truss(rings);
        model.supports = (0..3).map(|node| Support::clamped(NodeId(node))).collect();
        Pieces::new(&model, 4).model
    };
    Ok(vec![
        ("bunny", bunny()?),
        ("fertility", fertility),
        ("truss 5, 4 pieces", on_feet(5)),
        ("truss 10, 4 pieces", on_feet(10)),
    ])
}

/// FrameFab's bunny.
pub fn bunny() -> Result<Model> {
    read("crates/files/tests/data/framefab/bunny0507_.pwf")
}

/// Vertices (`v`), struts (`l`), pillars to a foot (`p`), and nodes on the ground (`s`).
fn read(file: &str) -> Result<Model> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(file);
    let text = std::fs::read_to_string(&path).with_context(|| path.display().to_string())?;
    let mut model = Model { sections: vec![Section::round(1.5, &ABS)], ..Model::default() };
    for line in text.lines() {
        let words: Vec<&str> = line.split_whitespace().collect();
        let node = |k: usize| -> Result<NodeId> {
            Ok(NodeId(words.get(k).context(line.to_owned())?.parse::<usize>()? - 1))
        };
        match words.first() {
            Some(&"v") => {
                model.nodes.push(Point3::new(words[1].parse()?, words[2].parse()?, words[3].parse()?));
            }
            Some(&"s") => model.supports.push(Support::clamped(node(1)?)),
            Some(&("l" | "p")) => {
                model.members.push(Member::new(node(1)?, node(2)?, SectionId(0)));
                if words[0] == "p" {
                    model.supports.push(Support::clamped(node(2)?));
                }
            }
            _ => {}
        }
    }
    Ok(model)
}

/// Bend-Forming's tetrahedral truss of so many rings: two faces of triangles, each with the outline of a triangle of 3N + 1 struts
/// without three corners of N, and struts between them.
pub fn truss(rings: u32) -> Model {
    let side = 3 * rings + 1;
    let mut nodes = Vec::new();
    for row in 0..=side {
        for place in 0..=side - row {
            if row.max(place).max(side - row - place) <= side - rings {
                let (row, place, side) = (f64::from(row), f64::from(place), f64::from(side));
                let x = (place + row / 2.0 - side / 2.0) * STRUT;
                nodes.push(Point3::new(x, (row - side / 3.0) * STRUT * 0.75_f64.sqrt(), DEPTH / 2.0));
            }
        }
    }
    nodes.extend(nodes.clone().iter().map(|node| -node));
    let mut members = Vec::new();
    for b in 0..nodes.len() {
        let near = (0..b).filter(|&a| ((nodes[a] - nodes[b]).norm() - STRUT).abs() < 1e-6 * STRUT);
        members.extend(near.map(|a| Member::new(NodeId(a), NodeId(b), SectionId(0))));
    }
    Model { nodes, members, sections: vec![Section::round(0.9, &STEEL)], supports: Vec::new() }
}
