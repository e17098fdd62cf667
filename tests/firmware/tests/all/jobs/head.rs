//! Figure: the head's account over wires that were stopped, lost and given up, one after the other, on a board that forgets
//! where its head stands whenever its port is opened.

use std::path::PathBuf;
use std::sync::mpsc::{Receiver, channel};

use rustix::process::Signal;
use wirebend_driver_api::Axis;
use wirebend_tests_firmware::board::Avr;

use crate::jobs::at_port::AtPort;
use crate::jobs::bender::net;
use crate::jobs::interrupted::{GEARS, Job, MACHINE};
use crate::jobs::shop::{Ran, shared};

const ROUNDS: usize = 20;
/// What cannot be distinguished of a head: a step of its motor.
const STEP_DEG: f64 = 360.0 / 1646.0;

struct Bench {
    job: &'static Job,
    file: PathBuf,
    at: AtPort<Avr>,
    runs: String,
}

impl Bench {
    fn new(runs: &str) -> Self {
        let job = Job::cube();
        let at = AtPort::new(GEARS, Some(&job.stored), true);
        Self { job, file: job.file.clone(), at, runs: runs.to_owned() }
    }

    /// Of a wire with one turn, which leaves the head there.
    fn of_one_turn(runs: &str) -> Self {
        let bench = Self::new(runs);
        let design = bench.job.shop.path("one-turn.obj");
        std::fs::write(&design, "v 0 0 0\nv 40 0 0\nv 40 40 0\nv 40 40 40\nl 1 2 3 4\n").unwrap();
        let file = bench.job.shop.path("one-turn.wbjob");
        let plan = ["plan", design.to_str().unwrap(), "--machine", MACHINE, "-o", file.to_str().unwrap()];
        bench.job.shop.ran(runs, &plan).ended(0);
        Self { file, ..bench }
    }

    fn arguments<'a>(&'a self, more: &[&'a str]) -> Vec<&'a str> {
        [&["run", self.file.to_str().unwrap(), "--port", &self.at.port], more].concat()
    }

    fn ran(&self, more: &[&str]) -> Ran {
        self.job.shop.ran(&self.runs, &self.arguments(more))
    }

    /// Where the head really stands, by its pulses since the power came on.
    fn stands_deg(&self) -> f64 {
        let steps = self.at.with(|bender| net(bender.pulses.all(), Axis::Rotate));
        f64::from(i32::try_from(steps).unwrap()) * STEP_DEG
    }

    fn pulses(&self) -> usize {
        self.at.with(|bender| bender.pulses.len())
    }

    /// Hears when the head has turned so far within a wire, in steps, and says how it stood when the wire's first feed
    /// began.
    fn turned(&self, steps: u32) -> Receiver<i64> {
        let (reached, hears) = channel();
        self.at.with(move |bender| {
            let mut seen = bender.pulses.len();
            let (mut began, mut turned) = (None, 0);
            let when = move |bender: &crate::jobs::bender::Bender<Avr>| {
                for at in seen..bender.pulses.len() {
                    let pulse = bender.pulses.all()[at];
                    match pulse.axis {
                        Axis::Feed if began.is_none() => {
                            let head = net(&bender.pulses.all()[..at], Axis::Rotate);
                            began = Some(head);
                            // A caller that does not wait for it has failed before.
                            let _ = reached.send(head);
                        }
                        Axis::Rotate if began.is_some() => turned += 1,
                        _ => {}
                    }
                }
                seen = bender.pulses.len();
                let there = turned >= steps;
                if there {
                    let _ = reached.send(0);
                }
                there
            };
            bender.watch(when, |_| {});
        });
        hears
    }

    /// Begins the wire, and interrupts it once the head has turned so far; gives how the head stood when the wire began.
    fn interrupted(&self, more: &[&str], steps: u32, signal: Signal) -> i64 {
        let hears = self.turned(steps);
        let running = self.job.shop.start(&self.runs, &self.arguments(more));
        let began = running.heard(&hears);
        running.heard(&hears);
        running.kill(signal);
        let ran = running.wait();
        let expected = if signal == Signal::INT { Some(130) } else { None };
        assert_eq!(ran.status.code(), expected, "{}", ran.err);
        self.at.until_still();
        began
    }
}

/// Stopped in the middle of its turn or after it, or killed so that no program hears how far it came: given up, and begun
/// anew, 20 times.
#[test]
fn the_head_stays_within_its_cable_over_wires_that_are_given_up() {
    let _others = shared();
    let bench = Bench::new("given-up");
    let (mut asked, mut furthest) = (0, 0.0_f64);
    for round in 0..ROUNDS {
        // The head turns by a quarter, 411 steps.
        let steps = [250, 411, 90, 400][round % 4];
        let signal = if round % 4 == 2 { Signal::KILL } else { Signal::INT };
        let stands = bench.stands_deg();
        let said = format!("--head-at={stands}");
        let mut more = vec!["--yes"];
        if round % 4 == 3 {
            // No program has heard where it stands.
            let before = bench.pulses();
            bench.ran(&more).ended(2).says("--head-at").says("between 0.0° and 90.0°");
            assert_eq!(bench.pulses(), before, "it moves before anybody has said where its head stands");
            more.push(&said);
            asked += 1;
        }
        let began = bench.interrupted(&more, steps, signal);
        assert!(began.abs() <= 1, "round {round}: the wire began with the head {began} steps from zero");
        furthest = furthest.max(bench.stands_deg().abs());
        bench.ran(&["--abandon"]).ended(0);
    }
    println!("{ROUNDS} wires given up: the head is at most {furthest:.1}° from zero; asked {asked} times");
    assert_eq!(bench.at.with(|bender| bender.incidents()), Vec::<String>::new());
}

/// A wire leaves the head where its program ends. The next one begins at zero, not there.
#[test]
fn a_wire_that_was_made_leaves_no_turn_to_the_next() {
    let _others = shared();
    let bench = Bench::of_one_turn("made");
    for round in 0..6 {
        let hears = bench.turned(u32::MAX);
        bench.ran(&["--yes"]).ended(0);
        let began = hears.try_recv().unwrap();
        assert!(began.abs() <= 1, "wire {round} began with the head {began} steps from zero");
        let ends = bench.stands_deg();
        assert!((ends.abs() - 90.0).abs() < 2.0 * STEP_DEG, "wire {round} leaves the head at {ends}°");
    }
    assert_eq!(bench.at.with(|bender| bender.incidents()), Vec::<String>::new());
}
