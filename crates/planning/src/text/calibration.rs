//! Words for calibrations: parameters, readings that are left out, what is not determined.

use wirebend_core::calibrate::{CalibrationError, Gap, Kind, LeftOut, LeftOutReason, OtherUnit, Parameter};

use super::number::count;

/// What is calibrated, as one calls it.
#[must_use]
pub fn parameter(parameter: Parameter) -> String {
    match parameter {
        Parameter::Springback => "springback".to_owned(),
        Parameter::SpringbackAt(angle) => format!("springback at {angle:.0}"),
        Parameter::SpringbackShift => "springback above the profile's curve".to_owned(),
        Parameter::OrbitRadius => "orbit radius R".to_owned(),
        Parameter::OrbitOffset => "orbit offset s".to_owned(),
        Parameter::BendRadius => "centreline radius of a bend".to_owned(),
        Parameter::PegRadius => "effective radius of the peg".to_owned(),
        Parameter::KFactor => "K-factor".to_owned(),
        Parameter::FeedScale => "wire per commanded mm".to_owned(),
        Parameter::RotationOffset => "offset of a turn".to_owned(),
        Parameter::RotationBacklash => "backlash of a turn".to_owned(),
    }
}

/// Why a reading is left out.
#[must_use]
pub fn left_out(left: &LeftOut) -> String {
    let (unit, digits) = match left.kind {
        Kind::Bends | Kind::Turns => ("°", 1),
        Kind::Feeds => (" mm", 2),
    };
    let value = |figure: wirebend_core::calibrate::Figure| format!("{:.digits$}{unit}", figure.plain());
    let (read, expected) = (value(left.reading), value(left.expected));
    match left.reason {
        LeftOutReason::DoesNotFit => {
            format!(
                "{read} does not fit the other readings, which say {expected}: it looks like a typing error"
            )
        }
        LeftOutReason::Impossible => format!("{read} cannot be; about {expected} was to be expected"),
        LeftOutReason::AxisOutOfRange { limit } => {
            format!(
                "{read} belongs to a position that the bend axis does not reach: it goes to {limit} either way"
            )
        }
        LeftOutReason::OtherSide => format!("{read} is to the other side than was commanded, {expected}"),
        LeftOutReason::Unit(unit) => {
            format!("{read} seems to be {}; about {expected} was to be expected", other_unit(unit))
        }
        LeftOutReason::NoBend => {
            "nothing stayed of this bend, which tells only that the wire took back all of it".to_owned()
        }
    }
}

/// What a reading is instead of what it should be.
const fn other_unit(unit: OtherUnit) -> &'static str {
    match unit {
        OtherUnit::Radians => "in radians",
        OtherUnit::Inches => "in inches",
        OtherUnit::Centimetres => "in centimetres",
        OtherUnit::InnerAngle => {
            "the angle between the legs instead of the bend, which is 0° where the wire is straight"
        }
    }
}

/// What a sheet needs at least.
const ENOUGH: &str =
    "bends of one angle are enough for the springback, one side for the feed, one turn for the head";

fn kind(kind: Kind) -> &'static str {
    match kind {
        Kind::Bends => "bends",
        Kind::Feeds => "sides",
        Kind::Turns => "turns of the head",
    }
}

