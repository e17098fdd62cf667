//! What it does when it behaves: a machine in memory that does every step at once.

use std::collections::VecDeque;

use serde_json::{Value, json};
use wirebend_driver_api::SafeTable;

use crate::conduct::is_told;
use crate::machine::Machine;
use crate::real;

const DESCRIPTION: &str = r#"{"id": "hostile", "name": "Hostile", "version": "0.1.0",
"description": "Misbehaves on demand, for tests.",
"capabilities": ["export", "live", "jog", "home", "pause", "resume", "stop", "ports", "settings", "console", "cut"],
"formats": [{"id": "hostile-text", "name": "Text", "extensions": ["txt"], "content": "design"}],
"settings_schema": {"type": "object", "additionalProperties": false, "properties": {
    "machine": {"type": "string", "description": "File that the machine is kept in."},
    "faults": {"type": "array", "items": {"type": "object"}, "description": "What goes wrong, and at which step."},
    "alone": {"type": "integer", "description": "Steps that it does while no program is there."},
    "holds_by_hand": {"type": "integer", "description": "The move by hand in which it holds."},
    "cutter_mm": {"type": "number", "description": "Where its cutter is, if it has one."},
    "jams_at": {"type": "integer", "description": "The cut at which the cutter jams."},
    "misset": {"type": "boolean", "description": "A setting is another one until it is written."}}}}"#;

/// What the machine's settings are at a moment; one that differs at first keeps to it when they are written.
fn settings(when: &str) -> Value {
    let differs = json!([{"name": "$100", "machine": "80", "expected": "40", "matters": true}]);
    if is_told("connect", "differ") || is_told(when, "differ") { differs } else { json!([]) }
}

/// What it calls the session of a wire.
const TOKEN: &str = "hostile-1";

fn connected(request: &Value) -> Value {
    // It was not asked to resume, and it has done more than it has taken.
    let lie = is_told("connect", "lie").then(|| json!({"accepted": 3, "done": 9}));
    let resume = lie.or_else(|| (request["resume"] == TOKEN).then(|| json!({"accepted": 3, "done": 1})));
    json!({"event": "connected", "identity": "nobody", "settings": settings("connect"), "going_on": resume})
}

fn written() -> Value {
    json!({"event": "settings-written", "settings": settings("write-settings")})
}

/// What it says of itself.
pub(crate) fn describe() -> Result<String, String> {
    real::table().map_or_else(|| Ok(DESCRIPTION.to_owned()), |mut table| real::text(table.describe()))
}

/// An instance with its machine.
pub(crate) struct Instance {
    /// The driver in whose place it stands.
    real: Option<SafeTable>,
    events: VecDeque<Value>,
    /// The one that it moves instead of the one in memory.
    machine: Option<Machine>,
    /// It has reported a fault.
    faulted: bool,
}

/// Faults that it can report while its machine moves on: one after which it stops the machine when it is ordered to, one after
/// which it never says that the machine stands, and one that has taken its port away.
const FAULTS: [&str; 3] = ["fault", "numb", "gone"];

impl Instance {
    pub fn open(settings: &[u8]) -> Result<Self, String> {
        let mut real = real::table();
        let machine = match &mut real {
            Some(table) => {
                real::text(table.open(settings))?;
                None
            }
            None => Machine::open(settings),
        };
        Ok(Self { real, events: VecDeque::new(), machine, faulted: false })
    }

