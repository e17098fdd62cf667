//! `calibrate new`: coupons as jobs that can be run, and a sheet for what is measured of them.

use std::path::PathBuf;

use nalgebra::{Point3, Vector3};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::bend::{Frame, program_of_path, replay};
use wirebend_core::calibrate::{Coupon, CouponPlan, Measured};
use wirebend_core::compensate::{BendModel, CompensatedProgram, compensate};
use wirebend_core::estimate::stock;
use wirebend_core::units::{Angle, Length};
use wirebend_core::wireframe::{Vertex, Wireframe};
use wirebend_files::document::{
    Document, DocumentError, Job, JobContents, JobStep, JobWire, ProfileSnapshot,
};
use wirebend_files::number::short;
use wirebend_files::read::{MeasuringSheet, SheetQuantity, SheetRow};
use wirebend_files::write::{CouponSheet, Paper, PrintedCoupon, PrintedReading, coupon_sheet};

use super::rounded::rounded;
use crate::export::paper;
use crate::machine::{Setup, deg, mm};
use crate::output::Output;
use crate::{Installation, PlanningError, Progress};

/// Angles of the ladder unless others are asked for: 7 to either side, which with sides and turns take about an hour.
const LADDER_DEG: [f64; 7] = [20.0, 40.0, 60.0, 80.0, 100.0, 120.0, 135.0];
/// The turn of the twist pair.
const TURN_DEG: f64 = 90.0;
/// A longer side shows the feed's scale four times as well.
const LONG_SIDE: f64 = 4.0;
/// Lengths are multiples of this, mm.
const MULTIPLE_MM: f64 = 5.0;
/// Angles that have one name, degrees.
const SAME_ANGLE_DEG: f64 = 0.01;
/// From coupon to coupon in the design, mm.
const APART_MM: f64 = 100.0;

#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct CalibrateNewRequest {
    /// The machine, by id.
    pub machine: String,
    /// The wire, by id; the one that the machine names if absent.
    pub material: Option<String>,
    /// Angles of the ladder, degrees; a usual set if empty.
    #[serde(default)]
    pub angles_deg: Vec<f64>,
    /// How often each coupon is bent.
    pub repeats: u32,
    /// Where jobs and sheet go. It is created where it is missing.
    pub folder: PathBuf,
    /// What the sheet is printed on, `a4` or `letter`; A4 if absent.
    #[serde(default)]
    pub paper: Option<String>,
    /// Whether files that are there may be replaced.
    #[serde(default)]
    pub force: bool,
}

#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct CalibrateNewResponse {
    pub machine: String,
    pub material: String,
    /// The table for what is measured.
    pub sheet: PathBuf,
    /// The sheet to print: a protractor in true size, and boxes for what is read.
    pub printed: PathBuf,
    /// The jobs; each of their wires is a coupon.
    pub jobs: Vec<PathBuf>,
    /// How many coupons there are, without their repeats.
    pub coupons: usize,
    pub repeats: u32,
    /// Wire that is fed for all of them, mm.
    pub wire_mm: f64,
    /// How long the machine bends, estimated, s.
    pub seconds: f64,
}

/// A coupon as a wire of a job.
struct Planned {
    name: String,
    coupon: Coupon,
    commanded: CompensatedProgram,
}

pub fn new(
    app: &Installation,
    request: &CalibrateNewRequest,
    progress: &dyn Progress,
) -> Result<CalibrateNewResponse, PlanningError> {
    progress.stage("planning coupons");
    let setup = app.setup(&request.machine, request.material.as_deref())?;
    if !(1..=20).contains(&request.repeats) {
        return Err(wrong("the number of repeats", request.repeats.to_string(), "a number from 1 to 20"));
    }
    let paper = request.paper.clone().map_or(Ok(Paper::default()), |name| paper(None, &name.into()))?;
    let plan = coupon_plan(&setup, &request.angles_deg)?;
    let mut jobs: [(&str, Vec<Planned>); 3] =
        [("angles", Vec::new()), ("sides", Vec::new()), ("turns", Vec::new())];
    for coupon in plan.coupons() {
        let (kind, name) = named(&coupon);
        let commanded = compensate(&coupon.program, &setup.model.compensation)
            .map_err(|_| wrong("a coupon", name.clone(), "one that the machine can bend"))?;
        let commanded = rounded(commanded, &setup)?;
        jobs[kind].1.push(Planned { name, coupon, commanded });
    }
    let sheet = MeasuringSheet {
        machine: setup.machine_id().to_owned(),
        material: setup.material_id().to_owned(),
        rows: jobs.iter().flat_map(|(_, wires)| wires).flat_map(|wire| rows(wire, request.repeats)).collect(),
        bent: Vec::new(),
        comments: Vec::new(),
        columns: Vec::new(),
    };
    let output = |name: &str| Output { path: request.folder.join(name), force: request.force };
    let written: Vec<_> = jobs.into_iter().filter(|(_, wires)| !wires.is_empty()).collect();
    let outputs: Vec<Output> = written.iter().map(|(name, _)| output(&format!("{name}.wbjob"))).collect();
    let sheet_output = output("sheet.csv");
    let printed_output = output("sheet.pdf");
    outputs.iter().chain([&sheet_output, &printed_output]).try_for_each(Output::check_overwrites)?;
    std::fs::create_dir_all(&request.folder).map_err(|error| {
        PlanningError::Document(DocumentError::Save { path: request.folder.display().to_string(), error })
    })?;
    progress.stage("writing");
    let all = || written.iter().flat_map(|(_, wires)| wires);
    let repeats = f64::from(request.repeats);
    let response = CalibrateNewResponse {
        machine: sheet.machine.clone(),
        material: sheet.material.clone(),
        sheet: sheet_output.path.clone(),
        printed: printed_output.path.clone(),
        jobs: outputs.iter().map(|output| output.path.clone()).collect(),
        coupons: all().count(),
        repeats: request.repeats,
        wire_mm: repeats * all().map(|wire| wire.commanded.feed_total().mm()).sum::<f64>(),
        seconds: repeats * all().map(|wire| setup.model.time.seconds(&wire.commanded)).sum::<f64>(),
    };
    for ((_, wires), output) in written.iter().zip(&outputs) {
        output.save(&job(&setup, wires)?.to_bytes()?)?;
    }
    sheet_output.save(sheet.to_text().as_bytes())?;
    let printed = CouponSheet {
        machine: setup.machine_name().to_owned(),
        material: setup.material_name().to_owned(),
        wire_diameter_mm: setup.model.wire.diameter.mm(),
        coupons: all().map(|wire| printed(&setup, wire)).collect(),
        repeats: request.repeats,
        paper,
    };
    printed_output.save(&coupon_sheet(&printed).bytes)?;
    Ok(response)
}

