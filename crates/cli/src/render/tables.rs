//! Lists of machines and materials.

use std::io::Write;

use wirebend_api::{MachinesResponse, MaterialsResponse};

pub(super) fn machines(out: &mut impl Write, found: &MachinesResponse) -> std::io::Result<()> {
    let rows = found.machines.iter().map(|machine| {
        let [least, most] = machine.diameter_mm;
        [
            machine.id.clone(),
            format!("{:.0}..{:.0}°", machine.bend_deg[0], machine.bend_deg[1]),
            format!("{:.1} mm", machine.min_edge_mm),
            format!("{least}..{most} mm"),
            machine.native.as_ref().or(machine.formats.first()).cloned().unwrap_or_default(),
            machine.name.clone(),
        ]
    });
    table(out, ["id", "bends", "edges from", "wire", "own format", "name"], rows)
}

pub(super) fn materials(out: &mut impl Write, found: &MaterialsResponse) -> std::io::Result<()> {
    let rows = found.materials.iter().map(|material| {
        [
            material.id.clone(),
            format!("{} mm", material.diameter_mm),
            material.price_per_mm.map_or_else(
                || "unknown".to_owned(),
                |price| {
                    format!("{:.2} {}/m", price * 1000.0, material.currency.as_deref().unwrap_or_default())
                },
            ),
            if material.springback_measured { "measured" } else { "estimated" }.to_owned(),
            material.name.clone(),
        ]
    });
    table(out, ["id", "diameter", "price", "springback", "name"], rows)
}

pub(super) fn table<const N: usize>(
    out: &mut impl Write,
    head: [&str; N],
    rows: impl Iterator<Item = [String; N]>,
) -> std::io::Result<()> {
    let rows = std::iter::once(head.map(str::to_owned)).chain(rows).map(Vec::from);
    aligned(out, &rows.collect::<Vec<_>>())
}

/// Rows of equally many cells, each column as wide as its widest cell.
pub(super) fn aligned(out: &mut impl Write, rows: &[Vec<String>]) -> std::io::Result<()> {
    let columns = rows.first().map_or(0, Vec::len);
    let width = |column: usize| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns).map(width).collect();
    for row in rows {
        let cells = row.iter().zip(&widths).map(|(cell, width)| padded(cell, *width));
        writeln!(out, "{}", cells.collect::<Vec<_>>().join("  ").trim_end())?;
    }
    Ok(())
}

/// A text with spaces after it, up to a width.
pub(super) fn padded(text: &str, width: usize) -> String {
    format!("{text}{}", " ".repeat(width.saturating_sub(text.chars().count())))
}
