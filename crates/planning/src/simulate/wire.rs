//! What a simulation found of one wire.

use nalgebra::Point3;
use schemars::JsonSchema;
use serde::Serialize;
use wirebend_core::simulate::ErrorReport;
use wirebend_files::document::JobWire;

use super::{KeptWire, SimulatedCollisions, SourceShare, StepShare};

/// How far one vertex of the route lies from where it should.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct VertexReport {
    pub vertex: u32,
    /// How far the simulated machine's wire has it from where the design has it, in mm; null without such a machine.
    pub machine_mm: Option<f64>,
    /// The same by the closed formulas, without errors.
    pub systematic_mm: f64,
    /// Mean distance over all runs, in mm.
    pub mean_mm: f64,
    /// Distance that 95 % of the runs stay within, in mm.
    pub radius_95_mm: f64,
}

/// How far the passes of the wire through one vertex lie apart.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct GapReport {
    pub vertex: u32,
    /// How often the wire comes through.
    pub passes: usize,
    /// Their largest distance on the simulated machine's wire, in mm; null without such a machine.
    pub machine_mm: Option<f64>,
    /// Mean of the largest distance, in mm.
    pub mean_mm: f64,
    /// What 95 % of the runs stay within, in mm.
    pub radius_95_mm: f64,
}

#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct SimulatedWire {
    /// In the order of the route, a vertex as often as it is passed.
    pub vertices: Vec<VertexReport>,
    /// The vertices that are passed more than once.
    pub gaps: Vec<GapReport>,
    /// The largest `machine_mm` of a vertex.
    pub worst_machine_mm: Option<f64>,
    /// The largest `systematic_mm`.
    pub worst_systematic_mm: f64,
    /// How far the worst vertex would be off if the axes took the commands to their resolutions, in mm.
    pub worst_rounded_mm: f64,
    /// The largest `mean_mm`.
    pub worst_mean_mm: f64,
    /// The largest `radius_95_mm`.
    pub worst_radius_95_mm: f64,
    /// How far each kind of error alone moves the wire, the largest first; empty without errors.
    pub sources: Vec<SourceShare>,
    /// How far the errors of each step move the wire, in the order of the program; empty without errors.
    pub steps: Vec<StepShare>,
    /// Where the simulated wires hit the machine or themselves; null where nobody asked, or with a note that says why not.
    pub collisions: Option<SimulatedCollisions>,
}

/// What one wire came to.
pub(super) struct Figures<'a> {
    pub perfect: &'a [Point3<f64>],
    /// Its vertices as the simulated machine bent them.
    pub made: Option<&'a [Point3<f64>]>,
    pub report: &'a ErrorReport,
}

pub(super) fn simulated_wire(wire: &JobWire, kept: &KeptWire, figures: &Figures) -> SimulatedWire {
    let Figures { perfect, made, report } = figures;
    let off = |points: &[Point3<f64>], k: usize| Some((kept.design.get(k)? - points.get(k)?).norm());
    let vertices: Vec<VertexReport> = wire
        .vertices
        .iter()
        .zip(&report.deviations)
        .enumerate()
        .map(|(k, (&vertex, spread))| VertexReport {
            vertex,
            machine_mm: made.and_then(|made| off(made, k)),
            systematic_mm: off(perfect, k).unwrap_or_default(),
            mean_mm: spread.mean.mm(),
            radius_95_mm: spread.radius_95.mm(),
        })
        .collect();
    let gaps = kept.passes.iter().zip(&report.gaps).map(|(passes, spread)| GapReport {
        vertex: passes.first().and_then(|&k| wire.vertices.get(k)).copied().unwrap_or_default(),
        passes: passes.len(),
        machine_mm: made.map(|made| farthest(made, passes)),
        mean_mm: spread.mean.mm(),
        radius_95_mm: spread.radius_95.mm(),
    });
    let worst = |of: fn(&VertexReport) -> f64| vertices.iter().map(of).fold(0.0, f64::max);
    SimulatedWire {
        gaps: gaps.collect(),
        worst_machine_mm: made.map(|_| worst(|vertex| vertex.machine_mm.unwrap_or_default())),
        worst_systematic_mm: worst(|vertex| vertex.systematic_mm),
        worst_rounded_mm: kept.worst_rounded_mm,
        worst_mean_mm: worst(|vertex| vertex.mean_mm),
        worst_radius_95_mm: worst(|vertex| vertex.radius_95_mm),
        sources: Vec::new(),
        steps: Vec::new(),
        collisions: None,
        vertices,
    }
}

/// The largest distance between any two of some points.
fn farthest(points: &[Point3<f64>], some: &[usize]) -> f64 {
    let points: Vec<&Point3<f64>> = some.iter().filter_map(|&k| points.get(k)).collect();
    points.iter().flat_map(|a| points.iter().map(move |b| (*a - *b).norm())).fold(0.0, f64::max)
}