    /// The name of the call and what is answered.
    pub fn call(&mut self, request: &[u8]) -> (String, Result<String, String>) {
        let body = request;
        let request: Value = serde_json::from_slice(request).unwrap_or_default();
        let name = request["call"].as_str().unwrap_or_default().to_owned();
        if let Some(table) = &mut self.real {
            return (name, real::text(table.call(body)));
        }
        if let Some(machine) = &mut self.machine {
            let answer = machine.call(body);
            let refusal = |error| serde_json::to_string(&error).unwrap_or_default();
            return (name, answer.map(|reply| reply.to_string()).map_err(refusal));
        }
        let mut reply = json!({});
        match name.as_str() {
            "encode" => reply = json!({"files": [{"text": "a wire\n"}]}),
            "ports" => reply = json!({"ports": [{"name": "anywhere", "likely": true}]}),
            "limits" => {
                reply = json!({"limits": [{"axis": "feed", "of": "step", "most": 1e6, "reason": "patience"}], "cutter_mm": 12.0});
            }
            "connect" => self.events.push_back(connected(&request)),
            "home" => self.events.push_back(json!({"event": "homed"})),
            "send" => reply = self.send(&request),
            "jog" => self.events.push_back(json!({"event": "jogged"})),
            "pause" => self.events.push_back(json!({"event": "paused"})),
            "resume" => self.events.push_back(json!({"event": "resumed"})),
            // One that is mute never says that the machine stands.
            "stop" if is_told("stop", "mute") || is_told("poll", "numb") => {}
            "stop" if is_told("poll", "gone") => {
                let error = json!({"code": "disconnected", "message": "the port is gone"});
                return (name, Err(error.to_string()));
            }
            "stop" => self.events.push_back(json!({"event": "stopped", "homed": false})),
            "write-settings" => self.events.push_back(written()),
            "console" => return (name, self.console(&request)),
            "cut" => self.events.push_back(json!({"event": "cut"})),
            "arm" => reply = json!({"token": TOKEN}),
            "disconnect" => {}
            _ => {
                let error = json!({"code": "unknown-call", "message": format!("'{name}' is not known")});
                return (name, Err(error.to_string()));
            }
        }
        (name, Ok(reply.to_string()))
    }

    /// The next event, or nothing.
    pub fn poll(&mut self) -> Result<String, String> {
        if let Some(machine) = &mut self.machine {
            let event = machine.poll().and_then(|event| serde_json::to_string(&event).ok());
            return Ok(event.unwrap_or_default());
        }
        if is_told("poll", "lie") {
            // A step of a wire that it was never sent.
            return Ok(json!({"event": "done", "n": 86_419}).to_string());
        }
        if let Some(table) = &mut self.real {
            return real::text(table.poll());
        }
        if let Some(how) = FAULTS.iter().find(|how| !self.faulted && is_told("poll", how)) {
            self.faulted = true;
            let disconnected = *how == "gone";
            let fault = json!({"event": "fault", "code": "refused", "message": "as it was told to", "disconnected": disconnected});
            return Ok(fault.to_string());
        }
        Ok(self.events.pop_front().map(|event| event.to_string()).unwrap_or_default())
    }

    /// Every line that begins with `?` is a question. One that lies says of a command that it was one, too.
    fn console(&mut self, request: &Value) -> Result<String, String> {
        let line = request["line"].as_str().unwrap_or_default();
        let question = line.starts_with('?');
        if !question && request["may_change"] != true {
            return Err(json!({"code": "not-a-question", "message": "it may move"}).to_string());
        }
        let changes = !question && !is_told("console", "lie");
        self.events.push_back(json!({"event": "console", "direction": "->", "text": line}));
        self.events.push_back(json!({"event": "console", "direction": "<-", "text": "ok"}));
        self.events.push_back(json!({"event": "console-done", "homed": !changes, "moved": changes}));
        Ok("{}".to_owned())
    }

    fn send(&mut self, request: &Value) -> Value {
        let steps = request["steps"].as_array().map(Vec::as_slice).unwrap_or_default();
        // Steps that were never sent, and a wire that is finished before its steps are.
        let lie = if is_told("send", "lie") { 5 } else { 0 };
        let numbers = steps.iter().filter_map(|step| Some(step["n"].as_u64()? + lie));
        self.events.extend(numbers.map(|n| json!({"event": "done", "n": n})));
        if request["last"] == true {
            self.events.push_back(json!({"event": "finished"}));
        }
        json!({"accepted": steps.last().map_or(&json!(0), |step| &step["n"]), "free": 4})
    }
}
