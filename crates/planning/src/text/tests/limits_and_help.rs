//! Where limits come from, and what a person can do.

use super::*;

#[test]
fn limits_say_where_they_come_from() {
    let axis = ReachLimit::Axis { needed: deg(102.2), travel: stated(deg(100.0)) };
    let reasoned =
        Source { reason: Some("the paper".to_owned()), entry: "kit, limits.min_feed_mm".to_owned() };
    for (limit, words) in [
        (LimitSource::Stated(&reasoned), "the paper [kit, limits.min_feed_mm]"),
        (LimitSource::Stated(&stated(()).source), "the profile"),
        (LimitSource::WeldTolerance, "the weld tolerance"),
        (LimitSource::EulerPath, "Euler: only the ends of wires may be odd"),
        (LimitSource::BendRadius(mm(3.0)), "bends of centreline radius 3.00 mm"),
        (
            LimitSource::Reach(&axis),
            "the bend axis, which would have to reach 102.2° and goes to 100.0° [the profile]",
        ),
        (LimitSource::Reach(&ReachLimit::Peg), "springback and setback of this wire on this machine"),
        (LimitSource::AxisResolution, "half the resolution of the bend axis"),
        (LimitSource::EulerLoad, "half the load at which a column with pinned ends buckles (Euler)"),
    ] {
        assert_eq!(source(limit), words);
    }
}

#[test]
fn remedies_are_alternatives_with_their_figures() {
    let helps = |remedies, words: &str| {
        assert_eq!(help(&finding(Location::default(), Fact::NoEdges, remedies)), words);
    };
    helps(vec![Remedy::OpenAngleOfTwo], "open the angle between two of its edges");
    helps(
        vec![Remedy::OpenAngle, Remedy::StartAtVertex { added: None }],
        "open the angle between the two edges, or start the wire at this vertex",
    );
    helps(
        vec![Remedy::TurnBendPlane, Remedy::ChooseStart, Remedy::ChooseMachineWithRotation],
        "turn the plane of the bend, start the wire at another vertex, or choose a machine whose head turns farther",
    );
    helps(
        vec![Remedy::LengthenEdge { by: Some(mm(3.07)) }, Remedy::ScaleUp],
        "make the edge at least 3.1 mm longer, or scale the design up",
    );
    helps(vec![Remedy::KeepBendBelow { max: deg(85.0) }], "keep the bend below 85.00°");
    let edges = |count: u32| (0..count).map(EdgeId).collect();
    helps(
        vec![Remedy::DoubleEdges { edges: edges(3), added: mm(90.0), design: mm(360.0) }],
        "run the wire along 3 edges twice: that adds 90.0 mm (25.0 % of the design), the least possible",
    );
    helps(
        vec![
            Remedy::ChooseStart,
            Remedy::LeaveStartOpen,
            Remedy::DoubleEdges { edges: edges(1), added: mm(70.0), design: mm(140.0) },
        ],
        "start the wire at another vertex, leave its start open, or run the wire along 1 edge twice: that adds 70.0 mm (50.0 % of the design), the least possible",
    );
}

/// No front end's words, no full stop: what a person reads continues in a list, beside an option or a button.
#[test]
fn every_remedy_is_a_clause() {
    let by = Some(mm(1.0));
    let all = [
        Remedy::Leave,
        Remedy::LeaveTouching,
        Remedy::LeaveRoom,
        Remedy::HoldUp,
        Remedy::TieWires,
        Remedy::FastenThere,
        Remedy::JoinEdges,
        Remedy::DrawEdges,
        Remedy::TakeFaceEdges,
        Remedy::DeleteEdge,
        Remedy::DeleteParallelEdge,
        Remedy::MergeVertices,
        Remedy::ConnectVertex,
        Remedy::DeleteVertex,
        Remedy::ConnectParts,
        Remedy::BendEachPart,
        Remedy::DoubleEdges { edges: vec![EdgeId(0)], added: mm(1.0), design: mm(0.0) },
        Remedy::FindDoubling,
        Remedy::ReduceOddVertices,
        Remedy::StartAtVertex { added: None },
        Remedy::StartAtVertex { added: Some(mm(12.5)) },
        Remedy::EndAtVertex,
        Remedy::ChooseStart,
        Remedy::LeaveStartOpen,
        Remedy::SplitDesign,
        Remedy::SplitEdge,
        Remedy::LengthenEdge { by },
        Remedy::LengthenEdge { by: None },
        Remedy::ShortenStraight,
        Remedy::AddBend,
        Remedy::ScaleUp,
        Remedy::ScaleDown,
        Remedy::OpenAngle,
        Remedy::OpenAngleOfTwo,
        Remedy::KeepBendBelow { max: deg(1.0) },
        Remedy::EnlargeBend,
        Remedy::Straighten,
        Remedy::EaseBends,
        Remedy::TurnBendPlane,
        Remedy::MoveApart,
        Remedy::AvoidCollisions,
        Remedy::SearchLonger,
        Remedy::AllowWires,
        Remedy::MeasureBody,
        Remedy::SupportVertices,
        Remedy::BraceFrame,
        Remedy::ChooseMaterial,
        Remedy::ChooseMachine,
        Remedy::ChooseMachineWithRotation,
    ];
    for remedy in all {
        let words = help(&finding(Location::default(), Fact::NoEdges, vec![remedy]));
        assert!(words.starts_with(char::is_lowercase) && !words.ends_with('.'), "{words}");
        assert!(!words.contains("--") && !words.contains('`') && words.split(' ').count() > 1, "{words}");
    }
}

#[test]
fn a_bend_that_is_tighter_than_the_wire_takes_is_told_with_both_radii() {
    let least_diameters = Sourced { value: 1.5, source: stated(()).source };
    let (inner, inner_within, diameter) = (mm(1.5), mm(0.0), mm(3.0));
    says(
        Location::default(),
        Fact::BendRadiusSmall(BendRadius { inner, inner_within, diameter, least_diameters }),
        "the inside of every bend has a radius of 1.50 mm, and this wire was seen to take 4.50 mm or more (1.5 times its diameter): the outside of bends may crack",
    );
    let least_diameters = Sourced { value: 0.501, source: stated(()).source };
    says(
        Location::default(),
        Fact::BendRadiusSmall(BendRadius { inner, inner_within, diameter, least_diameters }),
        "the inside of every bend has a radius of 1.500 mm, and this wire was seen to take 1.503 mm or more (0.501 times its diameter): the outside of bends may crack",
    );
}
