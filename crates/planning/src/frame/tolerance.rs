//! `tolerance`: how good a machine must be for what is required of the closed frame.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_accuracy::{
    self, BowedStrut, Closing, Continuum, Effects, NoLimit, Requirement, Surface, Tolerance, Vary,
};
use wirebend_core::checks::{Diagnostic, check_crossings};
use wirebend_core::simulate::{ErrorModel, ErrorTerm};
use wirebend_core::units::Length;
use wirebend_error::InputName;

use super::closing::ClosingName;
use super::faces::FacesChoice;
use super::wires::Wires;
use crate::choices::PlanChoices;
use crate::design::{DesignInput, default_weld};
use crate::report::NoteReport;
use crate::{Installation, PlanningError, Progress, text};

/// What is required of a closed frame.
#[derive(Debug, Clone, Copy, PartialEq, Default, Deserialize, JsonSchema)]
pub struct RequirementsChoice {
    /// How far the faces may be off, RMS.
    pub surface_mm: Option<f64>,
    /// Force along a strut, RMS.
    pub force_n: Option<f64>,
    /// Von Mises stress, RMS.
    pub stress_mpa: Option<f64>,
}

/// Which motions are off.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Deserialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum VaryName {
    #[default]
    Feed,
    /// Bends and rotations, by the same.
    Angle,
    /// Feeds, bends and rotations.
    Both,
}

/// A tetrahedral truss of many rings, by closed formulas.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
pub struct ContinuumChoice {
    /// Rings around the middle triangle.
    pub rings: u32,
    pub depth_mm: f64,
    pub diameter_mm: f64,
    /// How far its struts bow, as a share of their length: that changes its frequency alone.
    #[serde(default)]
    #[schemars(range(min = 0.0, max = 0.5))]
    pub bow: f64,
}

#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ToleranceRequest {
    pub of: ToleranceSubject,
    /// The wire, the machine and how its wires run.
    pub choices: PlanChoices,
    pub required: RequirementsChoice,
    #[serde(default)]
    pub vary: VaryName,
    /// Of what is required, the share of the squares that is for feeds where both vary.
    #[serde(default = "half")]
    #[schemars(range(min = 0.0, max = 1.0))]
    pub feed_share: f64,
    #[serde(default)]
    pub closing: ClosingName,
    /// The faces that are to be flat.
    pub faces: Option<FacesChoice>,
}

/// Whose joints are closed.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ToleranceSubject {
    Design(DesignInput),
    /// A truss of many rings, by closed formulas.
    Continuum(ContinuumChoice),
}

const fn half() -> f64 {
    0.5
}

/// What can be required.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum RequirementName {
    Surface,
    Force,
    Stress,
}

impl From<Requirement> for RequirementName {
    fn from(requirement: Requirement) -> Self {
        match requirement {
            Requirement::Surface => Self::Surface,
            Requirement::Force => Self::Force,
            Requirement::Stress => Self::Stress,
        }
    }
}

/// What the frame comes to, expected of all wires; of a truss by closed formulas no stress is known.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct AchievedReport {
    pub surface_mm: f64,
    pub force_n: f64,
    pub stress_mpa: Option<f64>,
}

/// The first frequency of a free truss by closed formulas.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct TrussFrequency {
    pub straight_hz: f64,
    /// How far struts bow, as a share of their length.
    pub bow: f64,
    /// With struts that bow so far, as Bend-Forming has it.
    pub bowed_hz: f64,
    /// The same by the exact tangent of an arc whose ends turn, and of one whose ends do not: rigid joints lie between.
    pub bowed_between_hz: [f64; 2],
}

/// How good the motions of a machine must be: standard deviations without a systematic part.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ToleranceResponse {
    pub material: String,
    /// Of feeds; null where they do not vary.
    pub feed_sigma_mm: Option<f64>,
    /// Of bends and rotations; null where they do not vary.
    pub angle_sigma_deg: Option<f64>,
    /// The requirement that leaves no reserve.
    pub governed_by: RequirementName,
    pub achieved: AchievedReport,
    /// Of a truss by closed formulas, where they are known for so many rings.
    pub first_frequency: Option<TrussFrequency>,
    /// What was merged, ignored or assumed while reading.
    pub notes: Vec<NoteReport>,
}

