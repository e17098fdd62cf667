//! The options of the command line by which remedies are done.

use wirebend_api::RemedyReport;

/// The options of some remedies, each once, in their order. What is done in the design itself has none.
pub(super) fn of(remedies: &[RemedyReport]) -> Vec<&'static str> {
    let mut options: Vec<&str> = Vec::new();
    for option in remedies.iter().filter_map(option) {
        if !options.contains(&option) {
            options.push(option);
        }
    }
    options
}

fn option(remedy: &RemedyReport) -> Option<&'static str> {
    match remedy {
        RemedyReport::DoubleEdges { .. } | RemedyReport::FindDoubling => Some("--double"),
        RemedyReport::Detour { .. } => Some("--detours"),
        RemedyReport::StartAtVertex { added_mm: Some(added) } if *added > 0.0 => {
            Some("--start VERTEX --double")
        }
        RemedyReport::StartAtVertex { .. } | RemedyReport::EndAtVertex | RemedyReport::ChooseStart => {
            Some("--start VERTEX")
        }
        RemedyReport::AvoidCollisions => Some("--avoid-collisions"),
        RemedyReport::SearchLonger => Some("--effort STEPS"),
        RemedyReport::AllowWires => Some("--wires N"),
        RemedyReport::TakeFaceEdges => Some("--face-edges"),
        RemedyReport::ChooseMaterial => Some("--material ID"),
        RemedyReport::SupportVertices => Some("--supports VERTICES"),
        RemedyReport::ChooseMachine | RemedyReport::ChooseMachineWithRotation => Some("--machine ID"),
        RemedyReport::Leave
        | RemedyReport::LeaveTouching
        | RemedyReport::LeaveRoom
        | RemedyReport::HoldUp
        | RemedyReport::TieWires
        | RemedyReport::FastenThere
        | RemedyReport::JoinEdges
        | RemedyReport::DrawEdges
        | RemedyReport::DeleteEdge
        | RemedyReport::DeleteParallelEdge
        | RemedyReport::MergeVertices
        | RemedyReport::ConnectVertex
        | RemedyReport::DeleteVertex
        | RemedyReport::ConnectParts
        | RemedyReport::BendEachPart
        | RemedyReport::ReduceOddVertices
        | RemedyReport::LeaveStartOpen
        | RemedyReport::SplitDesign
        | RemedyReport::SplitEdge
        | RemedyReport::LengthenEdge { .. }
        | RemedyReport::ShortenStraight
        | RemedyReport::AddBend
        | RemedyReport::ScaleUp
        | RemedyReport::ScaleDown
        | RemedyReport::OpenAngle
        | RemedyReport::OpenAngleOfTwo
        | RemedyReport::KeepBendBelow { .. }
        | RemedyReport::EnlargeBend
        | RemedyReport::Straighten
        | RemedyReport::EaseBends
        | RemedyReport::TurnBendPlane
        | RemedyReport::MoveApart
        | RemedyReport::Calibrate
        | RemedyReport::MeasureBody
        | RemedyReport::BraceFrame
        | RemedyReport::BuildLater
        | RemedyReport::TurnHead
        | RemedyReport::MoveFrame => None,
        RemedyReport::AllowMoreSag => Some("--epsilon MM"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_option_is_named_once() {
        let remedies = [
            RemedyReport::ChooseStart,
            RemedyReport::LeaveStartOpen,
            RemedyReport::StartAtVertex { added_mm: None },
        ];
        assert_eq!(of(&remedies), ["--start VERTEX"]);
        assert_eq!(of(&[RemedyReport::OpenAngle]), [""; 0]);
    }
}
