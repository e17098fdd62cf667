use wirebend_core::bend::PathError;
use wirebend_core::checks::{
    BendOf, BendRadius, ClosingBend, Diagnostic, Fact, LimitSource, Location, Meeting, ReachLimit, Remedy,
    Severity, Source, Sourced,
};
use wirebend_core::clearance::{Obstacle, Phase};
use wirebend_core::compensate::NearCorner;
use wirebend_core::route::RouteError;
use wirebend_core::search::Helps;
use wirebend_core::units::{Angle, Length};
use wirebend_core::wireframe::{EdgeId, VertexId};

use super::{help, message, source};

fn mm(value: f64) -> Length {
    Length::from_mm(value).unwrap()
}

fn deg(value: f64) -> Angle {
    Angle::from_deg(value).unwrap()
}

fn stated<T>(value: T) -> Sourced<T> {
    Sourced { value, source: Source { reason: None, entry: "the profile".to_owned() } }
}

fn finding(location: Location, fact: Fact, remedies: Vec<Remedy>) -> Diagnostic {
    Diagnostic { severity: Severity::Error, location, fact, remedies }
}

/// At vertex 4, along some edges, in the third step.
fn at(edges: &[u32]) -> Location {
    let edges = edges.iter().map(|&id| EdgeId(id)).collect();
    Location { vertices: vec![VertexId(4)], edges, step: Some(2) }
}

/// What a finding without remedies reads like.
fn says(location: Location, fact: Fact, words: &str) {
    assert_eq!(message(&finding(location, fact, Vec::new())), words);
}

#[test]
fn findings_of_the_drawing_name_vertices_and_edges() {
    let nowhere = Location::default;
    let (a, b) = (VertexId(1), VertexId(2));
    let zero = Fact::ZeroLengthEdge { edge: EdgeId(7), ends: [a, b], length: Length::ZERO };
    says(nowhere(), zero, "edge 7 from vertex 1 to vertex 2 has no length");
    let no_direction = || Fact::NoPath(PathError::NoDirection(3));
    says(at(&[7]), no_direction(), "edge 7 has no length: the wire has no direction there");
    says(at(&[]), no_direction(), "segment 4 of the wire has no length: the wire has no direction there");
    says(at(&[]), Fact::NoPath(PathError::TooShort(1)), "the route has 1 point: a wire takes at least 2");
    let parallel = Fact::ParallelEdges { edges: [EdgeId(3), EdgeId(9)], ends: [a, b] };
    says(nowhere(), parallel, "edges 3 and 9 both join vertices 1 and 2");
    let close = Fact::CoincidentVertices { vertices: [a, b], distance: mm(5e-4), tolerance: mm(1e-3) };
    says(nowhere(), close, "vertices 1 and 2 are 0.0005 mm apart but not merged");
    let closed_by = |near, closing| Fact::EdgesMeet {
        edges: [EdgeId(3), EdgeId(9)],
        near,
        from: [a, b],
        along: [mm(35.0), mm(0.5)],
        distance: mm(1.0),
        diameter: mm(3.0),
        closing,
    };
    let meet = |near| closed_by(near, None);
    let nearer = "1.0 mm from centre to centre, and the wire is 3.0 mm thick";
    let through = "they run through each other";
    says(
        nowhere(),
        meet([None, None]),
        &format!("edges 3 and 9 meet 35.0 mm from vertex 1: {nearer}; {through}"),
    );
    says(
        nowhere(),
        meet([None, Some(b)]),
        &format!("edge 3 meets vertex 2, 35.0 mm from vertex 1: {nearer}; {through}"),
    );
    says(
        nowhere(),
        meet([Some(a), None]),
        &format!("edge 9 meets vertex 1, 0.5 mm from vertex 2: {nearer}; {through}"),
    );
    let bend = |step, snaps_past| Some(ClosingBend { vertex: VertexId(7), step, snaps_past });
    for (closing, what) in [
        (None, "they press on each other there, or snap past each other while they are bent"),
        (bend(None, false), "they press on each other from the bend at vertex 7 on"),
        (bend(Some(4), false), "they press on each other from the bend of step 5 at vertex 7 on"),
        (
            bend(Some(4), true),
            "in the bend of step 5 at vertex 7 one snaps past the other, and they press on each other from then on",
        ),
    ] {
        let fact = closed_by([Some(a), Some(b)], closing);
        let said =
            message(&Diagnostic { severity: Severity::Warning, ..finding(nowhere(), fact, Vec::new()) });
        assert_eq!(said, format!("vertices 1 and 2 meet but are not merged: {nearer}; {what}"));
    }
    says(nowhere(), Fact::IsolatedVertex { vertex: a }, "vertex 1 has no edge: no wire passes through it");
    let several = Fact::SeveralWires { wires: 3 };
    says(nowhere(), several, "the wireframe is not connected: it takes 3 wires");
    says(nowhere(), Fact::NoEdges, "the wireframe has no edges: there is nothing to bend");
}

