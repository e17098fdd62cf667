//! The table of steps.

use super::{DisplayUnit, Flow, Pen, SMALL, SheetStep, Type, fixed};
use crate::number::{length_in, unit_name};

const ROW: f64 = 4.4;
const LETTERS: Type = Type { size: 3.0, bold: false, grey: 0.0 };
/// Where the columns end, as fractions of the width: number, three as designed, three as sent to the machine, and the length fed so far.
const ENDS: [f64; 8] = [0.06, 0.20, 0.33, 0.46, 0.61, 0.74, 0.87, 1.0];
/// Decimals of lengths, in millimetres and in inches.
const DECIMALS: [usize; 2] = [3, 4];

/// Every step, with the names of the columns on each page.
pub(super) fn table(flow: &mut Flow, heading: &str, steps: &[SheetStep], unit: DisplayUnit) {
    flow.heading(heading, 2.0 * ROW + 6.0);
    flow.text("Feed, then rotate, then bend. Rotations and bends as sent to the machine are in its own signs. Run: the wire fed by the end of the step.", SMALL);
    if steps.iter().any(|step| step.before_zero) {
        flow.text("Before zero: the bend axis stops on the side from which it bends.", SMALL);
    }
    flow.gap(1.0);
    names(flow, unit);
    let mut run = 0.0;
    for (index, step) in steps.iter().enumerate() {
        if !flow.fits(ROW) {
            flow.next_page();
            names(flow, unit);
        }
        run += step.fed_mm;
        let three = |values: [f64; 3]| values.map(|value| fixed(value, 3));
        let [feed, rotate, bend] = step.designed;
        let designed = [length_in(unit, feed, DECIMALS), fixed(rotate, 3), fixed(bend, 3)];
        let mut told = step.told.map_or_else(|| ["–", "–", "–"].map(str::to_owned), three);
        if step.before_zero {
            told[2].insert_str(0, "before zero ");
        }
        let mut cells = vec![(index + 1).to_string()];
        cells.extend(designed);
        cells.extend(told);
        cells.push(length_in(unit, run, DECIMALS));
        let [left, bottom, right, top] = flow.take(ROW);
        if index % 2 == 1 {
            flow.page().fill([left, bottom, right, top], 0.95);
        }
        for (cell, end) in cells.iter().zip(ENDS) {
            let x = left + (right - left) * end - 1.0;
            flow.page().text_to([x, bottom + 1.2], cell, LETTERS);
        }
    }
}

/// Two rows of headings. The machine is sent millimetres, whatever a person reads.
fn names(flow: &mut Flow, unit: DisplayUnit) {
    let [left, bottom, right, _] = flow.take(2.0 * ROW);
    let kind = LETTERS.bold();
    let at = |end: f64| left + (right - left) * end - 1.0;
    let sent = match unit {
        DisplayUnit::Millimetre => "as sent to the machine",
        DisplayUnit::Inch => "as sent to the machine, in mm",
    };
    for (group, first, last) in [("as designed", 0, 3), (sent, 3, 6)] {
        flow.page().text_to([at(ENDS[last]), bottom + ROW + 1.0], group, SMALL);
        flow.page().line(
            [at(ENDS[first]) + 3.0, bottom + ROW],
            [at(ENDS[last]), bottom + ROW],
            Pen::new(0.15, 0.6),
        );
    }
    let (feed, run) = (format!("feed {}", unit_name(unit)), format!("run {}", unit_name(unit)));
    let names = ["n", &feed, "rotate °", "bend °", "feed mm", "rotate °", "bend °", &run];
    for (name, end) in names.into_iter().zip(ENDS) {
        flow.page().text_to([at(end), bottom + 1.0], name, kind);
    }
    flow.page().line([left, bottom], [right, bottom], Pen::new(0.2, 0.0));
}
