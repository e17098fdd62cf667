//! The arguments.

pub(crate) mod calibrate;
pub(crate) mod frame;
pub(crate) mod live;
mod profile;
pub(crate) mod sequence;
mod shared;

use std::path::PathBuf;

use clap::{Parser, Subcommand};
use clap_complete::Shell;
use wirebend_api::{StageName, StepPause};

pub(crate) use calibrate::CalibrateCommand;
use frame::{FrameArgs, ToleranceArgs};
use live::{
    ConsoleArgs, DryRunArgs, JogArgs, MachineSettingsArgs, PortsArgs, ReplayArgs, RunArgs, RunsCommand,
};
pub(crate) use profile::ProfileCommand;
use sequence::SequenceArgs;
pub(crate) use shared::{
    ChoiceArgs, ClearanceArgs, DangerArgs, DesignArgs, ExportedArgs, OutputArgs, ReadArgs, WireRange,
};
use shared::{parse_pause, parse_setting, stage_parser};

const AFTER: &str = "\
Exit status: 0 done · 2 usage error · 3 bad input · 4 not feasible on this machine (the report is \
still printed) · 5 machine or driver failure, or a file that cannot be written · 6 it is not known \
whether the machine stands: cut its power · 130 stopped by the person.
Messages go to the error stream, results to the standard output; - stands for standard input or output.";

