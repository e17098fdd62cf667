//! How an interrupted job is gone on with, and what it comes to.

use wirebend_driver_api::Axis;

use super::LINES;
use super::case::{Case, What};
use super::job::Job;
use crate::at_port::AtPort;
use crate::bender::{Pulse, lines, net, ways};
use crate::shop::Ran;
use wirebend_tests_firmware::board::Board;

/// What the machine has made of a job, by its pulses alone.
struct Truth {
    /// Lines that are complete.
    whole: usize,
    /// Pulses of the line that is not.
    part: Vec<Pulse>,
}

impl Truth {
    fn of(job: &Job, made: &[Pulse]) -> Self {
        assert_eq!(ways(made), ways(&job.pulses[..made.len()]), "not the pulses of the job");
        let lines = lines(&job.pulses);
        let whole = lines.iter().filter(|line| line.end <= made.len()).count();
        let from = lines.get(whole).map_or(made.len(), |line| line.start);
        Self { whole, part: made[from.min(made.len())..].to_vec() }
    }
}

impl Case {
    /// Goes on, and compares what came out with the job that nothing has interrupted.
    pub fn go_on<B: Board + Send + 'static>(&self, job: &Job, at: &AtPort<B>, runs: &str) -> String {
        let made = at.with(|bender| bender.pulses.job().to_vec());
        let truth = Truth::of(job, &made);
        let record = record(job, runs);
        let known = usize::try_from(record["made"].as_u64().unwrap()).unwrap();
        // Of a line whose end was not heard any more nothing is known; of none is it said that was not made.
        assert!(known <= truth.whole, "{known} lines are said to be made, and {} are", truth.whole);
        assert!(
            truth.whole <= known + 1 || self.may_run_on(),
            "{} lines are made, {known} known",
            truth.whole
        );
        let resume = |answer: &str| {
            let file = job.file.to_str().unwrap();
            job.shop.ran(runs, &["run", file, "--port", &at.port, "--yes", answer])
        };
        let keeps = matches!(self.what, What::ProgramKilled | What::CablePulled);
        let told = if keeps && !self.reset_on_open {
            resume("--resume").ended(0);
            check_unbroken(job, at);
            format!("{} lines were made, {} known; the same wire came out", truth.whole, known)
        } else {
            self.decide(job, at, &truth, known, resume)
        };
        let record = self::record(job, runs);
        assert_eq!(
            (record["outcome"].as_str(), record["made"].as_u64()),
            (Some("finished"), Some(LINES as u64))
        );
        assert_eq!(record["interruptions"].as_array().unwrap().len(), 1, "{record}");
        told
    }

    /// Whether the machine makes lines that nobody hears of.
    fn may_run_on(&self) -> bool {
        matches!(self.what, What::ProgramKilled | What::CablePulled)
    }

    /// A person looks at the wire and says of each step in doubt whether it was made to its end.
    fn decide<B: Board + Send + 'static>(
        &self,
        job: &Job,
        at: &AtPort<B>,
        truth: &Truth,
        known: usize,
        resume: impl Fn(&str) -> Ran,
    ) -> String {
        let count = || at.with(|bender| bender.pulses.len());
        let before = count();
        let mut ran = resume("--resume");
        assert_eq!(count(), before, "it moves before anybody has said anything");
        let mut n = known;
        // One that has fed and turned, and bent in part, is closer to its end than to its beginning.
        let bending = truth.part.iter().any(|pulse| pulse.axis == Axis::Bend);
        let taken = truth.whole + usize::from(bending);
        while ran.status.code() != Some(0) {
            ran.ended(2)
                .says(&format!("whether step {} of {LINES}", n + 1))
                .says("--resume=made")
                .says("--resume=not-made")
                .says("made in part");
            let answer = if n < taken { "--resume=made" } else { "--resume=not-made" };
            ran = resume(answer);
            n += 1;
        }
        let pulses = at.with(|bender| bender.pulses.all().to_vec());
        let lines = lines(&job.pulses);
        let before_line =
            |line: usize| &job.pulses[..lines.get(line).map_or(job.pulses.len(), |line| line.start)];
        // What was fed of a line that is made again is fed twice.
        let twice = if bending { 0 } else { net(&truth.part, Axis::Feed) };
        assert_eq!(net(&pulses, Axis::Feed), net(&job.pulses, Axis::Feed) + twice, "feed");
        // A head that was turned in part and then forgotten stays off by that; one that is remembered is turned back.
        let forgotten = !matches!(self.what, What::Stopped | What::DriverKilled) || self.reset_on_open;
        let stood = net(before_line(truth.whole), Axis::Rotate) + net(&truth.part, Axis::Rotate);
        let off = if forgotten { stood - net(before_line(taken), Axis::Rotate) } else { 0 };
        assert_eq!(net(&pulses, Axis::Rotate), net(&job.pulses, Axis::Rotate) + off, "rotate");
        // What comes then is the rest of the job, line by line.
        let rest = &pulses[before..];
        let feeds = rest.iter().position(|pulse| pulse.axis == Axis::Feed).unwrap_or(rest.len());
        let steady = |pulses: &[Pulse]| {
            let kept: Vec<Pulse> =
                pulses.iter().copied().filter(|pulse| pulse.axis != Axis::Rotate).collect();
            ways(&kept)
        };
        assert_eq!(steady(&rest[feeds..]), steady(&job.pulses[before_line(taken).len()..]), "the rest");
        format!(
            "{} lines were made and {} pulses of the next, {known} known; {twice} pulses of feed and {off} of the \
             head are off",
            truth.whole,
            truth.part.len()
        )
    }
}

/// Nothing was lost: the same pulses, the same wire.
fn check_unbroken<B: Board + Send + 'static>(job: &Job, at: &AtPort<B>) {
    let (pulses, corners, incidents) =
        at.with(|bender| (bender.pulses.job().to_vec(), bender.made().corners(), bender.incidents()));
    assert_eq!(pulses.len(), job.pulses.len(), "pulses");
    assert_eq!(ways(&pulses), ways(&job.pulses));
    assert_eq!(corners, job.corners);
    assert_eq!(incidents, Vec::<String>::new());
}

/// The record of the wire.
fn record(job: &Job, runs: &str) -> serde_json::Value {
    let listed = job.shop.ran(runs, &["runs", "--json"]).ended(0).json();
    let id = listed["runs"][0]["id"].as_str().unwrap().to_owned();
    job.shop.ran(runs, &["runs", "show", &id, "--json"]).ended(0).json()["record"].clone()
}
