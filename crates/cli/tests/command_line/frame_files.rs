//! The files that `frame` writes for other programs, read back.

use std::collections::BTreeMap;
use std::path::Path;

use serde_json::{Value, json};

use crate::{example, root, run_in};

/// A file that a reader is tested with.
fn data(name: &str) -> String {
    root().join("crates/files/tests/data").join(name).display().to_string()
}

/// `ParaView` opens the file; a table has a row for each vertex and each strut.
#[test]
fn results_are_written_for_other_programs() {
    let folder = tempfile::tempdir().unwrap();
    let bunny = data("framefab/bunny0507_.pwf");
    let arguments = ["frame", &bunny, "--material", "abs-1-5mm", "--vtk", "bunny.vtk", "--csv", "bunny.csv"];
    run_in(folder.path(), &arguments, b"").ended(0);
    let read = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap();
    assert!(read("bunny.vtk").starts_with("# vtk DataFile Version "));
    // The heading, and 179 struts.
    assert_eq!(read("bunny-members.csv").lines().filter(|line| !line.starts_with('#')).count(), 180);
    assert_eq!(read("bunny-nodes.csv").lines().filter(|line| !line.starts_with('#')).count(), 92);
    let again = run_in(folder.path(), &arguments, b"").ended(2).err;
    assert!(again.contains("exists already"), "{again}");
    let files = ["--supports", "free", "--force", "--conmech", "free.json", "--glb", "free.glb"];
    let said = run_in(folder.path(), &[&arguments[..], &files].concat(), b"").ended(0).err;
    assert!(said.contains("no file of the loaded frame is written"), "{said}");
    assert!(!folder.path().join("free.json").exists() && !folder.path().join("free.glb").exists());
}

/// A sequence as the frame that it builds, each strut with its step; sags and stresses are those of `frame`.
#[test]
fn a_sequence_is_written_with_the_step_of_each_strut() {
    let folder = tempfile::tempdir().unwrap();
    let frame = data("assembly-instances/simple_frame.json");
    let material = ["--material", "abs-1-5mm", "--json"];
    let build = ["sequence", &frame, "--machine", "framefab-extruder", "-o", "built.vtk", "-f", "vtk"];
    let found = run_in(folder.path(), &[&build[..], &material].concat(), b"").ended(0).json();
    run_in(folder.path(), &[&["frame", &frame, "--vtk", "frame.vtk"], &material[..]].concat(), b"").ended(0);
    let read = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap();
    let built = read("built.vtk");
    let (before, steps) = built.split_once("SCALARS step int 1\nLOOKUP_TABLE default\n").unwrap();
    assert_eq!(before, read("frame.vtk"));
    let steps: Vec<usize> = steps.lines().map(|step| step.parse().unwrap()).collect();
    for (step, found) in found["steps"].as_array().unwrap().iter().enumerate() {
        assert_eq!(steps[usize::try_from(found["edge"].as_u64().unwrap()).unwrap()], step + 1);
    }
}

/// Numbers of nodes need not follow each other.
#[test]
fn numbers_of_nodes_may_have_gaps() {
    let folder = tempfile::tempdir().unwrap();
    let four = data("conmech/four-frame.json");
    let mut frame: Value = serde_json::from_slice(&std::fs::read(&four).unwrap()).unwrap();
    let other = |number: &mut Value| *number = json!(number.as_u64().unwrap() * 7 + 3);
    for node in frame["nodes"].as_array_mut().unwrap() {
        other(&mut node["node_ind"]);
    }
    for element in frame["elements"].as_array_mut().unwrap() {
        element["end_node_inds"].as_array_mut().unwrap().iter_mut().for_each(other);
    }
    for support in frame["supports"].as_array_mut().unwrap() {
        other(&mut support["node_ind"]);
    }
    std::fs::write(folder.path().join("gaps.json"), frame.to_string()).unwrap();
    let sag = |file: &str| {
        let found = run_in(folder.path(), &["frame", file, "--json"], b"").ended(0).json();
        found["static"]["max_displacement_mm"].as_f64().unwrap()
    };
    assert!((sag("gaps.json") / sag(&four) - 1.0).abs() < 1e-12);
    // PyNite 3.2.0.
    assert!((sag("gaps.json") / 1.0669e-5 - 1.0).abs() < 1e-4);
}

