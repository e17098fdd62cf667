//! How an interrupted job is resumed, and what it comes to.

use std::cmp::Ordering;

use wirebend_driver_api::Axis;

use super::LINES;
use super::case::{Case, What};
use super::job::{GEARS, Job};
use crate::jobs::at_port::AtPort;
use crate::jobs::bender::{Pulse, lines, net, ways};
use crate::jobs::shop::Ran;
use wirebend_tests_firmware::board::Board;

/// A motor step of the feed is 0.18 mm on this machine.
const CORNERS_MM: f64 = 0.18;

/// How a job was resumed.
pub struct Went {
    /// Steps that a person was asked about.
    pub asked: usize,
    /// The farthest that a corner of the wire is from where it should be, mm.
    pub off_mm: f64,
    pub told: String,
}
/// A step of the head's motor.
const HEAD_STEP_DEG: f64 = 360.0 / 1646.0;

/// What the machine has done of a job, by its pulses alone.
struct Truth {
    /// Lines that are complete.
    whole: usize,
    /// Pulses of the line that is not.
    part: Vec<Pulse>,
}

impl Truth {
    fn of(job: &Job, made: &[Pulse]) -> Self {
        assert_eq!(ways(made), ways(&job.whole().pulses[..made.len()]), "not the pulses of the job");
        let lines = lines(&job.whole().pulses);
        let whole = lines.iter().filter(|line| line.end <= made.len()).count();
        let from = lines.get(whole).map_or(made.len(), |line| line.start);
        Self { whole, part: made[from.min(made.len())..].to_vec() }
    }

    /// What a person measures of the step that is not complete: mm fed and degrees turned.
    fn measured(&self) -> [f64; 2] {
        let steps = |axis| i32::try_from(net(&self.part, axis)).map(f64::from).unwrap();
        let turn = f64::from(GEARS.rotate_steps_per_turn);
        [steps(Axis::Feed) / GEARS.feed_steps_per_mm, steps(Axis::Rotate) * 360.0 / turn]
    }
}

