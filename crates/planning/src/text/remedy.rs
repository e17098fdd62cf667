//! What can be done, as clauses that begin with a verb.

use wirebend_core::checks::Remedy;
use wirebend_core::units::{Length, Mm};

use super::number::{at_least, at_most, count};

/// One remedy, in the words of no front end.
pub(super) fn clause(remedy: &Remedy) -> String {
    let words = match remedy {
        Remedy::Leave => "leave it",
        Remedy::LeaveTouching => "leave them where two wires are meant to touch",
        Remedy::LeaveRoom => "leave room for the wires side by side",
        Remedy::HoldUp => "hold the part up while it is bent",
        Remedy::TieWires => "tie them together",
        Remedy::FastenThere => "weld or tie them there",
        Remedy::JoinEdges => "join them there with a vertex",
        Remedy::DrawEdges => "draw edges",
        Remedy::TakeFaceEdges => "take the edges of a model's faces",
        Remedy::DeleteEdge => "delete the edge",
        Remedy::DeleteParallelEdge => {
            "delete one of them: an edge that the wire has to pass twice is doubled by the route"
        }
        Remedy::MergeVertices => "merge the vertices",
        Remedy::ConnectVertex => "connect the vertex to another one",
        Remedy::DeleteVertex => "delete it",
        Remedy::ConnectParts => "connect the parts to bend them from one wire",
        Remedy::BendEachPart => "bend one wire for each part",
        Remedy::DoubleEdges { edges, added, design } => {
            let share = 100.0 * added.mm() / design.mm().max(f64::MIN_POSITIVE);
            let edges = count(edges.len(), "edge", "edges");
            return format!(
                "run the wire along {edges} twice: that adds {added:.1} ({share:.1} % of the design), the least possible"
            );
        }
        Remedy::Detour { edges, added } => {
            let edges = count(edges.len(), "more edge", "more edges");
            return format!("take a detour: run the wire along {edges} twice, which adds {added:.1}");
        }
        Remedy::FindDoubling => "run the wire along the cheapest edges twice",
        Remedy::ReduceOddVertices => "add and delete edges until at most two corners are odd",
        Remedy::StartAtVertex { added: None } => "start the wire at this vertex",
        Remedy::StartAtVertex { added: Some(added) } if added.mm().abs() < 0.05 => {
            "start the wire at this vertex, which adds no length"
        }
        Remedy::StartAtVertex { added: Some(added) } => {
            let adds = if *added > Length::ZERO { "adds" } else { "saves" };
            return format!("start the wire at this vertex, which {adds} {:.1}", added.abs());
        }
        Remedy::EndAtVertex => "start or end the wire there",
        Remedy::ChooseStart => "start the wire at another vertex",
        Remedy::LeaveStartOpen => "leave its start open",
        Remedy::SplitDesign => "divide the design into several wires",
        Remedy::SplitEdge => "divide the edge among two wires",
        Remedy::LengthenEdge { by: Some(by) } => {
            return format!("make the edge at least {:.1} longer", Mm(at_least(by.mm(), 1)));
        }
        Remedy::LengthenEdge { by: None } => "make the edge longer",
        Remedy::ShortenStraight => "shorten the straight part",
        Remedy::AddBend => "put a bend into it",
        Remedy::ScaleUp => "scale the design up",
        Remedy::ScaleDown => "scale the design down",
        Remedy::OpenAngle => "open the angle between the two edges",
        Remedy::OpenAngleOfTwo => "open the angle between two of its edges",
        Remedy::KeepBendBelow { max } => return format!("keep the bend below {:.2}°", at_most(max.deg(), 2)),
        Remedy::EnlargeBend => "make the bend larger",
        Remedy::Straighten => "make the edges straight there",
        Remedy::EaseBends => "make its bends gentler",
        Remedy::TurnBendPlane => "turn the plane of the bend",
        Remedy::MoveApart => "move the edges apart",
        Remedy::AvoidCollisions => "search for a program without collisions",
        Remedy::SearchLonger => "search longer",
        Remedy::AllowWires => "allow more wires",
        Remedy::Calibrate => "calibrate the machine before the first wire",
        Remedy::MeasureBody => "measure it and enter its dimensions in the machine's profile",
        Remedy::SupportVertices => "hold it at vertices that stand on something",
        Remedy::BraceFrame => "brace it with more struts",
        Remedy::BuildLater => "build it at another step",
        Remedy::TurnHead => "choose another direction of the head",
        Remedy::MoveFrame => "move the frame to where the machine reaches",
        Remedy::AllowMoreSag => "allow joints to be farther off",
        Remedy::ChooseMaterial => "choose another material",
        Remedy::ChooseMachine => "choose another machine",
        Remedy::ChooseMachineWithRotation => "choose a machine whose head turns farther",
    };
    words.to_owned()
}
