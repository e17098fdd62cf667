mod rotation;
mod strength;

use super::*;
use crate::plan::{DoublingChoice, Machine, PlanOptions, plan_wires};
use crate::testing::{chain, deg, from, mm, published_machine, wireframe};

fn design(w: &Wireframe) -> Vec<Diagnostic> {
    let components = w.components();
    check_design(&Design {
        wireframe: w,
        components: &components,
        weld_tolerance: mm(1e-3),
        diameter: mm(3.0),
    })
}

pub(super) fn on(machine: &Machine, w: &Wireframe, options: &PlanOptions) -> Vec<Diagnostic> {
    plan_wires(w, &w.components()[0], machine, options, |_| ()).remove(0).diagnostics
}

fn checked(w: &Wireframe) -> Vec<Diagnostic> {
    on(&published_machine(), w, &PlanOptions::default())
}

/// The only diagnostic with this code.
pub(super) fn only(found: &[Diagnostic], code: Code) -> &Diagnostic {
    let mut with_code = found.iter().filter(|diagnostic| diagnostic.code() == code);
    let (first, second) = (with_code.next(), with_code.next());
    assert!(second.is_none(), "{code} is said twice: {found:#?}");
    first.unwrap_or_else(|| panic!("{code} is not said: {found:#?}"))
}

fn measured_mm(diagnostic: &Diagnostic) -> f64 {
    match diagnostic.measured() {
        Some(Quantity::Length(length)) => length.mm(),
        other => panic!("{other:?} is no length"),
    }
}

pub(super) fn measured_deg(diagnostic: &Diagnostic) -> f64 {
    degrees(diagnostic.measured())
}

fn limit_deg(diagnostic: &Diagnostic) -> f64 {
    degrees(diagnostic.limit().map(|limit| limit.value))
}

fn degrees(quantity: Option<Quantity>) -> f64 {
    match quantity {
        Some(Quantity::Angle(angle)) => angle.deg(),
        other => panic!("{other:?} is no angle"),
    }
}

#[test]
fn a_sound_design_gives_nothing_to_say() {
    let u = chain(&[[0., 0., 0.], [35., 0., 0.], [35., 35., 0.], [0., 35., 0.]]);
    assert_eq!(design(&u), []);
    assert_eq!(checked(&u), []);
}

#[test]
fn flaws_of_the_drawing_are_named() {
    let w = wireframe(
        &[
            [0., 0., 0.],
            [30., 0., 0.],
            [30., 30., 0.],
            [30., 30., 0.],
            [90., 0., 0.],
            [120., 0., 0.],
            [5., 5., 5.],
        ],
        &[(0, 1), (1, 2), (2, 3), (1, 0), (4, 5)],
    );
    let found = design(&w);
    let zero = only(&found, Code::ZeroLengthEdge);
    assert_eq!((zero.location.edges[0], zero.is_error()), (EdgeId(2), true));
    assert_eq!(only(&found, Code::ParallelEdges).location.edges, [EdgeId(3), EdgeId(0)]);
    assert_eq!(only(&found, Code::CoincidentVertices).location.vertices, [VertexId(3), VertexId(2)]);
    assert_eq!(only(&found, Code::IsolatedVertex).location.vertices, [VertexId(6)]);
    assert_eq!(only(&found, Code::SeveralWires).measured(), Some(Quantity::Count(2)));
    assert_eq!(only(&design(&Wireframe::new()), Code::NoEdges).severity, Severity::Error);
    // The wire itself cannot be planned through an edge without length, and says which.
    let plan = checked(&w);
    assert!(plan.iter().any(|d| d.code() == Code::ZeroLengthEdge && d.location.edges == [EdgeId(2)]));
}

#[test]
fn odd_vertices_come_with_the_cheapest_way_out() {
    let star = wireframe(&[[0.; 3], [40., 0., 0.], [0., 50., 0.], [0., 0., 60.]], &[(0, 1), (0, 2), (0, 3)]);
    let found = checked(&star);
    let odd = only(&found, Code::NoEulerPath);
    assert_eq!(odd.location.vertices.len(), 4);
    assert_eq!(odd.limit().unwrap().value, Quantity::Count(2));
    let cheapest = Remedy::DoubleEdges { edges: vec![EdgeId(0)], added: mm(40.0), design: mm(150.0) };
    // The wire would come back from a dead end.
    assert_eq!(odd.remedies, [Remedy::AllowWires, cheapest]);
    // Accepted, the shortest strut is travelled twice: a fold back at its end that cannot be made.
    let accepted = PlanOptions { doubling: DoublingChoice::Cheapest, ..PlanOptions::default() };
    let found = on(&published_machine(), &star, &accepted);
    assert_eq!(only(&found, Code::FoldBack).location.vertices, [VertexId(1)]);
    assert!(only(&found, Code::FoldBack).is_error());
    assert_eq!(only(&found, Code::DoubledEdge).location.edges, [EdgeId(0)]);
}

