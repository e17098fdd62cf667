//! A person's own profiles: folders, parents, provenance.

use std::path::Path;

use tempfile::TempDir;
use wirebend_profile::{Kind, Library, MachineProfile, Profile, to_text};

const CHILD: &str = r#"{
  "schema_version": 1, "kind": "machine", "id": "my-kit", "inherits": "wirebend-kit",
  "name": "My kit",
  "limits": {
    "max_bend_deg": {"value": 120, "source": "measured on mine", "measured": true}
  }
}"#;

fn folder(files: &[(&str, &str)]) -> TempDir {
    let root = tempfile::tempdir().unwrap();
    for (path, text) in files {
        let path = root.path().join(path);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }
    root
}

fn with(root: &Path) -> (Library, wirebend_profile::Added) {
    let mut library = Library::shipped().unwrap();
    let added = library.add_folder(root);
    (library, added)
}

#[test]
fn a_childs_one_limit_changes_and_all_else_is_the_parents() {
    let root = folder(&[("machines/my-kit.json", CHILD)]);
    let (library, added) = with(root.path());
    assert!(added.refused.is_empty(), "{:?}", added.refused);
    assert_eq!(added.loaded, [(Kind::Machine, "my-kit".into())]);

    let child = library.machine("my-kit").unwrap();
    let mut expected = library.machine("wirebend-kit").unwrap().figures().unwrap();
    expected.limits.max_bend_deg = 120.0;
    assert_eq!(child.figures().unwrap(), expected);
    assert_eq!(child.chain, ["my-kit", "wirebend-kit"]);
    assert_eq!(child.profile.id(), "my-kit");
    assert_eq!(child.profile.name.as_deref(), Some("My kit"));
}

#[test]
fn a_person_can_see_which_file_set_a_value() {
    let root = folder(&[("machines/my-kit.json", CHILD)]);
    let (library, _) = with(root.path());
    let child = library.machine("my-kit").unwrap();
    let own = child.origin("limits.max_bend_deg").unwrap();
    assert_eq!(own.id, "my-kit");
    assert!(own.file.ends_with("my-kit.json"), "{}", own.file);
    assert_eq!(child.origin("limits.max_bend_deg.value"), Some(own));
    let parents = child.origin("limits.min_bend_deg").unwrap();
    assert_eq!(parents.id, "wirebend-kit");
    assert_eq!(parents.file, "machine-profiles/machines/wirebend-kit.json");
    assert_eq!(child.origin("limits"), None);
    assert_eq!(child.origin("limits.max_stock_mm"), None);
}

#[test]
fn one_bad_file_costs_only_itself_and_what_relies_on_it() {
    let orphan = CHILD.replace("\"my-kit\"", "\"orphan\"").replace("wirebend-kit", "broken");
    let root = folder(&[
        ("machines/broken.json", "{"),
        ("machines/my-kit.json", CHILD),
        ("machines/notes.txt", "not a profile"),
        ("machines/orphan.json", &orphan),
        ("stray.json", CHILD),
    ]);
    let (library, added) = with(root.path());
    let codes: Vec<&str> = added.refused.iter().map(|error| error.code().as_str()).collect();
    assert_eq!(codes, ["profile-syntax", "profile-unknown-parent"]);
    assert_eq!(added.loaded, [(Kind::Machine, "my-kit".into())]);
    let ignored: Vec<_> = added.ignored.iter().map(|path| path.file_name().unwrap()).collect();
    assert_eq!(ignored, ["stray.json", "notes.txt"]);
    library.machine("wirebend-kit").unwrap();
    library.machine("my-kit").unwrap();
    library.machine("orphan").unwrap_err();
}

#[test]
fn a_child_of_a_refused_parent_is_refused_even_if_it_would_mend_it() {
    let parent = r#"{"schema_version": 1, "kind": "noise", "id": "parent", "name": "open"}"#;
    let child = r#"{"schema_version": 1, "kind": "noise", "id": "child", "inherits": "parent",
        "feed": {"bias_mm": {"value": 0, "source": "s", "measured": false},
                 "sigma_mm": {"value": 0, "source": "s", "measured": false}},
        "bend": {"bias_deg": {"value": 0, "source": "s", "measured": false},
                 "sigma_deg": {"value": 0, "source": "s", "measured": false}},
        "rotate": {"bias_deg": {"value": 0, "source": "s", "measured": false},
                   "sigma_deg": {"value": 0, "source": "s", "measured": false}},
        "curvature": {"bias": {"value": 0, "source": "s", "measured": false},
                      "sigma": {"value": 0, "source": "s", "measured": false}}}"#;
    let root = folder(&[("noise/parent.json", parent), ("noise/child.json", child)]);
    let (library, added) = with(root.path());
    assert!(added.loaded.is_empty());
    library.noise("child").unwrap_err();
    // Marked as a base, the parent may stay open and the child works.
    let parent = parent.replace("\"name\"", "\"abstract\": true, \"name\"");
    let root = folder(&[("noise/parent.json", &parent), ("noise/child.json", child)]);
    let (library, added) = with(root.path());
    assert!(added.refused.is_empty(), "{:?}", added.refused);
    assert_eq!(library.noise("child").unwrap().profile.name.as_deref(), Some("open"));
}

