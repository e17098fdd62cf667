//! A line that the machine refuses while it runs the ones before it, which its queue holds: the run is over, and the machine
//! is not until it is stopped.

use wirebend_tests_firmware::board::{Avr, Board, Host};

use crate::jobs::at_port::AtPort;
use crate::jobs::bender::lines;
use crate::jobs::interrupted::{GEARS, Job};
use crate::jobs::lost::{STANDS, is_true};
use crate::jobs::shop::shared;

/// In the fifth line, which is sent once the first is done, the head is heard to turn twice about more than the board lets it.
fn too_far(payload: &str) -> Option<String> {
    let [line, feed, turn, bend] = payload.split(',').collect::<Vec<_>>()[..] else { return None };
    let turn = turn.parse::<i64>().ok()? + 2 * i64::from(GEARS.rotate_steps_per_turn);
    (line == "M5").then(|| format!("{line},{feed},{turn},{bend}"))
}

fn refused<B: Board + Send + 'static>() {
    let job = Job::cube();
    let at = AtPort::<B>::new(GEARS, Some(&job.stored), false);
    at.with(|bender| bender.hears(Box::new(too_far)));
    let runs = format!("refused-{}", B::NAME);
    let running = job.shop.start(&runs, &["run", job.file.to_str().unwrap(), "--port", &at.port, "--yes"]);
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
    assert!((2..5).contains(&begun), "{}: {begun} lines were begun", B::NAME);
    assert_eq!(after, 0, "{}: pulses after the STOP", B::NAME);
    is_true(&at, ran, 5, B::NAME);
}

#[test]
fn a_machine_that_refuses_a_line_does_not_make_those_that_it_holds() {
    let _others = shared();
    refused::<Avr>();
    refused::<Host>();
}