/// Room has to be left for all wires along an edge, however they share its passes.
#[test]
fn an_edge_that_several_wires_pass_is_said_once_with_all_passes() {
    // Two edges at each end of a bar that three wires pass.
    let points =
        [[0.; 3], [60., 0., 0.], [-50., 50., 0.], [-50., -50., 0.], [110., 50., 0.], [110., -50., 0.]];
    let w = wireframe(&points, &[(0, 1), (0, 2), (0, 3), (1, 4), (1, 5)]);
    let doubling = DoublingChoice::Accepted(vec![EdgeId(0), EdgeId(0)]);
    let options = PlanOptions { wires: 3, doubling, ..PlanOptions::default() };
    let plans = plan_wires(&w, &w.components()[0], &published_machine(), &options, |_| ());
    // Three wires need no edge twice.
    assert_eq!(plans.iter().map(|plan| plan.is_cheapest).collect::<Vec<_>>(), [false; 3]);
    let found: Vec<Diagnostic> = plans.into_iter().flat_map(|plan| plan.diagnostics).collect();
    assert_eq!(only(&found, Code::DoubledEdge).fact, Fact::DoubledEdge { edge: EdgeId(0), passes: 3 });
}

#[test]
fn short_edges_are_judged_as_designed_and_as_fed() {
    // Between two right angles the middle edge gives up 2.230 mm: 27 mm are fed as 24.77.
    let found = checked(&chain(&[[0., 0., 0.], [40., 0., 0.], [40., 27., 0.], [0., 27., 0.]]));
    let short = only(&found, Code::FeedTooShort);
    assert_eq!((short.location.step, &short.location.edges[..]), (Some(1), &[EdgeId(1)][..]));
    assert!((measured_mm(short) - 24.770).abs() < 1e-3);
    assert!(found.iter().all(|d| d.code() != Code::EdgeTooShort));
    let found = checked(&chain(&[[0., 0., 0.], [40., 0., 0.], [40., 15., 0.], [0., 15., 0.]]));
    assert!((measured_mm(only(&found, Code::EdgeTooShort)) - 15.0).abs() < 1e-9);
    let found = checked(&chain(&[[0., 0., 0.], [40., 0., 0.], [40., 5., 0.], [0., 5., 0.]]));
    assert!((measured_mm(only(&found, Code::ArcsOverlap)) - 5.0).abs() < 1e-9);
    // On a straight line short edges are one feed.
    let found = checked(&chain(&[[0., 0., 0.], [10., 0., 0.], [20., 0., 0.], [40., 0., 0.], [40., 40., 0.]]));
    assert_eq!(found, []);
    // Without a route each edge is judged on its own.
    let star = wireframe(&[[0.; 3], [19., 0., 0.], [0., 50., 0.], [0., 0., 60.]], &[(0, 1), (0, 2), (0, 3)]);
    assert_eq!(only(&checked(&star), Code::EdgeTooShort).location.edges, [EdgeId(0)]);
}

#[test]
fn values_close_to_a_limit_are_warned_of() {
    let found = checked(&chain(&[[0., 0., 0.], [40., 0., 0.], [40., 28.3, 0.], [0., 28.3, 0.]]));
    assert_eq!(only(&found, Code::FeedNearLimit).severity, Severity::Warning);
    let turn = f64::to_radians(180.0 - 150.0);
    let sharp = chain(&[[0., 0., 0.], [80., 0., 0.], [80. - 80. * turn.cos(), 80. * turn.sin(), 0.]]);
    assert_eq!(only(&checked(&sharp), Code::BendNearLimit).location.vertices, [VertexId(1)]);
}

