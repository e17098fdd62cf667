//! Machines that build frames strut by strut: the shipped one, and what is refused.

use expect_test::expect;
use serde_json::{Value, json};
use wirebend_profile::{HeadPoint, Library, StrutProcess, check_text};

use crate::refusals::{figure, messages, refuse};

fn builder(changes: &[(&str, Value)]) -> String {
    let mut value = json!({
        "schema_version": 1, "kind": "strut-builder", "id": "mine", "inherits": "framefab-extruder"
    });
    for (key, change) in changes {
        value[*key] = change.clone();
    }
    value.to_string()
}

fn head(points: &[(f64, f64)]) -> Value {
    let outline: Vec<Value> = points.iter().map(|(z, r)| json!({"z_mm": z, "r_mm": r})).collect();
    json!({"outline": outline, "source": "drawn", "measured": false})
}

/// Figures of Huang et al., `FrameFab`, and of its program.
#[test]
fn the_framefab_extruder_has_its_published_figures() {
    let library = Library::shipped().unwrap();
    let machine = library.strut_builder("framefab-extruder").unwrap();
    let figures = machine.figures().unwrap();
    assert_eq!(figures.process, StrutProcess::Extrude);
    let cone = figures.head[1];
    assert!((cone.r_mm / cone.z_mm - 30_f64.to_radians().tan()).abs() < 1e-4, "{cone:?}");
    assert_eq!(figures.head[2], HeadPoint { z_mm: 120.0, r_mm: 11.547 });
    // Both poles and a ring of 360/18 at each step between them.
    let rings = 180.0 / figures.direction_step_deg - 1.0;
    let directions = 2.0 + rings * 360.0 / figures.direction_step_deg;
    assert!((directions - 182.0).abs() < 1e-9, "{directions}");
    assert_eq!((figures.create_approach_deg, figures.connect_approach_deg), (60.0, 90.0));
    let wire = library.material(machine.profile.default_material.as_deref().unwrap()).unwrap();
    let sag = wire.figures().unwrap().diameter_mm / 2.0 - figures.position_tolerance_mm;
    assert!((sag - 0.65).abs() < 1e-12, "{sag}");
    assert!(figures.ground_first && figures.workspace.is_none());
}

/// A plan for a wire bender needs a bender.
#[test]
fn a_strut_builder_is_no_machine_that_bends() {
    let library = Library::shipped().unwrap();
    assert!(library.machines().iter().all(|listing| listing.id != "framefab-extruder"));
    let error = library.machine("framefab-extruder").unwrap_err();
    assert_eq!(error.to_string(), "no machine has the id `framefab-extruder`: it is a strut-builder");
    let error = library.strut_builder("wirebend-kit").unwrap_err();
    assert_eq!(error.to_string(), "no strut-builder has the id `wirebend-kit`: it is a machine");
    let error = library.strut_builder("arm").unwrap_err();
    assert_eq!(error.to_string(), "no strut-builder has the id `arm`");
}

/// One file with a mistake takes no other away: all benders stay, and so does the shipped builder.
#[test]
fn a_builder_without_its_material_is_left_out_alone() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("strut-builders")).unwrap();
    let text = builder(&[("default_material", "abs-2mm".into())]);
    std::fs::write(folder.path().join("strut-builders/mine.json"), text).unwrap();
    let mut library = Library::shipped().unwrap();
    let before = (library.machines(), library.strut_builders());
    let added = library.add_folder(folder.path());
    let text = messages(&added.refused);
    assert!(text.contains("default_material names the unknown material `abs-2mm`"), "{text}");
    assert!(added.loaded.is_empty());
    assert_eq!((library.machines(), library.strut_builders()), before);
}

