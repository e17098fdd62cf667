use proptest::prelude::*;
use serde_json::{Map, Value, json};

use super::*;
use crate::Kind;

fn layer(id: &str, values: Value) -> Layer {
    let Value::Object(values) = values else { panic!("an object") };
    Layer {
        kind: Kind::Machine,
        id: id.into(),
        inherits: None,
        is_abstract: false,
        file: format!("{id}.json"),
        text: String::new(),
        values,
        shipped: false,
    }
}

fn figure(value: i32, source: &str) -> Value {
    json!({"value": value, "source": source, "measured": false})
}

#[test]
fn a_new_value_never_keeps_the_old_source() {
    let parent = layer("parent", json!({"g": {"x": figure(1, "old")}}));
    let child = layer("child", json!({"g": {"x": {"value": 2, "source": "new"}}}));
    let merged = merge(&[&child, &parent], &[]);
    assert_eq!(merged.values["g"]["x"], json!({"value": 2, "source": "new"}));
    assert_eq!(merged.provenance["g.x"].id, "child");
}

#[test]
fn lists_and_whole_objects_are_replaced() {
    let parent = layer("parent", json!({"list": [1, 2, 3], "whole": {"a": 1}, "open": {"a": 1}}));
    let child = layer("child", json!({"list": [4], "whole": {"b": 2}, "open": {"b": 2}}));
    let merged = merge(&[&child, &parent], &["whole"]);
    let expected = json!({"list": [4], "whole": {"b": 2}, "open": {"a": 1, "b": 2}});
    assert_eq!(Value::Object(merged.values), expected);
    assert_eq!(merged.provenance["open.a"].id, "parent");
    assert_eq!(merged.provenance["open.b"].id, "child");
    assert!(!merged.provenance.contains_key("whole.a"));
}

#[test]
fn what_speaks_of_one_file_is_not_inherited() {
    let parent = layer("parent", json!({"abstract": true, "inherits": "x", "$schema": "s"}));
    let child = layer("child", json!({"id": "child"}));
    let merged = merge(&[&child, &parent], &[]);
    assert_eq!(Value::Object(merged.values), json!({"id": "child"}));
}

/// Groups to figures, with few names so that parent and child meet.
fn layers() -> impl Strategy<Value = Value> {
    let figures = prop::collection::btree_map("[a-c]", 0..100, 0..4);
    prop::collection::btree_map("[g-i]", figures, 0..4).prop_map(|groups| {
        let group = |figures: std::collections::BTreeMap<String, i32>| {
            let figures = figures.into_iter().map(|(key, value)| (key, figure(value, "s")));
            Value::Object(figures.collect::<Map<_, _>>())
        };
        Value::Object(groups.into_iter().map(|(key, value)| (key, group(value))).collect())
    })
}

proptest! {
    #[test]
    fn the_childs_figure_wins_and_the_rest_is_the_parents(child in layers(), parent in layers()) {
        let (child, parent) = (layer("child", child), layer("parent", parent));
        let merged = merge(&[&child, &parent], &[]);
        for group in ["g", "h", "i"] {
            for name in ["a", "b", "c"] {
                let find = |layer: &Layer| layer.values.get(group)?.get(name).cloned();
                let expected = match (find(&child), find(&parent)) {
                    (Some(figure), _) => Some((figure, "child")),
                    (None, Some(figure)) => Some((figure, "parent")),
                    (None, None) => None,
                };
                let value = merged.values.get(group).and_then(|group| group.get(name)).cloned();
                let by = merged.provenance.get(&format!("{group}.{name}"));
                prop_assert_eq!(value.zip(by.map(|by| by.id.as_str())), expected);
            }
        }
    }
}
