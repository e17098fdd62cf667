//! A design from more and more wires.

use std::io::Write;

use wirebend_api::{LeftOutReason, LeftOutWires, WiresResponse, WiresRow};

use super::compare::{collisions, cost, unknown};
use super::notes;
use super::number::{count, duration, mm};
use super::tables::aligned;

const HEAD: [&str; 9] =
    ["wires", "doubled", "doubled length", "length", "bends", "time", "stock", "cost", "in limits"];

pub(super) fn wires(out: &mut impl Write, found: &WiresResponse) -> std::io::Result<()> {
    notes(out, &found.notes)?;
    let searched = found.rows.iter().any(|row| row.search.is_some());
    let checked = searched || found.rows.iter().any(|row| row.side.collisions.is_some());
    // What was not asked for has no column.
    let further = |cells: [String; 2]| cells.into_iter().take(usize::from(checked) + usize::from(searched));
    let head = HEAD.map(str::to_owned).into_iter();
    let head = head.chain(further(["collisions", "program without"].map(str::to_owned)));
    let row = |row: &WiresRow| cells(row).into_iter().chain(further(of_collisions(row))).collect();
    let rows: Vec<Vec<String>> = std::iter::once(head.collect()).chain(found.rows.iter().map(row)).collect();
    aligned(out, &rows)?;
    found.left_out.iter().try_for_each(|numbers| writeln!(out, "{}", left_out(numbers)))
}

/// What the wires hit, and whether wires that hit nothing were found.
fn of_collisions(row: &WiresRow) -> [String; 2] {
    let search = match row.search.as_ref().map(|search| search.found) {
        Some(true) => "found",
        Some(false) => "not found",
        None => "not searched",
    };
    [collisions(&row.side), search.to_owned()]
}

/// Why numbers of wires have no row.
fn left_out(LeftOutWires { from, to, why }: &LeftOutWires) -> String {
    let numbers = match to {
        1 => "1 wire".to_owned(),
        _ if from == to => format!("{to} wires"),
        _ => format!("{from} to {to} wires"),
    };
    let enough = |enough: &usize| format!("{} {}", enough, if *enough == 1 { "is" } else { "are" });
    let why = match why {
        LeftOutReason::FewerThanParts { parts } => {
            format!("each of the {parts} parts of the design needs a wire")
        }
        LeftOutReason::SavesNothing { enough: wires } => {
            format!("{} enough, more save no doubled length", enough(wires))
        }
        LeftOutReason::NotNeeded { enough: wires } => {
            format!("{} enough for a program without collisions", enough(wires))
        }
        LeftOutReason::NothingFound { used } => {
            let what = "no program without collisions was found, and otherwise";
            format!("{what} {} enough", enough(used))
        }
    };
    format!("{numbers}: no row, {why}")
}

fn cells(row: &WiresRow) -> [String; 9] {
    let side = &row.side;
    let length = |length| format!("{} mm", mm(length));
    let stock_cost = side.stock_cost.zip(side.currency.as_deref());
    let stock_cost = stock_cost.map(|(cost, currency)| format!(" (stock {cost:.2} {currency})"));
    [
        row.wires.to_string(),
        row.doubled_edges.to_string(),
        length(row.doubled_mm),
        length(row.length_mm),
        side.bends.map_or_else(unknown, |bends| bends.to_string()),
        side.time_s.map_or_else(unknown, duration),
        side.stock_mm.map_or_else(unknown, length),
        cost(side) + &stock_cost.unwrap_or_default(),
        if side.feasible {
            "yes".to_owned()
        } else {
            format!("no, {}", count(side.errors, "error", "errors"))
        },
    ]
}
