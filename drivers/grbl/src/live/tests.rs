//! The transcripts, bytes that no transcript has, and a port that fails.

use std::cell::RefCell;
use std::io;
use std::path::Path;
use std::rc::Rc;
use std::time::{Duration, Instant};

use proptest::prelude::*;
use wirebend_driver_api::serial::Line;
use wirebend_driver_api::transcript::{self, Answered, Conversation};
use wirebend_driver_api::{Call, ConsoleLine, DriverError, Event, MachineSession};

use super::Session;
use super::protocol::Protocol;
use crate::settings::Settings;

impl Conversation for Protocol {
    fn receive(&mut self, bytes: &[u8], now: Duration) {
        self.receive(bytes, now);
    }

    fn pass(&mut self, now: Duration) {
        self.tick(now);
    }

    fn unplugged(&mut self, now: Duration) {
        self.unplugged(now);
    }

    fn call(&mut self, call: &Call, now: Duration) -> Result<Answered, DriverError> {
        match call {
            Call::Home { .. } => self.home(now)?,
            Call::Arm(run) => self.arm(run, now)?,
            Call::Send(batch) => return self.send(batch, now).map(Answered::Sent),
            Call::Jog(motion) => self.jog(*motion, now)?,
            Call::Cut => self.cut(now)?,
            Call::Pause => self.pause(now)?,
            Call::Speed { percent } => self.set_speed(*percent, now)?,
            Call::Console { line, may_change } => {
                self.console(&ConsoleLine::new(line)?, *may_change, now)?;
            }
            Call::Resume => self.resume(now)?,
            Call::Stop => self.stop(now)?,
            Call::Encode(_)
            | Call::Ports
            | Call::Limits
            | Call::Connect { .. }
            | Call::Disconnect
            | Call::WriteSettings => {
                return Err(DriverError::unsupported("do that within a conversation"));
            }
        }
        Ok(Answered::Taken)
    }

    fn take_output(&mut self) -> Vec<u8> {
        self.take_output()
    }

    fn next_event(&mut self) -> Option<Event> {
        self.next_event()
    }
}

fn opened(settings: serde_json::Value) -> Result<Protocol, DriverError> {
    let settings: Settings = serde_json::from_value(settings)
        .map_err(|error| DriverError::new("settings", error.to_string(), ""))?;
    settings.check()?;
    Ok(Protocol::new(Rc::new(settings)))
}

#[test]
fn every_transcript_is_what_happens() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/drivers/grbl");
    let ran = transcript::run_folder(&folder, opened);
    assert!(ran.is_ok(), "\n{}", transcript::told(&ran));
}

