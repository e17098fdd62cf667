//! Moves by hand, and a row of them as a file (`.wbmoves`).

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::json;
use wirebend_error::InputName;
use wirebend_files::document::sha256_hex;
use wirebend_planning::PlanningError;
use wirebend_profile::{MachineProfile, Resolved};

use crate::order::Move;
use crate::{LiveProblem, OperationError};

/// What the file says that it is.
const FORMAT: &str = "wbmoves";
/// The newest version that is known.
const VERSION: u64 = 1;
/// The most moves of one file.
const MAX_MOVES: usize = 100_000;

/// Moves that were run on a machine.
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
    /// The machine on which they ran.
    pub machine: String,
    /// SHA-256 over the values of its profile that moves depend on: figures, driver and its settings.
    #[schemars(regex(pattern = "^[0-9a-f]{64}$"))]
    pub profile_hash: String,
    /// The moves, in order.
    pub moves: Vec<Move>,
}

impl MovesFile {
    /// Moves as a machine ran them.
    pub fn new(machine: &Resolved<MachineProfile>, moves: Vec<Move>) -> Result<Self, OperationError> {
        Ok(Self {
            format: FORMAT.to_owned(),
            version: VERSION,
            machine: machine.profile.id.clone(),
            profile_hash: profile_hash(machine)?,
            moves,
        })
    }

    /// Reads the bytes of a file.
    pub fn open(file: &str, bytes: &[u8]) -> Result<Self, OperationError> {
        let wrong =
            |reason: String| OperationError::from(LiveProblem::Moves { file: file.to_owned(), reason });
        let value: serde_json::Value = serde_json::from_slice(bytes)
            .map_err(|error| wrong(format!("it is no recording of moves: {error}")))?;
        let (format, version) = (value["format"].as_str(), value["version"].as_u64());
        if format != Some(FORMAT) {
            return Err(wrong(format!("it is no recording of moves: its \"format\" is not \"{FORMAT}\"")));
        }
        if version.is_some_and(|version| version > VERSION) {
            return Err(wrong(format!("it is of a newer version than {VERSION}")));
        }
        // From the bytes, so that a mistake is reported with its line.
        let read: Self = serde_json::from_slice(bytes).map_err(|error| wrong(error.to_string()))?;
        if read.version != VERSION {
            return Err(wrong(format!("there is no version {} of this format", read.version)));
        }
        if read.moves.is_empty() || read.moves.len() > MAX_MOVES {
            return Err(wrong(format!("it has {} moves, expected 1 to {MAX_MOVES}", read.moves.len())));
        }
        read.moves.iter().try_for_each(|one| one.check())?;
        Ok(read)
    }

    /// Why a machine is not the one of the recording; `None` when it is.
    pub fn differs(&self, machine: &Resolved<MachineProfile>) -> Result<Option<String>, OperationError> {
        if self.machine != machine.profile.id {
            return Ok(Some(format!("on '{}', not on '{}'", self.machine, machine.profile.id)));
        }
        let changed = self.profile_hash != profile_hash(machine)?;
        Ok(changed.then(|| format!("before the profile of '{}' was changed", self.machine)))
    }

    pub fn to_bytes(&self) -> Result<Vec<u8>, OperationError> {
        let mut bytes = serde_json::to_vec_pretty(self)?;
        bytes.push(b'\n');
        Ok(bytes)
    }
}

/// Moves that are asked for: at least one, each of them possible.
pub fn check_moves(moves: &[Move]) -> Result<(), OperationError> {
    if moves.is_empty() {
        return Err(PlanningError::Value {
            input: Some(InputName::Moves),
            name: "the row of moves",
            value: "empty".to_owned(),
            expected: "a move, such as a feed of 10 mm",
        }
        .into());
    }
    Ok(moves.iter().try_for_each(|one| one.check())?)
}

/// What a machine does with a move follows from what this consists of.
pub fn profile_hash(machine: &Resolved<MachineProfile>) -> Result<String, OperationError> {
    let values = json!({ "figures": machine.figures()?, "driver": machine.profile.driver });
    Ok(sha256_hex(values.to_string().as_bytes()))
}
