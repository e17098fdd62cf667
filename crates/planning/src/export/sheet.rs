//! The job sheet: what is known of a plan or of a job, in words and numbers for a person.

use wirebend_core::checks::Diagnostic;
use wirebend_core::units::{DisplayUnit, Length, Mm};
use wirebend_files::number::short;
use wirebend_files::write::{Figure, Finding, JobSheet, SheetStep, SheetWire, job_sheet};
use wirebend_profile::{Profile as _, Sourced, Springback};

use super::content::{Content, Wire};
use super::joints;
use super::print::{Print, letters_replaced};
use super::template::lies_flat;
use crate::job::JobCollisions;
use crate::machine::Setup;
use crate::pauses;
use crate::report::{DiagnosticReport, PlanReport, SeverityName};
use crate::text;

/// A job sheet as PDF.
pub(super) fn encode(content: &mut Content, print: &Print) -> Vec<u8> {
    let sheet = text::kept_in(print.unit, || sheet(content, print));
    content.feasible = sheet.feasible;
    let pdf = job_sheet(&sheet);
    content.notes.extend(letters_replaced(&pdf.missing));
    pdf.bytes
}

fn sheet(content: &Content, print: &Print) -> JobSheet {
    let setup = &content.setup;
    let Known { found, collides, lines: collisions } = collisions(content, print.unit);
    let mut findings = content.report.as_deref().map(findings).unwrap_or_default();
    findings.extend(found);
    JobSheet {
        title: content.title.clone(),
        date: Some(print.date()),
        design_hash: content.design_hash.clone(),
        job_hash: content.job_hash.clone(),
        // Whoever holds the sheet is told the same as who checks, exports or arms: a collision that is an error is one here too.
        feasible: content.feasible && !collides,
        machine: format!("{} [{}]", setup.machine_name(), setup.machine_id()),
        material: format!("{} [{}]", setup.material_name(), setup.material_id()),
        figures: figures(setup, print.unit),
        wires: content.wires.iter().map(|wire| sheet_wire(setup, wire)).collect(),
        joints: joints::lines(&content.joints),
        findings,
        checked: content.report.is_some(),
        collisions,
        notes: content.notes.iter().map(|note| note.message.clone()).chain(pauses(content)).collect(),
        paper: print.paper,
        unit: print.unit,
        flat: lies_flat(setup.model.wire.diameter),
        straight: setup.model.straight,
    }
}

/// What is known of the collisions of the wires.
#[derive(Default)]
struct Known {
    /// Those that are not among the findings of the plan already.
    found: Vec<Finding>,
    /// Whether one of these is an error.
    collides: bool,
    /// What is said of wires of which none are known.
    lines: Vec<String>,
}

fn collisions(content: &Content, unit: DisplayUnit) -> Known {
    let several = content.wires.len() > 1;
    let report = content.report.as_deref();
    let looked = |index: usize| {
        report.and_then(|report| report.wires().get(index)).is_some_and(|wire| wire.collisions_checked)
    };
    let mut known = Known::default();
    for (index, wire) in content.wires.iter().enumerate() {
        let (named, of) = if several {
            (format!("wire {}, ", index + 1), format!("wire {}: ", index + 1))
        } else {
            Default::default()
        };
        let said = match &wire.kept {
            Some(kept) => {
                let collisions = JobCollisions::of(kept, &content.setup);
                if !looked(index) {
                    let found = collisions.findings();
                    known.collides |= found.iter().any(Diagnostic::is_error);
                    let found = found.iter().map(DiagnosticReport::from);
                    known.found.extend(found.map(|found| finding(&named, &found)));
                }
                // What was found stands among the findings.
                text::kept_in(unit, || collisions.otherwise())
            }
            None => vec!["collisions are not checked: there is no compensated program".to_owned()],
        };
        known.lines.extend(said.into_iter().map(|line| sentence(&format!("{of}{line}"))));
    }
    known
}

/// Where the machine waits for a person.
fn pauses(content: &Content) -> impl Iterator<Item = String> {
    let several = content.wires.len() > 1;
    let of_wire = move |(index, wire): (usize, &Wire)| {
        let pauses = wire.kept.as_ref().map(|kept| kept.pauses.clone()).unwrap_or_default();
        let of = if several { format!("wire {}: ", index + 1) } else { String::new() };
        let lines: Vec<String> =
            pauses::lines(&pauses).map(|line| sentence(&format!("{of}{line}"))).collect();
        lines
    };
    content.wires.iter().enumerate().flat_map(of_wire)
}

/// A line of a list as a sentence.
fn sentence(line: &str) -> String {
    let mut letters = line.chars();
    let first = letters.next().map(|first| first.to_uppercase().to_string()).unwrap_or_default();
    format!("{first}{}.", letters.as_str())
}

