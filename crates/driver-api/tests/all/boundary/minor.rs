//! A driver of 1.0 and a program of a later minor understand each other, and the other way round.

use serde::de::DeserializeOwned;
use serde_json::{Value, json};
use wirebend_driver_api::{
    ArmedReply, Axis, AxisLimit, Call, DoneBy, Event, Extent, HeadBy, Limits, Port, Ports, ReferenceBy,
    ResumeState, Run,
};

fn read<T: DeserializeOwned>(json: Value) -> T {
    serde_json::from_value(json).unwrap()
}

/// What a program or a driver of 1.0 writes has none of the keys of 1.1.
#[test]
fn messages_of_1_0_are_read() {
    let connect: Call = read(json!({"call": "connect", "port": "COM3"}));
    assert_eq!(connect, Call::Connect { port: "COM3".into(), resume: None });
    assert_eq!(read::<ArmedReply>(json!({})), ArmedReply { token: None });
    let connected: Event = read(json!({"event": "connected", "identity": "it", "homed": true}));
    assert!(matches!(connected, Event::Connected { resume: None, homed: true, .. }), "{connected:?}");
    let run: Run = read(json!({"job_hash": "5a", "name": "sample", "wire": 0, "steps": 3}));
    assert_eq!((run.after, run.rotate_at_deg, run.bench), (0, 0.0, None));
}

/// A driver of 1.0 passes over keys that it does not know; what it knows has to be where it was.
#[test]
fn what_1_0_knows_is_where_it_was() {
    let connect = Call::Connect { port: "COM3".into(), resume: Some("7".into()) };
    assert_eq!(serde_json::to_value(connect).unwrap()["port"], "COM3");
    let arm = Call::Arm(Run { steps: 3, after: 2, ..Run::default() });
    let arm = serde_json::to_value(arm).unwrap();
    assert_eq!((&arm["call"], &arm["steps"], &arm["wire"]), (&json!("arm"), &json!(3), &json!(0)));
}

#[test]
fn the_calls_of_1_1_run_behind_the_table() {
    let mut table = super::table_of_plain();
    table.open(b"{}").unwrap();
    let ports: Ports = read(super::value(super::ask(&mut table, &Call::Ports)));
    assert_eq!(ports.ports, [Port { name: "memory".into(), likely: true, ..Port::default() }]);
    assert_eq!(super::refusal(super::ask(&mut table, &Call::WriteSettings)).code, "not-connected");
    super::value(super::ask(&mut table, &Call::Connect { port: "memory".into(), resume: Some("t7".into()) }));
    assert_eq!(super::refusal(super::ask(&mut table, &Call::WriteSettings)).code, "unsupported");
    let armed = super::value(super::ask(&mut table, &Call::Arm(Run::default())));
    assert_eq!(read::<ArmedReply>(armed).token.as_deref(), Some("t7"));
}

/// As a driver in C writes them, word for word.
#[test]
fn the_events_of_1_1_are_written_so() {
    let connected: Event =
        read(json!({"event": "connected", "identity": "it", "going_on": {"accepted": 5, "done": 3}}));
    let Event::Connected { resume, .. } = connected else { panic!("{connected:?}") };
    assert_eq!(resume, Some(ResumeState { accepted: 5, done: 3 }));
    let made: Event =
        read(json!({"event": "made", "wire_mm": [[0, 0, 0], [1, 0, 0]], "corners_mm": [[0, 0, 0]]}));
    let Event::Made { wire_mm, corners_mm } = made else { panic!("{made:?}") };
    assert_eq!((wire_mm, corners_mm), (vec![[0.0; 3], [1.0, 0.0, 0.0]], vec![[0.0; 3]]));
    let written: Event = read(json!({"event": "settings-written"}));
    assert_eq!(written, Event::SettingsWritten { settings: Vec::new(), limits: Limits::default() });
    assert_eq!(read::<Call>(json!({"call": "write-settings"})), Call::WriteSettings);
}

/// A driver of before says nothing of who finds the reference: there the machine does. As one in C writes it otherwise,
/// word for word.
#[test]
fn who_brings_the_axes_to_their_reference_is_told_since_1_2() {
    let reference = |json| match read(json) {
        Event::Connected { reference, .. } => reference,
        other => panic!("{other:?}"),
    };
    let before =
        json!({"event": "connected", "identity": "it", "settings": [], "homed": false, "going_on": null});
    assert_eq!(reference(before), ReferenceBy::Machine);
    let told = |by: &str| json!({"event": "connected", "identity": "it", "reference": by});
    assert_eq!(reference(told("person")), ReferenceBy::Person);
    assert_eq!(reference(told("machine")), ReferenceBy::Machine);
    // A program of before passes over a key that it does not know: what it knows is where it was.
    let connected = Event::Connected {
        identity: "it".into(),
        settings: Vec::new(),
        homed: false,
        resume: None,
        reference: ReferenceBy::Person,
        done_by: DoneBy::Clock,
        head: HeadBy::Reference,
        limits: Limits::default(),
    };
    let written = serde_json::to_value(connected).unwrap();
    assert_eq!((&written["event"], &written["reference"]), (&json!("connected"), &json!("person")));
    assert_eq!(written["done_by"], json!("clock"));
    // One of before has a machine that reports what it has done.
    let told = read::<Event>(json!({"event": "connected", "identity": "it"}));
    assert!(matches!(told, Event::Connected { done_by: DoneBy::Machine, .. }), "{told:?}");
}

/// A driver of 1.2 or older finds the head with its reference, and homes as before when it is given where the head stands.
#[test]
fn who_knows_where_the_head_stands_is_told_since_1_3() {
    let head = |json| match read(json) {
        Event::Connected { head, .. } => head,
        other => panic!("{other:?}"),
    };
    assert_eq!(head(json!({"event": "connected", "identity": "it"})), HeadBy::Reference);
    assert_eq!(head(json!({"event": "connected", "identity": "it", "head": "program"})), HeadBy::Program);
    assert_eq!(read::<Call>(json!({"call": "home"})), Call::Home { head_at_deg: None });
    let said = serde_json::to_value(Call::Home { head_at_deg: Some(90.0) }).unwrap();
    assert_eq!((&said["call"], &said["head_at_deg"]), (&json!("home"), &json!(90.0)));
    // One whose driver knows nothing of it homes anyway.
    let mut table = super::table_of_plain();
    table.open(b"{}").unwrap();
    super::value(super::ask(&mut table, &Call::Connect { port: "memory".into(), resume: None }));
    let asked = super::ask(&mut table, &Call::Home { head_at_deg: Some(90.0) });
    assert_eq!(super::refusal(asked).code, "unsupported");
}

/// As a driver in C writes it; one that reports nothing has no limits.
#[test]
fn the_call_of_1_2_runs_behind_the_table() {
    let mut table = super::table_of_plain();
    table.open(b"{}").unwrap();
    assert_eq!(read::<Limits>(super::value(super::ask(&mut table, &Call::Limits))), Limits::default());
    let told: Limits =
        read(json!({"limits": [{"axis": "feed", "of": "step", "most": 7000, "setting": "longest"}]}));
    assert_eq!(told.limits, [AxisLimit::of_setting(Axis::Feed, Extent::Step, 7000.0, "longest")]);
    assert_eq!(read::<Call>(json!({"call": "limits"})), Call::Limits);
}
