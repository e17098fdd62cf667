//! The design of a program that is what a machine was told.

use wirebend_core::bend::{Frame, Step, replay};
use wirebend_core::compensate::{BendModel, CompensatedProgram};
use wirebend_core::route::Route;
use wirebend_core::simulate::formed_steps;
use wirebend_core::units::{Angle, Length};
use wirebend_error::{ErrorRemedy, InputName};
use wirebend_files::read::{PathWireframe, wireframe_of_path};

use crate::choices::PlanChoices;
use crate::design::Opened;
use crate::error::{PlanningError, ToldCommand};
use crate::installation::Installation;
use crate::machine::Setup;
use crate::program::{Known, ReadProgram};
use crate::report::NoteReport;

impl Installation {
    /// The design of a program that is what a machine was told: turned back for the machine and the material that a
    /// person names. All else is as it is.
    pub fn designed(&self, opened: Opened, choices: &PlanChoices) -> Result<Opened, PlanningError> {
        if !opened.is_told() {
            return Ok(opened);
        }
        let setup = self.maker_of(&opened, choices)?;
        opened.require_told_to(&setup)?;
        opened.turned_back(&setup)
    }

    /// The machine and the wire of what was opened. Recorded moves are of the machine that made them, unless that is not known here, and
    /// of its own wire where another machine is given: that one is for what follows.
    pub fn maker_of(&self, opened: &Opened, choices: &PlanChoices) -> Result<Setup, PlanningError> {
        let recorded = opened.recorded_on().filter(|id| self.library.machine(id).is_ok());
        let given = choices.machine.as_deref();
        let Some(machine) = recorded.or(given) else {
            return Err(PlanningError::Compensated { name: opened.name.clone() });
        };
        let material = choices.material.as_deref().filter(|_| given.is_none_or(|given| given == machine));
        self.setup(machine, material)
    }
}

impl Opened {
    fn is_told(&self) -> bool {
        self.program.as_ref().is_some_and(|program| program.known == Known::Told)
    }

    /// Refuses to turn back with one machine what was written for another.
    fn require_told_to(&self, setup: &Setup) -> Result<(), PlanningError> {
        let told_in = self.program.as_ref().and_then(|program| program.told_in);
        let export = &setup.machine.profile.export;
        let mut written = export.native.iter().chain(export.formats.iter().flatten());
        match told_in {
            Some(format) if !written.any(|known| known == format) => Err(PlanningError::FormatOfAnother {
                format: format.to_owned(),
                machine: setup.machine_id().to_owned(),
                known: Vec::new(),
            }),
            _ => Ok(()),
        }
    }

    /// The machine that a recording of moves is of.
    #[must_use]
    pub fn recorded_on(&self) -> Option<&str> {
        self.program.as_ref()?.machine.as_deref()
    }

    /// Refuses what would be compensated twice.
    pub fn require_designed(&self) -> Result<(), PlanningError> {
        if self.is_told() { Err(PlanningError::Compensated { name: self.name.clone() }) } else { Ok(()) }
    }

    /// The design that the steps leave on a machine.
    pub fn turned_back(mut self, setup: &Setup) -> Result<Self, PlanningError> {
        let Some(program) = self.program.take_if(|program| program.known == Known::Told) else {
            return Ok(self);
        };
        let told: Vec<Step> = program.commanded(setup.signs)?;
        let of_another = |NoDesign { step, command }| PlanningError::OtherCompensation {
            name: self.name.clone(),
            step: step + 1,
            command,
            machine: setup.machine_id().to_owned(),
            material: setup.material_id().to_owned(),
        };
        let steps = left(&told, setup).map_err(of_another)?;
        let path = replay(Frame::default(), &steps);
        let PathWireframe { wireframe, traversal: order, .. } = wireframe_of_path(&path, program.weld)
            .map_err(|_| of_another(NoDesign { step: 0, command: ToldCommand::Feed }))?;
        self.document.wireframe = wireframe;
        self.notes.push(NoteReport {
            code: "program-turned-back".into(),
            count: 1,
            message: format!(
                "the program is what a machine was told: turned back into the design with the compensation of {} and {}, \
                 for which it has to be written",
                setup.machine_id(),
                setup.material_id()
            ), remedies: vec![ErrorRemedy::TakeAsNominal] });
        self.notes.extend(not_bent(&told, &steps));
        self.program = Some(ReadProgram { steps, order, known: Known::Design, ..program });
        Ok(self)
    }

