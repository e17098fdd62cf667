//! Programs that are read: what their steps are, and the design that a compensated one leaves.
//!
//! A program of another tool is the design itself, or what a machine was told so that the design comes out. Planning
//! compensates, so that what was compensated before has to be turned back first: the WireBend-kit is told 110.4° to
//! leave 90°, and that would else be compensated once more.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::bend::{Frame, Step, replay};
use wirebend_core::route::Route;
use wirebend_core::units::{Angle, Length};
use wirebend_core::wireframe::VertexId;
use wirebend_driver_host::api;
use wirebend_files::read::{Format, ImportedProgram, wireframe_of_path};

use crate::design::{DesignInput, Opened};
use crate::machine::Setup;
use crate::plan::PlanChoices;
use crate::report::NoteReport;
use crate::{App, AppError};

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
enum Known {
    /// A person or the format says so, or they were turned back.
    Design,
    /// Nothing says so: taken as the design.
    Assumed,
    /// They are what a machine was told.
    Told,
}

/// A program as it was read.
#[derive(Debug, Clone)]
pub(crate) struct ReadProgram {
    steps: Vec<Step>,
    order: Vec<VertexId>,
    weld_mm: f64,
    known: Known,
}

impl ReadProgram {
    pub fn new(program: ImportedProgram, input: &DesignInput, format: Format) -> Self {
        let known = match input.program {
            Some(ProgramKind::Nominal) => Known::Design,
            Some(ProgramKind::Compensated) => Known::Told,
            None if program.told => Known::Told,
            // A table is of the finished part.
            None if format == Format::Lra => Known::Design,
            None => Known::Assumed,
        };
        let ImportedProgram { program, traversal, .. } = program;
        Self { steps: program.steps, order: traversal, weld_mm: input.weld_mm, known }
    }

    /// What was assumed of it.
    pub fn assumed(&self) -> Option<NoteReport> {
        (self.known == Known::Assumed).then(|| NoteReport {
            code: "program-nominal".into(),
            count: 1,
            message: "nothing says whether the program is compensated: taken as the design itself; \
                      --program compensated turns back what a machine was told"
                .to_owned(),
        })
    }
}

impl App {
    /// The design of a program that is what a machine was told: turned back for the machine and the material that a
    /// person names. All else is as it is.
    pub(crate) fn designed(&self, opened: Opened, choices: &PlanChoices) -> Result<Opened, AppError> {
        if !opened.is_told() {
            return Ok(opened);
        }
        let Some(machine) = &choices.machine else {
            return Err(AppError::Compensated { name: opened.name });
        };
        opened.turned_back(&self.setup(machine, choices.material.as_deref())?)
    }
}

impl Opened {
    fn is_told(&self) -> bool {
        self.program.as_ref().is_some_and(|program| program.known == Known::Told)
    }

    /// Refuses what would be compensated twice.
    pub(crate) fn require_designed(&self) -> Result<(), AppError> {
        if self.is_told() { Err(AppError::Compensated { name: self.name.clone() }) } else { Ok(()) }
    }

    /// The design that the steps leave on a machine.
    pub(crate) fn turned_back(mut self, setup: &Setup) -> Result<Self, AppError> {
        let Some(program) = self.program.take_if(|program| program.known == Known::Told) else {
            return Ok(self);
        };
        let steps = left(&program.steps, setup).map_err(|step| AppError::OtherCompensation {
            name: self.name.clone(),
            step: step + 1,
            machine: setup.machine_id().to_owned(),
            material: setup.material_id().to_owned(),
        })?;
        let path = replay(Frame::default(), &steps);
        let weld = crate::design::length("--weld", program.weld_mm)?;
        let (wireframe, order) = wireframe_of_path(&path, weld).map_err(|_| AppError::OtherCompensation {
            name: self.name.clone(),
            step: 1,
            machine: setup.machine_id().to_owned(),
            material: setup.material_id().to_owned(),
        })?;
        self.document.wireframe = wireframe;
        self.notes.push(NoteReport {
            code: "program-turned-back".into(),
            count: 1,
            message: format!(
                "the program is what a machine was told: turned back into the design with the compensation of {} and {}, \
                 for which it has to be written; --program nominal takes it as it stands",
                setup.machine_id(),
                setup.material_id()
            ),
        });
        self.program = Some(ReadProgram { steps, order, known: Known::Design, ..program });
        Ok(self)
    }

    /// The walk of the program, where it is to be kept.
    pub(crate) fn settled(&self, choices: &PlanChoices) -> Result<Option<Route>, AppError> {
        if !choices.keep_order {
            return Ok(None);
        }
        if choices.double || choices.closed || choices.start.is_some() {
            let expected = "without --double, --closed and --start, since the program settles the route";
            return Err(AppError::Value { name: "--keep-order", value: "given".to_owned(), expected });
        }
        let order = self.program.as_ref().map(|program| &program.order);
        let walk = order.and_then(|order| Route::through(&self.document.wireframe, order));
        walk.map(Some).ok_or_else(|| AppError::NoOrder { name: self.name.clone() })
    }
}

/// The steps from corner to corner that commands leave: the inverse of compensating. The step that cannot be where a
/// feed is too short for its bends.
fn left(told: &[Step], setup: &Setup) -> Result<Vec<Step>, usize> {
    let compensation = &setup.model.compensation;
    let mut before = Angle::ZERO;
    let mut steps = Vec::with_capacity(told.len());
    for (index, &step) in told.iter().enumerate() {
        let Step { feed, rotate, bend } = step;
        let told = api::Step { feed_mm: feed.mm(), rotate_deg: rotate.deg(), bend_deg: bend.deg() };
        let canonical = setup.signs.canonical(told);
        let angle = |deg: f64| Angle::from_deg(deg).map_err(|_| index);
        let bend = compensation.bend.result(angle(canonical.bend_deg)?);
        let feed = compensation.feed.as_ref().map_or(feed, |model| model.segment_of(feed, before, bend));
        // What is a little less than nothing was rounded.
        if feed.mm() < -ROUNDED_MM {
            return Err(index);
        }
        let feed = if feed < Length::ZERO { Length::ZERO } else { feed };
        steps.push(Step { feed, rotate: angle(canonical.rotate_deg)?, bend });
        before = bend;
    }
    Ok(steps)
}

/// So much may a feed of a program with two decimals be off.
const ROUNDED_MM: f64 = 0.01;
