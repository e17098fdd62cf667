//! Files of frames: what they say beside their struts, and what is refused of them.

use std::f64::consts::PI;

use serde_json::{Value, json};
use wirebend_core::units::Length;
use wirebend_core::wireframe::{EdgeId, VertexId};
use wirebend_files::read::frame::{
    FrameFile, LineLoad, NodalLoad, StrutKind, StrutMatchError, read_loads, read_sequence,
};
use wirebend_files::read::{Format, Imported, ReadError, ReadOptions, read};

use crate::formats::{data, import, import_data, mm};

fn frame(name: &str) -> (Imported, FrameFile) {
    let imported = import_data(name, &ReadOptions::default());
    let frame = imported.frame.as_deref().unwrap().clone();
    (imported, frame)
}

fn near(found: f64, expected: f64) {
    assert!((found - expected).abs() <= 1e-9 * expected.abs(), "{found} is not {expected}");
}

fn refused(result: Result<impl std::fmt::Debug, ReadError>) -> String {
    let error = result.unwrap_err();
    format!("{}: {error}", error.code())
}

/// The published frames state E 3500 and G 2400 N/mm² beside a Poisson's ratio of -0.27; struts are round, of radius 1.5 mm.
#[test]
fn an_assembly_states_its_material_and_its_section() {
    for name in ["four-frame", "simple_frame", "C_shape"] {
        let (imported, frame) = frame(&format!("assembly-instances/{name}.json"));
        let [material] = frame.materials.as_slice() else { panic!("one material") };
        assert_eq!(material.name, "PLA");
        near(material.youngs_modulus_mpa, 3500.0);
        near(material.shear_modulus_mpa, 2400.0);
        near(material.yield_strength_mpa.unwrap(), 36.0);
        assert!(
            (material.density_kg_per_m3 - 12_258.2 / 9.80665).abs() < 1e-9,
            "{}",
            material.density_kg_per_m3
        );
        let [section] = frame.sections.as_slice() else { panic!("one section") };
        near(section.round_radius_mm().unwrap(), 1.5);
        near(section.area_mm2, PI * 1.5 * 1.5);
        assert_eq!(frame.members.len(), imported.wireframe.edge_count());
        assert!(frame.members.values().all(|member| (member.section, member.material) == (Some(0), Some(0))));
        assert!(frame.supports.values().all(|held| *held == [true; 6]));
        let supports = imported.wireframe.vertices().filter(|(_, vertex)| vertex.support);
        assert!(supports.map(|(id, _)| id).eq(frame.supports.keys().copied()), "{name}");
    }
    let (_, simple) = frame("assembly-instances/simple_frame.json");
    let layers: std::collections::BTreeSet<i64> =
        simple.members.values().filter_map(|one| one.layer).collect();
    assert!(layers.len() > 1 && layers.contains(&0), "{layers:?}");
}

