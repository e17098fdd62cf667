//! From arguments to requests.

mod calibrate;
mod frame;
mod live;
mod sequence;

use std::io::Read;
use std::path::{Path, PathBuf};

use anyhow::Context;
use wirebend_api::{
    CheckRequest, Command, CompareRequest, DesignInput, DriverCheckRequest, DriverTrustRequest,
    DriversRequest, DumpRequest, ExportRequest, GenerateRequest, GeneratedShape, ImportRequest, Input,
    MachinesRequest, MaterialsRequest, Output, PlanChoices, PlanRequest, ProfileCheckRequest,
    ProfileExplainRequest, ProfileExportRequest, ProfileImportRequest, ProfileNewRequest, ProfilePlace,
    ProfileRevertRequest, ProfileSetRequest, SimulateRequest, StepPause, WiresRequest,
};

use crate::args::live::RunsCommand;
use crate::args::{
    ChoiceArgs, DangerArgs, DesignArgs, DriverCommand, GenerateCommand, OutputArgs, ProfileCommand, ReadArgs,
    Subcommands, WireRange,
};
use crate::contents::Contents;
use crate::usage::{BadInput, WrongUse};

/// The most that is read from standard input.
const MAX_BYTES: u64 = 512 << 20;

pub(crate) enum Prepared {
    /// To be run by the application.
    Command(Box<Command>, Contents),
    /// To be printed as it is.
    Text(Vec<u8>),
}

