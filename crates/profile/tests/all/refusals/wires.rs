//! Rules of wires and of their errors.

use expect_test::expect;
use serde_json::{Value, json};
use wirebend_profile::{Library, check_text};

use crate::refusals::{figure, messages, refuse};

fn material(changes: &[(&str, Value)]) -> String {
    let mut value = json!({
        "schema_version": 1, "kind": "material", "id": "mine", "inherits": "aluminium-6061-t6-3mm"
    });
    for (key, change) in changes {
        value[*key] = change.clone();
    }
    value.to_string()
}

#[test]
fn a_springback_table_can_be_read_both_ways() {
    let table = |pairs: &[(f64, f64)]| {
        let points: Vec<Value> = pairs.iter().map(|(a, l)| json!({"angle_deg": a, "loss_deg": l})).collect();
        let table = json!({"model": "table", "positive": points, "source": "s", "measured": true});
        material(&[("springback", table)])
    };
    check_text("mine.json", &table(&[(0.0, 5.0), (90.0, 4.0), (180.0, 4.0)])).unwrap();
    let cases: [(&[(f64, f64)], &str); 6] = [
        (&[(10.0, 5.0)], "is 1 pairs, expected two pairs or more"),
        (&[(10.0, 5.0), (10.0, 6.0)], "is 10, expected angle_deg above the pair before, 10"),
        (&[(10.0, 50.0), (20.0, 40.0)], "is 60, expected angle_deg + loss_deg above"),
        (&[(10.0, -1.0), (20.0, 1.0)], "is -1, expected loss_deg of 0 or more"),
        (&[(-10.0, 1.0), (20.0, 1.0)], "is -10, expected angle_deg between 0 and 180"),
        (&[(10.0, 1.0), (200.0, 1.0)], "is 200, expected angle_deg between 0 and 180"),
    ];
    for (pairs, expected) in cases {
        let text = messages(&check_text("mine.json", &table(pairs)).unwrap_err());
        assert!(text.contains("springback.positive"), "{text}");
        assert!(text.contains(expected), "{text}");
    }
}