pub fn tolerance(
    app: &Installation,
    request: &ToleranceRequest,
    progress: &dyn Progress,
) -> Result<ToleranceResponse, PlanningError> {
    let required = request.required.checked()?;
    if !(0.0..=1.0).contains(&request.feed_share) {
        return Err(wrong(InputName::FeedShare, request.feed_share, "a share from 0 to 1"));
    }
    let vary = match request.vary {
        VaryName::Feed => Vary::Feed,
        VaryName::Angle => Vary::Angle,
        VaryName::Both => Vary::Both { feed_share: request.feed_share },
    };
    let no_limit = |NoLimit| PlanningError::NoLimit;
    match &request.of {
        ToleranceSubject::Continuum(truss) => {
            let material = app.material_of(request.choices.material.as_deref())?;
            let bow = truss.bow;
            let truss = truss.checked(&material.wire)?;
            if request.vary != VaryName::Feed || request.required.stress_mpa.is_some() {
                return Err(PlanningError::OnlyLengths);
            }
            let feed = Effects {
                faces: vec![truss.surface_per_length()],
                force: truss.force_per_length(),
                stress: 0.0,
            };
            let found = wirebend_accuracy::tolerance(&feed, &Effects::default(), &required, vary)
                .map_err(no_limit)?;
            let first_frequency = first_frequency(&truss, bow);
            let notes =
                if bow > 0.0 && first_frequency.is_none() { vec![frequency_unknown()] } else { Vec::new() };
            Ok(ToleranceResponse {
                first_frequency,
                ..ToleranceResponse::new(material.id, &found, false, notes)
            })
        }
        ToleranceSubject::Design(design) => {
            let opened = app
                .designed(design.open_with(app, &request.choices, progress)?, &request.choices)?
                .with_wireframe()?;
            let mut notes = opened.notes.clone();
            let wireframe = opened.document.wireframe.clone();
            let wires = app.wires_to_close(opened, &request.choices, request.faces.as_ref(), progress)?;
            let crossings = check_crossings(&wireframe, wires.material.wire.diameter, default_weld());
            notes.extend(crossings.iter().map(crossing));
            progress.stage("closing joints");
            let closing = request.closing.into();
            let feed = wires.effects(closing, &one_mm(), request.vary != VaryName::Angle)?;
            let angle = wires.effects(closing, &one_degree(), request.vary != VaryName::Feed)?;
            let found = wirebend_accuracy::tolerance(&feed, &angle, &required, vary).map_err(no_limit)?;
            notes.extend(wires.notes);
            notes.extend(beyond_proportion(&found, wires.model.shortest_strut()));
            notes.extend(yields(&found, wires.material.section().yield_strength));
            Ok(ToleranceResponse::new(wires.material.id, &found, true, notes))
        }
    }
}

/// Bends and rotations that are off by more than so many degrees do not act in proportion any more: a sine is off by a thousandth.
const PROPORTIONAL_DEG: f64 = 5.0;
/// As a share of the shortest strut the way that a strut's end goes in so many degrees.
const PROPORTIONAL_SHARE: f64 = 0.1;

fn beyond_proportion(found: &Tolerance, shortest_mm: f64) -> Option<NoteReport> {
    let degrees = found.angle_sigma.filter(|&degrees| degrees > PROPORTIONAL_DEG);
    let angles = degrees.map(|degrees| {
        format!(
            "{degrees:.1}° are beyond the {PROPORTIONAL_DEG}° up to which effects grow in proportion: bends and rotations hardly limit what is required"
        )
    });
    let feed = found.feed_sigma.filter(|&feed| feed > PROPORTIONAL_SHARE * shortest_mm);
    let feeds = feed.map(|feed| {
        let percent = 100.0 * PROPORTIONAL_SHARE;
        format!(
            "{feed:.1} mm are more than {percent} % of the shortest strut of {shortest_mm:.1} mm, up to which effects grow in proportion: feeds hardly limit what is required"
        )
    });
    let first = angles.or(feeds)?;
    Some(NoteReport {
        code: "beyond-proportion".into(),
        count: 1,
        message: format!("{first}, and this is no figure to build by"),
        remedies: Vec::new(),
    })
}

/// Hooke's law ends where struts yield.
fn yields(found: &Tolerance, yield_mpa: f64) -> Option<NoteReport> {
    let stress = found.achieved.stress;
    (stress > yield_mpa).then(|| NoteReport {
        code: "struts-yield".into(),
        count: 1,
        message: format!(
            "with these the struts would bear {stress:.0} MPa and yield from {yield_mpa:.0} MPa on: require a stress below that, too"
        ),
        remedies: Vec::new(),
    })
}