#[test]
fn what_nobody_sets_is_listed_with_how_to_set_it() {
    let text = json!({"schema_version": 1, "kind": "strut-builder", "id": "mine"}).to_string();
    refuse(
        "mine.json",
        &text,
        expect![[r#"
        profile-missing: mine.json: name is not set, here or by a parent [AddKey { text: "\"name\": a name for people" }]
        profile-missing: mine.json: process is not set, here or by a parent [AddKey { text: "\"process\": \"extrude\", \"weld\" or \"place\"" }]
        profile-missing: mine.json: default_material is not set, here or by a parent [AddKey { text: "\"default_material\": the id of a material profile" }]
        profile-missing: mine.json: head is not set, here or by a parent [AddKey { text: "\"head\": {\"outline\": [{\"z_mm\": 0, \"r_mm\": number}, ...], \"source\": text, \"measured\": true or false}" }]
        profile-missing: mine.json: directions.step_deg is not set, here or by a parent [AddKey { text: "\"directions\": {\"step_deg\": {\"value\": number, \"source\": text, \"measured\": true or false}}" }]
        profile-missing: mine.json: approach_deg.create is not set, here or by a parent [AddKey { text: "\"approach_deg\": {\"create\": {\"value\": number, \"source\": text, \"measured\": true or false}}" }]
        profile-missing: mine.json: approach_deg.connect is not set, here or by a parent [AddKey { text: "\"approach_deg\": {\"connect\": {\"value\": number, \"source\": text, \"measured\": true or false}}" }]
        profile-missing: mine.json: position_tolerance_mm is not set, here or by a parent [AddKey { text: "\"position_tolerance_mm\": {\"value\": number, \"source\": text, \"measured\": true or false}" }]
        profile-missing: mine.json: clearance_mm is not set, here or by a parent [AddKey { text: "\"clearance_mm\": {\"value\": number, \"source\": text, \"measured\": true or false}" }]
        profile-missing: mine.json: speed.strut_mm_per_s is not set, here or by a parent [AddKey { text: "\"speed\": {\"strut_mm_per_s\": {\"value\": number, \"source\": text, \"measured\": true or false}}" }]
        profile-missing: mine.json: speed.travel_mm_per_s is not set, here or by a parent [AddKey { text: "\"speed\": {\"travel_mm_per_s\": {\"value\": number, \"source\": text, \"measured\": true or false}}" }]
        profile-missing: mine.json: pause_per_joint_s is not set, here or by a parent [AddKey { text: "\"pause_per_joint_s\": {\"value\": number, \"source\": text, \"measured\": true or false}" }]
        profile-missing: mine.json: ground_first is not set, here or by a parent [AddKey { text: "\"ground_first\": true or false" }]
    "#]],
    );
}

#[test]
fn a_head_is_a_convex_solid_from_its_tip() {
    let good: [&[(f64, f64)]; 3] = [
        &[(0.0, 0.0), (20.0, 11.547), (100.0, 11.547)],
        &[(0.0, 2.0), (30.0, 2.0)],
        &[(0.0, 1.0), (10.0, 8.0), (20.0, 12.0), (30.0, 0.0)],
    ];
    for points in good {
        check_text("mine.json", &builder(&[("head", head(points))])).unwrap();
    }
    let bad: [(&[(f64, f64)], &str); 7] = [
        (&[(0.0, 1.0)], "is 1 points, expected 2 to 1000 points"),
        (&[(1.0, 0.0), (2.0, 1.0)], "is 1, expected z_mm of 0 at the first point, the tip"),
        (&[(0.0, 0.0), (2.0, -1.0)], "is -1, expected r_mm of 0 or more"),
        (&[(0.0, 0.0), (2.0, 0.0)], "a head without a radius"),
        (&[(0.0, 0.0), (2.0, 1.0), (2.0, 3.0)], "is 2, expected z_mm above that of the point before, 2"),
        (&[(0.0, 0.0), (20.0, 5.0), (30.0, 20.0)], "is hollow at z_mm 20, expected a convex head"),
        (&[(0.0, 2.0), (20.0, 2.0), (30.0, 6.0)], "is hollow at z_mm 20, expected a convex head"),
    ];
    for (points, expected) in bad {
        let text = messages(&check_text("mine.json", &builder(&[("head", head(points))])).unwrap_err());
        assert!(text.contains("head.outline") && text.contains(expected), "{text}");
    }
}

#[test]
fn a_builder_that_contradicts_itself_is_refused() {
    let workspace = |max: f64| json!({"min_mm": [0, 0, 0], "max_mm": [10.0, 10.0, max], "source": " ", "measured": false});
    let text = builder(&[
        ("directions", json!({"step_deg": figure(25.0)})),
        ("approach_deg", json!({"create": figure(-1.0), "connect": figure(181.0)})),
        ("position_tolerance_mm", figure(-0.1)),
        ("clearance_mm", figure(-1.0)),
        ("speed", json!({"strut_mm_per_s": figure(0.0), "travel_mm_per_s": figure(-5.0)})),
        ("pause_per_joint_s", figure(-1.0)),
        ("workspace", workspace(0.0)),
        ("default_material", "abs".into()),
    ]);
    refuse(
        "mine.json",
        &text,
        expect![[r#"
            profile-rule: mine.json:1: speed.strut_mm_per_s is 0, expected a value above 0 [CorrectProfile]
            profile-rule: mine.json:1: speed.travel_mm_per_s is -5, expected a value above 0 [CorrectProfile]
            profile-rule: mine.json:1: approach_deg.create is -1, expected a value between 0 and 180 [CorrectProfile]
            profile-rule: mine.json:1: approach_deg.connect is 181, expected a value between 0 and 180 [CorrectProfile]
            profile-rule: mine.json:1: position_tolerance_mm is -0.1, expected 0 or more [CorrectProfile]
            profile-rule: mine.json:1: clearance_mm is -1, expected 0 or more [CorrectProfile]
            profile-rule: mine.json:1: pause_per_joint_s is -1, expected 0 or more [CorrectProfile]
            profile-rule: mine.json:1: directions.step_deg is 25, expected a divisor of 180 between 1 and 90 [CorrectProfile]
            profile-rule: mine.json:1: workspace.source is an empty text, expected where the dimensions come from, or why they are an estimate [CorrectProfile]
            profile-rule: mine.json:1: workspace.max_mm is 0, expected above the lower bound, 0 [CorrectProfile]
            profile-unknown-reference: mine.json:1: default_material names the unknown material `abs` [ChooseKnown { near: ["abs-1-5mm"], known: ["abs-1-5mm", "aluminium-3-175mm", "aluminium-6061-o-3mm", "aluminium-6061-t6-3mm", "brass-1-6mm", "copper-2mm", "pla-3mm", "steel-0-9mm", "steel-1mm", "steel-3mm"] }]
        "#]],
    );
    for step in [0.0, -18.0, 0.5, 180.0, 7.0] {
        let change = json!({"step_deg": figure(step)});
        let text = messages(&check_text("mine.json", &builder(&[("directions", change)])).unwrap_err());
        assert!(text.contains("expected a divisor of 180 between 1 and 90"), "{step}: {text}");
    }
    let unknown = builder(&[("head_mm", 3.into())]);
    let text = messages(&check_text("mine.json", &unknown).unwrap_err());
    assert!(text.contains("unknown field `head_mm`"), "{text}");
}
