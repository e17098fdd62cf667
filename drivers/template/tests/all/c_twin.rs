//! The driver in C beside the one in Rust: built strictly, run under sanitizers, and saying the same.
//! The compiled library is loaded by the tests of the command line.

#![cfg(unix)] // the Makefile is for systems with make and cc; README.md says how to build on Windows

use proptest::prelude::*;
use serde_json::{Value, json};
use template_driver::{Settings, Template};
use wirebend_driver_api::conformance::{self, mirrored_job, sample_job};
use wirebend_driver_api::{Call, DriverError, Encode, Encoded, Job, MachineDriver, Step};

use crate::checked::{Checked, make};

fn request(job: &Job) -> Vec<u8> {
    let call = Encode { format: "template-c-text".to_owned(), job: job.clone() };
    serde_json::to_vec(&Call::Encode(Box::new(call))).unwrap()
}

/// The sample with these steps for the machine.
fn job_of(steps: &[(f64, f64, f64)]) -> Job {
    let step =
        |&(feed_mm, rotate_deg, bend_deg): &_| Step { feed_mm, rotate_deg, bend_deg, approach_deg: None };
    let mut job = sample_job();
    job.wires[0].machine = Some(steps.iter().map(step).collect());
    job
}

/// What each of the two writes, or the code of its refusal.
fn both(c: &mut Checked, settings: &Value, job: &Job) -> [Result<Vec<String>, DriverError>; 2] {
    let texts = |encoded: Encoded| encoded.files.into_iter().map(|file| file.text).collect();
    let taken: Result<Settings, _> = serde_json::from_value(settings.clone());
    let rust = taken
        .map_err(|error| DriverError::new("settings", error.to_string(), ""))
        .and_then(Template::open)
        .and_then(|driver| driver.encode("template-text", job))
        .map(texts);
    let (opened, refusal) = c.ask_with("open", settings.to_string().as_bytes());
    if !opened {
        return [rust, Err(serde_json::from_slice(&refusal).unwrap())];
    }
    let (done, reply) = c.ask_with("call", &request(job));
    let in_c = if done {
        Ok(texts(serde_json::from_slice(&reply).unwrap()))
    } else {
        Err(serde_json::from_slice(&reply).unwrap())
    };
    [rust, in_c]
}

#[track_caller]
fn assert_same(c: &mut Checked, settings: &Value, job: &Job) {
    let [rust, in_c] = both(c, settings, job);
    match (rust, in_c) {
        (Ok(rust), Ok(in_c)) => assert_eq!(rust, in_c, "{settings}"),
        (Err(rust), Err(in_c)) => assert_eq!(rust.code, in_c.code, "{settings}: {rust} / {in_c}"),
        (rust, in_c) => panic!("{settings}: {rust:?} / {in_c:?}"),
    }
}

#[test]
fn the_library_builds_without_a_warning() {
    let library =
        if cfg!(target_os = "macos") { "libtemplate_c_driver.dylib" } else { "libtemplate_c_driver.so" };
    assert!(make("all").join(library).is_file());
}

#[test]
fn keeps_the_rules() {
    let found = conformance::check(&mut Checked::start());
    assert!(found.kept(), "\n{found}");
}

#[test]
fn describes_the_same_formats_and_settings() {
    let mut c: Value = serde_json::from_slice(&Checked::start().ask("describe").1).unwrap();
    let mut rust = serde_json::to_value(Template::describe()).unwrap();
    let schema = schemars::schema_for!(Settings).to_value();
    let (keys, c_keys) = (&schema["properties"], c["settings_schema"]["properties"].take());
    assert_eq!(c_keys.as_object().unwrap().len(), keys.as_object().unwrap().len());
    for (name, key) in c_keys.as_object().unwrap() {
        for (what, said) in key.as_object().unwrap() {
            assert_eq!(&keys[name][what], said, "{name}: {what}");
        }
    }
    assert_eq!((&c["id"], &c["formats"][0]["id"]), (&json!("template-c"), &json!("template-c-text")));
    for value in [&mut c, &mut rust] {
        value["formats"][0]["id"].take();
    }
    assert_eq!((&c["capabilities"], &c["formats"]), (&rust["capabilities"], &rust["formats"]));
}

