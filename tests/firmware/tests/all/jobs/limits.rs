//! A wire that the board would refuse in its middle is not begun.

use serde_json::{Value, json};
use wirebend_tests_firmware::board::Host;

use crate::jobs::at_port::AtPort;
use crate::jobs::interrupted::{GEARS, Job, coarse};
use crate::jobs::shop::{Shop, shared};

/// The board with a setting of another profile, as a user may have written it before.
fn board_with(settings: &Value) -> AtPort<Host> {
    let mut profile = coarse();
    profile["id"] = json!("before");
    let own = profile["driver"]["settings"].as_object_mut().unwrap();
    own.extend(settings.as_object().unwrap().clone());
    let shop = Shop::new(&[profile]);
    let at = AtPort::<Host>::new(GEARS, Some(&Job::cube().stored), true);
    let write = ["machine-settings", "--machine", "before", "--port", &at.port, "--write", "--yes"];
    shop.ran("before", &write).ended(0);
    at
}

/// The same wire bends to more than a hundred degrees: seven times with the profile's settings, and not once with these.
#[test]
fn a_bend_that_the_boards_settings_forbid_is_refused_before_the_wire() {
    let _others = shared();
    let job = Job::cube();
    let at = board_with(&json!({"bend_limit_deg": 80}));
    let begun = at.with(|bender| bender.pulses.len());
    let file = job.file.to_str().unwrap();
    let run = ["run", file, "--port", &at.port, "--yes", "--json"];
    let error = job.shop.ran("short", &run).ended(5).json();
    assert_eq!(error["error"]["code"], "settings-differ", "{error}");
    // A person who bends wires all the same reads what comes of it.
    let error = job.shop.ran("short", &[&run[..], &["--accept-settings"]].concat()).ended(4).json();
    assert_eq!(error["error"]["code"], "beyond-limit", "{error}");
    let message = error["error"]["message"].as_str().unwrap();
    assert!(message.contains("with step 1 the bend axis goes to") && message.contains("80.0"), "{message}");
    assert!(message.contains("its setting bend_limit"), "{message}");
    assert_eq!(at.with(|bender| bender.pulses.len()), begun, "it has moved");
    assert_eq!(job.shop.ran("short", &["runs", "--json"]).ended(0).json()["runs"], json!([]));
}