#[allow(clippy::too_many_lines, reason = "one arm a command")]
pub(crate) fn prepare(command: Subcommands) -> anyhow::Result<Prepared> {
    let written = |request| Prepared::Command(Box::new(request), Contents::Written);
    Ok(match command {
        Subcommands::Machines => written(Command::Machines(MachinesRequest {})),
        Subcommands::Materials => written(Command::Materials(MaterialsRequest {})),
        Subcommands::Drivers => written(Command::Drivers(DriversRequest {})),
        Subcommands::Driver(DriverCommand::Check { library }) => {
            written(Command::DriverCheck(DriverCheckRequest { library }))
        }
        Subcommands::Driver(DriverCommand::Trust { library, sha256 }) => {
            written(Command::DriverTrust(DriverTrustRequest { library, sha256 }))
        }
        Subcommands::Import { file, read, machine, material, output } => {
            let (output, contents) = place(output, true)?;
            let design = design(&DesignArgs { file, read })?;
            let request = ImportRequest { design, machine, material, output };
            Prepared::Command(Box::new(Command::Import(request)), contents)
        }
        Subcommands::Generate(GenerateCommand::Truss { rings, strut, depth, output }) => {
            let (output, contents) = place(output, true)?;
            let shape = GeneratedShape::Truss { rings, strut_mm: strut, depth_mm: depth };
            let request = GenerateRequest { shape, output };
            Prepared::Command(Box::new(Command::Generate(request)), contents)
        }
        Subcommands::Check { design: args, choices: chosen } => {
            written(Command::Check(CheckRequest { design: design(&args)?, choices: choices(chosen)? }))
        }
        Subcommands::Plan { design: args, choices: chosen, output, danger, compare, pauses } => {
            plan(&args, chosen, output, &danger, compare, pauses)?
        }
        Subcommands::Export { design: args, choices: chosen, format, settings, output, danger } => {
            let (output, contents) = place(output, true)?;
            let request = ExportRequest {
                design: design(&DesignArgs { file: args.file, read: args.read })?,
                choices: choices(chosen)?,
                format,
                settings: settings.into_iter().collect(),
                output,
                despite_errors: danger.despite_errors,
            };
            Prepared::Command(Box::new(Command::Export(request)), contents)
        }
        Subcommands::Simulate { job, noise, runs, seed, within, svg, png, force, collisions, clearance } => {
            if [&svg, &png].into_iter().flatten().any(|path| path == Path::new("-")) {
                return Err(
                    WrongUse("a picture goes to a file: name one after --svg or --png".to_owned()).into()
                );
            }
            if force && svg.is_none() && png.is_none() {
                let words = "--force replaces pictures: name one after --svg or --png";
                return Err(WrongUse(words.to_owned()).into());
            }
            let picture = |path: PathBuf| Output { path, force };
            let job = input(&job)?;
            let (svg, png) = (svg.map(picture), png.map(picture));
            written(Command::Simulate(SimulateRequest {
                job,
                noise,
                runs,
                seed,
                within_mm: within,
                svg,
                png,
                collisions,
                collision_margin_mm: clearance.clearance,
            }))
        }
        Subcommands::Frame(args) => written(frame::frame(args)?),
        Subcommands::Tolerance(args) => written(frame::tolerance(args)?),
        Subcommands::Sequence(args) => written(sequence::sequence(args)?),
        Subcommands::Run(args) => written(live::run(args)?),
        Subcommands::DryRun(args) => written(live::dry_run(args)?),
        Subcommands::Jog(args) => written(live::jog(args)?),
        Subcommands::Replay(args) => written(live::replay(args)?),
        Subcommands::Ports(args) => written(live::ports(args)),
        Subcommands::MachineSettings(args) => written(live::machine_settings(args)),
        Subcommands::Console(args) => written(live::console(args)?),
        Subcommands::Runs { command } => live::runs(command.unwrap_or(RunsCommand::List))?,
        Subcommands::Dump { stage, design: args, choices: chosen } => {
            written(Command::Dump(DumpRequest { stage, design: design(&args)?, choices: choices(chosen)? }))
        }
        Subcommands::Calibrate(command) => written(calibrate::calibrate(command)?),
        Subcommands::Profile(ProfileCommand::Set { id, values, source, measured, from, kind }) => {
            let folder = calibrate::own_folder("set HOME or XDG_CONFIG_HOME")?;
            let kind = kind.kind;
            let request = ProfileSetRequest { id, from, kind, values, source, measured, folder };
            written(Command::ProfileSet(request))
        }
        Subcommands::Profile(ProfileCommand::Revert { id, keys, kind }) => {
            written(Command::ProfileRevert(ProfileRevertRequest { id, kind: kind.kind, keys }))
        }
        Subcommands::Profile(ProfileCommand::Export { id, kind, alone, output }) => {
            let (output, contents) = place(output, true)?;
            let request = ProfileExportRequest { id, kind: kind.kind, output, alone };
            Prepared::Command(Box::new(Command::ProfileExport(request)), contents)
        }
        Subcommands::Profile(ProfileCommand::Import { file, id }) => {
            let folder = calibrate::own_folder("set HOME or XDG_CONFIG_HOME")?;
            written(Command::ProfileImport(ProfileImportRequest { file, id, folder }))
        }
        Subcommands::Profile(ProfileCommand::Check { files }) => {
            written(Command::ProfileCheck(ProfileCheckRequest { files }))
        }
        Subcommands::Profile(ProfileCommand::New { id, from, kind, name, all, output }) => {
            let force = output.force;
            let (place, contents) = profile_place(output.output)?;
            let kind = kind.kind;
            let request = ProfileNewRequest { id, inherits: from, kind, name, all, place, force };
            Prepared::Command(Box::new(Command::ProfileNew(request)), contents)
        }
        Subcommands::Profile(ProfileCommand::Explain { id, kind }) => {
            written(Command::ProfileExplain(ProfileExplainRequest { id, kind: kind.kind }))
        }
        Subcommands::Completions { shell } => {
            let mut text = Vec::new();
            clap_complete::generate(shell, &mut crate::command(), "wirebend", &mut text);
            Prepared::Text(text)
        }
        Subcommands::Man => {
            let mut text = Vec::new();
            clap_mangen::Man::new(crate::command()).render(&mut text)?;
            Prepared::Text(text)
        }
    })
}