#[test]
fn findings_of_the_route_say_why_there_is_none() {
    let odd = |allowed| Fact::NoEulerPath { odd: 8, allowed };
    let nowhere = Location::default;
    says(nowhere(), odd(4), "needs more than 2 wires (8 odd corners)");
    says(nowhere(), odd(2), "needs more than one wire (8 odd corners)");
    says(nowhere(), odd(0), "cannot be a closed wire (8 odd corners)");
    says(
        nowhere(),
        Fact::DoubledEdge { edge: EdgeId(7), passes: 2 },
        "edge 7 is made of 2 wires side by side",
    );
    let refused = |error, words| says(nowhere(), Fact::RouteRefused(error), words);
    refused(RouteError::NoEdges, "the wire has no edge to run along");
    let odd = vec![VertexId(1), VertexId(2), VertexId(3), VertexId(4)];
    refused(RouteError::Odd { odd, allowed: 2 }, "4 vertices are odd; 2 may be");
    refused(RouteError::Odd { odd: vec![VertexId(1)], allowed: 0 }, "1 vertex is odd; none may be");
    refused(
        RouteError::Start { start: VertexId(5), ends: vec![VertexId(1), VertexId(2)] },
        "the wire cannot start at vertex 5: it has to start at an odd corner (1, 2)",
    );
    refused(RouteError::StartElsewhere(VertexId(5)), "vertex 5 has no edge of this wire to start along");
    refused(RouteError::DoubledElsewhere(EdgeId(5)), "edge 5 is to be doubled but is not part of this wire");
    refused(
        RouteError::TooManyEnds { vertex: VertexId(5), ends: 600, max: 500 },
        "600 edge ends meet at vertex 5, doubled edges counted twice: a route can be found for up to 500",
    );
    refused(
        RouteError::TooLong,
        "the edges are more than a thousand million, or 288,000 km long or more together",
    );
}

