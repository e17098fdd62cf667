//! A design from more and more wires.

use std::io::Write;

use wirebend_api::{WiresResponse, WiresRow};

use super::compare::{cost, unknown};
use super::notes;
use super::number::{count, duration, mm};
use super::tables::table;

pub(super) fn wires(out: &mut impl Write, found: &WiresResponse) -> std::io::Result<()> {
    notes(out, &found.notes)?;
    let head =
        ["wires", "doubled", "doubled length", "length", "bends", "time", "stock", "cost", "in limits"];
    table(out, head, found.rows.iter().map(cells))
}

fn cells(row: &WiresRow) -> [String; 9] {
    let side = &row.side;
    let length = |length| format!("{} mm", mm(length));
    let stock_cost = row.stock_cost.zip(side.currency.as_deref());
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
