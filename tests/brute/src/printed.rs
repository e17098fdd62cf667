//! Designs as they are saved and sequences as they are printed, for machines and materials as FrameFab's authors have them.

use std::collections::BTreeMap;

use nalgebra::Vector3;
use serde_json::Value;

use crate::{Kind, Machine, Section, Step, Task, Vertex};

impl Task {
    /// A design of a `.wirebend` file, in ABS of 1.5 mm with FrameFab's extruder.
    ///
    /// # Panics
    /// Where it is no such design.
    #[must_use]
    pub fn framefab(design: &Value) -> Self {
        let list = |name: &str| design["wireframe"][name].as_array().expect("a list");
        let vertices = list("vertices").iter().map(|vertex| {
            let support = vertex.get("support").is_some_and(|support| support == true);
            let holds = |k: usize| support && vertex["free"][k] != true;
            let joint_g = vertex.get("joint").map_or(0.0, |joint| joint["mass_g"].as_f64().expect("a mass"));
            let at = triple(&vertex["at_mm"]).into();
            (number(&vertex["id"]), Vertex { at, support, fixed: [0, 1, 2, 3, 4, 5].map(holds), joint_g })
        });
        let edges =
            list("edges").iter().map(|edge| (number(&edge["id"]), ["a", "b"].map(|end| number(&edge[end]))));
        Self {
            vertices: vertices.collect::<BTreeMap<_, _>>(),
            edges: edges.collect(),
            section: Section { radius_mm: 0.75, e_mpa: 3457.0, g_mpa: 1294.0, density_t_mm3: 1210e-12 },
            gravity: Vector3::new(0.0, 0.0, -9806.65),
            machine: Machine {
                outline: vec![[0.0, 0.0], [20.0, 11.547], [120.0, 11.547]],
                places: false,
                max_create_deg: 60.0,
                max_connect_deg: 90.0,
                touch_mm: 0.1,
                clearance_mm: 0.0,
                ground_first: true,
                max_sag_mm: 0.65,
                workspace: None,
            },
        }
    }
}

impl Step {
    /// The steps of a sequence as `wirebend sequence --json` prints it.
    ///
    /// # Panics
    /// Where it is none.
    #[must_use]
    pub fn printed(sequence: &Value) -> Vec<Self> {
        let steps = sequence["steps"].as_array().expect("steps").iter().map(|step| {
            // A wire has lists of its own.
            let list = |name: &str| step.get(name).and_then(Value::as_array).cloned();
            let edges = list("edges").unwrap_or_else(|| vec![step["edge"].clone()]);
            let strut = serde_json::json!({ "vertex": step["from_vertex"], "direction": step["direction"] });
            let joints = list("joints").unwrap_or_else(|| vec![strut]);
            let kind = match step["type"].as_str() {
                Some("ground") => Kind::Ground,
                Some("create") => Kind::Create,
                Some("connect") => Kind::Connect,
                _ => panic!("no type: {step}"),
            };
            Self {
                edges: edges.iter().map(number).collect(),
                kind: Some(kind),
                joints: joints
                    .iter()
                    .map(|joint| (number(&joint["vertex"]), vec![triple(&joint["direction"]).into()]))
                    .collect(),
            }
        });
        steps.collect()
    }
}

fn number(value: &Value) -> u32 {
    value.as_u64().and_then(|number| number.try_into().ok()).unwrap_or_else(|| panic!("no number: {value}"))
}

fn triple(value: &Value) -> [f64; 3] {
    [0, 1, 2].map(|k| value[k].as_f64().unwrap_or_else(|| panic!("no point: {value}")))
}
