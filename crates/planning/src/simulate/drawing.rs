//! The picture of a simulation.

use std::path::PathBuf;

use nalgebra::Point3;
use wirebend_files::write::PictureWire;

use super::SimulateRequest;
use super::kept::KeptWire;
use crate::PlanningError;
use crate::export::no_fonts;
use crate::machine::Setup;
use crate::picture::{self, Caption};
use crate::report::NoteReport;

/// How many of the runs are drawn.
const DRAWN_RUNS: usize = 25;

/// The design and some of the wires that were bent from it.
#[derive(Default)]
pub(super) struct Drawing {
    runs: Vec<Vec<Point3<f64>>>,
    drawn: usize,
    designs: Vec<KeptWire>,
}

impl Drawing {
    pub fn run(&mut self, made: &[Point3<f64>]) {
        if self.drawn < DRAWN_RUNS {
            self.drawn += 1;
            self.runs.push(made.to_vec());
        }
    }

    pub fn design(&mut self, kept: KeptWire) {
        self.drawn = 0;
        self.designs.push(kept);
    }

    pub fn write(
        self,
        request: &SimulateRequest,
        setup: &Setup,
        notes: &mut Vec<NoteReport>,
    ) -> Result<Vec<PathBuf>, PlanningError> {
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