#[test]
fn findings_of_straight_parts_tell_length_and_feed() {
    let short = || Fact::EdgeTooShort { length: mm(19.0), limit: stated(mm(20.4)) };
    says(at(&[7]), short(), "edge 7 is 19.0 mm long; the machine's minimum is 20.4 mm");
    says(at(&[7, 8]), short(), "edges 7, 8 are 19.0 mm long; the machine's minimum is 20.4 mm");
    let near = Fact::EdgeNearLimit { length: mm(21.0), limit: stated(mm(20.4)) };
    says(at(&[7]), near, "edge 7 is 21.0 mm long; the machine's minimum is 20.4 mm");
    let (designed, limit) = (mm(27.0), || stated(mm(25.0)));
    let short = |unpressed| Fact::FeedTooShort { designed, feed: mm(24.8), limit: limit(), unpressed };
    let said = "edge 7 (27.0 mm as designed) is fed 24.8 mm after compensation; the machine cannot feed less than 25.0 mm";
    says(at(&[7]), short(None), said);
    says(
        at(&[7]),
        short(Some(deg(-42.0))),
        &format!("{said}, and the peg cannot press the bend of -42.0° at its end"),
    );
    let feed = Fact::FeedNearLimit { designed, feed: mm(25.8), limit: limit() };
    says(
        at(&[7, 8]),
        feed,
        "the straight of edges 7, 8 (27.0 mm as designed) is fed 25.8 mm after compensation; the shortest feed is 25.0 mm",
    );
    let feed = Fact::FeedTooLong { designed, feed: mm(26.0), limit: limit() };
    says(
        at(&[]),
        feed,
        "step 3 (27.0 mm as designed) is fed 26.0 mm; the machine feeds at most 25.0 mm at once",
    );
    let feed = Fact::FeedLongerThanStock { designed, feed: mm(26.0), limit: limit() };
    says(
        at(&[7]),
        feed,
        "edge 7 (27.0 mm as designed) is fed 26.0 mm; the stock without its tail is only 25.0 mm",
    );
    let arcs = Fact::ArcsOverlap { designed: mm(5.0), needed: mm(6.0), bend_radius: mm(3.0) };
    says(at(&[7]), arcs, "the bends at both ends of edge 7 take 6.0 mm of its 5.0 mm");
}

#[test]
fn findings_of_bends_name_the_vertex_or_else_the_step() {
    let sharp = |of| Fact::BendTooSharp { bend: deg(-160.0), of, limit: stated(deg(-155.0)) };
    says(
        at(&[]),
        sharp(BendOf::Step),
        "the bend at vertex 4 is -160.0°, more than the machine can bend (-155.0°)",
    );
    let of_step = Location { step: Some(2), ..Location::default() };
    says(
        of_step,
        sharp(BendOf::Step),
        "the bend of step 3 is -160.0°, more than the machine can bend (-155.0°)",
    );
    let gentlest = Fact::BendTooSharp { bend: deg(170.0), of: BendOf::Vertex, limit: stated(deg(-155.0)) };
    says(
        at(&[]),
        gentlest,
        "whichever way the wire runs, the sharpest bend at vertex 4 is 170.0°, more than the machine can bend (155.0°)",
    );
    let near = Fact::BendNearLimit { bend: deg(150.0), limit: stated(deg(155.0)) };
    says(at(&[]), near, "the bend at vertex 4 is 150.0°, close to the most the machine can bend (155.0°)");
    let unreached = |of| Fact::BendOutOfReach { bend: deg(90.0), of, max: deg(85.0), reach: ReachLimit::Peg };
    says(
        at(&[]),
        unreached(BendOf::Step),
        "the bend at vertex 4 is 90.00°, out of reach: the largest possible bend to this side is 85.00°",
    );
    says(
        at(&[]),
        unreached(BendOf::Vertex),
        "whichever way the wire runs, the sharpest bend at vertex 4 is 90.00°, out of reach: the largest possible bend to either side is 85.00°",
    );
    says(
        at(&[]),
        Fact::BendTooSmall { bend: deg(0.7) },
        "the bend at vertex 4 is 0.70°, too small: the peg would stop on the far side of the wire's axis",
    );
    says(
        at(&[]),
        Fact::LeadTooShort { bend: deg(90.0), lead: mm(26.2), needed: mm(27.725) },
        "the bend at vertex 4 cannot be pressed: the wire before it ends 26.2 mm from where the bend begins, and the peg needs 27.7 mm",
    );
    says(
        at(&[]),
        Fact::CornerTooNear { bend: deg(-42.53) },
        "the bend at vertex 4 is -42.53° and cannot be pressed: the corner before it is within the peg's reach, which meets the wire too early, too late or not at all",
    );
    let near = |further, past_other| {
        Fact::CornerWithinReach(NearCorner { step: 2, further: Some(deg(further)), past_other })
    };
    says(
        at(&[]),
        near(9.84, false),
        "the bend at vertex 4: the peg touches wire that was bent before, so the axis goes 9.8° further than for a straight leg",
    );
    says(
        at(&[]),
        near(-7.6, true),
        "the bend at vertex 4: the peg touches wire that was bent before, so the axis goes 7.6° less far than for a straight leg. It touches beyond a corner of another plane or to the other side, which may bend as well",
    );
    says(
        at(&[]),
        near(0.04, false),
        "the bend at vertex 4: the peg touches wire that was bent before, and the axis goes as far as for a straight leg",
    );
    says(
        Location::default(),
        Fact::HeadNotMeasured(3),
        "the bend head of this machine was not measured: 3 bends where the peg touches wire that was bent before may come out some degrees off",
    );
    says(
        at(&[]),
        Fact::BendInScatter { bend: deg(0.5), scatter: stated(deg(1.4)) },
        "the bend at vertex 4 is 0.5°, less than the scatter of bends on this machine (1.4°): it may come out to either side",
    );
    says(
        at(&[]),
        Fact::CornerNotMade { vertex: VertexId(4), corner: deg(0.49), straight: deg(0.5) },
        "the corner at vertex 4 is 0.490°, below the resolution of the bend axis: the wire stays straight there, and the next bend starts from its real direction",
    );
    says(
        at(&[]),
        Fact::FoldBack { limit: stated(deg(155.0)) },
        "the wire folds straight back on itself at vertex 4",
    );
    says(
        at(&[]),
        Fact::FoldBackNotCompensated { bend: deg(179.95) },
        "the bend at vertex 4 is 179.95°: the wire folds back on itself, and the feeds on both sides cannot be compensated",
    );
}

