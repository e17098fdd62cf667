//! A calibration as plain values with words.

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_core::calibrate::{
    Calibration, Estimate, Figure, Fit, Kind, LeftOut, Misfit, Parameter, SpringbackShape,
};

use super::measured::OfSheet;
use crate::text::calibration as words;

/// What is calibrated apart from the others.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum KindName {
    Bends,
    Feeds,
    Turns,
}

impl From<Kind> for KindName {
    fn from(kind: Kind) -> Self {
        match kind {
            Kind::Bends => Self::Bends,
            Kind::Feeds => Self::Feeds,
            Kind::Turns => Self::Turns,
        }
    }
}

/// How far readings are from a model, in mm or degrees.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct MisfitReport {
    pub mean_abs: f64,
    pub rms: f64,
}

impl From<Misfit> for MisfitReport {
    fn from(misfit: Misfit) -> Self {
        Self { mean_abs: misfit.mean_abs, rms: misfit.rms }
    }
}

/// A parameter as it was found.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ParameterReport {
    /// What it is, for people.
    pub name: String,
    /// `mm`, `deg` or empty for a ratio.
    pub unit: &'static str,
    pub before: f64,
    pub value: f64,
    /// With 95 % it is within this of the value.
    pub within_95: f64,
    /// Whether the readings determine it better than it was known before.
    pub identified: bool,
    /// Whether it was left as it was, since they do not.
    pub left: bool,
    /// How much of what is known of it comes from the readings, 0 to 1.
    pub determined: f64,
}

/// A reading beside what the fitted model makes of its command.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ReadingReport {
    /// Line of the sheet, from 1.
    pub line: usize,
    /// Which reading of the line, from 1.
    pub reading: usize,
    pub commanded: f64,
    pub read: f64,
    pub fitted: f64,
}

/// How readings of a kind were fitted.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct KindReport {
    pub kind: KindName,
    /// Unit of the readings: `deg` or `mm`.
    pub unit: &'static str,
    pub readings: usize,
    pub parameters: Vec<ParameterReport>,
    /// How many independent combinations of the parameters the readings tell.
    pub rank: usize,
    /// Standard deviation of a reading.
    pub scatter: f64,
    pub before: MisfitReport,
    pub after: MisfitReport,
    pub leave_one_out: MisfitReport,
    pub values: Vec<ReadingReport>,
}

/// A reading that was left out.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct LeftOutReport {
    pub kind: KindName,
    /// Line of the sheet, from 1.
    pub line: usize,
    /// Which reading of the line, from 1.
    pub reading: usize,
    pub coupon: String,
    pub read: f64,
    pub expected: f64,
    /// Why, for people.
    pub message: String,
}

/// What measurements tell of a machine and a wire.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct CalibrationReport {
    pub machine: String,
    pub material: String,
    pub kinds: Vec<KindReport>,
    /// What the springback depends on: `constant`, `curve`, or `moved`, the curve of the profile moved by one angle; absent where no bend was measured.
    pub shape: Option<&'static str>,
    /// The error by leave-one-out of the other shape, degrees, where it can be fitted.
    pub other_shape: Option<MisfitReport>,
    /// What the springback depends on there.
    pub other_shape_name: Option<&'static str>,
    pub left_out: Vec<LeftOutReport>,
    /// What was found and cannot be, so that readings are wrong.
    pub doubts: Vec<String>,
    /// What the measurements do not tell, and what is done for want of it.
    pub gaps: Vec<String>,
}

