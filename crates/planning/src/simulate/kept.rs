//! A wire of a job as it was designed, and bent wires laid beside it.

use std::collections::BTreeMap;

use nalgebra::{Point3, Rotation3, Unit};
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

/// A corner that is nearer to the first direction tells no plane.
const BESIDE_MM: f64 = 0.5;

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
        self.vertices_of(&self.wire(corners_mm))
    }

    /// The same of corners that are laid beside the design.
    fn vertices_of(&self, made: &[Point3<f64>]) -> Option<Vec<Point3<f64>>> {
        if made.len() != self.corners.len() {
            return None;
        }
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

    /// The corners of a bent wire laid beside the design by its first bend, and how far each vertex of the design is from where it lies on
    /// it then, in mm; `None` where the wire has another number of corners.
    pub fn compare(&self, corners_mm: &[[f64; 3]]) -> (Vec<[f64; 3]>, Option<Vec<f64>>) {
        let corners = self.by_first_bend(corners_mm);
        let off = |(design, made): (&Point3<f64>, Point3<f64>)| (design - made).norm();
        let deviations =
            self.vertices_of(&corners).map(|made| self.design.iter().zip(made).map(off).collect());
        (corners.into_iter().map(Into::into).collect(), deviations)
    }

    /// The points of a bent wire, laid beside the design.
    pub fn wire(&self, wire_mm: &[[f64; 3]]) -> Vec<Point3<f64>> {
        wire_mm.iter().map(|&point| self.placed(point)).collect()
    }

    /// The corners of a bent wire, laid beside the design with its first bend in the plane of the design's: a head that has play does not
    /// know where in that its zero is, and all of the wire is turned by it.
    fn by_first_bend(&self, corners_mm: &[[f64; 3]]) -> Vec<Point3<f64>> {
        let made = self.wire(corners_mm);
        let Frame { position, .. } = self.start;
        let axis = Unit::new_normalize(self.start.t());
        let beside = |point: &Point3<f64>| {
            let from = point - position;
            from - axis.scale(axis.dot(&from))
        };
        let pairs = self.corners.iter().filter_map(|&k| self.design.get(k)).zip(&made);
        let off = pairs.map(|(design, made)| (beside(design), beside(made)));
        let Some((design, made_off)) = off.into_iter().find(|(a, b)| a.norm().min(b.norm()) > BESIDE_MM)
        else {
            return made;
        };
        let turn = axis.dot(&made_off.cross(&design)).atan2(made_off.dot(&design));
        let turn = Rotation3::from_axis_angle(&axis, turn);
        made.iter().map(|point| position + turn * (point - position)).collect()
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
