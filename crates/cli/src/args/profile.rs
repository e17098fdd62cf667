//! The arguments of what is about profiles.

use std::path::PathBuf;

use clap::Subcommand;

use super::shared::{KindArgs, OutputArgs};

#[derive(Debug, Subcommand)]
pub(crate) enum ProfileCommand {
    /// Say whether profile files can be used
    #[command(after_help = "Example:\n  wirebend profile check machines/my-bender.json")]
    Check {
        /// Files to check
        #[arg(value_name = "FILE", required = true)]
        files: Vec<PathBuf>,
    },
    /// Write a new profile that inherits from another, to your own profile folder unless -o is given
    #[command(
        after_help = "Example:\n  wirebend profile new my-bender --from wirebend-kit --kind machine --all"
    )]
    New {
        /// Id of the new profile: lower-case letters, digits and hyphens
        #[arg(value_name = "NEW_ID")]
        id: String,
        /// Profile to inherit from, by id
        #[arg(long, value_name = "ID")]
        from: String,
        #[command(flatten)]
        kind: KindArgs,
        /// Name for people; the id if absent
        #[arg(long, value_name = "NAME")]
        name: Option<String>,
        /// Write every value of the parent, to be changed, instead of the heading alone
        #[arg(long)]
        all: bool,
        #[command(flatten)]
        output: OutputArgs,
    },
    /// Set values of a profile of your own, each with its source
    #[command(
        after_help = "Example:\n  wirebend profile set my-bender --from wirebend-kit --kind machine bend.orbit_offset_mm=11.6 --source \"caliper, 3 readings\" --measured"
    )]
    Set {
        /// Profile to change, by id
        #[arg(value_name = "ID")]
        id: String,
        /// Values to set, with dotted keys; `shapes.NAME={…}` is one body of a machine, of which the keys that are named change, and null takes it out
        #[arg(value_name = "KEY=VALUE", required = true)]
        values: Vec<String>,
        /// Where the values come from
        #[arg(long, value_name = "TEXT")]
        source: String,
        /// They were measured on the machine or the wire
        #[arg(long)]
        measured: bool,
        /// Where there is no profile of this id yet, make one that inherits from this one
        #[arg(long, value_name = "ID")]
        from: Option<String>,
        #[command(flatten)]
        kind: KindArgs,
    },
    /// Take back values of a profile of your own, or its last change
    #[command(after_help = "Example:\n  wirebend profile revert my-bender bend.orbit_offset_mm")]
    Revert {
        /// Profile to change, by id
        #[arg(value_name = "ID")]
        id: String,
        /// Values that are to be as in the profile that it inherits from, by their dotted keys; without any the last change of
        /// the profile is taken back, and made again by another revert
        #[arg(value_name = "KEY")]
        keys: Vec<String>,
        #[command(flatten)]
        kind: KindArgs,
    },
    /// Write a profile, with all that it has from other profiles of your own and with the wire of your own that it names, as one file for others
    #[command(after_help = "Example:\n  wirebend profile export my-bender -o my-bender.json")]
    Export {
        /// Profile to write, by id
        #[arg(value_name = "ID")]
        id: String,
        /// Leave out the other profiles of your own that it names: the wire and the noise profile of a machine
        #[arg(long)]
        alone: bool,
        #[command(flatten)]
        kind: KindArgs,
        #[command(flatten)]
        output: OutputArgs,
    },
    /// Take in a profile that somebody else has exported, as one of your own
    #[command(after_help = "Example:\n  wirebend profile import my-bender.json")]
    Import {
        /// File of the profile
        #[arg(value_name = "FILE")]
        file: PathBuf,
        /// Another id for it, where the one of the file is taken
        #[arg(long, value_name = "ID")]
        id: Option<String>,
    },
    /// Say which file and line set each value of a profile
    #[command(after_help = "Example:\n  wirebend profile explain steel-0-9mm")]
    Explain {
        /// Profile to explain
        #[arg(value_name = "ID")]
        id: String,
        #[command(flatten)]
        kind: KindArgs,
    },
}