#[test]
fn bends_that_cannot_be_made_name_the_vertex_and_the_limit() {
    let turn = f64::to_radians(180.0 - 160.0);
    let sharp = chain(&[[0., 0., 0.], [80., 0., 0.], [80. - 80. * turn.cos(), 80. * turn.sin(), 0.]]);
    let found = checked(&sharp);
    let bend = only(&found, Code::BendTooSharp);
    assert_eq!((bend.location.step, &bend.location.vertices[..]), (Some(0), &[VertexId(1)][..]));
    assert!((measured_deg(bend) - 160.0).abs() < 1e-9 && (limit_deg(bend) - 155.0).abs() < 1e-9, "{bend:?}");
    assert_eq!(bend.limit().unwrap().source, LimitSource::Stated(&from("the paper")));
    // Within the limits, but the axis stops before springback is made up for.
    let mut short_axis = published_machine();
    short_axis.compensation.bend.axis_limit = Some(deg(100.0));
    let corner = chain(&[[0., 0., 0.], [80., 0., 0.], [80., 80., 0.]]);
    let found = on(&short_axis, &corner, &PlanOptions::default());
    assert_eq!(only(&found, Code::BendOutOfReach).location.vertices, [VertexId(1)]);
    // Without springback a slight bend stops the peg on the far side.
    let mut stiff = published_machine();
    stiff.compensation.bend.springback = None;
    let slight = chain(&[[0., 0., 0.], [80., 0., 0.], [160., 2., 0.]]);
    assert_eq!(
        only(&on(&stiff, &slight, &PlanOptions::default()), Code::BendTooSmall).location.step,
        Some(0)
    );
    // Not quite straight back, but its corner is far outside of the edges.
    let mut any_bend = published_machine();
    any_bend.limits.max_bend.value = deg(180.0);
    any_bend.limits.min_bend.value = deg(-180.0);
    any_bend.compensation.bend = crate::compensate::BendModel::default();
    let folded = chain(&[[0., 0., 0.], [80., 0., 0.], [0., 0.1, 0.]]);
    assert!(only(&on(&any_bend, &folded, &PlanOptions::default()), Code::FoldBack).is_error());
}

#[test]
fn stock_includes_the_tail_that_cannot_be_fed() {
    let mut short = published_machine();
    short.limits.max_stock = Some(Sourced { value: mm(520.0), source: from("the shelf") });
    let fits = chain(&[[0., 0., 0.], [60., 0., 0.], [60., 60., 0.]]);
    assert_eq!(on(&short, &fits, &PlanOptions::default()), []);
    let long = chain(&[[0., 0., 0.], [60., 0., 0.], [60., 70., 0.]]);
    let found = on(&short, &long, &PlanOptions::default());
    // 130 mm less what one right angle saves: 6 - 2.4·π/2.
    assert!((measured_mm(only(&found, Code::StockTooLong)) - 527.770).abs() < 1e-3);
    let single = chain(&[[0., 0., 0.], [130., 0., 0.], [130., 30., 0.]]);
    assert_eq!(only(&on(&short, &single, &PlanOptions::default()), Code::FeedTooLong).location.step, Some(0));
}

#[test]
fn wire_that_does_not_fit_the_machine_is_refused() {
    let u = chain(&[[0., 0., 0.], [35., 0., 0.], [35., 35., 0.]]);
    for diameter in [0.9, 4.0] {
        let mut machine = published_machine();
        machine.wire.diameter = mm(diameter);
        let found = on(&machine, &u, &PlanOptions::default());
        assert!((measured_mm(only(&found, Code::WireDoesNotFit)) - diameter).abs() < 1e-12);
    }
}

/// The paper states 1.630 N·m for its wire, 23 times less than its axis has, and finds that 6.8 mm leave twice.
#[test]
fn an_axis_that_is_hardly_strong_enough_is_told() {
    let u = chain(&[[0., 0., 0.], [35., 0., 0.], [35., 35., 0.]]);
    let mut machine = published_machine();
    let torque = machine.limits.bend_torque.clone().unwrap();
    assert!((torque.needed_n_m - 1.630).abs() < 5e-4, "{}", torque.needed_n_m);
    let times = |diameter| {
        let torque = BendTorque::beside(torque.available_n_m.clone(), mm(diameter), 362.14);
        torque.available_n_m.value / torque.needed_n_m
    };
    assert!(
        (times(3.0) - 23.0).abs() < 0.5 && (times(6.8) - 2.0).abs() < 0.05,
        "{} {}",
        times(3.0),
        times(6.8)
    );
    for (available, warned) in [(2.46, false), (2.43, true), (1.0, true)] {
        let available_n_m = Sourced { value: available, source: torque.available_n_m.source.clone() };
        machine.limits.bend_torque = Some(BendTorque { available_n_m, ..torque });
        let found = on(&machine, &u, &PlanOptions::default());
        let low: Vec<_> = found.iter().filter(|one| one.code() == Code::BendTorqueLow).collect();
        assert_eq!(low.len(), usize::from(warned), "{available} N·m");
        assert!(low.iter().all(|one| one.severity == Severity::Warning));
    }
}

