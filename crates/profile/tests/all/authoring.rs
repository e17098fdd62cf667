//! A person's new profile, and what a profile says of itself.

use include_dir::{Dir, include_dir};
use serde_json::json;
use wirebend_profile::{Child, Explained, ExplainedValue, Kind, Library, schema};

fn library() -> Library {
    Library::shipped().unwrap()
}

/// The shipped profiles and a folder's.
fn with(files: &[(&str, &str)]) -> (tempfile::TempDir, Library) {
    let root = tempfile::tempdir().unwrap();
    for (path, text) in files {
        let path = root.path().join(path);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    }
    let mut library = library();
    let added = library.add_folder(root.path());
    assert!(added.refused.is_empty(), "{:?}", added.refused);
    (root, library)
}

fn child(kind: Kind, inherits: &str, all: bool) -> Child<'_> {
    Child { kind, id: "mine", inherits, name: "Mine", schema: None, all }
}

/// Ids of the complete shipped profiles of a kind.
fn complete(kind: Kind) -> Vec<String> {
    let listed = library().list(kind).into_iter().filter(|listing| !listing.is_abstract);
    listed.map(|listing| listing.id).collect()
}

fn value<'a>(explained: &'a Explained, key: &str) -> &'a ExplainedValue {
    explained.values.iter().find(|value| value.key == key).unwrap_or_else(|| panic!("no {key}"))
}

/// The shipped files as they were when the program was built. The checkout may have changed since then, and its
/// lines would not be those that the program knows.
static SHIPPED: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/../../machine-profiles");

/// A line of a shipped file, whose name begins with the folder's.
fn shipped_line(file: &str, line: usize) -> &'static str {
    let path = file.strip_prefix("machine-profiles/").unwrap();
    SHIPPED.get_file(path).unwrap().contents_utf8().unwrap().lines().nth(line - 1).unwrap()
}

#[test]
fn a_new_profile_is_complete_and_behaves_as_its_parent() {
    for kind in Kind::ALL {
        let validator = jsonschema::validator_for(&schema(kind)).unwrap();
        for parent in complete(kind) {
            for all in [false, true] {
                let text = library().child_text(&child(kind, &parent, all)).unwrap();
                let checked = library().check("mine.json", &text).unwrap();
                assert_eq!((checked.kind, checked.chain[1].as_str()), (kind, parent.as_str()));
                assert!(validator.is_valid(&serde_json::from_str(&text).unwrap()), "{text}");
                let (_root, library) = with(&[(&format!("{}/mine.json", kind.folder()), &text)]);
                let plain = |id: &str| {
                    let values = library.explain(kind, id).unwrap().values;
                    // A list is written anew: its numbers are compared as such below.
                    let is_list = |key: &str| key == "shapes" || key.starts_with("springback.");
                    let of_both =
                        values.into_iter().filter(|value| value.key != "name" && !is_list(&value.key));
                    of_both.map(|value| (value.key, value.value, value.source)).collect::<Vec<_>>()
                };
                assert_eq!(plain("mine"), plain(&parent), "{parent}, all: {all}");
                if kind == Kind::Machine {
                    let shapes = |id: &str| library.machine(id).unwrap().profile.shapes;
                    assert_eq!(shapes("mine"), shapes(&parent), "{parent}, all: {all}");
                }
                if kind == Kind::Material {
                    let figures = |id: &str| library.material(id).unwrap().figures().unwrap();
                    assert_eq!(figures("mine"), figures(&parent), "{parent}, all: {all}");
                }
            }
        }
    }
}

#[test]
fn a_new_profile_says_only_what_was_asked_for() {
    let text = library().child_text(&child(Kind::Machine, "wirebend-kit", false)).unwrap();
    let heading = json!({"schema_version": 1, "kind": "machine", "id": "mine", "inherits": "wirebend-kit",
        "name": "Mine"});
    assert_eq!(serde_json::from_str::<serde_json::Value>(&text).unwrap(), heading);
    let schema = Some("../schema/noise.schema.json");
    let text = library().child_text(&Child { schema, ..child(Kind::Noise, "none", true) }).unwrap();
    assert!(text.starts_with("{\n  \"$schema\": \"../schema/noise.schema.json\",\n"), "{text}");
    // A person finds value and source of a figure side by side.
    let figure = "\"bias_mm\": { \"value\": 0.0, \"source\": \"By definition\", \"measured\": false },";
    assert!(text.lines().any(|line| line.trim() == figure), "{text}");
}

#[test]
fn a_copy_of_a_base_is_a_base_no_more() {
    let text = library().child_text(&child(Kind::Material, "steel-1010", true)).unwrap();
    let errors = library().check("mine.json", &text).unwrap_err();
    // The base leaves open what differs from wire to wire.
    let codes: Vec<String> =
        errors.iter().map(|error| format!("{}: {error} {:?}", error.code(), error.remedies())).collect();
    assert_eq!(codes.len(), 2, "{codes:?}");
    assert!(codes[0].starts_with("profile-missing") && codes[0].contains("diameter_mm"), "{codes:?}");
    assert!(codes[1].starts_with("profile-missing") && codes[1].contains("springback"), "{codes:?}");
}

