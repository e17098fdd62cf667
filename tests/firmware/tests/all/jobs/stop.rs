//! Figure: from Ctrl-C to the byte that stops the machine, on a computer that is busy.

use std::process::{Child, Command};
use std::sync::Mutex;
use std::time::{Duration, Instant};

use rustix::process::Signal;

use crate::jobs::at_port::AtPort;
use crate::jobs::bender::Moment;
use crate::jobs::interrupted::{GEARS, Job};
use crate::jobs::shop::alone;
use wirebend_tests_firmware::board::Host;

/// How long a person may have to wait for a stop, the plan says.
const MAX: Duration = Duration::from_millis(250);
const TRIES: usize = 24;
/// How many wires are bent, and stopped, at the same time.
const AT_ONCE: usize = 4;

/// Another program of the person's that takes all of a core, in a session of its own as from another window.
struct Busy(Child);

impl Busy {
    fn new() -> Self {
        let mut spin = Command::new("setsid");
        spin.args(["sh", "-c", "while :; do :; done"]);
        Self(spin.spawn().expect("setsid of util-linux"))
    }
}

impl Drop for Busy {
    fn drop(&mut self) {
        // It has ended by itself, then, and the test has failed for want of it.
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}

/// From the signal to the byte, somewhere in a job.
fn one(job: &Job, number: usize) -> Duration {
    let at = AtPort::<Host>::new(GEARS, Some(&job.stored), true);
    let runs = format!("stop-{number}");
    let running = job.shop.start(&runs, &["run", job.file.to_str().unwrap(), "--port", &at.port, "--yes"]);
    // All over the first two lines.
    let pulses = 1 + 3000 * number / TRIES;
    running.reached(&at.at(Moment { pulses, cycles: 0 }, |_| {}));
    let pressed = Instant::now();
    running.kill(Signal::INT);
    running.wait().ended(130);
    let (stop, after) = at.with(|bender| bender.stopped());
    assert_eq!(after, 0, "pulses after the STOP");
    stop.came.saturating_duration_since(pressed)
}

#[test]
fn a_stop_is_out_in_time_on_a_busy_computer() {
    let _nobody_else = alone();
    let job = Job::cube();
    let took = Mutex::new(Vec::new());
    let cores = std::thread::available_parallelism().unwrap().get();
    let mut busy: Vec<Busy> = (0..cores).map(|_| Busy::new()).collect();
    std::thread::scope(|scope| {
        for first in 0..AT_ONCE {
            let took = &took;
            scope.spawn(move || {
                for number in (first..TRIES).step_by(AT_ONCE) {
                    let time = one(job, number);
                    took.lock().unwrap().push(time);
                }
            });
        }
    });
    assert!(busy.iter_mut().all(|busy| busy.0.try_wait().unwrap().is_none()), "a core was not busy");
    let mut took = took.into_inner().unwrap();
    took.sort();
    let (median, worst) = (took[took.len() / 2], took[took.len() - 1]);
    println!(
        "Ctrl-C to STOP at the port, {cores} cores busy, {TRIES} tries: median {median:?}, worst {worst:?}"
    );
    assert!(worst <= MAX, "a stop took {worst:?}");
}
