//! The remedies of errors in the words of the command line: its options and commands.

use std::io::Write;

use wirebend_api::{ErrorRemedy, InputName};

use crate::again::{abandon, quoted, resume};

/// Writes a line for each remedy.
pub(crate) fn write(out: &mut impl Write, remedies: &[ErrorRemedy]) -> std::io::Result<()> {
    of(remedies).iter().try_for_each(|advice| writeln!(out, "  help: {advice}"))
}

/// The remedies in words, in their order.
pub(crate) fn of(remedies: &[ErrorRemedy]) -> Vec<String> {
    remedies.iter().map(one).collect()
}

#[allow(clippy::too_many_lines, reason = "one arm a remedy")]
fn one(remedy: &ErrorRemedy) -> String {
    use ErrorRemedy as R;
    match remedy {
        R::CheckReadable => "check that it exists and may be read".to_owned(),
        R::CheckRightFile => "check that it is the right file".to_owned(),
        R::CheckDisk => "check that the folder can be written to and the disk has room".to_owned(),
        R::CorrectFile => "correct the file there, or export it again".to_owned(),
        R::ExportAgain => "export or download the file again".to_owned(),
        R::ExportWithout { part } => format!("export the file again without {part}"),
        R::ExportAs { form } => format!("export or save it as {form}"),
        R::ExportResolved => "export the file again with its parts resolved".to_owned(),
        R::OpenModel => "name the model or the drawing itself".to_owned(),
        R::PutFilesBeside => "put these files beside it".to_owned(),
        R::OpenFromFolder => "open the file itself from its folder, with these files beside it".to_owned(),
        R::SimplifyModel => "simplify the model, or export less of it".to_owned(),
        R::RepairMesh => "repair the mesh and export it again".to_owned(),
        R::NameColumns { columns } => format!("name the columns in a header line: {columns}"),
        R::SplitBend => "write it as two bends".to_owned(),
        R::ChooseFileFormat => "say which format it is with --from FORMAT, or export one of these".to_owned(),
        R::ChooseUnit => "say what the numbers measure with --units UNIT".to_owned(),
        R::CheckScale => "check --units and --scale".to_owned(),
        R::LeaveOutLayers => "leave out --layer".to_owned(),
        R::ReadAgain => "read the file again".to_owned(),
        R::ImportAgain => "import the model again".to_owned(),
        R::UseLastCopy => "take its last good copy, or undo what was changed by hand".to_owned(),
        R::OpenAsItIs => "use the command for that kind of file".to_owned(),
        R::UpdateProgram => "update the program".to_owned(),
        R::ChooseOtherFile => "name another file".to_owned(),
        R::Overwrite { .. } => "replace it with --force".to_owned(),
        R::CorrectInput { input } => format!("correct {}", option(*input)),
        R::LeaveOut { inputs } => {
            let options: Vec<&str> = inputs.iter().map(|input| option(*input)).collect();
            format!("leave out {}", options.join(", "))
        }
        R::ChooseKnown { near, known } => choice(near, known),
        R::ChooseLoadCase { known } => format!("name one with --load-case: {}", known.join(", ")),
        R::FreeVertex => "free the support, or remove the joint, first".to_owned(),
        R::UseRadius { radius } => format!("use a radius of {radius}, the nearest that can be made"),
        R::CutByHand => "leave out --cut, and cut each piece off by hand".to_owned(),
        R::LengthenEdges => "make the edges at the corner longer".to_owned(),
        R::EnterLength => "give a length of more than 0".to_owned(),
        R::EnterAngle => "give an angle of more than 0° and at most 180°".to_owned(),
        R::SelectTwoEdges => "name the two edges".to_owned(),
        R::MoveEndsApart => "move one of its ends".to_owned(),
        R::MoveOutOfLine => "move a vertex out of the line first".to_owned(),
        R::MoveEndAlone => "move its end without the rest".to_owned(),
        R::CorrectProfile => "correct the profile".to_owned(),
        R::AddKey { text } => format!("add {text}"),
        R::SeeSchema => "see the JSON Schema in machine-profiles/schema/".to_owned(),
        R::MoveFile { folder } => format!("move the file to {folder}"),
        R::RenameFile { name } => format!("rename the file to {name}"),
        R::ChooseOtherId => "choose another id".to_owned(),
        R::InheritFrom { ids } if ids.is_empty() => "inherit from a complete profile".to_owned(),
        R::InheritFrom { ids } => format!("inherit from {} to change only what differs", ids.join(" or ")),
        R::UseChild => "use a profile that inherits from it".to_owned(),
        R::RemoveParent => "remove one \"inherits\"".to_owned(),
        R::ChooseKind { kinds } => {
            let options: Vec<String> = kinds.iter().map(|kind| format!("--kind {kind}")).collect();
            format!("say which is meant with {}", options.join(" or "))
        }
        R::CopyProfile => "copy it with `wirebend profile new`, and change the copy".to_owned(),
        R::SetHome => "set HOME".to_owned(),
        R::ChooseMachine { known } => format!("choose one with --machine ID: {}", known.join(", ")),
        R::ChooseMachineAndMaterial => {
            "name the machine and the wire that it was compensated for with --machine and --material".to_owned()
        }
        R::TakeAsNominal => "take it as it stands with --program nominal".to_owned(),
        R::TurnBack => "turn it back into the design with --program compensated".to_owned(),
        R::TakeFaceEdges => "take the edges of its faces with --face-edges".to_owned(),
        R::ImportFaceEdges => "import its model again with --face-edges".to_owned(),
        R::TraceSurface => "trace a wireframe on it in the window".to_owned(),
        R::OpenAsWireframe => "use it as a wireframe".to_owned(),
        R::ExportFormat { format } => format!("export the machine's own program: --format {format}"),
        R::WatchFirstWire => "run the first wire slowly, and watch for collisions".to_owned(),
        R::PlanAgain => "plan the design again with `wirebend plan`".to_owned(),
        R::PlanForMachine { machine: Some(machine) } => {
            format!("plan the design again with --machine {}", quoted(machine))
        }
        R::PlanForMachine { machine: None } => {
            "plan the design with the --machine that reads it".to_owned()
        }
        R::PlanWithinLimit => "plan the design again for a machine profile with that limit".to_owned(),
        R::MakeJob => {
            "make a job of a design with `wirebend plan DESIGN --machine ID -o JOB.wbjob`".to_owned()
        }
        R::UseJob => "use `wirebend export` or `wirebend simulate` on the job".to_owned(),
        R::UseDesign => "use this command on its design".to_owned(),
        R::UseProgramFile => {
            "use --keep-order with the file of a program, such as WireBend-kit text, a Pensa script or an LRA table"
                .to_owned()
        }
        R::ImportOriginal => "import the original again".to_owned(),
        R::FixFindings => "fix what `wirebend check` finds".to_owned(),
        R::IgnoreFindings => "go on anyway with --despite-errors".to_owned(),
        R::SaveDesign => "save the design".to_owned(),
        R::OpenDesign => "resume it by its job: `wirebend run JOB --resume`".to_owned(),
        R::TrustDriver { file, again } => {
            let when = if *again {
                "if that was an update of yours"
            } else {
                "a driver is not accepted yet: if you trust its author"
            };
            let file = quoted(&file.display().to_string());
            format!("{when}, accept it with `wirebend driver trust {file}`")
        }
        R::ListDrivers => "see `wirebend drivers`".to_owned(),
        R::NameDriverFolder => "name the folder of another driver with --driver-path".to_owned(),
        R::ReportToAuthor => "report this to the author of the driver".to_owned(),
        R::FollowDriver { advice } => advice.clone(),
        R::UpdateDriver => "use a newer build of the driver".to_owned(),
        R::ChangeDriverSetting => "change the setting in the machine's profile".to_owned(),
        R::RestrictAccess { path } => {
            let path = quoted(&path.display().to_string());
            format!("put it where only you may write, or run `chmod o-w {path}`")
        }
        R::InstallFont => "write an SVG, or install a font (apt-get install fonts-dejavu-core)".to_owned(),
        R::BendTestPiece => {
            "bend a test piece first, and enter its springback in the material's profile".to_owned()
        }
        R::ResetTrust => "correct the list, or delete it and accept the drivers again".to_owned(),
        R::ChoosePort { known } if known.is_empty() => {
            "say with --port where the machine is; the driver lists no port".to_owned()
        }
        R::ChoosePort { known } => format!("say with --port where the machine is: {}", known.join(", ")),
        R::ExportFile => "use `wirebend export`, and the machine's own program".to_owned(),
        R::AnswerEachPiece => "leave out --yes: you are asked before each piece".to_owned(),
        R::ConfirmMotion => "check that it is safe, then confirm with --yes".to_owned(),
        R::ConfirmZero => "bring the axes there, and confirm with --axes-at-zero; --yes is not enough".to_owned(),
        R::StateHead => {
            "look at it, and state its angle from where its cable is unwound with --head-at DEGREES".to_owned()
        }
        R::TurnHeadBack => {
            "switch the motors off, turn it back by hand, or turn it with `wirebend jog`, then state --head-at=0"
                .to_owned()
        }
        R::TurnHeadLess => "turn it less, or the other way".to_owned(),
        R::TurnAxesBack => "turn the axes back with `wirebend jog`".to_owned(),
        R::Home => "home the machine before it moves again".to_owned(),
        R::ArmAgain => "arm the machine again".to_owned(),
        R::ArmOrJog => "arm the machine, or move it by hand".to_owned(),
        R::StartOrDisarm => "start the wire, or disarm it first".to_owned(),
        R::ContinueOrStop => "resume it, or stop it first".to_owned(),
        R::PauseOrStop => "pause or stop it first".to_owned(),
        R::Wait => "wait until that is over".to_owned(),
        R::Stop => "stop the machine there".to_owned(),
        R::CutPower => "cut the power of the machine, and look at it".to_owned(),
        R::CheckPowerAndPort => "check that it has power and that the port is right".to_owned(),
        R::Connect => "connect it first".to_owned(),
        R::ConnectAgain => "connect the machine again".to_owned(),
        R::ConnectAt { port } => format!("name its port with --port {}", quoted(port)),
        R::AskAgain => "confirm it again".to_owned(),
        R::Answer => "answer the question first".to_owned(),
        R::UseOtherMachine => "use another machine, or do it by hand".to_owned(),
        R::LookAtWire => "look at the wire".to_owned(),
        R::WriteSettings { machine, port } => format!(
            "write the settings with `wirebend machine-settings --machine {} --port {} --write`",
            quoted(machine),
            quoted(port)
        ),
        R::SetMachine => {
            "its driver cannot write them: set them with the machine's own program, or correct the profile and plan the job again"
                .to_owned()
        }
        R::AcceptSettings => "bend wires anyway with --accept-settings".to_owned(),
        R::CloseOtherPrograms => "close other programs and try again".to_owned(),
        R::ChooseWire => "say which wire is meant with --wire".to_owned(),
        R::ChooseJob => "name the job".to_owned(),
        R::ResumeRun { run } => format!("resume it with `{}`", resume(run)),
        R::AbandonRun { run } => format!("give it up with `{}`", abandon(run)),
        R::AnswerDoubt { run, step, counted } => {
            let command = resume(run);
            let counted = if *counted {
                format!(" `{command}=as-counted:{step}` if what the machine counts is right,")
            } else {
                String::new()
            };
            format!(
                "look at the wire, and say `{command}=made:{step}` if the step is complete, `{command}=not-made:{step}` if nothing of it is done,{counted} or `{command}=part:{step}:MM:DEGREES` with how much was fed and turned: the rest follows, with its bend from the beginning"
            )
        }
        R::ResumeWithoutAnswer { run } => format!("say `{}` without that answer", resume(run)),
        R::StopAndAnswer { run } => {
            let command = resume(run);
            format!(
                "with `{command}=made:N`, `{command}=not-made:N` or `{command}=part:N:MM:DEGREES` for the first unknown step N, the machine is stopped and the answer is taken"
            )
        }
        R::MeasureStep => "measure it".to_owned(),
        R::BeginAnew => "give the wire up with --abandon, and bend it anew".to_owned(),
        R::NameRunsFolder => "name a folder with --runs-folder".to_owned(),
        R::ListRuns => "see `wirebend runs`".to_owned(),
        R::RecordAgain => "record the moves again with `wirebend jog … --record FILE`".to_owned(),
        R::ReplayHere { machine } => format!("replay it anyway with --machine {}", quoted(machine)),
        R::RecordFirst => "move the machine by hand with recording on".to_owned(),
    }
}

