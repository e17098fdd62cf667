//! Figures that say where they come from, and other small values of profiles.

use std::borrow::Cow;
use std::ops::Deref;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{DeserializeOwned, Error};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::Value;

/// A figure with its source. Replaced whole by a child profile, so that a new value never keeps
/// an old source.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "Sourced_{T}")]
pub struct Sourced<T> {
    /// The figure, in the unit that the key's suffix names.
    pub value: T,
    /// Where the figure comes from: a paper, a data sheet, a measurement, or why it is an estimate.
    #[schemars(length(min = 1))]
    pub source: String,
    /// True when it was measured on the real machine or wire; false for a stated, derived or
    /// estimated figure.
    pub measured: bool,
    /// The true value is this near, in 95 of 100 cases, as a calibration has found; absent where nobody said.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.0))]
    pub within_95: Option<f64>,
    /// The same before that calibration, from which the next one starts; absent where nobody said.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 0.0))]
    pub within_95_before: Option<f64>,
}

/// A value that is no figure, such as a sign or a choice. In a file it is an object like that of a [`Sourced`]; the plain value,
/// which says nothing of where it comes from, is taken too, as files have it that were written before these values had sources.
#[derive(Clone, Debug, PartialEq)]
pub struct Noted<T> {
    /// The value.
    pub value: T,
    /// Where it comes from; `None` where the file does not say.
    pub source: Option<String>,
    /// As of a [`Sourced`]; false without a source.
    pub measured: bool,
}

impl<T> Deref for Noted<T> {
    type Target = T;

    fn deref(&self) -> &T {
        &self.value
    }
}

impl<T: Serialize> Serialize for Noted<T> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        match &self.source {
            None => self.value.serialize(to),
            Some(source) => {
                let source = source.clone();
                Sourced {
                    value: &self.value,
                    source,
                    measured: self.measured,
                    within_95: None,
                    within_95_before: None,
                }
                .serialize(to)
            }
        }
    }
}

impl<'de, T: DeserializeOwned> Deserialize<'de> for Noted<T> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let value = Value::deserialize(from)?;
        if value.is_object() {
            let Sourced { value, source, measured, within_95: _, within_95_before: _ } =
                serde_json::from_value::<Sourced<T>>(value).map_err(D::Error::custom)?;
            return Ok(Self { value, source: Some(source), measured });
        }
        let value = serde_json::from_value(value).map_err(D::Error::custom)?;
        Ok(Self { value, source: None, measured: false })
    }
}

impl<T: JsonSchema> JsonSchema for Noted<T> {
    fn schema_name() -> Cow<'static, str> {
        format!("Noted_{}", T::schema_name()).into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let stated = generator.subschema_for::<Sourced<T>>();
        let plain = generator.subschema_for::<T>();
        json_schema!({
            "description": "A value with its source; the plain value is taken too.",
            "anyOf": [stated, plain]
        })
    }
}

/// A publication that the `source` texts of a profile refer to.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Reference {
    /// The short name that `source` texts use.
    #[schemars(length(min = 1))]
    pub key: String,
    /// Authors, title, venue, year.
    #[schemars(length(min = 1))]
    pub citation: String,
    /// DOI without a resolver's address.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub doi: Option<String>,
    /// Address of a page.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub url: Option<String>,
}

/// Direction of a machine's axis against the canonical, right-handed one. JSON: `1` or `-1`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(try_from = "i64", into = "i64")]
pub enum Sign {
    /// The machine's value is the canonical one.
    Same,
    /// The machine's value is the canonical one negated.
    Opposite,
}

impl Sign {
    /// `1.0` or `-1.0`: the machine's value is this times the canonical value.
    #[must_use]
    pub fn factor(self) -> f64 {
        match self {
            Self::Same => 1.0,
            Self::Opposite => -1.0,
        }
    }
}

impl TryFrom<i64> for Sign {
    type Error = String;

    fn try_from(value: i64) -> Result<Self, String> {
        match value {
            1 => Ok(Self::Same),
            -1 => Ok(Self::Opposite),
            other => Err(format!("a sign is 1 or -1, not {other}")),
        }
    }
}

impl From<Sign> for i64 {
    fn from(sign: Sign) -> Self {
        match sign {
            Sign::Same => 1,
            Sign::Opposite => -1,
        }
    }
}

impl JsonSchema for Sign {
    fn schema_name() -> Cow<'static, str> {
        "Sign".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        json_schema!({
            "description": "1: the machine's value is the canonical one; -1: negated.",
            "enum": [1, -1]
        })
    }
}
