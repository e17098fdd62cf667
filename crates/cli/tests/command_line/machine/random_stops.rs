//! Figure: a wire on grbl is stopped at random moments and resumed, by a person who answers what is true. What comes out
//! is the wire that was not stopped.

use std::sync::Mutex;
use std::thread;
use std::time::{Duration, Instant};

use rustix::process::Signal;
use serde_json::Value;

use super::bender::Bender;
use super::interrupted::Going;
use super::runs::{PATIENCE, Shop};
use crate::grbl_model::Build;

const RUNS: usize = 12;
/// Runs at the same time: nearly all of their time is waiting for the machine.
const AT_ONCE: usize = 2;
/// Steps that the driver has at most, and of which it may have done none or all.
const MAX_ASKED: usize = 5;
/// A step of the model is 0.0125 mm or degrees; what is asked for is rounded to it when a step begins, and when its rest does.
const CLOSE: f64 = 0.03;

/// What came out of the nozzle: where on the wire, how the head stood, and how far it was bent there.
#[derive(Debug, Clone)]
struct Made {
    fed: f64,
    bends: Vec<[f64; 3]>,
}

impl Made {
    /// Bends at one place are one, as far as the farthest.
    fn new(fed: f64, all: impl IntoIterator<Item = [f64; 3]>) -> Self {
        let mut bends: Vec<[f64; 3]> = Vec::new();
        for bend in all {
            match bends.last_mut() {
                Some(last) if close(&last[..2], &bend[..2]) => {
                    if bend[2].abs() > last[2].abs() {
                        last[2] = bend[2];
                    }
                }
                _ => bends.push(bend),
            }
        }
        Self { fed, bends }
    }

    fn is(&self, other: &Self) -> bool {
        let alike = |(one, other): (&[f64; 3], &[f64; 3])| close(one, other);
        close(&[self.fed], &[other.fed])
            && self.bends.len() == other.bends.len()
            && self.bends.iter().zip(&other.bends).all(alike)
    }
}

fn close(one: &[f64], other: &[f64]) -> bool {
    one.iter().zip(other).all(|(a, b)| (a - b).abs() < CLOSE)
}

/// A quick bender at a port, and the job.
struct Bench {
    shop: Shop,
    bender: Bender,
}

impl Bench {
    fn new() -> Self {
        let build = Build { switches: false, steps_a_turn: 16, ..Build::default() };
        Self { shop: Shop::on("mirror-left.obj", "grbl-bender"), bender: Bender::new(build) }
    }

    /// What is sent to the machine for each step: feed and rotation.
    fn steps(&self) -> Vec<[f64; 2]> {
        let job: Value =
            serde_json::from_slice(&std::fs::read(self.shop.path().join("a.wbjob")).unwrap()).unwrap();
        let steps = job["wires"][0]["compensated"].as_array().unwrap();
        steps.iter().map(|step| ["feed_mm", "rotate_deg"].map(|key| step[key].as_f64().unwrap())).collect()
    }

