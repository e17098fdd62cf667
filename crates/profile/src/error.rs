//! Why a profile was refused or not found.

use std::fmt;
use std::io;

use wirebend_error::{ErrorCode, ErrorRemedy};

use crate::Kind;

/// A file and, where known, a line in it, counted from 1. Shown as `file:line`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Place {
    /// Name of the file as it was given; shipped ones begin with `machine-profiles/`.
    pub file: String,
    /// Line, from 1.
    pub line: Option<usize>,
}

impl Place {
    pub(crate) fn file(file: &str) -> Self {
        Self { file: file.into(), line: None }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.line {
            Some(line) => write!(f, "{}:{line}", self.file),
            None => f.write_str(&self.file),
        }
    }
}

/// Why a profile was refused or not found. The message says where, what was found and what was expected.
#[derive(Debug, thiserror::Error)]
pub enum ProfileError {
    /// A file or folder could not be read.
    #[error("{file}: cannot be read: {source}")]
    Unreadable {
        /// The file or folder.
        file: String,
        /// What the system said.
        source: io::Error,
    },
    /// A file is too large to be a profile.
    #[error("{file}: larger than {limit} bytes, which no profile is")]
    TooLarge {
        /// The file.
        file: String,
        /// Largest size that is read, bytes.
        limit: usize,
    },
    /// A file is not text.
    #[error("{file}: not UTF-8 text (byte {byte})")]
    NotText {
        /// The file.
        file: String,
        /// Bytes before the first that is not text.
        byte: usize,
    },
    /// A file is not JSON.
    #[error("{place}: not JSON: {message} (column {column})")]
    Syntax {
        /// Where.
        place: Place,
        /// Column, from 1.
        column: usize,
        /// What the JSON reader expected.
        message: String,
    },
    /// An unknown key, a wrong type, or one of the keys without which a file is no profile.
    #[error("{place}: {message} (column {column})")]
    Shape {
        /// Where.
        place: Place,
        /// Column, from 1; 0 when only the file is known.
        column: usize,
        /// What was found and expected.
        message: String,
        /// What to do.
        remedy: Box<ErrorRemedy>,
    },
    /// The `kind` key is absent or not a known word.
    #[error("{place}: {found}, expected \"kind\": \"machine\", \"material\", \"noise\" or \"strut-builder\"")]
    UnknownKind {
        /// Where.
        place: Place,
        /// What was found instead.
        found: String,
    },
    /// A file lies in the folder of another kind.
    #[error("{place}: a {found} profile in the folder {folder}/")]
    WrongFolder {
        /// Where.
        place: Place,
        /// Kind that the file says it is.
        found: Kind,
        /// Name of the folder in which it lies.
        folder: String,
    },
    /// A file was written for a newer program.
    #[error("{place}: schema_version {found}, this program reads up to {known}")]
    NewerVersion {
        /// Where.
        place: Place,
        /// Version of the file.
        found: u64,
        /// Newest version that this program reads.
        known: u32,
    },
    /// An id is not a slug.
    #[error(
        "{place}: the id `{id}` must be of lower-case letters, digits and single hyphens, such as `my-bender`"
    )]
    BadId {
        /// Where.
        place: Place,
        /// The id.
        id: String,
    },
    /// An id is not the file's name.
    #[error("{place}: the id `{id}` differs from the file's name")]
    IdNotFileName {
        /// Where.
        place: Place,
        /// The id.
        id: String,
    },
    /// Two files of the person's folders have one id.
    #[error("{place}: the id `{id}` is taken by {first}")]
    DuplicateId {
        /// The file that was refused.
        place: Place,
        /// The id.
        id: String,
        /// The file that has the id.
        first: String,
    },
    /// A person's file has the id of a shipped profile.
    #[error("{place}: `{id}` is a {kind} that comes with the program")]
    ShadowsShipped {
        /// The file that was refused.
        place: Place,
        /// Kind.
        kind: Kind,
        /// The id.
        id: String,
    },
    /// The parent does not exist.
    #[error(
        "{place}: inherits from the unknown {kind} `{parent}` (one whose file was refused is unknown too)"
    )]
    UnknownParent {
        /// The `inherits` key.
        place: Place,
        /// Kind.
        kind: Kind,
        /// Id of the parent.
        parent: String,
        /// The nearest ids and the known ones.
        remedy: Box<ErrorRemedy>,
    },
    /// The parents of a profile run in a circle.
    #[error("{place}: the parents run in a circle: {}", chain.join(" -> "))]
    Cycle {
        /// The `inherits` key of the profile that cannot be used.
        place: Place,
        /// Ids from child to parent; the last one is there twice.
        chain: Vec<String>,
    },
    /// A profile names another one that does not exist.
    #[error("{place}: {key} names the unknown {kind} `{id}`")]
    UnknownReference {
        /// Where.
        place: Place,
        /// Dotted key.
        key: String,
        /// Kind of the profile that is named.
        kind: Kind,
        /// Id that is named.
        id: String,
        /// The nearest ids and the known ones.
        remedy: Box<ErrorRemedy>,
    },
    /// A profile names another one that only serves to be inherited from.
    #[error("{place}: {key} names the {kind} `{id}`, which is abstract and cannot be used itself")]
    AbstractReference {
        /// Where.
        place: Place,
        /// Dotted key.
        key: String,
        /// Kind of the profile that is named.
        kind: Kind,
        /// Id that is named.
        id: String,
        /// The nearest ids and those that can be used.
        remedy: Box<ErrorRemedy>,
    },
    /// No profile has this id.
    #[error("no {kind} has the id `{id}`{}", other.map(|kind| format!(": it is a {kind}")).unwrap_or_default())]
    Unknown {
        /// Kind.
        kind: Kind,
        /// Id that was asked for.
        id: String,
        /// A kind that has a profile with this id.
        other: Option<Kind>,
        /// The nearest ids and the known ones.
        remedy: Box<ErrorRemedy>,
    },
    /// No profile of any kind has this id.
    #[error("no profile has the id `{id}`")]
    UnknownId {
        /// Id that was asked for.
        id: String,
        /// The nearest ids and the known ones.
        remedy: Box<ErrorRemedy>,
    },
    /// The profile only serves to be inherited from.
    #[error("{place}: the {kind} `{id}` is abstract and cannot be used itself")]
    Abstract {
        /// The `abstract` key.
        place: Place,
        /// Kind.
        kind: Kind,
        /// Id that was asked for.
        id: String,
    },
    /// A required value is set neither by the file nor by a parent.
    #[error("{file}: {key} is not set, here or by a parent")]
    Missing {
        /// The file.
        file: String,
        /// Dotted key.
        key: String,
        /// What to write.
        how: String,
    },
    /// A value breaks a rule.
    #[error("{place}: {key} is {found}, expected {expected}")]
    Rule {
        /// Where it was set, possibly in a parent's file.
        place: Place,
        /// Dotted key.
        key: String,
        /// The value.
        found: String,
        /// What the rule asks for.
        expected: String,
    },
}

