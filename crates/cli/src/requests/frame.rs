//! The requests of frames.

use std::path::{Path, PathBuf};

use wirebend_api::{
    BowChoice, ClosingChoice, ClosingName, Command, ContinuumChoice, FacesChoice, FrameFiles, FrameRequest,
    LoadsChoice, Output, ToleranceRequest, ToleranceSubject,
};

use super::{choices, design, input};
use crate::args::frame::{ClosingArgs, FrameArgs, ToleranceArgs};
use crate::args::{ChoiceArgs, DesignArgs};
use crate::usage::WrongUse;

pub(super) fn frame(args: FrameArgs) -> anyhow::Result<Command> {
    let faces = faces(&args.closing)?;
    let named = [&args.vtk, &args.csv, &args.conmech, &args.glb, &args.closed_vtk];
    if named.into_iter().flatten().any(|path| path == Path::new("-")) {
        let words = "results go to files: name one after --vtk, --csv, --conmech, --glb or --closed-vtk";
        return Err(WrongUse(words.to_owned()).into());
    }
    if args.force && named.iter().all(|file| file.is_none()) {
        let words = "--force replaces files: name one after --vtk, --csv, --conmech, --glb or --closed-vtk";
        return Err(WrongUse(words.to_owned()).into());
    }
    if !args.close && (args.closing.closing.is_some() || args.closing.faces.is_some()) {
        let words = "--closing and --faces are for joints that are closed: give --close and --errors, too";
        return Err(WrongUse(words.to_owned()).into());
    }
    let walk = args.choices.walk();
    if !args.close && !walk.is_empty() {
        let words = "only with --close and --errors, for the wires whose joints are closed";
        return Err(WrongUse(format!("{words}: {}", walk.join(", "))).into());
    }
    no_looks(&args.choices)?;
    if args.seed.is_some() && args.bow.is_none() && (!args.close || args.expected) {
        let words = "--seed is for wires that are drawn and for struts that bow: give --close without --expected, or --bow";
        return Err(WrongUse(words.to_owned()).into());
    }
    let seed = args.seed.unwrap_or(1);
    let force = args.force;
    let file = |path: PathBuf| Output { path, force };
    let loads = args.loads.as_deref().map(input).transpose()?;
    let close = args.errors.filter(|_| args.close).map(|errors| ClosingChoice {
        errors,
        closing: args.closing.closing.unwrap_or(ClosingName::Aligned),
        runs: if args.expected { 0 } else { args.runs },
        seed,
        faces,
        vtk: args.closed_vtk.map(file),
    });
    Ok(Command::Frame(FrameRequest {
        design: design(&args.design)?,
        choices: choices(args.choices)?,
        supports: args.supports,
        loads: loads.map(|file| LoadsChoice { file, case: args.load_case }),
        forces: Vec::new(),
        gravity: args.gravity.map(|gravity| gravity.0),
        files: Box::new(FrameFiles {
            vtk: args.vtk.map(file),
            csv: args.csv.map(file),
            conmech: args.conmech.map(file),
            glb: args.glb.map(file),
            displacement_scale: args.displacement_scale,
        }),
        modes: args.modes,
        pieces: args.pieces,
        bow: args.bow.map(|share| BowChoice { share, seed }),
        close,
    }))
}

/// No wire is looked at while it is bent.
fn no_looks(choices: &ChoiceArgs) -> Result<(), WrongUse> {
    let looks = choices.looks();
    let words = "wires that are bent, as plan and check show it";
    if looks.is_empty() { Ok(()) } else { Err(WrongUse(format!("only for {words}: {}", looks.join(", ")))) }
}

pub(super) fn tolerance(args: ToleranceArgs) -> anyhow::Result<Command> {
    no_looks(&args.choices)?;
    let machine = args.choices.machine.is_some().then_some("--machine");
    let of_wires: Vec<&str> =
        args.read.given().into_iter().chain(machine).chain(args.choices.walk()).collect();
    if args.continuum.is_some() && !of_wires.is_empty() {
        let words = "only with a wireframe, in place of --continuum";
        return Err(WrongUse(format!("{words}: {}", of_wires.join(", "))).into());
    }
    let of = match (args.continuum, args.file) {
        (Some(truss), _) => ToleranceSubject::Continuum(ContinuumChoice { bow: args.bow, ..truss }),
        (None, Some(file)) => ToleranceSubject::Design(design(&DesignArgs { file, read: args.read })?),
        (None, None) => return Err(WrongUse("no wireframe is named".to_owned()).into()),
    };
    Ok(Command::Tolerance(ToleranceRequest {
        of,
        choices: choices(args.choices)?,
        required: args.required,
        vary: args.vary,
        feed_share: args.feed_share,
        closing: args.closing.closing.unwrap_or(ClosingName::Aligned),
        faces: faces(&args.closing)?,
    }))
}

fn faces(args: &ClosingArgs) -> anyhow::Result<Option<FacesChoice>> {
    Ok(args.faces.as_deref().map(input).transpose()?.map(FacesChoice::Input))
}
