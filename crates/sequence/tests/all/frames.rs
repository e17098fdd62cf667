//! Frames that others built, and the head and the material with which they did.

use nalgebra::{Point3, Vector3};
use serde_json::Value;
use wirebend_collide::Head;
use wirebend_core::units::{Angle, Length};
use wirebend_core::wireframe::{Vertex, VertexId, Wireframe};
use wirebend_frame::{Material, Section};
use wirebend_sequence::{HeadDirections, Pace, Structure, StrutBuilder, Weight};

fn data(name: &str) -> String {
    // Benchmarks take this file, too.
    let inside = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let folders = inside.ancestors().map(|folder| folder.join("crates/files/tests/data"));
    let path = folders.into_iter().find(|folder| folder.is_dir()).unwrap().join(name);
    std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The bunny of FrameFab's authors: 91 nodes, 167 struts and 12 pillars on their feet. Edges: lines of struts, then pillars.
pub fn bunny() -> Wireframe {
    let text = data("framefab/bunny0507_.pwf");
    let of = |kind: &str| -> Vec<Vec<f64>> {
        let lines = text.lines().map(|line| line.split_whitespace().collect::<Vec<_>>());
        lines
            .filter(|words| words.first() == Some(&kind))
            .map(|words| words[1..].iter().map(|word| word.parse().unwrap()).collect())
            .collect()
    };
    // The format counts from 1.
    let vertex =
        |words: &[f64], k: usize| (0..1000).find(|id| f64::from(id + 1) >= words[k]).map(VertexId).unwrap();
    let feet: Vec<VertexId> = of("p").iter().map(|pillar| vertex(pillar, 1)).collect();
    let mut made = Wireframe::new();
    for (id, point) in (0..).map(VertexId).zip(of("v")) {
        let position = Point3::new(point[0], point[1], point[2]);
        made.add_vertex(Vertex { support: feet.contains(&id), ..Vertex::at(position) }).unwrap();
    }
    for ends in of("l").iter().chain(&of("p")) {
        made.add_edge(vertex(ends, 0), vertex(ends, 1)).unwrap();
    }
    assert_eq!((made.vertex_count(), made.edge_count()), (91, 179));
    made
}

/// A frame of the assembly instances by their authors.
pub fn assembly(name: &str) -> Wireframe {
    let file: Value = serde_json::from_str(&data(&format!("assembly-instances/{name}.json"))).unwrap();
    let mut made = Wireframe::new();
    for node in file["node_list"].as_array().unwrap() {
        let position = Point3::from(["X", "Y", "Z"].map(|axis| node["point"][axis].as_f64().unwrap()));
        let support = node["is_grounded"].as_i64().map_or(node["is_grounded"] == true, |there| there == 1);
        made.add_vertex(Vertex { support, ..Vertex::at(position) }).unwrap();
    }
    for element in file["element_list"].as_array().unwrap() {
        let end = |k: usize| VertexId(u32::try_from(element["end_node_ids"][k].as_u64().unwrap()).unwrap());
        made.add_edge(end(0), end(1)).unwrap();
    }
    made
}

/// A step of the sequence that FrameFab's authors published.
pub struct PublishedStep {
    pub from: Point3<f64>,
    pub to: Point3<f64>,
    pub kind: String,
    pub directions: Vec<[f64; 3]>,
}

pub fn published_bunny() -> Vec<PublishedStep> {
    let file: Value = serde_json::from_str(&data("framefab/bunny_result.json")).unwrap();
    let triple = |value: &Value| [0, 1, 2].map(|k| value[k].as_f64().unwrap());
    let steps = file["sequenced_elements"].as_array().unwrap().iter().map(|step| PublishedStep {
        from: Point3::from(triple(&step["start_pt"])),
        to: Point3::from(triple(&step["end_pt"])),
        kind: step["type"].as_str().unwrap().to_owned(),
        directions: step["feasible_orientation"].as_array().unwrap().iter().map(triple).collect(),
    });
    steps.collect()
}

/// FrameFab's head: a cone of 30° to each side of its axis, 20 mm high, then a cylinder of 100 mm.
pub const HEAD: [[f64; 2]; 3] = [[0.0, 0.0], [20.0, 11.547], [120.0, 11.547]];

/// FrameFab's machine: 182 directions, and joints that may be off by 0.65 mm.
pub fn builder() -> StrutBuilder {
    let (mm, deg) = (|mm| Length::from_mm(mm).unwrap(), |deg| Angle::from_deg(deg).unwrap());
    StrutBuilder {
        head: Head::new(&HEAD).unwrap(),
        places: false,
        directions: HeadDirections::each(deg(18.0)).unwrap(),
        max_create: deg(60.0),
        max_connect: deg(90.0),
        touch: mm(0.1),
        clearance: mm(0.0),
        ground_first: true,
        max_sag: mm(0.65),
        workspace: None,
        pace: Pace { build_mm_s: 10.0, travel_mm_s: 50.0, pause_s: 1.0 },
    }
}

/// Struts of ABS, 1.5 mm thick, under the gravity with which the reference figures were computed.
pub fn abs() -> Weight {
    let abs = Material { e: 3457.0, g: 1294.0, density: 1210e-12, yield_strength: 40.0 };
    Weight { section: Section::round(1.5, &abs), gravity: Vector3::new(0.0, 0.0, -9806.33) }
}

/// Both frames with a published or a computed sequence.
pub fn both() -> [(&'static str, Structure); 2] {
    [("bunny", bunny()), ("C_shape", assembly("C_shape"))]
        .map(|(name, frame)| (name, Structure::new(&frame).unwrap()))
}

/// A frame of points and struts between them. What is at height 0 is a support.
pub fn frame(points: &[[f64; 3]], edges: &[[u32; 2]]) -> Structure {
    let mut made = Wireframe::new();
    for point in points {
        let mut vertex = Vertex::at(Point3::from(*point));
        vertex.support = point[2] == 0.0;
        made.add_vertex(vertex).unwrap();
    }
    for [a, b] in edges {
        made.add_edge(VertexId(*a), VertexId(*b)).unwrap();
    }
    Structure::new(&made).unwrap()
}
