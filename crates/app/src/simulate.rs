//! `simulate`: a job bent without a machine, with the errors that machines make.

use std::collections::BTreeMap;
use std::path::PathBuf;

use nalgebra::Point3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::bend::{Frame, program_of_path};
use wirebend_core::compensate::CompensatedProgram;
use wirebend_core::simulate::{
    ErrorModel, ErrorTerm, Spread, Trial, fractions, perfect_wire, scheduled_start, simulate as run_trial,
};
use wirebend_core::units::{Angle, Length};
use wirebend_files::document::JobWire;
use wirebend_files::write::PictureWire;

use crate::design::Input;
use crate::export::{no_fonts, open_job};
use crate::machine::{Setup, kept_steps, objections, restored};
use crate::output::Output;
use crate::picture::{self, Caption};
use crate::report::NoteReport;
use crate::{App, AppError, Progress};

/// The most runs of one simulation.
const MOST_RUNS: u32 = 1_000_000;
/// The most distances that are kept, a gibibyte of them: one for each vertex and gap and run.
const MOST_DISTANCES: usize = 1 << 27;
/// How many of the runs are drawn.
const DRAWN_RUNS: usize = 25;

/// What to simulate.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct SimulateRequest {
    /// The job.
    pub job: Input,
    /// The errors; absent, none are made.
    pub noise: Option<String>,
    /// How often the wire is bent.
    pub runs: u32,
    /// Where the random numbers start: the same seed, the same wires.
    pub seed: u64,
    /// A picture as SVG.
    pub svg: Option<Output>,
    /// A picture as PNG.
    pub png: Option<Output>,
}

/// How far one vertex of the route lies from where it should.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct VertexReport {
    /// The vertex.
    pub vertex: u32,
    /// Where it lies without errors, in mm, from where the design has it.
    pub systematic_mm: f64,
    /// Mean distance over all runs, in mm.
    pub mean_mm: f64,
    /// Distance that 95 % of the runs stay within, in mm.
    pub radius_95_mm: f64,
}

/// How far the passes of the wire through one vertex lie apart.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct GapReport {
    /// The vertex.
    pub vertex: u32,
    /// How often the wire comes through.
    pub passes: usize,
    /// Mean of the largest distance, in mm.
    pub mean_mm: f64,
    /// What 95 % of the runs stay within, in mm.
    pub radius_95_mm: f64,
}

/// One simulated wire.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct SimulatedWire {
    /// In the order of the route, a vertex as often as it is passed.
    pub vertices: Vec<VertexReport>,
    /// The vertices that are passed more than once.
    pub gaps: Vec<GapReport>,
    /// The largest `systematic_mm`.
    pub worst_systematic_mm: f64,
    /// The largest `mean_mm`.
    pub worst_mean_mm: f64,
    /// The largest `radius_95_mm`.
    pub worst_radius_95_mm: f64,
}

/// What the simulation found. Deviations are taken with the first vertex and the first direction in
/// place.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct SimulateResponse {
    /// The machine.
    pub machine: String,
    /// The material.
    pub material: String,
    /// The errors; null without any.
    pub noise: Option<String>,
    /// How often the wire was bent.
    pub runs: u32,
    /// Where the random numbers started.
    pub seed: u64,
    /// The wires of the job.
    pub wires: Vec<SimulatedWire>,
    /// What was left out.
    pub notes: Vec<NoteReport>,
    /// The pictures.
    pub files: Vec<PathBuf>,
}

pub(crate) fn simulate(
    app: &App,
    request: &SimulateRequest,
    progress: &dyn Progress,
) -> Result<SimulateResponse, AppError> {
    for output in request.svg.iter().chain(&request.png) {
        output.check()?;
    }
    let runs = if request.noise.is_some() { request.runs } else { 1 };
    if runs == 0 || runs > MOST_RUNS {
        let expected = "give a number of runs from 1 to 1000000";
        return Err(AppError::Value { name: "--runs", value: runs.to_string(), expected });
    }
    let errors = match &request.noise {
        Some(id) => noise_model(app, id)?,
        None => ErrorModel::default(),
    };
    progress.stage("reading");
    let (name, bytes) = request.job.load()?;
    let job = open_job(&name, &bytes)?;
    let contents = job.contents();
    let setup = restored(&name, contents)?;
    let distances: usize = contents.wires.iter().map(|wire| 2 * wire.vertices.len()).sum();
    if distances.saturating_mul(runs as usize) > MOST_DISTANCES {
        let expected = "give fewer runs: the distances of all vertices in all runs do not fit the memory";
        return Err(AppError::Value { name: "--runs", value: runs.to_string(), expected });
    }
    progress.stage("bending");
    let mut drawing = Drawing::default();
    let mut wires = Vec::with_capacity(contents.wires.len());
    for (index, wire) in contents.wires.iter().enumerate() {
        let kept = KeptWire::new(&name, wire, &setup)?;
        let mut done = 0;
        let bent = |made: &[Point3<f64>]| {
            done += 1;
            drawing.run(made);
            progress.advance(
                index as u64 * u64::from(runs) + done,
                contents.wires.len() as u64 * u64::from(runs),
            );
        };
        let wrong = |error| AppError::Noise { noise: request.noise.clone().unwrap_or_default(), error };
        let trial = kept.trial(&setup);
        let perfect = perfect_wire(&trial);
        let report = run_trial(&trial, &errors, runs, request.seed, bent).map_err(wrong)?;
        wires.push(simulated_wire(wire, &kept, &perfect, &report.deviations, &report.gaps));
        drawing.design(kept);
    }
    let mut notes = objections(contents);
    let files = drawing.write(request, &setup, &mut notes)?;
    Ok(SimulateResponse {
        machine: setup.machine_id().to_owned(),
        material: setup.material_id().to_owned(),
        noise: request.noise.clone(),
        runs,
        seed: request.seed,
        wires,
        notes,
        files,
    })
}

