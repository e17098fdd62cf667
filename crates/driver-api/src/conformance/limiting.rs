//! Rules about what a driver says of its machine's limits.

use super::subject::done;
use super::{Conformance, Subject};
use crate::{AxisLimit, AxisRate, Call, Capability, Description, DriverError, Lack, Limits, Reply};

pub(super) fn check(subject: &mut dyn Subject, description: &Description, found: &mut Conformance) {
    found.note("reports limits and rates above zero, with settings that it has", told(subject, description));
}

/// A driver of 1.1 does not know the call.
fn told(subject: &mut dyn Subject, description: &Description) -> Result<(), String> {
    let call = serde_json::to_vec(&Call::Limits).unwrap_or_default();
    let reply = match subject.call(&call).map_err(|broken| broken.0)? {
        Reply::Refused(refusal) => {
            let error: Result<DriverError, _> = serde_json::from_slice(&refusal);
            return match error {
                Ok(error) if error.code == "unknown-call" => Ok(()),
                _ => Err(format!("it refused: {}", String::from_utf8_lossy(&refusal))),
            };
        }
        reply @ Reply::Ok(_) => done(Ok(reply))?,
    };
    let Limits { limits, rates, cutter_mm, lacks } =
        serde_json::from_slice(&reply).map_err(|error| format!("the limits cannot be read: {error}"))?;
    for AxisLimit { axis, most, setting, reason, .. } in &limits {
        above_zero(&format!("the limit of {axis:?}"), *most)?;
        if setting.is_none() && reason.trim().is_empty() {
            return Err(format!("the limit of {axis:?} names neither a setting nor a reason"));
        }
        setting.iter().try_for_each(|key| known(key, description))?;
    }
    if let Some(mm) = cutter_mm {
        if !mm.is_finite() {
            return Err(format!("its cutter is at {mm}"));
        }
        if !description.can(Capability::Cut) {
            return Err("it has a cutter, and the driver has not the capability 'cut'".to_owned());
        }
    }
    for Lack { capability, reason, help } in &lacks {
        if !description.can(*capability) {
            return Err(format!("its machine lacks {capability:?}, which the driver cannot either"));
        }
        if reason.trim().is_empty() || help.trim().is_empty() {
            return Err(format!("it does not say why its machine lacks {capability:?}, or what to do"));
        }
    }
    for AxisRate { axis, per_s, settings } in &rates {
        above_zero(&format!("the rate of {axis:?}"), *per_s)?;
        settings.iter().try_for_each(|key| known(key, description))?;
    }
    Ok(())
}

fn above_zero(what: &str, value: f64) -> Result<(), String> {
    if value.is_finite() && value > 0.0 { Ok(()) } else { Err(format!("{what} is {value}")) }
}

fn known(key: &str, description: &Description) -> Result<(), String> {
    let has = description.settings_schema["properties"].get(key).is_some();
    if has { Ok(()) } else { Err(format!("the settings have no key '{key}'")) }
}
