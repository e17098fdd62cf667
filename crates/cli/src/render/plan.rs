//! Plans and what the checks say of them.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::io::Write;

use wirebend_api::{
    BestSoFar, CheckResponse, DiagnosticCode, DiagnosticReport, FoundSoFar, PlanReport, PlanResponse,
    RouteReport, SearchReport, SearchWeights, SeverityName, WireReport,
};

use super::number::{count, duration, mm};
use super::{notes, options, severity_style, written};

/// How many diagnostics of one code are listed before the rest is counted.
const TOLD: usize = 6;

pub(super) fn plan(out: &mut impl Write, found: &PlanResponse) -> std::io::Result<()> {
    notes(out, &found.notes)?;
    writeln!(out, "{} with {}", found.machine, found.material)?;
    let wires = found.report.wires();
    for (index, report) in wires.iter().enumerate() {
        if wires.len() > 1 {
            writeln!(out, "wire {}", index + 1)?;
        }
        wire(out, report, wires.len() == 1)?;
    }
    diagnostics(out, &found.report)?;
    if found.withheld {
        // A job holds what is sent to the machine, which a bend beyond its reach has not.
        let despite = wires.iter().all(|wire| wire.compensated.is_some());
        let or = if despite { ", or go on anyway with --despite-errors" } else { "" };
        let said = |diagnostic: &&DiagnosticReport| diagnostic.severity == SeverityName::Error;
        let is_search = |diagnostic: &DiagnosticReport| diagnostic.code == DiagnosticCode::NoClearProgram;
        let of_wires = wires.iter().flat_map(|wire| &wire.diagnostics);
        let mut errors = found.report.diagnostics().iter().chain(of_wires).filter(said);
        if errors.all(is_search) {
            writeln!(
                out,
                "no job was written: none without a collision was found; do what is said above{or}"
            )?;
        } else {
            writeln!(out, "no job was written: fix the errors above{or}")?;
        }
    }
    written(out, found.output.iter())
}

/// `alone`: whether it is the only wire, so that what is least of all wires is least of it.
fn walk(route: &RouteReport, alone: bool) -> String {
    let mut said = format!("{}, {} mm as designed", count(route.feeds, "feed", "feeds"), mm(route.length_mm));
    if route.doubled_edges > 0 {
        let edges = count(route.doubled_edges, "edge", "edges");
        let least = if route.optimal && alone { ", the least possible" } else { "" };
        let _ = write!(said, "; {edges} doubled, {} mm more{least}", mm(route.doubled_mm));
    }
    if !route.beside.is_empty() {
        let edges = count(route.beside.len(), "edge", "edges");
        let _ = write!(said, "; {edges} beside a wire before it, {} mm", mm(route.beside_mm));
    }
    said
}

