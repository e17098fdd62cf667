//! What there is to choose from: machines, materials, errors of machines, and machines that build struts.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_profile::{BendFigures, Kind, Listing, MachineProfile, Profile as _, Resolved, Springback};

use crate::{Installation, PlanningError, Progress};

/// Asks for the machines.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
pub struct MachinesRequest {}

/// A machine to choose.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MachineEntry {
    pub id: String,
    pub name: String,
    /// Whether it comes with the program.
    pub shipped: bool,
    /// Its profile.
    pub file: String,
    /// The driver that runs it.
    pub driver: String,
    /// Whether it bends about a pin by a peg, so that a simulated machine can have its bend head.
    pub has_peg: bool,
    /// The noise profile that its errors are taken from, where its profile names one.
    pub noise: Option<String>,
    /// The formats that can be written for it, its default first.
    pub formats: Vec<String>,
    /// Its own format, where only its driver writes it.
    pub native: Option<String>,
    /// The material that is in it unless another is named.
    pub default_material: String,
    /// Largest bends to both sides, in degrees.
    pub bend_deg: [f64; 2],
    /// Shortest designed edge, in mm.
    pub min_edge_mm: f64,
    /// Thinnest and thickest wire, in mm.
    pub diameter_mm: [f64; 2],
    /// The calibration that made this version of a machine, and of the wire that it names; absent of what none has made.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub calibrated: Option<CalibratedVersion>,
}

/// A calibration that made a version of a machine and its wire.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct CalibratedVersion {
    /// The day of the measurement.
    pub date: String,
    /// How many readings it was from.
    pub readings: u32,
    /// The machine that it was made from.
    pub machine: String,
    /// The wire that it was made from.
    pub material: String,
}

#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct MachinesResponse {
    /// By id.
    pub machines: Vec<MachineEntry>,
}

/// Asks for the materials.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
pub struct MaterialsRequest {}

/// A material to choose.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MaterialEntry {
    pub id: String,
    pub name: String,
    /// Whether it comes with the program.
    pub shipped: bool,
    /// Its profile.
    pub file: String,
    pub diameter_mm: f64,
    /// Density, in kg/m³.
    pub density_kg_per_m3: f64,
    /// Price of a millimetre, in `currency`; null where it is not known.
    pub price_per_mm: Option<f64>,
    /// Of the price.
    pub currency: Option<String>,
    /// Depth of the neutral fibre, as a fraction of the diameter.
    pub k_factor: f64,
    /// Least and most that a bend loses when it is let go, degrees.
    pub springback_deg: [f64; 2],
    /// Whether its springback was measured.
    pub springback_measured: bool,
    /// Yield strength, `MPa`.
    pub yield_strength_mpa: f64,
}

#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct MaterialsResponse {
    /// By id.
    pub materials: Vec<MaterialEntry>,
}

pub fn machines(
    app: &Installation,
    _request: &MachinesRequest,
    _progress: &dyn Progress,
) -> Result<MachinesResponse, PlanningError> {
    let entry = |listing: Listing| {
        let machine = app.library.machine(&listing.id)?;
        let figures = machine.figures()?;
        let profile = &machine.profile;
        Ok(MachineEntry {
            driver: profile.driver.id.clone().unwrap_or_default(),
            noise: profile.error.as_ref().map(|noise| noise.value.clone()),
            has_peg: matches!(figures.bend, BendFigures::Peg { .. }),
            formats: profile.export.formats.clone().unwrap_or_default(),
            native: profile.export.native.clone(),
            default_material: profile.default_material.as_deref().cloned().unwrap_or_default(),
            bend_deg: [figures.limits.min_bend_deg, figures.limits.max_bend_deg],
            min_edge_mm: figures.limits.min_edge_mm,
            diameter_mm: [figures.min_diameter_mm, figures.max_diameter_mm],
            calibrated: calibrated(&machine),
            id: listing.id,
            name: listing.name,
            shipped: listing.shipped,
            file: listing.file,
        })
    };
    let concrete = app.library.machines().into_iter().filter(|listing| !listing.is_abstract);
    Ok(MachinesResponse { machines: concrete.map(entry).collect::<Result<_, PlanningError>>()? })
}

/// Of the profile itself: one that inherits from a calibrated machine is another machine.
fn calibrated(machine: &Resolved<MachineProfile>) -> Option<CalibratedVersion> {
    let calibrated = &machine.profile.calibrated;
    machine.origin("calibrated.date").filter(|origin| origin.id == machine.profile.id())?;
    Some(CalibratedVersion {
        date: calibrated.date.clone()?,
        readings: calibrated.readings?,
        machine: calibrated.machine.clone()?,
        material: calibrated.material.clone()?,
    })
}

pub fn materials(
    app: &Installation,
    _request: &MaterialsRequest,
    _progress: &dyn Progress,
) -> Result<MaterialsResponse, PlanningError> {
    let entry = |listing: Listing| {
        let figures = app.library.material(&listing.id)?.figures()?;
        let (losses, springback_measured): (Vec<f64>, bool) = match &figures.springback {
            Springback::Constant { angle_deg } => (vec![angle_deg.value], angle_deg.measured),
            Springback::Table { positive, negative, measured, .. } => {
                let all = positive.iter().chain(negative.iter().flatten());
                (all.map(|point| point.loss_deg).collect(), *measured)
            }
        };
        let springback_deg =
            losses.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], &loss| {
                [least.min(loss), most.max(loss)]
            });
        Ok(MaterialEntry {
            diameter_mm: figures.diameter_mm,
            density_kg_per_m3: figures.density_kg_per_m3,
            price_per_mm: figures.price_per_mm,
            currency: figures.currency,
            k_factor: figures.k_factor,
            springback_deg,
            springback_measured,
            yield_strength_mpa: figures.yield_strength_mpa,
            id: listing.id,
            name: listing.name,
            shipped: listing.shipped,
            file: listing.file,
        })
    };
    let concrete = app.library.materials().into_iter().filter(|listing| !listing.is_abstract);
    Ok(MaterialsResponse { materials: concrete.map(entry).collect::<Result<_, PlanningError>>()? })
}

/// A machine that builds struts, to choose.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct StrutBuilderEntry {
    pub id: String,
    pub name: String,
    /// What it builds with unless another material is named.
    pub default_material: Option<String>,
}

/// The errors of a machine, to choose.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct NoiseEntry {
    pub id: String,
    pub name: String,
}

/// The machines that build struts, by id.
pub fn strut_builders(app: &Installation) -> Result<Vec<StrutBuilderEntry>, PlanningError> {
    let concrete = app.library.strut_builders().into_iter().filter(|listing| !listing.is_abstract);
    let entry = |listing: Listing| {
        let default_material = app.library.strut_builder(&listing.id)?.profile.default_material;
        let default_material = default_material.map(|own| own.value);
        Ok(StrutBuilderEntry { id: listing.id, name: listing.name, default_material })
    };
    concrete.map(entry).collect()
}

/// The errors of machines, by id.
pub fn noises(app: &Installation) -> Vec<NoiseEntry> {
    let concrete = app.library.list(Kind::Noise).into_iter().filter(|listing| !listing.is_abstract);
    concrete.map(|listing| NoiseEntry { id: listing.id, name: listing.name }).collect()
}