#[test]
fn findings_of_the_machine_tell_what_it_can_do() {
    says(
        at(&[]),
        Fact::RotationOutOfRange {
            wanted: deg(95.0),
            commanded: false,
            range: [deg(-90.0), deg(90.0)],
            source: stated(()).source,
        },
        "the bend at vertex 4 needs the head at 95.00° (or half turns from there); the head turns from -90.0° to 90.0°",
    );
    says(
        at(&[]),
        Fact::RotationOutOfRange {
            wanted: deg(95.0),
            commanded: true,
            range: [deg(0.0), deg(90.0)],
            source: stated(()).source,
        },
        "for the bend at vertex 4 the head is sent to 95.00°; it turns from 0.0° to 90.0°",
    );
    says(
        Location::default(),
        Fact::StockTooLong { needed: mm(527.8), tail: mm(400.0), limit: stated(mm(520.0)) },
        "the wire takes 527.8 mm of stock, 400.0 mm of it unusable tail; the machine takes 520.0 mm",
    );
    for (diameter, compared) in [(0.9, "thinner"), (4.0, "thicker")] {
        says(
            Location::default(),
            Fact::WireDoesNotFit {
                diameter: mm(diameter),
                range: [mm(2.8), mm(3.2)],
                source: stated(()).source,
            },
            &format!("a wire of {diameter:.2} mm is {compared} than the machine takes (2.80 mm to 3.20 mm)"),
        );
    }
}

#[test]
fn an_axis_that_is_hardly_strong_enough_is_told_with_both_torques() {
    let available_n_m = Sourced { value: 2.0, source: stated(()).source };
    says(
        Location::default(),
        Fact::BendTorqueLow { needed_n_m: 1.63, available_n_m, margin: 1.5 },
        "the bend axis has 2.00 N·m, 1.23 times the 1.63 N·m that bend this wire: it may stall",
    );
}

