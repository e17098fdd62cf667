//! From profiles to what the stages ask about.

use serde_json::{Map, Value};
use wirebend_core::bend::Step;
use wirebend_core::checks::{BendRadius, BendTorque, MachineLimits, Source, Sourced};
use wirebend_core::compensate::{
    BendModel, Compensation, FeedModel, MotionModel, PegGeometry, Springback, SpringbackCurve,
    SpringbackPoint, ToldStep,
};
use wirebend_core::estimate::{TimeModel, WireModel};
use wirebend_core::plan::Machine;
use wirebend_core::schedule::HeadLimits;
use wirebend_core::units::{Angle, Length, NotFinite};
use wirebend_files::document::{JobContents, JobStep, JobWire};
use wirebend_profile::{
    BendFigures, MachineFigures, MachineProfile, MaterialFigures, MaterialProfile, Profile, Resolved,
};

use crate::PlanningError;
use crate::bodies::{bodies, peg_length};
use crate::drivers::Told;
use crate::installation::Board;
use crate::report::NoteReport;
use crate::signs::Signs;

/// A machine with a wire in it, and the profiles that say so.
#[derive(Debug, Clone)]
pub struct Setup {
    pub machine: Resolved<MachineProfile>,
    pub material: Resolved<MaterialProfile>,
    pub model: Machine,
    pub signs: Signs,
    /// What the machine's driver said when it was asked for its limits, which `machine` has by now.
    pub driver: Told,
    pub currency: Option<String>,
    /// Energy that forming a gram of the wire takes, kJ, where its profile says so.
    pub process_energy_kj_per_g: Option<f64>,
}

impl crate::Installation {
    /// A machine and a material by id; without a material the one that the machine names.
    pub fn setup(&self, machine: &str, material: Option<&str>) -> Result<Setup, PlanningError> {
        let machine = self.library.machine(machine)?;
        let own = machine.profile.default_material.as_deref().map_or("", String::as_str);
        let material = self.library.material(material.unwrap_or(own))?;
        self.completed(machine, material)
    }

    /// The same for a check: with what the machine itself says where it is connected. A job does not know that, or it would
    /// be another one as soon as the machine is away.
    pub fn setup_connected(&self, setup: Setup) -> Result<Setup, PlanningError> {
        let Some(board) = self.boards.of(setup.machine_id()) else { return Ok(setup) };
        let mut setup = setup.at(&board)?;
        setup.driver.board = Some(board);
        Ok(setup)
    }

    /// The same with settings of the machine's driver over those of its profile.
    pub fn setup_with(&self, setup: Setup, settings: &Map<String, Value>) -> Result<Setup, PlanningError> {
        let mut machine = self.library.machine(setup.machine_id())?;
        machine.profile.driver.settings.get_or_insert_default().extend(settings.clone());
        self.completed(machine, setup.material)
    }

    /// A setup with what the machine's driver and the machine itself say.
    fn completed(
        &self,
        mut machine: Resolved<MachineProfile>,
        material: Resolved<MaterialProfile>,
    ) -> Result<Setup, PlanningError> {
        let driver = self.with_driver_limits(&mut machine);
        let mut setup = Setup { driver, ..Setup::new(machine, material)? };
        setup.model.scatter = self.scatter(&setup.machine.profile)?;
        Ok(setup)
    }

    /// How far bends scatter by the errors that the machine's profile names.
    fn scatter(&self, machine: &MachineProfile) -> Result<Option<Sourced<Angle>>, PlanningError> {
        let Some(id) = &machine.error else { return Ok(None) };
        let errors = self.library.noise(id)?;
        let Some(sigma) = &errors.profile.bend.sigma_deg else { return Ok(None) };
        let source = source(&errors, "bend.sigma_deg", Some(&sigma.source));
        Ok(Some(Sourced { value: deg(sigma.value)?, source }))
    }
}

impl Setup {
    /// Wire that the commands of a job's wire feed, mm.
    #[must_use]
    pub fn fed_mm(&self, wire: &JobWire) -> f64 {
        self.fed_in_mm(wire, wire.compensated.len())
    }