    /// The walk of the program, where it is to be kept.
    pub fn settled(&self, choices: &PlanChoices) -> Result<Vec<Route>, PlanningError> {
        if !choices.keep_order {
            return Ok(Vec::new());
        }
        let given = [
            (InputName::Double, choices.double),
            (InputName::Detours, choices.detours),
            (InputName::Wires, choices.wires.is_some()),
            (InputName::Closed, choices.closed),
            (InputName::Start, choices.start.is_some()),
        ];
        let inputs: Vec<InputName> =
            given.into_iter().filter(|(_, given)| *given).map(|(name, _)| name).collect();
        if !inputs.is_empty() {
            let instead = Box::new(ErrorRemedy::LeaveOut { inputs: vec![InputName::KeepOrder] });
            return Err(PlanningError::Settled { name: self.name.clone(), inputs, instead });
        }
        let order = self.program.as_ref().map(|program| &program.order);
        let walk = order.and_then(|order| Route::through(&self.document.wireframe, order));
        walk.map(|walk| vec![walk]).ok_or_else(|| PlanningError::NoOrder { name: self.name.clone() })
    }
}

/// A command that no design leads to.
struct NoDesign {
    /// From 0.
    step: usize,
    command: ToldCommand,
}

/// The steps from corner to corner that commands in canonical signs leave: the inverse of compensating. Refused is a feed that is too
/// short for its bends, and a bend beyond what the machine can press.
fn left(told: &[Step], setup: &Setup) -> Result<Vec<Step>, NoDesign> {
    let mut steps = corner_to_corner(told, setup);
    let bends = BendModel { axis_limit: None, ..setup.model.compensation.bend.clone() };
    let [most, most_negative] = [Angle::HALF_TURN, -Angle::HALF_TURN].map(|side| match &bends.setback {
        // Any command beyond leaves the largest bend.
        Some(_) => bends.max_bend(side).deg() - SLIGHT_BEND_DEG,
        None => Angle::HALF_TURN.deg() + SLIGHT_BEND_DEG,
    });
    for (index, step) in steps.iter_mut().enumerate() {
        // What is a little less than nothing was rounded.
        if step.feed.mm() < -ROUNDED_MM {
            return Err(NoDesign { step: index, command: ToldCommand::Feed });
        }
        if step.bend.deg() > most || -step.bend.deg() > most_negative {
            return Err(NoDesign { step: index, command: ToldCommand::Bend });
        }
        if step.feed < Length::ZERO {
            step.feed = Length::ZERO;
        }
    }
    Ok(steps)
}

/// What a person takes for bends and is none.
fn not_bent(told: &[Step], left: &[Step]) -> Option<NoteReport> {
    let is_lost =
        |(told, left): (&Step, &Step)| told.bend.deg().abs() > SLIGHT_DEG && left.bend == Angle::ZERO;
    let lost: Vec<usize> =
        told.iter().zip(left).map(is_lost).enumerate().filter_map(|(k, lost)| lost.then_some(k)).collect();
    let &first = lost.first()?;
    let more = match lost.len() - 1 {
        0 => String::new(),
        1 => ", and in 1 later step".to_owned(),
        later => format!(", and in {later} later steps"),
    };
    let message = format!(
        "step {}: the bend axis went to {:.1}° and bends nothing: the wire that is fed ends within the reach of the bend pin, or springs back whole{more}",
        first + 1,
        told[first].bend.deg(),
    );
    Some(NoteReport { code: "not-bent".into(), count: lost.len(), message, remedies: Vec::new() })
}

/// A smaller command is a rounded zero.
const SLIGHT_DEG: f64 = 0.5;

/// The same, with feeds below 0 where one is too short for its bends.
pub(crate) fn corner_to_corner(told: &[Step], setup: &Setup) -> Vec<Step> {
    let compensation = &setup.model.compensation;
    formed_steps(&CompensatedProgram::from_job_steps(told.iter().copied(), compensation), compensation)
}

/// Less than any command can tell.
const SLIGHT_BEND_DEG: f64 = 1e-6;

