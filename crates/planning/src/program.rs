//! Programs that are read: what their steps are, and the design that a compensated one leaves.
//!
//! A program of another tool is the design itself, or what a machine was told so that the design comes out. Planning
//! compensates, so that what was compensated before has to be turned back first: the WireBend-kit is told 110.4° to
//! leave 90°, and that would else be compensated once more.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::bend::Step;
use wirebend_core::units::Length;
use wirebend_core::wireframe::VertexId;
use wirebend_driver_host::api;
use wirebend_error::ErrorRemedy;
use wirebend_files::read::{Format, ImportedProgram};

use crate::PlanningError;
use crate::machine::kept_steps;
use crate::report::NoteReport;
use crate::signs::Signs;

/// What the steps of a program are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum ProgramKind {
    /// The design itself: angles and lengths as they shall be.
    Nominal,
    /// What a machine was told so that the design comes out, in the machine's signs.
    Compensated,
}

impl ProgramKind {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Nominal, Self::Compensated];

    /// The word for it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Nominal => "nominal",
            Self::Compensated => "compensated",
        }
    }
}

/// How it is known what the steps are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Known {
    /// A person or the format says so, or they were turned back.
    Design,
    /// Nothing says so: taken as the design.
    Assumed,
    /// They are what a machine was told.
    Told,
}

/// A program as it was read.
#[derive(Debug, Clone)]
pub struct ReadProgram {
    pub steps: Vec<Step>,
    pub order: Vec<VertexId>,
    /// So near corners of it are one.
    pub weld: Length,
    pub known: Known,
    /// The format that it is in, where the file itself says that it is what a machine was told: one whose programs are in that format.
    pub told_in: Option<&'static str>,
    /// Id of the machine on which it was recorded: such a program is in canonical signs.
    pub machine: Option<String>,
}

impl ReadProgram {
    /// `kind`: what a person says that its steps are.
    pub fn new(program: ImportedProgram, kind: Option<ProgramKind>, format: Format) -> Self {
        let told_in = format.written_as().filter(|_| kind.is_none() && program.told);
        let known = match kind {
            Some(ProgramKind::Nominal) => Known::Design,
            Some(ProgramKind::Compensated) => Known::Told,
            None if program.told => Known::Told,
            // A table is of the finished part.
            None if format == Format::Lra => Known::Design,
            None => Known::Assumed,
        };
        let ImportedProgram { program, traversal, machine, weld, .. } = program;
        Self { steps: program.steps, order: traversal, weld, known, told_in, machine }
    }

    /// The steps as commands in canonical signs, for a machine with these signs.
    pub fn commanded(&self, signs: Signs) -> Result<Vec<Step>, PlanningError> {
        if self.machine.is_some() {
            return Ok(self.steps.clone());
        }
        let canonical = |step: &Step| {
            let Step { feed, rotate, bend } = step;
            let (rotate_deg, bend_deg) = (rotate.deg(), bend.deg());
            signs.canonical(api::Step { feed_mm: feed.mm(), rotate_deg, bend_deg, approach_deg: None })
        };
        kept_steps(&self.steps.iter().map(canonical).collect::<Vec<_>>())
    }

    pub fn assumed(&self) -> Option<NoteReport> {
        (self.known == Known::Assumed).then(|| NoteReport {
            code: "program-nominal".into(),
            count: 1,
            message: "nothing says whether the program is compensated: taken as the design itself".to_owned(),
            remedies: vec![ErrorRemedy::TurnBack],
        })
    }
}
