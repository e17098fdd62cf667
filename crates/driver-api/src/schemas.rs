//! The JSON Schema of every message, for authors of drivers in other languages.

use schemars::JsonSchema;
use schemars::generate::SchemaSettings;
use serde_json::Value;

use crate::{ArmedReply, Call, Description, DriverError, Encoded, Event, Limits, Ports, Sent};

/// Name and JSON Schema of each message that crosses the boundary.
#[must_use]
pub fn message_schemas() -> Vec<(&'static str, Value)> {
    vec![
        ("description", schema_of::<Description>()),
        ("call", schema_of::<Call>()),
        ("encoded", schema_of::<Encoded>()),
        ("armed", schema_of::<ArmedReply>()),
        ("sent", schema_of::<Sent>()),
        ("ports", schema_of::<Ports>()),
        ("limits", schema_of::<Limits>()),
        ("event", schema_of::<Event>()),
        ("error", schema_of::<DriverError>()),
    ]
}

fn schema_of<T: JsonSchema>() -> Value {
    SchemaSettings::draft2020_12().into_generator().into_root_schema_for::<T>().to_value()
}