#[test]
fn every_value_is_shown_on_the_line_that_sets_it() {
    for kind in Kind::ALL {
        for listing in library().list(kind) {
            let explained = library().explain(kind, &listing.id).unwrap();
            assert!(explained.values.len() > 5, "{}", listing.id);
            for value in explained.values {
                let line = shipped_line(&value.place.file, value.place.line.unwrap());
                let word = value.key.rsplit('.').next().unwrap();
                assert!(line.contains(&format!("\"{word}\":")), "{}: {} in {line}", listing.id, value.key);
                assert!(value.place.file.ends_with(&format!("{}.json", value.id)));
            }
        }
    }
}

/// The shipped files have their keys in the order of the documentation.
#[test]
fn values_come_in_the_order_of_the_file_of_a_profile_without_parent() {
    for (kind, id) in
        [(Kind::Machine, "wirebend-kit"), (Kind::Material, "brass-1-6mm"), (Kind::Noise, "none")]
    {
        let explained = library().explain(kind, id).unwrap();
        let lines: Vec<usize> = explained.values.iter().filter_map(|value| value.place.line).collect();
        assert!(lines.is_sorted(), "{id}: {lines:?}");
        assert_eq!(explained.values[0].key, "name", "{id}");
    }
}

#[test]
fn what_a_child_changes_is_shown_beside_what_its_parent_says() {
    let text = r#"{
        "schema_version": 1, "kind": "machine", "id": "my-kit", "inherits": "wirebend-kit",
        "limits": {
            "max_bend_deg": {"value": 120, "source": "bent on mine", "measured": true}
        },
        "error": null
    }"#;
    let grandchild = r#"{"schema_version": 1, "kind": "machine", "id": "third", "inherits": "my-kit",
        "limits": {"max_bend_deg": {"value": 90, "source": "worn", "measured": true}}}"#;
    let (_root, library) = with(&[("machines/my-kit.json", text), ("machines/third.json", grandchild)]);
    let mine = library.explain(Kind::Machine, "my-kit").unwrap();
    let chain: Vec<_> = mine.chain.iter().map(|link| (link.id.as_str(), link.shipped)).collect();
    assert_eq!(chain, [("my-kit", false), ("wirebend-kit", true)]);
    let bend = value(&mine, "limits.max_bend_deg");
    assert_eq!((bend.value.as_f64(), bend.place.line), (Some(120.0), Some(4)));
    assert_eq!((bend.source.as_deref(), bend.measured), (Some("bent on mine"), Some(true)));
    let old = bend.instead_of.as_ref().unwrap();
    assert_eq!((old.value.as_f64(), old.id.as_str()), (Some(155.0), "wirebend-kit"));
    // Taken away, which is not the same as never set.
    let error = value(&mine, "error");
    assert!(error.value.is_null() && error.instead_of.as_ref().unwrap().value == "wirebend-kit");
    assert_eq!(value(&mine, "limits.min_bend_deg").instead_of, None);
    // The nearest parent that sets it counts.
    let third = library.explain(Kind::Machine, "third").unwrap();
    let old = value(&third, "limits.max_bend_deg").instead_of.clone().unwrap();
    assert_eq!((old.value.as_f64(), old.id.as_str()), (Some(120.0), "my-kit"));
}

#[test]
fn a_springback_table_says_for_its_pairs_where_they_come_from() {
    let steel = library().explain(Kind::Material, "steel-0-9mm").unwrap();
    let pairs = value(&steel, "springback.positive");
    assert_eq!(pairs.value.as_array().unwrap().len(), 3);
    assert_eq!(pairs.measured, Some(false));
    assert!(pairs.source.as_ref().unwrap().contains("nobody measured it"));
    assert_eq!(value(&steel, "springback.model").source, None);
    let keys: Vec<&str> = steel.values.iter().map(|value| value.key.as_str()).collect();
    assert!(!keys.contains(&"springback.source") && !keys.contains(&"id"), "{keys:?}");
    let aluminium = library().explain(Kind::Material, "aluminium-6061-t6-3mm").unwrap();
    let lost = value(&aluminium, "springback.angle_deg");
    assert_eq!((lost.value.as_f64(), lost.measured), (Some(10.23), Some(true)));
}

#[test]
fn a_base_can_be_explained_though_not_used() {
    let steel = library().explain(Kind::Material, "steel-1010").unwrap();
    assert!(steel.is_abstract && steel.name == "Low-carbon steel");
    library().explain(Kind::Material, "steel-1011").unwrap_err();
}

#[test]
fn an_id_tells_its_kinds() {
    assert_eq!(library().kinds("wirebend-kit").unwrap(), [Kind::Machine, Kind::Noise]);
    assert_eq!(library().kinds("steel-1mm").unwrap(), [Kind::Material]);
}
