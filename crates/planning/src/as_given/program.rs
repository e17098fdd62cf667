//! A program of a machine's own format as a job: it is run as it stands, and nothing of it is compensated.

use std::collections::BTreeMap;
use std::path::PathBuf;

use nalgebra::{Point3, Vector3};
use wirebend_core::bend::{Frame, Step, replay};
use wirebend_core::compensate::CompensatedProgram;
use wirebend_core::estimate::stock;
use wirebend_core::units::Length;
use wirebend_files::document::{Job, JobContents, JobStep, JobWire, ProfileSnapshot, SourceFile, sha256_hex};
use wirebend_files::read::{Format, ReadError, decode};

use super::GivenWires;
use crate::design::{DesignInput, Opened};
use crate::job::{is_job, open_job};
use crate::machine::Setup;
use crate::output::file_name;
use crate::program::ProgramKind;
use crate::turning_back::corner_to_corner;
use crate::{Installation, PlanningError, text};

/// A feed that stands for none at all, mm: two bends at one place have their directions by it. Too small
/// to see; its ends are two vertices all the same.
const HAIR_MM: f64 = 0.002;

/// For which machine and wire a program is, which it does not say itself.
#[derive(Debug, Clone, Copy, Default)]
pub struct ProgramMachine<'a> {
    pub machine: Option<&'a str>,
    /// Absent, the one that the machine's profile names.
    pub material: Option<&'a str>,
}

/// The job of a file: a sealed one as it is, and of a program in the format of its machine one that runs it as it stands.
pub fn job_of_file(
    app: &Installation,
    name: &str,
    bytes: &[u8],
    of: ProgramMachine,
) -> Result<Job, PlanningError> {
    if is_job(name, bytes) || decode(bytes).trim().is_empty() {
        return open_job(name, bytes);
    }
    let not_a_job = || PlanningError::NotAJob { name: name.to_owned() };
    let opened = read(name, bytes).map_err(|error| match error {
        // What is nothing else is no job either.
        PlanningError::Read(ReadError::UnknownFormat { .. })
        | PlanningError::Settled { .. }
        | PlanningError::WithoutEffect { .. } => not_a_job(),
        PlanningError::Read(ReadError::GCode { .. }) => PlanningError::GCodeToRun { name: name.to_owned() },
        error => error,
    })?;
    if opened.program.is_none() || opened.format == Format::Moves {
        return Err(not_a_job());
    }
    let machine = of.machine.ok_or_else(|| PlanningError::NoMachine { known: app.machine_ids() })?;
    let setup = app.setup(machine, of.material)?;
    require_own(&opened, &setup)?;
    of_program(name, bytes, &opened, &setup)
}

/// Recorded moves as a job of the machine that they were recorded on, so that they can be shown. They are run by replaying them.
pub fn job_of_moves(
    app: &Installation,
    name: &str,
    bytes: &[u8],
    of: ProgramMachine,
) -> Result<Job, PlanningError> {
    let opened = read(name, bytes)?;
    let recorded = opened.recorded_on().ok_or_else(|| PlanningError::NotAJob { name: name.to_owned() })?;
    let material = of.material.filter(|_| of.machine == Some(recorded));
    let setup = app.setup(recorded, material)?;
    of_program(name, bytes, &opened, &setup)
}

fn read(name: &str, bytes: &[u8]) -> Result<Opened, PlanningError> {
    let input = DesignInput { program: Some(ProgramKind::Compensated), ..DesignInput::file(PathBuf::new()) };
    input.open_bytes(name.to_owned(), bytes, None)
}

/// Refuses a program of another machine's format: its numbers mean something else there.
fn require_own(opened: &Opened, setup: &Setup) -> Result<(), PlanningError> {
    let own = setup.machine.profile.export.native.clone();
    let format = opened.format.written_as();
    if format.is_some() && format == own.as_deref() {
        return Ok(());
    }
    Err(PlanningError::FormatOfAnother {
        format: format.unwrap_or(opened.format.name()).to_owned(),
        machine: setup.machine_id().to_owned(),
        known: own.into_iter().collect(),
    })
}

