//! The formats, and what each says where a person and a preset say nothing.

use crate::values::{Column, LengthUnit, Lengths, RotationCount};

/// A table that can be written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum TableFormat {
    /// Length, rotation and angle of each part.
    Lra,
    /// The same under the names of a machine's axes.
    Ybc,
    Xyz,
    /// Distances and planes counted from the start.
    Cumulative,
}

impl TableFormat {
    pub const ALL: [Self; 4] = [Self::Lra, Self::Ybc, Self::Xyz, Self::Cumulative];

    pub const fn id(self) -> &'static str {
        match self {
            Self::Lra => "lra-csv",
            Self::Ybc => "ybc-csv",
            Self::Xyz => "xyz-csv",
            Self::Cumulative => "cumulative-csv",
        }
    }

    pub const fn name(self) -> &'static str {
        match self {
            Self::Lra => "LRA table",
            Self::Ybc => "YBC table",
            Self::Xyz => "XYZ table of corners",
            Self::Cumulative => "Cumulative table",
        }
    }

    pub const fn extensions(self) -> &'static [&'static str] {
        match self {
            Self::Lra => &["csv", "lra"],
            Self::Ybc => &["csv", "ybc"],
            Self::Xyz => &["csv", "xyz"],
            Self::Cumulative => &["csv"],
        }
    }

    /// Whether its first row names the columns: controllers that take YBC take numbers only.
    pub const fn header(self) -> bool {
        !matches!(self, Self::Ybc)
    }

    pub const fn columns(self) -> &'static [Column] {
        match self {
            Self::Ybc => &[Column::Length, Column::Rotation, Column::Angle],
            Self::Cumulative => &[Column::Distance, Column::Rotation, Column::Angle, Column::Radius],
            _ => &[Column::Length, Column::Rotation, Column::Angle, Column::Radius],
        }
    }

    pub const fn rotation(self) -> RotationCount {
        match self {
            Self::Cumulative => RotationCount::Absolute,
            _ => RotationCount::Relative,
        }
    }

    /// The name of a column, which says what is in it: `L_mm`, but `Lcorner_mm` for lengths between corners
    /// and `Rabs_deg` for rotations from the start, so that neither is taken for what it is not.
    pub fn column_name(
        self,
        column: Column,
        lengths: Lengths,
        rotation: RotationCount,
        unit: LengthUnit,
    ) -> String {
        let [length, turn, angle] = if self == Self::Ybc { ["Y", "B", "C"] } else { ["L", "R", "A"] };
        let between = if lengths == Lengths::Intersection { "corner" } else { "" };
        let from_start = if rotation == RotationCount::Absolute { "abs" } else { "" };
        let unit = unit.word();
        match column {
            Column::Number => "N".to_owned(),
            Column::Length => format!("{length}{between}_{unit}"),
            Column::Distance => format!("D{between}_{unit}"),
            Column::Rotation => format!("{turn}{from_start}_deg"),
            Column::Angle => format!("{angle}_deg"),
            Column::Radius => format!("CLR_{unit}"),
        }
    }
}