fn wire(out: &mut impl Write, report: &WireReport, alone: bool) -> std::io::Result<()> {
    let wireframe = &report.wireframe;
    let line = |out: &mut dyn Write, label: &str, text: String| writeln!(out, "  {label:<11} {text}");
    line(
        out,
        "wireframe",
        format!(
            "{}, {}, {}",
            count(wireframe.vertices, "vertex", "vertices"),
            count(wireframe.edges, "edge", "edges"),
            count(wireframe.odd_vertices, "odd corner", "odd corners")
        ),
    )?;
    if let Some(route) = &report.route {
        line(out, "route", walk(route, alone))?;
    }
    if let Some(program) = &report.program {
        line(
            out,
            "program",
            format!(
                "{}, {}",
                count(program.steps.len(), "step", "steps"),
                count(program.bends, "bend", "bends")
            ),
        )?;
    }
    if let Some(compensated) = &report.compensated {
        line(
            out,
            "stock",
            format!(
                "{} mm: {} mm fed + {} mm unusable tail",
                mm(compensated.stock_mm),
                mm(compensated.feed_mm),
                mm(compensated.stock_mm - compensated.feed_mm)
            ),
        )?;
    }
    if let Some(sag) = report.sag {
        let joint = sag.joint.map_or_else(String::new, |joint| {
            format!(
                "; {:.1} mm off where step {} comes back to vertex {}",
                joint.off_mm,
                joint.step + 1,
                joint.vertex
            )
        });
        let words = format!(
            "{:.1} mm at the free end in step {}, under its own weight{joint}",
            sag.deflection_mm,
            sag.step + 1
        );
        line(out, "sags", words)?;
    }
    for pause in &report.pauses {
        line(out, "pauses", format!("after step {}: {}", pause.after, pause.note))?;
    }
    let mut figures = Vec::new();
    figures.extend(report.time_s.map(|seconds| format!("{} on the machine", duration(seconds))));
    let with_stock = |fed: String, stock: Option<String>| match stock {
        Some(stock) => format!("{fed} (stock {stock})"),
        None => fed,
    };
    let mass = |mass: f64| format!("{mass:.1} g");
    let price = |cost: f64| format!("{cost:.2} {}", report.currency.as_deref().unwrap_or_default());
    figures.extend(report.mass_g.map(|fed| with_stock(mass(fed), report.stock_mass_g.map(mass))));
    figures.extend(report.cost.map(|fed| with_stock(price(fed), report.stock_cost.map(price))));
    if !figures.is_empty() {
        line(out, "takes", figures.join(", "))?;
    }
    if let Some((energy, time)) = report.process_energy_kj.zip(report.process_time_min) {
        let words =
            format!("{energy:.2} kJ, {time:.1} min at 25 W, as Bend-Forming counts for forming the wire");
        line(out, "energy", words)?;
    }
    if let Some(search) = &report.search {
        let found =
            if search.found { "a program without collisions" } else { "no program without a collision" };
        let ended = if search.ended { "; ended by you" } else { "" };
        line(out, "search", format!("{found}; steps checked: {}{ended}", search.steps_checked))?;
        line(out, "prefers", objective(search))?;
    }
    Ok(())
}

/// By what a search has chosen.
fn objective(search: &SearchReport) -> String {
    let Some(SearchWeights { wire, doubled_mm, second }) = search.weights else {
        return "fewest wires, then the least doubled length, then the least time".to_owned();
    };
    let parts = [(wire, "wire"), (doubled_mm, "doubled mm"), (second, "second")];
    let parts = parts.into_iter().filter(|&(weight, _)| weight > 0);
    let parts: Vec<String> = parts.map(|(weight, what)| format!("{weight} for each {what}")).collect();
    format!("the least sum of {}", parts.join(", "))
}

pub(super) fn check(out: &mut impl Write, found: &CheckResponse) -> std::io::Result<()> {
    notes(out, &found.notes)?;
    let all: Vec<&DiagnosticReport> = found.diagnostics.iter().collect();
    list(out, &all)?;
    let machine = found.machine.as_deref().unwrap_or("any machine");
    let on = match &found.material {
        Some(material) => format!("{machine} with {material}"),
        None => machine.to_owned(),
    };
    let verdict = if !found.feasible {
        format!("cannot be bent on {on}")
    } else if found.machine.is_some() {
        format!("within the limits of {on}{}", unchecked(!found.collisions_checked))
    } else {
        "no error in the design".to_owned()
    };
    summary(out, &verdict, &all)
}

/// Everything that the checks say of a plan, and whether it is within the machine's limits.
pub(crate) fn diagnostics(out: &mut impl Write, report: &PlanReport) -> std::io::Result<()> {
    let of_wires = report.wires().iter().flat_map(|wire| &wire.diagnostics);
    let mut all: Vec<&DiagnosticReport> = report.diagnostics().iter().chain(of_wires).collect();
    all.sort_by_key(|diagnostic| diagnostic.severity as u8);
    list(out, &all)?;
    let checked = report.wires().iter().all(|wire| wire.collisions_checked);
    let verdict = if report.feasible() { "within the machine's limits" } else { "cannot be bent as it is" };
    summary(out, &format!("{verdict}{}", unchecked(report.feasible() && !checked)), &all)
}

/// That no limit is passed does not say that no part hits another.
const fn unchecked(unchecked: bool) -> &'static str {
    if unchecked { "; collisions not checked" } else { "" }
}

fn summary(out: &mut impl Write, verdict: &str, all: &[&DiagnosticReport]) -> std::io::Result<()> {
    let number = |severity| all.iter().filter(|diagnostic| diagnostic.severity == severity).count();
    let (errors, warnings) = (number(SeverityName::Error), number(SeverityName::Warning));
    writeln!(
        out,
        "{verdict}: {}, {}",
        count(errors, "error", "errors"),
        count(warnings, "warning", "warnings")
    )
}

