//! Drivers behind the table: one that keeps the rules, and ones that break each of them.

#![allow(unsafe_code)] // tables are made by hand here

mod minor;
mod plain;
mod rules;

use std::ffi::{c_char, c_void};

use plain::Plain;
use serde_json::{Value, json};
use wirebend_driver_api::conformance::{self, sample_job};
use wirebend_driver_api::{
    ABI_MAJOR, ABI_MINOR, Axis, Batch, Buffer, Bytes, Call, DriverError, Encode, Job, Motion, NumberedStep,
    Reply, SafeTable, Step, Table, TableError,
};

wirebend_driver_api::export_driver!(Plain);

fn table_of_plain() -> SafeTable {
    // SAFETY: the table is static and complete.
    unsafe { SafeTable::new(wirebend_driver_entry()) }.unwrap()
}

fn ask(table: &mut SafeTable, call: &Call) -> Reply {
    table.call(&serde_json::to_vec(call).unwrap()).unwrap()
}

fn encode(format: &str, job: Job) -> Call {
    Call::Encode(Box::new(Encode { format: format.into(), job }))
}

#[track_caller]
fn refusal(reply: Reply) -> DriverError {
    match reply {
        Reply::Refused(bytes) => serde_json::from_slice(&bytes).unwrap(),
        Reply::Ok(bytes) => panic!("accepted: {}", String::from_utf8_lossy(&bytes)),
    }
}

#[track_caller]
fn value(reply: Reply) -> Value {
    match reply {
        Reply::Ok(bytes) => serde_json::from_slice(&bytes).unwrap(),
        Reply::Refused(bytes) => panic!("refused: {}", String::from_utf8_lossy(&bytes)),
    }
}

#[test]
fn a_driver_that_keeps_the_rules_passes() {
    conformance::assert_kept::<Plain>();
}

#[test]
fn a_session_runs_behind_the_table() {
    let mut table = table_of_plain();
    assert_eq!(table.version().0, ABI_MAJOR);
    assert!(!table.has_extension("nothing/1").unwrap());
    assert_eq!(table.open(b"{\"decimals\": 1}").unwrap(), Reply::Ok(Vec::new()));
    let text = &value(ask(&mut table, &encode("plain-text", sample_job())))["files"][0]["text"];
    assert_eq!(text, "60.0 90.0 90.0\n40.0 -90.0 90.0\n50.0 45.0 -60.0\n70.0 0.0 0.0\n");
    assert_eq!(value(ask(&mut table, &Call::Connect { port: "memory".into(), resume: None })), json!({}));
    assert_eq!(
        refusal(ask(&mut table, &Call::Connect { port: "memory".into(), resume: None })).code,
        "connected"
    );
    let steps = vec![NumberedStep { n: 1, step: Step { feed_mm: 5.0, ..Step::default() } }];
    assert_eq!(
        value(ask(&mut table, &Call::Send(Batch { steps, last: true }))),
        json!({"accepted": 1, "free": 8})
    );
    assert_eq!(value(table.poll().unwrap()), json!({"event": "done", "n": 1}));
    assert_eq!(table.poll().unwrap(), Reply::Ok(Vec::new()), "one event only");
    assert_eq!(refusal(ask(&mut table, &Call::Home { head_at_deg: None })).code, "unsupported");
    assert_eq!(refusal(ask(&mut table, &Call::Jog(Motion::new(Axis::Bend, 1.0)))).code, "unsupported");
    value(ask(&mut table, &Call::Stop));
    assert_eq!(value(table.poll().unwrap())["event"], "stopped");
    value(ask(&mut table, &Call::Disconnect));
    assert_eq!(refusal(ask(&mut table, &Call::Stop)).code, "not-connected");
    table.close().unwrap();
    assert_eq!(table.poll().unwrap_err(), TableError::NotOpen("poll"));
}

/// A panic must not run through C, and what it left half done must not be used.
#[test]
fn a_panic_is_a_refusal_and_ends_the_instance() {
    let mut table = table_of_plain();
    assert_eq!(
        refusal(table.open(b"{\"decimals\": 100}").unwrap()).message,
        "the driver failed: a hundred decimals"
    );
    table.open(b"{}").unwrap();
    let job = Job { name: "panic".into(), ..sample_job() };
    assert_eq!(refusal(ask(&mut table, &encode("plain-text", job))).code, "panic");
    assert_eq!(refusal(ask(&mut table, &encode("plain-text", sample_job()))).code, "panicked");
    table.open(b"{}").unwrap();
    value(ask(&mut table, &encode("plain-text", sample_job())));
}

