//! The simulated machine: the firmware's own core, the switch, and a wire.

use std::io;
use std::time::{Duration, Instant};

use wirebend_driver_api::{Axis, Bench as BenchFigures, BenchBender, BenchWire, DriverError, Event, Spread};

use super::transport::Transport;
use crate::bench::{Bench, BenchError, Bender, Compliance, Drives, ErrorTerm, Noise, Peg, Scale, Wire};
use crate::controller::{Controller, HZ, Observation, Observed};
use crate::link::{Link, MachineEvent, Request};
use crate::protocol::{Machine, Reset};
use crate::settings::{Settings, expected};

/// The machine of which build.rs compiles the first settings.
pub(super) const FIRMWARE_MACHINE: u32 = Machine::WirebendKit as u32;

/// How fast its clock runs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum SimulationSpeed {
    /// A multiple of real time.
    Times(f64),
    /// As fast as the computer allows.
    Unlimited,
}

/// The most time that one read lets pass: frames go both ways in between, at any speed and however rarely it is polled.
const SLICE: Duration = Duration::from_millis(1);
/// A busy computer falls behind the clock; more than this is not made up for.
const MAX_BEHIND: Duration = Duration::from_millis(200);
/// Where the bend axis stands when the power comes on: anywhere, but not at zero.
const BEND_AT_DEG: f64 = -30.0;
/// How far the bend axis may press its switch, degrees.
const BEYOND_SWITCH_DEG: f64 = 2.0;
/// How far the drawn wire may be from its arcs, mm.
const CENTRELINE_TOLERANCE_MM: f64 = 0.05;

pub(super) struct Simulated {
    controller: Controller,
    pace: SimulationSpeed,
    /// When its time was `now`, by the clock; it is behind the clock where it could not be computed as fast.
    seen_at: Instant,
    now: Duration,
    sent: Vec<u8>,
    scale: Scale,
    /// Where the bend axis really is, and the edge of its switch, steps.
    bend: i64,
    switch_at: i64,
    switch_deg: f64,
    switch_closes: bool,
    inverted: [bool; 3],
    peg_out_us: u16,
    bench: Option<Bench>,
    told: usize,
}

impl Transport for Simulated {
    fn now(&self) -> Duration {
        self.now
    }

    fn read(&mut self) -> io::Result<Vec<u8>> {
        self.now += match self.pace {
            SimulationSpeed::Times(times) => {
                let behind = self.seen_at.elapsed();
                let passed = behind.min(MAX_BEHIND);
                let slice = passed.mul_f64(times).min(SLICE);
                self.seen_at += behind.saturating_sub(passed) + slice.div_f64(times);
                slice
            }
            SimulationSpeed::Unlimited => SLICE,
        };
        let until = cycles(self.now);
        while let Some(seen) = self.controller.run(until) {
            self.saw(seen);
        }
        Ok(std::mem::take(&mut self.sent))
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.controller.send(bytes);
        Ok(())
    }

    fn has_more(&self) -> bool {
        match self.pace {
            SimulationSpeed::Times(times) => self.seen_at.elapsed().mul_f64(times) >= SLICE,
            SimulationSpeed::Unlimited => true,
        }
    }

    fn load(&mut self, figures: Option<&BenchFigures>) -> Result<(), DriverError> {
        self.told = 0;
        self.bench =
            figures.map(|figures| self.bench(figures)).transpose().map_err(|error| refusal(&error))?;
        Ok(())
    }

    fn warnings(&mut self) -> Vec<DriverError> {
        let Some(bench) = &self.bench else { return Vec::new() };
        let new = &bench.incidents()[self.told..];
        self.told += new.len();
        let help = "look at the settings of the machine's profile: a real one would be damaged";
        new.iter().map(|incident| DriverError::new("mishap", incident.to_string(), help)).collect()
    }

    fn made(&mut self) -> Option<Event> {
        let made = self.bench.take()?.made();
        Some(Event::Made { wire_mm: made.centreline(CENTRELINE_TOLERANCE_MM), corners_mm: made.corners() })
    }
}

fn refusal(error: &BenchError) -> DriverError {
    let help = "correct the bender's dimensions or the material in their profiles";
    DriverError::new("bench", format!("no wire can be simulated: {error}"), help)
}

fn cycles(time: Duration) -> u64 {
    u64::try_from(time.as_nanos() * u128::from(HZ) / 1_000_000_000).unwrap_or(u64::MAX)
}

