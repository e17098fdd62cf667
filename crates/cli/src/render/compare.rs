//! One design on several machines.

use std::collections::BTreeMap;
use std::io::Write;

use wirebend_api::{CollisionCount, CompareResponse, Findings, MachineSide, OtherSide, WireDiagnostic};

use super::notes;
use super::number::{count, duration, mm};
use super::tables::aligned;

/// How many errors of a machine are listed before the rest is counted.
const TOLD: usize = 12;

pub(super) fn compare(out: &mut impl Write, found: &CompareResponse) -> std::io::Result<()> {
    notes(out, &found.notes)?;
    table(out, found)?;
    for other in &found.to {
        differences(out, &found.from, other, &other.side.machine)?;
        if let Some(own) = &other.own_wire {
            let name = format!("{} with {}", own.side.machine, own.side.material);
            differences(out, &found.from, own, &name)?;
        }
    }
    Ok(())
}

/// The other machines, each with its own wire beside it where that of the design does not fit.
fn columns(found: &CompareResponse) -> impl Iterator<Item = &OtherSide> {
    found.to.iter().flat_map(|other| [other].into_iter().chain(other.own_wire.as_deref()))
}

/// A row for each figure, a column for each machine.
fn table(out: &mut impl Write, found: &CompareResponse) -> std::io::Result<()> {
    let from = &found.from;
    let row = |label: &str,
               cell: &dyn Fn(&MachineSide) -> String,
               change: &dyn Fn(&OtherSide) -> Option<String>| {
        let others = columns(found).map(|other| {
            let change = change(other).map(|change| format!(" ({change})")).unwrap_or_default();
            format!("{}{change}", cell(&other.side))
        });
        [label.to_owned(), cell(from)].into_iter().chain(others).collect::<Vec<String>>()
    };
    let none = |_: &OtherSide| None;
    let number = |value: Option<usize>| value.map_or_else(unknown, |value| value.to_string());
    aligned(
        out,
        &[
            row("", &|side| side.machine.clone(), &none),
            row("wire", &|side| side.material.clone(), &none),
            row("in limits", &|side| if side.feasible { "yes" } else { "no" }.to_owned(), &none),
            row("errors", &|side| side.errors.to_string(), &|other| {
                Some(signed_count(from.errors, other.side.errors))
            }),
            row("collisions", &collisions, &none),
            row("feeds", &|side| number(side.feeds), &|other| {
                Some(signed_count(from.feeds?, other.side.feeds?))
            }),
            row("bends", &|side| number(side.bends), &|other| {
                other.change.bends.map(|bends| signed(&bends.abs().to_string(), bends < 0))
            }),
            row("time", &|side| side.time_s.map_or_else(unknown, duration), &|other| {
                other.change.time_s.map(|seconds| signed(&duration(seconds.abs()), seconds < 0.0))
            }),
            row(
                "stock",
                &|side| side.stock_mm.map_or_else(unknown, |stock| format!("{} mm", mm(stock))),
                &|other| {
                    other.change.stock_mm.map(|stock| signed(&format!("{} mm", mm(stock.abs())), stock < 0.0))
                },
            ),
            row("cost", &cost, &|other| {
                other.change.cost.map(|cost| signed(&format!("{:.2}", cost.abs()), cost < 0.0))
            }),
            row("stock cost", &stock_cost, &|other| {
                other.change.stock_cost.map(|cost| signed(&format!("{:.2}", cost.abs()), cost < 0.0))
            }),
            row("mass", &|side| side.mass_g.map_or_else(unknown, |mass| format!("{mass:.1} g")), &|other| {
                other.change.mass_g.map(|mass| signed(&format!("{:.1} g", mass.abs()), mass < 0.0))
            }),
        ],
    )
}

/// How many things the wire hits there, and whether that rests on estimates.
pub(super) fn collisions(side: &MachineSide) -> String {
    match side.collisions {
        None => "not checked".to_owned(),
        Some(CollisionCount { hits: 0, .. }) => "none".to_owned(),
        Some(CollisionCount { hits, estimated: 0 }) => hits.to_string(),
        Some(CollisionCount { hits, estimated }) if estimated == hits => format!("{hits}, estimated"),
        Some(CollisionCount { hits, estimated }) => format!("{hits}, {estimated} estimated"),
    }
}