    /// The same of its first steps.
    #[must_use]
    pub fn fed_in_mm(&self, wire: &JobWire, steps: usize) -> f64 {
        let commanded = wire.compensated.iter().take(steps).map(|step| step.feed_mm).sum();
        self.model.compensation.motion.fed(Length::from_mm(commanded).unwrap_or_default()).mm()
    }

    /// A setup from resolved profiles, such as the snapshots in a job.
    pub fn new(
        machine: Resolved<MachineProfile>,
        material: Resolved<MaterialProfile>,
    ) -> Result<Self, PlanningError> {
        let figures = machine.figures()?;
        let wire = material.figures()?;
        let model = model(&machine, &figures, &material, &wire)?;
        let signs = Signs::of(&figures);
        let process_energy_kj_per_g = wire.process_energy_mj_per_kg;
        let (driver, currency) = (Told::default(), wire.currency);
        Ok(Self { machine, material, model, signs, driver, currency, process_energy_kj_per_g })
    }

    /// The same at a machine that is connected, with what that says of itself.
    pub fn at(&self, board: &Board) -> Result<Self, PlanningError> {
        let mut machine = self.machine.clone();
        board.limit(&mut machine);
        let mut setup = Self::new(machine, self.material.clone())?;
        setup.model.scatter.clone_from(&self.model.scatter);
        Ok(Self { driver: self.driver.clone(), ..setup })
    }

    pub fn machine_id(&self) -> &str {
        self.machine.profile.id()
    }

    pub fn material_id(&self) -> &str {
        self.material.profile.id()
    }

    /// The machine's name for people.
    pub fn machine_name(&self) -> &str {
        self.machine.profile.name.as_deref().unwrap_or(self.machine.profile.id())
    }

    /// The material's name for people.
    pub fn material_name(&self) -> &str {
        self.material.profile.name.as_deref().unwrap_or(self.material.profile.id())
    }
}

/// A profile that passed its rules holds finite numbers only; one from a damaged job may not.
fn not_finite(error: NotFinite) -> PlanningError {
    PlanningError::Value {
        input: None,
        name: "a figure of a profile",
        value: error.value.to_string(),
        expected: "a finite number",
    }
}

pub fn mm(value: f64) -> Result<Length, PlanningError> {
    Length::from_mm(value).map_err(not_finite)
}

pub fn deg(value: f64) -> Result<Angle, PlanningError> {
    Angle::from_deg(value).map_err(not_finite)
}

/// Where a figure of a profile comes from.
pub(crate) fn source<T: Profile>(profile: &Resolved<T>, key: &str, reason: Option<&str>) -> Source {
    let origin = profile.origin(key).map_or(profile.profile.id(), |origin| origin.id.as_str());
    Source { reason: reason.map(str::to_owned), entry: format!("{origin}, {key}") }
}

/// A figure of a profile, which a child may leave to its parent.
type Figure = Option<wirebend_profile::Sourced<f64>>;