fn table_with(change: impl Fn(&mut Table)) -> Result<SafeTable, TableError> {
    let mut table = wirebend_driver_api::table::<Plain>();
    change(&mut table);
    // SAFETY: the table is complete but for what the test changes, which is checked or harmless.
    unsafe { SafeTable::new(&raw const table) }
}

#[test]
fn other_versions_are_refused_by_their_numbers() {
    // SAFETY: a null table is looked at no further.
    assert_eq!(unsafe { SafeTable::new(std::ptr::null()) }.unwrap_err(), TableError::NoTable);
    let newer = table_with(|table| table.abi_major = ABI_MAJOR + 1).unwrap_err();
    assert_eq!(newer, TableError::Version { major: ABI_MAJOR + 1, minor: ABI_MINOR });
    assert!(newer.to_string().contains(&format!("version {}.{ABI_MINOR}", ABI_MAJOR + 1)), "{newer}");
    let older = table_with(|table| table.abi_major = 0).unwrap_err();
    assert!(older.to_string().contains(&format!("version 0.{ABI_MINOR}")), "{older}");
    table_with(|table| table.abi_minor = 99).unwrap();
}

#[test]
fn a_hole_in_the_table_is_named() {
    assert_eq!(table_with(|table| table.poll = None).unwrap_err(), TableError::Missing("poll"));
    assert_eq!(table_with(|table| table.extension = None).unwrap_err(), TableError::Missing("extension"));
}

unsafe extern "C" fn odd_status(_out: *mut Buffer) -> i32 {
    7
}

unsafe extern "C" fn null_bytes(out: *mut Buffer) -> i32 {
    // SAFETY: the caller gives a place.
    unsafe { *out = Buffer { data: std::ptr::null_mut(), len: 3 } };
    0
}

unsafe extern "C" fn boundless(out: *mut Buffer) -> i32 {
    // SAFETY: the caller gives a place. The bytes are never read, for there are too many.
    unsafe { *out = Buffer { data: std::ptr::dangling_mut(), len: usize::MAX / 2 } };
    0
}

unsafe extern "C" fn keep(_buffer: Buffer) {}

unsafe extern "C" fn no_instance(_s: Bytes, _instance: *mut *mut c_void, _out: *mut Buffer) -> i32 {
    0
}

#[test]
fn answers_against_the_rules_are_told_apart() {
    let describe = |function: unsafe extern "C" fn(*mut Buffer) -> i32| {
        table_with(|table| {
            table.describe = Some(function);
            table.free = Some(keep);
        })
        .unwrap()
        .describe()
        .unwrap_err()
    };
    assert_eq!(describe(odd_status), TableError::Status { function: "describe", status: 7 });
    assert_eq!(describe(null_bytes), TableError::NullBytes("describe"));
    assert_eq!(describe(boundless), TableError::TooLarge { function: "describe", len: usize::MAX / 2 });
    assert_eq!(
        table_with(|table| table.open = Some(no_instance)).unwrap().open(b"{}").unwrap_err(),
        TableError::NoInstance
    );
}

unsafe extern "C" fn one_more(name: *const c_char) -> *const c_void {
    // SAFETY: the caller gives a text with its end.
    let name = unsafe { std::ffi::CStr::from_ptr(name) };
    if name.to_bytes() == b"one-more/1" { name.as_ptr().cast() } else { std::ptr::null() }
}

#[test]
fn extensions_are_found_by_name_and_revision() {
    let table = table_with(|table| table.extension = Some(one_more)).unwrap();
    assert!(table.has_extension("one-more/1").unwrap() && !table.has_extension("one-more/2").unwrap());
}

#[test]
fn every_message_has_a_schema() {
    let schemas = wirebend_driver_api::message_schemas();
    assert_eq!(schemas.len(), 9);
    assert!(schemas.iter().all(|(_, schema)| schema.get("$schema").is_some()));
}