impl CalibrationReport {
    pub(super) fn new(machine: &str, material: &str, found: &Calibration, sheet: &OfSheet<'_>) -> Self {
        let bends = found.bends.as_ref();
        let fits = [
            (Kind::Bends, bends.map(|bends| &bends.fit)),
            (Kind::Feeds, found.feeds.as_ref().map(|feeds| &feeds.fit)),
            (Kind::Turns, found.turns.as_ref().map(|turns| &turns.fit)),
        ];
        let left_out = found.left_out.iter().map(|left| {
            let row = sheet.row(left.kind, left.place);
            let as_read = |figure| sheet.as_read(left.kind, figure);
            let left = &LeftOut { reading: as_read(left.reading), expected: as_read(left.expected), ..*left };
            LeftOutReport {
                kind: left.kind.into(),
                line: row.map_or(0, |row| row.line),
                reading: left.place.repeat + 1,
                coupon: row.map(|row| row.coupon.clone()).unwrap_or_default(),
                read: left.reading.plain(),
                expected: left.expected.plain(),
                message: words::left_out(left),
            }
        });
        let other = bends.and_then(|bends| bends.other);
        let turns_stay = found.turns.as_ref().and_then(|turns| turns_stay(&turns.fit));
        Self {
            machine: machine.to_owned(),
            material: material.to_owned(),
            kinds: fits.into_iter().filter_map(|(kind, fit)| Some(kind_report(kind, fit?, sheet))).collect(),
            shape: bends.map(|bends| shape(bends.shape)),
            other_shape: other.map(|(_, misfit)| misfit.into()),
            other_shape_name: other.map(|(name, _)| shape(name)),
            left_out: left_out.collect(),
            doubts: Vec::new(),
            gaps: found.gaps.iter().map(words::gap).chain(turns_stay.map(words::turns_stay)).collect(),
        }
    }
}

fn shape(shape: SpringbackShape) -> &'static str {
    match shape {
        SpringbackShape::Constant => "constant",
        SpringbackShape::Moved => "moved",
        SpringbackShape::Cubic => "curve",
    }
}

fn kind_report(kind: Kind, fit: &Fit, sheet: &OfSheet<'_>) -> KindReport {
    let value = |residual: &wirebend_core::calibrate::Residual| ReadingReport {
        line: sheet.row(kind, residual.place).map_or(0, |row| row.line),
        reading: residual.place.repeat + 1,
        commanded: residual.commanded.plain(),
        read: sheet.as_read(kind, residual.reading).plain(),
        fitted: sheet.as_read(kind, residual.fitted).plain(),
    };
    KindReport {
        kind: kind.into(),
        unit: unit(fit.scatter),
        readings: fit.readings,
        parameters: fit.estimates.iter().map(parameter).collect(),
        rank: fit.rank,
        scatter: fit.scatter.plain(),
        before: fit.before.into(),
        after: fit.after.into(),
        leave_one_out: fit.leave_one_out.into(),
        values: fit.residuals.iter().map(value).collect(),
    }
}

fn parameter(estimate: &Estimate) -> ParameterReport {
    ParameterReport {
        name: words::parameter(estimate.parameter),
        unit: unit(estimate.value),
        before: estimate.before.plain(),
        value: estimate.value.plain(),
        within_95: estimate.within_95.plain(),
        identified: estimate.is_identified(),
        left: estimate.is_left(),
        determined: estimate.determined,
    }
}

fn unit(figure: Figure) -> &'static str {
    match figure {
        Figure::Length(_) => "mm",
        Figure::Angle(_) => "deg",
        Figure::Ratio(_) => "",
    }
}

/// Why what was found of turns is in no profile, if it is not: a difference that is within its own uncertainty would have the head make up
/// for what may not be there.
pub(super) fn turns_stay(fit: &Fit) -> Option<words::TurnsStay> {
    let off = |parameter| {
        let found = estimate(fit, parameter)?;
        Some((found.value.plain() - found.before.plain()).abs() > found.within_95.plain())
    };
    let is_off = off(Parameter::RotationOffset)? || off(Parameter::RotationBacklash)?;
    let backlash = estimate(fit, Parameter::RotationBacklash)?.value.plain();
    match (is_off, backlash >= 0.0) {
        (false, _) => Some(words::TurnsStay::WithinUncertainty),
        (true, false) => Some(words::TurnsStay::NegativeBacklash),
        (true, true) => None,
    }
}

/// The estimate of a parameter.
pub(super) fn estimate(fit: &Fit, wanted: Parameter) -> Option<&Estimate> {
    fit.estimates.iter().find(|estimate| estimate.parameter == wanted)
}
