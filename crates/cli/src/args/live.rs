//! The arguments of what moves a machine, or asks it.

use std::num::NonZeroUsize;
use std::path::PathBuf;

use clap::{Args, Subcommand};
use wirebend_api::{Decided, Decision, Move, PartOfStep};

use crate::number::number;

/// Where the machine is, and that it may move.
#[derive(Debug, Args)]
pub(crate) struct PortArgs {
    /// Port of the machine, such as /dev/ttyACM0 or COM3 (see `wirebend ports`); where none is named, a simulated machine bends the wire
    #[arg(long, short, value_name = "PORT")]
    pub port: Option<String>,
    /// Say that the machine may move, instead of being asked
    #[arg(long, short)]
    pub yes: bool,
}

/// Where the axes stand.
#[derive(Debug, Args)]
pub(crate) struct ZeroArgs {
    /// Say that every axis of a machine without switches stands at zero (for `jog`: where it counts from), instead of being asked; --yes does not imply it
    #[arg(long)]
    pub axes_at_zero: bool,
    /// Say where the head stands, in degrees from where its cable is unwound; needed where that is not known, as after a turn that was lost
    #[arg(long, value_name = "DEGREES", allow_negative_numbers = true, value_parser = degrees)]
    pub head_at: Option<f64>,
}

/// What is run, and where.
#[derive(Debug, Args)]
pub(crate) struct ToRunArgs {
    /// Job to run, or program in the machine's own format, or - for standard input
    #[arg(value_name = "JOB")]
    pub job: PathBuf,
    /// Machine that a program is for, by id; a job says it itself
    #[arg(long, short, value_name = "ID")]
    pub machine: Option<String>,
    /// Wire that a program is for, by id; without it the one that the machine's profile names
    #[arg(long, value_name = "ID")]
    pub material: Option<String>,
    /// Run a program although the machine cannot make it as it stands, or a wire although it hits the machine or itself
    #[arg(long)]
    pub despite_errors: bool,
    #[command(flatten)]
    pub at: PortArgs,
    #[command(flatten)]
    pub zero: ZeroArgs,
}

#[allow(clippy::struct_excessive_bools)] // each is an option of its own
#[derive(Debug, Args)]
pub(crate) struct RunArgs {
    #[command(flatten)]
    pub what: ToRunArgs,
    /// Bend this wire alone, counted from 1
    #[arg(long, value_name = "N")]
    pub wire: Option<NonZeroUsize>,
    /// Bend so many pieces of the same, one after the other; before each you are asked (--yes answers that on a simulated machine, and is refused on a real one, where somebody has to cut off each piece)
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u32).range(1..=10_000), conflicts_with_all = ["resume", "abandon"])]
    pub repeat: u32,
    /// Length of the wire that is loaded, in mm: new wire is asked for only when what is left does not suffice
    #[arg(long, value_name = "MM", value_parser = length)]
    pub stock: Option<f64>,
    /// Cut each piece off with the machine's cutter; the next one is bent without a question as long as the wire that is loaded (--stock) suffices
    #[arg(long, conflicts_with_all = ["resume", "abandon"])]
    pub cut: bool,
    /// Resume what was interrupted; with an answer, state what became of step N, which is in doubt: made:N, not-made:N, as-counted:N (the rest of it is bent from where the machine has counted), part:N:MM:DEGREES (from what was fed and turned as you measure it)
    #[arg(long, value_name = "ANSWER", num_args = 0..=1, require_equals = true, default_missing_value = "ask", conflicts_with = "abandon", value_parser = answer)]
    pub resume: Option<Answer>,
    /// Give up what was interrupted, so that the wire can be begun anew; nothing moves
    #[arg(long)]
    pub abandon: bool,
    /// Bend wires although settings of the machine are not those of its profile
    #[arg(long)]
    pub accept_settings: bool,
    #[command(flatten)]
    pub simulated: SimulatedArgs,
    /// Write the record of the run to this file, too
    #[arg(long, value_name = "FILE")]
    pub record: Option<PathBuf>,
    /// Replace a record that is there
    #[arg(long, requires = "record")]
    pub force: bool,
}