/// A dialect numbers its nodes by their places and says true for 1; a support may hold some directions alone.
#[test]
fn an_assembly_may_be_of_either_dialect() {
    let node = |x: f64, more: Value| {
        let mut node = json!({"point": {"X": x, "Y": 0.0, "Z": 0.0}});
        node.as_object_mut().unwrap().extend(more.as_object().unwrap().clone());
        node
    };
    let assembly = |nodes: Vec<Value>| {
        json!({"unit": "cm", "node_list": nodes, "element_list": [{"end_node_ids": [0, 1]}]}).to_string()
    };
    let text = assembly(vec![
        node(0.0, json!({"is_grounded": true})),
        node(1.0, json!({"is_grounded": false, "fixities": [0, 0, 1, 0, 0, 0]})),
    ]);
    let imported = import("a.json", &text).unwrap();
    let frame = imported.frame.unwrap();
    let held = [[true; 6], [false, false, true, false, false, false]];
    assert_eq!(frame.supports.values().copied().collect::<Vec<_>>(), held);
    // The design itself has it, too.
    assert_eq!(imported.wireframe.vertices().map(|(_, vertex)| vertex.fixed()).collect::<Vec<_>>(), held);
    assert!(frame.materials.is_empty() && frame.sections.is_empty());
    assert!((imported.wireframe.total_length().mm() - 10.0).abs() < 1e-12);
    // What is said to hold nothing is no support.
    let text = assembly(vec![
        node(0.0, json!({"is_grounded": 1, "fixities": [0, 0, 0, 0, 0, 0]})),
        node(1.0, json!({"is_grounded": 1, "fixities": []})),
    ]);
    let imported = import("a.json", &text).unwrap();
    assert_eq!(imported.frame.unwrap().supports.into_iter().collect::<Vec<_>>(), [(VertexId(1), [true; 6])]);
    let supports = imported.wireframe.vertices().filter(|(_, vertex)| vertex.support).map(|(id, _)| id);
    assert_eq!(supports.collect::<Vec<_>>(), [VertexId(1)]);
    let text = assembly(vec![node(0.0, json!({"fixities": [1, 1, 1]})), node(1.0, json!({}))]);
    assert_eq!(
        refused(import("a.json", &text)),
        "read-syntax: a.json, node 0: found \"3 fixities\", expected six fixities, or none"
    );
    let mut wrong: Value = serde_json::from_slice(&data("assembly-instances/four-frame.json").0).unwrap();
    wrong["material_properties"]["youngs_modulus_unit"] = json!("psi");
    let text = refused(import("a.json", wrong.to_string()));
    assert!(text.contains("found \"psi\", expected one of the units kN/m2, kN/cm2"), "{text}");
    wrong["material_properties"]["youngs_modulus_unit"] = json!(null);
    assert_eq!(
        refused(import("a.json", wrong.to_string())),
        "read-syntax: a.json, material_properties 0: found \"youngs_modulus without a unit\", expected youngs_modulus_unit beside it"
    );
    wrong["material_properties"]["youngs_modulus_unit"] = json!("MPa");
    wrong["material_properties"]["youngs_modulus"] = json!(0);
    let text = refused(import("a.json", wrong.to_string()));
    assert!(text.contains("found \"0\", expected a figure above 0"), "{text}");
}