fn of_program(name: &str, bytes: &[u8], opened: &Opened, setup: &Setup) -> Result<Job, PlanningError> {
    let program = opened.program.as_ref().ok_or_else(|| PlanningError::NotAJob { name: name.to_owned() })?;
    let told = program.commanded(setup.signs)?;
    let hair = Length::from_mm(HAIR_MM).unwrap_or_default();
    let mut shape: Vec<Step> = corner_to_corner(&told, setup);
    for step in &mut shape {
        step.feed = if step.feed < hair { hair } else { step.feed };
    }
    let path = replay(Frame::default(), &shape);
    let commanded = CompensatedProgram::from_job_steps(told, &setup.model.compensation);
    let steps: Vec<JobStep> = shape.iter().copied().map(JobStep::from).collect();
    let wire = JobWire {
        vertices: vertices(&path, setup.model.wire.diameter.mm() / 2.0),
        path_mm: path.iter().map(|point| [point.x, point.y, point.z]).collect(),
        nominal: steps.clone(),
        spans: (0..steps.len()).map(|k| [k, k + 1]).collect(),
        scheduled: steps,
        stock_mm: stock(&commanded, setup.model.limits.tail.value).mm(),
        time_s: setup.model.time.seconds(&commanded),
        compensated: commanded.told().map(JobStep::from).collect(),
        avoids_collisions: false,
        clearance_mm: None,
        sag: false,
        pauses: Vec::new(),
    };
    let snapshot = |id: &str, value| ProfileSnapshot { id: id.to_owned(), snapshot: value };
    let sha256 = sha256_hex(bytes);
    let contents = JobContents {
        // It has no design: what it was made from is the program itself.
        design_hash: sha256.clone(),
        machine: snapshot(setup.machine_id(), serde_json::to_value(&setup.machine)?),
        material: snapshot(setup.material_id(), serde_json::to_value(&setup.material)?),
        wires: vec![wire],
        objections: Vec::new(),
        program: Some(SourceFile { file: file_name(std::path::Path::new(name)), sha256 }),
    };
    let checked = GivenWires::of(name, &Job::seal(contents.clone())?, setup)?;
    let errors = checked.findings().filter(|finding| finding.is_error());
    let objections = text::kept(|| errors.map(text::message).collect());
    Ok(Job::seal(JobContents { objections, ..contents })?)
}

/// An id for each point of a path. Points that lie within `reach` mm of each other are one: the numbers of a program are rounded, and
/// where the middles of wires come closer than half of the wire they are joined. Points that only follow each other closely, as along a
/// curve, are not: between the visits of a joint the wire goes away from it and back.
fn vertices(path: &[Point3<f64>], reach: f64) -> Vec<u32> {
    let cell = |point: &Point3<f64>| point.coords.map(|mm| (mm / reach).floor());
    let key = |cell: Vector3<f64>| [cell.x, cell.y, cell.z].map(f64::to_bits);
    let around = [-1.0, 0.0, 1.0];
    let around = around.into_iter().flat_map(|x| around.into_iter().map(move |y| (x, y)));
    let around: Vec<_> = around.flat_map(|(x, y)| [-1.0, 0.0, 1.0].map(|z| Vector3::new(x, y, z))).collect();
    let mut known: Vec<Point3<f64>> = Vec::new();
    let mut cells: BTreeMap<[u64; 3], Vec<usize>> = BTreeMap::new();
    let mut order: Vec<usize> = Vec::new();
    // How far along the wire each of them was met last.
    let (mut along, mut met): (f64, Vec<f64>) = (0.0, Vec::new());
    for (index, point) in path.iter().enumerate() {
        along += index
            .checked_sub(1)
            .and_then(|before| path.get(before))
            .map_or(0.0, |from| (point - from).norm());
        let off = |id: usize| (known[id] - point).norm();
        // Zero and -0.0 are one cell.
        let near =
            around.iter().filter_map(|off| cells.get(&key(cell(point) + off + Vector3::zeros()))).flatten();
        // The wire may come closer still.
        let closest = |id: usize| path.get(index + 1).is_none_or(|next| (known[id] - next).norm() >= off(id));
        let apart = |id: usize| along - met[id] > 2.0 * reach;
        let near = near.copied().filter(|&id| off(id) <= reach && apart(id) && closest(id));
        let nearest = near.min_by(|&one, &other| off(one).total_cmp(&off(other)).then(one.cmp(&other)));
        let id = nearest.unwrap_or(known.len());
        if id == known.len() {
            known.push(*point);
            met.push(along);
            cells.entry(key(cell(point) + Vector3::zeros())).or_default().push(id);
        }
        met[id] = along;
        order.push(id);
    }
    order.into_iter().map(|id| u32::try_from(id).unwrap_or(u32::MAX)).collect()
}