/// "did you mean a or b? known: a, b, c".
fn choice(near: &[String], known: &[String]) -> String {
    let quoted: Vec<String> = near.iter().map(|id| format!("`{id}`")).collect();
    let near = (!near.is_empty()).then(|| format!("did you mean {}?", quoted.join(" or ")));
    let known = (!known.is_empty()).then(|| format!("known: {}", known.join(", ")));
    let said: Vec<String> = near.into_iter().chain(known).collect();
    if said.is_empty() { "there is none yet".to_owned() } else { said.join(" ") }
}

/// The option by which something is given.
const fn option(input: InputName) -> &'static str {
    match input {
        InputName::Format => "--from",
        InputName::Scale => "--scale",
        InputName::Units => "--units",
        InputName::Weld => "--weld",
        InputName::FaceEdges => "--face-edges",
        InputName::CentrelineRadius => "--clr",
        InputName::Tolerance => "--tolerance",
        InputName::ShortestEdge => "--shortest-edge",
        InputName::Layers => "--layer",
        InputName::Handedness => "--handedness",
        InputName::Program => "--program",
        InputName::Machine => "--machine",
        InputName::Material => "--material",
        InputName::Double => "--double",
        InputName::Detours => "--detours",
        InputName::Wires => "--wires",
        InputName::Closed => "--closed",
        InputName::Start => "--start",
        InputName::Reverse => "--reverse",
        InputName::KeepOrder => "--keep-order",
        InputName::Collisions => "--collisions",
        InputName::AvoidCollisions => "--avoid-collisions",
        InputName::Clearance => "--clearance",
        InputName::Sag => "--sag",
        InputName::Runs => "--runs",
        InputName::Within => "--within",
        InputName::Supports => "--supports",
        InputName::Gravity => "--gravity",
        InputName::Loads => "--loads",
        InputName::Modes => "--modes",
        InputName::Pieces => "--pieces",
        InputName::Bow => "--bow",
        InputName::Faces => "--faces",
        InputName::Requirements => "--require",
        InputName::Vary => "--vary",
        InputName::FeedShare => "--feed-share",
        InputName::Continuum => "--continuum",
        InputName::Expected => "--expected",
        InputName::Epsilon => "--epsilon",
        InputName::TimeLimit => "--limit",
        InputName::GroupBy => "--group-by",
        InputName::ProfileId => "the id",
        InputName::ProfileName => "--name",
        InputName::FormatSettings => "--set",
        InputName::Moves => "the moves, such as f 10, r 90, b 45 or home",
        InputName::Resume => "--resume",
        InputName::Abandon => "--abandon",
        InputName::SimulatedAs => "--simulated-machine and --simulated-material",
        InputName::Readings => "the readings, such as angle-40:1=38.5,39",
        InputName::ProfileValues => "the values, such as bend.orbit_offset_mm=11.6",
        InputName::Date => "--date",
        InputName::ProfileKeys => "the keys, such as bend.orbit_offset_mm",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_that_is_not_known_is_answered_with_those_that_are() {
        let words = |words: &[&str]| words.iter().map(|word| (*word).to_owned()).collect::<Vec<_>>();
        let remedy = ErrorRemedy::ChooseKnown { near: words(&["pensa"]), known: words(&["grbl", "pensa"]) };
        assert_eq!(of(&[remedy]), ["did you mean `pensa`? known: grbl, pensa"]);
        assert_eq!(choice(&[], &[]), "there is none yet");
    }

    #[test]
    fn a_file_is_accepted_with_a_command_that_a_shell_takes() {
        let remedy = ErrorRemedy::TrustDriver { file: "/my drivers/x.so".into(), again: false };
        assert!(one(&remedy).ends_with("`wirebend driver trust '/my drivers/x.so'`"));
    }
}