/// From a wireframe to a bent wire: check, plan, compensate, export, simulate.
#[derive(Debug, Parser)]
#[command(name = "wirebend", version, after_help = AFTER, arg_required_else_help = true)]
pub struct Cli {
    #[command(subcommand)]
    pub(crate) command: Subcommands,
    /// Print one JSON object on the standard output instead of a report
    #[arg(long, global = true, display_order = 100)]
    pub(crate) json: bool,
    /// Show more of what is done: -v, -vv, -vvv
    #[arg(short, long, action = clap::ArgAction::Count, global = true, display_order = 101)]
    pub(crate) verbose: u8,
    /// Use the profiles in this folder too (machines/, materials/, noise/, strut-builders/)
    #[arg(long, value_name = "FOLDER", global = true, display_order = 102)]
    pub(crate) profiles: Vec<PathBuf>,
    /// Look for drivers in this folder too, or take this library; they are used once they are trusted
    #[arg(long, value_name = "PATH", global = true, display_order = 103)]
    pub(crate) driver_path: Vec<PathBuf>,
    /// Keep journals and records of wires in this folder instead of your own
    #[arg(long, value_name = "FOLDER", global = true, display_order = 104)]
    pub(crate) runs_folder: Option<PathBuf>,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Subcommands {
    /// List the machines
    #[command(after_help = "Example:\n  wirebend machines")]
    Machines,
    /// List the materials
    #[command(after_help = "Example:\n  wirebend materials --json")]
    Materials,
    /// List the drivers, what they write and which of them wait to be trusted
    #[command(after_help = "Examples:\n  wirebend drivers\n  wirebend drivers --driver-path ~/my-drivers")]
    Drivers,
    /// Check a third-party driver, or accept it
    #[command(subcommand)]
    Driver(DriverCommand),
    /// Read a model, a drawing, a table or a program into a .wirebend document, or into an .obj of its wireframe
    #[command(
        after_help = "Examples:\n  wirebend import examples/bunny.obj --face-edges -o bunny.wirebend\n  wirebend import bunny.wirebend -o bunny-wires.obj"
    )]
    Import {
        /// File to read, or - for standard input
        #[arg(value_name = "FILE")]
        file: PathBuf,
        #[command(flatten)]
        read: ReadArgs,
        /// Machine that a compensated program was written for, by id
        #[arg(long, short, value_name = "ID")]
        machine: Option<String>,
        /// Wire that it was written for, by id
        #[arg(long, value_name = "ID", requires = "machine")]
        material: Option<String>,
        #[command(flatten)]
        output: OutputArgs,
    },
    /// Make a design from a few figures
    #[command(subcommand)]
    Generate(GenerateCommand),
    /// Report what a machine cannot make of a wireframe, and why; without a machine, what none can
    #[command(
        after_help = "Examples:\n  wirebend check examples/house.obj --machine wirebend-kit\n  wirebend check examples/house.obj"
    )]
    Check {
        #[command(flatten)]
        design: DesignArgs,
        #[command(flatten)]
        choices: ChoiceArgs,
    },
    /// Find the route, make the program, compensate it, and write the job
    #[command(
        after_help = "Examples:\n  wirebend plan examples/cube.obj --machine wirebend-kit --double -o cube.wbjob\n  wirebend plan examples/house.obj --machine wirebend-kit --compare pensa-diwire-pro\n  wirebend plan examples/cube.obj --machine wirebend-kit --wires 1..6"
    )]
    Plan {
        #[command(flatten)]
        design: DesignArgs,
        #[command(flatten)]
        choices: ChoiceArgs,
        #[command(flatten)]
        output: OutputArgs,
        #[command(flatten)]
        danger: DangerArgs,
        /// Say what changes on another machine, by id, instead of making a job; may be given again
        #[arg(long, value_name = "ID", conflicts_with_all = ["output", "force", "despite_errors"])]
        compare: Vec<String>,
        /// Let the machine wait after a step, from 1, until you have done what the note says and confirmed it; W/STEP:NOTE for
        /// another wire than the first; may be given again
        #[arg(long = "pause", value_name = "STEP:NOTE", conflicts_with = "compare", value_parser = parse_pause)]
        pauses: Vec<StepPause>,
    },
    /// Write what a machine, another program or a person reads
    #[command(
        after_help = "Examples:\n  wirebend export cube.wbjob -o cube.txt\n  wirebend export examples/house.obj --machine pensa-diwire-pro -o house.dsw\n  wirebend export examples/spring.obj --machine wirebend-kit --format svg -o spring.svg\n  wirebend export examples/house.obj --machine grbl-bender --set mode=absolute -o house.nc\n  wirebend export cube.wbjob --format template-pdf --set paper=letter -o cube.pdf"
    )]
    Export {
        #[command(flatten)]
        design: ExportedArgs,
        #[command(flatten)]
        choices: ChoiceArgs,
        /// Format to write (see `wirebend machines` and `wirebend drivers`); the machine's own if absent
        #[arg(long, short = 'f', value_name = "FORMAT")]
        format: Option<String>,
        /// Setting of the format's driver, over the machine's profile; of what is printed, paper=letter or units=in
        #[arg(long = "set", value_name = "KEY=VALUE", value_parser = parse_setting)]
        settings: Vec<(String, serde_json::Value)>,
        #[command(flatten)]
        output: OutputArgs,
        #[command(flatten)]
        danger: DangerArgs,
    },
    /// Compute a wireframe as a frame: what its struts carry, how it vibrates, how accurate it is once its joints are closed
    #[command(
        after_help = "Examples:\n  wirebend frame examples/bunny-frame.pwf --material abs-1-5mm\n  wirebend frame examples/truss-1.obj --material steel-0-9mm --supports free --modes 3\n  wirebend frame examples/truss-1.obj --machine pensa-diwire-pro --material steel-0-9mm --double --supports free --close --errors bend-forming"
    )]
    Frame(FrameArgs),
    /// Say how good a machine must be for what is required of a closed frame
    #[command(
        after_help = "Examples:\n  wirebend tolerance examples/truss-1.obj --machine pensa-diwire-pro --material steel-0-9mm --double --require surface=0.1mm,force=20N\n  wirebend tolerance --continuum 408,50,50000 --material steel-0-9mm --require surface=1mm,force=5N"
    )]
    Tolerance(ToleranceArgs),
    /// Find the order in which a machine builds the struts of a frame, or check one
    #[command(
        after_help = "Examples:\n  wirebend sequence bunny-frame.pwf --machine framefab-extruder -o bunny-sequence.json\n  wirebend sequence bunny-frame.pwf --machine framefab-extruder --check bunny-sequence.json\n  wirebend sequence bunny-frame.pwf --machine framefab-extruder --layers --cost paper"
    )]
    Sequence(SequenceArgs),
    /// Bend a job without a machine, with the errors that machines make
    #[command(
        after_help = "Examples:\n  wirebend simulate cube.wbjob --noise wirebend-kit --runs 500 --seed 1 --svg cube-made.svg\n  wirebend simulate cube.wbjob --noise wirebend-kit --runs 100 --collisions"
    )]
    Simulate {
        /// Job to bend, or - for standard input
        #[arg(value_name = "JOB")]
        job: PathBuf,
        /// Errors to make: the id of a noise profile (none, wirebend-kit, bend-forming, or your own)
        #[arg(long, value_name = "PROFILE")]
        noise: Option<String>,
        /// How often to bend the wire
        #[arg(long, value_name = "N", default_value_t = 200, requires = "noise")]
        runs: u32,
        /// Where the random numbers start; the same seed gives the same wires
        #[arg(long, value_name = "S", default_value_t = 1, requires = "noise")]
        seed: u64,
        /// Say how exact a machine must be so that each vertex, taken by itself, is this close to its place in 95 % of the wires, mm
        #[arg(long, value_name = "MM", allow_negative_numbers = true)]
        within: Option<f64>,
        /// Draw the design and the bent wires as SVG
        #[arg(long, value_name = "FILE")]
        svg: Option<PathBuf>,
        /// Draw the design and the bent wires as PNG
        #[arg(long, value_name = "FILE")]
        png: Option<PathBuf>,
        /// Replace pictures that are there
        #[arg(long)]
        force: bool,
        /// Look where the simulated wires hit the machine or themselves while they are bent
        #[arg(long)]
        collisions: bool,
        #[command(flatten)]
        clearance: ClearanceArgs,
    },
    /// Run a job on its machine; at a terminal Enter pauses and resumes it, Ctrl-C is STOP
    #[command(
        after_help = "Examples:\n  wirebend run cube.wbjob --port sim\n  wirebend run cube.wbjob --port /dev/ttyACM0\n  wirebend run cube.wbjob --port /dev/ttyACM0 --resume"
    )]
    Run(RunArgs),
    /// Make the moves of a wire without wire, slowly and with the peg in; Ctrl-C is STOP
    #[command(after_help = "Example:\n  wirebend dry-run cube.wbjob --port /dev/ttyACM0")]
    DryRun(DryRunArgs),
    /// Move a machine by hand; Ctrl-C is STOP
    #[command(
        after_help = "Example:\n  wirebend jog --machine wirebend-kit --port sim:max home f 10 r 90 b -45 --record try.wbmoves"
    )]
    Jog(JogArgs),
    /// Replay recorded moves; Ctrl-C is STOP
    #[command(after_help = "Example:\n  wirebend replay try.wbmoves --port sim:max")]
    Replay(ReplayArgs),
    /// List the ports that a machine can be at
    #[command(after_help = "Example:\n  wirebend ports --machine wirebend-kit")]
    Ports(PortsArgs),
    /// Compare what a machine has stored with its profile, or write it
    #[command(
        after_help = "Examples:\n  wirebend machine-settings --machine wirebend-kit --port /dev/ttyACM0\n  wirebend machine-settings --machine wirebend-kit --port /dev/ttyACM0 --write"
    )]
    MachineSettings(MachineSettingsArgs),
    /// Send lines to a machine in its own words, and print its answers; Ctrl-C is STOP
    #[command(
        after_help = "Examples:\n  wirebend console --machine grbl-bender --port /dev/ttyUSB0 '$$' '$#'\n  echo status | wirebend console --machine wirebend-kit --port sim"
    )]
    Console(ConsoleArgs),
    /// Show what was bent, wire by wire
    #[command(after_help = "Examples:\n  wirebend runs\n  wirebend runs show 3f2a9c81d0b4-0-1")]
    Runs {
        #[command(subcommand)]
        command: Option<RunsCommand>,
    },
    /// Print one stage's value as JSON
    #[command(
        after_help = "Example:\n  wirebend dump route examples/cube.obj --machine wirebend-kit --double"
    )]
    Dump {
        /// Stage to print
        #[arg(value_name = "STAGE", value_parser = stage_parser())]
        stage: StageName,
        #[command(flatten)]
        design: DesignArgs,
        #[command(flatten)]
        choices: ChoiceArgs,
    },
    /// Measure your machine and wire, and make profiles of what was measured
    #[command(subcommand)]
    Calibrate(CalibrateCommand),
    /// Work on profiles of machines, strut builders, materials and errors
    #[command(subcommand)]
    Profile(ProfileCommand),
    /// Print the completions of a shell
    #[command(
        after_help = "Example:\n  wirebend completions bash > ~/.local/share/bash-completion/completions/wirebend"
    )]
    Completions {
        /// Which shell
        shell: Shell,
    },
    /// Print the manual page
    #[command(after_help = "Example:\n  wirebend man > wirebend.1 && man ./wirebend.1")]
    Man,
}