fn model(
    machine: &Resolved<MachineProfile>,
    figures: &MachineFigures,
    material: &Resolved<MaterialProfile>,
    wire: &MaterialFigures,
) -> Result<Machine, PlanningError> {
    let limits = &figures.limits;
    let stated = &machine.profile.limits;
    let stated_source = |key: &str, figure: &Figure| {
        source(machine, key, figure.as_ref().map(|figure| figure.source.as_str()))
    };
    let length = |key: &str, figure: &Figure, value: f64| {
        Ok::<_, PlanningError>(Sourced { value: mm(value)?, source: stated_source(key, figure) })
    };
    let angle = |key: &str, figure: &Figure, value: f64| {
        Ok::<_, PlanningError>(Sourced { value: deg(value)?, source: stated_source(key, figure) })
    };
    let feed = limits.max_feed_mm.map(|feed| length("limits.max_feed_mm", &stated.max_feed_mm, feed));
    let stock = limits.max_stock_mm.map(|stock| length("limits.max_stock_mm", &stated.max_stock_mm, stock));
    let (thin, thick) = (&machine.profile.wire.min_diameter_mm, &machine.profile.wire.max_diameter_mm);
    let diameter = mm(wire.diameter_mm)?;
    let pin = mm(figures.pin_radius_mm)?;
    let pin_stated = machine.profile.bend.pin_radius_mm.as_ref();
    let pin_within = mm(pin_stated.and_then(|pin| pin.within_95).unwrap_or_default())?;
    Ok(Machine {
        limits: MachineLimits {
            min_bend: angle("limits.min_bend_deg", &stated.min_bend_deg, limits.min_bend_deg)?,
            max_bend: angle("limits.max_bend_deg", &stated.max_bend_deg, limits.max_bend_deg)?,
            min_edge: length("limits.min_edge_mm", &stated.min_edge_mm, limits.min_edge_mm)?,
            min_feed: length("limits.min_feed_mm", &stated.min_feed_mm, limits.min_feed_mm)?,
            max_feed: feed.transpose()?,
            max_stock: stock.transpose()?,
            tail: length("limits.tail_mm", &stated.tail_mm, limits.tail_mm)?,
            min_diameter: length("wire.min_diameter_mm", thin, figures.min_diameter_mm)?,
            max_diameter: length("wire.max_diameter_mm", thick, figures.max_diameter_mm)?,
            bend_torque: machine.profile.bend.torque_n_m.as_ref().map(|torque| {
                let source = stated_source("bend.torque_n_m", &machine.profile.bend.torque_n_m);
                let available = Sourced { value: torque.value, source };
                BendTorque::beside(available, diameter, wire.ultimate_strength_mpa)
            }),
            bend_radius: material.profile.min_bend_radius_diameters.as_ref().map(|least| {
                let source = source(material, "min_bend_radius_diameters", Some(least.source.as_str()));
                let least_diameters = Sourced { value: least.value, source };
                BendRadius { inner: pin, inner_within: pin_within, diameter, least_diameters }
            }),
            min_rotation_source: stated_source("limits.min_rotation_deg", &stated.min_rotation_deg),
            max_rotation_source: stated_source("limits.max_rotation_deg", &stated.max_rotation_deg),
            axis_source: stated_source("bend.axis_limit_deg", &machine.profile.bend.axis_limit_deg),
            head_not_measured: machine.profile.head_measured() == Some(false),
        },
        head: HeadLimits {
            min: deg(limits.min_rotation_deg)?,
            max: deg(limits.max_rotation_deg)?,
            seconds_per_degree: 1.0 / figures.rotate_rate_deg_per_s,
            seconds_per_turn: figures.fixed_per_turn_s,
        },
        compensation: Compensation {
            feed: figures.compensate_feed.then(|| FeedModel::new(pin, diameter, wire.k_factor)),
            bend: bend_model(machine, figures, material, wire)?,
            motion: MotionModel {
                feed_scale: figures.feed_scale,
                rotate_offset: deg(figures.rotate_offset_deg)?,
                rotate_backlash: deg(figures.rotate_backlash_deg)?,
            },
        },
        time: TimeModel {
            feed_mm_per_s: figures.feed_rate_mm_per_s,
            rotate_deg_per_s: figures.rotate_rate_deg_per_s,
            bend_deg_per_s: figures.bend_rate_deg_per_s,
            fixed_per_bend_s: figures.fixed_per_bend_s,
            fixed_per_feed_s: figures.fixed_per_feed_s,
            fixed_per_turn_s: figures.fixed_per_turn_s,
        },
        wire: WireModel {
            diameter,
            density_kg_per_m3: wire.density_kg_per_m3,
            youngs_modulus_gpa: wire.youngs_modulus_gpa,
            price_per_mm: wire.price_per_mm,
        },
        bend_radius: FeedModel::new(pin, diameter, wire.k_factor).bend_radius,
        straight: deg(figures.bend_resolution_deg / 2.0)?,
        bodies: bodies(
            machine.origin("shapes").map_or(machine.profile.id(), |origin| origin.id.as_str()),
            machine.profile.shapes.as_deref().unwrap_or_default(),
            figures,
            wire.diameter_mm,
        ),
        scatter: None, // from another profile: filled in by `Installation::setup`
    })
}

