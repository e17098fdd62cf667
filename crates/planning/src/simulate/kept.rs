//! A wire of a job as it was designed, and bent wires laid beside it.

use std::collections::BTreeMap;

use nalgebra::Point3;
use wirebend_core::bend::{Frame, Step, program_of_path};
use wirebend_core::compensate::CompensatedProgram;
use wirebend_core::motion::poses_of_points;
use wirebend_core::simulate::{SimulationInput, fractions, perfect_wire, scheduled_start};
use wirebend_core::units::{Angle, Length};
use wirebend_files::document::{JobContents, JobWire};

use super::resolution::resolution;
use crate::PlanningError;
use crate::machine::{Setup, kept_steps, told_steps};
use crate::playback::PoseReport;
use crate::signs::Signs;

/// A wire of a job, made ready to be bent.
pub struct KeptWire {
    start: Frame,
    scheduled: Vec<Step>,
    pub design: Vec<Point3<f64>>,
    fractions: Vec<Vec<f64>>,
    pub passes: Vec<Vec<usize>>,
    program: CompensatedProgram,
    /// How far the vertex that is farthest off would be from its design, were the commands rounded to what the axes can be told, mm.
    pub worst_rounded_mm: f64,
    pub length: Length,
    pub bends: usize,
    /// The points of the path at which the wire has a corner, its ends included.
    corners: Vec<usize>,
    signs: Signs,
}

impl KeptWire {
    /// All wires of a job.
    pub fn all(name: &str, contents: &JobContents, setup: &Setup) -> Result<Vec<Self>, PlanningError> {
        contents.wires.iter().map(|wire| Self::new(name, wire, setup)).collect()
    }

    pub fn new(name: &str, wire: &JobWire, setup: &Setup) -> Result<Self, PlanningError> {
        let design: Vec<Point3<f64>> = wire.path_mm.iter().copied().map(Point3::from).collect();
        let scheduled = kept_steps(&wire.scheduled)?;
        let nominal = kept_steps(&wire.nominal)?;
        // The frame in which the design starts is not kept: the path gives it back.
        let damaged = |error: wirebend_core::bend::PathError| PlanningError::DamagedJob {
            name: name.to_owned(),
            reason: error.to_string(),
        };
        let (start, _) = program_of_path(&design, setup.model.straight).map_err(damaged)?;
        let mut at: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
        for (k, &vertex) in wire.vertices.iter().enumerate() {
            at.entry(vertex).or_default().push(k);
        }
        let bent = nominal.iter().zip(&wire.spans).filter(|(step, _)| step.bend != Angle::ZERO);
        let inner = bent.map(|(_, &[_, end])| end);
        let corners = std::iter::once(0).chain(inner).chain(design.len().checked_sub(1)).collect();
        let told = told_steps(&wire.compensated)?;
        let program = |told| CompensatedProgram::from_job_steps(told, &setup.model.compensation);
        let rounded = program(resolution(setup)?.rounded(&told));
        let kept = Self {
            start: scheduled_start(start, &scheduled),
            fractions: fractions(&design, wire.spans.iter().map(|&[from, to]| from..to)),
            passes: at.into_values().filter(|passes| passes.len() > 1).collect(),
            program: program(told),
            worst_rounded_mm: 0.0,
            length: nominal.iter().map(|step| step.feed).sum(),
            bends: nominal.iter().filter(|step| step.bend != Angle::ZERO).count(),
            design,
            corners,
            signs: setup.signs,
            scheduled,
        };
        let made = perfect_wire(&SimulationInput { program: &rounded, ..kept.input(setup) });
        let off = kept.design.iter().zip(made).map(|(design, made)| (design - made).norm());
        Ok(Self { worst_rounded_mm: off.fold(0.0, f64::max), ..kept })
    }

    pub fn input<'a>(&'a self, setup: &'a Setup) -> SimulationInput<'a> {
        SimulationInput {
            start: self.start,
            design: &self.design,
            fractions: &self.fractions,
            passes: &self.passes,
            program: &self.program,
            compensation: &setup.model.compensation,
        }
    }

    /// Where the vertices of the design lie on a wire that a machine has bent: `corners_mm` are its ends and
    /// corners in the frame of the turtle at its start, in the machine's signs. Vertices on a straight divide it
    /// as they do in the design. `None` where the wire has another number of corners.
    pub fn vertices(&self, corners_mm: &[[f64; 3]]) -> Option<Vec<Point3<f64>>> {
        if corners_mm.len() != self.corners.len() {
            return None;
        }
        let made: Vec<Point3<f64>> = corners_mm.iter().map(|&corner| self.placed(corner)).collect();
        let mut vertices = Vec::with_capacity(self.design.len());
        vertices.extend(made.first());
        for (ends, made) in self.corners.windows(2).zip(made.windows(2)) {
            let points = self.design.get(ends[0]..=ends[1])?;
            let lengths: Vec<f64> = points.windows(2).map(|pair| (pair[1] - pair[0]).norm()).collect();
            let total: f64 = lengths.iter().sum();
            let along = lengths.iter().scan(0.0, |sum, length| {
                *sum += length;
                Some(*sum / total)
            });
            vertices.extend(along.map(|fraction| made[0] + (made[1] - made[0]) * fraction));
        }
        Some(vertices)
    }

    /// How far each vertex of the design is from where it lies on a bent wire, in mm.
    pub fn deviations_mm(&self, corners_mm: &[[f64; 3]]) -> Option<Vec<f64>> {
        let made = self.vertices(corners_mm)?;
        Some(self.design.iter().zip(made).map(|(design, made)| (design - made).norm()).collect())
    }

    /// The points of a bent wire, laid beside the design.
    pub fn wire(&self, wire_mm: &[[f64; 3]]) -> Vec<Point3<f64>> {
        wire_mm.iter().map(|&point| self.placed(point)).collect()
    }

    /// How a bent wire lies in the machine while each step bends it: `corners` are where it begins and where each step has
    /// left it, laid beside the design.
    pub fn poses(&self, corners: &[Point3<f64>]) -> Vec<PoseReport> {
        let poses = poses_of_points(corners, &self.start, &self.scheduled);
        poses.iter().map(PoseReport::from).collect()
    }

    fn placed(&self, point: [f64; 3]) -> Point3<f64> {
        let [x, y, z] = self.signs.made(point);
        let Frame { position, .. } = self.start;
        position + self.start.t() * x + self.start.n() * y + self.start.b() * z
    }
}
