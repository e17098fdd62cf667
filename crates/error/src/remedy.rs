//! What can be done about an error.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::Serialize;

use crate::input::InputName;

/// What a person can do about an error, with what it takes to offer it. Several remedies of an error are done in their order, or are
/// a choice; each front end words them.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(tag = "remedy", rename_all = "kebab-case")]
pub enum ErrorRemedy {
    // Files
    /// See that the file exists and may be read.
    CheckReadable,
    /// See that it is the right file.
    CheckRightFile,
    /// See that the folder can be written to and the disk has room.
    CheckDisk,
    /// Correct the file where the error is.
    CorrectFile,
    /// Export the file again.
    ExportAgain,
    /// Export the file again without something that is not read.
    ExportWithout {
        /// What is not read, as a noun.
        part: String,
    },
    /// Export or save the file in another form.
    ExportAs {
        /// The form, such as a format.
        form: String,
    },
    /// Export the model with its parts resolved.
    ExportResolved,
    /// Open the model or the drawing itself.
    OpenModel,
    /// Put the files that it names beside it.
    PutFilesBeside,
    /// Open the file from its folder.
    OpenFromFolder,
    /// Simplify the model, or export less of it.
    SimplifyModel,
    /// Repair the mesh.
    RepairMesh,
    /// Name the columns of the table in a header line.
    NameColumns {
        /// The names.
        columns: String,
    },
    /// Write the bend as two.
    SplitBend,
    /// Say which format it is.
    ChooseFileFormat,
    /// Say what the numbers measure.
    ChooseUnit,
    /// Check unit and scale.
    CheckScale,
    /// Read the file without choosing layers.
    LeaveOutLayers,
    /// Read the file again, as it is now.
    ReadAgain,
    /// Import the model again.
    ImportAgain,
    /// Take the last good copy of the document.
    UseLastCopy,
    /// Open the document as what it is.
    OpenAsItIs,
    /// Update the program.
    UpdateProgram,
    /// Write to another file.
    ChooseOtherFile,
    /// Replace the file.
    Overwrite {
        /// The file.
        path: PathBuf,
    },

    // What was asked for
    /// Give another value.
    CorrectInput {
        /// What it is a value of.
        input: InputName,
    },
    /// Leave something out that has no effect.
    LeaveOut {
        /// What.
        inputs: Vec<InputName>,
    },
    /// Take one of those that there are.
    ChooseKnown {
        /// Those with similar names.
        near: Vec<String>,
        /// All.
        known: Vec<String>,
    },
    /// Take one of the load cases of a file.
    ChooseLoadCase {
        /// All.
        known: Vec<String>,
    },

    // Edits
    /// Give a length that an edge can have.
    EnterLength,
    /// Give an angle that two edges can have.
    EnterAngle,
    /// Select the two edges that the angle is between.
    SelectTwoEdges,
    /// Move the ends of the edge apart.
    MoveEndsApart,
    /// Move a vertex out of the line first.
    MoveOutOfLine,
    /// Let the end of the edge move without the rest.
    MoveEndAlone,
    /// Free the support, or remove the joint, first.
    FreeVertex,
    /// Round with another radius.
    UseRadius {
        /// The nearest that can be made, with its unit.
        radius: String,
    },
    /// Make the edges at the corner longer.
    LengthenEdges,

    // Profiles
    /// Correct the profile.
    CorrectProfile,
    /// Add a key to the profile.
    AddKey {
        /// What to write.
        text: String,
    },
    /// Look into the JSON Schema of profiles.
    SeeSchema,
    /// Move the file to another folder.
    MoveFile {
        /// The folder.
        folder: String,
    },
    /// Rename the file.
    RenameFile {
        /// Its new name.
        name: String,
    },
    /// Choose another id.
    ChooseOtherId,
    /// Inherit from a profile.
    InheritFrom {
        /// Those that it can be.
        ids: Vec<String>,
    },
    /// Use a profile that inherits from this one.
    UseChild,
    /// Remove one of the parents.
    RemoveParent,
    /// Say which kind of profile is meant.
    ChooseKind {
        /// The kinds.
        kinds: Vec<String>,
    },
    /// Copy the profile, and change the copy.
    CopyProfile,
    /// Set the variable HOME.
    SetHome,

    // Designs and jobs
    /// Choose a machine.
    ChooseMachine {
        /// The machines.
        known: Vec<String>,
    },
    /// Name the machine and the material that the program was compensated for.
    ChooseMachineAndMaterial,
    /// Take the program as the design.
    TakeAsNominal,
    /// Turn the program back into the design.
    TurnBack,
    /// Take the edges of the model's faces.
    TakeFaceEdges,
    /// Import the model of a document again, with the edges of its faces.
    ImportFaceEdges,
    /// Trace a wireframe on the surface.
    TraceSurface,
    /// Open the file as a wireframe.
    OpenAsWireframe,
    /// Plan the design again.
    PlanAgain,
    /// Plan the design for a machine.
    PlanForMachine {
        /// The machine; null for any that can do it.
        machine: Option<String>,
    },
    /// Plan the design with the limit in the machine's profile.
    PlanWithinLimit,
    /// Plan the design, to have a job.
    MakeJob,
    /// Export or simulate the job.
    UseJob,
    /// Use the design, not its job.
    UseDesign,
    /// Use the file of a program.
    UseProgramFile,
    /// Import the original again.
    ImportOriginal,
    /// Fix what the checks find.
    FixFindings,
    /// Write the program although the machine cannot make it.
    IgnoreFindings,
    /// Export it in the machine's own format, which says all of it.
    ExportFormat {
        /// Its id.
        format: String,
    },
    /// Run it slowly at the machine first, and watch it.
    WatchFirstWire,
    /// Install a font, or write an SVG.
    InstallFont,
    /// Bend a test piece, and enter its springback in the material's profile.
    BendTestPiece,
    /// Save the open design.
    SaveDesign,
    /// Open the design that the job was planned from.
    OpenDesign,

