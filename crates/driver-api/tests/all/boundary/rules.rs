//! Each rule of the conformance kit finds what breaks it.

use serde_json::{Value, json};
use wirebend_driver_api::conformance::{self, Broken, Conformance, Subject};
use wirebend_driver_api::{Reply, SafeTable, TableError};

/// A driver that answers as `Plain` does, but for what a test changes.
struct Changed<F> {
    table: SafeTable,
    change: F,
}

impl<F: Fn(&str, &[u8], Value) -> Value> Changed<F> {
    fn pass(&self, function: &str, asked: &[u8], reply: Result<Reply, TableError>) -> Result<Reply, Broken> {
        let (kept, bytes) = match reply? {
            Reply::Ok(bytes) => (true, bytes),
            Reply::Refused(bytes) => (false, bytes),
        };
        let value = serde_json::from_slice(&bytes).unwrap_or(Value::Null);
        let changed = (self.change)(function, asked, value.clone());
        let bytes = if changed == value { bytes } else { changed.to_string().into_bytes() };
        // What has no `code` is no refusal.
        let refused = changed.get("code").is_some() || (!kept && changed == value);
        Ok(if refused { Reply::Refused(bytes) } else { Reply::Ok(bytes) })
    }
}

impl<F: Fn(&str, &[u8], Value) -> Value> Subject for Changed<F> {
    fn describe(&mut self) -> Result<Reply, Broken> {
        let reply = self.table.describe();
        self.pass("describe", b"", reply)
    }

    fn open(&mut self, settings: &[u8]) -> Result<Reply, Broken> {
        let reply = self.table.open(settings);
        self.pass("open", settings, reply)
    }

    fn call(&mut self, request: &[u8]) -> Result<Reply, Broken> {
        let reply = self.table.call(request);
        self.pass("call", request, reply)
    }

    fn poll(&mut self) -> Result<Reply, Broken> {
        let reply = self.table.poll();
        self.pass("poll", b"", reply)
    }

    fn close(&mut self) -> Result<(), Broken> {
        Ok(self.table.close()?)
    }
}

fn examine(change: impl Fn(&str, &[u8], Value) -> Value) -> Conformance {
    conformance::check(&mut Changed { table: super::table_of_plain(), change })
}

/// What is broken when the description has another value at a place.
fn broken_by(place: &str, other: &Value) -> Vec<String> {
    let found = examine(|function, _, mut value| {
        if function == "describe" {
            *value.pointer_mut(place).unwrap() = other.clone();
        }
        value
    });
    found.findings.into_iter().filter_map(|finding| finding.broken).collect()
}

#[test]
fn what_is_wrong_with_a_description_is_found() {
    let cases = [
        ("/id", json!("Plain Driver"), "'Plain Driver' is not such an id"),
        ("/version", json!("one"), "not a version of three numbers"),
        ("/name", json!(" "), "the name or the description is empty"),
        ("/formats/0/extensions/0", json!(".txt"), "write it without its dot"),
        ("/formats/0/extensions", json!([]), "needs a name and a file name extension"),
        ("/formats", json!([]), "'export' and a list of formats go together"),
        ("/capabilities", json!(["export", "pause"]), "'pause' and 'resume' go together"),
        ("/capabilities", json!(["export", "jog"]), "need 'live'"),
        ("/capabilities", json!(["export", "ports"]), "need 'live'"),
        ("/capabilities", json!(["export", "settings"]), "need 'live'"),
        ("/settings_schema/type", json!("array"), "not that of an object"),
        ("/settings_schema/additionalProperties", json!(true), "unknown keys are to be refused"),
        (
            "/settings_schema/properties/decimals/description",
            json!(""),
            "the key 'decimals' has no description",
        ),
        ("/capabilities", json!(["whistle"]), "not one of those of this version"),
        ("/formats", json!("none"), "the description cannot be read"),
    ];
    for (place, other, expected) in cases {
        let broken = broken_by(place, &other);
        assert!(broken.iter().any(|what| what.contains(expected)), "{place} = {other}: {broken:#?}");
    }
}

/// What is broken when `change` has a hand in the answers.
#[track_caller]
fn assert_broken(rule: &str, change: impl Fn(&str, &[u8], Value) -> Value) {
    let found = examine(change);
    let broken = found.findings.iter().any(|finding| finding.rule.contains(rule) && finding.broken.is_some());
    assert!(broken, "nothing against '{rule}':\n{found}");
}

#[test]
fn what_is_wrong_with_answers_is_found() {
    let holds = |asked: &[u8], what: &str| String::from_utf8_lossy(asked).contains(what);
    assert_broken("opens with the default settings", |function, _, value| {
        if function == "open" { json!({"code": "no", "message": "no"}) } else { value }
    });
    assert_broken("by name", |function, asked, value| {
        if function == "open" && holds(asked, "no_driver") {
            json!({"code": "no", "message": "no"})
        } else {
            value
        }
    });
    assert_broken(
        "no events before",
        |function, _, value| if function == "poll" { json!({"event": "homed"}) } else { value },
    );
    assert_broken(
        "as 'unknown-call'",
        |_, asked, value| if holds(asked, "whistle") { json!({}) } else { value },
    );
    assert_broken(
        "no JSON",
        |function, asked, value| if function == "call" && asked == b"{}" { json!({}) } else { value },
    );
    assert_broken("refuses a format", |_, asked, value| {
        if holds(asked, "no-such-format") { json!({"files": []}) } else { value }
    });
    assert_broken(
        "writes a job",
        |_, asked, value| if holds(asked, "plain-text") { json!({"files": []}) } else { value },
    );
    let fixed = json!({"files": [{"text": "always"}]});
    assert_broken(
        "mirror image",
        |_, asked, value| if holds(asked, "plain-text") { fixed.clone() } else { value },
    );
    assert_broken(
        "every wire",
        |_, asked, value| if holds(asked, "plain-text") { fixed.clone() } else { value },
    );
    assert_broken("no steps for a machine", |_, asked, value| {
        if holds(asked, "\"machine\":null") { fixed.clone() } else { value }
    });
    assert_broken(
        "before it is connected",
        |_, asked, value| if holds(asked, "\"jog\"") { json!({}) } else { value },
    );
    assert_broken(
        "a port that is not there",
        |_, asked, value| if holds(asked, "wirebend-no") { json!({}) } else { value },
    );
    for wrong in [json!({"ports": [{"name": " "}]}), json!(["memory"])] {
        assert_broken(
            "lists the ports",
            |_, asked, value| {
                if holds(asked, "\"ports\"") { wrong.clone() } else { value }
            },
        );
    }
    assert_broken("refuses to list ports", |function, asked, mut value| match function {
        "describe" => {
            value["capabilities"] = json!(["export", "live", "stop"]);
            value
        }
        _ if holds(asked, "\"ports\"") => json!({"code": "no", "message": "no"}),
        _ => value,
    });
}