#[test]
fn another_driver_does_not_get_the_settings_of_the_parents() {
    let settings = r#""driver": {"id": "wirebend-kit", "settings": {"baud": 1, "deep": {"a": 2}}}"#;
    let base = CHILD.replace("\"name\"", &format!("{settings}, \"name\""));
    let child = |id: &str, driver: &str| {
        CHILD
            .replace("\"my-kit\"", &format!("\"{id}\""))
            .replace("\"wirebend-kit\"", "\"my-kit\"")
            .replace("\"name\"", &format!("\"driver\": {driver}, \"name\""))
    };
    let root = folder(&[
        ("machines/my-kit.json", &base),
        ("machines/same.json", &child("same", r#"{"settings": {"deep": {"b": 3}}}"#)),
        ("machines/other.json", &child("other", r#"{"id": "grbl"}"#)),
    ]);
    let (library, added) = with(root.path());
    assert!(added.refused.is_empty(), "{:?}", added.refused);
    let same = library.machine("same").unwrap();
    let settings = serde_json::Value::Object(same.profile.driver.settings.clone().unwrap());
    assert_eq!(settings, serde_json::json!({"baud": 1, "deep": {"a": 2, "b": 3}}));
    assert_eq!(same.origin("driver.settings.deep.b").unwrap().id, "same");
    let other = library.machine("other").unwrap();
    assert_eq!(other.profile.driver.settings, None);
    assert_eq!(other.origin("driver.settings.baud"), None);
}

#[test]
fn null_takes_an_optional_value_away() {
    let base = CHILD.replace(
        "\"max_bend_deg\"",
        r#""max_stock_mm": {"value": 900, "source": "s", "measured": false}, "max_bend_deg""#,
    );
    let child = r#"{"schema_version": 1, "kind": "machine", "id": "spool", "inherits": "my-kit",
        "limits": {"max_stock_mm": null}}"#;
    let root = folder(&[("machines/my-kit.json", &base), ("machines/spool.json", child)]);
    let (library, added) = with(root.path());
    assert!(added.refused.is_empty(), "{:?}", added.refused);
    let limit = |id: &str| library.machine(id).unwrap().figures().unwrap().limits.max_stock_mm;
    assert_eq!(limit("my-kit"), Some(900.0));
    assert_eq!(limit("spool"), None);
}

#[test]
fn a_material_changes_its_springback_model_without_remains_of_the_old_one() {
    let child = r#"{"schema_version": 1, "kind": "material", "id": "mine",
        "inherits": "aluminium-6061-t6-3mm",
        "springback": {"model": "table", "source": "bent ten of each", "measured": true,
            "positive": [{"angle_deg": 10, "loss_deg": 5}, {"angle_deg": 90, "loss_deg": 8}]}}"#;
    let root = folder(&[("materials/mine.json", child)]);
    let (library, added) = with(root.path());
    assert!(added.refused.is_empty(), "{:?}", added.refused);
    let mine = library.material("mine").unwrap();
    assert_eq!(mine.origin("springback.positive").unwrap().id, "mine");
    assert_eq!(mine.origin("springback.angle_deg").unwrap().id, "mine");
}

#[test]
fn a_written_profile_reads_back_the_same() {
    let library = Library::shipped().unwrap();
    for listing in library.machines() {
        let profile = library.machine(&listing.id).unwrap().profile;
        let text = to_text(&profile).unwrap();
        assert!(!text.contains("null") && text.ends_with("}\n"));
        assert_eq!(serde_json::from_str::<MachineProfile>(&text).unwrap(), profile);
    }
}

#[test]
fn a_byte_order_mark_of_a_windows_editor_does_no_harm() {
    let text = format!("\u{feff}{}", CHILD.replace('\n', "\r\n"));
    let root = folder(&[("machines/my-kit.json", &text)]);
    assert!(with(root.path()).1.refused.is_empty());
}

/// Files that were written before signs and choices had sources are taken as they are, and say that they have none: the source of
/// the parent is that of another value.
#[test]
fn a_plain_sign_counts_and_has_no_source_of_its_parent() {
    let plain = CHILD.replace("\"limits\"", "\"signs\": {\"bend\": -1},\n  \"limits\"");
    let stated = plain.replace("-1", r#"{"value": -1, "source": "bent one", "measured": true}"#);
    for (text, source) in [(&plain, None), (&stated, Some("bent one"))] {
        let root = folder(&[("machines/my-kit.json", text.as_str())]);
        let (library, added) = with(root.path());
        assert!(added.refused.is_empty(), "{:?}", added.refused);
        let machine = library.machine("my-kit").unwrap();
        assert!((machine.figures().unwrap().bend_sign + 1.0).abs() < 1e-12);
        let explained = library.explain(Kind::Machine, "my-kit").unwrap().values;
        let sign = explained.iter().find(|value| value.key == "signs.bend").unwrap();
        assert_eq!((sign.source.as_deref(), sign.id.as_str()), (source, "my-kit"));
        let other = explained.iter().find(|value| value.key == "signs.rotate").unwrap();
        assert!(other.source.is_some() && other.id == "wirebend-kit");
        let written = to_text(&machine.profile).unwrap();
        let again: MachineProfile = serde_json::from_str(&written).unwrap();
        assert_eq!(again, machine.profile);
    }
}
