//! Profiles: whether they can be used, what was written, which profile set what.

use std::io::Write;

use anstyle::Style;
use serde_json::Value;
use wirebend_api::{
    BendTorqueReport, ProfileCheckResponse, ProfileExplainResponse, ProfileExportResponse,
    ProfileImportResponse, ProfileNewResponse, ProfileRevertResponse, ProfileSetResponse, SamplePlace,
    SetValue, SeverityName, SharedProfile, SpringbackReport, SpringbackSample, ValueReport,
};

use super::tables::padded;
use super::{advice, notes, severity_style};

/// The widest line.
const COLUMNS: usize = 120;
/// The widest cell of a value; a longer text is shown in full below it.
const VALUE: usize = 26;

/// What the last words of a key say of its value's unit; the longer ones first.
const UNITS: [(&str, &str); 9] = [
    ("price_per_mm", "per mm"),
    ("kg_per_m3", "kg/m³"),
    ("mm_per_s", "mm/s"),
    ("deg_per_s", "°/s"),
    ("gpa", "GPa"),
    ("mpa", "MPa"),
    ("deg", "°"),
    ("mm", "mm"),
    ("s", "s"),
];

pub(super) fn check(out: &mut impl Write, found: &ProfileCheckResponse) -> std::io::Result<()> {
    for verdict in &found.files {
        for note in &verdict.notes {
            writeln!(out, "{}: note: {note}", verdict.file.display())?;
        }
        if verdict.ok {
            let id = verdict.id.as_deref().unwrap_or_default();
            let from = match verdict.inherits.as_slice() {
                [] => String::new(),
                chain => format!(", inherits from {}", chain.join(" ← ")),
            };
            writeln!(
                out,
                "{}: ok ({} '{id}'{from})",
                verdict.file.display(),
                verdict.kind.unwrap_or("profile")
            )?;
        } else {
            for problem in &verdict.problems {
                let style = severity_style(SeverityName::Error);
                writeln!(out, "{style}error{style:#}: {}", problem.message)?;
                advice::write(out, &problem.remedies)?;
            }
        }
    }
    Ok(())
}

pub(super) fn new(out: &mut impl Write, found: &ProfileNewResponse) -> std::io::Result<()> {
    let Some(file) = &found.file else { return Ok(()) };
    writeln!(
        out,
        "wrote {} ({} '{}', inherits from {})",
        file.display(),
        found.kind,
        found.id,
        found.inherits
    )
}

pub(super) fn set(out: &mut impl Write, found: &ProfileSetResponse) -> std::io::Result<()> {
    changed(out, &found.values)?;
    writeln!(out, "wrote {} ({} '{}')", found.file.display(), found.kind, found.id)
}

pub(super) fn revert(out: &mut impl Write, found: &ProfileRevertResponse) -> std::io::Result<()> {
    changed(out, &found.values)?;
    writeln!(out, "wrote {} ({} '{}')", found.file.display(), found.kind, found.id)
}

pub(super) fn exported(out: &mut impl Write, found: &ProfileExportResponse) -> std::io::Result<()> {
    let Some(file) = &found.file else { return Ok(()) };
    notes(out, &found.notes)?;
    writeln!(out, "wrote {} ({} '{}'{})", file.display(), found.kind, found.id, with(&found.with))
}

pub(super) fn imported(out: &mut impl Write, found: &ProfileImportResponse) -> std::io::Result<()> {
    let with = with(&found.with);
    if found.known {
        let (file, kind, id) = (found.file.display(), found.kind, &found.id);
        return writeln!(out, "nothing to import: {file} is here already ({kind} '{id}'{with})");
    }
    if let Some(name) = &found.own_name {
        writeln!(
            out,
            "note: another {} is called \"{name}\": this one is \"{}\" here",
            found.kind, found.name
        )?;
    }
    writeln!(out, "wrote {} ({} '{}'{with})", found.file.display(), found.kind, found.id)
}

/// ", with the material 'spool'", of what goes with a profile.
fn with(others: &[SharedProfile]) -> String {
    let named: Vec<String> =
        others.iter().map(|other| format!("the {} '{}'", other.kind, other.id)).collect();
    if named.is_empty() { String::new() } else { format!(", with {}", named.join(" and ")) }
}

