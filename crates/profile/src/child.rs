//! The text of a new profile that inherits from a known one.

use serde_json::{Map, Value};

use crate::heading::OWN;
use crate::library::Library;
use crate::merge::merge;
use crate::resolve::typed;
use crate::{
    Kind, MachineProfile, MaterialProfile, NoiseProfile, Profile, ProfileError, SCHEMA_VERSION,
    StrutBuilderProfile, to_text,
};

/// A profile to be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Child<'a> {
    /// Kind of both.
    pub kind: Kind,
    /// Its id.
    pub id: &'a str,
    /// Id of its parent.
    pub inherits: &'a str,
    /// Name for people.
    pub name: &'a str,
    /// Address or path of the JSON Schema, for editors.
    pub schema: Option<&'a str>,
    /// Whether to write every value of the parent, to be changed; otherwise the heading alone.
    pub all: bool,
}

impl Library {
    /// The text of a new profile. Whether it can be used is for [`Library::check`] to say.
    ///
    /// # Errors
    /// [`ProfileError::Unknown`] with the nearest ids when there is no such parent.
    pub fn child_text(&self, child: &Child<'_>) -> Result<String, ProfileError> {
        match child.kind {
            Kind::Machine => self.child_text_as::<MachineProfile>(child),
            Kind::Material => self.child_text_as::<MaterialProfile>(child),
            Kind::Noise => self.child_text_as::<NoiseProfile>(child),
            Kind::StrutBuilder => self.child_text_as::<StrutBuilderProfile>(child),
        }
    }

    fn child_text_as<T: Profile>(&self, child: &Child<'_>) -> Result<String, ProfileError> {
        let parent = self.find(T::KIND, child.inherits)?;
        let mut values = Map::new();
        if child.all {
            values = merge(&self.chain(parent)?, T::WHOLE).values;
            values.retain(|key, _| !OWN.contains(&key.as_str()));
        }
        let heading: [(&str, Option<Value>); 6] = [
            ("$schema", child.schema.map(Value::from)),
            ("schema_version", Some(SCHEMA_VERSION.into())),
            ("kind", Some(child.kind.word().into())),
            ("id", Some(child.id.into())),
            ("inherits", Some(child.inherits.into())),
            ("name", Some(child.name.into())),
        ];
        for (key, value) in heading {
            values.extend(value.map(|value| (key.to_owned(), value)));
        }
        let text = to_text(&typed::<T>(values, &parent.file)?);
        text.map(|text| figures_on_a_line(&text)).map_err(|error| crate::resolve::unfit(&parent.file, &error))
    }
}

impl Library {
    /// The text of a profile that needs no other profile of its kind but one that comes with the program: what it inherits
    /// from profiles of a person's own is written into it.
    ///
    /// # Errors
    /// [`ProfileError::Unknown`] with the nearest ids when there is no such profile.
    pub fn portable_text(&self, kind: Kind, id: &str) -> Result<String, ProfileError> {
        match kind {
            Kind::Machine => self.portable_text_as::<MachineProfile>(id),
            Kind::Material => self.portable_text_as::<MaterialProfile>(id),
            Kind::Noise => self.portable_text_as::<NoiseProfile>(id),
            Kind::StrutBuilder => self.portable_text_as::<StrutBuilderProfile>(id),
        }
    }

