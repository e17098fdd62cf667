//! Binary glTF 2.0 of lines in space, such as the bent wire: their surface, in metres with y up as the format wants it.

use nalgebra::Point3;
use serde_json::{Value, json};

use super::centreline::Centreline;
use super::tube::{Swept, Tube};

const FLOAT: u32 = 5126;
const UNSIGNED_INT: u32 = 5125;
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;
/// Drawn wire: a metal, and how rough.
const METAL: [f64; 2] = [1.0, 0.35];

/// A line whose surface is written.
pub(super) struct Line<'a> {
    pub name: String,
    /// mm, z up.
    pub points: &'a [Point3<f64>],
    pub tube: Tube,
}

/// Writes the surface of wires (mm, z up), each as a node of its own. Wires of less than two points are left out.
#[must_use]
pub fn glb(wires: &[Centreline], tube: Tube) -> Vec<u8> {
    let wires = wires.iter().enumerate();
    let lines = wires.map(|(k, wire)| Line { name: format!("wire {}", k + 1), points: &wire.points, tube });
    of_lines(lines)
}

/// Writes the surface of lines, each as a node of its own. Lines of less than two points are left out.
pub(super) fn of_lines<'a>(lines: impl Iterator<Item = Line<'a>>) -> Vec<u8> {
    let mut binary = Vec::new();
    let (mut nodes, mut meshes, mut accessors, mut views) = (vec![], vec![], vec![], vec![]);
    for line in lines.filter(|line| line.points.len() > 1) {
        let swept = Swept::new(line.points, line.tube);
        let points: Vec<[f32; 3]> = swept.points.iter().map(in_metres).collect();
        let indices: Vec<u32> = swept.faces().flat_map(|face| triangles(&face)).collect();
        let edge = |pick: fn(f32, f32) -> f32, from: f32| {
            points.iter().fold([from; 3], |edge, p| std::array::from_fn(|axis| pick(edge[axis], p[axis])))
        };
        nodes.push(json!({ "name": line.name, "mesh": meshes.len() }));
        let attributes = json!({ "POSITION": accessors.len() });
        let primitive = json!({ "attributes": attributes, "indices": accessors.len() + 1, "material": 0 });
        meshes.push(json!({ "primitives": [primitive] }));
        accessors.push(
            json!({ "bufferView": views.len(), "componentType": FLOAT, "type": "VEC3", "count": points.len(),
            "min": edge(f32::min, f32::INFINITY), "max": edge(f32::max, f32::NEG_INFINITY) }),
        );
        accessors
            .push(json!({ "bufferView": views.len() + 1, "componentType": UNSIGNED_INT, "type": "SCALAR",
            "count": indices.len() }));
        let (positions, corners) = (points.as_flattened(), &indices);
        views.push(view(&mut binary, positions.iter().flat_map(|c| c.to_le_bytes()), ARRAY_BUFFER));
        views.push(view(&mut binary, corners.iter().flat_map(|c| c.to_le_bytes()), ELEMENT_ARRAY_BUFFER));
    }
    let mut root = json!({ "asset": { "version": "2.0", "generator": "WireBend-kit" } });
    // The format has no empty lists.
    if !nodes.is_empty() {
        let [metallic, roughness] = METAL;
        root["scene"] = json!(0);
        root["scenes"] = json!([{ "nodes": (0..nodes.len()).collect::<Vec<_>>() }]);
        root["materials"] =
            json!([{ "pbrMetallicRoughness": { "metallicFactor": metallic, "roughnessFactor": roughness } }]);
        root["buffers"] = json!([{ "byteLength": binary.len() }]);
        for (name, list) in
            [("nodes", nodes), ("meshes", meshes), ("accessors", accessors), ("bufferViews", views)]
        {
            root[name] = Value::Array(list);
        }
    }
    container(root.to_string().into_bytes(), binary)
}

/// Metres, with y up: what was up was z.
#[allow(clippy::cast_possible_truncation)] // the format has single precision
fn in_metres(p: &Point3<f64>) -> [f32; 3] {
    [p.x, p.z, -p.y].map(|mm| (mm / 1000.0) as f32)
}

/// A convex face of three corners or more as a fan around its first.
fn triangles(face: &[usize]) -> Vec<u32> {
    let fan = face[1..].windows(2).flat_map(|pair| [face[0], pair[0], pair[1]]);
    fan.map(|corner| u32::try_from(corner).unwrap_or(u32::MAX)).collect()
}

fn view(binary: &mut Vec<u8>, bytes: impl Iterator<Item = u8>, target: u32) -> Value {
    let begin = binary.len();
    binary.extend(bytes);
    json!({ "buffer": 0, "byteOffset": begin, "byteLength": binary.len() - begin, "target": target })
}

/// A header and two chunks, each filled up to a multiple of four bytes.
fn container(mut text: Vec<u8>, mut binary: Vec<u8>) -> Vec<u8> {
    text.resize(text.len().next_multiple_of(4), b' ');
    binary.resize(binary.len().next_multiple_of(4), 0);
    let mut chunks = Vec::new();
    for (kind, chunk) in [(b"JSON", &text), (b"BIN\0", &binary)] {
        if !chunk.is_empty() {
            chunks.extend(length(chunk.len()));
            chunks.extend(kind);
            chunks.extend(chunk);
        }
    }
    let mut file = b"glTF".to_vec();
    file.extend(2_u32.to_le_bytes());
    file.extend(length(12 + chunks.len()));
    file.extend(chunks);
    file
}

fn length(bytes: usize) -> [u8; 4] {
    u32::try_from(bytes).unwrap_or(u32::MAX).to_le_bytes()
}