#[derive(Debug, Args)]
pub(crate) struct SimulatedArgs {
    /// Give the simulated machine the bend head of this machine, not of the one that the job was planned for: to try a calibration
    #[arg(long, value_name = "ID", conflicts_with_all = ["resume", "abandon"])]
    pub simulated_machine: Option<String>,
    /// Give the simulated machine this wire, not the one that the job was planned for
    #[arg(long, value_name = "ID", conflicts_with_all = ["resume", "abandon"])]
    pub simulated_material: Option<String>,
}

#[derive(Debug, Args)]
pub(crate) struct DryRunArgs {
    #[command(flatten)]
    pub what: ToRunArgs,
    /// The wire, counted from 1; needed where the job has several
    #[arg(long, value_name = "N")]
    pub wire: Option<NonZeroUsize>,
    /// Do it although settings of the machine are not those of its profile
    #[arg(long)]
    pub accept_settings: bool,
}

/// What a person says of a step in doubt; nothing where they are to be asked.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Answer(pub Option<Decided>);

fn length(text: &str) -> Result<f64, String> {
    number(text)
        .filter(|mm| *mm > 0.0)
        .ok_or_else(|| "expected a length in mm above 0, such as 2000".to_owned())
}

fn degrees(text: &str) -> Result<f64, String> {
    number(text).ok_or_else(|| "expected a number such as 12.5".to_owned())
}

/// `ask`, or a word, the step, and for a part what was fed and turned.
fn answer(text: &str) -> Result<Answer, String> {
    if text == "ask" {
        return Ok(Answer(None));
    }
    let expected = "made:N, not-made:N, as-counted:N or part:N:MM:DEGREES, where N is the step in doubt";
    let mut words = text.split(':');
    let (word, step) = (words.next().unwrap_or_default(), words.next());
    let step = step.and_then(|n| n.parse().ok()).filter(|n| *n > 0).ok_or(expected)?;
    let figures: Option<Vec<f64>> = words.map(number).collect();
    let what = match (word, figures.ok_or(expected)?.as_slice()) {
        ("made", []) => Decision::Made,
        ("not-made", []) => Decision::NotMade,
        ("as-counted", []) => Decision::AsCounted,
        ("part", &[feed_mm, rotate_deg]) => Decision::Part(PartOfStep { feed_mm, rotate_deg }),
        _ => return Err(expected.to_owned()),
    };
    Ok(Answer(Some(Decided { step, what })))
}

#[derive(Debug, Args)]
pub(crate) struct JogArgs {
    /// Machine, by id (see `wirebend machines`)
    #[arg(long, short, value_name = "ID")]
    pub machine: String,
    #[command(flatten)]
    pub at: PortArgs,
    #[command(flatten)]
    pub zero: ZeroArgs,
    /// Write the moves that were done to this file (.wbmoves), to be replayed
    #[arg(long, value_name = "FILE")]
    pub record: Option<PathBuf>,
    /// Replace a recording that is there
    #[arg(long, requires = "record")]
    pub force: bool,
    /// Moves: f MM, r DEGREES, b DEGREES, home; a number may be below 0
    #[arg(value_name = "MOVE", required = true, allow_negative_numbers = true)]
    pub moves: Vec<String>,
}

#[derive(Debug, Args)]
pub(crate) struct ReplayArgs {
    /// Recording to replay, or - for standard input
    #[arg(value_name = "FILE")]
    pub file: PathBuf,
    #[command(flatten)]
    pub at: PortArgs,
    #[command(flatten)]
    pub zero: ZeroArgs,
    /// Machine, by id: to replay what was recorded on another one, or before its profile was changed
    #[arg(long, short, value_name = "ID")]
    pub machine: Option<String>,
}

