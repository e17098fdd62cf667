//! Rules about moving a machine, as far as they can be tried without one.

use super::subject::{done, refused};
use super::{Conformance, Subject};
use crate::{Axis, Batch, Call, Capability, Description, Motion, Run};

/// A port that no computer has.
const NO_PORT: &str = "wirebend-no-such-port";

pub(super) fn check(subject: &mut dyn Subject, description: &Description, found: &mut Conformance) {
    let outcome = unconnected(subject);
    found.note("refuses to move before it is connected", outcome);
    let connect = ask(subject, &Call::Connect { port: NO_PORT.to_owned() });
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

fn ask(subject: &mut dyn Subject, call: &Call) -> Result<crate::Reply, super::Broken> {
    subject.call(&serde_json::to_vec(call).unwrap_or_default())
}

fn unconnected(subject: &mut dyn Subject) -> Result<(), String> {
    let run =
        Run { job_hash: "0".repeat(64), name: "sample".to_owned(), wire: 0, steps: 1, ..Run::default() };
    let calls = [
        Call::Home,
        Call::Arm(run),
        Call::Send(Batch { steps: Vec::new(), last: true }),
        Call::Jog(Motion { axis: Axis::Feed, by: 1.0 }),
        Call::Pause,
        Call::Resume,
        Call::Stop,
    ];
    for call in &calls {
        refused(ask(subject, call)).map_err(|what| format!("{what}: {call:?}"))?;
    }
    Ok(())
}