fn sheet_wire(setup: &Setup, wire: &Wire) -> SheetWire {
    let length: Length = wire.nominal.iter().map(|step| step.feed).sum();
    let commanded = |index: usize| wire.compensated.as_ref()?.get(index).map(|told| told.step);
    let told = |index: usize| {
        let step = setup.signs.machine(commanded(index)?);
        Some([step.feed_mm, step.rotate_deg, step.bend_deg])
    };
    let other_side = |index: usize| {
        let told = wire.compensated.as_ref().and_then(|steps| steps.get(index));
        told.is_some_and(|told| told.bends() && told.beyond_zero() <= 0.0)
    };
    let fed = |index: usize| commanded(index).map(|step| setup.model.compensation.motion.fed(step.feed).mm());
    let steps = wire.nominal.iter().enumerate().map(|(index, step)| SheetStep {
        designed: [step.feed.mm(), step.rotate.deg(), step.bend.deg()],
        told: told(index),
        before_zero: other_side(index),
        fed_mm: fed(index).unwrap_or(step.feed.mm()),
    });
    SheetWire { picture: wire.picture(), facts: facts(setup, wire, length), steps: steps.collect() }
}

/// What a wire takes. What is not known is said to be so.
fn facts(setup: &Setup, wire: &Wire, length: Length) -> Vec<(String, String)> {
    let unknown = || "not known".to_owned();
    let model = &setup.model.wire;
    let motion = &setup.model.compensation.motion;
    let fed =
        wire.compensated.as_ref().map(|steps| motion.fed(steps.iter().map(|told| told.step.feed).sum()));
    let stock = wire.stock_mm.and_then(|stock| Length::from_mm(stock).ok());
    let tail = Some(setup.model.limits.tail.value);
    let cost = |length: Option<Length>| {
        model.cost(length?).map(|cost| match &setup.currency {
            Some(currency) => format!("{cost:.2} {currency}"),
            None => format!("{cost:.2}"),
        })
    };
    let mass = |length: Option<Length>| length.map(|length| format!("{:.1} g", model.mass_g(length)));
    let fact = |name: &str, value: Option<String>| (name.to_owned(), value.unwrap_or_else(unknown));
    // Four in a row: what is fed, what is lost and what both take stand under each other.
    vec![
        fact("wire fed", fed.map(|fed| fed.to_string())),
        fact("unusable tail", tail.map(|tail| tail.to_string())),
        fact("stock length", stock.map(|stock| stock.to_string())),
        fact("designed length", Some(length.to_string())),
        fact("cost, fed wire", cost(fed)),
        fact("cost, unusable tail", cost(tail)),
        fact("cost, stock", cost(stock)),
        fact("bends", Some(wire.bend_count().to_string())),
        fact("mass, fed wire", mass(fed)),
        fact("mass, unusable tail", mass(tail)),
        fact("mass, stock", mass(stock)),
        fact("machine time", wire.time_s.map(duration)),
    ]
}

/// Figures of the machine and of the wire, with their sources as the profiles have them.
/// The largest angle to either side: one figure where both are the same.
fn two_sided(min: Option<&Sourced<f64>>, max: f64) -> String {
    match min.map(|min| min.value) {
        Some(min) if (min + max).abs() > 1e-9 => format!("{min}° to {max}°"),
        _ => format!("{max}°"),
    }
}

