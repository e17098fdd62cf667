//! The job sheet: what a person takes to the machine, as PDF.

mod picture;
mod steps;

use wirebend_core::units::{Angle, DisplayUnit, Length};

use super::pdf::flow::{Flow, SMALL};
use super::pdf::{Canvas, Paper, Pdf, Pen, Type, document, letters};
use super::svg::PictureWire;
use crate::number::fixed;

/// What stands on a job sheet. Nothing is looked up or computed for it, the date included.
#[derive(Debug, Clone, PartialEq)]
pub struct JobSheet {
    /// The name of the design.
    pub title: String,
    /// The day, as it shall be read.
    pub date: Option<String>,
    pub design_hash: String,
    /// Hash of the job, where there is one.
    pub job_hash: Option<String>,
    /// Whether the machine can make it.
    pub feasible: bool,
    pub machine: String,
    /// The wire in it.
    pub material: String,
    /// What the plan was made with.
    pub figures: Vec<Figure>,
    pub wires: Vec<SheetWire>,
    /// What holds the struts together, and where: lines for people.
    pub joints: Vec<String>,
    /// What the checks say.
    pub findings: Vec<Finding>,
    /// Whether these are all: a job keeps no warnings of its plan.
    pub checked: bool,
    /// What is known of collisions: lines for people.
    pub collisions: Vec<String>,
    /// What was assumed or left out.
    pub notes: Vec<String>,
    /// What it is printed on.
    pub paper: Paper,
    /// What the lengths of the picture and of the steps as designed are written in. What the machine is sent is in mm.
    pub unit: DisplayUnit,
    /// How far a point may be from a plane for all of the wire to be flat: then it is drawn as seen straight from above.
    pub flat: Length,
    /// A bend up to this is none.
    pub straight: Angle,
}

/// A figure of a machine or of a wire.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Figure {
    pub name: String,
    /// Its value with its unit.
    pub value: String,
    pub source: String,
}

#[derive(Debug, Clone, PartialEq, Default)]
pub struct SheetWire {
    pub picture: PictureWire,
    /// What it takes: names and values with their units.
    pub facts: Vec<(String, String)>,
    pub steps: Vec<SheetStep>,
}

/// A step: feed in mm, rotation and bend in degrees.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SheetStep {
    pub designed: [f64; 3],
    /// As sent to the machine, in its signs; none if it could not be compensated.
    pub told: Option<[f64; 3]>,
    /// Whether the bend axis stops at zero or before it: the bend is to the other side than its sign.
    pub before_zero: bool,
    /// Wire that its feed gives, mm.
    pub fed_mm: f64,
}

/// What a check says.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Finding {
    /// How bad it is, in a word.
    pub severity: &'static str,
    /// What it is about.
    pub code: String,
    pub message: String,
    pub help: String,
}

/// Writes a job sheet: title, picture, what it takes, the figures with their sources, what the checks say, and every
/// step of every wire. The same sheet gives the same bytes.
#[must_use]
pub fn job_sheet(sheet: &JobSheet) -> Pdf {
    let mut flow = Flow::new(sheet.paper.size_mm());
    head(&mut flow, sheet);
    let height = flow.paper[1] * 0.3;
    let area = flow.take(height);
    for line in picture::draw(flow.page(), sheet, area) {
        flow.text(&line, SMALL);
    }
    for (index, wire) in sheet.wires.iter().enumerate() {
        facts(&mut flow, &numbered("Totals", index, sheet.wires.len()), &wire.facts);
    }
    joints(&mut flow, sheet);
    checks(&mut flow, sheet);
    figures(&mut flow, sheet);
    for (index, wire) in sheet.wires.iter().enumerate() {
        steps::table(&mut flow, &numbered("Steps", index, sheet.wires.len()), &wire.steps, sheet.unit);
    }
    let design = format!("design {}", short(&sheet.design_hash));
    let job = sheet.job_hash.as_ref().map(|hash| format!(", job {}", short(hash))).unwrap_or_default();
    let about = format!("{} ({design}{job})", sheet.title);
    document(&format!("{}: job sheet", sheet.title), flow.finish(&about))
}

