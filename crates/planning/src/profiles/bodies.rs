//! One body of a machine, as `profile set ID shapes.NAME=…` sets it: the list of bodies itself is replaced as a whole.

use serde_json::{Map, Value};
use wirebend_error::InputName;

use super::own::OwnProfile;
use crate::PlanningError;

/// Adds a source to what has none of its own.
pub(super) fn with_source(of: &mut Map<String, Value>, (source, measured): (&str, bool)) {
    if !of.contains_key("source") {
        of.insert("source".to_owned(), source.into());
        of.insert("measured".to_owned(), measured.into());
    }
}

/// Changes the body of this name by the keys that are given, adds it where there is none, or takes it out with null. The bodies are
/// those of the file, or where it has none those of its parents. Gives the body as it was.
pub(super) fn set_body(
    profile: &mut OwnProfile,
    parents: Option<&Value>,
    name: &str,
    value: &Value,
    (source, measured): (&str, bool),
) -> Result<Value, PlanningError> {
    let list = profile.own_value("shapes").or(parents).and_then(Value::as_array);
    let mut bodies = list.cloned().unwrap_or_default();
    let at = bodies.iter().position(|body| body.get("name").and_then(Value::as_str) == Some(name));
    let before = at.map(|at| bodies[at].clone()).unwrap_or_default();
    let wrong = |expected| PlanningError::Value {
        input: Some(InputName::ProfileValues),
        name: "a body",
        value: format!("'{name}'"),
        expected,
    };
    match (value, at) {
        (Value::Null, Some(at)) => drop(bodies.remove(at)),
        (Value::Null, None) => return Err(wrong("the name of a body that the machine has")),
        (Value::Object(given), _) => {
            let mut body = before.as_object().cloned().unwrap_or_default();
            // Its figures are new: what was said of the old ones does not hold for them.
            body.remove("source");
            body.remove("measured");
            body.extend(given.clone());
            body.entry("name").or_insert_with(|| name.into());
            with_source(&mut body, (source, measured));
            match at {
                Some(at) => bodies[at] = body.into(),
                None => bodies.push(body.into()),
            }
        }
        _ => {
            return Err(wrong(
                "an object with what changes of it, such as {\"at_mm\": [0, 0, -40]}, or null",
            ));
        }
    }
    profile.set("shapes", bodies.into())?;
    Ok(before)
}
