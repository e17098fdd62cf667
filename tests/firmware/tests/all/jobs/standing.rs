//! Where the axes stand when a step is ended in its middle: what the driver reports against the pulses on the pins.

use std::time::Instant;

use serde_json::{Value, json};
use wirebend_driver_api::{
    Axis, Batch, Event, MachineDriver, MachineSession, NumberedStep, PausedBy, Run, Step,
};
use wirebend_driver_wirebend_kit::WirebendKit;
use wirebend_tests_firmware::board::{Avr, Board, MS, Reset};

use crate::jobs::at_port::AtPort;
use crate::jobs::bender::{Bender, net};
use crate::jobs::interrupted::{GEARS, Job, coarse};
use crate::jobs::shop::{DEADLINE, shared};

/// Half a step of the feed's motor, mm, and of the head's, degrees, which is the longer one of the two that turn.
const HALF_A_STEP: f64 = 0.5 / GEARS.feed_steps_per_mm;
const HALF_A_TURN_STEP: f64 = 0.11;

/// A step that takes seconds on each axis; bends to the negative side.
const STEP: Step = Step { feed_mm: 400.0, rotate_deg: 200.0, bend_deg: -120.0, approach_deg: None };

/// A homed machine that bends a wire of this step, connected by the driver.
struct Making {
    at: AtPort<Avr>,
    session: Box<dyn MachineSession>,
    told: Vec<Event>,
    /// Pulses of the bend axis up to its zero.
    zero: i64,
}

impl Making {
    fn new() -> Self {
        Self::with(coarse()["driver"]["settings"].clone())
    }

    /// The same with other settings than those that the board has.
    fn with(settings: Value) -> Self {
        let at = AtPort::<Avr>::new(GEARS, Some(&Job::cube().stored), true);
        at.with(|bender| bender.board.set_inputs(false, false));
        let settings = serde_json::from_value(settings).unwrap();
        let session = WirebendKit::open(settings).unwrap().connect(&at.port, None).unwrap();
        let mut making = Self { at, session, told: Vec::new(), zero: 0 };
        making.until(|event| matches!(event, Event::Connected { .. }));
        making.session.write_settings().unwrap();
        making.until(|event| matches!(event, Event::SettingsWritten { settings, .. } if settings.is_empty()));
        making.session.home().unwrap();
        making.until(|event| *event == Event::Homed);
        making.zero = making.at.with(|bender| net(bender.pulses.all(), Axis::Bend));
        making.session.arm(&Run { steps: 2, ..Run::default() }).unwrap();
        let back = Step { rotate_deg: -STEP.rotate_deg, ..STEP };
        let steps = [(1, STEP), (2, back)].map(|(n, step)| NumberedStep { n, step });
        let begun = Instant::now();
        while making.session.send(&Batch { steps: steps.to_vec(), last: true }).unwrap().accepted < 2 {
            assert!(begun.elapsed() < DEADLINE);
            making.session.poll().unwrap();
        }
        making
    }

    fn until(&mut self, mut wanted: impl FnMut(&Event) -> bool) {
        let begun = Instant::now();
        loop {
            assert!(begun.elapsed() < DEADLINE, "{:?}", self.told.last());
            let Some(event) = self.session.poll().unwrap() else { continue };
            self.told.push(event.clone());
            if wanted(&event) {
                return;
            }
        }
    }

    /// Until this axis has done so many steps of the job, in its own direction.
    fn underway(&mut self, axis: Axis, steps: i64) {
        let begun = Instant::now();
        let zero = self.zero;
        let reached = move |bender: &mut Bender<Avr>| {
            let from = if axis == Axis::Bend { zero } else { 0 };
            (net(bender.pulses.all(), axis) - from).abs() >= steps
        };
        while !self.at.with(reached) {
            assert!(begun.elapsed() < DEADLINE);
            if let Some(event) = self.session.poll().unwrap() {
                self.told.push(event);
            }
        }
    }

    /// What the pins have done, in the units of the program.
    fn counted(&self) -> Step {
        let zero = self.zero;
        let [feed, rotate, bend] = self.at.with(move |bender| {
            let all = bender.pulses.all();
            [net(all, Axis::Feed), net(all, Axis::Rotate), net(all, Axis::Bend) - zero]
                .map(|steps| f64::from(i32::try_from(steps).unwrap()))
        });
        Step {
            feed_mm: feed / GEARS.feed_steps_per_mm,
            rotate_deg: rotate * 360.0 / f64::from(GEARS.rotate_steps_per_turn),
            bend_deg: bend * 360.0 / f64::from(GEARS.bend_steps_per_turn),
            approach_deg: None,
        }
    }