fn changed(out: &mut impl Write, values: &[SetValue]) -> std::io::Result<()> {
    values.iter().try_for_each(|SetValue { key, before, value }| match before {
        Value::Null => writeln!(out, "{key}: {value}"),
        before => writeln!(out, "{key}: {value} instead of {before}"),
    })
}

pub(super) fn explain(out: &mut impl Write, found: &ProfileExplainResponse) -> std::io::Result<()> {
    let base = if found.is_abstract { ", only to be inherited from" } else { "" };
    writeln!(out, "{} '{}': {}{base}", found.kind, found.id, found.name)?;
    let width = found.chain.iter().map(|link| link.id.chars().count()).max().unwrap_or(0);
    for (depth, link) in found.chain.iter().enumerate() {
        let arrow = if depth == 0 { " " } else { "←" };
        let whose = if link.shipped { "shipped" } else { "own" };
        writeln!(out, "  {arrow} {}  {whose:<7}  {}", padded(&link.id, width), link.file)?;
    }
    writeln!(out)?;
    let cells: Vec<[String; 3]> = found.values.iter().map(cells).collect();
    let width = |column: usize| cells.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let (values, keys, places) = (width(0), width(1), width(2));
    let dim = Style::new().dimmed();
    let margin = " ".repeat(values + 4);
    for (value, [shown, key, place]) in found.values.iter().zip(&cells) {
        let lead = " ".repeat(values - shown.chars().count());
        let line = format!("{lead}{shown}  {}  {}", padded(key, keys), padded(place, places));
        let [measured, replaced] = remarks(value);
        let line = format!("{line}  {measured}");
        let whole = format!("{line}{}{replaced}", if measured.is_empty() { "" } else { ", " });
        if replaced.is_empty() || whole.chars().count() > COLUMNS {
            writeln!(out, "{}", line.trim_end())?;
            let below = wrapped(&replaced, COLUMNS - margin.len());
            below.iter().try_for_each(|text| writeln!(out, "{margin}{text}"))?;
        } else {
            writeln!(out, "{whole}")?;
        }
        let long = long(value);
        for text in long.iter().chain(&value.source).flat_map(|text| wrapped(text, COLUMNS - margin.len())) {
            writeln!(out, "{margin}{dim}{text}{dim:#}")?;
        }
    }
    found.bend_torque.as_ref().map_or(Ok(()), |torque| bend_torque(out, torque))?;
    found.springback.as_ref().map_or(Ok(()), |curve| springback(out, curve))
}

/// What the bend axis can bend, a line for each wire.
fn bend_torque(out: &mut impl Write, torque: &BendTorqueReport) -> std::io::Result<()> {
    let BendTorqueReport { available_n_m, margin, wires } = torque;
    writeln!(
        out,
        "\nbend torque: {available_n_m} N·m; how many times what each wire needs (a warning below {margin})"
    )?;
    for wire in wires {
        writeln!(out, "  {:>7.1} times  {:>6.3} N·m  {}", wire.times, wire.needed_n_m, wire.material)?;
    }
    Ok(())
}

/// The curve of a springback table, a line for each bend.
fn springback(out: &mut impl Write, curve: &SpringbackReport) -> std::io::Result<()> {
    writeln!(out, "\nspringback: {}", curve.rule)?;
    let same = curve.positive == curve.negative;
    let sides: &[(&str, &[SpringbackSample])] = if same {
        &[("either side", &curve.positive)]
    } else {
        &[("positive side", &curve.positive), ("negative side", &curve.negative)]
    };
    for (side, samples) in sides {
        writeln!(out, "  {side}: bend, loss")?;
        for SpringbackSample { bend_deg, loss_deg, place } in *samples {
            let place = match place {
                SamplePlace::Pair => "  pair",
                SamplePlace::Between => "",
                SamplePlace::Beyond => "  beyond the pairs",
            };
            writeln!(out, "    {bend_deg:>6.1}°  {loss_deg:>6.2}°{place}")?;
        }
    }
    Ok(())
}

/// Value, key, and the line that set it.
fn cells(value: &ValueReport) -> [String; 3] {
    let line = value.line.map(|line| format!(":{line}")).unwrap_or_default();
    [short(&shown(&value.key, &value.value)), value.key.clone(), format!("{}{line}", value.set_by)]
}