/// One plan, or several compared.
fn plan(
    args: &DesignArgs,
    chosen: ChoiceArgs,
    output: OutputArgs,
    danger: &DangerArgs,
    compare: Vec<String>,
    pauses: Vec<StepPause>,
) -> anyhow::Result<Prepared> {
    let design = design(args)?;
    let written = |command| Ok(Prepared::Command(Box::new(command), Contents::Written));
    if !compare.is_empty() {
        if chosen.wires.is_some_and(WireRange::is_several) {
            let words = "a range of wires cannot be combined with --compare: give one number of wires";
            return Err(WrongUse(words.to_owned()).into());
        }
        return written(Command::Compare(CompareRequest {
            design,
            choices: choices(chosen)?,
            against: compare,
        }));
    }
    if let Some(WireRange { from, to }) = chosen.wires.filter(|range| range.is_several()) {
        if output.output.is_some()
            || output.force
            || danger.despite_errors
            || chosen.sag
            || !pauses.is_empty()
        {
            let words = "numbers of wires are compared, and no job is made: give one number of wires";
            return Err(WrongUse(words.to_owned()).into());
        }
        let choices = choices(ChoiceArgs { wires: None, ..chosen })?;
        return written(Command::Wires(WiresRequest { design, choices, from, to }));
    }
    if danger.despite_errors && output.output.is_none() {
        let words = "--despite-errors is for a job that is written: name its file with -o";
        return Err(WrongUse(words.to_owned()).into());
    }
    let (output, contents) = place(output, false)?;
    let request = PlanRequest {
        design,
        choices: choices(chosen)?,
        make_job: contents == Contents::StandardOutput,
        output,
        despite_errors: danger.despite_errors,
        pauses,
    };
    Ok(Prepared::Command(Box::new(Command::Plan(request)), contents))
}

/// Where a result goes: to a file, to the standard output for `-`, and without a name to the
/// standard output where the result is all that the command is for.
fn place(args: OutputArgs, is_the_point: bool) -> Result<(Option<Output>, Contents), WrongUse> {
    Ok(match args.output {
        Some(path) if path != Path::new("-") => (Some(Output { path, force: args.force }), Contents::Written),
        Some(_) => (None, Contents::StandardOutput),
        None if args.force => {
            return Err(WrongUse("--force replaces a file: name it with -o".to_owned()));
        }
        None if is_the_point => (None, Contents::StandardOutput),
        None => (None, Contents::Written),
    })
}

/// Where a new profile goes: to the person's own folder unless a file is named.
fn profile_place(output: Option<PathBuf>) -> Result<(ProfilePlace, Contents), WrongUse> {
    Ok(match output {
        Some(path) if path == Path::new("-") => (ProfilePlace::Returned, Contents::StandardOutput),
        Some(path) => (ProfilePlace::File(path), Contents::Written),
        None => {
            let homeless = "there is no home folder with profiles of your own: name a file with -o";
            let folder =
                wirebend_api::Places::of_person().own.ok_or_else(|| WrongUse(homeless.to_owned()))?;
            (ProfilePlace::Folder(folder), Contents::Written)
        }
    })
}

fn input(file: &Path) -> anyhow::Result<Input> {
    if file != Path::new("-") {
        return Ok(Input::File(file.to_owned()));
    }
    Ok(Input::Bytes { name: "standard input".to_owned(), bytes: standard_input()? })
}

fn standard_input() -> anyhow::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let taken = std::io::stdin().lock().take(MAX_BYTES + 1).read_to_end(&mut bytes);
    taken.context("standard input cannot be read")?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(BadInput(format!("standard input is longer than {MAX_BYTES} bytes: give a file")).into());
    }
    Ok(bytes)
}

fn design(args: &DesignArgs) -> anyhow::Result<DesignInput> {
    let ReadArgs {
        from,
        scale,
        units,
        weld,
        face_edges,
        clr,
        tolerance,
        shortest_edge,
        layers,
        handedness,
        program,
    } = &args.read;
    Ok(DesignInput {
        input: input(&args.file)?,
        format: *from,
        scale: *scale,
        units: *units,
        weld_mm: *weld,
        face_edges: *face_edges,
        clr_mm: *clr,
        tolerance_mm: *tolerance,
        shortest_edge: *shortest_edge,
        layers: layers.clone(),
        handedness: *handedness,
        program: *program,
    })
}

fn choices(args: ChoiceArgs) -> Result<PlanChoices, WrongUse> {
    let ChoiceArgs {
        machine,
        material,
        double,
        detours,
        wires,
        closed,
        start,
        reverse,
        keep_order,
        collisions,
        avoid_collisions,
        effort,
        search_seed,
        weights,
        sag,
        clearance,
    } = args;
    if wires.is_some_and(WireRange::is_several) {
        return Err(WrongUse("a range of wires is for `plan` alone: give one number of wires".to_owned()));
    }
    let wires = wires.map(|range| range.to);
    Ok(PlanChoices {
        machine,
        material,
        double,
        detours,
        wires,
        closed,
        start,
        reverse,
        keep_order,
        collisions,
        avoid_collisions,
        search_effort: effort,
        search_seed,
        search_weights: weights,
        sag,
        collision_margin_mm: clearance.clearance,
    })
}
