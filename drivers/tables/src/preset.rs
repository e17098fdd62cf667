//! Families of readers, and what each says. `README.md` has the sources.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::values::{Column, DecimalMark, Lengths, RotationCount, Separator};

/// A family of readers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Preset {
    /// Nothing but what the format says.
    #[default]
    None,
    /// L, R and A under these names and nothing else.
    Lra,
    /// The same under the names Y, B and C.
    Ybc,
    /// A number on each row, as bend reports of CAD programs have it: N, L, R, A, CLR.
    Numbered,
    /// Lengths from corner to corner: the reader takes the arcs off itself.
    Intersection,
    /// Columns C, F, E, G and Y of bend reports after MIL-D-9898: distance to the start of the bend, radius, rotation from the start, bend angle, straight length.
    #[serde(rename = "mil-d-9898")]
    MilD9898,
    /// What spreadsheets open where the decimal mark is a comma: semicolons between the cells.
    DecimalComma,
}

/// What a preset says; the rest is left to the format.
#[derive(Debug, Default)]
pub(crate) struct Said {
    /// Columns with their names. Then a header is written.
    pub columns: Option<&'static [(Column, &'static str)]>,
    pub lengths: Option<Lengths>,
    pub rotation: Option<RotationCount>,
    pub unsigned_bends: Option<bool>,
    pub separator: Option<Separator>,
    pub decimal_mark: Option<DecimalMark>,
}

impl Preset {
    pub(crate) fn says(self) -> Said {
        use Column::{Angle, Distance, Length, Number, Radius, Rotation};
        let relative = |columns| Said {
            columns: Some(columns),
            lengths: Some(Lengths::Tangent),
            rotation: Some(RotationCount::Relative),
            unsigned_bends: Some(true),
            ..Said::default()
        };
        match self {
            Self::None => Said::default(),
            Self::Lra => relative(&[(Length, "L"), (Rotation, "R"), (Angle, "A")]),
            Self::Ybc => relative(&[(Length, "Y"), (Rotation, "B"), (Angle, "C")]),
            Self::Numbered => {
                relative(&[(Number, "N"), (Length, "L"), (Rotation, "R"), (Angle, "A"), (Radius, "CLR")])
            }
            Self::Intersection => Said { lengths: Some(Lengths::Intersection), ..Said::default() },
            Self::MilD9898 => Said {
                rotation: Some(RotationCount::Absolute),
                ..relative(&[(Distance, "C"), (Radius, "F"), (Rotation, "E"), (Angle, "G"), (Length, "Y")])
            },
            Self::DecimalComma => Said {
                separator: Some(Separator::Semicolon),
                decimal_mark: Some(DecimalMark::Comma),
                ..Said::default()
            },
        }
    }
}