#[cfg(test)]
mod tests {
    use wirebend_core::checks::Diagnostic;

    use super::*;

    /// What a joint of the design is must be one here: a wire that meets itself there would count as one that hits itself.
    #[test]
    fn points_that_rounding_has_moved_apart_are_one_and_what_only_follows_is_not() {
        let path =
            [[0.0, 0.0, 0.0], [30.0, 0.0, 0.0], [30.0, 30.0, 0.0], [30.0, 30.0, 0.002], [-0.02, 0.01, 0.0]];
        assert_eq!(vertices(&path.map(Point3::from), 1.5), [0, 1, 2, 3, 0]);
        let apart = [[0.0, 0.0, 0.0], [30.0, 0.0, 0.0], [30.0, 30.0, 0.0], [0.0, 1.6, 0.0]];
        assert_eq!(vertices(&apart.map(Point3::from), 1.5), [0, 1, 2, 3]);
    }

    /// A curve in steps that are shorter than half of the wire is no row of joints; where it closes, it is one.
    #[test]
    fn points_that_are_close_along_the_wire_stay_apart() {
        let line: Vec<_> = (0..40).map(|k| Point3::new(0.5 * f64::from(k), 0.0, 0.0)).collect();
        assert_eq!(vertices(&line, 1.5), (0..40).collect::<Vec<_>>());
        let turn = |k: u32| f64::from(k) / 60.0 * std::f64::consts::TAU;
        let circle: Vec<_> =
            (0..=60).map(|k| Point3::new(10.0 * turn(k).cos(), 10.0 * turn(k).sin(), 0.01)).collect();
        let ids = vertices(&circle, 1.5);
        assert_eq!(ids[..60], (0..60).collect::<Vec<_>>());
        assert_eq!(ids[60], 0, "it closes");
    }

    #[test]
    fn g_code_that_is_to_be_run_is_told_from_what_is_no_program() {
        let app = Installation::new(&[]).unwrap();
        let of = ProgramMachine { machine: Some("grbl-bender"), material: None };
        let said = |bytes: &[u8]| job_of_file(&app, "house.nc", bytes, of).unwrap_err().to_string();
        assert!(said(b"G21\nG90\nG1 X10 F600\n").contains("run the job that it was written from"));
    }

    /// It is run as it was exported: what the checks say of it is what they say of the design.
    #[test]
    fn an_exported_program_of_a_closed_wire_is_checked_as_its_design_is() {
        let app = Installation::new(&[]).unwrap();
        let example = format!("{}/../../examples/house.obj", env!("CARGO_MANIFEST_DIR"));
        let opened = DesignInput::file(example.into()).open(&crate::NoProgress).unwrap();
        let choices = crate::PlanChoices { machine: Some("wirebend-kit".into()), ..Default::default() };
        let mut planned = app.plan_design(opened, &choices, &crate::NoProgress).unwrap();
        let text = include_bytes!("../../../../tests/golden/house/wirebend-kit.txt");
        let of = ProgramMachine { machine: Some("wirebend-kit"), material: None };
        let job = job_of_file(&app, "house.txt", text, of).unwrap();
        let mut given = GivenWires::of("house.txt", &job, &planned.setup).unwrap();
        assert_eq!(planned.find_collisions_in_time(), None);
        assert_eq!(given.find_collisions(&planned.setup), None);
        let contacts = |findings: &mut dyn Iterator<Item = &Diagnostic>| -> Vec<_> {
            findings
                .filter(|one| one.location.step.is_some())
                .map(|one| (one.code(), one.location.step))
                .collect()
        };
        assert_eq!(contacts(&mut given.findings()), contacts(&mut planned.wires[0].diagnostics.iter()));
    }
}
