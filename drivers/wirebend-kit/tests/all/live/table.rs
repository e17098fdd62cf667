//! A simulated machine on a table, and what a program does with it.

use std::time::{Duration, Instant};

use serde_json::Value;
use wirebend_driver_api::{
    Batch, Bench, BenchBender, BenchWire, DriverError, Event, MachineDriver, MachineSession, Motion,
    NumberedStep, Run, Step,
};
use wirebend_driver_wirebend_kit::WirebendKit;

/// More looks than any wire here takes.
const LOOKS: usize = 100_000;

pub struct Table {
    pub session: Box<dyn MachineSession>,
    pub seen: Vec<Event>,
    /// A stop leaves the wire as it is, and the peg in it.
    pub stopped: bool,
    /// Between two looks at it.
    pub rarely: Duration,
    /// Of its head, degrees.
    pub backlash_deg: f64,
}

impl Table {
    pub fn new(settings: Value) -> Self {
        Self::at("sim:max", settings)
    }

    pub fn at(port: &str, settings: Value) -> Self {
        let driver = WirebendKit::open(serde_json::from_value(settings).unwrap()).unwrap();
        let session = driver.connect(port, None).unwrap();
        Self { session, seen: Vec::new(), stopped: false, rarely: Duration::ZERO, backlash_deg: 0.0 }
    }

    /// The next event of this kind.
    pub fn until(&mut self, mut wanted: impl FnMut(&Event) -> bool) -> Event {
        for _ in 0..LOOKS {
            let looked = Instant::now();
            while looked.elapsed() < self.rarely {
                std::thread::yield_now();
            }
            let Some(event) = self.session.poll().unwrap() else { continue };
            self.seen.push(event.clone());
            if wanted(&event) {
                return event;
            }
            let wrong = matches!(event, Event::Fault { .. } | Event::Warning(_)) && !self.stopped;
            assert!(!wrong, "{event:?}");
        }
        panic!("nothing of the kind: {:?}", self.seen);
    }

    pub fn connected(&mut self) -> Event {
        self.until(|event| matches!(event, Event::Connected { .. }))
    }

    pub fn home(&mut self) {
        self.session.home().unwrap();
        self.until(|event| *event == Event::Homed);
    }

    pub fn arm(&mut self, after: u32, steps: u32, rotate_at_deg: f64) -> String {
        let bench = Bench {
            // The published machine and its wire.
            bender: BenchBender {
                pin_radius_mm: 1.5,
                rod_radius_mm: 3.175,
                orbit_radius_mm: 20.4,
                orbit_offset_mm: 12.0,
                axis_limit_deg: 155.0,
                feed_scale: 1.0,
                rotate_offset_deg: 0.0,
                rotate_backlash_deg: self.backlash_deg,
            },
            wire: BenchWire {
                diameter_mm: 3.0,
                k_factor: 0.3,
                youngs_modulus_gpa: 68.03,
                yield_strength_mpa: 268.47,
                ultimate_strength_mpa: 362.14,
            },
            noise: None,
        };
        let run = Run { steps, after, rotate_at_deg, bench: Some(Box::new(bench)), ..Run::default() };
        self.session.arm(&run).unwrap().token.unwrap()
    }

    /// All steps of a wire, as they are taken.
    pub fn send(&mut self, steps: &[Step]) {
        self.send_part(steps, true);
    }

    /// The first steps of a wire; `last`: there are no others.
    pub fn send_part(&mut self, steps: &[Step], last: bool) {
        let numbered: Vec<NumberedStep> =
            (1..).zip(steps).map(|(n, &step)| NumberedStep { n, step }).collect();
        let mut taken = 0;
        for _ in 0..LOOKS {
            let batch = Batch { steps: numbered[taken as usize..].to_vec(), last };
            taken = self.session.send(&batch).unwrap().accepted;
            if taken as usize == steps.len() {
                return;
            }
            if let Some(event) = self.session.poll().unwrap() {
                self.seen.push(event);
            }
        }
        panic!("not taken: {:?}", self.seen);
    }

    /// A wire: its corners as they came out.
    pub fn make(&mut self, steps: &[Step]) -> Vec<[f64; 3]> {
        self.arm(0, u32::try_from(steps.len()).unwrap(), 0.0);
        self.send(steps);
        let made = self.until(|event| matches!(event, Event::Made { .. }));
        self.until(|event| *event == Event::Finished);
        let Event::Made { corners_mm, .. } = made else { unreachable!() };
        corners_mm
    }

    pub fn jog(&mut self, motion: Motion) {
        self.session.jog(motion).unwrap();
        self.until(|event| *event == Event::Jogged);
    }

    /// Where it stands, when it is next reported.
    pub fn position(&mut self) -> Step {
        for _ in 0..LOOKS {
            match self.session.poll().unwrap() {
                Some(event) => self.seen.push(event),
                None => break,
            }
        }
        let last = self.seen.iter().rev().find_map(|event| match event {
            Event::Position(step) => Some(*step),
            _ => None,
        });
        last.unwrap()
    }

    /// Why a step is not taken.
    pub fn refused(&mut self, step: Step) -> DriverError {
        let batch = Batch { steps: vec![NumberedStep { n: 1, step }], last: true };
        for _ in 0..LOOKS {
            match self.session.send(&batch) {
                Err(error) => return error,
                Ok(sent) => assert_eq!(sent.accepted, 0),
            }
            self.session.poll().unwrap();
        }
        panic!("never refused");
    }
}