impl Simulated {
    /// A machine that was flashed and set up as the profile says, and has just been given power.
    pub fn new(pace: SimulationSpeed, settings: &Settings) -> Result<Self, DriverError> {
        let memory =
            || DriverError::new("memory", "there is no memory for a simulated machine", "close something");
        let mut controller = Controller::new().ok_or_else(memory)?;
        let values = expected(settings);
        set_up(&mut controller, &values);
        let scale = Scale {
            feed_mm_per_step: 1.0 / settings.feed_steps_per_mm,
            rotate_deg_per_step: 360.0 / f64::from(settings.rotate_steps_per_turn),
            bend_deg_per_step: 360.0 / f64::from(settings.bend_steps_per_turn),
        };
        let steps = |deg: f64| i64::from(crate::settings::steps(deg / scale.bend_deg_per_step));
        let mut machine = Self {
            controller,
            pace,
            seen_at: Instant::now(),
            now: Duration::ZERO,
            sent: Vec::new(),
            scale,
            bend: steps(BEND_AT_DEG),
            switch_at: steps(settings.home_position_deg),
            switch_deg: settings.home_position_deg.abs(),
            switch_closes: settings.switch_closes,
            inverted: [settings.feed_inverted, settings.rotate_inverted, settings.bend_inverted],
            peg_out_us: u16::try_from(settings.peg_out_us).unwrap_or(u16::MAX),
            bench: None,
            told: 0,
        };
        // What was done to set it up took no time of the machine that a person sees.
        machine.controller.restart_clock();
        machine.move_switch();
        machine.controller.reset(Reset::PowerOn);
        Ok(machine)
    }

    fn bench(&self, figures: &BenchFigures) -> Result<Bench, BenchError> {
        let BenchBender {
            pin_radius_mm,
            rod_radius_mm,
            orbit_radius_mm,
            orbit_offset_mm,
            feed_scale,
            rotate_offset_deg,
            rotate_backlash_deg,
            ..
        } = figures.bender;
        // Bends are kept within their limit by the firmware; the axis itself goes to its switch and a little on.
        let axis_limit_deg = self.switch_deg + BEYOND_SWITCH_DEG;
        let bender =
            Bender { pin_radius_mm, rod_radius_mm, orbit_radius_mm, orbit_offset_mm, axis_limit_deg };
        let BenchWire {
            diameter_mm,
            k_factor,
            youngs_modulus_gpa,
            yield_strength_mpa,
            ultimate_strength_mpa,
        } = figures.wire;
        let wire = Wire {
            diameter_mm,
            k_factor,
            youngs_modulus_gpa,
            yield_strength_mpa,
            ultimate_strength_mpa,
            strain_at_ultimate: Wire::STRAIN_AT_ULTIMATE,
        };
        let axis_deg = f64::from(i32::try_from(self.bend).unwrap_or(0)) * self.scale.bend_deg_per_step;
        let bench = Bench::new(bender, wire, self.scale, Compliance::published()?)?
            .with_drives(Drives { feed_scale, rotate_offset_deg, rotate_backlash_deg })?
            .with_bend_axis_at(axis_deg)?;
        let term = |spread: Spread| ErrorTerm { bias: spread.bias, sigma: spread.sigma };
        match &figures.noise {
            None => Ok(bench),
            Some(noise) => bench.with_noise(&Noise {
                seed: noise.seed,
                feed_mm: term(noise.feed_mm),
                rotate_deg: term(noise.rotate_deg),
                bend_deg: term(noise.bend_deg),
            }),
        }
    }

    fn move_switch(&mut self) {
        let pressed =
            if self.switch_at < 0 { self.bend <= self.switch_at } else { self.bend >= self.switch_at };
        self.controller.set_switch(pressed != self.switch_closes);
    }

    fn saw(&mut self, seen: Observation) {
        match seen.what {
            Observed::Pulse { axis, forward } => {
                let forward = forward != self.inverted[index(axis)];
                if axis == Axis::Bend {
                    self.bend += if forward { 1 } else { -1 };
                    self.move_switch();
                }
                if let Some(bench) = &mut self.bench {
                    bench.step(axis, forward);
                }
            }
            Observed::Peg { width_us } => {
                if let Some(bench) = &mut self.bench {
                    bench.peg(if width_us == self.peg_out_us { Peg::Out } else { Peg::In });
                }
            }
            Observed::Sent(byte) => self.sent.push(byte),
            Observed::MotorsOn | Observed::MotorsOff => {}
        }
    }
}

const fn index(axis: Axis) -> usize {
    match axis {
        Axis::Feed => 0,
        Axis::Rotate => 1,
        Axis::Bend => 2,
    }
}

/// Stores settings as a person would: over the line.
fn set_up(controller: &mut Controller, values: &[i32]) {
    let mut link = Link::new(1, None, Duration::from_millis(100), Duration::ZERO);
    link.request(Request::LoadDefaults);
    // In a second round those are taken that depend on one another.
    for _ in 0..2 {
        for (id, &value) in (1_u8..).zip(values) {
            link.request(Request::Write(id, value));
        }
    }
    let mut now = Duration::ZERO;
    while !link.is_answered() && now < Duration::from_secs(30) {
        now += SLICE;
        controller.send(&link.take_bytes());
        let mut sent = Vec::new();
        while let Some(seen) = controller.run(cycles(now)) {
            sent.extend(if let Observed::Sent(byte) = seen.what { Some(byte) } else { None });
        }
        link.advance(&sent, now);
        let _: Vec<MachineEvent> = link.take_events();
    }
}