/// Whether a figure was measured, and what it replaces; each may be empty.
fn remarks(value: &ValueReport) -> [String; 2] {
    let measured = value.measured.map(|measured| if measured { "measured" } else { "not measured" });
    let replaced = value.instead_of.as_ref().map(|old| {
        let before = shown(&value.key, &old.value);
        if before == shown(&value.key, &value.value) {
            format!("as in {}", old.set_by)
        } else {
            format!("instead of {} from {}", short(&before), old.set_by)
        }
    });
    [measured.unwrap_or_default().to_owned(), replaced.unwrap_or_default()]
}

/// A value that its cell does not hold.
fn long(value: &ValueReport) -> Option<String> {
    let text = shown(&value.key, &value.value);
    (text.chars().count() > VALUE).then_some(text)
}

/// A value as a person reads it, with its unit where it is a figure.
fn shown(key: &str, value: &Value) -> String {
    match value {
        Value::Null => "none".to_owned(),
        Value::String(text) => text.clone(),
        Value::Bool(yes) => if *yes { "yes" } else { "no" }.to_owned(),
        Value::Number(number) => match unit(key) {
            "" => plain(number),
            "°" => format!("{}°", plain(number)),
            unit => format!("{} {unit}", plain(number)),
        },
        Value::Array(items) => list(items),
        Value::Object(_) => value.to_string(),
    }
}

/// A number as it was most likely written: `155`, not `155.0`.
fn plain(number: &serde_json::Number) -> String {
    number.as_f64().map_or_else(|| number.to_string(), |value| value.to_string())
}

/// A list of words, of springback pairs or of references.
fn list(items: &[Value]) -> String {
    let item = |item: &Value| match item {
        Value::String(text) => text.clone(),
        Value::Object(pair) if pair.contains_key("loss_deg") => {
            let angle = |key: &str| pair.get(key).and_then(Value::as_f64).unwrap_or_default();
            format!("{}→{}°", angle("angle_deg"), angle("loss_deg"))
        }
        // Of a publication its short name, of a body what it is called: the profile has the rest.
        Value::Object(named) => {
            let name = named.get("key").or_else(|| named.get("name")).and_then(Value::as_str);
            name.map_or_else(|| item.to_string(), str::to_owned)
        }
        other => other.to_string(),
    };
    items.iter().map(item).collect::<Vec<_>>().join(", ")
}

/// The unit that a key ends with.
fn unit(key: &str) -> &'static str {
    let word = key.rsplit('.').next().unwrap_or(key);
    let ends =
        |suffix: &str| word.strip_suffix(suffix).is_some_and(|rest| rest.is_empty() || rest.ends_with('_'));
    UNITS.into_iter().find(|(suffix, _)| ends(suffix)).map_or("", |(_, unit)| unit)
}

/// A text no wider than a cell.
fn short(text: &str) -> String {
    if text.chars().count() <= VALUE {
        return text.to_owned();
    }
    let kept: String = text.chars().take(VALUE - 1).collect();
    format!("{}…", kept.trim_end())
}

/// A text in lines of at most so many characters, broken between words; a longer word stands alone.
fn wrapped(text: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_figure_has_the_unit_of_its_key() {
        let value = serde_json::json!(25.0);
        for (key, expected) in [
            ("limits.min_feed_mm", "25 mm"),
            ("feed.rate_mm_per_s", "25 mm/s"),
            ("limits.max_bend_deg", "25°"),
            ("bend.rate_deg_per_s", "25 °/s"),
            ("time.fixed_per_bend_s", "25 s"),
            ("density_kg_per_m3", "25 kg/m³"),
            ("price_per_mm", "25 per mm"),
            ("k_factor", "25"),
            ("curvature.bias", "25"),
        ] {
            assert_eq!(shown(key, &value), expected, "{key}");
        }
    }

    #[test]
    fn lines_break_between_words_and_lose_none() {
        assert_eq!(wrapped("one two three", 8), ["one two", "three"]);
        assert_eq!(wrapped("extraordinary a", 5), ["extraordinary", "a"]);
        assert_eq!(short(&"x".repeat(40)).chars().count(), VALUE);
    }
}
