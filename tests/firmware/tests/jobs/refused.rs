//! A line that the machine refuses while it makes the ones before it, which its queue holds: the run is over, and the machine
//! is not until it is told.

use serde_json::json;
use wirebend_tests_firmware::board::{Avr, Board, Host};

use crate::at_port::AtPort;
use crate::bender::lines;
use crate::interrupted::{GEARS, coarse};
use crate::lost::{STANDS, is_true};
use crate::shop::{Shop, example, shared};

/// The head of the board turns less far than the profile says, and the third line of the cube is beyond that.
fn refused<B: Board + Send + 'static>() {
    let mut narrow = coarse();
    narrow["id"] = json!("narrow-kit");
    narrow["driver"]["settings"]["rotate_limit_deg"] = json!(45.0);
    let shop = Shop::new(&[coarse(), narrow]);
    let job = shop.path("cube.wbjob");
    let job = job.to_str().unwrap();
    shop.ran("r", &["plan", &example("cube-8-edges.obj"), "--machine", "coarse-kit", "-o", job]).ended(0);
    let at = AtPort::<B>::new(GEARS, None, false);
    shop.ran("r", &["machine-settings", "--machine", "narrow-kit", "--port", &at.port, "--write", "--yes"])
        .ended(0);
    let running = shop.start("r", &["run", job, "--port", &at.port, "--yes", "--accept-settings"]);
    let ran = running.wait();
    assert!(ran.err.contains("the machine refuses a step"), "{}: {}", B::NAME, ran.err);
    assert!(ran.err.contains(STANDS), "{}: {}", B::NAME, ran.err);
    let (begun, after) = at.with(|bender| {
        let stop = bender.stops.last().expect("a STOP");
        (
            lines(bender.pulses.job()).len(),
            bender.pulses.all().iter().filter(|pulse| pulse.at > stop.at).count(),
        )
    });
    assert!((1..3).contains(&begun), "{}: {begun} lines were begun", B::NAME);
    assert_eq!(after, 0, "{}: pulses after the STOP", B::NAME);
    is_true(&at, ran, 5, B::NAME);
}

#[test]
fn a_machine_that_refuses_a_line_does_not_make_those_that_it_holds() {
    let _others = shared();
    refused::<Avr>();
    refused::<Host>();
}
