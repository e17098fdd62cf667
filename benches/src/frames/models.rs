//! Frames to be measured with.

use std::path::Path;

use anyhow::{Context, Result};
use nalgebra::{Point3, Vector3};
use wirebend_frame::{Material, Member, Model, NodeId, Pieces, Section, SectionId, Support};

use super::truss::{DEPTH, Truss};

/// FrameFab's ABS.
const ABS: Material = Material { e: 3457.0, g: 1294.0, density: 1.21e-9, yield_strength: 40.0 };
/// Frames on clamped feet.
pub fn standing() -> Result<Vec<(&'static str, Model)>> {
    let on_feet = |rings| {
        let mut model = truss(rings);
        model.supports = (0..3).map(|node| Support::clamped(NodeId(node))).collect();
        Pieces::new(&model, 4).model
    };
    Ok(vec![
        ("bunny", bunny()?),
        ("duck", duck()?),
        ("truss 5, 4 pieces", on_feet(5)),
        ("truss 10, 4 pieces", on_feet(10)),
    ])
}

/// FrameFab's bunny.
pub fn bunny() -> Result<Model> {
    read("crates/files/tests/data/framefab/bunny0507_.pwf")
}

/// Frames that were printed in the air, of 765 and of 909 struts.
pub fn fertility() -> Result<Model> {
    read("crates/frame/tests/data/fertility.txt")
}

pub fn duck() -> Result<Model> {
    read("crates/frame/tests/data/duck.txt")
}

/// Ducks in a row, apart from each other by 60 mm.
pub fn ducks(count: u32) -> Result<Model> {
    let one = duck()?;
    let x = one.nodes.iter().map(|node| node.x);
    let [low, high] = x.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)]);
    let mut all = Model { sections: one.sections.clone(), ..Model::default() };
    for k in 0..count {
        let first = all.nodes.len();
        let there = |node: NodeId| NodeId(first + node.0);
        let apart = Vector3::x() * (f64::from(k) * (high - low + 60.0));
        all.nodes.extend(one.nodes.iter().map(|node| node + apart));
        all.members.extend(one.members.iter().map(|member| Member {
            a: there(member.a),
            b: there(member.b),
            ..*member
        }));
        all.supports
            .extend(one.supports.iter().map(|support| Support { node: there(support.node), ..*support }));
    }
    Ok(all)
}

/// A pedestrian bridge, of 6427 struts.
pub fn bridge() -> Result<Model> {
    read("crates/frame/tests/data/bridge.txt")
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

/// Bend-Forming's tetrahedral truss of so many rings along the walk of its authors: a strut that is walked along twice is two members.
pub fn truss(rings: i32) -> Model {
    Truss::new(rings, DEPTH).locked(&format!("ring-{rings}"))
}
