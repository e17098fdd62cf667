//! Calibrations: what was written, what was found.

use std::io::Write;

use serde_json::Value;
use wirebend_api::{
    CalibrateApplyResponse, CalibrateCompareResponse, CalibrateEnterResponse, CalibrateNewResponse,
    CalibrationReport, KindName, KindReport, MisfitReport, ParameterReport, SeverityName,
};

use super::number::count;
use super::tables::{aligned, table};
use super::{severity_style, written};

pub(super) fn new(out: &mut impl Write, found: &CalibrateNewResponse) -> std::io::Result<()> {
    let repeats = found.repeats;
    writeln!(
        out,
        "{} for {} with {}: bend each {}, {:.1} m of wire, about {:.0} min on the machine",
        count(found.coupons, "coupon", "coupons"),
        found.machine,
        found.material,
        count(repeats as usize, "time", "times"),
        found.wire_mm / 1000.0,
        (found.seconds / 60.0).ceil(),
    )?;
    written(out, found.jobs.iter().chain([&found.sheet, &found.printed]))
}

pub(super) fn enter(out: &mut impl Write, found: &CalibrateEnterResponse) -> std::io::Result<()> {
    let entered = count(found.entered, "reading", "readings");
    let missing = match found.missing {
        0 => String::new(),
        missing => format!(", {} empty", count(missing, "cell is", "cells are")),
    };
    let replaced = match found.replaced {
        0 => String::new(),
        replaced => format!(" in place of {replaced}"),
    };
    writeln!(out, "{entered} entered{replaced}; {} in all{missing}", found.readings)?;
    written(out, [&found.sheet].into_iter())
}

pub(super) fn fit(out: &mut impl Write, found: &CalibrationReport) -> std::io::Result<()> {
    writeln!(out, "{} with {}", found.machine, found.material)?;
    let style = severity_style(SeverityName::Warning);
    for left in &found.left_out {
        let (line, reading) = (left.line, left.reading);
        let place = format!("line {line}, reading {reading} ({})", left.coupon);
        writeln!(out, "{style}left out{style:#}: {place}: {}", left.message)?;
    }
    doubts(out, found)?;
    for gap in &found.gaps {
        writeln!(out, "note: {gap}")?;
    }
    found.kinds.iter().try_for_each(|kind| one_kind(out, kind, found))
}

fn doubts(out: &mut impl Write, found: &CalibrationReport) -> std::io::Result<()> {
    let style = severity_style(SeverityName::Warning);
    found.doubts.iter().try_for_each(|doubt| writeln!(out, "{style}warning{style:#}: {doubt}"))
}

fn one_kind(out: &mut impl Write, kind: &KindReport, found: &CalibrationReport) -> std::io::Result<()> {
    let unit = shown(kind.unit);
    let name = match kind.kind {
        KindName::Bends => "bends",
        KindName::Feeds => "sides",
        KindName::Turns => "turns",
    };
    let of = kind.parameters.len();
    writeln!(
        out,
        "\n{name}: {}, scatter {:.2}{unit}; {} of {} determined",
        count(kind.readings, "reading", "readings"),
        kind.scatter,
        kind.rank,
        count(of, "parameter", "parameters"),
    )?;
    let rows: Vec<Vec<String>> = kind.parameters.iter().map(parameter).collect();
    aligned(out, &rows)?;
    let off = |misfit: &MisfitReport| format!("{:.2}{unit}", misfit.mean_abs);
    writeln!(out, "  off on average: {} before, {} after", off(&kind.before), off(&kind.after))?;
    let rms = |misfit: &MisfitReport| format!("{:.2}{unit}", misfit.rms);
    write!(out, "  leave-one-out: {} rms", rms(&kind.leave_one_out))?;
    if let (KindName::Bends, Some(shape)) = (kind.kind, found.shape) {
        let this = match shape {
            "constant" => "a constant springback",
            "moved" => "the springback of the profile, moved by one angle",
            _ => "a curve of the springback for each side",
        };
        write!(out, " with {this}")?;
        if let (Some(misfit), Some(other)) = (&found.other_shape, found.other_shape_name) {
            let other = match other {
                "constant" => "a constant",
                "moved" => "that of the profile, moved",
                _ => "a curve",
            };
            write!(out, ", {} with {other}", rms(misfit))?;
        }
    }
    writeln!(out)
}

fn parameter(found: &ParameterReport) -> Vec<String> {
    let digits = if found.unit.is_empty() { 4 } else { 2 };
    let unit = shown(found.unit);
    vec![
        format!("  {}", found.name),
        format!("{:.digits$}{unit}", found.value),
        format!("± {:.digits$}{unit}", found.within_95),
        format!("was {:.digits$}{unit}", found.before),
        match (found.identified, found.left) {
            (true, _) => "",
            (false, true) => "left as it was: not determined",
            (false, false) => "not determined by these readings",
        }
        .to_owned(),
    ]
}

fn shown(unit: &str) -> &'static str {
    match unit {
        "deg" => "°",
        "mm" => " mm",
        _ => "",
    }
}

pub(super) fn apply(out: &mut impl Write, found: &CalibrateApplyResponse) -> std::io::Result<()> {
    let left_out = found.report.left_out.len();
    if left_out > 0 {
        writeln!(
            out,
            "note: {} left out; `wirebend calibrate fit` names them",
            count(left_out, "reading is", "readings are")
        )?;
    }
    let parameters = found.report.kinds.iter().flat_map(|kind| &kind.parameters);
    let mut left: Vec<&str> =
        parameters.filter(|found| found.left).map(|found| found.name.as_str()).collect();
    // The radius of a bend is a parameter of bends and of sides.
    let mut seen = std::collections::BTreeSet::new();
    left.retain(|name| seen.insert(*name));
    if !left.is_empty() {
        writeln!(out, "note: left as it was, since the readings do not determine it: {}", left.join(", "))?;
    }
    doubts(out, &found.report)?;
    for gap in &found.report.gaps {
        writeln!(out, "note: {gap}")?;
    }
    writeln!(out, "machine '{}' with material '{}'", found.machine, found.material)?;
    written(out, found.files.iter())
}

pub(super) fn compare(out: &mut impl Write, found: &CalibrateCompareResponse) -> std::io::Result<()> {
    let [first, second] = &found.machines;
    let rows = found.values.iter().map(|value| {
        let [a, b] = &value.values;
        [value.key.clone(), cell(a), cell(b)]
    });
    table(out, ["", first, second], rows)?;
    for misfit in &found.misfits {
        let unit = shown(misfit.unit);
        let name = match misfit.kind {
            KindName::Bends => "bends",
            KindName::Feeds => "sides",
            KindName::Turns => "turns",
        };
        let [a, b] = misfit.misfits.map(|misfit| format!("{:.2}{unit}", misfit.mean_abs));
        let [of_first, of_second] = &found.materials;
        writeln!(
            out,
            "{name} off on average: {a} with {first} and {of_first}, {b} with {second} and {of_second}"
        )?;
    }
    Ok(())
}

/// A value in a cell: long ones are counted.
fn cell(value: &Value) -> String {
    match value {
        Value::Null => "-".to_owned(),
        Value::Array(items) => count(items.len(), "entry", "entries"),
        Value::String(text) => text.clone(),
        other => other.to_string(),
    }
}