/// A vertex as a table has it: where it is, how far it moves, and how far it turns.
type Node = [f64; 9];

/// The vertices at which struts end, in order of id.
fn nodes(folder: &Path, arguments: &[&str]) -> Vec<Node> {
    run_in(folder, &[arguments, &["--csv", "table.csv", "--force"]].concat(), b"").ended(0);
    let table = std::fs::read_to_string(folder.join("table-nodes.csv")).unwrap();
    let rows = table.lines().skip(1).map(|row| {
        let figures: Vec<f64> = row.split(',').skip(1).map(|figure| figure.parse().unwrap()).collect();
        figures[..9].try_into().unwrap()
    });
    rows.collect()
}

fn near(a: &[f64], b: &[f64], by: f64) -> bool {
    a.iter().zip(b).all(|(a, b)| (a - b).abs() <= by)
}

/// A design whose joints weigh something, and one of whose vertices has no strut.
pub(crate) fn jointed(folder: &Path) -> String {
    let lines = "v 0 0 0\nv 9 9 9\nv 0 60 0\nv 0 0 80\nv 0 60 80\nv 50 30 80\nl 1 4\nl 3 5\nl 4 5 6 4\n";
    std::fs::write(folder.join("jointed.obj"), lines).unwrap();
    run_in(folder, &["import", "jointed.obj", "--units", "mm", "-o", "jointed.wirebend"], b"").ended(0);
    let path = folder.join("jointed.wirebend");
    let mut design: Value = serde_json::from_slice(&std::fs::read(&path).unwrap()).unwrap();
    let vertices = design["wireframe"]["vertices"].as_array_mut().unwrap();
    for vertex in vertices {
        let at: Vec<f64> = serde_json::from_value(vertex["at_mm"].clone()).unwrap();
        if at[2] == 0.0 {
            vertex["support"] = json!(true);
        } else {
            vertex["joint"] = json!({ "kind": "snap-fit", "mass_g": 1.5 + at[0] / 10.0 });
        }
    }
    design["wireframe"]["vertices"].as_array_mut().unwrap().push(json!({ "id": 90, "at_mm": [5, 5, 5] }));
    design["wireframe"]["next_vertex"] = json!(91);
    std::fs::write(&path, design.to_string()).unwrap();
    path.display().to_string()
}

/// Supports, sections, materials and loads are in the files, and so it moves as it did.
#[test]
fn a_frame_written_for_conmech_moves_as_it_did() {
    let folder = tempfile::tempdir().unwrap();
    let loads = data("conmech/uniform_load_analytical_model_loads.json");
    let (analytic, four) =
        (data("conmech/uniform_load_analytical_model.json"), data("conmech/four-frame.json"));
    let own = data("conmech/four-frame_loads.json");
    let (bunny, shape) = (data("framefab/bunny0507_.pwf"), data("assembly-instances/C_shape.json"));
    let (simple, jointed) = (data("assembly-instances/simple_frame.json"), jointed(folder.path()));
    let abs = ["--material", "abs-1-5mm"];
    let cases: [(&str, &[&str]); 7] = [
        (&bunny, &abs),
        (&shape, &["--material", "abs-1-5mm", "--gravity", "0.3,-0.2,-1"]),
        (&simple, &["--supports", "0,3,5"]),
        (&four, &[]),
        (&analytic, &["--loads", &loads]),
        (&four, &["--loads", &own, "--gravity", "0,0.5,-1", "--material", "steel-0-9mm"]),
        (&jointed, &abs),
    ];
    for (file, rest) in cases {
        let arguments = [&["frame", file], rest].concat();
        let written = [&arguments[..], &["--conmech", "out.json", "--force", "--json"]].concat();
        let found = run_in(folder.path(), &written, b"").json();
        let weighed =
            found["notes"].as_array().unwrap().iter().find(|note| note["code"] == "joints-as-forces");
        assert_eq!(weighed.map(|note| &note["count"]), (file == jointed).then_some(&json!(3)));
        // Without a material of its own, and without the loads again.
        let again = nodes(folder.path(), &["frame", "out.json", "--loads", "out-loads.json"]);
        let mut before = nodes(folder.path(), &arguments);
        if file == jointed {
            assert_eq!(before.pop().map(|node| node[0]), Some(5.0), "the vertex without struts");
        }
        assert_eq!(again.len(), before.len(), "{file}");
        let most = before.iter().flat_map(|node| &node[3..6]).fold(0.0, |most: f64, u| most.max(u.abs()));
        assert!(most > 0.0, "{file}");
        for (again, before) in again.iter().zip(&before) {
            assert!(near(&again[..3], &before[..3], 1e-9), "{file}: {again:?} {before:?}");
            assert!(near(&again[3..], &before[3..], 1e-9 * most), "{file}: {again:?} {before:?}");
        }
    }
}