/// Diagnostics, the first few of each code in full and the rest as a count.
fn list(out: &mut impl Write, all: &[&DiagnosticReport]) -> std::io::Result<()> {
    let mut of_code: BTreeMap<DiagnosticCode, usize> = BTreeMap::new();
    for diagnostic in all {
        *of_code.entry(diagnostic.code).or_default() += 1;
    }
    let mut told: BTreeMap<DiagnosticCode, usize> = BTreeMap::new();
    for diagnostic in all {
        let number = told.entry(diagnostic.code).or_default();
        *number += 1;
        if *number <= TOLD {
            one(out, diagnostic)?;
        }
        let total = of_code.get(&diagnostic.code).copied().unwrap_or_default();
        if *number == TOLD + 1 {
            writeln!(out, "  … and {} more of {}; --json lists all", total - TOLD, diagnostic.code)?;
        }
    }
    Ok(())
}

fn one(out: &mut impl Write, diagnostic: &DiagnosticReport) -> std::io::Result<()> {
    finding(out, diagnostic, "")
}

/// A finding with the source of its limit and what to do about it. `with`: what comes before the options that do it.
pub(super) fn finding(
    out: &mut impl Write,
    diagnostic: &DiagnosticReport,
    with: &str,
) -> std::io::Result<()> {
    let style = severity_style(diagnostic.severity);
    let severity = match diagnostic.severity {
        SeverityName::Error => "error",
        SeverityName::Warning => "warning",
        SeverityName::Info => "info",
    };
    let step = diagnostic.step.map(|step| format!(" step {}:", step + 1)).unwrap_or_default();
    writeln!(out, "{style}{severity}{style:#}[{}]:{step} {}", diagnostic.code, diagnostic.message)?;
    if let Some(source) = &diagnostic.limit_source {
        writeln!(out, "    limit from {source}")?;
    }
    if diagnostic.severity != SeverityName::Info && !diagnostic.help.is_empty() {
        let options = options::of(&diagnostic.remedies);
        let by = if options.is_empty() { String::new() } else { format!(" [{with}{}]", options.join(", ")) };
        writeln!(out, "    help: {}{by}", diagnostic.help)?;
    }
    Ok(())
}

/// What a search says of itself once it has found something, or goes on with another part; none while its name says it all.
pub(crate) fn found_so_far(&FoundSoFar { part, parts, best }: &FoundSoFar) -> Option<String> {
    let several = parts > 1;
    let of_part = if several { format!("part {part} of {parts}: ") } else { String::new() };
    // Parts that come later are not searched then.
    let stop = if several { "Ctrl-C ends the search" } else { "Ctrl-C takes it" };
    match best {
        None => several.then(|| format!("{of_part}searching for a program without collisions ({stop})")),
        Some(BestSoFar { wires, doubled_mm }) => {
            let doubled = mm(doubled_mm);
            let doubled = if doubled == mm(0.0) { String::new() } else { format!(", {doubled} mm doubled") };
            let wires = count(wires, "wire", "wires");
            Some(format!("{of_part}found {wires}{doubled}, looking for better ({stop})"))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_search_says_what_ctrl_c_takes_and_of_several_parts_that_it_ends_all() {
        let best = |wires, doubled_mm| Some(BestSoFar { wires, doubled_mm });
        let said = |part, parts, best| found_so_far(&FoundSoFar { part, parts, best });
        assert_eq!(said(1, 1, None), None, "its name says it");
        assert_eq!(
            said(1, 1, best(2, 24.0)).unwrap(),
            "found 2 wires, 24.0 mm doubled, looking for better (Ctrl-C takes it)"
        );
        assert_eq!(said(1, 1, best(1, 0.01)).unwrap(), "found 1 wire, looking for better (Ctrl-C takes it)");
        assert_eq!(
            said(2, 3, None).unwrap(),
            "part 2 of 3: searching for a program without collisions (Ctrl-C ends the search)"
        );
        assert_eq!(
            said(2, 3, best(1, 0.0)).unwrap(),
            "part 2 of 3: found 1 wire, looking for better (Ctrl-C ends the search)"
        );
    }
}
