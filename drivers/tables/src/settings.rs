//! What a person can set.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::preset::Preset;
use crate::values::{
    Column, Comments, DecimalMark, Handedness, LengthUnit, Lengths, LineEnd, PointColumn, RotationCount,
    Separator,
};

/// How tables are written. What is left open is as the preset says, and else as the format says. The comments
/// below are shown in a form.
#[derive(Debug, Clone, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Settings {
    /// A family of readers: what it says holds for every key that is left open.
    pub preset: Preset,
    /// Columns of LRA, YBC and cumulative tables from left to right: N number of the row from 1, L length of the straight part, D distance from the start, R rotation, A bend angle, CLR centreline radius.
    pub columns: Option<Vec<Column>>,
    /// Columns of XYZ tables from left to right: N number of the row from 1, X, Y, Z, CLR centreline radius (empty at the ends).
    pub point_columns: Option<Vec<PointColumn>>,
    /// What lengths and distances are measured between: tangent (the ends of the arcs) or intersection (the corners of the design).
    pub lengths: Option<Lengths>,
    /// right: a positive rotation turns the next bend's axis by the right-hand rule about the direction in which the wire runs. left: the other way. XYZ tables have no rotations and do not change.
    pub handedness: Option<Handedness>,
    /// Whether a rotation counts from the bend before (relative, above -180 up to 180 degrees) or from the start (absolute, 0 to below 360 degrees).
    pub rotation: Option<RotationCount>,
    /// Whether every bend is 0 to 180 degrees; a negative one then becomes half a turn of rotation. Otherwise bends keep their sign.
    pub unsigned_bends: Option<bool>,
    /// Unit of lengths, radii and points. Angles are degrees.
    pub length_unit: Option<LengthUnit>,
    /// Digits behind the decimal mark of lengths and angles, 0 to 9. 3 unless set.
    #[schemars(range(min = 0, max = 9))]
    pub decimals: Option<u8>,
    /// What stands between two cells. A comma unless set, but a semicolon where the decimal mark is a comma.
    pub separator: Option<Separator>,
    /// What stands before the decimals: point or comma.
    pub decimal_mark: Option<DecimalMark>,
    /// Whether the first row names the columns.
    pub header: Option<bool>,
    /// Names for `columns`, one each. Needs `columns`, or a preset that has columns.
    pub header_names: Option<Vec<String>>,
    /// Names for `point_columns`, one each.
    pub point_header_names: Option<Vec<String>>,
    /// End of each line: lf, or crlf as Windows has it.
    pub line_end: Option<LineEnd>,
    /// Whether a first line with the hash of the design is written: number-sign starts it with #, none leaves it out. CSV has no comments, so none unless set.
    pub comments: Option<Comments>,
}
