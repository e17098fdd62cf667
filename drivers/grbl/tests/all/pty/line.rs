//! A line of which one byte is changed on the cable. grbl has no checksum: what still makes sense it answers `ok`. Every
//! digit of every line is tried in `src/live/changed.rs`, where time costs nothing.

use serde_json::json;
use wirebend_driver_api::{Event, Step};

use crate::pty::model::{Build, Change};
use crate::pty::{arm_and_send, built, connected_and_homed, until, until_told};

/// Of whole steps of the model.
const WIRE: [Step; 2] = [
    Step { feed_mm: 20.5, rotate_deg: -30.0, bend_deg: 92.35, approach_deg: None },
    Step { feed_mm: 10.0, rotate_deg: 0.0, bend_deg: 0.0, approach_deg: None },
];

/// Such a wire was reported as finished.
#[test]
fn a_bend_that_was_changed_on_its_way_ends_the_wire() {
    let change = Change { line: "G1 Z92.350 F500".to_owned(), at: 4, to: b'1' };
    let build = Build { change: Some(change), ..Build::default() };
    let mut bench = built(json!({"homing": "switches"}), build);
    let session = bench.session.as_mut();
    connected_and_homed(session);
    arm_and_send(session, &WIRE);
    let events = until(session, |event| matches!(event, Event::Finished | Event::Fault { .. }));
    let [Event::Fault { error, in_doubt: Some(1), disconnected: false }] = events.as_slice() else {
        panic!("{events:?}")
    };
    // It went 12.35 there and 92.35 back.
    let said = "in step 1 the bend axis stands at -80\u{b0}, and the lines that were sent end at 0\u{b0}";
    assert!(error.code == "displaced" && error.message.starts_with(said), "{error}");
    // Where the axes stand says nothing of the wire: the step stays in doubt.
    let told = until_told(bench.session.as_mut(), |event| matches!(event, Event::PartMade { .. }));
    assert!(matches!(told.last(), Some(Event::PartMade { step: 1, made: None, .. })), "{told:?}");
    drop(bench.session);
    assert_eq!(bench.model.end().bends, [[20.5, -30.0, -80.0]]);
}