#[test]
fn a_stop_overtakes_lines_that_the_port_has_not_been_given() {
    let mut protocol = begun(true, true);
    let now = Duration::from_secs(3);
    let call = |text| serde_json::from_str::<Call>(text).unwrap();
    let arm = call(r#"{"call":"arm","job_hash":"5a","name":"x","wire":0,"steps":1}"#);
    Conversation::call(&mut protocol, &arm, now).unwrap();
    Conversation::call(&mut protocol, &call(r#"{"call":"send","steps":[],"last":true}"#), now).unwrap();
    protocol.stop(now).unwrap();
    assert_eq!(protocol.take_output(), [0x18]);
}

/// A port: what it was given, and whether it takes anything.
#[derive(Default)]
struct Cable {
    written: Vec<u8>,
    stuck: bool,
}

struct End(Rc<RefCell<Cable>>);

impl Line for End {
    fn read(&mut self) -> io::Result<Vec<u8>> {
        Ok(Vec::new())
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        let mut cable = self.0.borrow_mut();
        if cable.stuck {
            return Err(io::ErrorKind::TimedOut.into());
        }
        cable.written.extend_from_slice(bytes);
        Ok(())
    }
}

/// A connection to a machine that is homed and idle.
fn session(cable: &Rc<RefCell<Cable>>) -> Session {
    let line: Box<dyn Line> = Box::new(End(Rc::clone(cable)));
    Session { line: Some(line), protocol: begun(true, false), opened: Instant::now() }
}

/// A person who reads that the stop was passed on takes the hand off the power switch.
#[test]
fn a_stop_that_could_not_be_written_is_refused() {
    let cable = Rc::default();
    let mut session = session(&cable);
    cable.borrow_mut().stuck = true;
    let error = session.stop().expect_err("nothing was written");
    assert_eq!(error.code, "stop-not-sent");
    assert!(error.message.contains("timed out") && error.help.contains("power"), "{error}");
    // A caller that only listens hears it, too, and no second stop looks as if it had been passed on.
    let ends = |event: &Event| matches!(event, Event::Fault { error, disconnected: true, .. } if error.code == "unplugged");
    let events: Vec<Event> = std::iter::from_fn(|| session.poll().unwrap()).collect();
    assert_eq!(events.iter().filter(|event| ends(event)).count(), 1, "{events:?}");
    assert_eq!(session.stop().expect_err("the port is closed").code, "disconnected");
    assert!(cable.borrow().written.is_empty());
}

#[test]
fn a_stop_that_was_written_is_passed_on() {
    let cable = Rc::default();
    let mut session = session(&cable);
    session.stop().unwrap();
    assert_eq!(cable.borrow().written, [0x18]);
}

/// What may happen to a conversation.
#[derive(Debug, Clone)]
enum Happening {
    Bytes(Vec<u8>),
    Line(&'static str),
    Ms(u64),
    Call(&'static str),
}

fn happenings() -> impl Strategy<Value = Vec<Happening>> {
    let lines = [
        "ok",
        "error:1",
        "error:9",
        "error:x",
        "ALARM:1",
        "ALARM:3",
        "ALARM:9",
        "Grbl 1.1h ['$' for help]",
        "[MSG:'$H'|'$X' to unlock]",
        "[VER:1.1h.20190825:]",
        "$22=1",
        "$13=1",
        "<Idle|MPos:0.000,0.000,0.000|FS:0,0|WCO:1.000,1.000,1.000>",
        "<Run|WPos:1.000,2.000,3.000>",
        "<Jog|MPos:1.000,2.000,3.000>",
        "<Hold:0|MPos:1.000,2.000,3.000>",
        "<Hold:1|MPos:1.000,2.000,3.000,4.000>",
        "<Door:1|MPos:1.000,2.000,3.000>",
        "<Alarm|MPos:1.000,2.000,3.000>",
        "<Sleep|MPos:1.000,2.000,3.000>",
        "oj",
    ];
    let calls = [
        r#"{"call":"home"}"#,
        r#"{"call":"arm","job_hash":"5a","name":"x","wire":0,"steps":4}"#,
        r#"{"call":"send","steps":[{"n":1,"feed_mm":9,"rotate_deg":9,"bend_deg":9}],"last":false}"#,
        r#"{"call":"send","steps":[{"n":2,"feed_mm":9,"rotate_deg":-9,"bend_deg":-9}],"last":true}"#,
        r#"{"call":"jog","axis":"rotate","by":-5}"#,
        r#"{"call":"pause"}"#,
        r#"{"call":"resume"}"#,
        r#"{"call":"stop"}"#,
    ];
    let happening = prop_oneof![
        2 => prop::collection::vec(any::<u8>(), 0..300).prop_map(Happening::Bytes),
        8 => prop::sample::select(lines.to_vec()).prop_map(Happening::Line),
        4 => (0..3000u64).prop_map(Happening::Ms),
        4 => prop::sample::select(calls.to_vec()).prop_map(Happening::Call),
    ];
    prop::collection::vec(happening, 0..60)
}

/// Begins with a machine that is ready, or with a port that was just opened.
fn begun(connected: bool, counting: bool) -> Protocol {
    let streaming = if counting { "character-counting" } else { "one-line-at-a-time" };
    let mut protocol = opened(serde_json::json!({"homing": "none", "streaming": streaming})).unwrap();
    if connected {
        let idle = "<Idle|MPos:0.000,0.000,0.000>";
        for (at, line) in ["Grbl 1.1h ['$' for help]", "ok", "$32=0", "ok", idle].into_iter().enumerate() {
            let now = Duration::from_millis(at as u64);
            protocol.receive(format!("{line}\r\n").as_bytes(), now);
            protocol.tick(now);
        }
        protocol.home(Duration::from_millis(10)).unwrap();
        protocol.receive(b"ok\r\n", Duration::from_millis(20));
        protocol.tick(Duration::from_secs(2));
        protocol.receive(format!("{idle}\r\n").as_bytes(), Duration::from_secs(2));
        assert!(std::iter::from_fn(|| protocol.next_event()).any(|event| event == Event::Homed));
        protocol.take_output();
    }
    protocol
}

proptest! {
    #[test]
    fn nothing_that_comes_keeps_stop_from_being_sent(
        connected: bool, counting: bool, happenings in happenings()
    ) {
        let mut protocol = begun(connected, counting);
        let mut now = Duration::from_secs(2);
        let mut over = false;
        for happening in happenings {
            match happening {
                Happening::Bytes(bytes) => protocol.receive(&bytes, now),
                Happening::Line(line) => protocol.receive(format!("{line}\r\n").as_bytes(), now),
                Happening::Ms(ms) => now += Duration::from_millis(ms),
                Happening::Call(call) => {
                    drop(Conversation::call(&mut protocol, &serde_json::from_str(call).unwrap(), now));
                }
            }
            protocol.tick(now);
            while let Some(event) = protocol.next_event() {
                prop_assert!(!over, "{event:?} after the end");
                over = matches!(event, Event::Fault { disconnected: true, .. });
            }
        }
        protocol.take_output();
        let asked = protocol.stop(now);
        prop_assert_eq!(asked.is_err(), over, "only a closed port keeps a machine from being stopped");
        if over {
            return Ok(());
        }
        let mut sent = protocol.take_output();
        // A jog is given up first; when that brings nothing it is reset within a second.
        let jog = sent.contains(&0x85);
        prop_assert!(jog || sent.contains(&0x18), "{:?}", sent);
        protocol.tick(now + Duration::from_secs(1));
        sent.append(&mut protocol.take_output());
        prop_assert!(sent.contains(&0x18), "{:?}", sent);
        let lines = sent.split(|byte| *byte == 0x18).skip(1).flatten();
        prop_assert!(!lines.copied().any(|byte| byte == b'G'), "nothing moves after a stop");
    }
}