    fn portable_text_as<T: Profile>(&self, id: &str) -> Result<String, ProfileError> {
        let layer = self.find(T::KIND, id)?;
        let chain = self.chain(layer)?;
        let own: Vec<_> = chain.iter().take_while(|layer| !layer.shipped).copied().collect();
        let name = chain.iter().find_map(|layer| layer.values.get("name"));
        let mut merged = merge(if own.is_empty() { &chain[..1] } else { &own }, T::WHOLE).values;
        if !layer.values.contains_key("calibrated") {
            // That made one of its parents, and not the profile itself.
            merged.remove("calibrated");
        }
        let inherits = chain.get(own.len().max(1)).map(|parent| Value::from(parent.id.as_str()));
        let mut values = Map::new();
        for key in ["schema_version", "kind", "id"] {
            values.extend(merged.get(key).map(|value| (key.to_owned(), value.clone())));
        }
        values.extend(inherits.map(|id| ("inherits".to_owned(), id)));
        values.extend(name.map(|name| ("name".to_owned(), name.clone())));
        for (key, value) in merged {
            if key != "$schema" && key != "inherits" {
                values.entry(key).or_insert(value);
            }
        }
        let text = serde_json::to_string_pretty(&values);
        let text = text.map_err(|error| crate::resolve::unfit(&layer.file, &error))? + "\n";
        Ok(written(T::KIND, &text).unwrap_or(text))
    }
}

impl Library {
    /// The profiles of a person's own that a profile names, such as the wire of a machine: kind and id, each once.
    ///
    /// # Errors
    /// [`ProfileError::Unknown`] with the nearest ids when there is no such profile.
    pub fn own_named(&self, kind: Kind, id: &str) -> Result<Vec<(Kind, String)>, ProfileError> {
        match kind {
            Kind::Machine => self.own_named_as::<MachineProfile>(id),
            Kind::Material => self.own_named_as::<MaterialProfile>(id),
            Kind::Noise => self.own_named_as::<NoiseProfile>(id),
            Kind::StrutBuilder => self.own_named_as::<StrutBuilderProfile>(id),
        }
    }

    fn own_named_as<T: Profile>(&self, id: &str) -> Result<Vec<(Kind, String)>, ProfileError> {
        let resolved = self.resolve_first::<T>(self.find(T::KIND, id)?)?;
        let named = resolved.profile.references().into_iter();
        let own = named.filter(|(_, kind, id)| self.layer(*kind, id).is_some_and(|layer| !layer.shipped));
        Ok(own.map(|(_, kind, id)| (kind, id.to_owned())).collect())
    }
}

/// The text of a profile as this program writes one: keys in the order of the documentation, a figure on a line. One that
/// takes inherited values away keeps its order, since the types of profiles know no value that is taken away. `None` where it
/// is no profile of the kind; [`Library::check`] says why.
#[must_use]
pub fn written(kind: Kind, text: &str) -> Option<String> {
    fn of<T: Profile>(text: &str) -> Option<String> {
        to_text(&serde_json::from_str::<T>(text).ok()?).ok()
    }
    if serde_json::from_str(text).is_ok_and(|value| takes_away(&value)) {
        return Some(figures_on_a_line(text));
    }
    let text = match kind {
        Kind::Machine => of::<MachineProfile>(text),
        Kind::Material => of::<MaterialProfile>(text),
        Kind::Noise => of::<NoiseProfile>(text),
        Kind::StrutBuilder => of::<StrutBuilderProfile>(text),
    };
    text.map(|text| figures_on_a_line(&text))
}

/// Whether a group of values has one that takes an inherited value away.
fn takes_away(value: &Value) -> bool {
    match value {
        Value::Null => true,
        Value::Object(group) => group.values().any(takes_away),
        _ => false,
    }
}

/// Puts each figure with its source on one line, as in the shipped files: a person who goes through
/// them compares values, not braces.
fn figures_on_a_line(text: &str) -> String {
    let mut made = String::new();
    let mut lines = text.lines().peekable();
    while let Some(line) = lines.next() {
        made.push_str(line);
        // JSON has no line break inside a text, so a brace at the end of a line is a real one.
        let is_figure = line.ends_with('{')
            && lines.peek().is_some_and(|next| next.trim_start().starts_with("\"value\": "));
        while is_figure && let Some(part) = lines.next() {
            made.push(' ');
            made.push_str(part.trim_start());
            if part.trim_start().starts_with('}') {
                break;
            }
        }
        made.push('\n');
    }
    made
}
