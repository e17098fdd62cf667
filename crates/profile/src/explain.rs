//! Which file set what: a profile, value by value, with the file and the line of each.

use serde_json::{Map, Value};

use crate::heading::OWN;
use crate::layer::Layer;
use crate::library::Library;
use crate::merge::{Merged, is_figure, merge};
use crate::position::line_of;
use crate::resolved::origin;
use crate::{
    Kind, MachineProfile, MaterialProfile, NoiseProfile, Place, Profile, ProfileError, Resolved,
    StrutBuilderProfile, to_text,
};

/// A profile with its values and the files that set them.
#[derive(Clone, Debug, PartialEq)]
pub struct Explained {
    /// Name for people; the id when no name is set.
    pub name: String,
    /// Whether it only serves to be inherited from.
    pub is_abstract: bool,
    /// The profile itself, its parent, and so on.
    pub chain: Vec<Ancestor>,
    /// Every value in the order of the documentation; keys that speak of one file, such as `id` and
    /// `inherits`, are left out.
    pub values: Vec<ExplainedValue>,
}

/// A profile of a chain.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Ancestor {
    /// Its id.
    pub id: String,
    /// Its file; shipped ones begin with `machine-profiles/`.
    pub file: String,
    /// Whether it comes with the program.
    pub shipped: bool,
}

/// One value of a profile.
#[derive(Clone, Debug, PartialEq)]
pub struct ExplainedValue {
    /// Dotted key.
    pub key: String,
    /// The plain value; of a figure without its source. Null where an inherited value is taken away.
    pub value: Value,
    /// Id of the profile that set it.
    pub id: String,
    /// Where in that profile's file.
    pub place: Place,
    /// Where a figure comes from; absent for what is no figure.
    pub source: Option<String>,
    /// Whether a figure was measured; absent for what is no figure.
    pub measured: Option<bool>,
    /// What the parent of the profile that set it has here.
    pub instead_of: Option<Overridden>,
}

/// A value of a parent that a child has replaced.
#[derive(Clone, Debug, PartialEq)]
pub struct Overridden {
    /// The plain value.
    pub value: Value,
    /// Id of the profile that set it.
    pub id: String,
}

impl Library {
    /// Every value of a profile and the file that set it. Abstract profiles can be explained too.
    ///
    /// # Errors
    /// [`ProfileError::Unknown`] with the nearest ids.
    pub fn explain(&self, kind: Kind, id: &str) -> Result<Explained, ProfileError> {
        match kind {
            Kind::Machine => self.explain_as::<MachineProfile>(id),
            Kind::Material => self.explain_as::<MaterialProfile>(id),
            Kind::Noise => self.explain_as::<NoiseProfile>(id),
            Kind::StrutBuilder => self.explain_as::<StrutBuilderProfile>(id),
        }
    }

    fn explain_as<T: Profile>(&self, id: &str) -> Result<Explained, ProfileError> {
        let layer = self.find(T::KIND, id)?;
        let chain = self.chain(layer)?;
        let Resolved { profile, .. } = self.resolve_first::<T>(layer)?;
        let levels: Vec<Merged> = (0..chain.len()).map(|level| merge(&chain[level..], T::WHOLE)).collect();
        let mut walk = Walk { chain: &chain, levels: &levels, whole: T::WHOLE, values: Vec::new() };
        if let Some(merged) = levels.first() {
            walk.group(&merged.values, &[], None);
        }
        let mut values = walk.values;
        // The text of a whole profile has its keys in the order of the documentation.
        let text = to_text(&profile).unwrap_or_default();
        values.sort_by_cached_key(|(path, _)| line_of(&text, &words(path)).unwrap_or(usize::MAX));
        let name = chain.iter().find_map(|layer| layer.values.get("name")?.as_str()).unwrap_or(id);
        Ok(Explained {
            name: name.to_owned(),
            is_abstract: layer.is_abstract,
            chain: chain.iter().map(|layer| Ancestor::from(*layer)).collect(),
            values: values.into_iter().map(|(_, value)| value).collect(),
        })
    }
}

impl From<&Layer> for Ancestor {
    fn from(layer: &Layer) -> Self {
        Self { id: layer.id.clone(), file: layer.file.clone(), shipped: layer.shipped }
    }
}

fn words(path: &[String]) -> Vec<&str> {
    path.iter().map(String::as_str).collect()
}

/// A walk over the values of a merged profile.
struct Walk<'a> {
    /// Child first.
    chain: &'a [&'a Layer],
    /// The chain merged from each of its layers on.
    levels: &'a [Merged],
    whole: &'a [&'a str],
    values: Vec<(Vec<String>, ExplainedValue)>,
}

impl Walk<'_> {
    /// Takes the values of a group; `stated` is where a list in it comes from, if the group says so.
    fn group(&mut self, group: &Map<String, Value>, path: &[String], stated: Option<&Stated>) {
        for (key, value) in group {
            if path.is_empty() && OWN.contains(&key.as_str()) {
                continue;
            }
            if stated.is_some() && ["source", "measured"].contains(&key.as_str()) {
                continue;
            }
            let path = [path, std::slice::from_ref(key)].concat();
            match value {
                Value::Object(group) if !is_figure(group) => {
                    let is_whole = self.whole.contains(&path.join(".").as_str());
                    let stated = Stated::of(group).filter(|_| is_whole);
                    self.group(group, &path, stated.as_ref());
                }
                _ => self.value(path, value, stated.filter(|_| value.is_array())),
            }
        }
    }

    fn value(&mut self, path: Vec<String>, value: &Value, stated: Option<&Stated>) {
        let key = path.join(".");
        let merged = self.levels.first();
        let Some(set_by) = merged.and_then(|merged| origin(&merged.provenance, &key)) else { return };
        let Some(level) = self.chain.iter().position(|layer| layer.id == set_by.id) else { return };
        let stated = value.as_object().and_then(Stated::of).or(stated.cloned());
        let instead_of = self.levels.get(level + 1).and_then(|parents| overridden(parents, &path, &key));
        let value = ExplainedValue {
            value: plain(value),
            id: set_by.id.clone(),
            place: self.chain[level].place(&key),
            source: stated.as_ref().map(|stated| stated.source.clone()),
            measured: stated.map(|stated| stated.measured),
            instead_of,
            key,
        };
        self.values.push((path, value));
    }
}

/// Where a figure or a list comes from.
#[derive(Clone)]
struct Stated {
    source: String,
    measured: bool,
}

impl Stated {
    fn of(object: &Map<String, Value>) -> Option<Self> {
        let source = object.get("source")?.as_str()?.to_owned();
        Some(Self { source, measured: object.get("measured")?.as_bool()? })
    }
}

/// What the parents of a layer have at a key; nothing where they have a group or no value.
fn overridden(parents: &Merged, path: &[String], key: &str) -> Option<Overridden> {
    let (first, rest) = path.split_first()?;
    let value = rest.iter().try_fold(parents.values.get(first)?, |value, part| value.get(part))?;
    let value = plain(value);
    let is_value = !value.is_null() && !value.is_object();
    let id = &origin(&parents.provenance, key)?.id;
    is_value.then(|| Overridden { value, id: id.clone() })
}

/// A figure without its source, the same whether it was written as `155` or `155.0`; anything else as
/// it is.
fn plain(value: &Value) -> Value {
    match value.as_object() {
        Some(object) if is_figure(object) => match value["value"].as_f64() {
            Some(figure) => figure.into(),
            None => value["value"].clone(),
        },
        _ => value.clone(),
    }
}
