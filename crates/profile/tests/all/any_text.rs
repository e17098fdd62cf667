//! No file, however strange, may bring the program down.

use proptest::prelude::*;
use serde_json::{Map, Value, json};
use wirebend_profile::check_text;

/// JSON made of the words of profiles, so that it gets further than noise would.
fn profile_like() -> impl Strategy<Value = Value> {
    let leaf = prop_oneof![
        Just(Value::Null),
        any::<bool>().prop_map(Value::Bool),
        any::<f64>().prop_map(|number| json!(number)),
        ".{0,8}".prop_map(Value::String),
        any::<f64>().prop_map(|value| json!({"value": value, "source": "s", "measured": true})),
        prop::sample::select(vec!["wirebend-kit", "mine", "machine", "table", "constant", "peg"])
            .prop_map(|word| json!(word)),
    ];
    let words = vec![
        "limits",
        "max_bend_deg",
        "min_bend_deg",
        "bend",
        "method",
        "signs",
        "springback",
        "model",
        "positive",
        "angle_deg",
        "loss_deg",
        "feed",
        "value",
        "source",
        "measured",
        "name",
        "inherits",
        "abstract",
        "driver",
        "settings",
        "export",
        "formats",
        "error",
        "a.b",
    ];
    leaf.prop_recursive(4, 32, 6, move |inner| {
        let key = prop::sample::select(words.clone()).prop_map(str::to_owned);
        prop_oneof![
            prop::collection::vec(inner.clone(), 0..4).prop_map(Value::Array),
            prop::collection::btree_map(key, inner, 0..6)
                .prop_map(|map| Value::Object(map.into_iter().collect())),
        ]
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(128))]

    #[test]
    fn any_characters_are_answered(text in ".*") {
        let errors = check_text("mine.json", &text).unwrap_err();
        prop_assert!(!errors.is_empty());
    }

    #[test]
    fn any_json_is_answered(
        value in profile_like(),
        kind in prop::sample::select(vec!["machine", "material", "noise"]),
    ) {
        let mut values = match value {
            Value::Object(values) => values,
            other => Map::from_iter([("limits".to_owned(), other)]),
        };
        values.insert("schema_version".into(), json!(1));
        values.insert("kind".into(), json!(kind));
        values.insert("id".into(), json!("mine"));
        // Refused or not, there is an answer with words in it.
        match check_text("mine.json", &Value::Object(values).to_string()) {
            Ok(checked) => prop_assert_eq!(checked.id, "mine"),
            Err(errors) => prop_assert!(errors.iter().all(|error| !error.to_string().is_empty())),
        }
    }

    #[test]
    fn any_cut_of_a_good_file_is_refused(at in any::<prop::sample::Index>()) {
        let good = include_str!("../../../../machine-profiles/machines/wirebend-kit.json").trim_end();
        let cut = at.index(good.len());
        let errors = check_text("wirebend-kit.json", good.get(..cut).unwrap_or_default()).unwrap_err();
        prop_assert_eq!(errors[0].code(), "profile-syntax");
    }
}

#[test]
fn deep_nesting_is_refused_and_not_followed() {
    let text = format!("{{\"kind\": {}1{}}}", "[".repeat(100_000), "]".repeat(100_000));
    let errors = check_text("mine.json", &text).unwrap_err();
    assert_eq!(errors[0].code(), "profile-syntax");
}