/// A coupon on the sheet that is printed.
fn printed(setup: &Setup, wire: &Planned) -> PrintedCoupon {
    // A person measures over the outside.
    let wanted = |row: &SheetRow| match row.quantity {
        SheetQuantity::Side => row.wanted + setup.model.wire.diameter.mm(),
        _ => row.wanted,
    };
    let reading = |row: &SheetRow| PrintedReading {
        what: row.quantity.word(),
        wanted: wanted(row),
        unit: if row.quantity == SheetQuantity::Side { " mm" } else { "°" },
        is_bend: row.quantity == SheetQuantity::Bend,
    };
    PrintedCoupon {
        name: wire.name.clone(),
        wire_mm: wire.commanded.feed_total().mm(),
        readings: rows(wire, 0).iter().map(reading).collect(),
    }
}

fn wrong(name: &'static str, value: String, expected: &'static str) -> PlanningError {
    PlanningError::Value { input: None, name, value, expected }
}

/// Coupons that a machine can bend.
fn coupon_plan(setup: &Setup, asked_deg: &[f64]) -> Result<CouponPlan, PlanningError> {
    let limits = &setup.model.limits;
    // A row of the table has one angle that the axis goes to, whose sign is the side.
    let bends = BendModel { before_zero: false, ..setup.model.compensation.bend.clone() };
    let can = |angle: Angle| {
        let within = angle <= limits.max_bend.value && -angle >= limits.min_bend.value;
        angle > Angle::ZERO && within && bends.command(angle).is_ok() && bends.command(-angle).is_ok()
    };
    let asked = asked_deg.iter().map(|&angle| deg(angle)).collect::<Result<Vec<_>, _>>()?;
    if let Some(angle) = asked.iter().find(|&&angle| !can(angle)) {
        let expected = "one that the machine can bend to both sides";
        return Err(wrong("an angle of the ladder", angle.to_string(), expected));
    }
    let twice = |k: usize| asked[..k].iter().any(|before| (*before - asked[k]).deg().abs() < SAME_ANGLE_DEG);
    if let Some(k) = (1..asked.len()).find(|&k| twice(k)) {
        let expected = "an angle that is not in the list yet: --repeats says how often each is bent";
        return Err(wrong("an angle of the ladder", asked[k].to_string(), expected));
    }
    let usual =
        || LADDER_DEG.iter().filter_map(|&angle| deg(angle).ok()).filter(|&angle| can(angle)).collect();
    let angles: Vec<Angle> = if asked.is_empty() { usual() } else { asked };
    // A right angle takes a bend radius from each end of its sides.
    let corner = setup.model.bend_radius.mm();
    let shortest = limits.min_edge.value.mm().max(limits.min_feed.value.mm() + 2.0 * corner);
    let round = |value: f64| mm((value / MULTIPLE_MM).ceil() * MULTIPLE_MM);
    let bend = &setup.machine.profile.bend;
    let plain =
        |stated: &Option<wirebend_profile::Sourced<f64>>| stated.as_ref().map_or(0.0, |stated| stated.value);
    // Nothing of the peg is farther from the pin than its whole orbit.
    let reach = match bends.setback {
        Some(_) => plain(&bend.orbit_offset_mm) + plain(&bend.orbit_radius_mm) + plain(&bend.rod_radius_mm),
        None => 0.0,
    };
    let side = round(shortest)?;
    let right = deg(90.0)?;
    let turn = deg(TURN_DEG)?;
    let room = setup.model.head.max;
    // Of a head that turns no farther, what comes before the first bend is taken off the turn.
    let turn = if room < turn + CouponPlan::LEAD { turn - CouponPlan::LEAD } else { turn };
    Ok(CouponPlan {
        angles,
        sides: if can(right) { vec![side, round(LONG_SIDE * side.mm())?] } else { Vec::new() },
        turn: (room >= turn + CouponPlan::LEAD && can(right)).then_some(turn),
        edge: round(shortest.max(reach + MULTIPLE_MM))?,
    })
}