#[test]
fn writes_and_refuses_the_same() {
    let mut c = Checked::start();
    let mut two = sample_job();
    two.wires.push(mirrored_job().wires.remove(0));
    let mut bare = two.clone();
    bare.wires[1].machine = None;
    let odd = Job { name: "Stuhl \"größer\"\u{7f}\n\u{85}\u{a0}\\ \u{1f600}".to_owned(), ..sample_job() };
    // Halves of the last digit, what rounds to zero from both sides, and the limits.
    let halves = job_of(&[(0.5, -0.5, 0.125), (1.5, -1.5, 0.375), (0.4, -0.4, -0.0004), (1e5, -1e5, 0.0)]);
    let jobs = [sample_job(), two, bare, odd, halves, job_of(&[]), job_of(&[(1e5 + 0.5, 0.0, 0.0)])];
    let settings = [
        json!({}),
        json!({"decimals": 0, "header": false, "comment": ""}),
        json!({"decimals": 6, "comment": "// \u{e9}"}),
        json!({"decimals": 7}),
        json!({"decimals": -1}),
        json!({"decimals": 2.5}),
        json!({"decimals": "3"}),
        json!({"header": 1}),
        json!({"comment": "#\n"}),
        json!({"comment": "\u{9f}"}),
        json!({"comment": null}),
        json!({"Decimals": 3}),
    ];
    for settings in &settings {
        for job in &jobs {
            assert_same(&mut c, settings, job);
        }
    }
    let [rust, in_c] = both(&mut c, &json!({}), &job_of(&[(1.0, 0.0, 0.0), (0.0, -200_000.0, 0.0)]));
    assert_eq!(rust.unwrap_err().message, in_c.unwrap_err().message, "wire and step are named");
}

proptest! {
    #[test]
    fn writes_any_numbers_the_same(
        steps in prop::collection::vec((-2e5..2e5_f64, -360.0..360.0_f64, -1e-3..1e-3_f64), 0..20),
        decimals in 0..=6,
    ) {
        let settings = json!({"decimals": decimals});
        assert_same(&mut Checked::start(), &settings, &job_of(&steps));
    }
}

/// Whatever is cut off, nothing is read beyond the end and nothing is guessed.
#[test]
fn a_truncated_call_is_refused_at_every_byte() {
    let mut c = Checked::start();
    c.ask_with("open", b"{}");
    let whole = request(&sample_job());
    for len in 0..whole.len() {
        let (done, reply) = c.ask_with("call", &whole[..len]);
        let error: DriverError = serde_json::from_slice(&reply).unwrap();
        assert!(!done && error.code == "request", "{len}: {error}");
    }
    assert!(c.ask_with("call", &whole).0);
}

#[test]
fn a_call_without_what_it_needs_is_refused() {
    let mut c = Checked::start();
    c.ask_with("open", b"{}");
    let whole: Value = serde_json::from_slice(&request(&sample_job())).unwrap();
    let places = ["/format", "/job", "/job/name", "/job/design_hash", "/job/machine/name", "/job/wires"];
    let deeper = ["/job/wires/0/machine", "/job/wires/0/machine/1", "/job/wires/0/machine/1/bend_deg"];
    for place in places.into_iter().chain(deeper) {
        for other in [json!(null), json!(7), json!("7")] {
            let mut call = whole.clone();
            *call.pointer_mut(place).unwrap() = other.clone();
            let (done, reply) = c.ask_with("call", call.to_string().as_bytes());
            let fits = place.ends_with("_deg") && other.is_number()
                || (place.ends_with("name") || place.ends_with("hash")) && other.is_string();
            assert_eq!(done, fits, "{place} = {other}: {}", String::from_utf8_lossy(&reply));
        }
    }
}

/// Every allocation fails once: the driver says so, keeps nothing, and continues afterwards.
#[test]
fn a_lack_of_memory_is_survived() {
    let mut c = Checked::start();
    let requests = [request(&sample_job()), b"{\"call\": \"whistle\"}".to_vec(), b"{".to_vec()];
    let asked = requests.iter().map(|request| ("call", request.as_slice()));
    for (what, bytes) in asked.chain([("open", &b"{\"comment\": \"//\"}"[..]), ("open", b"{\"x\": 1}")]) {
        c.ask_with("open", b"{}");
        c.ask("fail 0");
        let expected = c.ask_with(what, bytes);
        let count: usize = String::from_utf8(c.ask("fail 0").1).unwrap().parse().unwrap();
        assert!(count > 0, "{what} allocates");
        for n in 1..=count {
            c.ask_with("open", b"{}");
            c.ask(&format!("fail {n}"));
            let (done, reply) = c.ask_with(what, bytes);
            let error: DriverError = serde_json::from_slice(&reply).unwrap();
            assert!(!done && error.code == "out-of-memory", "{what}, allocation {n}: {error}");
            c.ask("fail 0");
        }
        c.ask_with("open", b"{}");
        assert_eq!(c.ask_with(what, bytes), expected);
    }
}
