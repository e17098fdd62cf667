use wirebend_accuracy::ClosingError;
use wirebend_core::compensate::{PegGeometryError, PegRadius, SpringbackError};
use wirebend_core::simulate::{BadErrorTerm, ErrorSource};
use wirebend_core::units::{Angle, Length};
use wirebend_core::wireframe::{EdgeId, EditError, FilletFault, VertexId, WireframeError};

fn mm(value: f64) -> Length {
    Length::from_mm(value).unwrap()
}

#[test]
fn an_edit_that_cannot_be_made_says_why_and_what_would_be_right() {
    let (a, b) = (VertexId(1), VertexId(2));
    let fillet = |fault, min_edge| EditError::Fillet {
        vertex: a,
        radius: mm(5.0),
        length: mm(3.8),
        min_edge: mm(min_edge),
        fault,
        nearest: None,
    };
    for (error, words) in [
        (EditError::Wireframe(WireframeError::NoVertex(a)), "there is no vertex 1"),
        (EditError::NoEdge(EdgeId(7)), "there is no edge 7"),
        (EditError::Repeated(a), "vertex 1 is listed twice"),
        (EditError::Loop(a), "vertex 1 cannot be connected to itself"),
        (EditError::RepeatedEdge(EdgeId(7)), "edge 7 is listed twice"),
        (EditError::ChainCount(1), "a chain takes at least 2 edges, 1 given"),
        (
            EditError::Branched { vertex: a, edges: 3 },
            "the edges are no chain: 3 of them meet at vertex 1, and at most 2 can",
        ),
        (EditError::BrokenChain(EdgeId(7)), "the edges are no chain: edge 7 is not connected to the others"),
        (EditError::ClosedChain, "the edges are a closed loop, and a chain has two ends"),
        (
            EditError::ArcStep(Angle::ZERO),
            "the step along an arc has to be more than 0° and at most 180°: 0.000° is not",
        ),
        (
            EditError::SmallArc { radius: mm(5.0), min_edge: mm(12.0) },
            "an arc of radius 5.00 mm cannot be made of edges of at least 12.00 mm",
        ),
        (EditError::EdgeLength(-3.0), "-3 mm is no length of an edge: it has to be more than 0"),
        (
            EditError::CornerAngle(270.0),
            "270° is no angle between edges: it has to be more than 0° and at most 180°",
        ),
        (EditError::NotAnEnd { edge: EdgeId(7), vertex: a }, "vertex 1 is not an end of edge 7"),
        (
            EditError::NoDirection(EdgeId(7)),
            "the ends of edge 7 are at the same place, so it has no direction",
        ),
        (EditError::NoCorner { vertex: a, edges: 3 }, "vertex 1 has 3 edges, and an angle is between 2"),
        (EditError::SameEnds(EdgeId(7), EdgeId(8)), "edges 7 and 8 join the same two vertices"),
        (
            EditError::InLine(a),
            "the two edges at vertex 1 are in line, which leaves open in which plane to turn one",
        ),
        (
            EditError::InLoop(EdgeId(7)),
            "edge 7 is part of a closed loop: the rest is connected to both of its ends and cannot follow one",
        ),
        (EditError::FilletRadius(0.0), "0 mm is no radius of a fillet: it has to be more than 0"),
        (
            EditError::StraightCorner(a),
            "the edges at vertex 1 are in line or on each other: there is no corner to round",
        ),
        (EditError::HeldCorner(a), "vertex 1 is a support or has a joint, which a fillet would move"),
        (
            fillet(FilletFault::Chords, 20.4),
            "the chords of a fillet of 5.0 mm at vertex 1 would be shorter than 20.4 mm, the shortest that can be made there",
        ),
        (
            fillet(FilletFault::Edges, 20.4),
            "what a fillet of 5.0 mm leaves of the edges at vertex 1 would be shorter than 20.4 mm, the shortest that can be made there",
        ),
        (fillet(FilletFault::Edges, 0.0), "the edges at vertex 1 are too short for a fillet of 5.0 mm"),
        (
            EditError::Sides { sides: 2, max: 10_000 },
            "a polygon has from 3 to 10\u{202f}000 sides, and not 2",
        ),
        (EditError::ShapeSize(-1.0), "-1 mm is no size: it has to be more than 0"),
        (EditError::Turns(0.0), "a helix has more than 0 and at most 10\u{202f}000 turns, and not 0"),
        (EditError::Connected(a, b), "vertices 1 and 2 are connected already"),
        (
            EditError::SplitAt(1.5),
            "an edge is split between its ends: 1.5 is not more than 0 and less than 1",
        ),
        (EditError::MergeCount(1), "merging takes at least 2 vertices, 1 given"),
        (EditError::Singular, "the transform is not invertible: it would flatten the wireframe"),
        (EditError::EmptyStrand, "a strand takes a vertex to begin at or a point to go through"),
        (
            EditError::TooMuch { count: 2_000_000, max: 1_000_000 },
            "2\u{202f}000\u{202f}000 vertices or edges are too many: at most 1\u{202f}000\u{202f}000 can be added at once",
        ),
        (
            EditError::NotInPiece { index: 4, count: 4 },
            "an edge of the piece ends at its vertex 4, but it has 4, counted from 0",
        ),
        (
            EditError::ArrayCount { copies: 900_000, max: 1_000_000 },
            "an array of 900000 copies is too large: at most 1\u{202f}000\u{202f}000 vertices can be added at once",
        ),
    ] {
        assert_eq!(super::edit(&error), words);
    }
}

#[test]
fn models_of_machine_and_material_say_which_figure_is_wrong() {
    let radius = PegGeometryError::NotPositive { radius: PegRadius::Pin, value: Length::ZERO };
    assert_eq!(super::peg_geometry(&radius), "the pin radius is 0.0 mm: it must be more than 0");
    let short = PegGeometryError::NoContact { orbit_radius: mm(4.0), peg: mm(4.7) };
    assert_eq!(
        super::peg_geometry(&short),
        "the peg never touches the wire: its orbit of radius 4.0 mm is smaller than its contact distance 4.7 mm"
    );
    let behind = PegGeometryError::Behind { offset: mm(-19.9), orbit_radius: mm(20.4) };
    assert_eq!(
        super::peg_geometry(&behind),
        "the peg never touches the wire: with an orbit offset of -19.9 mm its orbit of radius 20.4 mm ends before the pin"
    );
    for (error, words) in [
        (SpringbackError::Empty, "the springback table needs at least one measured pair"),
        (
            SpringbackError::Range(0),
            "pair 1 of the springback table: the formed angle and the loss must not be negative",
        ),
        (
            SpringbackError::NotIncreasing(1),
            "pair 2 of the springback table: both the formed angle and the formed angle plus loss must increase",
        ),
    ] {
        assert_eq!(super::springback(&error), words);
    }
    assert_eq!(
        super::closing(&ClosingError::NoVertex { wire: 0, vertex: 7, vertices: 3 }),
        "wire 1 passes vertex 7, and there are 3"
    );
    assert_eq!(
        super::closing(&ClosingError::OtherProgram { wire: 1, struts: 4, segments: 3 }),
        "wire 2 runs along 4 edges, and its program has 3 straight parts"
    );
    assert_eq!(
        super::closing(&ClosingError::SeveralParts { parts: 2 }),
        "the design is in 2 parts: how far each is off from the other is not known before something joins them"
    );
    let noise = BadErrorTerm { of: ErrorSource::Bend, bias: 0.0, sigma: -1.0 };
    assert_eq!(
        super::noise(&noise),
        "the error of bends is 0 ± -1: both must be finite and the deviation not negative"
    );
}