fn figures(setup: &Setup, unit: DisplayUnit) -> Vec<Figure> {
    let (machine, material) = (&setup.machine.profile, &setup.material.profile);
    let (of_machine, of_material) = (machine.id(), material.id());
    let figure = |profile: &str, name: &str, stated: &Option<Sourced<f64>>, value: &dyn Fn(f64) -> String| {
        let stated = stated.as_ref()?;
        let source = format!("{}{} [{profile}]", how(stated.measured), stated.source);
        Some(Figure { name: name.to_owned(), value: value(stated.value), source })
    };
    let (limits, bend) = (&machine.limits, &machine.bend);
    let radius = Figure {
        name: "centreline radius of bends".to_owned(),
        value: format!("{:.2}", setup.model.bend_radius),
        source: "derived: pin radius plus half the wire diameter".to_owned(),
    };
    let (length, speed) = (|mm: f64| Mm(mm).to_string(), |mm: f64| format!("{}/s", Mm(mm)));
    let (angle, turning) = (|deg: f64| format!("{deg}°"), |deg: f64| format!("{deg}°/s"));
    let price = |per_mm: f64| format!("{}{}", per_length(per_mm, unit), price_unit(setup));
    let priced = match unit {
        DisplayUnit::Millimetre => "price per mm",
        DisplayUnit::Inch => "price per inch",
    };
    [
        figure(of_material, "wire diameter", &material.diameter_mm, &length),
        figure(of_machine, "pin radius", &bend.pin_radius_mm, &length),
        Some(radius),
        figure(of_material, "K-factor", &material.k_factor, &|k| k.to_string()),
        springback(setup),
        figure(of_machine, "largest bend", &limits.max_bend_deg, &|max| {
            two_sided(limits.min_bend_deg.as_ref(), max)
        }),
        figure(of_machine, "range of the bend axis", &bend.axis_limit_deg, &angle),
        figure(of_machine, "range of the head", &limits.max_rotation_deg, &|max| {
            two_sided(limits.min_rotation_deg.as_ref(), max)
        }),
        figure(of_machine, "minimum feed", &limits.min_feed_mm, &length),
        figure(of_machine, "maximum feed", &limits.max_feed_mm, &length),
        figure(of_machine, "unusable tail", &limits.tail_mm, &length),
        figure(of_machine, "feed speed", &machine.feed.rate_mm_per_s, &speed),
        figure(of_machine, "rotate speed", &machine.rotate.rate_deg_per_s, &turning),
        figure(of_machine, "bend speed", &bend.rate_deg_per_s, &turning),
        figure(of_machine, "overhead of each bend", &machine.time.fixed_per_bend_s, &|s| format!("{s} s")),
        figure(of_machine, "overhead of each feed", &machine.time.fixed_per_feed_s, &|s| format!("{s} s")),
        figure(of_machine, "overhead of each turn", &machine.time.fixed_per_turn_s, &|s| format!("{s} s")),
        figure(of_material, "density", &material.density_kg_per_m3, &|d| format!("{d} kg/m³")),
        figure(of_material, priced, &material.price_per_mm, &price),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// A price for each millimetre as one for each of a unit.
fn per_length(per_mm: f64, unit: DisplayUnit) -> String {
    match unit {
        DisplayUnit::Millimetre => per_mm.to_string(),
        DisplayUnit::Inch => short(per_mm * 25.4, 6),
    }
}

fn price_unit(setup: &Setup) -> String {
    setup.currency.as_ref().map(|currency| format!(" {currency}")).unwrap_or_default()
}

fn springback(setup: &Setup) -> Option<Figure> {
    let (value, measured, source) = match setup.material.profile.springback.as_ref()? {
        Springback::Constant { angle_deg } => {
            (format!("{}°", angle_deg.value), angle_deg.measured, &angle_deg.source)
        }
        Springback::Table { positive, source, measured, .. } => {
            (format!("by a table of {} angles", positive.len()), *measured, source)
        }
    };
    let by_us = setup.model.compensation.bend.springback.is_some();
    let whose = if by_us { "" } else { "not used: the machine compensates itself; " };
    let source = format!("{whose}{}{source} [{}]", how(measured), setup.material_id());
    Some(Figure { name: "springback".to_owned(), value, source })
}

const fn how(measured: bool) -> &'static str {
    if measured { "measured: " } else { "not measured: " }
}

fn findings(report: &PlanReport) -> Vec<Finding> {
    let several = report.wires().len() > 1;
    let of_wires = report.wires().iter().enumerate().flat_map(|(index, wire)| {
        let of = if several { format!("wire {}, ", index + 1) } else { String::new() };
        wire.diagnostics.iter().map(move |diagnostic| finding(&of, diagnostic))
    });
    report.diagnostics().iter().map(|diagnostic| finding("", diagnostic)).chain(of_wires).collect()
}

fn finding(of: &str, diagnostic: &DiagnosticReport) -> Finding {
    let limit = diagnostic.limit_source.as_ref().map(|source| format!(" (limit from {source})"));
    Finding {
        severity: match diagnostic.severity {
            SeverityName::Error => "error",
            SeverityName::Warning => "warning",
            SeverityName::Info => "info",
        },
        code: diagnostic.code.to_string(),
        message: format!("{of}{}{}", diagnostic.message, limit.unwrap_or_default()),
        help: diagnostic.help.clone(),
    }
}

/// A time as hours, minutes and seconds, from the largest that is needed.
fn duration(seconds: f64) -> String {
    let whole = seconds.max(0.0).round();
    let (hours, minutes, seconds) = ((whole / 3600.0).floor(), (whole / 60.0).floor() % 60.0, whole % 60.0);
    match (hours > 0.0, minutes > 0.0) {
        (true, _) => format!("{hours} h {minutes:02} min"),
        (false, true) => format!("{minutes} min {seconds:02} s"),
        (false, false) => format!("{seconds} s"),
    }
}
