//! From an id to a complete profile: the chain of parents, the merge, and the rules.

use serde_json::{Map, Value};
use wirebend_error::ErrorRemedy;

use crate::layer::Layer;
use crate::library::Library;
use crate::merge::{Merged, merge};
use crate::profile::Fault;
use crate::resolved::{Resolved, origin};
use crate::{Kind, Place, Profile, ProfileError};

impl Library {
    /// The profile and its ancestors, child first.
    pub(crate) fn chain<'a>(&'a self, first: &'a Layer) -> Result<Vec<&'a Layer>, ProfileError> {
        let mut chain = vec![first];
        let mut layer = first;
        while let Some(parent) = &layer.inherits {
            if chain.iter().any(|seen| &seen.id == parent) {
                let ids = chain.iter().map(|seen| seen.id.clone());
                let chain = ids.chain([parent.clone()]).collect();
                return Err(ProfileError::Cycle { place: first.place("inherits"), chain });
            }
            let place = layer.place("inherits");
            layer = self.layer(first.kind, parent).ok_or_else(|| ProfileError::UnknownParent {
                place,
                kind: first.kind,
                parent: parent.clone(),
                remedy: Box::new(self.known(first.kind, parent, &layer.id)),
            })?;
            chain.push(layer);
        }
        Ok(chain)
    }

    /// Merges a profile with its parents and applies every rule to the whole.
    pub(crate) fn resolve<T: Profile>(&self, layer: &Layer) -> Result<Resolved<T>, Vec<ProfileError>> {
        let chain = self.chain(layer).map_err(|error| vec![error])?;
        let merged = merge(&chain, T::WHOLE);
        let profile: T = typed(merged.values.clone(), &layer.file).map_err(|error| vec![error])?;
        let errors = Whole { library: self, chain: &chain, merged: &merged }.errors(&profile);
        if !errors.is_empty() {
            return Err(errors);
        }
        let chain = chain.iter().map(|layer| layer.id.clone()).collect();
        Ok(Resolved { profile, provenance: merged.provenance, chain })
    }

    /// Applies every rule to one profile of any kind.
    pub(crate) fn errors_of(&self, layer: &Layer) -> Vec<ProfileError> {
        let result = match layer.kind {
            Kind::Machine => self.resolve::<crate::MachineProfile>(layer).map(drop),
            Kind::Material => self.resolve::<crate::MaterialProfile>(layer).map(drop),
            Kind::Noise => self.resolve::<crate::NoiseProfile>(layer).map(drop),
            Kind::StrutBuilder => self.resolve::<crate::StrutBuilderProfile>(layer).map(drop),
        };
        result.err().unwrap_or_default()
    }
}

/// A merged profile under examination.
struct Whole<'a> {
    library: &'a Library,
    chain: &'a [&'a Layer],
    merged: &'a Merged,
}

impl Whole<'_> {
    fn errors<T: Profile>(&self, profile: &T) -> Vec<ProfileError> {
        let mut errors = Vec::new();
        if !profile.is_abstract() {
            self.missing(profile, &mut errors);
        }
        for fault in profile.faults() {
            let place = self.place(self.nearer(&fault));
            let (key, found, expected) = (fault.key, fault.found, fault.expected);
            errors.push(ProfileError::Rule { place, key, found, expected });
        }
        for (key, value) in self
            .merged
            .provenance
            .keys()
            .filter_map(|key| lookup(&self.merged.values, key).map(|value| (key, value)))
        {
            if value.get("source").and_then(Value::as_str).is_some_and(is_blank)
                && value.get("value").is_some()
            {
                errors.push(ProfileError::Rule {
                    place: self.place(key),
                    key: format!("{key}.source"),
                    found: "an empty text".into(),
                    expected: "where the figure comes from, or why it is an estimate".into(),
                });
            }
        }
        for (key, kind, id) in profile.references() {
            let named = self.library.layer(kind, id);
            let is_abstract = named.is_some_and(|layer| layer.is_abstract);
            // What is abstract itself leaves it to its children to name another.
            if named.is_some() && (!is_abstract || profile.is_abstract()) {
                continue;
            }
            let remedy = Box::new(self.library.usable(kind, id));
            let (place, key, id) = (self.place(key), key.to_owned(), id.to_owned());
            errors.push(if is_abstract {
                ProfileError::AbstractReference { place, key, kind, id, remedy }
            } else {
                ProfileError::UnknownReference { place, key, kind, id, remedy }
            });
        }
        errors
    }

    fn missing<T: Profile>(&self, profile: &T, errors: &mut Vec<ProfileError>) {
        let Some(file) = self.chain.first().map(|layer| layer.file.clone()) else {
            return;
        };
        for (key, how) in profile.required() {
            let value = lookup(&self.merged.values, key);
            let blank = value.is_none_or(|value| value.is_null() || value.as_str().is_some_and(is_blank));
            if blank {
                let (key, how) = (key.to_owned(), example(key, how));
                errors.push(ProfileError::Missing { file: file.clone(), key, how });
            }
        }
    }

    /// Of the two keys of a contradiction, the one that was set later: a child's is at fault, not
    /// its parent's.
    fn nearer<'f>(&self, fault: &'f Fault) -> &'f str {
        let depth = |key: &str| {
            let set_by = origin(&self.merged.provenance, key);
            self.chain.iter().position(|layer| set_by.is_some_and(|by| by.id == layer.id))
        };
        match &fault.against {
            Some(other) if depth(other) < depth(&fault.key) => other,
            _ => &fault.key,
        }
    }

    /// The line that set a value, in whichever file of the chain did.
    fn place(&self, key: &str) -> Place {
        let set_by = origin(&self.merged.provenance, key);
        let layer = self.chain.iter().find(|layer| set_by.is_some_and(|by| by.id == layer.id));
        match layer.or(self.chain.first()) {
            Some(layer) => layer.place(key),
            None => Place::file(""),
        }
    }
}

/// Merged values as the profile that they are.
pub(crate) fn typed<T: Profile>(values: Map<String, Value>, file: &str) -> Result<T, ProfileError> {
    serde_json::from_value(Value::Object(values)).map_err(|error| unfit(file, &error))
}

/// A file and its parents that are each a profile and together are none.
pub(crate) fn unfit(file: &str, error: &serde_json::Error) -> ProfileError {
    ProfileError::Shape {
        place: Place::file(file),
        column: 0,
        message: format!("the file and its parents do not fit together: {error}"),
        remedy: Box::new(ErrorRemedy::CorrectProfile),
    }
}

fn is_blank(text: &str) -> bool {
    text.trim().is_empty()
}

fn lookup<'a>(values: &'a Map<String, Value>, key: &str) -> Option<&'a Value> {
    let mut parts = key.split('.');
    let first = values.get(parts.next()?)?;
    parts.try_fold(first, |value, part| value.get(part))
}

/// What to write for a dotted key: its groups around it.
pub(crate) fn example(key: &str, how: &str) -> String {
    match key.split_once('.') {
        Some((group, rest)) => format!("\"{group}\": {{{}}}", example(rest, how)),
        None => format!("\"{key}\": {how}"),
    }
}