impl ProfileError {
    /// A stable word for programs that show the error.
    #[must_use]
    pub fn code(&self) -> ErrorCode {
        match self {
            Self::Unreadable { .. } => ErrorCode::ProfileUnreadable,
            Self::TooLarge { .. } => ErrorCode::ProfileTooLarge,
            Self::NotText { .. } => ErrorCode::ProfileNotText,
            Self::Syntax { .. } => ErrorCode::ProfileSyntax,
            Self::Shape { .. } => ErrorCode::ProfileShape,
            Self::UnknownKind { .. } => ErrorCode::ProfileUnknownKind,
            Self::WrongFolder { .. } => ErrorCode::ProfileWrongFolder,
            Self::NewerVersion { .. } => ErrorCode::ProfileNewerVersion,
            Self::BadId { .. } => ErrorCode::ProfileBadId,
            Self::IdNotFileName { .. } => ErrorCode::ProfileIdNotFileName,
            Self::DuplicateId { .. } => ErrorCode::ProfileDuplicateId,
            Self::ShadowsShipped { .. } => ErrorCode::ProfileShadowsShipped,
            Self::UnknownParent { .. } => ErrorCode::ProfileUnknownParent,
            Self::Cycle { .. } => ErrorCode::ProfileCycle,
            Self::UnknownReference { .. } => ErrorCode::ProfileUnknownReference,
            Self::Unknown { .. } => ErrorCode::ProfileUnknown,
            Self::UnknownId { .. } => ErrorCode::ProfileUnknownId,
            Self::AbstractReference { .. } | Self::Abstract { .. } => ErrorCode::ProfileAbstract,
            Self::Missing { .. } => ErrorCode::ProfileMissing,
            Self::Rule { .. } => ErrorCode::ProfileRule,
        }
    }

    /// What can be done about it.
    #[must_use]
    pub fn remedies(&self) -> Vec<ErrorRemedy> {
        vec![match self {
            Self::Unreadable { .. } => ErrorRemedy::CheckReadable,
            Self::TooLarge { .. } => ErrorRemedy::CheckRightFile,
            Self::NotText { .. } => ErrorRemedy::ExportAs { form: "UTF-8 text".to_owned() },
            Self::Syntax { .. } | Self::UnknownKind { .. } | Self::Rule { .. } => ErrorRemedy::CorrectProfile,
            Self::WrongFolder { found, .. } => {
                ErrorRemedy::MoveFile { folder: format!("{}/", found.folder()) }
            }
            Self::NewerVersion { .. } => ErrorRemedy::UpdateProgram,
            Self::BadId { .. } | Self::DuplicateId { .. } => ErrorRemedy::ChooseOtherId,
            Self::IdNotFileName { id, .. } => ErrorRemedy::RenameFile { name: format!("{id}.json") },
            Self::ShadowsShipped { id, .. } => {
                return vec![ErrorRemedy::ChooseOtherId, ErrorRemedy::InheritFrom { ids: vec![id.clone()] }];
            }
            Self::Cycle { .. } => ErrorRemedy::RemoveParent,
            Self::Shape { remedy, .. }
            | Self::UnknownParent { remedy, .. }
            | Self::UnknownReference { remedy, .. }
            | Self::AbstractReference { remedy, .. }
            | Self::Unknown { remedy, .. }
            | Self::UnknownId { remedy, .. } => (**remedy).clone(),
            Self::Abstract { .. } => ErrorRemedy::UseChild,
            Self::Missing { how, .. } => ErrorRemedy::AddKey { text: how.clone() },
        }]
    }
}

/// The known words that are nearest to another one.
pub(crate) fn nearest<'a>(word: &str, known: impl Iterator<Item = &'a str>) -> Vec<String> {
    let mut scored: Vec<(f64, &str)> =
        known.map(|other| (strsim::jaro_winkler(word, other), other)).collect();
    scored.retain(|(score, _)| *score > 0.75);
    scored.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(b.1)));
    scored.iter().take(3).map(|(_, word)| (*word).to_owned()).collect()
}

wirebend_error::reported!(ProfileError);
