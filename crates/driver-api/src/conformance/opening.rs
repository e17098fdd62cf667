//! Rules about settings and about the instance as such.

use serde_json::json;

use super::subject::{done, refused};
use super::{Conformance, Subject};

/// Whether an instance can be had at all.
pub(super) fn check(subject: &mut dyn Subject, found: &mut Conformance) -> bool {
    let opens = done(subject.open(b"{}")).map(drop);
    if !found.note("opens with the default settings", opens) {
        return false;
    }
    found.note("has no events before it is connected", quiet(subject));
    found.note("refuses a call that it does not know, as 'unknown-call'", unknown_call(subject));
    found.note("refuses a request that is no JSON", garbage(subject));
    found.note("refuses settings with a key that it does not know, by name", unknown_key(subject));
    found.note("refuses settings that are no object", refused(subject.open(b"[1, 2")).map(drop));
    let again = done(subject.open(b"{}")).and_then(|_| done(subject.open(b"{}"))).map(drop);
    found.note("opens again after it was closed", again)
}

fn quiet(subject: &mut dyn Subject) -> Result<(), String> {
    let event = done(subject.poll())?;
    if event.is_empty() { Ok(()) } else { Err(format!("it reported {}", String::from_utf8_lossy(&event))) }
}

fn unknown_call(subject: &mut dyn Subject) -> Result<(), String> {
    let call = json!({"call": "whistle", "tune": [1, 2, 3]}).to_string();
    let error = refused(subject.call(call.as_bytes()))?;
    if error.code == "unknown-call" { Ok(()) } else { Err(format!("the code is '{}'", error.code)) }
}

fn garbage(subject: &mut dyn Subject) -> Result<(), String> {
    for request in [&b""[..], b"\xff\xfe\x00", b"{\"call\":", b"[[[[", b"{}"] {
        refused(subject.call(request))
            .map_err(|what| format!("{what}: {}", String::from_utf8_lossy(request)))?;
    }
    Ok(())
}

fn unknown_key(subject: &mut dyn Subject) -> Result<(), String> {
    const KEY: &str = "no_driver_has_this_key";
    let error = refused(subject.open(json!({ KEY: 1 }).to_string().as_bytes()))?;
    if error.message.contains(KEY) { Ok(()) } else { Err(format!("the message does not name it: {error}")) }
}
