//! The runner on a machine that everybody understands: it says `ready`, echoes steps, and asks with `?`.

use std::collections::VecDeque;
use std::time::Duration;

use serde_json::{Value, json};

use super::{Answered, Conversation, TranscriptError, run_folder, run_text, told};
use crate::{ArmedReply, Call, DriverError, Event, PausedBy, Sent, Step};

#[derive(Default)]
struct Echo {
    output: Vec<u8>,
    events: VecDeque<Event>,
    asked: Duration,
}

impl Conversation for Echo {
    fn receive(&mut self, bytes: &[u8], _now: Duration) {
        match bytes {
            b"ready\r\n" => self.events.push_back(Event::Homed),
            b"busy\r\n" => self.events.push_back(Event::Paused { by: PausedBy::Program }),
            b"\x07" => self.events.push_back(Event::Jogged),
            _ => self.events.push_back(Event::Position(Step { feed_mm: 1.0, ..Step::default() })),
        }
    }

    fn pass(&mut self, now: Duration) {
        if now >= self.asked + Duration::from_millis(100) {
            self.asked = now;
            self.output.push(b'?');
        }
    }

    fn unplugged(&mut self, _now: Duration) {
        self.events.push_back(Event::Stopped { homed: false });
    }

    fn call(&mut self, call: &Call, _now: Duration) -> Result<Answered, DriverError> {
        match call {
            Call::Home { .. } => self.output.extend_from_slice(b"home\n"),
            Call::Send(batch) => {
                let free = batch.steps.first().map_or(0, |step| step.n);
                return Ok(Answered::Sent(Sent { accepted: 0, free }));
            }
            Call::Arm(run) => {
                return Ok(Answered::Armed(ArmedReply { token: Some(format!("t-{}", run.wire)) }));
            }
            _ => return Err(DriverError::unsupported("do that")),
        }
        Ok(Answered::Taken)
    }

    fn take_output(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.output)
    }

    fn next_event(&mut self) -> Option<Event> {
        self.events.pop_front()
    }
}

fn run(text: &str) -> Result<(), TranscriptError> {
    run_text("t", text, |settings| {
        if settings == json!({}) {
            Ok(Echo::default())
        } else {
            Err(DriverError::new("settings", "no settings here", ""))
        }
    })
}

/// The text of the error that a transcript gives.
#[track_caller]
fn error(text: &str) -> String {
    run(text).expect_err("it has to fail").to_string()
}

#[test]
fn a_transcript_that_is_what_happens_passes() {
    let text = r#"
        # every kind of line
        settings {}
        ignore position
        do {"call":"home"}
        -> home
        <- ready
        event {"event":"homed"}
        @ 0.1 s
        ->! \x3f
        on ? busy
        @ 101 ms
        event {"event":"paused"}
        on ?
        @ 99 ms
        ->! ?
        <- where
        do {"call":"jog","axis":"feed","by":1}
        refused unsupported
        do {"call":"send","steps":[],"last":true}
        reply {"free":0}
        do {"call":"arm","job_hash":"0","name":"echo","wire":2,"steps":1}
        reply {"token":"t-2"}
        <-! \x07
        event {"event":"jogged"}
        <- where
        event {"event":"position","feed_mm":1}
        unplug
        event {"event":"stopped"}
    "#;
    run(text).unwrap();
}

