//! conmech JSON: a frame, and its loads. Metres, kN.

use std::collections::BTreeMap;

use serde_json::{Value, json};
use wirebend_core::wireframe::{EdgeId, VertexId, Wireframe};

use crate::read::frame::{FrameFile, LoadCase};

/// Standard gravity, m/s²: the format states a weight per volume.
const GRAVITY: f64 = 9.80665;

/// Writes a frame as `frame` describes it, which holds no other vertices than that says. Its nodes are the vertices at which edges end, in
/// order of their ids and numbered from 0. Every element has a tag of its own, by which sections, materials and loads name it. An edge
/// without section or material gets none, which conmech refuses.
#[must_use]
pub fn conmech_frame(wireframe: &Wireframe, frame: &FrameFile, name: &str) -> String {
    let numbers = numbers(wireframe);
    let used = || wireframe.vertices().filter_map(|(id, vertex)| Some((id, vertex, *numbers.get(&id)?)));
    let nodes = used().map(|(id, vertex, number)| {
        let at = vertex.position;
        let metres = [at.x, at.y, at.z].map(|mm| mm / 1e3);
        json!({
            "point": metres,
            "node_ind": number,
            "is_grounded": frame.supports.contains_key(&id),
        })
    });
    let supports = used().filter_map(|(id, _, number)| {
        let condition = frame.supports.get(&id)?;
        Some(json!({ "condition": condition, "node_ind": number }))
    });
    let elements = wireframe.edges().enumerate().map(|(k, (id, edge))| {
        let layer = frame.members.get(&id).and_then(|member| member.layer);
        json!({
            "end_node_inds": [numbers[&edge.a], numbers[&edge.b]],
            "elem_tag": tag(id),
            "elem_ind": k,
            "layer_ind": layer.unwrap_or(-1),
            "bending_stiff": true,
        })
    });
    let tags = |place: &dyn Fn(EdgeId) -> bool| -> Vec<String> {
        wireframe.edges().filter(|(id, _)| place(*id)).map(|(id, _)| tag(id)).collect()
    };
    let of = |id: EdgeId| frame.members.get(&id);
    let sections = frame.sections.iter().enumerate().map(|(k, section)| {
        let named = tags(&|id| of(id).is_some_and(|member| member.section == Some(k)));
        json!({
            "family": "custom",
            "name": format!("section {k}"),
            "elem_tags": named,
            "A": section.area_mm2 / 1e6, "A_unit": "m2",
            "Jx": section.j_mm4 / 1e12, "Jx_unit": "m4",
            "Iy": section.iy_mm4 / 1e12, "Iy_unit": "m4",
            "Iz": section.iz_mm4 / 1e12, "Iz_unit": "m4",
        })
    });
    let materials = frame.materials.iter().enumerate().map(|(k, material)| {
        let named = tags(&|id| of(id).is_some_and(|member| member.material == Some(k)));
        let mut value = json!({
            "family": "custom",
            "name": material.name,
            "type_name": "ISO",
            "elem_tags": named,
            "E": material.youngs_modulus_mpa * 1e3, "E_unit": "kN/m2",
            "G12": material.shear_modulus_mpa * 1e3, "G12_unit": "kN/m2",
            "density": material.density_kg_per_m3 * GRAVITY / 1e3, "density_unit": "kN/m3",
        });
        if let Some(yields) = material.yield_strength_mpa {
            value["fy"] = json!(yields * 1e3);
            value["fy_unit"] = json!("kN/m2");
        }
        value
    });
    // Without elements a list of tags would be empty, which means all of them.
    let used = |value: &Value| value["elem_tags"].as_array().is_some_and(|tags| !tags.is_empty());
    let file = json!({
        "model_name": name,
        "unit": "meter",
        "node_num": numbers.len(),
        "element_num": wireframe.edge_count(),
        "nodes": nodes.collect::<Vec<_>>(),
        "elements": elements.collect::<Vec<_>>(),
        "supports": supports.collect::<Vec<_>>(),
        "joints": [],
        "cross_secs": sections.filter(used).collect::<Vec<_>>(),
        "materials": materials.filter(used).collect::<Vec<_>>(),
    });
    format!("{file:#}\n")
}

/// Writes load cases for the file that [`conmech_frame`] makes of the same wireframe.
#[must_use]
pub fn conmech_loads(wireframe: &Wireframe, cases: &[LoadCase]) -> String {
    let numbers = numbers(wireframe);
    let case = |case: &LoadCase| {
        let nodal = case.nodal.iter().filter_map(|load| {
            let node = numbers.get(&load.vertex)?;
            let (force, moment) = (load.force_n.map(|n| n / 1e3), load.moment_n_mm.map(|n_mm| n_mm / 1e6));
            Some(json!({
                "force": force, "force_unit": "kN",
                "moment": moment, "moment_unit": "kNm",
                "node_ind": node,
            }))
        });
        let line = case.line.iter().map(|load| {
            json!({
                "q": load.n_per_mm, "q_unit": "kN/m", "load": load.n_per_mm,
                "elem_tags": [tag(load.edge)],
            })
        });
        let mut value = json!({ "ploads": nodal.collect::<Vec<_>>(), "eloads": line.collect::<Vec<_>>() });
        if let Some(gravity) = case.gravity {
            value["gravity"] = json!({ "force": gravity, "force_unit": "kN" });
        }
        (case.name.clone(), value)
    };
    let cases: serde_json::Map<String, Value> = cases.iter().map(case).collect();
    format!("{:#}\n", json!({ "loadcases": cases }))
}

/// The numbers of the vertices at which edges end: another node would be free to move without any force.
fn numbers(wireframe: &Wireframe) -> BTreeMap<VertexId, usize> {
    let used = wireframe.vertices().map(|(id, _)| id).filter(|id| !wireframe.incident(*id).is_empty());
    used.enumerate().map(|(number, id)| (id, number)).collect()
}

fn tag(edge: EdgeId) -> String {
    format!("e{edge}")
}