#[derive(Debug, Subcommand)]
pub(crate) enum GenerateCommand {
    /// A tetrahedral truss: two hexagonal layers of triangles, joined by diagonals
    #[command(
        group(clap::ArgGroup::new("size").args(["strut", "depth"]).required(true).multiple(true)),
        after_help = "Examples:\n  wirebend generate truss --rings 3 --strut 100 -o truss.wirebend\n  wirebend generate truss --rings 1 --strut 61.237 --depth 53.033 -o truss.obj"
    )]
    Truss {
        /// Rings around the middle triangle, 0 to 100
        #[arg(long, value_name = "N")]
        rings: u32,
        /// Length of the struts in both layers [default: all struts are of one length]
        #[arg(long, value_name = "MM")]
        strut: Option<f64>,
        /// Distance of the layers [default: all struts are of one length]
        #[arg(long, value_name = "MM")]
        depth: Option<f64>,
        #[command(flatten)]
        output: OutputArgs,
    },
}

#[derive(Debug, Subcommand)]
pub(crate) enum DriverCommand {
    /// Say whether a library keeps the rules for drivers; this runs it, in a process of its own
    #[command(after_help = "Example:\n  wirebend driver check ./libmy_driver.so")]
    Check {
        /// Library to try
        #[arg(value_name = "LIBRARY")]
        library: PathBuf,
    },
    /// Accept a third-party driver as it is; without --sha256 say what it is and accept nothing
    #[command(
        after_help = "Example:\n  wirebend driver trust ./libmy_driver.so\n  wirebend driver trust ./libmy_driver.so --sha256 HASH"
    )]
    Trust {
        /// Library to accept
        #[arg(value_name = "LIBRARY")]
        library: PathBuf,
        /// Its SHA-256, as its author publishes it or as this command shows it
        #[arg(long, value_name = "HASH")]
        sha256: Option<String>,
    },
}