fn head(flow: &mut Flow, sheet: &JobSheet) {
    let date = sheet.date.as_deref().unwrap_or_default();
    let kind = Type::new(6.0).bold();
    let room = flow.width() - SMALL.width(date) - 4.0;
    let [left, bottom, right, _] = flow.take(7.0);
    let title = letters::cut(&sheet.title, kind.size, true, room);
    flow.page().text([left, bottom], &title, kind);
    flow.page().text_to([right, bottom], date, SMALL);
    flow.gap(1.5);
    flow.text(&format!("{}  ·  {}", sheet.machine, sheet.material), Type::new(3.6));
    let job = match &sheet.job_hash {
        Some(hash) => format!("job {}", short(hash)),
        None => "plan, not a job yet".to_owned(),
    };
    flow.text(&format!("design {}  ·  {job}", short(&sheet.design_hash)), SMALL);
    if !sheet.feasible {
        flow.gap(1.0);
        flow.text("This cannot be bent as it is. See the checks.", Type::new(3.8).bold());
    }
    flow.gap(3.0);
}

/// Values under their names, four in a row.
fn facts(flow: &mut Flow, heading: &str, facts: &[(String, String)]) {
    flow.heading(heading, 12.0);
    let (name, value) = (SMALL, Type::new(3.8).bold());
    for row in facts.chunks(4) {
        let [left, bottom, right, _] = flow.take(10.0);
        let column = (right - left) / 4.0;
        let mut x = left;
        for (label, figure) in row {
            let room = column - 2.0;
            flow.page().text([x, bottom + 5.8], &letters::cut(label, name.size, false, room), name);
            flow.page().text([x, bottom + 1.2], &letters::cut(figure, value.size, true, room), value);
            x += column;
        }
    }
}

/// What is needed beside the wire; left out where nothing is.
fn joints(flow: &mut Flow, sheet: &JobSheet) {
    if sheet.joints.is_empty() {
        return;
    }
    flow.heading("Joints", 8.0);
    for line in &sheet.joints {
        flow.text(line, Type::new(3.2));
    }
}

fn checks(flow: &mut Flow, sheet: &JobSheet) {
    flow.heading("Checks", 8.0);
    if sheet.findings.is_empty() {
        let verdict = match (sheet.feasible, sheet.checked) {
            (true, true) => "No problems found.",
            (true, false) => {
                "No errors found. A job does not keep the warnings of its plan: check the design for them."
            }
            (false, _) => "See the notes.",
        };
        flow.text(verdict, Type::new(3.2));
    }
    if sheet.feasible {
        flow.text("Within the machine's limits.", Type::new(3.2));
    }
    for line in &sheet.collisions {
        flow.text(line, Type::new(3.2));
    }
    for finding in &sheet.findings {
        let Finding { severity, code, message, help } = finding;
        flow.text(&format!("{severity} [{code}]: {message}"), Type::new(3.2));
        if !help.is_empty() {
            flow.indented(&format!("help: {help}"), SMALL, 4.0);
        }
        flow.gap(0.8);
    }
    for note in &sheet.notes {
        flow.indented(&format!("note: {note}"), SMALL, 0.0);
    }
}

/// Name, value, and source in as many lines as it needs.
fn figures(flow: &mut Flow, sheet: &JobSheet) {
    flow.heading("Planned with", 10.0);
    let kind = Type::new(3.0);
    for Figure { name, value, source } in &sheet.figures {
        let width = flow.width();
        let (second, third) = (width * 0.27, width * 0.47);
        let column = |text: &str, room: f64| letters::lines(text, kind.size, false, room - 2.0);
        let columns = [column(name, second), column(value, third - second), column(source, width - third)];
        let rows = columns.iter().map(Vec::len).max().unwrap_or_default();
        for row in 0..rows {
            let [left, bottom, ..] = flow.take(kind.size * 1.35);
            for (lines, x) in columns.iter().zip([0.0, second, third]) {
                if let Some(line) = lines.get(row) {
                    let kind = if x >= third { kind.grey(0.3) } else { kind };
                    flow.page().text([left + x, bottom], line, kind);
                }
            }
        }
        flow.gap(0.7);
    }
}

fn numbered(heading: &str, index: usize, count: usize) -> String {
    if count > 1 { format!("{heading}: wire {} of {count}", index + 1) } else { heading.to_owned() }
}

/// The beginning of a hash, long enough to tell designs apart.
fn short(hash: &str) -> String {
    hash.chars().take(12).collect()
}