impl Case {
    /// Resumes, and compares what came out with the job that nothing has interrupted.
    pub fn go_on<B: Board + Send + 'static>(&self, job: &Job, at: &AtPort<B>, runs: &str) -> Went {
        let made = at.with(|bender| bender.pulses.job().to_vec());
        let truth = Truth::of(job, &made);
        let record = record(job, runs);
        let known = usize::try_from(record["made"].as_u64().unwrap()).unwrap();
        // Of a line whose end was not heard any more nothing is known; none that was not done is reported.
        assert!(known <= truth.whole, "{known} lines are said to be done, and {} are", truth.whole);
        // A machine whose driver is lost goes on until it is stopped by another, and nobody is told of what it does meanwhile.
        let told = if self.what == What::DriverKilled { truth.whole.min(self.line) } else { truth.whole };
        assert!(told <= known + 1 || self.may_run_on(), "{told} lines are done, {known} known");
        // Where the head stands only the machine knows where that was not reported, and only as long as it has its power.
        let lost = match self.what {
            What::Stopped => false,
            What::ControllerReset | What::PowerLost => true,
            What::DriverKilled | What::ProgramKilled | What::CablePulled => self.reset_on_open,
        };
        let stands = f64::from(i32::try_from(net(&made, Axis::Rotate)).unwrap()) * HEAD_STEP_DEG;
        let said = format!("--head-at={stands}");
        let resume = |answer: &str| {
            let file = job.file.to_str().unwrap();
            let mut arguments = vec!["run", file, "--port", &at.port, "--yes", answer];
            arguments.extend(lost.then_some(said.as_str()));
            job.shop.ran(runs, &arguments)
        };
        let keeps = matches!(self.what, What::ProgramKilled | What::CablePulled);
        let went = if keeps && !self.reset_on_open {
            resume("--resume").ended(0);
            check_unbroken(job, at);
            let told = format!("{} steps were done, {known} known; the same wire came out", truth.whole);
            Went { asked: 0, off_mm: 0.0, told }
        } else {
            self.decide(job, at, &truth, known, resume)
        };
        let record = self::record(job, runs);
        assert_eq!(
            (record["outcome"].as_str(), record["made"].as_u64()),
            (Some("finished"), Some(LINES as u64))
        );
        // Without power the controller starts anew and its port goes: which is noticed first, and whether both are, is chance.
        let most = if matches!(self.what, What::PowerLost) { 2 } else { 1 };
        assert!((1..=most).contains(&record["interruptions"].as_array().unwrap().len()), "{record}");
        went
    }

    /// Whether the machine runs lines that are not reported.
    fn may_run_on(&self) -> bool {
        matches!(self.what, What::ProgramKilled | What::CablePulled)
    }

    /// A person looks at the wire, and says of each step in doubt how much of it was done.
    fn decide<B: Board + Send + 'static>(
        &self,
        job: &Job,
        at: &AtPort<B>,
        truth: &Truth,
        known: usize,
        resume: impl Fn(&str) -> Ran,
    ) -> Went {
        let before = at.with(|bender| bender.pulses.len());
        // A machine that was stopped counts where it stands, and a person confirms it; after a lost driver a person measures.
        let tells = self.what == What::Stopped;
        let mut ran = resume("--resume");
        let mut asked = 0;
        let mut n = known;
        while ran.status.code() != Some(0) {
            let after = at.with(|bender| bender.pulses.len());
            assert_eq!(after, before, "it moves before anybody has said anything");
            n += 1;
            asked += 1;
            ran.ended(2)
                .says(&format!("whether step {n} of {LINES}"))
                .says(&format!("--resume=made:{n}"))
                .says(&format!("--resume=part:{n}:"));
            let [fed, turned] = truth.measured();
            let answer = match n.cmp(&(truth.whole + 1)) {
                Ordering::Less => format!("--resume=made:{n}"),
                Ordering::Equal if tells => format!("--resume=as-counted:{n}"),
                Ordering::Equal => format!("--resume=part:{n}:{fed}:{turned}"),
                Ordering::Greater => format!("--resume=not-made:{n}"),
            };
            ran = resume(&answer);
        }
        let on_its_way = truth.part.last().is_some_and(|pulse| pulse.axis != Axis::Bend);
        assert!(!tells || asked <= usize::from(on_its_way), "asked {asked} times of what the machine knows");
        assert!(
            tells || asked > 0 || truth.part.is_empty(),
            "the user was not asked about what is not known"
        );
        let (all, corners) = at.with(|bender| (bender.pulses.all().to_vec(), bender.made().corners()));
        // What is measured in degrees is not in whole steps of the motor: 90\u{b0} are 411.5 of them.
        let most = u64::from(asked > 0 && !tells);
        for axis in [Axis::Feed, Axis::Rotate] {
            let (made, wanted) = (net(&all, axis), net(&job.whole().pulses, axis));
            assert!(made.abs_diff(wanted) <= most, "{axis:?}: {made} pulses, not {wanted}");
        }
        let off_mm = apart(&corners, &job.whole().corners);
        assert!(
            off_mm < CORNERS_MM,
            "a corner is {off_mm:.3} mm from where it is in a wire that nothing interrupts"
        );
        // What comes after the step is the rest of the job, line by line.
        let rest = &all[before..];
        let whole = lines(&job.whole().pulses)
            .get(truth.whole + 1)
            .map_or(&[][..], |line| &job.whole().pulses[line.start..]);
        assert!(steady(rest).ends_with(&steady(whole)), "the rest");
        let told = format!(
            "{} steps were done and {} pulses of the next, {known} known, {asked} asked about; the farthest corner is {off_mm:.3} mm off",
            truth.whole,
            truth.part.len()
        );
        Went { asked, off_mm, told }
    }
}

/// Pulses without those of the head, which is turned to where it was first.
fn steady(pulses: &[Pulse]) -> Vec<(Axis, bool)> {
    let kept: Vec<Pulse> = pulses.iter().copied().filter(|pulse| pulse.axis != Axis::Rotate).collect();
    ways(&kept)
}

/// The farthest that a corner is from where it should be, mm.
fn apart(made: &[[f64; 3]], wanted: &[[f64; 3]]) -> f64 {
    assert_eq!(made.len(), wanted.len(), "another wire: {made:?}");
    let off = |(a, b): (&[f64; 3], &[f64; 3])| (0..3).map(|at| (a[at] - b[at]).powi(2)).sum::<f64>().sqrt();
    made.iter().zip(wanted).map(off).fold(0.0, f64::max)
}

/// Nothing was lost: the same pulses, the same wire.
fn check_unbroken<B: Board + Send + 'static>(job: &Job, at: &AtPort<B>) {
    let (pulses, corners, incidents) =
        at.with(|bender| (bender.pulses.job().to_vec(), bender.made().corners(), bender.incidents()));
    assert_eq!(pulses.len(), job.whole().pulses.len(), "pulses");
    assert_eq!(ways(&pulses), ways(&job.whole().pulses));
    assert_eq!(corners, job.whole().corners);
    assert_eq!(incidents, Vec::<String>::new());
}

/// The record of the wire.
fn record(job: &Job, runs: &str) -> serde_json::Value {
    let listed = job.shop.ran(runs, &["runs", "--json"]).ended(0).json();
    let id = listed["runs"][0]["id"].as_str().unwrap().to_owned();
    job.shop.ran(runs, &["runs", "show", &id, "--json"]).ended(0).json()["record"].clone()
}