    /// The last that was reported of where the axes stand, before the event that ended it.
    fn told(&self) -> Option<Step> {
        let before = self.told.iter().rev().skip(1).take_while(|event| !matches!(event, Event::Done { .. }));
        before.clone().find_map(|event| match event {
            Event::Position(step) => Some(*step),
            _ => None,
        })
    }

    /// What was reported of the step that was ended in its middle.
    fn part(&self) -> Option<(u32, Option<Step>, bool)> {
        let parts = self.told.iter().filter_map(|event| match event {
            Event::PartMade { step, made, exact } => Some((*step, *made, *exact)),
            _ => None,
        });
        let parts: Vec<_> = parts.collect();
        assert!(parts.len() < 2, "{parts:?}");
        parts.first().copied()
    }

    /// The part of the first step that was reported against the pins.
    #[track_caller]
    fn part_is_counted(&self, what: &str) {
        let Some((1, Some(part), false)) = self.part() else { panic!("{what}: {:?}", self.part()) };
        let counted = self.counted();
        // Half a motor step: what the motors have done of their whole steps is reported of the step.
        let apart = |a: f64, b: f64, most: f64| (a - b).abs() < most;
        let same = apart(part.feed_mm, counted.feed_mm, HALF_A_STEP)
            && apart(part.rotate_deg, counted.rotate_deg, HALF_A_TURN_STEP)
            && apart(part.bend_deg, counted.bend_deg, HALF_A_TURN_STEP);
        assert!(same, "{what}: reported {part:?}, done {counted:?}");
    }

    #[track_caller]
    fn stands(&self, what: &str) {
        let (told, counted) = (self.told().expect("a position"), self.counted());
        // Half a step: both are whole numbers of steps.
        let apart = |a: f64, b: f64, step: f64| (a - b).abs() < step / 2.0;
        let feed = apart(told.feed_mm, counted.feed_mm, 1.0 / GEARS.feed_steps_per_mm);
        let rotate = apart(told.rotate_deg, counted.rotate_deg, 0.2);
        let bend = apart(told.bend_deg, counted.bend_deg, 0.16);
        assert!(feed && rotate && bend, "{what}: reported {told:?}, done {counted:?}");
    }
}

/// Steps into a step, on each axis: in its feed, in its rotation, in its swing past zero.
const MOMENTS: [(Axis, i64); 4] =
    [(Axis::Feed, 700), (Axis::Feed, 1501), (Axis::Rotate, 333), (Axis::Bend, 150)];

#[test]
fn a_stop_in_a_step_tells_how_far_each_axis_got() {
    let _others = shared();
    for (axis, steps) in MOMENTS {
        let mut making = Making::new();
        making.underway(axis, steps);
        making.session.stop().unwrap();
        making.until(|event| matches!(event, Event::Stopped { .. }));
        making.stands(&format!("STOP in {axis:?}"));
        making.part_is_counted(&format!("STOP in {axis:?}"));
        let told = making.told().unwrap();
        let whole = (told.feed_mm - STEP.feed_mm).abs() < 0.1 && told.rotate_deg.abs() > 199.0;
        assert!(!whole || axis == Axis::Bend, "{axis:?}: in the middle of it, {told:?}");
    }
}

#[test]
fn an_alarm_in_a_step_tells_how_far_each_axis_got() {
    let _others = shared();
    let mut making = Making::new();
    making.underway(Axis::Bend, 150);
    // The peg is out and swings to the other side: on its way back it meets a switch that reads pressed.
    making.at.with(Bender::break_switch);
    making.until(|event| matches!(event, Event::Fault { .. }));
    let Some(Event::Fault { error, in_doubt, .. }) = making.told.last() else { unreachable!() };
    assert_eq!((error.code.as_str(), *in_doubt), ("alarm", Some(1)), "{error}");
    making.stands("switch hit");
    // What has hit something may have lost steps.
    assert_eq!(making.part(), Some((1, None, false)));
}

/// Of a machine that holds every axis stands where it is counted.
#[test]
fn a_stop_at_rest_tells_exactly_how_far_the_step_is() {
    let _others = shared();
    let mut making = Making::new();
    making.underway(Axis::Feed, 700);
    making.session.pause().unwrap();
    making.until(|event| *event == Event::Paused { by: PausedBy::Program });
    making.session.stop().unwrap();
    making.until(|event| matches!(event, Event::Stopped { .. }));
    let Some((1, Some(part), true)) = making.part() else { panic!("{:?}", making.part()) };
    let counted = making.counted();
    assert!((part.feed_mm - counted.feed_mm).abs() < HALF_A_STEP, "reported {part:?}, done {counted:?}");
}