    fn arguments<'a>(&'a self, more: &[&'a str]) -> Vec<&'a str> {
        [&["run", "a.wbjob", "--port", &self.bender.port, "--yes", "--axes-at-zero"], more].concat()
    }
}

/// A wire that is not stopped, and how long it takes from its first motion.
fn undisturbed() -> (Made, Duration) {
    let bench = Bench::new();
    let going = Going::start(&bench.shop, &bench.arguments(&[]));
    let begun = first_motion(&bench.bender);
    assert_eq!(going.end().0, Some(0));
    let took = begun.elapsed();
    let record = bench.bender.model.end();
    (Made::new(record.at[0], record.bends), took)
}

fn first_motion(bender: &Bender) -> Instant {
    let begun = Instant::now();
    while bender.model.now().at.iter().all(|at| *at == 0.0) {
        assert!(begun.elapsed() < PATIENCE, "it does not move");
        thread::sleep(Duration::from_millis(1));
    }
    Instant::now()
}

/// What a person says of the step that they are asked about: what the machine counts, which is true as the model loses no step,
/// or what they measure.
fn answer(said: &str, bench: &Bench, [fed, turned, _]: [f64; 3]) -> String {
    let after = |words: &str| said.find(words).map(|at| &said[at + words.len()..]);
    let number = |rest: &str| rest.chars().take_while(char::is_ascii_digit).collect::<String>();
    if let Some(rest) = after("--resume=as-counted:") {
        return format!("--resume=as-counted:{}", number(rest));
    }
    let n = number(after("--resume=made:").unwrap_or_else(|| panic!("it does not ask: {said}")));
    let step: usize = n.parse().unwrap();
    let steps = bench.steps();
    let before: [f64; 2] = [0, 1].map(|axis| steps[..step - 1].iter().map(|step| step[axis]).sum());
    let part = [fed - before[0], turned - before[1]];
    if part[0] < CLOSE {
        format!("--resume=not-made:{n}")
    } else {
        format!("--resume=part:{n}:{}:{}", part[0], part[1])
    }
}

/// Stops it after so long and resumes. Gives what was bent, and how often a person was asked; nothing where the wire was done before
/// the stop, as it may be when the run that was measured had to wait for a busy computer.
fn stopped(after: Duration) -> Option<(Made, usize)> {
    let bench = Bench::new();
    let going = Going::start(&bench.shop, &bench.arguments(&[]));
    let begun = first_motion(&bench.bender);
    thread::sleep(after.saturating_sub(begun.elapsed()));
    going.send(Signal::INT);
    let status = going.end().0;
    if status == Some(0) {
        return None;
    }
    assert_eq!(status, Some(130), "after {after:?}");
    let stood = bench.bender.model.now().at;
    bench.bender.model.turn_to_marks();
    let mut asked = 0;
    let mut ran = bench.shop.run(&bench.arguments(&["--head-at=0", "--resume"]));
    while ran.status != 0 {
        assert_eq!((ran.status, asked < MAX_ASKED), (2, true), "after {after:?}: {}", ran.err);
        asked += 1;
        let answer = answer(&ran.err, &bench, stood);
        ran = bench.shop.run(&bench.arguments(&["--head-at=0", &answer]));
    }
    let record = bench.bender.model.end();
    Some((Made::new(record.at[0], record.bends), asked))
}

#[test]
#[allow(clippy::print_stdout)] // a figure is worth reading
fn a_wire_that_is_stopped_at_random_moments_comes_out_as_planned() {
    let (wanted, takes) = undisturbed();
    assert_eq!(wanted.bends.len(), 4, "{wanted:?}");
    let mut state = 20_261_123_u64;
    let moments: Vec<Duration> = (0..RUNS)
        .map(|_| {
            // The constants of Knuth's MMIX.
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let thousandths = u32::try_from(state >> 33).unwrap() % 900;
            takes * thousandths / 1000
        })
        .collect();
    let (left, ended) = (Mutex::new(moments.into_iter()), Mutex::new(Vec::new()));
    thread::scope(|scope| {
        for _ in 0..AT_ONCE {
            scope.spawn(|| {
                loop {
                    let Some(mut after) = left.lock().unwrap().next() else { return };
                    let (made, asked) = loop {
                        match stopped(after) {
                            Some(ended) => break ended,
                            None => after = after * 4 / 5,
                        }
                    };
                    assert!(made.is(&wanted), "stopped after {after:?}: {made:?}, and not {wanted:?}");
                    ended.lock().unwrap().push(asked);
                }
            });
        }
    });
    let ended = ended.into_inner().unwrap();
    let asked = ended.iter().filter(|asked| **asked > 0).count();
    println!(
        "grbl: {} of {RUNS} wires of {takes:.1?} come out as planned; in {asked} a person was asked",
        ended.len()
    );
}