/// Of each edge the middle of its first ring of corners and of its last one, mm.
fn ends_of_tubes(file: &[u8]) -> BTreeMap<String, [[f64; 3]; 2]> {
    let length = |at: usize| u32::from_le_bytes(file[at..at + 4].try_into().unwrap()) as usize;
    let json: Value = serde_json::from_slice(&file[20..20 + length(12)]).unwrap();
    let binary = &file[20 + length(12) + 8..];
    let nodes = json["nodes"].as_array().unwrap().iter();
    let tubes = nodes.map(|node| {
        let of =
            |list: &str, index: &Value| json[list][usize::try_from(index.as_u64().unwrap()).unwrap()].clone();
        let mesh = of("meshes", &node["mesh"]);
        let accessor = of("accessors", &mesh["primitives"][0]["attributes"]["POSITION"]);
        let offset = of("bufferViews", &accessor["bufferView"])["byteOffset"].as_u64().unwrap();
        let count = usize::try_from(accessor["count"].as_u64().unwrap()).unwrap();
        // A ring has 12 corners; the format is in metres with y up.
        let middle = |first: usize| {
            let mut sum = [0.0; 3];
            for corner in first..first + 12 {
                let part = |axis: usize| {
                    let at = usize::try_from(offset).unwrap() + 12 * corner + 4 * axis;
                    f64::from(f32::from_le_bytes(binary[at..at + 4].try_into().unwrap())) * 1000.0 / 12.0
                };
                let (x, y, z) = (part(0), part(1), part(2));
                sum = [sum[0] + x, sum[1] - z, sum[2] + y];
            }
            sum
        };
        (node["name"].as_str().unwrap().to_owned(), [middle(0), middle(count - 12)])
    });
    tubes.collect()
}

/// The ends of each strut are where its vertices have moved to, at true scale and enlarged.
#[test]
fn the_deformed_shape_ends_where_vertices_move_to() {
    let folder = tempfile::tempdir().unwrap();
    let bunny = ["frame", &data("framefab/bunny0507_.pwf"), "--material", "abs-1-5mm"];
    let nodes = nodes(folder.path(), &bunny);
    let members = std::fs::read_to_string(folder.path().join("table-members.csv")).unwrap();
    for (scale, rest) in [(1.0, &[][..]), (40.0, &["--displacement-scale", "40"])] {
        let arguments = [&bunny[..], &["--glb", "bunny.glb", "--force"], rest].concat();
        run_in(folder.path(), &arguments, b"").ended(0);
        let tubes = ends_of_tubes(&std::fs::read(folder.path().join("bunny.glb")).unwrap());
        assert_eq!(tubes.len(), 179);
        for row in members.lines().skip(1) {
            let numbers: Vec<&str> = row.split(',').take(3).collect();
            let ends = tubes[&format!("edge {}", numbers[0])];
            for (end, vertex) in ends.iter().zip(&numbers[1..]) {
                let node = &nodes[vertex.parse::<usize>().unwrap()];
                let moved: Vec<f64> = (0..3).map(|axis| node[axis] + scale * node[3 + axis]).collect();
                // Single precision of a metre.
                assert!(near(end, &moved, 5e-5), "{row}: {end:?} {moved:?}");
            }
        }
        // The program itself reads it, and as a surface.
        let stencil = ["import", "bunny.glb", "-o", "bunny.wirebend", "--force", "--json"];
        run_in(folder.path(), &stencil, b"").ended(0);
    }
}