#[test]
fn a_start_that_does_not_fit_is_refused() {
    let u = chain(&[[0., 0., 0.], [35., 0., 0.], [35., 35., 0.]]);
    let from_the_middle = PlanOptions { start: Some(VertexId(1)), ..PlanOptions::default() };
    let found = on(&published_machine(), &u, &from_the_middle);
    assert_eq!(only(&found, Code::RouteRefused).location.vertices, [VertexId(1)]);
}

#[test]
fn every_finding_has_a_remedy() {
    let w = wireframe(
        &[[0.; 3], [19., 0., 0.], [0., 50., 0.], [0., 0., 60.], [7., 7., 7.]],
        &[(0, 1), (0, 2), (0, 3)],
    );
    for diagnostic in design(&w).into_iter().chain(checked(&w)) {
        assert!(!diagnostic.remedies.is_empty(), "{diagnostic:?}");
    }
    let mut names: Vec<_> = Code::ALL.iter().map(|code| code.as_str()).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), Code::ALL.len());
}

/// A machine that compensates on its own: the axis is the bend.
fn direct_machine() -> Machine {
    let mut machine = published_machine();
    machine.compensation = crate::compensate::Compensation::default();
    machine.limits.min_bend.value = deg(-180.0);
    machine.limits.max_bend.value = deg(180.0);
    machine
}

#[test]
fn arcs_overlap_also_on_a_machine_that_compensates_on_its_own() {
    // Two bends of 170° take 3 mm · tan(85°) = 34.3 mm each of an edge of 60 mm.
    let turn = f64::to_radians(10.0);
    let zigzag = chain(&[
        [0., 0., 0.],
        [60., 0., 0.],
        [60. - 60. * turn.cos(), 60. * turn.sin(), 0.],
        [120. - 60. * turn.cos(), 60. * turn.sin(), 0.],
    ]);
    let found = on(&direct_machine(), &zigzag, &PlanOptions::default());
    assert_eq!(only(&found, Code::ArcsOverlap).location.edges, [EdgeId(1)]);
}

#[test]
fn a_corner_that_the_axis_cannot_resolve_is_said() {
    let mut coarse = direct_machine();
    coarse.straight = deg(0.5);
    let rise = 1000.0 * f64::to_radians(0.49).sin();
    let gentle = chain(&[[0., 0., 0.], [100., 0., 0.], [1100., rise, 0.], [1100., rise + 50., 0.]]);
    let found = on(&coarse, &gentle, &PlanOptions::default());
    let corner = only(&found, Code::CornerNotMade);
    assert_eq!((corner.location.vertices[0], corner.severity), (VertexId(1), Severity::Warning));
}

#[test]
fn a_fold_back_is_judged_by_the_side_that_makes_it() {
    let tee = wireframe(&[[0.; 3], [60., 0., 0.], [0., 80., 0.], [0., 0., 100.]], &[(0, 1), (0, 2), (0, 3)]);
    let doubled = PlanOptions { doubling: DoublingChoice::Cheapest, ..PlanOptions::default() };
    let mut one_sided = direct_machine();
    one_sided.limits.max_bend.value = deg(95.0);
    let found = on(&one_sided, &tee, &doubled);
    assert_eq!(only(&found, Code::FoldBack).severity, Severity::Warning, "the negative side makes it");
    let mut short_axis = direct_machine();
    short_axis.compensation.bend.axis_limit = Some(deg(130.0));
    let plan = plan_wires(&tee, &tee.components()[0], &short_axis, &doubled, |_| ()).remove(0);
    assert!(!plan.is_feasible());
    assert!(only(&plan.diagnostics, Code::FoldBack).is_error(), "nothing else says why");
}

/// A corner of so many degrees with legs of 80 mm, at the vertex 1.
fn corner(bend_deg: f64) -> [[f64; 3]; 3] {
    let turn = f64::to_radians(bend_deg);
    [[0., 0., 0.], [80., 0., 0.], [80. + 80. * turn.cos(), 80. * turn.sin(), 0.]]
}

