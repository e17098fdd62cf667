//! Rules about moving a machine, as far as they can be tried without one.

use super::subject::{done, refused};
use super::{Conformance, Subject};
use crate::{Axis, Batch, Call, Capability, Description, Motion, Ports, Run};

/// A port that no computer has.
const NO_PORT: &str = "wirebend-no-such-port";

pub(super) fn check(subject: &mut dyn Subject, description: &Description, found: &mut Conformance) {
    let outcome = unconnected(subject);
    found.note("refuses to move before it is connected", outcome);
    listing(subject, description, found);
    let connect = ask(subject, &Call::Connect { port: NO_PORT.to_owned(), resume: None });
    if description.can(Capability::Live) {
        let outcome = refused(connect).and_then(|error| {
            if error.message.contains(NO_PORT) {
                Ok(())
            } else {
                Err(format!("the message does not name it: {error}"))
            }
        });
        found.note("refuses a port that is not there, by name", outcome);
    } else {
        let outcome = refused(connect).and_then(|error| {
            if error.code == "unsupported" { Ok(()) } else { Err(format!("the code is '{}'", error.code)) }
        });
        found.note("refuses to connect, as 'unsupported'", outcome);
    }
    found.note("is usable after a connection that failed", done(ask(subject, &Call::Disconnect)).map(drop));
}

/// What is claimed is listed by name; what is not is refused, by a driver of 1.0 as a call that it does not know.
fn listing(subject: &mut dyn Subject, description: &Description, found: &mut Conformance) {
    let listed = ask(subject, &Call::Ports);
    if description.can(Capability::Ports) {
        let outcome = done(listed).and_then(|bytes| {
            let Ports { ports } = serde_json::from_slice(&bytes)
                .map_err(|error| format!("the list of ports cannot be read: {error}"))?;
            let nameless = ports.iter().any(|port| port.name.trim().is_empty());
            if nameless { Err("a port has no name".to_owned()) } else { Ok(()) }
        });
        found.note("lists the ports that there are", outcome);
    } else {
        let outcome = refused(listed).and_then(|error| match error.code.as_str() {
            "unsupported" | "unknown-call" => Ok(()),
            code => Err(format!("the code is '{code}'")),
        });
        found.note("refuses to list ports, as 'unsupported'", outcome);
    }
}

fn ask(subject: &mut dyn Subject, call: &Call) -> Result<crate::Reply, super::Broken> {
    subject.call(&serde_json::to_vec(call).unwrap_or_default())
}

fn unconnected(subject: &mut dyn Subject) -> Result<(), String> {
    let run =
        Run { job_hash: "0".repeat(64), name: "sample".to_owned(), wire: 0, steps: 1, ..Run::default() };
    let calls = [
        Call::Home { head_at_deg: None },
        Call::Arm(run),
        Call::Send(Batch { steps: Vec::new(), last: true }),
        Call::Jog(Motion::new(Axis::Feed, 1.0)),
        Call::Pause,
        Call::Speed { percent: 50 },
        Call::Console { line: "?".to_owned(), may_change: false },
        Call::Cut,
        Call::Resume,
        Call::Stop,
        Call::WriteSettings,
    ];
    for call in &calls {
        refused(ask(subject, call)).map_err(|what| format!("{what}: {call:?}"))?;
    }
    Ok(())
}
