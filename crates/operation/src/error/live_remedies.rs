//! What can be done about a problem with a machine.

use wirebend_error::{ErrorRemedy as R, InputName};

use super::live::after_hard_stop;
use super::{HeadProblem, LiveProblem};

impl LiveProblem {
    /// What can be done about it.
    pub fn remedies(&self) -> Vec<R> {
        match self {
            Self::NoPort { known } => vec![R::ChoosePort { known: known.clone() }],
            Self::FilesOnly { .. } => vec![R::ExportFile],
            Self::NotConfirmed => vec![R::ConfirmMotion],
            Self::YesForPieces { .. } => vec![R::AnswerEachPiece],
            Self::ZeroNotConfirmed => vec![R::ConfirmZero],
            Self::Head(problem) => problem.remedies(),
            Self::Declined => Vec::new(),
            Self::Stopped { .. } | Self::Held { .. } => vec![R::Home],
            Self::Unstopped { by, .. } => after_hard_stop(*by),
            Self::MayMove { .. } => vec![R::CutPower, R::ConnectAgain],
            Self::Unrecorded { stands, run, .. } => {
                let power = (!stands).then_some(R::CutPower);
                power.into_iter().chain([R::CheckDisk, R::ResumeRun { run: run.clone() }]).collect()
            }
            Self::NoAnswer { .. } => vec![R::CheckPowerAndPort],
            Self::AtWork { .. } => vec![R::Wait, R::Stop],
            Self::Fault(report) => report.remedies.clone(),
            Self::Session(error) => error.remedies(),
            Self::Job(error) => error.remedies(),
            Self::SettingsDiffer { machine, port, writable, .. } => {
                let (machine, port) = (machine.clone(), port.clone());
                let set = if *writable { R::WriteSettings { machine, port } } else { R::SetMachine };
                vec![set, R::AcceptSettings]
            }
            Self::NoCutter { able: true, .. } => vec![R::ChangeDriverSetting, R::CutByHand],
            Self::NoCutter { .. } | Self::EndTooShort { .. } => vec![R::CutByHand],
            Self::BendTooFar { .. } => vec![R::CorrectInput { input: InputName::Moves }],
            Self::NoWire { .. } | Self::WhichWire { .. } | Self::SeveralUnfinished { .. } => {
                vec![R::ChooseWire]
            }
            Self::Unfinished { run, .. } | Self::WireInMachine { run, .. } => {
                vec![R::ResumeRun { run: run.clone() }, R::AbandonRun { run: run.clone() }]
            }
            Self::DamagedJournal { run, .. } => vec![R::AbandonRun { run: run.clone() }],
            Self::NotSimulated { .. } => vec![R::LeaveOut { inputs: vec![InputName::SimulatedAs] }],
            Self::NothingBegun { input } => vec![R::LeaveOut { inputs: vec![*input] }],
            Self::NothingUnfinished => vec![R::LeaveOut { inputs: vec![InputName::Abandon] }],
            Self::InDoubt { doubt, run } => {
                vec![R::AnswerDoubt { run: run.clone(), step: doubt.step, counted: doubt.counted.is_some() }]
            }
            Self::OtherStep { run, .. } => vec![R::ResumeWithoutAnswer { run: run.clone() }],
            Self::NotCounted { .. } => vec![R::MeasureStep],
            Self::Contradiction { run, .. } => vec![R::StopAndAnswer { run: run.clone() }],
            Self::NowhereToRecord => vec![R::SetHome, R::NameRunsFolder],
            Self::RunsFolder { .. } => vec![R::CheckDisk],
            Self::NoRun { .. } => vec![R::ListRuns],
            Self::SeveralRuns { known, .. } => {
                vec![R::ChooseKnown { near: Vec::new(), known: known.clone() }]
            }
            Self::Moves { .. } => vec![R::RecordAgain],
            Self::OtherMachine { machine, .. } => vec![R::ReplayHere { machine: machine.clone() }],
        }
    }
}

impl HeadProblem {
    /// What can be done about it.
    pub fn remedies(&self) -> Vec<R> {
        match self {
            Self::Unknown { .. } => vec![R::StateHead, R::TurnHeadBack],
            Self::Turned { .. } | Self::Beyond { .. } => vec![R::TurnHeadBack],
            Self::TooFar { .. } => vec![R::TurnHeadLess],
        }
    }
}

#[cfg(test)]
mod tests {
    use wirebend_driver_host::api::SettingCheck;

    use super::*;

    /// A command that the driver refuses leads a person in a circle.
    #[test]
    fn settings_are_written_only_where_the_driver_can() {
        let told = |writable| {
            let setting = SettingCheck {
                name: "$100".to_owned(),
                machine: "80".to_owned(),
                expected: "40".to_owned(),
                matters: true,
            };
            let (machine, port) = ("bender".to_owned(), "/dev/ttyUSB0".to_owned());
            LiveProblem::SettingsDiffer { machine, port, settings: vec![setting], writable }
        };
        assert!(told(true).to_string().ends_with("wires would come out wrong: $100 is 80, not 40"));
        let (machine, port) = ("bender".to_owned(), "/dev/ttyUSB0".to_owned());
        assert_eq!(told(true).remedies(), [R::WriteSettings { machine, port }, R::AcceptSettings]);
        assert_eq!(told(false).remedies(), [R::SetMachine, R::AcceptSettings]);
    }
}
