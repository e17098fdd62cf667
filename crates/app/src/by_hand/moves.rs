//! Moves by hand, and a row of them as a file (`.wbmoves`).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::json;
use wirebend_files::document::sha256_hex;
use wirebend_profile::{MachineProfile, Resolved};

use crate::{AppError, LiveProblem};

/// What the file says that it is.
const FORMAT: &str = "wbmoves";
/// The newest version that is known.
const VERSION: u64 = 1;
/// The most moves of one file.
const MOST_MOVES: usize = 100_000;

/// One axis by an amount, in canonical signs, or the search for the reference.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "move", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Move {
    /// The machine finds its reference.
    Home,
    /// Feeds.
    Feed {
        /// By so much; below 0 back into the machine.
        mm: f64,
    },
    /// Turns the head about the wire.
    Rotate {
        /// By so much, right-handed about the direction of travel.
        deg: f64,
    },
    /// Moves the bend axis. On a machine with a peg that is a whole bend: out with the peg, there and back, in.
    Bend {
        /// By so much.
        deg: f64,
    },
}

/// A row of moves that was made on a machine.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(rename = "WireBend moves")]
pub struct MovesFile {
    /// Which kind of file this is.
    #[schemars(extend("const" = "wbmoves"))]
    pub format: String,
    /// The version of this format.
    #[schemars(extend("const" = 1))]
    pub version: u64,
    /// The machine on which they were made.
    pub machine: String,
    /// SHA-256 over the values of its profile that moves depend on: figures, driver and its settings.
    #[schemars(regex(pattern = "^[0-9a-f]{64}$"))]
    pub profile_hash: String,
    /// The moves, in order.
    pub moves: Vec<Move>,
}

impl Move {
    /// Refuses a number that no machine can be told.
    pub(crate) fn check(self) -> Result<(), AppError> {
        let (name, value) = match self {
            Self::Home => return Ok(()),
            Self::Feed { mm } => ("a feed", mm),
            Self::Rotate { deg } => ("a rotation", deg),
            Self::Bend { deg } => ("a bend", deg),
        };
        if value.is_finite() {
            return Ok(());
        }
        let expected = "give a finite number of mm or degrees";
        Err(AppError::Value { name, value: value.to_string(), expected })
    }
}

impl std::fmt::Display for Move {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Home => f.write_str("home"),
            Self::Feed { mm } => write!(f, "feed {mm} mm"),
            Self::Rotate { deg } => write!(f, "rotate {deg}°"),
            Self::Bend { deg } => write!(f, "bend {deg}°"),
        }
    }
}

impl MovesFile {
    /// Moves as they were made on a machine.
    pub(crate) fn new(machine: &Resolved<MachineProfile>, moves: Vec<Move>) -> Result<Self, AppError> {
        Ok(Self {
            format: FORMAT.to_owned(),
            version: VERSION,
            machine: machine.profile.id.clone(),
            profile_hash: profile_hash(machine)?,
            moves,
        })
    }

    /// Reads the bytes of a file.
    pub(crate) fn open(file: &str, bytes: &[u8]) -> Result<Self, AppError> {
        let wrong = |reason: String| AppError::from(LiveProblem::Moves { file: file.to_owned(), reason });
        let value: serde_json::Value = serde_json::from_slice(bytes)
            .map_err(|error| wrong(format!("it is no recording of moves: {error}")))?;
        let (format, version) = (value["format"].as_str(), value["version"].as_u64());
        if format != Some(FORMAT) {
            return Err(wrong(format!("it is no recording of moves: its \"format\" is not \"{FORMAT}\"")));
        }
        if version.is_some_and(|version| version > VERSION) {
            return Err(wrong(format!("it is of a newer version than {VERSION}: update the program")));
        }
        // From the bytes, so that a mistake is told with its line.
        let read: Self = serde_json::from_slice(bytes).map_err(|error| wrong(error.to_string()))?;
        if read.version != VERSION {
            return Err(wrong(format!("there is no version {} of this format", read.version)));
        }
        if read.moves.is_empty() || read.moves.len() > MOST_MOVES {
            return Err(wrong(format!("it has {} moves, expected 1 to {MOST_MOVES}", read.moves.len())));
        }
        read.moves.iter().try_for_each(|one| one.check())?;
        Ok(read)
    }

    /// Why a machine is not the one of the recording; `None` when it is.
    pub(crate) fn differs(&self, machine: &Resolved<MachineProfile>) -> Result<Option<String>, AppError> {
        if self.machine != machine.profile.id {
            return Ok(Some(format!("on '{}', not on '{}'", self.machine, machine.profile.id)));
        }
        let changed = self.profile_hash != profile_hash(machine)?;
        Ok(changed.then(|| format!("before the profile of '{}' was changed", self.machine)))
    }

    /// The bytes of the file.
    pub(crate) fn to_bytes(&self) -> Result<Vec<u8>, AppError> {
        let mut bytes = serde_json::to_vec_pretty(self)?;
        bytes.push(b'\n');
        Ok(bytes)
    }
}

/// What a machine does with a move follows from what this is made of.
pub(crate) fn profile_hash(machine: &Resolved<MachineProfile>) -> Result<String, AppError> {
    let values = json!({ "figures": machine.figures()?, "driver": machine.profile.driver });
    Ok(sha256_hex(values.to_string().as_bytes()))
}