/// The head counts from where the wire begins, and the feed from where the step does.
#[test]
fn a_stop_in_a_later_step_tells_of_that_step_alone() {
    let _others = shared();
    let mut making = Making::new();
    making.until(|event| *event == Event::Done { n: 1 });
    // Not what the pins have done by now: of the second step some may be done before one hears of the first.
    let before = (STEP.feed_mm * GEARS.feed_steps_per_mm).round() / GEARS.feed_steps_per_mm;
    let begun = Instant::now();
    while making.counted().feed_mm < before + 50.0 {
        assert!(begun.elapsed() < DEADLINE);
        making.told.extend(making.session.poll().unwrap());
    }
    making.session.stop().unwrap();
    making.until(|event| matches!(event, Event::Stopped { .. }));
    let Some((2, Some(part), false)) = making.part() else { panic!("{:?}", making.part()) };
    let fed = making.counted().feed_mm - before;
    assert!((part.feed_mm - fed).abs() < HALF_A_STEP && part.rotate_deg == 0.0, "{part:?}, fed {fed}");
}

/// A controller that was reset counts from zero: nothing of where it stood is reported as if it knew.
#[test]
fn a_reset_in_a_step_tells_no_position() {
    let _others = shared();
    let mut making = Making::new();
    making.underway(Axis::Feed, 700);
    making.told.clear();
    making.at.with(|bender| bender.reset(Reset::External));
    making.until(|event| matches!(event, Event::Fault { .. }));
    let Some(Event::Fault { error, in_doubt, .. }) = making.told.last() else { unreachable!() };
    assert_eq!((error.code.as_str(), *in_doubt), ("restarted", Some(1)));
    if let Some(told) = making.told() {
        assert!(told.feed_mm > 0.0, "of before the reset: {told:?}");
    }
    let from = making.told.len();
    let end = making.at.with(|bender| bender.board.now()) + 1000 * MS;
    while making.at.with(|bender| bender.board.now()) < end {
        making.told.extend(making.session.poll().unwrap());
    }
    let after = making.told[from..].iter().filter(|event| matches!(event, Event::Position(_))).count();
    assert_eq!(making.part(), None, "it is not known how far it was");
    assert_eq!(after, 0, "a position that is not known");
}

/// Both inputs wired.
fn wired() -> Value {
    let mut settings = coarse()["driver"]["settings"].clone();
    settings["hold_input"] = json!(true);
    settings["emergency_input"] = json!(true);
    settings
}

/// To resume while it is open is refused and ends nothing.
#[test]
fn an_open_door_is_told_and_left_by_a_person() {
    let _others = shared();
    let mut making = Making::with(wired());
    making.underway(Axis::Feed, 700);
    making.at.with(|bender| bender.board.set_inputs(true, false));
    making.until(|event| *event == Event::Paused { by: PausedBy::Machine });
    making.session.resume().unwrap();
    making.told.clear();
    making.until(|event| matches!(event, Event::Warning(_) | Event::Fault { .. }));
    let Some(Event::Warning(warning)) = making.told.last() else { panic!("{:?}", making.told.last()) };
    assert_eq!(warning.code, "hold-input");
    making.at.with(|bender| bender.board.set_inputs(false, false));
    making.session.resume().unwrap();
    making.until(|event| *event == Event::Resumed);
    making.until(|event| *event == Event::Done { n: 1 });
    let steps = making.counted().feed_mm * GEARS.feed_steps_per_mm;
    let whole = STEP.feed_mm * GEARS.feed_steps_per_mm;
    assert!(steps > whole - 1.0, "{steps} steps of the first feed, not {whole}");
}

#[test]
fn after_an_emergency_stop_the_step_is_in_doubt() {
    let _others = shared();
    let mut making = Making::with(wired());
    making.underway(Axis::Rotate, 333);
    making.at.with(|bender| bender.board.set_inputs(false, true));
    making.until(|event| matches!(event, Event::Fault { .. }));
    let Some(Event::Fault { error, in_doubt, .. }) = making.told.last() else { unreachable!() };
    assert_eq!((error.code.as_str(), *in_doubt), ("alarm", Some(1)), "{error}");
    assert!(error.message.contains("emergency stop"), "{error}");
    assert!(!making.told.iter().any(|event| matches!(event, Event::Done { .. })));
    making.stands("emergency stop");
    // While it is pressed the machine does not home, and says why.
    making.session.home().unwrap();
    making.until(|event| matches!(event, Event::Fault { .. }));
    let Some(Event::Fault { error, .. }) = making.told.last() else { unreachable!() };
    assert!(error.help.contains("release the emergency stop"), "{error}");
    making.at.with(|bender| bender.board.set_inputs(false, false));
    making.session.home().unwrap();
    making.until(|event| *event == Event::Homed);
}
