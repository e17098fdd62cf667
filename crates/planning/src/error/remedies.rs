//! What can be done about an error of planning.

use wirebend_accuracy::ClosingError;
use wirebend_core::calibrate::CalibrationError;
use wirebend_driver_host::advice_of;
use wirebend_error::{ErrorRemedy, InputName};
use wirebend_files::read::Format;

use super::{DriverProblem, PlanningError, StencilFileError};

/// What a material profile lacks without which no frame of it can be computed.
const SHEAR_MODULUS: &str = "\"poisson_ratio\": {\"value\": number, \"source\": text, \"measured\": true or false}, or \"shear_modulus_gpa\" like it";

impl PlanningError {
    /// What can be done about it.
    #[must_use]
    pub fn remedies(&self) -> Vec<ErrorRemedy> {
        use ErrorRemedy as R;
        match self {
            Self::Read(error) => error.remedies(),
            Self::Document(error) => error.remedies(),
            Self::Profile(error) => error.remedies(),
            Self::Stencil(error) => error.remedies(),
            Self::Driver(problem) => problem.remedies(),
            Self::Geometry { .. }
            | Self::Springback { .. }
            | Self::Noise { .. }
            | Self::StrutBuilder { .. }
            | Self::Calibration(CalibrationError::Geometry(_))
            | Self::Closing { error: ClosingError::Errors(_), .. } => vec![R::CorrectProfile],
            Self::Calibration(_)
            | Self::Beyond { .. }
            | Self::Closing { error: ClosingError::SeveralParts { .. }, .. }
            | Self::StrutWithoutLength { .. }
            | Self::Faces { .. }
            | Self::SequenceFile { .. } => vec![R::CorrectFile],
            Self::ShippedProfile { .. } => vec![R::CopyProfile],
            Self::NothingToRevert { .. } => vec![R::CorrectInput { input: InputName::ProfileKeys }],
            Self::NoMaterial { known } => vec![R::ChooseKnown { near: Vec::new(), known: known.clone() }],
            Self::LoadCase { known, .. } => vec![R::ChooseLoadCase { known: known.clone() }],
            Self::NoShearModulus { .. } => vec![R::AddKey { text: SHEAR_MODULUS.to_owned() }],
            Self::NoWalks { .. } => vec![R::LeaveOut { inputs: vec![InputName::GroupBy] }],
            Self::OtherDesign { error, .. } => error.remedies(),
            Self::NoFrame { .. } => vec![R::CheckScale, R::SimplifyModel],
            Self::NoModes { .. } => vec![R::CorrectInput { input: InputName::Modes }],
            Self::Closing { error: ClosingError::Bowed, .. } => {
                vec![R::LeaveOut { inputs: vec![InputName::Expected] }]
            }
            Self::Closing { .. } | Self::DamagedJob { .. } => vec![R::PlanAgain],
            Self::NoLimit | Self::OnlyLengths => vec![
                R::CorrectInput { input: InputName::Requirements },
                R::CorrectInput { input: InputName::Vary },
            ],
            Self::NoSurface { .. } => vec![R::OpenAsWireframe],
            Self::Value { input, .. } => input.iter().map(|&input| R::CorrectInput { input }).collect(),
            Self::IdTaken { .. } => vec![R::ChooseOtherId],
            Self::SeveralKinds { kinds, .. } | Self::OtherKind { kinds, .. } => {
                vec![R::ChooseKind { kinds: kinds.iter().map(ToString::to_string).collect() }]
            }
            Self::OpenParent { missing, complete, .. } if complete.is_empty() => {
                vec![R::InheritFrom { ids: Vec::new() }, R::AddKey { text: missing.join(", ") }]
            }
            Self::OpenParent { complete, .. } => vec![R::InheritFrom { ids: complete.clone() }],
            Self::NoMachine { known } => vec![R::ChooseMachine { known: known.clone() }],
            Self::OnlyStencil { format, .. } => vec![edges_of_faces(*format), R::TraceSurface],
            Self::NoVertex { input, .. } => vec![R::CorrectInput { input: *input }],
            Self::StartWithoutEdge { .. } => vec![R::CorrectInput { input: InputName::Start }],
            Self::UnknownFormat { known, missing, .. } => {
                let driver = missing.iter().flat_map(|problem| problem.remedies());
                std::iter::once(R::ChooseKnown { near: Vec::new(), known: known.clone() })
                    .chain(driver)
                    .collect()
            }
            Self::NoSettings { .. } => vec![R::LeaveOut { inputs: vec![InputName::FormatSettings] }],
            Self::FormatOfAnother { known, .. } if known.is_empty() => {
                vec![R::PlanForMachine { machine: None }]
            }
            Self::FormatOfAnother { known, .. } => vec![
                R::PlanForMachine { machine: None },
                R::ChooseKnown { near: Vec::new(), known: known.clone() },
            ],
            Self::NotAJob { .. } | Self::GCodeToRun { .. } => vec![R::MakeJob],
            Self::IsAJob { .. } => vec![R::UseJob, R::UseDesign],
            Self::Compensated { .. } | Self::OtherCompensation { .. } => {
                vec![R::ChooseMachineAndMaterial, R::TakeAsNominal]
            }
            Self::NoOrder { .. } => vec![R::UseProgramFile],
            Self::Settled { inputs, instead, .. } => {
                vec![R::LeaveOut { inputs: inputs.clone() }, (**instead).clone()]
            }
            Self::WithoutEffect { inputs, .. } => vec![R::LeaveOut { inputs: inputs.clone() }],
            Self::ClosedWires { .. } => {
                let leave_out = |input| R::LeaveOut { inputs: vec![input] };
                [InputName::Closed, InputName::Wires].map(leave_out).into()
            }
            Self::NoBender { .. } => vec![R::LeaveOut { inputs: vec![InputName::SimulatedAs] }],
            Self::OtherMachine { wanted, .. } => vec![R::PlanForMachine { machine: Some(wanted.clone()) }],
            Self::Unwritable { .. } => vec![R::ExportAs { form: "template-svg or template-dxf".to_owned() }],
            Self::StageNotReached { .. } => vec![R::FixFindings],
            Self::NotFeasible { .. } => vec![R::FixFindings, R::IgnoreFindings],
            Self::Exists(path) => vec![R::ChooseOtherFile, R::Overwrite { path: path.clone() }],
            Self::Stopped | Self::Picture(_) | Self::Json(_) => Vec::new(),
        }
    }
}