/// Programs write all of a frame on one line: the line alone does not lead to what is wrong.
#[test]
fn what_is_wrong_in_a_json_file_is_found_by_its_entry() {
    let nodes = r#"[{"point": {"X": 0, "Y": 0, "Z": 0}}, {"point": {"X": 9, "Y": 0, "Z": 0}}]"#;
    let assembly =
        |elements: &str| format!(r#"{{"unit": "cm", "node_list": {nodes}, "element_list": {elements}}}"#);
    assert_eq!(
        refused(import("a.json", assembly(r#"[{"end_node_ids": [0, 1]}, {"layer_id": 2}]"#))),
        "read-syntax: a.json, line 1, element_list[1]: found missing field `end_node_ids`, expected an object with node_list and element_list"
    );
    let text = refused(import("a.json", assembly("[]").replace("\"Z\": 0}}]", "\"Z\": \"low\"}}]")));
    assert!(
        text.contains("a.json, line 1, node_list[1].point.Z: found invalid type: string \"low\""),
        "{text}"
    );
    let text = refused(import("a.json", assembly("[]").replace("\"X\": 9", "\"X\": NaN")));
    assert!(text.contains("a.json, line 1, node_list[1].point.X: found expected value"), "{text}");
    let text = refused(import("a.json", format!("{}\n }}", assembly("[]"))));
    assert!(text.contains("a.json, line 2: found trailing characters"), "{text}");
}

#[test]
fn a_conmech_frame_is_in_metres_and_kilonewtons() {
    let (imported, frame) = frame("conmech/uniform_load_analytical_model.json");
    assert_eq!(imported.format, Format::Conmech);
    let at = |id| imported.wireframe.vertex(VertexId(id)).unwrap().position;
    assert_eq!((at(1).x, at(2).y), (5000.0, 8000.0));
    assert_eq!(frame.supports.keys().map(|id| id.0).collect::<Vec<_>>(), [0, 2]);
    let member = |id| &frame.members[&EdgeId(id)];
    let of = |id: u32| {
        let member = member(id);
        (&frame.sections[member.section.unwrap()], &frame.materials[member.material.unwrap()])
    };
    assert_eq!((&*member(0).tag, &*member(1).tag, member(0).layer), ("ab", "bc", None));
    let (ab, steel) = of(0);
    near(ab.area_mm2, 4000.0);
    near(ab.iy_mm4, 5e7);
    near(ab.j_mm4, 1e5);
    assert_eq!(ab.round_radius_mm(), None, "an I beam is not round");
    near(of(1).0.iy_mm4, 2e8);
    near(steel.youngs_modulus_mpa, 200_000.0);
    near(steel.shear_modulus_mpa, 76_923.076_923_076_93);
    near(steel.density_kg_per_m3, 78_500.0 / 9.80665);
}

/// `[""]` is for elements without a tag, before the entry for all.
#[test]
fn entries_of_a_conmech_frame_are_for_their_tags() {
    let (_, frame) = frame("conmech/four-frame.json");
    for member in frame.members.values() {
        assert_eq!(frame.materials[member.material.unwrap()].name, "PLA");
        near(frame.sections[member.section.unwrap()].round_radius_mm().unwrap(), 1.5);
    }
    let mut model: Value = serde_json::from_slice(&data("conmech/four-frame.json").0).unwrap();
    model["materials"][1]["elem_tags"] = json!([""]);
    assert_eq!(
        refused(import("a.json", model.to_string())),
        "read-syntax: a.json, material 1: found \"another material for the tag \"\"\", expected one material for each tag; material 0 is for it"
    );
}

/// Entries of one node hold it together; a condition that holds nothing is no support, and a node that is grounded is one where no entry
/// says how.
#[test]
fn a_conmech_node_is_held_as_all_of_its_entries_say() {
    let mut model: Value = serde_json::from_slice(&data("conmech/four-frame.json").0).unwrap();
    let entry = |node: i64, held: [bool; 6]| json!({"condition": held, "node_ind": node});
    let [along_z, about_x] = [2, 3].map(|axis| std::array::from_fn(|k| k == axis));
    model["supports"] = json!([entry(0, along_z), entry(1, [false; 6]), entry(0, about_x)]);
    model["nodes"][1]["is_grounded"] = json!(true);
    let imported = import("a.json", model.to_string()).unwrap();
    let supports = imported.frame.unwrap().supports;
    let held = [false, false, true, true, false, false];
    assert_eq!(
        supports.into_iter().collect::<Vec<_>>(),
        [(VertexId(0), held), (VertexId(2), [true; 6])],
        "node 1 says that nothing holds it, node 2 is grounded and says no more"
    );
}

/// What is made wrong in a model.
type Change<'a> = &'a dyn Fn(&mut Value);

#[test]
fn what_a_conmech_frame_has_that_is_not_computed_is_refused_by_name() {
    let model: Value = serde_json::from_slice(&data("conmech/four-frame.json").0).unwrap();
    let with = |change: Change<'_>| {
        let mut model = model.clone();
        change(&mut model);
        refused(import("a.json", model.to_string()))
    };
    let released = json!([{"c_conditions": [null, 0.0, null], "elem_tags": ["a"]}]);
    let cases: [(&str, Change<'_>); 9] = [
        ("a.json, material 0: found \"fy without a unit\", expected fy_unit beside it", &|model| {
            model["materials"][0]["fy"] = json!(36.0);
            model["materials"][0]["fy_unit"] = json!(null);
        }),
        ("a.json, joint 0: a release at the end of an element (c_conditions) is not read", &|model| {
            model["joints"] = released.clone();
        }),
        ("a.json, element 2: an element that does not bend (bending_stiff false) is not read", &|model| {
            model["elements"][2]["bending_stiff"] = json!(false);
        }),
        ("a.json, element 1: found \"3 ends\", expected two end_node_inds", &|model| {
            model["elements"][1]["end_node_inds"] = json!([0, 1, 2]);
        }),
        ("a.json, element 0: 9 names no node: there are 5", &|model| {
            model["elements"][0]["end_node_inds"] = json!([0, 9]);
        }),
        ("a.json, support 0: 7 names no node: there are 5", &|model| {
            model["supports"][0]["node_ind"] = json!(7);
        }),
        (
            "a.json, support 1: found \"5 entries in the condition of node 1\", expected six: which displacements along x, y, z and \
             rotations about them are held",
            &|model| {
                let supports = json!([{"condition": ([true; 6]), "node_ind": 0}, {"condition": ([true; 5]), "node_ind": 1}]);
                model["supports"] = supports;
            },
        ),
        ("a.json, node 1: found \"node_ind 0 again\", expected another node_ind", &|model| {
            model["nodes"][1]["node_ind"] = json!(0);
        }),
        ("a.json: found \"furlong\", expected a unit: meter, centimeter, millimeter or inch", &|model| {
            model["unit"] = json!("furlong");
        }),
    ];
    for (expected, change) in cases {
        let text = with(change);
        assert!(text.ends_with(expected), "{text}");
    }
    let unreleased = json!([{"c_conditions": [null, null], "elem_tags": ["a"]}]);
    let mut model = model.clone();
    model["joints"] = unreleased;
    import("a.json", model.to_string()).unwrap();
}

#[test]
fn loads_are_at_nodes_and_along_tagged_elements() {
    let (imported, frame) = frame("conmech/uniform_load_analytical_model.json");
    let (bytes, name) = data("conmech/uniform_load_analytical_model_loads.json");
    let cases = read_loads(&bytes, &name, &imported.wireframe, Some(&frame)).unwrap();
    let [case] = cases.as_slice() else { panic!("one case") };
    let nodal = NodalLoad { vertex: VertexId(1), force_n: [0.0, 0.0, -5000.0], moment_n_mm: [0.0; 3] };
    assert_eq!(case.nodal, [nodal]);
    assert_eq!(case.line, [LineLoad { edge: EdgeId(0), n_per_mm: [0.0, 0.0, -3.0] }]);
    assert_eq!((&*case.name, case.gravity), ("0", None));
    let (imported, frame) = self::frame("conmech/four-frame.json");
    let (bytes, name) = data("conmech/four-frame_loads.json");
    let cases = read_loads(&bytes, &name, &imported.wireframe, Some(&frame)).unwrap();
    assert_eq!(cases[0].gravity, Some([0.0, 0.0, -1.0]), "a multiple of standard gravity");
    // Without a frame of its own a file names vertices by their ids.
    let cases = read_loads(&bytes, &name, &imported.wireframe, None).unwrap();
    assert!(cases[0].nodal.is_empty());
}

#[test]
fn loads_on_what_is_not_there_are_refused() {
    let (imported, frame) = frame("conmech/uniform_load_analytical_model.json");
    let read = |case: Value| {
        let text = json!({"loadcases": {"dead": {}, "wind": case}}).to_string();
        refused(read_loads(text.as_bytes(), "l.json", &imported.wireframe, Some(&frame)))
    };
    let point = |node: i64, unit: &str| {
        json!({"ploads": [{"force": [0, 0, 1], "force_unit": unit, "moment": [0, 0, 0], "moment_unit": "kNm",
            "node_ind": node}]})
    };
    assert!(
        read(point(9, "kN"))
            .ends_with("l.json, load case wind, node load 0: 9 names no node of the frame: there are 3")
    );
    assert!(read(point(-1, "kN")).contains("-1 names no node"));
    assert!(read(point(1, "lbf")).contains("found \"lbf\", expected one of the units kN, N"));
    let along = |tag: &str, again: f64| json!({"eloads": [{"q": [0, 0, 1], "q_unit": "kN/m", "load": [0, 0, again], "elem_tags": [tag]}]});
    assert!(read(along("xy", 1.0)).contains("found \"the tag \"xy\"\", expected elem_tags of elements"));
    assert!(
        read(along("ab", 2.0))
            .contains("l.json, load case wind, element load 0: found \"a load that is not q\"")
    );
    let text = read(json!({"tloads": []}));
    assert!(text.contains("unknown field `tloads`"), "{text}");
    let none = read_loads(b"{\"loadcases\": {}}", "l.json", &imported.wireframe, None);
    assert_eq!(refused(none), "read-empty: l.json: no load cases in it");
}

/// The sequence that `FrameFab`'s authors published for their bunny: every strut of the frame once, pillars first.
#[test]
fn the_published_sequence_is_of_the_published_bunny() {
    let bunny = import_data("framefab/bunny0507_.pwf", &ReadOptions::default());
    let (bytes, name) = data("framefab/bunny_result.json");
    let sequence = read_sequence(&bytes, &name).unwrap();
    let kinds = |kind| sequence.steps.iter().filter(|step| step.kind == kind).count();
    assert_eq!(
        (kinds(StrutKind::Ground), kinds(StrutKind::Create), kinds(StrutKind::Connect)),
        (12, 67, 100)
    );
    // 6,928 directions, and the one upwards of each pillar.
    assert_eq!(sequence.steps.iter().map(|step| step.directions.len()).sum::<usize>(), 6928 + 12);
    let steps = sequence.match_edges(&bunny.wireframe, mm(0.01)).unwrap();
    assert_eq!(steps.len(), 179);
    let foot =
        |step: &wirebend_files::read::frame::MatchedStep| bunny.wireframe.vertex(step.from).unwrap().support;
    assert!(steps.iter().take(12).all(foot) && !steps.iter().skip(12).any(foot));
    let small = read_sequence(&data("framefab/framefab_path_result.json").0, "path.json").unwrap();
    assert_eq!(small.steps.len(), 7);
}

#[test]
fn a_sequence_of_another_design_is_refused() {
    let bunny = import_data("framefab/bunny0507_.pwf", &ReadOptions::default()).wireframe;
    let sequence = read_sequence(&data("framefab/bunny_result.json").0, "bunny.json").unwrap();
    let tolerance = Length::from_mm(0.01).unwrap();
    let mut moved = sequence.clone();
    moved.steps[3].end.x += 0.1;
    let error = moved.match_edges(&bunny, tolerance).unwrap_err();
    assert!(
        error.to_string().starts_with("step 4 of the sequence: no vertex of the design within 0.01 mm of ("),
        "{error}"
    );
    let mut twice = sequence.clone();
    twice.steps[20] = twice.steps[19].clone();
    let error = twice.match_edges(&bunny, tolerance).unwrap_err();
    assert!(matches!(error, StrutMatchError::Repeated { step: 21, first: 20, .. }), "{error}");
    let mut across = sequence.clone();
    across.steps[0].end = across.steps[1].end;
    let error = across.match_edges(&bunny, tolerance).unwrap_err();
    assert!(matches!(error, StrutMatchError::NoEdge { step: 1, .. }), "{error}");
    let mut short = sequence;
    short.steps.truncate(170);
    let error = short.match_edges(&bunny, tolerance).unwrap_err();
    assert!(matches!(error, StrutMatchError::Missing { count: 9, .. }), "{error}");
}

#[test]
fn what_is_no_sequence_is_refused() {
    let step = |kind: &str, direction: Value| json!({"start_pt": [0, 0, 0], "end_pt": [0, 0, 1], "type": kind, "feasible_orientation": [direction]});
    let read = |steps: Vec<Value>, count: usize| {
        let text = json!({"element_number": count, "sequenced_elements": steps}).to_string();
        refused(read_sequence(text.as_bytes(), "s.json"))
    };
    let up = || json!([0, 0, 1]);
    assert_eq!(
        read(vec![step("glue", up())], 1),
        "read-syntax: s.json, element 0: found \"glue\", expected type \"support\", \"create\" or \"connect\""
    );
    assert!(read(vec![step("create", json!([0, 0, 0.1]))], 1).contains("expected a direction of length 1"));
    assert!(
        read(vec![step("create", json!([1e308, 1e308, 0]))], 1).contains("expected a direction of length 1")
    );
    assert_eq!(
        read(vec![step("create", up())], 2),
        "read-truncated: s.json: element_number says 2, but the list has 1: the file is cut off or damaged"
    );
    assert_eq!(read(vec![], 0), "read-empty: s.json: no sequenced_elements in it");
    assert!(refused(read_sequence(b"[]", "s.json")).starts_with("read-syntax: s.json, line 1:"));
}

#[test]
fn frames_are_read_from_any_bytes_without_a_panic() {
    let (imported, frame) = frame("conmech/uniform_load_analytical_model.json");
    let sequence = data("framefab/framefab_path_result.json").0;
    let loads = data("conmech/uniform_load_analytical_model_loads.json").0;
    for (bytes, stride) in [(&sequence, 997), (&loads, 7)] {
        for k in (0..bytes.len()).step_by(stride) {
            let mut changed = bytes.clone();
            changed[k] = changed[k].wrapping_add(1);
            for bytes in [&changed[..], &bytes[..k]] {
                let _ = read_sequence(bytes, "s.json");
                let _ = read_loads(bytes, "l.json", &imported.wireframe, Some(&frame));
            }
        }
    }
    let _ = read(&sequence, "s.json", None, &ReadOptions::default()).unwrap_err();
}