/// Of which job a coupon is, and its name.
fn named(coupon: &Coupon) -> (usize, String) {
    let steps = &coupon.program.steps;
    match coupon.measured.first() {
        Some(&(step, Measured::Side)) => (1, format!("side-{}", short(steps[step].feed.mm(), 2))),
        Some(&(step, Measured::Turn { .. })) => (2, format!("turn-{}", short(steps[step].rotate.deg(), 2))),
        Some(&(step, Measured::Bend)) => (0, format!("angle-{}", short(steps[step].bend.deg(), 2))),
        None => (0, String::new()),
    }
}

/// The rows of a coupon.
fn rows(wire: &Planned, repeats: u32) -> Vec<SheetRow> {
    let steps = &wire.coupon.program.steps;
    let commanded = wire.commanded.steps();
    let row = |&(step, measured): &(usize, Measured)| {
        let (quantity, wanted, value) = match measured {
            Measured::Bend => (SheetQuantity::Bend, steps[step].bend.deg(), commanded[step].bend.deg()),
            Measured::Side => (SheetQuantity::Side, steps[step].feed.mm(), commanded[step].feed.mm()),
            Measured::Turn { reverses } => {
                let quantity = if reverses { SheetQuantity::TurnBack } else { SheetQuantity::Turn };
                (quantity, steps[step].rotate.deg(), commanded[step].rotate.deg())
            }
        };
        let axes = || [commanded[step - 1].bend.deg(), commanded[step].bend.deg()];
        SheetRow {
            line: 0,
            coupon: wire.name.clone(),
            quantity,
            wanted,
            commanded: value,
            axes_deg: (quantity == SheetQuantity::Side).then(axes),
            readings: vec![None; repeats as usize],
        }
    };
    wire.coupon.measured.iter().map(row).collect()
}

/// The job whose wires are coupons.
fn job(setup: &Setup, wires: &[Planned]) -> Result<Job, PlanningError> {
    let mut wireframe = Wireframe::new();
    let mut bent = Vec::with_capacity(wires.len());
    for (at, wire) in (0_i32..).zip(wires) {
        let from = Point3::new(0.0, 0.0, APART_MM * f64::from(at));
        let path = Frame::looking(from, Vector3::x(), Vector3::y())
            .map(|start| replay(start, &wire.coupon.program.steps))
            .unwrap_or_default();
        bent.push(job_wire(setup, wire, &path, &mut wireframe)?);
    }
    let snapshot = |id: &str, value| ProfileSnapshot { id: id.to_owned(), snapshot: value };
    Ok(Job::seal(JobContents {
        design_hash: Document::new(wireframe).design_hash()?,
        machine: snapshot(setup.machine_id(), serde_json::to_value(&setup.machine)?),
        material: snapshot(setup.material_id(), serde_json::to_value(&setup.material)?),
        wires: bent,
        objections: Vec::new(),
        program: None,
    })?)
}

fn job_wire(
    setup: &Setup,
    wire: &Planned,
    path: &[Point3<f64>],
    wireframe: &mut Wireframe,
) -> Result<JobWire, PlanningError> {
    let coupon = |()| wrong("a coupon", wire.name.clone(), "a path of finite points");
    let mut vertices = Vec::with_capacity(path.len());
    for &point in path {
        let id = wireframe.add_vertex(Vertex::at(point)).map_err(|_| coupon(()))?;
        if let Some(&before) = vertices.last() {
            wireframe.add_edge(before, id).map_err(|_| coupon(()))?;
        }
        vertices.push(id);
    }
    let (_, nominal) = program_of_path(path, setup.model.straight).map_err(|_| coupon(()))?;
    let steps = |steps: &[wirebend_core::bend::Step]| steps.iter().copied().map(JobStep::from).collect();
    Ok(JobWire {
        vertices: vertices.iter().map(|id| id.0).collect(),
        path_mm: path.iter().map(|point| [point.x, point.y, point.z]).collect(),
        nominal: steps(&nominal.steps),
        spans: nominal.spans.iter().map(|span| [span.start, span.end]).collect(),
        scheduled: steps(&wire.coupon.program.steps),
        compensated: wire.commanded.told().map(JobStep::from).collect(),
        stock_mm: stock(&wire.commanded, setup.model.limits.tail.value).mm(),
        time_s: setup.model.time.seconds(&wire.commanded),
        avoids_collisions: false,
        clearance_mm: None,
        sag: false,
        pauses: Vec::new(),
    })
}

/// What a side is read over its outside, from what it has from corner to corner: half a wire more at either end.
pub(super) fn over_outside(side: Length, diameter: Length) -> Length {
    side + diameter
}
