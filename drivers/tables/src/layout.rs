//! From settings, preset and format to how a table is written.

use wirebend_driver_api::DriverError;

use crate::format::TableFormat;
use crate::grid::Grid;
use crate::refusal::setting;
use crate::settings::Settings;
use crate::sheet::Style;
use crate::values::{
    Column, Comments, DecimalMark, Handedness, LengthUnit, Lengths, LineEnd, PointColumn, RotationCount,
    Separator,
};

/// The most digits behind the decimal mark.
const MAX_DECIMALS: u8 = 9;

/// How a table of bends is written.
#[derive(Debug)]
pub(crate) struct BendLayout {
    pub columns: Vec<Column>,
    pub header: Option<Vec<String>>,
    pub lengths: Lengths,
    pub handedness: Handedness,
    pub rotation: RotationCount,
    pub unsigned_bends: bool,
    pub style: Style,
}

/// How a table of points is written.
#[derive(Debug)]
pub(crate) struct PointLayout {
    pub columns: Vec<PointColumn>,
    pub header: Option<Vec<String>>,
    pub style: Style,
}

/// Refuses settings that no table can be written with.
pub(crate) fn check(settings: &Settings, format: TableFormat) -> Result<(), DriverError> {
    if format == TableFormat::Xyz { points(settings).map(drop) } else { bends(settings, format).map(drop) }
}

pub(crate) fn bends(settings: &Settings, format: TableFormat) -> Result<BendLayout, DriverError> {
    let style = style(settings)?;
    let said = settings.preset.says();
    let lengths = settings.lengths.or(said.lengths).unwrap_or(Lengths::Tangent);
    let rotation = settings.rotation.or(said.rotation).unwrap_or(format.rotation());
    let preset = said.columns.filter(|_| settings.columns.is_none());
    let columns = match (&settings.columns, preset) {
        (Some(columns), _) => columns.clone(),
        (None, Some(columns)) => columns.iter().map(|(column, _)| *column).collect(),
        (None, None) => format.columns().to_vec(),
    };
    distinct("columns", &columns)?;
    // The names of a preset say lengths and rotations as it counts them, and of others what they are not.
    let is_as_said = (said.lengths, said.rotation) == (Some(lengths), Some(rotation));
    let names = match (&settings.header_names, preset) {
        (Some(_), None) if settings.columns.is_none() => {
            let message = "'header_names' is set and 'columns' is not: the formats have different columns";
            return Err(setting(message, "list the columns in 'columns' too, one for each name"));
        }
        (Some(names), _) => {
            fitting("header_names", names, "columns", columns.len(), style.separator)?;
            names.clone()
        }
        (None, Some(columns)) if is_as_said => columns.iter().map(|(_, name)| (*name).to_owned()).collect(),
        (None, _) => {
            let name = |&column| format.column_name(column, lengths, rotation, style.unit);
            columns.iter().map(name).collect()
        }
    };
    let named = settings.header_names.is_some() || preset.is_some();
    let has_header = settings.header.unwrap_or(named || format.header());
    Ok(BendLayout {
        columns,
        header: has_header.then_some(names),
        lengths,
        handedness: settings.handedness.unwrap_or(Handedness::Right),
        rotation,
        unsigned_bends: settings.unsigned_bends.or(said.unsigned_bends).unwrap_or(true),
        style,
    })
}

pub(crate) fn points(settings: &Settings) -> Result<PointLayout, DriverError> {
    let style = style(settings)?;
    let columns = settings
        .point_columns
        .clone()
        .unwrap_or_else(|| vec![PointColumn::X, PointColumn::Y, PointColumn::Z]);
    distinct("point_columns", &columns)?;
    let unit = style.unit.word();
    let names = if let Some(names) = &settings.point_header_names {
        fitting("point_header_names", names, "point_columns", columns.len(), style.separator)?;
        names.clone()
    } else {
        let name = |column: &PointColumn| match column {
            PointColumn::Number => "N".to_owned(),
            PointColumn::X => format!("x_{unit}"),
            PointColumn::Y => format!("y_{unit}"),
            PointColumn::Z => format!("z_{unit}"),
            PointColumn::Radius => format!("CLR_{unit}"),
        };
        columns.iter().map(name).collect()
    };
    Ok(PointLayout { columns, header: settings.header.unwrap_or(true).then_some(names), style })
}

fn style(settings: &Settings) -> Result<Style, DriverError> {
    let said = settings.preset.says();
    let decimals = settings.decimals.unwrap_or(3);
    if decimals > MAX_DECIMALS {
        let message = format!("'decimals' is {decimals}; it can be 0 to {MAX_DECIMALS}");
        return Err(setting(message, "set it to 3 for thousandths"));
    }
    let decimal_mark = settings.decimal_mark.or(said.decimal_mark).unwrap_or(DecimalMark::Point);
    let is_comma = decimal_mark == DecimalMark::Comma;
    let usual = if is_comma { Separator::Semicolon } else { Separator::Comma };
    let separator = settings.separator.or(said.separator).unwrap_or(usual);
    if is_comma && separator == Separator::Comma {
        let message = "'separator' is comma and 'decimal_mark' is comma: nobody could tell them apart";
        return Err(setting(message, "set 'separator' to semicolon or tab"));
    }
    Ok(Style {
        grid: Grid { decimals },
        unit: settings.length_unit.unwrap_or(LengthUnit::Mm),
        separator,
        decimal_mark,
        line_end: settings.line_end.unwrap_or(LineEnd::Lf),
        comment: settings.comments == Some(Comments::NumberSign),
    })
}

/// Refuses a list without columns, and one with a column twice.
fn distinct<C: PartialEq + serde::Serialize>(key: &str, columns: &[C]) -> Result<(), DriverError> {
    if columns.is_empty() {
        return Err(setting(format!("'{key}' is an empty list"), "list a column, or leave the key out"));
    }
    let again = columns.iter().enumerate().find(|(k, column)| columns[..*k].contains(column));
    match again {
        None => Ok(()),
        Some((_, column)) => {
            let column = serde_json::to_string(column).unwrap_or_default();
            Err(setting(format!("'{key}' lists {column} twice"), "list each column once"))
        }
    }
}

/// Refuses names that are not one for each column, or that a reader would take apart.
fn fitting(
    key: &str,
    names: &[String],
    columns_key: &str,
    columns: usize,
    separator: Separator,
) -> Result<(), DriverError> {
    if names.len() != columns {
        let message = format!("the length of '{key}' is {}, expected {columns}", names.len());
        return Err(setting(message, format!("give one name for each column in '{columns_key}'")));
    }
    let apart = |c: char| c == separator.mark() || c == '"' || c.is_control();
    match names.iter().find(|name| name.contains(apart)) {
        None => Ok(()),
        Some(name) => {
            let message = format!(
                "'{key}' has the name {name:?} with a separator, a quotation mark or a control character in it"
            );
            Err(setting(message, "leave that character out"))
        }
    }
}