pub(super) fn unknown() -> String {
    "unknown".to_owned()
}

pub(super) fn cost(side: &MachineSide) -> String {
    money(side.cost, side)
}

fn stock_cost(side: &MachineSide) -> String {
    money(side.stock_cost, side)
}

fn money(cost: Option<f64>, side: &MachineSide) -> String {
    let currency = side.currency.as_deref().unwrap_or_default();
    cost.map_or_else(unknown, |cost| format!("{cost:.2} {currency}").trim_end().to_owned())
}

fn signed_count(from: usize, to: usize) -> String {
    signed(&to.abs_diff(from).to_string(), to < from)
}

/// A difference with its sign; one that rounds to nothing has none.
fn signed(magnitude: &str, is_less: bool) -> String {
    if !magnitude.contains(|c: char| ('1'..='9').contains(&c)) {
        return "same".to_owned();
    }
    format!("{}{magnitude}", if is_less { "-" } else { "+" })
}

/// What is beyond the limits of a machine and within those of the first one, and the other way round.
fn differences(
    out: &mut impl Write,
    from: &MachineSide,
    other: &OtherSide,
    machine: &str,
) -> std::io::Result<()> {
    let (worse, better) = (&other.newly_infeasible, &other.newly_feasible);
    if worse.diagnostics.is_empty() && better.diagnostics.is_empty() {
        writeln!(out, "{machine}: no other errors than on {}", from.machine)?;
    }
    newly(out, worse, ["error", "errors"], [machine, &from.machine])?;
    newly(out, &other.newly_warned, ["warning", "warnings"], [machine, &from.machine])?;
    if !better.diagnostics.is_empty() {
        let errors = count(better.diagnostics.len(), "error", "errors");
        writeln!(out, "{machine}: without {errors} of {}: {}", from.machine, gone(better))?;
    }
    Ok(())
}

/// What a machine has that the first one has not; nothing of nothing.
fn newly(
    out: &mut impl Write,
    found: &Findings,
    [one, many]: [&str; 2],
    [machine, first]: [&str; 2],
) -> std::io::Result<()> {
    let all = &found.diagnostics;
    if all.is_empty() {
        return Ok(());
    }
    writeln!(out, "{machine}: {} that {first} does not have", count(all.len(), one, many))?;
    for found in all.iter().take(TOLD) {
        writeln!(out, "  {}: {}", place(found), found.diagnostic.message)?;
    }
    match all.len().saturating_sub(TOLD) {
        0 => Ok(()),
        more => writeln!(out, "  … and {more} more"),
    }
}

/// Where an error is, the thing that a person can point at first: of a length an edge, else a vertex.
fn place(found: &WireDiagnostic) -> String {
    let diagnostic = &found.diagnostic;
    let is_length = diagnostic.unit == Some("mm") && diagnostic.edge.is_some();
    match (diagnostic.vertex.filter(|_| !is_length), diagnostic.edge, diagnostic.step, found.wire) {
        (Some(vertex), ..) => format!("vertex {vertex}"),
        (None, Some(edge), ..) => format!("edge {edge}"),
        (None, None, Some(step), Some(wire)) => format!("step {} of wire {}", step + 1, wire + 1),
        (None, None, _, Some(wire)) => format!("wire {}", wire + 1),
        (None, None, _, None) => "design".to_owned(),
    }
}

/// Errors by code and where they were, in one line.
fn gone(findings: &Findings) -> String {
    let mut of_code: BTreeMap<&str, Vec<String>> = BTreeMap::new();
    for found in &findings.diagnostics {
        of_code.entry(found.diagnostic.code.as_str()).or_default().push(place(found));
    }
    let told = of_code.into_iter().map(|(code, places)| match places.len() {
        0..=3 => format!("{code} at {}", places.join(", ")),
        number => format!("{number} of {code}"),
    });
    told.collect::<Vec<_>>().join("; ")
}
