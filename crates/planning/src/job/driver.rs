//! From what is exported or run to what a driver is given.

use nalgebra::Point3;
use wirebend_core::bend::{Step, straight_lengths};
use wirebend_core::compensate::ToldStep;
use wirebend_core::units::Length;
use wirebend_driver_host::api;

use crate::machine::Setup;

/// One wire, as the stages left it.
pub struct Stages<'a> {
    pub path: &'a [Point3<f64>],
    pub nominal: &'a [Step],
    pub compensated: Option<&'a [ToldStep]>,
    pub stock_mm: Option<f64>,
    pub time_s: Option<f64>,
}

/// A job for drivers, with the machine's steps in the machine's signs.
pub fn job<'a>(
    setup: &Setup,
    name: &str,
    job_hash: Option<String>,
    design_hash: &str,
    wires: impl Iterator<Item = Stages<'a>>,
) -> api::Job {
    let diameter_mm = setup.model.wire.diameter.mm();
    let (machine, material) = (setup.machine_id().to_owned(), setup.material_id().to_owned());
    api::Job {
        name: name.to_owned(),
        job_hash,
        design_hash: design_hash.to_owned(),
        machine: api::MachineRef { id: machine, name: setup.machine_name().to_owned() },
        material: api::MaterialRef { id: material, name: setup.material_name().to_owned(), diameter_mm },
        bend_radius_mm: setup.model.bend_radius.mm(),
        wires: wires.map(|stages| wire(setup, &stages)).collect(),
    }
}

fn wire(setup: &Setup, stages: &Stages) -> api::Wire {
    let straight = straight_lengths(stages.nominal, setup.model.bend_radius);
    let design = stages.nominal.iter().zip(straight).map(|(step, straight)| api::DesignStep {
        feed_mm: step.feed.mm(),
        rotate_deg: step.rotate.deg(),
        bend_deg: step.bend.deg(),
        straight_mm: straight.map(Length::mm),
    });
    let machine = |told: &[ToldStep]| setup.signs.machine_steps(told, &setup.model.compensation);
    api::Wire {
        path_mm: stages.path.iter().map(|point| [point.x, point.y, point.z]).collect(),
        design: design.collect(),
        machine: stages.compensated.map(machine),
        stock_mm: stages.stock_mm,
        time_s: stages.time_s,
    }
}