/// So much may a feed of a program with two decimals be off.
const ROUNDED_MM: f64 = 0.01;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::design::DesignInput;
    use crate::program::ProgramKind;

    /// 10 mm of wire are not reached by a peg that comes out 20 mm beside the nozzle.
    #[test]
    fn a_bend_that_bends_nothing_is_named() {
        let app = Installation::new(&[]).unwrap();
        let notes = |feed: f64| {
            let moves = format!("f {feed}\nb 45\nf {feed}\nb 60\nf 50\n");
            let input =
                DesignInput { program: Some(ProgramKind::Compensated), ..DesignInput::file("a.txt".into()) };
            let opened = input.open_bytes("a.txt".to_owned(), moves.as_bytes(), None).unwrap();
            let choices = PlanChoices { machine: Some("wirebend-kit".to_owned()), ..PlanChoices::default() };
            app.designed(opened, &choices).unwrap().notes
        };
        let found = notes(10.0);
        let note = found.iter().find(|note| note.code == "not-bent").unwrap();
        assert!(note.message.starts_with("step 1: the bend axis went to 45.0°"), "{}", note.message);
        assert!(notes(50.0).iter().all(|note| note.code != "not-bent"));
    }

    /// The axis has its largest bend at 150°; one that is bent without a peg ends with half a turn.
    #[test]
    fn a_bend_beyond_reach_is_refused() {
        let app = Installation::new(&[]).unwrap();
        let designed = |name: &str, moves: &str, machine: &str| {
            let input =
                DesignInput { program: Some(ProgramKind::Compensated), ..DesignInput::file(name.into()) };
            let opened = input.open_bytes(name.to_owned(), moves.as_bytes(), None).unwrap();
            let choices = PlanChoices { machine: Some(machine.to_owned()), ..PlanChoices::default() };
            app.designed(opened, &choices)
        };
        let kit =
            |bend: f64| designed("a.txt", &format!("f 60\nb 30\nf 60\nb {bend}\nf 60\n"), "wirebend-kit");
        for bend in [200.0, -1000.0] {
            let error = kit(bend).err().unwrap();
            let PlanningError::OtherCompensation { step, command, .. } = error else { panic!("{error}") };
            assert_eq!((step, command), (2, ToldCommand::Bend), "{bend}");
        }
        assert!(kit(120.0).is_ok());
        let pensa =
            |bend: f64| designed("a.dsw", &format!("feed 60\nbend {bend}\nfeed 60\n"), "pensa-diwire-pro");
        assert!(matches!(pensa(220.0), Err(PlanningError::OtherCompensation { step: 1, .. })));
        assert!(pensa(170.0).is_ok());
    }

    /// "Can that machine make it, too?" was answered for another part.
    #[test]
    fn recorded_moves_are_of_the_machine_that_made_them() {
        let app = Installation::new(&[]).unwrap();
        let moves =
            br#"{"format": "wbmoves", "version": 1, "machine": "wirebend-kit", "profile_hash": "", "moves": [
            {"move": "feed", "mm": 60}, {"move": "bend", "deg": 80}, {"move": "feed", "mm": 60}]}"#;
        let designed = |machine: Option<&str>| {
            let input = DesignInput::file("a.wbmoves".into());
            let opened = input.open_bytes("a.wbmoves".to_owned(), moves, None).unwrap();
            let choices = PlanChoices { machine: machine.map(str::to_owned), ..PlanChoices::default() };
            app.designed(opened, &choices).unwrap().document.wireframe
        };
        assert_eq!(designed(Some("grbl-bender")), designed(None));
    }

    /// With the springback of another machine 90° would become 66.5°, and nothing would be wrong with that.
    #[test]
    fn what_was_written_for_one_machine_is_not_turned_back_with_another() {
        let app = Installation::new(&[]).unwrap();
        let script = include_bytes!("../../../tests/golden/house/pensa.txt");
        let designed = |machine: &str, program: Option<ProgramKind>| {
            let input = DesignInput { program, ..DesignInput::file("house.dsw".into()) };
            let opened = input.open_bytes("house.dsw".to_owned(), script, None).unwrap();
            let choices = PlanChoices { machine: Some(machine.to_owned()), ..PlanChoices::default() };
            app.designed(opened, &choices)
        };
        let refused = designed("wirebend-kit", None).err().unwrap();
        assert!(matches!(refused, PlanningError::FormatOfAnother { .. }), "{refused}");
        let design = designed("pensa-diwire-pro", None).unwrap().document.wireframe;
        let length: f64 = design.edges().map(|(id, _)| design.edge_length(id).mm()).sum();
        assert!((length - 292.0).abs() < 0.01, "{length}");
        // Whoever says what it is knows better.
        assert!(designed("wirebend-kit", Some(ProgramKind::Nominal)).is_ok());
    }
}