/// Struts that run through each other are none that could be built, and the figures are those of the frame as it is drawn.
fn crossing(found: &Diagnostic) -> NoteReport {
    NoteReport { code: "edges_meet".into(), count: 1, message: text::message(found), remedies: Vec::new() }
}

fn first_frequency(truss: &Continuum, bow: f64) -> Option<TrussFrequency> {
    let of = |strut| truss.first_frequency_hz(bow, strut);
    Some(TrussFrequency {
        straight_hz: truss.first_frequency_hz(0.0, BowedStrut::Published)?,
        bow,
        bowed_hz: of(BowedStrut::Published)?,
        bowed_between_hz: [of(BowedStrut::Pinned)?, of(BowedStrut::Clamped)?],
    })
}

fn frequency_unknown() -> NoteReport {
    NoteReport {
        code: "frequency-not-fitted".into(),
        count: 1,
        message: "a bow changes the first frequency alone, which is known for trusses of 1 to 10 rings"
            .to_owned(),
        remedies: Vec::new(),
    }
}

fn one_mm() -> ErrorModel {
    ErrorModel { feed_mm: ErrorTerm { bias: 0.0, sigma: 1.0 }, ..ErrorModel::default() }
}

fn one_degree() -> ErrorModel {
    let one = ErrorTerm { bias: 0.0, sigma: 1.0 };
    ErrorModel { bend_deg: one, rotate_deg: one, ..ErrorModel::default() }
}

fn wrong(input: InputName, value: f64, expected: &'static str) -> PlanningError {
    PlanningError::Value { input: Some(input), name: input.words(), value: value.to_string(), expected }
}

impl Wires {
    /// What a deviation of one unit does; nothing where it does not vary.
    fn effects(&self, closing: Closing, errors: &ErrorModel, varies: bool) -> Result<Effects, PlanningError> {
        if !varies {
            return Ok(Effects::default());
        }
        let surface: &Surface = &self.surface;
        let expected = self.model.straight().and_then(|prepared| prepared.expected(closing, errors, surface));
        let expected = expected.map_err(|error| self.failed(error))?;
        let [force, stress] = [expected.axial_rms, expected.von_mises_rms];
        Ok(Effects { faces: expected.faces_rms, force, stress }.without_rounding(&self.model))
    }
}

impl RequirementsChoice {
    /// What is required, each a number above 0.
    fn checked(&self) -> Result<Vec<(Requirement, f64)>, PlanningError> {
        let given = [
            (Requirement::Surface, self.surface_mm),
            (Requirement::Force, self.force_n),
            (Requirement::Stress, self.stress_mpa),
        ];
        let given: Vec<(Requirement, f64)> =
            given.into_iter().filter_map(|(of, limit)| Some((of, limit?))).collect();
        match given.iter().find(|(_, limit)| !(limit.is_finite() && *limit > 0.0)) {
            Some(&(_, limit)) => Err(wrong(InputName::Requirements, limit, "a number above 0")),
            None => Ok(given),
        }
    }
}

impl ContinuumChoice {
    fn checked(&self, wire: &wirebend_core::estimate::WireModel) -> Result<Continuum, PlanningError> {
        let length = |mm: f64| {
            let length = Length::from_mm(mm).ok().filter(|length| *length > Length::ZERO);
            length.ok_or_else(|| wrong(InputName::Continuum, mm, "a length above 0, in mm"))
        };
        if self.rings == 0 {
            return Err(wrong(InputName::Continuum, 0.0, "at least 1 ring"));
        }
        if !(0.0..=0.5).contains(&self.bow) {
            return Err(wrong(InputName::Bow, self.bow, "a share of their length, from 0 to 0.5"));
        }
        let (depth, diameter) = (length(self.depth_mm)?, length(self.diameter_mm)?);
        Ok(Continuum { rings: self.rings, depth, diameter, wire: *wire })
    }
}

impl ToleranceResponse {
    fn new(material: String, found: &Tolerance, stress: bool, notes: Vec<NoteReport>) -> Self {
        Self {
            material,
            feed_sigma_mm: found.feed_sigma,
            angle_sigma_deg: found.angle_sigma,
            governed_by: found.governed_by.into(),
            achieved: AchievedReport {
                surface_mm: found.achieved.surface,
                force_n: found.achieved.force,
                stress_mpa: stress.then_some(found.achieved.stress),
            },
            first_frequency: None,
            notes,
        }
    }
}