#[test]
fn what_the_driver_sends_has_to_be_there() {
    let home = r#"do {"call":"home"}"#;
    assert_eq!(
        error(&format!("{home}\n-> hone\n")),
        r#"t:2: the driver should send "hone\n", and sent "home\n""#
    );
    assert_eq!(error("->! \\x18\n"), r#"t:1: the driver should send "\x18", and sent nothing"#);
    assert_eq!(
        error(&format!("{home}\n<- ready\nevent {{}}")),
        r#"t:2: before this line the driver sent "home\n", which the transcript does not have"#
    );
    // At the end of the file, too.
    assert!(matches!(error("@ 100 ms\n->! ?\n@ 100 ms\n").as_str(), text if text.starts_with("t:4: before")));
}

#[test]
fn what_the_driver_reports_has_to_be_there() {
    let expected = r#"t:2: the driver should report {"event":"done","n":1}, and reported {"event":"homed"}"#;
    assert_eq!(error("<- ready\nevent {\"event\":\"done\",\"n\":1}"), expected);
    assert_eq!(
        error("event {\"event\":\"homed\"}"),
        r#"t:1: the driver should report {"event":"homed"}, and reported nothing"#
    );
    assert_eq!(
        error("<- ready\n@ 100 ms\n->! ?"),
        r#"t:2: before this line the driver reported {"event":"homed"}, which the transcript does not have"#
    );
    // Ignored events may come; others of another kind may not.
    assert!(run("ignore homed\n<- ready\n@ 100 ms\n->! ?").is_ok());
    assert!(run("ignore paused\n<- ready\n@ 100 ms\n->! ?").is_err());
}

#[test]
fn an_event_is_what_was_expected_only_with_its_values() {
    let with = |keys: &str| run(&format!("<- where\nevent {{\"event\":\"position\",{keys}}}"));
    assert!(with("\"feed_mm\":1,\"bend_deg\":0.0").is_ok());
    assert!(with("\"feed_mm\":2").is_err());
    assert!(with("\"no_such_key\":1").is_err());
}

#[test]
fn the_answer_to_a_call_has_to_fit() {
    let (home, jog) = (r#"do {"call":"home"}"#, r#"do {"call":"jog","axis":"feed","by":1}"#);
    let send = r#"do {"call":"send","steps":[],"last":true}"#;
    let said = error(&format!("{home}\nrefused unsupported\n-> home"));
    assert_eq!(said, "t:2: the call should be answered with the refusal 'unsupported', and was with {}");
    assert!(
        error(&format!("{jog}\nevent {{}}")).starts_with("t:1: the call should be answered with no refusal")
    );
    assert!(error(&format!("{jog}\nrefused busy")).contains("the refusal 'unsupported': this driver cannot"));
    assert!(
        error(&format!("{send}\nreply {{\"free\":1}}\nevent {{}}")).contains("{\"accepted\":0,\"free\":0}")
    );
}

#[test]
fn a_line_that_is_not_in_the_notation_is_refused_with_what_was_expected() {
    for (line, part) in [
        ("=> home", "'=>' is not in the notation; expected '->'"),
        ("@ 5", "'5' is no time; expected a number and its unit, such as '250 ms'"),
        ("@ five ms", "is no time"),
        ("@ -1 s", "is no time"),
        ("@ 1 h", "is no time"),
        ("->!", "bytes are missing"),
        ("->! \\x1", "needs two hexadecimal digits"),
        ("->! \\q", "'\\' needs n, r, t, s"),
        ("do {\"call\":\"whistle\"}", "'do' needs JSON on the same line: unknown variant"),
        ("event {", "'event' needs JSON on the same line"),
        ("refused", "needs the code"),
        ("refused busy", "belongs right below the 'do'"),
    ] {
        let text = error(&format!("-> home\n{line}"));
        assert!(text.starts_with("t:2: ") && text.contains(part), "{text}");
    }
    assert!(error("-> home\nignore console").contains("comes too late"));
}

#[test]
fn a_transcript_that_expects_nothing_and_settings_that_are_refused_are_errors() {
    assert_eq!(
        error("# nothing\n<- ready"),
        "t: expects nothing of the driver; say what it sends and reports"
    );
    assert_eq!(error("settings {\"baud\":1}\n-> home"), "t: its settings are refused: no settings here");
}

#[test]
fn bytes_are_written_as_they_are_sent() {
    // The machine's bytes reach the driver as written; only the bell is known to `Echo`.
    assert!(run("<-! \\x07\nevent {\"event\":\"jogged\"}").is_ok());
    assert!(run("<-! ready\\r\\n\nevent {\"event\":\"homed\"}").is_ok());
    assert_eq!(
        error("->! a\\\\\\s\\t\\xfF"),
        r#"t:1: the driver should send "a\\ \t\xff", and sent nothing"#
    );
}

#[test]
fn a_folder_is_run_file_by_file_and_may_not_be_empty() {
    let folder = tempfile::tempdir().unwrap();
    let run = || run_folder(folder.path(), |_: Value| Ok(Echo::default()));
    assert!(told(&run()).ends_with("no file ends on .transcript; write at least one"));
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("b.transcript", "<- ready\nevent {\"event\":\"homed\"}");
    write("notes.txt", "not run");
    assert_eq!(run().unwrap(), ["b.transcript"]);
    write("a.transcript", "-> home");
    assert_eq!(told(&run()), "a.transcript:1: the driver should send \"home\\n\", and sent nothing");
    std::fs::write(folder.path().join("c.transcript"), b"\xff\xfe").unwrap();
    assert!(told(&run()).contains("c.transcript: cannot be read: "));
}