fn noise_model(app: &App, id: &str) -> Result<ErrorModel, AppError> {
    let figures = app.library.noise(id)?.figures()?;
    let term = |figure: wirebend_profile::ErrorFigures| ErrorTerm { bias: figure.bias, sigma: figure.sigma };
    Ok(ErrorModel {
        feed_mm: term(figures.feed_mm),
        rotate_deg: term(figures.rotate_deg),
        bend_deg: term(figures.bend_deg),
        curvature: term(figures.curvature),
    })
}

/// A wire of a job, made ready to be bent.
struct KeptWire {
    start: Frame,
    design: Vec<Point3<f64>>,
    fractions: Vec<Vec<f64>>,
    passes: Vec<Vec<usize>>,
    program: CompensatedProgram,
    length: Length,
    bends: usize,
}

impl KeptWire {
    fn new(name: &str, wire: &JobWire, setup: &Setup) -> Result<Self, AppError> {
        let design: Vec<Point3<f64>> = wire.path_mm.iter().copied().map(Point3::from).collect();
        let scheduled = kept_steps(&wire.scheduled)?;
        let nominal = kept_steps(&wire.nominal)?;
        // The frame in which the design starts is not kept: the path gives it back.
        let damaged = |error: wirebend_core::bend::PathError| AppError::DamagedJob {
            name: name.to_owned(),
            reason: error.to_string(),
        };
        let (start, _) = program_of_path(&design, setup.model.straight).map_err(damaged)?;
        let mut at: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
        for (k, &vertex) in wire.vertices.iter().enumerate() {
            at.entry(vertex).or_default().push(k);
        }
        Ok(Self {
            start: scheduled_start(start, &scheduled),
            fractions: fractions(&design, wire.spans.iter().map(|&[from, to]| from..to)),
            passes: at.into_values().filter(|passes| passes.len() > 1).collect(),
            program: CompensatedProgram::kept(kept_steps(&wire.compensated)?),
            length: nominal.iter().map(|step| step.feed).sum(),
            bends: nominal.iter().filter(|step| step.bend != Angle::ZERO).count(),
            design,
        })
    }

    fn trial<'a>(&'a self, setup: &'a Setup) -> Trial<'a> {
        Trial {
            start: self.start,
            design: &self.design,
            fractions: &self.fractions,
            passes: &self.passes,
            program: &self.program,
            compensation: &setup.model.compensation,
        }
    }
}

fn simulated_wire(
    wire: &JobWire,
    kept: &KeptWire,
    perfect: &[Point3<f64>],
    deviations: &[Spread],
    gaps: &[Spread],
) -> SimulatedWire {
    let vertices: Vec<VertexReport> = wire
        .vertices
        .iter()
        .zip(kept.design.iter().zip(perfect))
        .zip(deviations)
        .map(|((&vertex, (design, perfect)), spread)| VertexReport {
            vertex,
            systematic_mm: (design - perfect).norm(),
            mean_mm: spread.mean.mm(),
            radius_95_mm: spread.radius_95.mm(),
        })
        .collect();
    let gaps = kept.passes.iter().zip(gaps).map(|(passes, spread)| GapReport {
        vertex: passes.first().and_then(|&k| wire.vertices.get(k)).copied().unwrap_or_default(),
        passes: passes.len(),
        mean_mm: spread.mean.mm(),
        radius_95_mm: spread.radius_95.mm(),
    });
    let worst = |of: fn(&VertexReport) -> f64| vertices.iter().map(of).fold(0.0, f64::max);
    SimulatedWire {
        gaps: gaps.collect(),
        worst_systematic_mm: worst(|vertex| vertex.systematic_mm),
        worst_mean_mm: worst(|vertex| vertex.mean_mm),
        worst_radius_95_mm: worst(|vertex| vertex.radius_95_mm),
        vertices,
    }
}

/// The design and some of the wires that were made of it.
#[derive(Default)]
struct Drawing {
    runs: Vec<Vec<Point3<f64>>>,
    drawn: usize,
    designs: Vec<KeptWire>,
}

impl Drawing {
    fn run(&mut self, made: &[Point3<f64>]) {
        if self.drawn < DRAWN_RUNS {
            self.drawn += 1;
            self.runs.push(made.to_vec());
        }
    }

    fn design(&mut self, kept: KeptWire) {
        self.drawn = 0;
        self.designs.push(kept);
    }

    fn write(
        self,
        request: &SimulateRequest,
        setup: &Setup,
        notes: &mut Vec<NoteReport>,
    ) -> Result<Vec<PathBuf>, AppError> {
        if request.svg.is_none() && request.png.is_none() {
            return Ok(Vec::new());
        }
        let caption = Caption {
            title: format!("{}, simulated", request.job.stem()),
            machine: setup.machine_name().to_owned(),
            material: setup.material_name().to_owned(),
            length: self.designs.iter().map(|wire| wire.length).sum(),
            bends: self.designs.iter().map(|wire| wire.bends).sum(),
        };
        let wire = |wire: KeptWire| PictureWire { points: wire.design, doubled: Vec::new() };
        let designs = self.designs.into_iter().map(wire).collect();
        let drawing = picture::draw(caption, designs, self.runs, Vec::new());
        let mut files = Vec::new();
        if let Some(output) = &request.svg {
            files.push(output.save(drawing.as_bytes())?);
        }
        if let Some(output) = &request.png {
            let (pixels, has_fonts) = picture::png(&drawing)?;
            if !has_fonts {
                notes.push(no_fonts());
            }
            files.push(output.save(&pixels)?);
        }
        Ok(files)
    }
}