/// What is in the way of a search is hit, or where the wire has to stay away, may only be near: which of them is not known.
#[test]
fn what_is_in_the_way_of_a_search_is_said_to_be_hit_only_where_it_is() {
    let unfound = |obstacle, clearance| Fact::NoClearProgram {
        checks: 90,
        exhausted: false,
        obstacle,
        body: matches!(obstacle, Some(Obstacle::Body(_))).then(|| "nozzle".to_owned()),
        passed: Some((3, 12)),
        clearance,
        helps: Helps::default(),
    };
    let nozzle = Some(Obstacle::Body(1));
    let tried = "no program without a collision was found: 90 steps were checked; the search got as far as edge 3 of 12: at vertex 4";
    for (fact, what) in [
        (unfound(nozzle, Length::ZERO), "the wire would hit the nozzle"),
        (unfound(nozzle, mm(12.0)), "the wire would come within 12.0 mm of the nozzle"),
        (unfound(nozzle, mm(0.04)), "the wire would come within 0.04 mm of the nozzle"),
        (
            unfound(Some(Obstacle::Stock), Length::ZERO),
            "the wire would hit the wire that is still to be bent",
        ),
        (unfound(None, mm(12.0)), "the head cannot turn far enough"),
    ] {
        says(at(&[]), fact, &format!("{tried} {what}"));
    }
}

/// What only just touches is not said to go nowhere.
#[test]
fn how_deep_or_near_the_wire_is_never_reads_as_nothing() {
    for (depth, later, does, then) in [
        (2.13, 0, "hits", "and goes 2.1 mm into it"),
        (0.07, 0, "hits", "and goes 0.1 mm into it"),
        (0.0, 0, "hits", "and goes less than 0.1 mm into it"),
        (-0.01, 0, "comes near", "and comes within 0.1 mm of it"),
        (-0.42, 0, "comes near", "and comes within 0.4 mm of it"),
        (2.13, 3, "hits", "goes 2.1 mm into it, and hits it again in 3 later steps"),
        (-0.42, 1, "comes near", "comes within 0.4 mm of it, and comes near it again in 1 later step"),
    ] {
        let meeting = Meeting {
            struck: Vec::new(),
            phase: Phase::Bend,
            fed: mm(30.0),
            bent: deg(20.0),
            head: Angle::ZERO,
            depth: mm(depth),
            later,
        };
        let words = format!(
            "the wire {does} the wire that is still to be bent when step 3 has bent it to 20.0°, {then}"
        );
        says(at(&[]), Fact::MeetsStock(meeting), &words);
    }
}

/// Read with too few digits, a value beyond a limit is the limit, and the person looks for the fault elsewhere.
#[test]
fn what_is_beyond_a_limit_never_reads_like_it() {
    let sharp = |bend| {
        let fact = Fact::BendTooSharp { bend: deg(bend), of: BendOf::Step, limit: stated(deg(155.0)) };
        message(&finding(at(&[]), fact, Vec::new()))
    };
    assert!(sharp(155.0001).contains("is 155.0001°") && sharp(155.0001).contains("(155.0000°)"));
    // At the limit but for rounding the two read alike, as they should.
    let near = Fact::BendNearLimit { bend: deg(155.0 - 1e-12), limit: stated(deg(155.0)) };
    let near = message(&finding(at(&[]), near, Vec::new()));
    assert!(near.contains("is 155.0°,") && near.contains("(155.0°)"), "{near}");
    let short = Fact::EdgeTooShort { length: mm(20.399_96), limit: stated(mm(20.4)) };
    let short = message(&finding(at(&[7]), short, Vec::new()));
    assert!(short.contains("20.39996 mm") && short.contains("20.40000 mm"), "{short}");
    let feed =
        Fact::FeedTooShort { designed: mm(27.2), feed: mm(24.98), limit: stated(mm(25.0)), unpressed: None };
    let feed = message(&finding(at(&[7]), feed, Vec::new()));
    assert!(feed.contains("24.98 mm") && feed.contains("25.00 mm"), "{feed}");
    let (bend, max) = (deg(85.0004), deg(85.0));
    let far = Fact::BendOutOfReach { bend, of: BendOf::Step, max, reach: ReachLimit::Peg };
    let far = message(&finding(at(&[]), far, Vec::new()));
    assert!(far.contains("85.0004°") && far.contains("85.0000°"), "{far}");
}

mod limits_and_help;
