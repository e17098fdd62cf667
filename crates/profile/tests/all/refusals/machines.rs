//! Rules of machines.

use expect_test::expect;
use serde_json::{Value, json};
use wirebend_profile::{MachineProfile, Resolved, check_text};

use crate::refusals::{child, figure, messages, refuse};

#[test]
fn what_nobody_sets_is_listed_with_how_to_set_it() {
    let text = "{\"schema_version\": 1, \"kind\": \"noise\", \"id\": \"mine\", \"name\": \" \"}";
    refuse(
        "mine.json",
        text,
        expect![[r#"
            profile-missing: mine.json: name is not set, here or by a parent [AddKey { text: "\"name\": a name for people" }]
            profile-missing: mine.json: feed.bias_mm is not set, here or by a parent [AddKey { text: "\"feed\": {\"bias_mm\": {\"value\": number, \"source\": text, \"measured\": true or false}}" }]
            profile-missing: mine.json: feed.sigma_mm is not set, here or by a parent [AddKey { text: "\"feed\": {\"sigma_mm\": {\"value\": number, \"source\": text, \"measured\": true or false}}" }]
            profile-missing: mine.json: bend.bias_deg is not set, here or by a parent [AddKey { text: "\"bend\": {\"bias_deg\": {\"value\": number, \"source\": text, \"measured\": true or false}}" }]
            profile-missing: mine.json: bend.sigma_deg is not set, here or by a parent [AddKey { text: "\"bend\": {\"sigma_deg\": {\"value\": number, \"source\": text, \"measured\": true or false}}" }]
            profile-missing: mine.json: rotate.bias_deg is not set, here or by a parent [AddKey { text: "\"rotate\": {\"bias_deg\": {\"value\": number, \"source\": text, \"measured\": true or false}}" }]
            profile-missing: mine.json: rotate.sigma_deg is not set, here or by a parent [AddKey { text: "\"rotate\": {\"sigma_deg\": {\"value\": number, \"source\": text, \"measured\": true or false}}" }]
            profile-missing: mine.json: curvature.bias is not set, here or by a parent [AddKey { text: "\"curvature\": {\"bias\": {\"value\": number, \"source\": text, \"measured\": true or false}}" }]
            profile-missing: mine.json: curvature.sigma is not set, here or by a parent [AddKey { text: "\"curvature\": {\"sigma\": {\"value\": number, \"source\": text, \"measured\": true or false}}" }]
        "#]],
    );
}

#[test]
fn a_peg_needs_its_orbit_and_a_direct_machine_does_not() {
    let bend = |method: &str| {
        json!({
            "method": method, "rate_deg_per_s": figure(1.0), "resolution_deg": figure(1.0),
            "pin_radius_mm": figure(1.0)
        })
    };
    let text = |method: &str| {
        let id = "mine";
        let mut value: Value = serde_json::from_str(&child("")).unwrap();
        value["inherits"] = "pensa-diwire-pro".into();
        value["id"] = id.into();
        value["bend"] = bend(method);
        value.to_string()
    };
    check_text("mine.json", &text("direct")).unwrap();
    refuse(
        "mine.json",
        &text("peg"),
        expect![[r#"
            profile-missing: mine.json: bend.rod_radius_mm is not set, here or by a parent [AddKey { text: "\"bend\": {\"rod_radius_mm\": {\"value\": number, \"source\": text, \"measured\": true or false}}" }]
            profile-missing: mine.json: bend.orbit_radius_mm is not set, here or by a parent [AddKey { text: "\"bend\": {\"orbit_radius_mm\": {\"value\": number, \"source\": text, \"measured\": true or false}}" }]
            profile-missing: mine.json: bend.orbit_offset_mm is not set, here or by a parent [AddKey { text: "\"bend\": {\"orbit_offset_mm\": {\"value\": number, \"source\": text, \"measured\": true or false}}" }]
            profile-missing: mine.json: bend.axis_limit_deg is not set, here or by a parent [AddKey { text: "\"bend\": {\"axis_limit_deg\": {\"value\": number, \"source\": text, \"measured\": true or false}}" }]
        "#]],
    );
}

#[test]
fn an_abstract_base_may_leave_values_open_but_not_break_rules() {
    let base = "{\"schema_version\": 1, \"kind\": \"machine\", \"id\": \"base\", \"abstract\": true";
    assert!(check_text("base.json", &format!("{base}}}")).unwrap().is_abstract);
    let text = format!("{base},\n\"feed\": {{\n\"rate_mm_per_s\": {}}}}}", figure(0.0));
    refuse(
        "base.json",
        &text,
        expect![[r#"
            profile-rule: base.json:3: feed.rate_mm_per_s is 0, expected a value above 0 [CorrectProfile]
        "#]],
    );
}

/// Each rule of a machine: what is put in, and the one message that comes out.
#[test]
fn a_machine_that_contradicts_itself_is_refused() {
    let cases = [
        ("limits.min_bend_deg", 5.0, "expected a value between -180 and 0"),
        ("limits.max_bend_deg", -5.0, "expected a value between 0 and 180"),
        ("limits.max_bend_deg", 181.0, "expected a value between 0 and 180"),
        ("limits.min_rotation_deg", 1.0, "expected 0 or less"),
        ("limits.max_rotation_deg", -1.0, "expected 0 or more"),
        ("limits.min_edge_mm", -1.0, "expected 0 or more"),
        ("limits.min_feed_mm", -1.0, "expected 0 or more"),
        ("limits.max_stock_mm", 0.0, "expected a value above 0"),
        ("limits.tail_mm", -1.0, "expected 0 or more"),
        ("wire.min_diameter_mm", 0.0, "expected a value above 0"),
        ("wire.max_diameter_mm", 1.0, "expected at least the lower bound, 2.8"),
        ("feed.rate_mm_per_s", 0.0, "expected a value above 0"),
        ("feed.resolution_mm", 0.0, "expected a value above 0"),
        ("rotate.rate_deg_per_s", -1.0, "expected a value above 0"),
        ("rotate.resolution_deg", 0.0, "expected a value above 0"),
        ("bend.rate_deg_per_s", 0.0, "expected a value above 0"),
        ("bend.resolution_deg", 0.0, "expected a value above 0"),
        ("bend.pin_radius_mm", 0.0, "expected a value above 0"),
        ("bend.rod_radius_mm", 0.0, "expected a value above 0"),
        ("bend.orbit_radius_mm", 0.0, "expected a value above 0"),
        (
            "bend.orbit_offset_mm",
            -20.0,
            "expected above -19.833, from where the orbit reaches the wire ahead of the pin",
        ),
        ("bend.axis_limit_deg", 0.0, "expected a value above 0"),
        ("time.fixed_per_bend_s", -1.0, "expected 0 or more"),
        ("time.fixed_per_turn_s", -1.0, "expected 0 or more"),
    ];
    for (key, value, expected) in cases {
        let (group, leaf) = key.split_once('.').unwrap();
        let lines = format!("\"{group}\": {{\n\"{leaf}\": {}}}", figure(value));
        let errors = check_text("mine.json", &child(&lines)).unwrap_err();
        let message = format!("mine.json:7: {key} is {value}, {expected}");
        assert!(errors.iter().any(|error| error.to_string() == message), "{key}: {errors:?}");
    }
}

#[test]
fn equal_bounds_are_a_range_of_wires_but_not_of_angles() {
    let same = |key: &str, low: f64, high: f64| {
        let (group, leaf) = key.split_once('.').unwrap();
        let (low, high) = (figure(low), figure(high));
        child(&format!("\"{group}\": {{\"min_{leaf}\": {low}, \"max_{leaf}\": {high}}}"))
    };
    check_text("mine.json", &same("wire.diameter_mm", 3.0, 3.0)).unwrap();
    check_text("mine.json", &same("limits.bend_deg", 0.0, 0.0)).unwrap_err();
    check_text("mine.json", &same("limits.bend_deg", 0.0, 90.0)).unwrap();
}

#[test]
fn names_of_drivers_and_formats_are_ids() {
    let lines = "\"driver\": {\"id\": \"A B\"},\n\
                 \"export\": {\"formats\": [\"svg\", \"svg\", \"X\"], \"native\": \"é\"}";
    refuse(
        "mine.json",
        &child(lines),
        expect![[r#"
            profile-rule: mine.json:6: driver.id is A B, expected an id of lower-case letters, digits and hyphens [CorrectProfile]
            profile-rule: mine.json:7: export.native is é, expected an id of lower-case letters, digits and hyphens [CorrectProfile]
            profile-rule: mine.json:7: export.formats is svg, expected each format id once [CorrectProfile]
            profile-rule: mine.json:7: export.formats is X, expected an id of lower-case letters, digits and hyphens [CorrectProfile]
        "#]],
    );
    refuse(
        "mine.json",
        &child("\"export\": {\"formats\": []}"),
        expect![[r#"
            profile-rule: mine.json:6: export.formats is an empty list, expected at least one format id [CorrectProfile]
        "#]],
    );
}

/// Profiles of a job's snapshot did not come from a library.
#[test]
fn figures_of_an_open_profile_name_what_is_missing() {
    let profile: MachineProfile = serde_json::from_str(&child("")).unwrap();
    let open = Resolved { profile, provenance: [].into(), chain: vec![] };
    let error = open.figures().unwrap_err();
    expect![[r#"
        profile-missing: mine: name is not set, here or by a parent [AddKey { text: "\"name\": a name for people" }]
    "#]]
    .assert_eq(&messages(&[error]));
}

/// A body without size would be neither seen nor hit.
#[test]
fn a_body_of_a_machine_has_a_size_and_a_direction() {
    let shape = |solid: &str, axis: &str| {
        child(&format!(
            "\"shapes\": [{{ \"name\": \"arm\", \"part\": \"head\", \"solid\": {solid}, \"at_mm\": [0, 0, 0], \
             \"axis\": {axis}, \"source\": \"test\", \"measured\": false }}]"
        ))
    };
    let flat = shape("{ \"box\": { \"size_mm\": [1, 0, 1] } }", "[0, 0, 1]");
    refuse(
        "mine.json",
        &flat,
        expect![[r#"
            profile-rule: mine.json:6: shapes is 0, expected sizes of 'arm' above 0 [CorrectProfile]
        "#]],
    );
    let nowhere = shape("{ \"cylinder\": { \"radius_mm\": 1, \"length_mm\": 2 } }", "[0, 0, 0]");
    refuse(
        "mine.json",
        &nowhere,
        expect![[r#"
            profile-rule: mine.json:6: shapes is an axis without direction, expected a direction for the axis of 'arm' that is not 0 0 0 [CorrectProfile]
        "#]],
    );
    let unknown = shape("{ \"sphere\": { \"radius_mm\": 1 } }", "[0, 0, 1]");
    refuse(
        "mine.json",
        &unknown,
        expect![[r#"
            profile-shape: mine.json:6: unknown variant `sphere`, expected `box` or `cylinder` (column 63) [SeeSchema]
        "#]],
    );
}