#[derive(Debug, Args)]
pub(crate) struct PortsArgs {
    /// For this machine
    #[arg(long, short, value_name = "ID", conflicts_with = "driver")]
    pub machine: Option<String>,
    /// For the machines of this driver
    #[arg(long, value_name = "ID")]
    pub driver: Option<String>,
}

#[derive(Debug, Args)]
pub(crate) struct MachineSettingsArgs {
    /// Machine, by id (see `wirebend machines`)
    #[arg(long, short, value_name = "ID")]
    pub machine: String,
    /// Port of the machine, such as /dev/ttyACM0 or COM3 (see `wirebend ports`)
    #[arg(long, short, value_name = "PORT")]
    pub port: Option<String>,
    /// Write the settings of the profile to the machine, for good
    #[arg(long)]
    pub write: bool,
    /// Write without being asked
    #[arg(long, short)]
    pub yes: bool,
}

#[derive(Debug, Args)]
pub(crate) struct ConsoleArgs {
    /// Machine, by id (see `wirebend machines`)
    #[arg(long, short, value_name = "ID")]
    pub machine: String,
    /// Port of the machine, such as /dev/ttyACM0 or COM3 (see `wirebend ports`); where none is named, the simulated machine is asked
    #[arg(long, short, value_name = "PORT")]
    pub port: Option<String>,
    /// Say that the machine may move or be changed, instead of being asked before each line that is no question
    #[arg(long, short)]
    pub yes: bool,
    /// Lines, one after the other; without any they are read from standard input
    #[arg(value_name = "LINE")]
    pub lines: Vec<String>,
}

#[derive(Debug, Subcommand)]
pub(crate) enum RunsCommand {
    /// List the wires that were bent
    #[command(after_help = "Example:\n  wirebend runs list --json")]
    List,
    /// Show one record
    #[command(after_help = "Example:\n  wirebend runs show 3f2a9c81d0b4-0-1")]
    Show {
        /// Its id, or enough of its beginning
        #[arg(value_name = "ID")]
        id: String,
    },
    /// Write one record as a file
    #[command(after_help = "Example:\n  wirebend runs export 3f2a9c81d0b4-0-1 -o cube-made.json")]
    Export {
        /// Its id, or enough of its beginning
        #[arg(value_name = "ID")]
        id: String,
        #[command(flatten)]
        output: super::OutputArgs,
    },
}

/// Words such as `f 10 r -90 home` as moves.
pub(crate) fn moves(words: &[String]) -> Result<Vec<Move>, String> {
    let mut moves = Vec::new();
    let mut words = words.iter();
    while let Some(word) = words.next() {
        if matches!(word.as_str(), "home" | "h") {
            moves.push(Move::Home);
            continue;
        }
        let mut amount = || {
            let found = words.next().ok_or_else(|| format!("'{word}' needs a number after it"))?;
            number(found).ok_or_else(|| format!("'{found}' after '{word}' is no number"))
        };
        moves.push(match word.as_str() {
            "f" | "feed" => Move::Feed { mm: amount()? },
            "r" | "rotate" => Move::Rotate { deg: amount()? },
            "b" | "bend" => Move::Bend { deg: amount()? },
            _ => return Err(format!("'{word}' is no move: expected f MM, r DEGREES, b DEGREES or home")),
        });
    }
    Ok(moves)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Vec<Move>, String> {
        moves(&text.split(' ').map(str::to_owned).collect::<Vec<_>>())
    }

    #[test]
    fn moves_are_a_letter_and_a_number() {
        let expected =
            [Move::Feed { mm: 10.0 }, Move::Bend { deg: -45.5 }, Move::Home, Move::Rotate { deg: 90.0 }];
        assert_eq!(read("f 10 b -45.5 home rotate 90").unwrap(), expected);
    }

    #[test]
    fn what_is_no_move_is_named() {
        for (text, said) in [("x 10", "'x'"), ("f", "needs a number"), ("f ten", "'ten'"), ("b inf", "'inf'")]
        {
            assert!(read(text).unwrap_err().contains(said), "{text}");
        }
    }
}
