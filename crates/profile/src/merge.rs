//! Puts a child's keys on its parent's and remembers which file set each.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use serde_json::{Map, Value};

use crate::heading::OWN;
use crate::layer::Layer;

/// Which file set a value.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Origin {
    /// Id of the profile.
    pub id: String,
    /// Its file; shipped ones begin with `machine-profiles/`.
    pub file: String,
}

/// A chain of files made one.
#[derive(Clone, Debug, Default)]
pub(crate) struct Merged {
    pub(crate) values: Map<String, Value>,
    pub(crate) provenance: BTreeMap<String, Origin>,
}

/// Merges a chain, child first. Objects are merged key by key; lists, figures with a source, and
/// the objects at the dotted keys `whole` are replaced; `null` takes an inherited value away.
pub(crate) fn merge(chain: &[&Layer], whole: &[&str]) -> Merged {
    let mut merged = Merged::default();
    for layer in chain.iter().rev() {
        merged.values.retain(|key, _| !OWN.contains(&key.as_str()));
        merged.provenance.retain(|key, _| !OWN.contains(&key.as_str()));
        merged.drop_settings_of_another_driver(&layer.values);
        merged.drop_other_way(&layer.values);
        let origin = Origin { id: layer.id.clone(), file: layer.file.clone() };
        let mut onto = Onto { provenance: &mut merged.provenance, origin, whole };
        onto.put_all(&mut merged.values, &layer.values, "");
    }
    merged
}

impl Merged {
    /// Settings have the schema of their driver, so another driver starts without any.
    fn drop_settings_of_another_driver(&mut self, child: &Map<String, Value>) {
        let wanted = child.get("driver").and_then(|driver| driver.get("id"));
        let Some(Value::Object(driver)) = self.values.get_mut("driver") else {
            return;
        };
        if wanted.is_some_and(|id| driver.get("id").is_some_and(|mine| mine != id)) {
            for key in ["settings", "stop_bytes", "stop_reply"] {
                driver.remove(key);
                forget(&mut self.provenance, &format!("driver.{key}"));
            }
        }
    }
}

/// Keys of which a profile states one: the other follows from it.
const ONE_OF: [[&str; 2]; 2] =
    [["shear_modulus_gpa", "poisson_ratio"], ["poisson_ratio", "shear_modulus_gpa"]];

impl Merged {
    /// A child that states a value one way does not keep its parent's, which is stated the other way. A file that
    /// states both itself keeps both, and is refused by its rules.
    fn drop_other_way(&mut self, child: &Map<String, Value>) {
        for [stated, other] in ONE_OF {
            if child.get(stated).is_some_and(|value| !value.is_null()) {
                self.values.remove(other);
                forget(&mut self.provenance, other);
            }
        }
    }
}

struct Onto<'a> {
    provenance: &'a mut BTreeMap<String, Origin>,
    origin: Origin,
    whole: &'a [&'a str],
}

impl Onto<'_> {
    fn put_all(&mut self, onto: &mut Map<String, Value>, child: &Map<String, Value>, path: &str) {
        for (key, value) in child {
            let path = if path.is_empty() { key.clone() } else { format!("{path}.{key}") };
            self.put(onto, key, value, &path);
        }
    }

    fn put(&mut self, onto: &mut Map<String, Value>, key: &str, value: &Value, path: &str) {
        if let Value::Object(group) = value
            && !is_figure(group)
            && !self.whole.contains(&path)
        {
            let slot = onto.entry(key).or_insert_with(|| Value::Object(Map::new()));
            if !matches!(slot, Value::Object(old) if !is_figure(old)) {
                forget(self.provenance, path);
                *slot = Value::Object(Map::new());
            }
            if let Value::Object(old) = slot {
                self.put_all(old, group, path);
            }
            return;
        }
        onto.insert(key.to_owned(), value.clone());
        forget(self.provenance, path);
        self.provenance.insert(path.to_owned(), self.origin.clone());
    }
}

/// Whether an object is a figure with its source rather than a group of keys.
pub(crate) fn is_figure(object: &Map<String, Value>) -> bool {
    object.contains_key("value") && object.contains_key("source")
}

fn forget(provenance: &mut BTreeMap<String, Origin>, path: &str) {
    let below = format!("{path}.");
    provenance.retain(|key, _| key != path && !key.starts_with(&below));
}

#[cfg(test)]
mod tests;