/// Arithmetic on coordinates must not turn a bend at the limit into one beyond it, nor hide one that is beyond.
#[test]
fn what_is_beyond_a_limit_is_told_from_what_is_at_it() {
    let found = checked(&chain(&corner(155.0001)));
    let sharp = only(&found, Code::BendTooSharp);
    assert!((measured_deg(sharp) - 155.0001).abs() < 1e-9 && (limit_deg(sharp) - 155.0).abs() < 1e-9);
    // At the limit it can be made, also after the arithmetic of a corner from its coordinates.
    for bend in [155.0, -155.0] {
        let found = checked(&chain(&corner(bend)));
        assert!(found.iter().all(|d| !d.is_error()), "{found:#?}");
        assert!((measured_deg(only(&found, Code::BendNearLimit)).abs() - 155.0).abs() < 1e-9);
    }
    let short =
        |length: f64| checked(&chain(&[[0., 0., 0.], [40., 0., 0.], [40., length, 0.], [0., length, 0.]]));
    let found = short(20.399_96);
    let edge = only(&found, Code::EdgeTooShort);
    assert!((measured_mm(edge) - 20.399_96).abs() < 1e-9);
    let by = mm(20.4) - mm(measured_mm(edge));
    assert_eq!(edge.remedies, [Remedy::LengthenEdge { by: Some(by) }, Remedy::ScaleUp]);
    let mut short_axis = published_machine();
    short_axis.compensation.bend.axis_limit = Some(deg(100.0));
    let max = short_axis.compensation.bend.max_bend(deg(1.0));
    let found = on(&short_axis, &chain(&corner(max.deg() + 0.0004)), &PlanOptions::default());
    let unreached = only(&found, Code::BendOutOfReach);
    assert!((measured_deg(unreached) - limit_deg(unreached) - 0.0004).abs() < 1e-6, "{unreached:?}");
    assert_eq!(unreached.remedies, [Remedy::KeepBendBelow { max }]);
}

/// Half a degree drawn, and the wire comes out bent by a degree to the other side.
#[test]
fn a_bend_that_is_lost_in_the_scatter_is_warned_of() {
    let mut machine = published_machine();
    machine.scatter = Some(Sourced { value: deg(1.4), source: from("the paper") });
    let said = |bend| on(&machine, &chain(&corner(bend)), &PlanOptions::default());
    let found = said(0.5);
    let slight = only(&found, Code::BendInScatter);
    assert_eq!((slight.severity, slight.location.vertices[0]), (Severity::Warning, VertexId(1)));
    assert!(
        (measured_deg(slight) - 0.5).abs() < 1e-9 && (limit_deg(slight) - 1.4).abs() < 1e-9,
        "{slight:?}"
    );
    assert!(said(1.5).iter().all(|d| d.code() != Code::BendInScatter));
    assert!(
        checked(&chain(&corner(0.5))).iter().all(|d| d.code() != Code::BendInScatter),
        "nobody knows the scatter"
    );
}

/// The machine's controller refuses it with the wire half bent.
#[test]
fn a_single_feed_may_be_too_long() {
    let mut machine = published_machine();
    machine.limits.max_feed = Some(Sourced { value: mm(100.0), source: from("driver setting feed_most_mm") });
    let found =
        on(&machine, &chain(&[[0., 0., 0.], [120., 0., 0.], [120., 60., 0.]]), &PlanOptions::default());
    let long = only(&found, Code::FeedTooLong);
    assert_eq!((long.location.step, long.is_error()), (Some(0), true));
    assert_eq!(long.limit().unwrap().source, LimitSource::Stated(&from("driver setting feed_most_mm")));
}

/// By arithmetic a straight of 100 mm at 0.01 rad to an axis is 100.00000000000001 mm long.
#[test]
fn what_arithmetic_adds_is_beyond_no_limit() {
    let mut machine = published_machine();
    let straight = chain(&[[0., 0., 0.], [100.0 * 0.01_f64.cos(), 100.0 * 0.01_f64.sin(), 0.]]);
    let limit = |value: f64| Sourced { value: mm(value), source: from("test") };
    assert!(straight.total_length() > mm(100.0));
    let tail = machine.limits.tail.value.mm();
    machine.limits.max_feed = Some(limit(100.0));
    machine.limits.max_stock = Some(limit(100.0 + tail));
    let errors = |machine: &Machine| {
        let found = on(machine, &straight, &PlanOptions::default());
        found.iter().filter(|found| found.is_error()).map(Diagnostic::code).collect::<Vec<_>>()
    };
    assert_eq!(errors(&machine), []);
    machine.limits.max_feed = Some(limit(99.99));
    assert_eq!(errors(&machine), [Code::FeedTooLong]);
    machine.limits.max_feed = None;
    machine.limits.max_stock = Some(limit(99.99 + tail));
    assert!(errors(&machine).contains(&Code::StockTooLong));
}
