//! Figure: what is said of a machine that was stopped, against the pulses on its pins: its driver is lost, or the line
//! to it is dead when the stop is sent.

use std::sync::Mutex;
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

use rustix::process::{Signal, kill_process};
use wirebend_tests_built::Loose;
use wirebend_tests_firmware::board::{Avr, Board, Host};

use crate::jobs::at_port::AtPort;
use crate::jobs::bender::{Moment, Phase};
use crate::jobs::interrupted::{GEARS, Job};
use crate::jobs::shop::{Ran, shared};

/// From the end of the driver to the first byte of the stop.
const AT_ONCE: Duration = Duration::from_millis(150);
/// What the computer may be busy with besides.
const GRACE: Duration = Duration::from_secs(1);
/// Longer than any of these is waited for.
const FOR_EVER: Duration = Duration::from_hours(1);
/// A driver that does not answer is ended then: what a poll may take.
const HUNG: Duration = Duration::from_secs(2);
/// Pulses of a homing that is under way.
const SEARCHING: usize = 40;
/// Cases that are tried beside each other.
const AT_ONCE_TRIED: usize = 3;

pub const STANDS: &str = "the machine has confirmed that it stands";
const MAY_MOVE: &str = "has NOT confirmed that it stands: cut its power";

/// Pulses that the machine gives from now on.
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
    assert!(!stands || moved == 0, "{case}: it is said to stand and gives {moved} pulses");
    assert_eq!(stands, status != 6, "{case}: {}", ran.err);
}

/// What causes a driver to be lost.
#[derive(Debug, Clone, Copy)]
enum By {
    Signal(Signal),
    /// What it does itself, in a word of the hostile driver.
    Itself(&'static str),
}

/// How a driver is lost: in words, by what, and after how long that can be known.
type Way = (&'static str, By, Duration);

const WAYS: [Way; 9] = [
    ("killed", By::Signal(Signal::KILL), Duration::ZERO),
    ("ended by a segmentation fault", By::Signal(Signal::SEGV), Duration::ZERO),
    ("aborted", By::Signal(Signal::ABORT), Duration::ZERO),
    ("ended", By::Signal(Signal::TERM), Duration::ZERO),
    ("hung", By::Signal(Signal::STOP), HUNG),
    ("exits", By::Itself("exit"), Duration::ZERO),
    ("reports a step that was never sent", By::Itself("lie"), Duration::ZERO),
    ("answers what is no JSON", By::Itself("nonsense"), Duration::ZERO),
    ("writes over its pipe", By::Itself("garbage"), Duration::ZERO),
];

/// What the machine does then: it homes, or is in a phase of a line, from 0.
#[derive(Debug, Clone, Copy)]
enum During {
    Homing,
    Line(usize, Phase),
}

const DURING: [During; 6] = [
    During::Homing,
    During::Line(0, Phase::Feed),
    During::Line(1, Phase::Rotate),
    During::Line(0, Phase::Peg),
    During::Line(0, Phase::Swing),
    During::Line(1, Phase::Return),
];

impl During {
    fn hears<B: Board + Send + 'static>(self, at: &AtPort<B>) -> Receiver<()> {
        let Self::Line(line, phase) = self else {
            let (reached, hears) = channel();
            at.with(move |bender| {
                bender.watch(
                    |bender| bender.pulses.len() > SEARCHING,
                    move |_| reached.send(()).unwrap_or_default(),
                );
            });
            return hears;
        };
        at.at(Moment::of(&Job::cube().whole().pulses, line, phase, 50), |_| {})
    }
}

/// Gives after how long the first byte of the stop was at the port.
fn lost<B: Board + Send + 'static>((how, by, _): Way, during: During) -> Duration {
    let job = Job::cube();
    let at = AtPort::<B>::new(GEARS, Some(&job.stored), true);
    let hears = during.hears(&at);
    let case = format!("{}: driver {how} during {during:?}", B::NAME);
    let runs = case.replace([' ', ':', ',', '(', ')'], "-");
    let arguments = ["run", job.file.to_str().unwrap(), "--port", &at.port, "--yes"];
    let folder = tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).unwrap();
    let (running, loose) = match by {
        By::Signal(_) => (job.shop.start(&runs, &arguments), None),
        By::Itself(what) => {
            let loose = Loose::new(folder.path(), "wirebend-kit", what);
            (job.shop.start_program(&loose.program, &runs, &arguments), Some(loose))
        }
    };
    running.reached(&hears);
    let driver = running.driver();
    let begun = Instant::now();
    if let Some(loose) = loose {
        loose.let_loose();
    }
    if let By::Signal(signal) = by {
        kill_process(driver, signal).unwrap();
        // The first takes away the handler that Rust has for a full stack, and two at once count as one.
        while signal == Signal::SEGV && kill_process(driver, signal).is_ok() && begun.elapsed() < GRACE {
            std::thread::sleep(Duration::from_millis(1));
        }
    }
    let ran = running.wait();
    is_true(&at, ran, 5, &case);
    let (stop, after) = at.with(|bender| bender.stopped());
    assert_eq!(after, 0, "{case}: pulses after the STOP");
    let took = stop.came.saturating_duration_since(begun);
    println!("{case}: STOP at the port after {took:?}");
    took
}

/// However its driver is lost, and whatever the machine does.
fn stops_in_every_case<B: Board + Send + 'static>() {
    let all = WAYS.into_iter().flat_map(|way| DURING.map(|during| (way, during)));
    let left = Mutex::new(all);
    let late = Mutex::new(Vec::new());
    std::thread::scope(|scope| {
        for _ in 0..AT_ONCE_TRIED {
            scope.spawn(|| {
                loop {
                    let Some((way, during)) = left.lock().unwrap().next() else { return };
                    let took = lost::<B>(way, during);
                    if took > way.2 + AT_ONCE + GRACE {
                        late.lock().unwrap().push((way.0, during, took));
                    }
                }
            });
        }
    });
    let late = late.into_inner().unwrap();
    assert!(late.is_empty(), "{late:?}");
}

#[test]
fn a_board_whose_driver_is_lost_is_stopped() {
    let _others = shared();
    stops_in_every_case::<Avr>();
}

#[test]
fn a_machine_whose_driver_is_lost_is_stopped() {
    let _others = shared();
    stops_in_every_case::<Host>();
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
