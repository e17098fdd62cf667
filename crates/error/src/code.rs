//! The names of errors.

use std::borrow::Cow;
use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Serialize, Serializer};

macro_rules! codes {
    ($($name:ident = $text:literal,)*) => {
        /// The name of a kind of error. It stays the same while the wording changes, so that scripts and front ends can rely on
        /// it.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
        pub enum ErrorCode { $($name,)* }

        impl ErrorCode {
            /// Every code, by name.
            pub const ALL: &'static [Self] = &[$(Self::$name,)*];

            /// The code as JSON and the command line spell it: lower case with hyphens.
            #[must_use]
            pub const fn as_str(self) -> &'static str {
                match self { $(Self::$name => $text,)* }
            }
        }
    };
}

codes! {
    Ask = "ask",
    AtWork = "at-work",
    BegunElsewhere = "begun-elsewhere",
    BendTooFar = "bend-too-far",
    BeyondLimit = "beyond-limit",
    Busy = "busy",
    Calibration = "calibration",
    ClosedWires = "closed-wires",
    ClosingJoints = "closing-joints",
    Compensated = "compensated",
    ConfirmationOfAnother = "confirmation-of-another",
    ConfirmationUsed = "confirmation-used",
    ConnectedBefore = "connected-before",
    Contradiction = "contradiction",
    DamagedJob = "damaged-job",
    Declined = "declined",
    Document = "document",
    DocumentChanged = "document-changed",
    DocumentClosedWires = "document-closed-wires",
    DocumentDangling = "document-dangling",
    DocumentEmpty = "document-empty",
    DocumentInconsistent = "document-inconsistent",
    DocumentJson = "document-json",
    DocumentNewer = "document-newer",
    DocumentNoSuchVersion = "document-no-such-version",
    DocumentNotFinite = "document-not-finite",
    DocumentSave = "document-save",
    DocumentStencil = "document-stencil",
    DocumentStencilDamaged = "document-stencil-damaged",
    DocumentStencils = "document-stencils",
    DocumentWireframe = "document-wireframe",
    DocumentWrite = "document-write",
    DocumentWrongFormat = "document-wrong-format",
    DriverBroken = "driver-broken",
    DriverChanged = "driver-changed",
    DriverDied = "driver-died",
    DriverEnded = "driver-ended",
    DriverGarbage = "driver-garbage",
    DriverHung = "driver-hung",
    DriverLibrary = "driver-library",
    DriverLimitsUnknown = "driver-limits-unknown",
    DriverLoad = "driver-load",
    DriverNotTrusted = "driver-not-trusted",
    DriverRefused = "driver-refused",
    DriverSettings = "driver-settings",
    DriverStart = "driver-start",
    DriverTooLarge = "driver-too-large",
    DriverTooOld = "driver-too-old",
    DriverTrust = "driver-trust",
    DriverUnsafe = "driver-unsafe",
    Edit = "edit",
    Exists = "exists",
    Faces = "faces",
    Failure = "failure",
    FileChanged = "file-changed",
    FilesOnly = "files-only",
    FormatOfAnother = "format-of-another",
    HeadBeyond = "head-beyond",
    HeadNotKept = "head-not-kept",
    HeadTooFar = "head-too-far",
    HeadTurned = "head-turned",
    HeadUnknown = "head-unknown",
    Held = "held",
    IdTaken = "id-taken",
    InDoubt = "in-doubt",
    IsAJob = "is-a-job",
    JobNotKept = "job-not-kept",
    JournalDamaged = "journal-damaged",
    JournalEmpty = "journal-empty",
    JournalExists = "journal-exists",
    JournalImpossible = "journal-impossible",
    JournalInUse = "journal-in-use",
    JournalIo = "journal-io",
    JournalNewer = "journal-newer",
    Json = "json",
    LeftInWire = "left-in-wire",
    LoadCase = "load-case",
    MachineAtWork = "machine-at-work",
    MachineFault = "machine-fault",
    MachineGeometry = "machine-geometry",
    Moves = "moves",
    MovesOfAnother = "moves-of-another",
    NoAnswer = "no-answer",
    NoBender = "no-bender",
    NoDriver = "no-driver",
    NoEdge = "no-edge",
    NoExample = "no-example",
    NoFile = "no-file",
    NoFrame = "no-frame",
    NoJob = "no-job",
    NoLimit = "no-limit",
    NoMachine = "no-machine",
    NoMaterial = "no-material",
    NoModes = "no-modes",
    NoOrder = "no-order",
    NoOwnFolder = "no-own-folder",
    NoPort = "no-port",
    NoQuestion = "no-question",
    NoRun = "no-run",
    NoSettings = "no-settings",
    NoShearModulus = "no-shear-modulus",
    NoStencil = "no-stencil",
    NoSurface = "no-surface",
    NoThread = "no-thread",
    NoVertex = "no-vertex",
    NoWalks = "no-walks",
    NoWire = "no-wire",
    NoiseProfile = "noise-profile",
    NotAJob = "not-a-job",
    NotBegun = "not-begun",
    NotConfirmed = "not-confirmed",
    NotConnected = "not-connected",
    NotCounted = "not-counted",
    NotFeasible = "not-feasible",
    NotKept = "not-kept",
    NotNow = "not-now",
    NotOfStep = "not-of-step",
    NotPermitted = "not-permitted",
    NotSimulated = "not-simulated",
    NoCutter = "no-cutter",
    EndTooShort = "end-too-short",
    Nothing = "nothing",
    NothingBegun = "nothing-begun",
    NothingRecorded = "nothing-recorded",
    NothingToRevert = "nothing-to-revert",
    NothingUnfinished = "nothing-unfinished",
    NowhereToRecord = "nowhere-to-record",
    NowhereToTrust = "nowhere-to-trust",
    OffZero = "off-zero",
    OnlyLengths = "only-lengths",
    OnlyStencil = "only-stencil",
    OpenParent = "open-parent",
    OtherCompensation = "other-compensation",
    OtherKind = "other-kind",
    OtherLibrary = "other-library",
    OtherMachine = "other-machine",
    OtherStep = "other-step",
    OtherWire = "other-wire",
    OutOfOrder = "out-of-order",
    OwnProgram = "own-program",
    Picture = "picture",
    ProfileAbstract = "profile-abstract",
    ProfileBadId = "profile-bad-id",
    ProfileChanged = "profile-changed",
    ProfileCycle = "profile-cycle",
    ProfileDuplicateId = "profile-duplicate-id",
    ProfileIdNotFileName = "profile-id-not-file-name",
    ProfileMissing = "profile-missing",
    ProfileNewerVersion = "profile-newer-version",
    ProfileNotText = "profile-not-text",
    ProfileRule = "profile-rule",
    ProfileShadowsShipped = "profile-shadows-shipped",
    ProfileShape = "profile-shape",
    ProfileSyntax = "profile-syntax",
    ProfileTooLarge = "profile-too-large",
    ProfileUnknown = "profile-unknown",
    ProfileUnknownId = "profile-unknown-id",
    ProfileUnknownKind = "profile-unknown-kind",
    ProfileUnknownParent = "profile-unknown-parent",
    ProfileUnknownReference = "profile-unknown-reference",
    ProfileUnreadable = "profile-unreadable",
    ProfileWrongFolder = "profile-wrong-folder",
    QuestionOpen = "question-open",
    ReadElsewhere = "read-elsewhere",
    ReadEmpty = "read-empty",
    ReadIndex = "read-index",
    ReadIo = "read-io",
    ReadLibrary = "read-library",
    ReadLoop = "read-loop",
    ReadNoCorner = "read-no-corner",
    ReadNoLayers = "read-no-layers",
    ReadNoSuchLayer = "read-no-such-layer",
    ReadNumber = "read-number",
    ReadOtherDesign = "read-other-design",
    ReadScale = "read-scale",
    ReadStencil = "read-stencil",
    ReadSyntax = "read-syntax",
    ReadTolerance = "read-tolerance",
    ReadTooDeep = "read-too-deep",
    ReadTooLarge = "read-too-large",
    ReadTooMany = "read-too-many",
    ReadTruncated = "read-truncated",
    ReadUnknownFormat = "read-unknown-format",
    ReadUnsupported = "read-unsupported",
    ReadWireframe = "read-wireframe",
    RunsFolder = "runs-folder",
    SequenceFile = "sequence-file",
    SessionPurpose = "session-purpose",
    SessionStale = "session-stale",
    SessionState = "session-state",
    SettingsDiffer = "settings-differ",
    Settled = "settled",
    SeveralKinds = "several-kinds",
    SeveralRuns = "several-runs",
    SeveralUnfinished = "several-unfinished",
    ShippedProfile = "shipped-profile",
    SpringbackTable = "springback-table",
    StageNotReached = "stage-not-reached",
    Stale = "stale",
    StartWithoutEdge = "start-without-edge",
    StencilMissing = "stencil-missing",
    Steps = "steps",
    StillMoving = "still-moving",
    StopNotConfirmed = "stop-not-confirmed",
    StopNotConfirmedYet = "stop-not-confirmed-yet",
    Stopped = "stopped",
    StoppedBefore = "stopped-before",
    StoppedSince = "stopped-since",
    StrutWithoutLength = "strut-without-length",
    Unfinished = "unfinished",
    UnknownFormat = "unknown-format",
    Unsupported = "unsupported",
    Unwritable = "unwritable",
    Unwritten = "unwritten",
    Usage = "usage",
    Value = "value",
    WhichWire = "which-wire",
    WithoutEffect = "without-effect",
    WrongAnswer = "wrong-answer",
    ZeroNotConfirmed = "zero-not-confirmed",
}

impl fmt::Display for ErrorCode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

impl PartialEq<&str> for ErrorCode {
    fn eq(&self, other: &&str) -> bool {
        self.as_str() == *other
    }
}

impl Serialize for ErrorCode {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.as_str())
    }
}

/// A list in the schema, of which generated types are a union: a front end cannot compare with a code that is not there.
impl JsonSchema for ErrorCode {
    fn schema_name() -> Cow<'static, str> {
        "ErrorCode".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let codes: Vec<&str> = Self::ALL.iter().map(|code| code.as_str()).collect();
        json_schema!({
            "description": "The kind of an error: a name that stays the same.",
            "type": "string",
            "enum": codes
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two errors under one name could not be told apart, and a script would do the wrong thing about one of them.
    #[test]
    fn a_code_names_one_kind_of_error() {
        let mut spelt: Vec<&str> = ErrorCode::ALL.iter().map(|code| code.as_str()).collect();
        let count = spelt.len();
        spelt.sort_unstable();
        spelt.dedup();
        assert_eq!(spelt.len(), count);
        let plain = |code: &&str| code.bytes().all(|byte| byte.is_ascii_lowercase() || byte == b'-');
        assert!(spelt.iter().all(plain), "{spelt:?}");
    }
}
