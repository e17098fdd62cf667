//! From one wire of a job to what a session and a simulated machine are given.

use std::time::Duration;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::compensate::CompensatedProgram;
use wirebend_core::estimate::StepSeconds;
use wirebend_driver_host::api::{self, Bench, BenchBender, BenchWire};
use wirebend_driver_host::jobs::{PauseAfter, StepTime, WireJob};
use wirebend_driver_host::{HostError, OpenDriver};
use wirebend_files::document::{Job, JobPause, JobWire};
use wirebend_profile::{BendFigures, MachineProfile, MaterialProfile, Resolved};

use crate::machine::{Setup, told_steps};
use crate::signs::Signs;
use crate::{DriverProblem, Installation, PlanningError};

/// The machine's driver with the settings of its profile.
pub fn opened(app: &Installation, profile: &MachineProfile) -> Result<OpenDriver, PlanningError> {
    let driver = app.driver(profile.driver.id.as_deref().unwrap_or_default())?;
    let settings = profile.driver.settings.clone().unwrap_or_default();
    let open = driver.open(&serde_json::Value::Object(settings)).map_err(|error| match error {
        HostError::Refused { driver, error } => DriverProblem::Settings { driver, error },
        other => DriverProblem::Host(other),
    })?;
    Ok(open)
}

/// The bender and the wire of a simulated machine where they are others than those that the wire was planned for, so
/// that they differ from what the profiles say as those of a real machine do.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SimulatedAs {
    /// Id of the machine whose bend head it has; absent, that of the job.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub machine: Option<String>,
    /// Id of the material of the wire that it bends; absent, that of the job.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub material: Option<String>,
}

impl SimulatedAs {
    /// Whether nothing is other than in the job.
    #[must_use]
    pub const fn is_as_planned(&self) -> bool {
        self.machine.is_none() && self.material.is_none()
    }

    /// What the simulated machine is told.
    pub fn bench(&self, app: &Installation, planned: &Setup) -> Result<Bench, PlanningError> {
        let machine = self.machine.as_deref().map(|id| app.library.machine(id)).transpose()?;
        let material = self.material.as_deref().map(|id| app.library.material(id)).transpose()?;
        let machine = machine.as_ref().unwrap_or(&planned.machine);
        let bench = bench(machine, material.as_ref().unwrap_or(&planned.material), planned.signs)?;
        bench.ok_or_else(|| PlanningError::NoBender { machine: machine.profile.id.clone() })
    }
}

/// One wire of a job, for the loop that runs it.
pub fn work(setup: &Setup, job: &Job, name: &str, index: usize) -> Result<WireJob, PlanningError> {
    let damaged =
        |reason: &str| PlanningError::DamagedJob { name: name.to_owned(), reason: reason.to_owned() };
    let wire = job.contents().wires.get(index).ok_or_else(|| damaged("it has not so many wires"))?;
    let compensated = told_steps(&wire.compensated)?;
    let steps = setup.signs.machine_steps(&compensated, &setup.model.compensation);
    let run = api::Run {
        job_hash: job.hash().to_owned(),
        design_hash: job.contents().design_hash.clone(),
        name: name.to_owned(),
        machine: setup.machine_id().to_owned(),
        stock_mm: Some(wire.stock_mm),
        wire: index,
        steps: u32::try_from(steps.len()).map_err(|_| damaged("it has too many steps"))?,
        bench: bench(&setup.machine, &setup.material, setup.signs)?.map(Box::new),
        ..api::Run::default()
    };
    let pause = |JobPause { after, note }: &JobPause| PauseAfter { after: *after, note: note.clone() };
    let pauses = wire.pauses.iter().map(pause).collect();
    let head_play_deg = setup.model.compensation.motion.rotate_backlash.deg();
    let ends = [setup.model.head.min, setup.model.head.max].map(|end| setup.signs.head(end.deg()));
    let head_range_deg = [ends[0].min(ends[1]), ends[0].max(ends[1])];
    Ok(WireJob { run, steps, estimates: estimates(setup, wire)?, head_play_deg, head_range_deg, pauses })
}

/// How long each step takes by the machine's time model.
fn estimates(setup: &Setup, wire: &JobWire) -> Result<Vec<StepTime>, PlanningError> {
    let steps = told_steps(&wire.compensated)?;
    let program = CompensatedProgram::from_job_steps(steps, &setup.model.compensation);
    let each = setup.model.time.each_step(&program);
    let seconds = |seconds: f64| Duration::try_from_secs_f64(seconds).unwrap_or_default();
    Ok(each
        .map(|StepSeconds { feed, rotate, bend, wait }| StepTime {
            feed: seconds(feed),
            rotate: seconds(rotate),
            bend: seconds(bend + wait),
        })
        .collect())
}

/// What a simulated machine has to know; `None` for a machine without a pin and a peg that go about the wire.
fn bench(
    machine: &Resolved<MachineProfile>,
    material: &Resolved<MaterialProfile>,
    signs: Signs,
) -> Result<Option<Bench>, PlanningError> {
    let (machine, wire) = (machine.figures()?, material.figures()?);
    let BendFigures::Peg { rod_radius_mm, orbit_radius_mm, orbit_offset_mm, axis_limit_deg, .. } =
        machine.bend
    else {
        return Ok(None);
    };
    let pin_radius_mm = machine.pin_radius_mm;
    Ok(Some(Bench {
        bender: BenchBender {
            pin_radius_mm,
            rod_radius_mm,
            orbit_radius_mm,
            orbit_offset_mm,
            axis_limit_deg,
            feed_scale: machine.feed_scale,
            rotate_offset_deg: signs.head(machine.rotate_offset_deg),
            rotate_backlash_deg: machine.rotate_backlash_deg,
        },
        wire: BenchWire {
            diameter_mm: wire.diameter_mm,
            k_factor: wire.k_factor,
            youngs_modulus_gpa: wire.youngs_modulus_gpa,
            yield_strength_mpa: wire.yield_strength_mpa,
            ultimate_strength_mpa: wire.ultimate_strength_mpa,
        },
        noise: None,
    }))
}