#[test]
fn a_wire_that_contradicts_itself_is_refused() {
    let zero = || figure(0.0);
    let point = |angle: f64| json!({"angle_deg": angle, "loss_deg": 1});
    let text = material(&[
        ("diameter_mm", zero()),
        ("k_factor", figure(1.5)),
        ("youngs_modulus_gpa", zero()),
        ("yield_strength_mpa", figure(400.0)),
        ("density_kg_per_m3", zero()),
        ("price_per_mm", figure(-1.0)),
        ("currency", "dollars".into()),
        (
            "springback",
            json!({"model": "table", "positive": [point(1.0), point(2.0)],
            "negative": [point(2.0), point(1.0)], "source": "", "measured": false}),
        ),
    ]);
    refuse(
        "mine.json",
        &text,
        expect![[r#"
            profile-rule: mine.json:1: diameter_mm is 0, expected a value above 0 [CorrectProfile]
            profile-rule: mine.json:1: youngs_modulus_gpa is 0, expected a value above 0 [CorrectProfile]
            profile-rule: mine.json:1: density_kg_per_m3 is 0, expected a value above 0 [CorrectProfile]
            profile-rule: mine.json:1: k_factor is 1.5, expected a value between 0 and 1 [CorrectProfile]
            profile-rule: mine.json:1: price_per_mm is -1, expected 0 or more [CorrectProfile]
            profile-rule: mine.json:1: ultimate_strength_mpa is 362.14, expected at least the yield strength, 400 [CorrectProfile]
            profile-rule: mine.json:1: currency is dollars, expected three capital letters (ISO 4217) [CorrectProfile]
            profile-rule: mine.json:1: springback.negative is 1, expected angle_deg above the pair before, 2 [CorrectProfile]
            profile-rule: mine.json:1: springback.source is an empty text, expected where the pairs come from, or why they are an estimate [CorrectProfile]
        "#]],
    );
    let constant = json!({"model": "constant", "angle_deg": figure(-1.0)});
    refuse(
        "mine.json",
        &material(&[("springback", constant)]),
        expect![[r#"
            profile-rule: mine.json:1: springback.angle_deg is -1, expected a value between 0 and 180 [CorrectProfile]
        "#]],
    );
    refuse(
        "mine.json",
        &material(&[("currency", Value::Null)]),
        expect![[r#"
            profile-missing: mine.json: currency is not set, here or by a parent [AddKey { text: "\"currency\": the ISO 4217 code of the price, such as \"USD\"" }]
        "#]],
    );
    let extra = json!({"model": "constant", "angle_deg": figure(1.0), "source": "s"});
    refuse(
        "mine.json",
        &material(&[("springback", extra)]),
        expect![[r#"
            profile-shape: mine.json:1: unknown field `source`, expected `angle_deg` (column 191) [SeeSchema]
        "#]],
    );
}

/// The shear modulus follows from Poisson's ratio; two statements of one thing differ sooner or later.
#[test]
fn a_wire_states_its_shear_one_way() {
    let both = material(&[("shear_modulus_gpa", figure(26.0)), ("poisson_ratio", figure(0.3))]);
    refuse(
        "mine.json",
        &both,
        expect![[r#"
        profile-rule: mine.json:1: poisson_ratio is 0.3, expected no poisson_ratio beside shear_modulus_gpa: the one follows from the other [CorrectProfile]
    "#]],
    );
    let stiff = material(&[("shear_modulus_gpa", figure(0.0))]);
    refuse(
        "mine.json",
        &stiff,
        expect![[r#"
        profile-rule: mine.json:1: shear_modulus_gpa is 0, expected a value above 0 [CorrectProfile]
    "#]],
    );
    for ratio in [-1.0, 0.51] {
        let text =
            messages(&check_text("mine.json", &material(&[("poisson_ratio", figure(ratio))])).unwrap_err());
        assert!(text.contains("expected more than -1 and at most 0.5"), "{text}");
    }
    let brittle = material(&[("fracture_strain", figure(0.0)), ("process_energy_mj_per_kg", figure(-1.0))]);
    refuse(
        "mine.json",
        &brittle,
        expect![[r#"
        profile-rule: mine.json:1: fracture_strain is 0, expected a value above 0 [CorrectProfile]
        profile-rule: mine.json:1: process_energy_mj_per_kg is -1, expected a value above 0 [CorrectProfile]
    "#]],
    );
}

/// A child of a wire with Poisson's ratio may have measured its shear modulus, and the other way round.
#[test]
fn a_child_states_its_shear_its_own_way() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("materials")).unwrap();
    let text = material(&[("shear_modulus_gpa", figure(27.0))]);
    std::fs::write(folder.path().join("materials/mine.json"), text).unwrap();
    let mut library = Library::shipped().unwrap();
    assert!(library.add_folder(folder.path()).refused.is_empty());
    let mine = library.material("mine").unwrap();
    assert_eq!(mine.figures().unwrap().shear_modulus_gpa, Some(27.0));
    assert_eq!(mine.profile.poisson_ratio, None);
    assert!(mine.origin("poisson_ratio").is_none());
    let parent = library.material("aluminium-6061-t6-3mm").unwrap();
    assert_eq!(parent.figures().unwrap().shear_modulus_gpa, Some(68.03 / 2.0 / 1.33));
}

#[test]
fn a_spread_is_not_negative() {
    let text = json!({
        "schema_version": 1, "kind": "noise", "id": "mine", "inherits": "none",
        "feed": {"sigma_mm": figure(-1.0)}, "bend": {"sigma_deg": figure(-1.0)},
        "rotate": {"sigma_deg": figure(-1.0)}, "curvature": {"sigma": figure(-1.0)}
    });
    refuse(
        "mine.json",
        &text.to_string(),
        expect![[r#"
            profile-rule: mine.json:1: feed.sigma_mm is -1, expected 0 or more [CorrectProfile]
            profile-rule: mine.json:1: bend.sigma_deg is -1, expected 0 or more [CorrectProfile]
            profile-rule: mine.json:1: rotate.sigma_deg is -1, expected 0 or more [CorrectProfile]
            profile-rule: mine.json:1: curvature.sigma is -1, expected 0 or more [CorrectProfile]
        "#]],
    );
}
