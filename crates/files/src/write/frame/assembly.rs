//! Assembly-instances JSON with the elements in the order in which they are built.

use std::collections::BTreeMap;

use serde_json::{Map, Value, json};
use wirebend_core::wireframe::{EdgeId, VertexId, Wireframe};

use crate::read::frame::{Fixities, FrameMaterial, FrameSection};

/// Standard gravity, m/s²: the format states a weight per volume.
const GRAVITY: f64 = 9.80665;

/// A strut as it is built.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BuiltMember {
    pub edge: EdgeId,
    /// The layer that it is built in, from 0.
    pub layer: i64,
}

/// Writes a frame, mm. Its elements stand in the order of `built`, with their layers; edges that are not in it come after, without one. A
/// support that `supports` does not name is held as the wireframe says. Material and section are for all elements.
#[must_use]
pub fn assembly_instances(
    wireframe: &Wireframe,
    built: &[BuiltMember],
    supports: &BTreeMap<VertexId, Fixities>,
    material: Option<&FrameMaterial>,
    section: Option<&FrameSection>,
) -> String {
    let mut numbers: BTreeMap<VertexId, usize> = BTreeMap::new();
    let mut nodes = Vec::new();
    for (number, (id, vertex)) in wireframe.vertices().enumerate() {
        numbers.insert(id, number);
        let held = supports.get(&id).copied().or(vertex.support.then(|| vertex.fixed()));
        let fixities: Vec<u8> = held.iter().flatten().map(|held| u8::from(*held)).collect();
        let at = vertex.position;
        nodes.push(json!({
            "point": { "X": at.x, "Y": at.y, "Z": at.z },
            "node_id": number,
            "is_grounded": u8::from(held.is_some()),
            "fixities": fixities,
        }));
    }
    let mut layers: BTreeMap<EdgeId, i64> = BTreeMap::new();
    let order = built.iter().filter(|member| layers.insert(member.edge, member.layer).is_none());
    let mut order: Vec<EdgeId> = order.map(|member| member.edge).collect();
    order.extend(wireframe.edges().map(|(id, _)| id).filter(|id| !layers.contains_key(id)));
    let elements = order.iter().filter_map(|id| Some((id, wireframe.edge(*id)?))).enumerate();
    let elements = elements.map(|(number, (id, edge))| {
        let mut element =
            json!({ "end_node_ids": [numbers[&edge.a], numbers[&edge.b]], "element_id": number });
        if let Some(layer) = layers.get(id) {
            element["layer_id"] = json!(layer);
        }
        element
    });
    let elements: Vec<Value> = elements.collect();
    let mut file = json!({
        "assembly_type": "extrusion",
        "model_type": "3D_frame",
        "unit": "millimeter",
        "dimension": 3,
        "node_num": nodes.len(),
        "element_num": elements.len(),
        "node_list": nodes,
        "element_list": elements,
    });
    if material.is_some() || section.is_some() {
        file["uniform_cross_section"] = json!(section.is_some());
        file["uniform_material_properties"] = json!(material.is_some());
        file["material_properties"] = Value::Object(properties(material, section));
    }
    format!("{file:#}\n")
}

fn properties(material: Option<&FrameMaterial>, section: Option<&FrameSection>) -> Map<String, Value> {
    let mut keys = Map::new();
    let mut figure = |key: &str, value: f64, unit: &str| {
        keys.insert(key.to_owned(), json!(value));
        keys.insert(format!("{key}_unit"), json!(unit));
    };
    if let Some(material) = material {
        figure("youngs_modulus", material.youngs_modulus_mpa / 10.0, "kN/cm2");
        figure("shear_modulus", material.shear_modulus_mpa / 10.0, "kN/cm2");
        figure("density", material.density_kg_per_m3 * GRAVITY / 1000.0, "kN/m3");
        if let Some(yields) = material.yield_strength_mpa {
            // As the published files spell it.
            figure("tensile_yeild_stress", yields / 10.0, "kN/cm2");
        }
    }
    if let Some(section) = section {
        figure("cross_sec_area", section.area_mm2 / 1e2, "centimeter^2");
        figure("Jx", section.j_mm4 / 1e4, "centimeter^4");
        figure("Iy", section.iy_mm4 / 1e4, "centimeter^4");
        figure("Iz", section.iz_mm4 / 1e4, "centimeter^4");
    }
    if let Some(material) = material {
        keys.insert("material_name".to_owned(), json!(material.name));
    }
    keys
}