#[test]
fn what_a_model_cannot_carry_is_named() {
    let folder = tempfile::tempdir().unwrap();
    // Its beams are no round wire: 4000 mm² and 5e7 mm⁴.
    let beams =
        ["frame", &data("conmech/uniform_load_analytical_model.json"), "--glb", "beams.glb", "--json"];
    let found = run_in(folder.path(), &beams, b"").ended(0).json();
    let drawn = found["notes"].as_array().unwrap().iter().find(|note| note["code"] == "drawn-round").unwrap();
    assert_eq!(drawn["count"], 2);
    // conmech asks for a yield strength, which this copy does not state.
    let text = std::fs::read_to_string(data("conmech/four-frame.json")).unwrap();
    let mut frame: Value = serde_json::from_str(&text).unwrap();
    for material in frame["materials"].as_array_mut().unwrap() {
        material.as_object_mut().unwrap().retain(|key, _| !key.starts_with("fy"));
    }
    std::fs::write(folder.path().join("soft.json"), frame.to_string()).unwrap();
    let soft = ["frame", "soft.json", "--conmech", "again.json"];
    let said = run_in(folder.path(), &soft, b"").ended(0).err;
    assert!(said.contains("asks for a yield strength (fy), and that of 4 edges is not known"), "{said}");
    let house = example("house.obj");
    let house = ["frame", &house, "--units", "mm", "--material", "abs-1-5mm", "--supports", "0,1,2,3"];
    let refused = |rest: &[&str]| run_in(folder.path(), &[&house[..], rest].concat(), b"").ended(2).err;
    assert!(refused(&["--displacement-scale", "3"]).contains("--glb"));
    assert!(refused(&["--glb", "a.glb", "--displacement-scale", "inf"]).contains("1 is true scale"));
    for option in ["--glb", "--conmech"] {
        assert!(refused(&[option, "-"]).contains("results go to files"));
    }
    // Neither of two files is replaced unasked.
    std::fs::write(folder.path().join("house-loads.json"), "{}").unwrap();
    assert!(refused(&["--conmech", "house.json"]).contains("house-loads.json"));
    assert!(!folder.path().join("house.json").exists());
}

/// The strut that bears the most is not the one that is nearest to what it can bear, where they are of different materials.
#[test]
fn each_stress_has_the_share_of_its_own_strut() {
    let folder = tempfile::tempdir().unwrap();
    let text = std::fs::read_to_string(data("conmech/four-frame.json")).unwrap();
    let mut file: Value = serde_json::from_str(&text).unwrap();
    // A pillar of steel that yields at 10 times the stress of the PLA of the others.
    file["elements"][0]["elem_tag"] = "steel".into();
    file["materials"][0]["elem_tags"] = serde_json::json!(["", "pla"]);
    file["materials"][1]["elem_tags"] = serde_json::json!(["steel"]);
    file["materials"][1]["fy"] = 2_350_000.0.into();
    std::fs::write(folder.path().join("mixed.json"), file.to_string()).unwrap();
    let members = |more: &[&str]| {
        let asked = ["frame", "mixed.json", "--gravity", "0,1,-1"];
        run_in(folder.path(), &[&asked[..], more].concat(), b"").ended(0)
    };
    let found = members(&["--json"]).json();
    let figures: Vec<[f64; 2]> = found["static"]["members"]
        .as_array()
        .unwrap()
        .iter()
        .map(|member| ["von_mises_mpa", "utilisation"].map(|key| member[key].as_f64().unwrap()))
        .collect();
    let most =
        |of: usize| (0..figures.len()).max_by(|a, b| figures[*a][of].total_cmp(&figures[*b][of])).unwrap();
    let [stressed, used] = [most(0), most(1)];
    assert_ne!(stressed, used, "{figures:?}");
    let shown = members(&[]).err;
    let share = |edge: usize| format!("{:.1} % of what yields", 100.0 * figures[edge][1]);
    for expected in [
        format!("{:.3} MPa in edge {stressed}, {}", figures[stressed][0], share(stressed)),
        format!("nearest to yield   edge {used}, {}", share(used)),
    ] {
        assert!(shown.contains(&expected), "{expected}: {shown}");
    }
}
