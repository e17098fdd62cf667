//! Transcripts, and what holds for any wire.

use std::path::Path;

use proptest::prelude::*;
use wirebend_driver_api::conformance::sample_job;
use wirebend_driver_api::transcript::{self, Answered, Conversation};
use wirebend_driver_api::{Call, MachineDriver, Step};

use super::*;
use crate::HowToMechatronics;

const FOLDER: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/drivers/howtomechatronics");

impl Conversation for Timed {
    fn receive(&mut self, bytes: &[u8], now: Duration) {
        Self::receive(self, bytes, now);
    }

    fn pass(&mut self, now: Duration) {
        Self::pass(self, now);
    }

    fn unplugged(&mut self, _now: Duration) {
        Self::unplugged(self);
    }

    fn call(&mut self, call: &Call, _now: Duration) -> Result<Answered, DriverError> {
        match call {
            Call::Arm(run) => self.arm(run).map(|()| Answered::Taken),
            Call::Send(batch) => self.send(batch).map(Answered::Sent),
            Call::Stop => {
                self.stop();
                Ok(Answered::Taken)
            }
            _ => Err(DriverError::unsupported("do that")),
        }
    }

    fn take_output(&mut self) -> Vec<u8> {
        Self::take_output(self)
    }

    fn next_event(&mut self) -> Option<Event> {
        Self::next_event(self)
    }
}

#[test]
fn the_machine_is_spoken_to_as_written_down() {
    let ran = transcript::run_folder(Path::new(FOLDER), |settings| {
        let settings: Settings = serde_json::from_value(settings)
            .map_err(|error| DriverError::new("settings", error.to_string(), ""))?;
        settings.check()?;
        Ok(Timed::new(settings))
    });
    assert!(ran.is_ok(), "{}", transcript::told(&ran));
}

fn any_step() -> impl Strategy<Value = Step> {
    (0.0..2000.0_f64, -360.0..360.0_f64, -180.0..180.0_f64).prop_map(|(feed_mm, rotate_deg, bend_deg)| Step {
        feed_mm,
        rotate_deg,
        bend_deg,
        approach_deg: None,
    })
}

fn run_of(steps: usize) -> Run {
    let steps = u32::try_from(steps).unwrap();
    Run { job_hash: "0".repeat(64), name: "sample".to_owned(), wire: 0, steps, ..Run::default() }
}

fn written(steps: &[Step]) -> String {
    let mut job = sample_job();
    job.wires[0].machine = Some(steps.to_vec());
    let driver = HowToMechatronics::open(Settings::default()).unwrap();
    driver.encode(crate::FORMAT, &job).unwrap().files.remove(0).text
}

proptest! {
    /// However the program divides a wire into batches, the machine gets what the file has.
    #[test]
    fn what_is_sent_is_what_is_written(
        steps in prop::collection::vec(any_step(), 1..100),
        sizes in prop::collection::vec(1_usize..100, 100),
    ) {
        let mut timed = Timed::new(Settings { end_each_wire: true, ..Settings::default() });
        let mut now = timed.settings.boot();
        timed.pass(now);
        timed.arm(&run_of(steps.len())).unwrap();
        let (mut sent, mut done, mut finished) = (Vec::new(), 0, false);
        let mut sizes = sizes.into_iter().cycle();
        let numbered: Vec<NumberedStep> =
            (1..).zip(&steps).map(|(n, step)| NumberedStep { n, step: *step }).collect();
        let mut accepted = 0;
        while !finished {
            // From one before what was taken, as after an answer that got lost.
            let from = usize::try_from(accepted).unwrap().saturating_sub(1);
            let to = (from + sizes.next().unwrap()).min(steps.len());
            let batch = Batch { steps: numbered[from..to].to_vec(), last: to == steps.len() };
            accepted = timed.send(&batch).unwrap().accepted;
            now += Duration::from_secs(30);
            timed.pass(now);
            sent.extend(timed.take_output());
            while let Some(event) = timed.next_event() {
                if let Event::Done { n } = event {
                    prop_assert_eq!(n, done + 1, "each step once and in order");
                    done = n;
                }
                finished |= event == Event::Finished;
            }
        }
        prop_assert_eq!(usize::try_from(done).unwrap(), steps.len());
        prop_assert_eq!(String::from_utf8(sent).unwrap(), written(&steps));
    }

    /// Whatever the line brings: nothing breaks, and after a stop nothing is sent.
    #[test]
    fn nothing_is_sent_after_a_stop(
        steps in prop::collection::vec(any_step(), 1..20),
        noise in prop::collection::vec(any::<u8>(), 0..300),
        stop_s in 0_u64..100,
    ) {
        let mut timed = Timed::new(Settings::default());
        timed.pass(timed.settings.boot());
        timed.arm(&run_of(steps.len())).unwrap();
        let steps = (1..).zip(&steps).map(|(n, step)| NumberedStep { n, step: *step }).collect();
        timed.send(&Batch { steps, last: true }).unwrap();
        let stop = timed.settings.boot() + Duration::from_secs(stop_s);
        timed.receive(&noise, stop);
        timed.pass(stop);
        timed.stop();
        timed.take_output();
        for second in 1..1000 {
            timed.pass(stop + Duration::from_secs(second));
            prop_assert!(timed.take_output().is_empty());
        }
        let events: Vec<Event> = std::iter::from_fn(|| timed.next_event()).collect();
        prop_assert_eq!(events.last(), Some(&Event::Stopped { homed: false }));
    }
}
