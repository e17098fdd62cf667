//! Profiles that do not fit the others.

use expect_test::expect;
use wirebend_profile::{Kind, Library, check_file, check_text};

use crate::refusals::{child, figure, messages, refuse, refuse_folder};

#[test]
fn an_unknown_parent_is_answered_with_the_nearest_ids() {
    let text = child("").replace("wirebend-kit", "wirebend-kid");
    refuse(
        "mine.json",
        &text,
        expect![[r#"
            profile-unknown-parent: mine.json:5: inherits from the unknown machine `wirebend-kid` (one whose file was refused is unknown too) [ChooseKnown { near: ["wirebend-kit"], known: ["grbl-bender", "howtomechatronics", "pensa-diwire-pro", "table-bender", "wirebend-kit"] }]
        "#]],
    );
}

#[test]
fn a_ring_of_parents_is_shown_whole() {
    let of = |id: &str, parent: &str| {
        child("").replace("\"mine\"", &format!("\"{id}\"")).replace("wirebend-kit", parent)
    };
    refuse(
        "mine.json",
        &of("mine", "mine"),
        expect![[r#"
            profile-cycle: mine.json:5: the parents run in a circle: mine -> mine [RemoveParent]
        "#]],
    );
    let (a, b, c) = (of("a", "b"), of("b", "c"), of("c", "b"));
    let files = [
        ("machines/a.json", a.as_bytes()),
        ("machines/b.json", b.as_bytes()),
        ("machines/c.json", c.as_bytes()),
    ];
    refuse_folder(
        &files,
        expect![[r#"
            profile-cycle: PROFILES/machines/a.json:5: the parents run in a circle: a -> b -> c -> b [RemoveParent]
            profile-cycle: PROFILES/machines/b.json:5: the parents run in a circle: b -> c -> b [RemoveParent]
            profile-cycle: PROFILES/machines/c.json:5: the parents run in a circle: c -> b -> c [RemoveParent]
        "#]],
    );
}

#[test]
fn other_profiles_that_are_named_must_exist() {
    let text = child("\"default_material\": \"steel\",\n\"error\": \"nope\"");
    refuse(
        "mine.json",
        &text,
        expect![[r#"
            profile-unknown-reference: mine.json:6: default_material names the unknown material `steel` [ChooseKnown { near: ["steel-1mm", "steel-3mm", "steel-0-9mm"], known: ["abs-1-5mm", "aluminium-3-175mm", "aluminium-6061-o-3mm", "aluminium-6061-t6-3mm", "brass-1-6mm", "copper-2mm", "pla-3mm", "steel-0-9mm", "steel-1mm", "steel-3mm"] }]
            profile-unknown-reference: mine.json:7: error names the unknown noise `nope` [ChooseKnown { near: ["none"], known: ["bend-forming", "none", "wirebend-kit"] }]
        "#]],
    );
}

/// Every command that takes the machine with its own wire would be refused.
#[test]
fn a_profile_that_is_named_must_be_one_that_can_be_used() {
    let text = child("\"default_material\": \"steel-1010\"");
    refuse(
        "mine.json",
        &text,
        expect![[r#"
            profile-abstract: mine.json:6: default_material names the material `steel-1010`, which is abstract and cannot be used itself [ChooseKnown { near: ["steel-1mm", "steel-0-9mm", "steel-3mm"], known: ["abs-1-5mm", "aluminium-3-175mm", "aluminium-6061-o-3mm", "aluminium-6061-t6-3mm", "brass-1-6mm", "copper-2mm", "pla-3mm", "steel-0-9mm", "steel-1mm", "steel-3mm"] }]
        "#]],
    );
    // What is abstract itself leaves that to its children.
    let family = child("\"abstract\": true,\n\"default_material\": \"steel-1010\"");
    check_text("mine.json", &family).unwrap();
}

/// Whichever end of the range the child sets, the child's line is at fault.
#[test]
fn a_contradiction_with_a_parent_is_shown_in_the_child() {
    let of = |id: &str, parent: &str, key: &str| {
        child(&format!("\"abstract\": true,\n\"limits\": {{\"{key}\": {}}}", figure(0.0)))
            .replace("\"mine\"", &format!("\"{id}\""))
            .replace("wirebend-kit", parent)
    };
    let low = of("low", "wirebend-kit", "min_bend_deg");
    let high = of("high", "wirebend-kit", "max_bend_deg");
    let (low_child, high_child) = (of("x", "high", "min_bend_deg"), of("y", "low", "max_bend_deg"));
    let files = [
        ("machines/low.json", low.as_bytes()),
        ("machines/high.json", high.as_bytes()),
        ("machines/x.json", low_child.as_bytes()),
        ("machines/y.json", high_child.as_bytes()),
    ];
    refuse_folder(
        &files,
        expect![[r#"
            profile-rule: PROFILES/machines/x.json:7: limits.max_bend_deg is 0, expected above the lower bound, 0 [CorrectProfile]
            profile-rule: PROFILES/machines/y.json:7: limits.max_bend_deg is 0, expected above the lower bound, 0 [CorrectProfile]
        "#]],
    );
}

#[test]
fn a_shipped_id_cannot_be_taken_over() {
    let text = child("").replace("\"mine\"", "\"wirebend-kit\"");
    refuse(
        "wirebend-kit.json",
        &text,
        expect![[r#"
            profile-shadows-shipped: wirebend-kit.json:4: `wirebend-kit` is a machine that comes with the program [ChooseOtherId, InheritFrom { ids: ["wirebend-kit"] }]
        "#]],
    );
    refuse_folder(
        &[("machines/wirebend-kit.json", text.as_bytes())],
        expect![[r#"
            profile-shadows-shipped: PROFILES/machines/wirebend-kit.json:4: `wirebend-kit` is a machine that comes with the program [ChooseOtherId, InheritFrom { ids: ["wirebend-kit"] }]
        "#]],
    );
}

#[test]
fn a_second_file_with_an_id_is_refused() {
    let (one, two) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    let mut library = Library::shipped().unwrap();
    for root in [&one, &two] {
        std::fs::create_dir(root.path().join("machines")).unwrap();
        std::fs::write(root.path().join("machines/mine.json"), child("")).unwrap();
    }
    assert!(library.add_folder(one.path()).refused.is_empty());
    let text = messages(&library.add_folder(two.path()).refused)
        .replace(&one.path().display().to_string(), "ONE")
        .replace(&two.path().display().to_string(), "TWO")
        .replace('\\', "/");
    expect![[r#"
        profile-duplicate-id: TWO/machines/mine.json:4: the id `mine` is taken by ONE/machines/mine.json [ChooseOtherId]
    "#]]
    .assert_eq(&text);
    library.machine("mine").unwrap();
}

#[test]
fn an_unknown_id_is_answered_with_the_nearest_and_the_known() {
    let library = Library::shipped().unwrap();
    let machine = library.machine("wirebendkit").unwrap_err();
    let noise = library.noise("zzz").unwrap_err();
    expect![[r#"
        profile-unknown: no machine has the id `wirebendkit` [ChooseKnown { near: ["wirebend-kit"], known: ["grbl-bender", "howtomechatronics", "pensa-diwire-pro", "table-bender", "wirebend-kit"] }]
        profile-unknown: no noise has the id `zzz` [ChooseKnown { near: [], known: ["bend-forming", "none", "wirebend-kit"] }]
    "#]]
    .assert_eq(&messages(&[machine, noise]));
    // The abstract `steel-1010` is for others to inherit from, and no help to whoever looks for a wire.
    let material = messages(&[library.material("zzz").unwrap_err()]);
    assert!(material.contains("steel-1mm") && !material.contains("steel-1010"), "{material}");
    let (near, far) = (library.kinds("pensa").unwrap_err(), library.kinds("zzz").unwrap_err());
    // Of every kind, each id once.
    let all = [
        "abs-1-5mm",
        "aluminium-3-175mm",
        "aluminium-6061-o-3mm",
        "aluminium-6061-t6-3mm",
        "bend-forming",
        "brass-1-6mm",
        "copper-2mm",
        "framefab-extruder",
        "grbl-bender",
        "howtomechatronics",
        "none",
        "pensa-diwire-pro",
        "pla-3mm",
        "steel-0-9mm",
        "steel-1010",
        "steel-1mm",
        "steel-3mm",
        "table-bender",
        "wirebend-kit",
    ];
    let expected = format!(
        "profile-unknown-id: no profile has the id `pensa` [ChooseKnown {{ near: [\"pensa-diwire-pro\"], known: {all:?} }}]\n\
         profile-unknown-id: no profile has the id `zzz` [ChooseKnown {{ near: [], known: {all:?} }}]\n"
    );
    assert_eq!(messages(&[near, far]), expected);
}

#[test]
fn an_abstract_profile_cannot_be_used() {
    let error = Library::shipped().unwrap().material("steel-1010").unwrap_err();
    expect![[r#"
        profile-abstract: machine-profiles/materials/steel-1010.json:6: the material `steel-1010` is abstract and cannot be used itself [UseChild]
    "#]]
    .assert_eq(&messages(&[error]));
}

#[test]
fn a_child_is_checked_among_its_neighbours() {
    let root = tempfile::tempdir().unwrap();
    let machines = root.path().join(Kind::Machine.folder());
    std::fs::create_dir(&machines).unwrap();
    std::fs::write(machines.join("mine.json"), child("")).unwrap();
    let text = child("").replace("wirebend-kit", "mine").replacen("\"mine\"", "\"second\"", 1);
    std::fs::write(machines.join("second.json"), text).unwrap();
    let checked = check_file(&machines.join("second.json")).unwrap();
    assert_eq!(checked.chain, ["second", "mine", "wirebend-kit"]);
    assert_eq!((checked.kind, checked.id.as_str()), (Kind::Machine, "second"));
}
