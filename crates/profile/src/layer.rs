//! One profile file as read: the layer that merging puts on its parent.

use serde_json::error::Category;
use serde_json::{Map, Value};
use wirebend_error::ErrorRemedy;

use crate::error::nearest;
use crate::kind::is_slug;
use crate::position::line_of;
use crate::rules::FIGURE;
use crate::{
    Kind, MAX_FILE_BYTES, MachineProfile, MaterialProfile, NoiseProfile, Place, Profile, ProfileError,
    SCHEMA_VERSION, StrutBuilderProfile,
};

/// One file that is a profile by itself; whether it fits its parents is not known yet.
#[derive(Clone, Debug)]
pub(crate) struct Layer {
    pub(crate) kind: Kind,
    pub(crate) id: String,
    pub(crate) inherits: Option<String>,
    pub(crate) is_abstract: bool,
    pub(crate) file: String,
    pub(crate) text: String,
    pub(crate) values: Map<String, Value>,
    pub(crate) shipped: bool,
}

impl Layer {
    /// Reads one file. A byte order mark is passed over.
    ///
    /// # Errors
    /// The first thing that makes the file no profile, with its line.
    pub(crate) fn read(file: &str, bytes: &[u8], shipped: bool) -> Result<Self, ProfileError> {
        let layer = Self::read_shared(file, bytes, shipped)?;
        layer.check_file_name()?;
        Ok(layer)
    }

    /// As [`Self::read`], of a file that is passed on under any name, or that has other profiles in it as well.
    pub(crate) fn read_shared(file: &str, bytes: &[u8], shipped: bool) -> Result<Self, ProfileError> {
        if bytes.len() > MAX_FILE_BYTES {
            return Err(ProfileError::TooLarge { file: file.into(), limit: MAX_FILE_BYTES });
        }
        let text = std::str::from_utf8(bytes)
            .map_err(|error| ProfileError::NotText { file: file.into(), byte: error.valid_up_to() })?;
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let value: Value = serde_json::from_str(text).map_err(|error| json_error(file, &error))?;
        let Value::Object(values) = value else {
            let place = Place { file: file.into(), line: Some(1) };
            return Err(ProfileError::UnknownKind { place, found: "not a JSON object".into() });
        };
        let kind = kind_of(file, text, &values)?;
        check_version(file, text, &values)?;
        let layer = match kind {
            Kind::Machine => Self::of::<MachineProfile>(file, text, values, shipped),
            Kind::Material => Self::of::<MaterialProfile>(file, text, values, shipped),
            Kind::Noise => Self::of::<NoiseProfile>(file, text, values, shipped),
            Kind::StrutBuilder => Self::of::<StrutBuilderProfile>(file, text, values, shipped),
        }?;
        layer.check_id()?;
        Ok(layer)
    }

    fn of<T: Profile>(
        file: &str,
        text: &str,
        values: Map<String, Value>,
        shipped: bool,
    ) -> Result<Self, ProfileError> {
        let profile: T = serde_json::from_str(text).map_err(|error| json_error(file, &error))?;
        Ok(Self {
            kind: T::KIND,
            id: profile.id().into(),
            inherits: profile.inherits().map(Into::into),
            is_abstract: profile.is_abstract(),
            file: file.into(),
            text: text.into(),
            values,
            shipped,
        })
    }

    fn check_id(&self) -> Result<(), ProfileError> {
        let (place, id) = (self.place("id"), self.id.clone());
        if !is_slug(&id) {
            return Err(ProfileError::BadId { place, id });
        }
        Ok(())
    }

    fn check_file_name(&self) -> Result<(), ProfileError> {
        let (place, id) = (self.place("id"), self.id.clone());
        let name = self.file.rsplit(['/', '\\']).next().unwrap_or(&self.file);
        if name.strip_suffix(".json") != Some(&id) {
            return Err(ProfileError::IdNotFileName { place, id });
        }
        Ok(())
    }

    /// The file and the line of a dotted key, or of the nearest group that the file has.
    pub(crate) fn place(&self, key: &str) -> Place {
        let path: Vec<&str> = key.split('.').collect();
        Place { file: self.file.clone(), line: line_of(&self.text, &path) }
    }
}

fn kind_of(file: &str, text: &str, values: &Map<String, Value>) -> Result<Kind, ProfileError> {
    let found = match values.get("kind") {
        None => "no \"kind\"".to_owned(),
        Some(Value::String(word)) => match Kind::from_word(word) {
            Some(kind) => return Ok(kind),
            None => format!("the unknown kind \"{word}\""),
        },
        Some(_) => "a \"kind\" that is not text".to_owned(),
    };
    let place = Place { file: file.into(), line: line_of(text, &["kind"]).or(Some(1)) };
    Err(ProfileError::UnknownKind { place, found })
}

/// Before anything else of the file is read: a newer format may have keys unknown here.
fn check_version(file: &str, text: &str, values: &Map<String, Value>) -> Result<(), ProfileError> {
    let Some(found) = values.get("schema_version").and_then(Value::as_u64) else {
        return Ok(());
    };
    let place = Place { file: file.into(), line: line_of(text, &["schema_version"]) };
    if found > u64::from(SCHEMA_VERSION) {
        return Err(ProfileError::NewerVersion { place, found, known: SCHEMA_VERSION });
    }
    if found == 0 {
        return Err(ProfileError::Rule {
            place,
            key: "schema_version".into(),
            found: "0".into(),
            expected: SCHEMA_VERSION.to_string(),
        });
    }
    Ok(())
}

fn json_error(file: &str, error: &serde_json::Error) -> ProfileError {
    let line = (error.line() > 0).then_some(error.line());
    let place = Place { file: file.into(), line };
    let text = error.to_string();
    let message = text.split(" at line ").next().unwrap_or(&text).to_owned();
    let column = error.column();
    if error.classify() != Category::Data {
        return ProfileError::Syntax { place, column, message };
    }
    let message = message.replace("struct Sourced", "a figure with its source");
    let remedy = Box::new(key_hint(&message));
    ProfileError::Shape { place, column, message, remedy }
}

/// What to do about serde's message: the nearest of the keys that it lists in backticks.
fn key_hint(message: &str) -> ErrorRemedy {
    let mut words = message.split('`').skip(1).step_by(2);
    let add = |text: String| ErrorRemedy::AddKey { text };
    if message.starts_with("unknown field") {
        let near = words.next().map(|unknown| nearest(unknown, words)).unwrap_or_default();
        if !near.is_empty() {
            return ErrorRemedy::ChooseKnown { near, known: Vec::new() };
        }
    } else if message.ends_with("a figure with its source") {
        return add(FIGURE.to_owned());
    } else if message.starts_with("missing field")
        && let Some(key) = words.next()
    {
        return add(format!("\"{key}\""));
    }
    ErrorRemedy::SeeSchema
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_misspelt_key_is_answered_with_the_nearest_one() {
        let message = "unknown field `max_bend`, expected one of `min_edge_mm`, `max_bend_deg`";
        let near = vec!["max_bend_deg".to_owned()];
        assert_eq!(key_hint(message), ErrorRemedy::ChooseKnown { near, known: Vec::new() });
        assert_eq!(key_hint("missing field `source`"), ErrorRemedy::AddKey { text: "\"source\"".to_owned() });
        assert_eq!(key_hint("unknown field `x`, there are no fields"), ErrorRemedy::SeeSchema);
    }
}