/// How the edges of faces become a wireframe: a document is taken as it is.
pub(crate) const fn edges_of_faces(format: Format) -> ErrorRemedy {
    match format {
        Format::Wirebend => ErrorRemedy::ImportFaceEdges,
        _ => ErrorRemedy::TakeFaceEdges,
    }
}

impl DriverProblem {
    /// What can be done about it.
    #[must_use]
    pub fn remedies(&self) -> Vec<ErrorRemedy> {
        use ErrorRemedy as R;
        match self {
            Self::NoDriver { waiting, .. } => {
                let trust = waiting.iter().map(|file| R::TrustDriver { file: file.clone(), again: false });
                trust.chain([R::ListDrivers, R::NameDriverFolder]).collect()
            }
            Self::OwnFormat { cause, .. } => cause.remedies(),
            Self::Host(error) => error.remedies(),
            Self::Unwritten { error, .. } | Self::Settings { error, .. } => advice_of(error),
            Self::BeyondLimit { .. } => vec![R::PlanWithinLimit, R::ChangeDriverSetting],
            Self::Library { .. } => vec![R::CheckReadable],
            Self::OtherLibrary { .. } => vec![R::CheckRightFile],
            Self::NowhereToTrust => vec![R::SetHome],
            Self::OwnProgram(_) => Vec::new(),
        }
    }
}

impl StencilFileError {
    /// What can be done about it.
    #[must_use]
    pub fn remedies(&self) -> Vec<ErrorRemedy> {
        match self {
            Self::Read(error) => error.remedies(),
            Self::NoSurface { .. } => vec![ErrorRemedy::CheckRightFile],
            Self::NoFolder { .. } => vec![ErrorRemedy::OpenFromFolder],
            Self::Outside { .. } => vec![ErrorRemedy::PutFilesBeside],
        }
    }
}

wirebend_error::reported!(crate::text::shown => PlanningError, DriverProblem);