fn bend_model(
    machine: &Resolved<MachineProfile>,
    figures: &MachineFigures,
    material: &Resolved<MaterialProfile>,
    wire: &MaterialFigures,
) -> Result<BendModel, PlanningError> {
    let (axis_limit, before_zero, peg) = match figures.bend {
        BendFigures::Direct { axis_limit_deg } => (axis_limit_deg, false, None),
        BendFigures::Peg { rod_radius_mm, orbit_radius_mm, orbit_offset_mm, axis_limit_deg, before_zero } => {
            let half = wire.diameter_mm / 2.0;
            let peg = PegGeometry::new(
                mm(orbit_radius_mm)?,
                mm(orbit_offset_mm)?,
                mm(figures.pin_radius_mm + half)?,
                mm(rod_radius_mm + half)?,
            );
            let wrong = |error| PlanningError::Geometry { machine: machine.profile.id().to_owned(), error };
            let peg = peg.map_err(wrong)?;
            let length = peg_length(machine.profile.shapes.as_deref().unwrap_or_default());
            (
                Some(axis_limit_deg),
                before_zero,
                Some(length.map_or(peg, |length| peg.with_peg_length(length))),
            )
        }
    };
    let springback = figures
        .compensate_springback
        .then(|| springback(material.profile.id(), &wire.springback))
        .transpose()?;
    Ok(BendModel {
        springback,
        setback: peg.filter(|_| figures.compensate_setback),
        axis_limit: axis_limit.map(deg).transpose()?,
        before_zero,
    })
}

pub fn springback(
    material: &str,
    stated: &wirebend_profile::Springback,
) -> Result<Springback, PlanningError> {
    let curve = |pairs: &[wirebend_profile::LossPoint]| {
        let points: Vec<SpringbackPoint> = pairs
            .iter()
            .map(|pair| Ok(SpringbackPoint { formed: deg(pair.angle_deg)?, loss: deg(pair.loss_deg)? }))
            .collect::<Result<_, PlanningError>>()?;
        SpringbackCurve::new(&points)
            .map_err(|error| PlanningError::Springback { material: material.to_owned(), error })
    };
    Ok(match stated {
        wirebend_profile::Springback::Constant { angle_deg } => Springback::Constant(deg(angle_deg.value)?),
        wirebend_profile::Springback::Table { positive, negative, .. } => Springback::Table {
            positive: curve(positive)?,
            negative: curve(negative.as_deref().unwrap_or(positive))?,
        },
    })
}

/// The setup that a job was planned for, from its own snapshots.
pub fn restored(name: &str, job: &JobContents) -> Result<Setup, PlanningError> {
    let damaged = |snapshot: &'static str| {
        let name = name.to_owned();
        move |error: serde_json::Error| PlanningError::DamagedJob {
            name,
            reason: format!("its {snapshot}: {error}"),
        }
    };
    let machine = serde_json::from_value(job.machine.snapshot.clone()).map_err(damaged("machine"))?;
    let material = serde_json::from_value(job.material.snapshot.clone()).map_err(damaged("material"))?;
    Setup::new(machine, material)
}

/// The steps that a job has kept.
pub fn kept_steps(steps: &[JobStep]) -> Result<Vec<Step>, PlanningError> {
    steps.iter().map(|&step| Step::try_from(step).map_err(not_finite)).collect()
}

/// The same of what a machine is told.
pub fn told_steps(steps: &[JobStep]) -> Result<Vec<ToldStep>, PlanningError> {
    steps.iter().map(|&step| ToldStep::try_from(step).map_err(not_finite)).collect()
}

/// The errors of the checks despite which a job was planned.
pub fn accepted_errors(job: &JobContents) -> Vec<NoteReport> {
    let note = |error: &String| NoteReport {
        code: "objection".into(),
        count: 1,
        message: planned_despite(error),
        remedies: Vec::new(),
    };
    job.objections.iter().map(note).collect()
}

/// Names an error that a user has accepted.
#[must_use]
pub fn planned_despite(error: &str) -> String {
    format!("the job was planned despite an error: {error}")
}
