//! Figure: what is said of a machine that was stopped, against the pulses on its pins: its driver is killed, or the line
//! to it is dead when the stop is sent.

use std::time::{Duration, Instant};

use rustix::process::{Signal, kill_process};
use wirebend_tests_firmware::board::{Avr, Board, Host};

use crate::at_port::AtPort;
use crate::bender::Moment;
use crate::interrupted::{GEARS, Job};
use crate::shop::{Ran, shared};

/// From the end of the driver to the first byte of the stop.
const AT_ONCE: Duration = Duration::from_millis(150);
/// What the computer may be busy with besides.
const GRACE: Duration = Duration::from_secs(1);
/// Longer than any of these is waited for.
const FOR_EVER: Duration = Duration::from_hours(1);
/// Pulses of the job before something happens: in a feed, and in the first bend.
const MOMENTS: [usize; 2] = [60, 400];

pub const STANDS: &str = "the machine has confirmed that it stands";
const MAY_MOVE: &str = "has NOT confirmed that it stands: cut its power";

/// Pulses that the machine makes from now on.
fn made_after<B: Board + Send + 'static>(at: &AtPort<B>) -> usize {
    let before = at.with(|bender| bender.pulses.all().len());
    at.until_still();
    at.with(|bender| bender.pulses.all().len()) - before
}

#[track_caller]
pub fn is_true<B: Board + Send + 'static>(at: &AtPort<B>, ran: Ran, status: i32, case: &str) {
    let moved = made_after(at);
    let ran = ran.ended(status);
    let stands = ran.err.contains(STANDS);
    assert!(stands != ran.err.contains(MAY_MOVE), "{case}: one of the two is said: {}", ran.err);
    assert!(!stands || moved == 0, "{case}: it is said to stand and makes {moved} pulses");
    assert_eq!(stands, status != 6, "{case}: {}", ran.err);
}

fn killed<B: Board + Send + 'static>(pulses: usize) -> Duration {
    let job = Job::cube();
    let at = AtPort::<B>::new(GEARS, Some(&job.stored), true);
    let runs = format!("lost-{}-{pulses}", B::NAME);
    let running = job.shop.start(&runs, &["run", job.file.to_str().unwrap(), "--port", &at.port, "--yes"]);
    running.reached(&at.at(Moment { pulses, cycles: 0 }, |_| {}));
    let driver = running.driver();
    let killed = Instant::now();
    kill_process(driver, Signal::KILL).unwrap();
    let ran = running.wait();
    is_true(&at, ran, 5, &format!("{} killed after {pulses} pulses", B::NAME));
    let stop = at.with(|bender| *bender.stops.first().expect("a STOP"));
    let after = at.with(move |bender| bender.pulses.all().iter().filter(|pulse| pulse.at > stop.at).count());
    assert_eq!(after, 0, "pulses after the STOP");
    stop.came.saturating_duration_since(killed)
}

#[test]
fn a_machine_whose_driver_is_killed_is_stopped() {
    let _others = shared();
    for pulses in MOMENTS {
        for took in [killed::<Avr>(pulses), killed::<Host>(pulses)] {
            println!("driver killed after {pulses} pulses: STOP at the port after {took:?}");
            assert!(took < AT_ONCE + GRACE, "{took:?}");
        }
    }
}

/// All that the program sends is lost for a time, the stop with it.
fn deaf<B: Board + Send + 'static>(dead: Duration, status: i32) {
    let job = Job::cube();
    let at = AtPort::<B>::new(GEARS, Some(&job.stored), true);
    let case = format!("{} deaf for {dead:?}", B::NAME);
    let runs = format!("deaf-{}-{}", B::NAME, dead.as_millis());
    let running = job.shop.start(&runs, &["run", job.file.to_str().unwrap(), "--port", &at.port, "--yes"]);
    running.reached(&at.at(Moment { pulses: 60, cycles: 0 }, move |bender| bender.deafen(dead)));
    let pressed = Instant::now();
    running.kill(Signal::INT);
    let ran = running.wait();
    println!("{case}: said after {:?}", pressed.elapsed());
    is_true(&at, ran, status, &case);
    let runs = job.shop.ran(&runs, &["runs", "--json"]).ended(0).json();
    let id = runs["runs"][0]["id"].as_str().unwrap().to_owned();
    assert!(!id.is_empty(), "{case}: it is in the journal");
}

#[test]
fn what_is_said_after_a_stop_is_true_however_long_the_line_was_dead() {
    let _others = shared();
    for dead in [0, 300, 1000, 5000].map(Duration::from_millis) {
        deaf::<Avr>(dead, 130);
        deaf::<Host>(dead, 130);
    }
    deaf::<Avr>(FOR_EVER, 6);
    deaf::<Host>(FOR_EVER, 6);
}