/// What is not determined, and what is done for want of it.
#[must_use]
pub fn gap(gap: &Gap) -> String {
    match gap {
        Gap::NoReadings { kind: of, given } => {
            let what = match of {
                Kind::Bends => "springback and bend head stay as they are in the profiles",
                Kind::Feeds => "K-factor and feed stay as they are in the profiles",
                Kind::Turns => "nothing is said of the head",
            };
            match given {
                0 => format!("no {} were measured: {what}", kind(*of)),
                given => format!(
                    "none of {} of {} can be fitted: {what}",
                    count(*given, "reading", "readings"),
                    kind(*of)
                ),
            }
        }
        Gap::OneSide { missing } => {
            let side = if *missing < 0.0 { "negative" } else { "positive" };
            format!(
                "no bend to the {side} side was measured: springback and bend head are fitted from the other one, and this is taken to be like it"
            )
        }
        Gap::OneAngle { axis } => format!(
            "all bends were commanded alike, {axis}: their springback is fitted, and the dimensions of the bend head stay as they are; measure another angle"
        ),
        Gap::OneLength { feed } => format!(
            "all sides were fed the same, {feed}: what they lack is shared out between the feed and the K-factor; measure another length"
        ),
        Gap::FewAngles { needed } => format!(
            "a curve of the springback needs {needed} different angles of each side that was bent: none is made of fewer"
        ),
        Gap::SpringbackLeft => {
            "the profile leaves springback to the machine: what was found of it is written to no profile".to_owned()
        }
        Gap::DeductionLeft => {
            "the profile leaves the wire in bends to the machine: a side is what is fed, and the K-factor stays as it is"
                .to_owned()
        }
        Gap::NoReversal => {
            "no turn goes back: the offset of turns is fitted, and the backlash of the head is not determined"
                .to_owned()
        }
    }
}

/// Why what was found of turns is not in a profile.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TurnsStay {
    /// What was there before is within 95 % of what was found.
    WithinUncertainty,
    /// The head would gain by turning back.
    NegativeBacklash,
}

/// The same in words.
#[must_use]
pub fn turns_stay(why: TurnsStay) -> String {
    let (why, instead) = match why {
        TurnsStay::WithinUncertainty => (
            "offset and backlash of turns differ from those of the profile by less than they are known",
            "more readings of turns tell them better",
        ),
        TurnsStay::NegativeBacklash => ("a backlash below zero cannot be", "measure the turns again"),
    };
    format!("{why}: both stay as the profile has them, and programs do not make up for them; {instead}")
}

/// "line 5", "lines 5 and 6", "lines 5 to 18".
fn sheet_lines(lines: &[usize]) -> String {
    match lines {
        [] => "its lines".to_owned(),
        [line] => format!("line {line}"),
        [first, second] => format!("lines {first} and {second}"),
        [first, .., last] => format!("lines {first} to {last}"),
    }
}

/// What was found that no profile holds.
#[must_use]
pub fn beyond(name: &str, found: &str, expected: &str, lines: &[usize]) -> String {
    let lines = sheet_lines(lines);
    format!(
        "{name} is found to be {found}, and a profile holds {expected}: readings in {lines} of the sheet are wrong"
    )
}

/// A K-factor that bent wire does not have.
#[must_use]
pub fn neutral_fibre(k_factor: f64, lines: &[usize]) -> String {
    let lines = sheet_lines(lines);
    format!(
        "the K-factor is found to be {k_factor:.4}, and the neutral fibre of a bent wire lies between its inner face, 0, and its middle, 0.5: \
         were the sides in {lines} of the sheet read over the outside?"
    )
}

/// Why there is no calibration.
#[must_use]
pub fn refusal(error: &CalibrationError) -> String {
    match error {
        CalibrationError::NoReadings { given: 0, .. } => {
            format!("the sheet has no readings: not one cell is filled in; {ENOUGH}")
        }
        CalibrationError::NoReadings { given, reason: Some(LeftOutReason::Unit(unit)) } => {
            let readings = count(*given, "reading", "readings");
            format!("none of {readings} can be fitted: each seems to be {}", other_unit(*unit))
        }
        CalibrationError::NoReadings { given, .. } => {
            format!("none of {} can be fitted; {ENOUGH}", count(*given, "reading", "readings"))
        }
        CalibrationError::Geometry(error) => super::error::peg_geometry(error),
        CalibrationError::NoSolution { kind: of } => {
            let of = kind(*of);
            format!(
                "no machine makes {of} as their readings say: correct them, or empty their cells to fit the rest"
            )
        }
    }
}