    // Drivers
    /// Accept a driver.
    TrustDriver {
        /// Its library.
        file: PathBuf,
        /// It was accepted before and has been changed.
        again: bool,
    },
    /// Keep other users from writing to a file or folder.
    RestrictAccess {
        /// The file or folder.
        path: PathBuf,
    },
    /// See which drivers there are.
    ListDrivers,
    /// Name the folder of a driver.
    NameDriverFolder,
    /// Report it to the author of the driver.
    ReportToAuthor,
    /// Do what the driver says.
    FollowDriver {
        /// In its words.
        advice: String,
    },
    /// Take a newer driver.
    UpdateDriver,
    /// Change a setting of the driver.
    ChangeDriverSetting,
    /// Correct the list of accepted drivers, or delete it and accept them again.
    ResetTrust,

    // Machines
    /// Say at which port the machine is.
    ChoosePort {
        /// Those that its driver lists.
        known: Vec<String>,
    },
    /// Write a file for the machine's own program.
    ExportFile,
    /// See that the machine may move, and confirm it.
    ConfirmMotion,
    /// Answer before each piece, instead of beforehand.
    AnswerEachPiece,
    /// Bring every axis to zero, and confirm it.
    ConfirmZero,
    /// Say where the head stands.
    StateHead,
    /// Turn the head back to zero by hand, and say so.
    TurnHeadBack,
    /// Turn the head less, or the other way.
    TurnHeadLess,
    /// Turn the axes back by hand.
    TurnAxesBack,
    /// Home the machine.
    Home,
    /// Arm the machine again.
    ArmAgain,
    /// Arm a wire, or move by hand.
    ArmOrJog,
    /// Start or disarm the wire.
    StartOrDisarm,
    /// Resume it after the pause, or stop it.
    ContinueOrStop,
    /// Pause or stop the wire.
    PauseOrStop,
    /// Wait until it is over.
    Wait,
    /// Stop the machine.
    Stop,
    /// Cut the power of the machine.
    CutPower,
    /// See whether the machine has power and the port is right.
    CheckPowerAndPort,
    /// Connect the machine.
    Connect,
    /// Disconnect the machine, and connect it again.
    ConnectAgain,
    /// Connect the machine at this port.
    ConnectAt {
        /// The port.
        port: String,
    },
    /// Ask the person again.
    AskAgain,
    /// Answer the open question.
    Answer,
    /// Use another machine, or do it by hand.
    UseOtherMachine,
    /// Look at the wire.
    LookAtWire,
    /// Write the settings of the profile to the machine.
    WriteSettings {
        /// The machine.
        machine: String,
        /// Where it is.
        port: String,
    },
    /// Set the machine with its own program, or correct the profile and plan the job again.
    SetMachine,
    /// Bend wires with the settings as they are.
    AcceptSettings,
    /// Close other programs.
    CloseOtherPrograms,

    // Runs
    /// Say which wire of the job is meant.
    ChooseWire,
    /// Say of which job it is.
    ChooseJob,
    /// Resume the wire.
    ResumeRun {
        /// The wire.
        run: RunTarget,
    },
    /// Give the wire up.
    AbandonRun {
        /// The wire.
        run: RunTarget,
    },
    /// Look at the wire, and say what became of a step.
    AnswerDoubt {
        /// The wire.
        run: RunTarget,
        /// The step, from 1.
        step: u32,
        /// The machine has counted how much of it is done.
        counted: bool,
    },
    /// Resume the wire without an answer about a step.
    ResumeWithoutAnswer {
        /// The wire.
        run: RunTarget,
    },
    /// Stop the machine, and say step by step what was done.
    StopAndAnswer {
        /// The wire.
        run: RunTarget,
    },
    /// Measure how much of the step is done.
    MeasureStep,
    /// Cut pieces off by hand.
    CutByHand,
    /// Give up the wire, or bend it again from the start.
    BeginAnew,
    /// Set the folder of journals and records.
    NameRunsFolder,
    /// See which records there are.
    ListRuns,
    /// Record the moves again.
    RecordAgain,
    /// Replay the moves on this machine anyway.
    ReplayHere {
        /// The machine.
        machine: String,
    },
    /// Make a recording first.
    RecordFirst,
}

/// A wire of a job that was begun.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct RunTarget {
    /// The job's file; null where it is in no file.
    pub job: Option<PathBuf>,
    /// Index of the wire, from 0; null where the job has no other.
    pub wire: Option<usize>,
    /// The port that was named.
    pub port: Option<String>,
    /// The machine that was named for a program.
    pub machine: Option<String>,
    /// The wire that was named for a program.
    pub material: Option<String>,
}
