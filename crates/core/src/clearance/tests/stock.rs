use super::*;
use crate::bend::program_of_path;

/// The contacts with the stock of a wire along points.
fn with_stock(path: &[[f64; 3]], vertices: &[u32]) -> Vec<Deep> {
    let bend = BendModel { springback: None, setback: None, axis_limit: None, before_zero: false };
    with_stock_bent(path, vertices, &bend)
}

fn with_stock_bent(path: &[[f64; 3]], vertices: &[u32], bend: &BendModel) -> Vec<Deep> {
    of_path(path, vertices, bend, wire(), all_of)
}

/// What is asked of a wire along points.
fn of_path<T>(
    path: &[[f64; 3]],
    vertices: &[u32],
    bend: &BendModel,
    wire: StockWire,
    ask: impl FnOnce(Clearance) -> T,
) -> T {
    let path: Vec<Point3<f64>> = path.iter().copied().map(Point3::from).collect();
    let (start, program) = program_of_path(&path, deg(1e-9)).unwrap();
    let bodies = Bodies::default();
    let ends = |k: usize| [vertices[k], vertices[k + 1]];
    let same = |j: usize, k: usize| ends(j) == ends(k) || ends(j) == [ends(k)[1], ends(k)[0]];
    let passage = |k: usize| {
        let edge = (0..k).find(|&j| same(j, k)).unwrap_or(k);
        let [from, to] = ends(k).map(VertexId);
        let edge = EdgeId(u32::try_from(edge).unwrap());
        (Passage { edge, from, to }, Length::computed((path[k + 1] - path[k]).norm()))
    };
    let passages = program.spans.iter().map(|span| span.clone().map(passage).collect());
    ask(Clearance::new((start, &program.steps), None, passages.collect(), wire, &bodies, bend))
}

#[test]
fn a_wire_that_is_drawn_through_itself_meets_the_stock_before_it_is_fed_there() {
    // The fourth straight crosses the middle of the first one.
    let path = [[0., 0., 0.], [100., 0., 0.], [100., 60., 0.], [50., 60., 0.], [50., -40., 0.]];
    let found = with_stock(&path, &[0, 1, 2, 3, 4]);
    let [contact] = &found[..] else { panic!("{found:?}") };
    assert_eq!((contact.step, contact.leg, contact.phase), (2, 0, Phase::Bend));
    assert_eq!(contact.obstacle, Obstacle::Stock);
    // Centreline on centreline: as deep as the wire is thick.
    assert!((contact.depth.mm() - 3.0).abs() < 0.2, "{contact:?}");
}

/// A strut lies along the stock when the wire begins to bend: the contact is there, and not at the end of the bend.
#[test]
fn what_is_met_when_a_bend_begins_is_met_at_its_begin() {
    let path = [[0., 0., 0.], [100., 0., 0.], [60., 1., 0.], [60., 50., 0.]];
    let found = with_stock(&path, &[0, 1, 2, 3]);
    let contact =
        found.iter().find(|contact| (contact.step, contact.phase) == (1, Phase::Bend)).expect("a contact");
    assert_eq!((contact.bent, contact.leg), (Angle::ZERO, 0));
    assert!(contact.passed < 0.5, "{contact:?}");
}

#[test]
fn a_wire_that_passes_over_itself_by_more_than_its_diameter_meets_nothing() {
    let path =
        |over: f64| [[0., 0., 0.], [100., 0., 0.], [100., 60., over], [50., 60., over], [50., -40., over]];
    assert!(with_stock(&path(3.1), &[0, 1, 2, 3, 4]).is_empty());
    assert_eq!(with_stock(&path(2.5), &[0, 1, 2, 3, 4]).len(), 1);
}

/// A bow-tie that is crossed where nothing sweeps past, and a strut that is travelled twice.
#[test]
fn struts_that_share_a_vertex_and_doubled_ones_do_not_meet() {
    let bow =
        [[0., 0., 0.], [50., 50., 0.], [100., 0., 0.], [100., 100., 0.], [50., 50., 0.], [0., 100., 0.]];
    assert!(with_stock(&bow, &[0, 1, 2, 3, 1, 4]).is_empty());
    let twice = [[0., 0., 0.], [80., 0., 0.], [80., 80., 0.], [0., 0., 0.], [80., 0., 0.], [80., 0., 60.]];
    assert!(with_stock(&twice, &[0, 1, 2, 0, 1, 3]).is_empty());
}

/// Bent at (0, -60), the stock comes from the right to the vertex at the origin, and goes through the strut that ends there.
#[test]
fn a_strut_sweeps_through_the_stock_that_comes_to_its_vertex() {
    let path = [[60., -20., 0.], [0., 0., 0.], [-60., -60., 0.], [0., -60., 0.], [0., 0., 0.]];
    let found = with_stock(&path, &[0, 1, 2, 3, 1]);
    let [contact] = &found[..] else { panic!("{found:?}") };
    assert_eq!((contact.step, contact.leg, contact.phase), (2, 0, Phase::Bend));
    assert!((contact.depth.mm() - 3.0).abs() < 0.2, "{contact:?}");
    // Its end at (60, -20) is the first to meet it: 33.7 degrees up, less what half of both wires take at 72.1 mm, and a little more for
    // the pin around which it winds.
    let expected = (40.0_f64 / 60.0).atan().to_degrees() - (3.0_f64 / 72.1).to_degrees();
    assert!((contact.bent.deg() - expected).abs() < 0.5, "{contact:?}");
}

/// The same at the vertex where it bends: the stock goes from above the strut to below it.
#[test]
fn a_strut_sweeps_through_the_stock_at_its_own_vertex() {
    let to = |end: [f64; 3]| {
        let path = [[60., 40., 0.], [0., 0., 0.], [0., -60., 0.], [-60., -60., 0.], [0., 0., 0.], end];
        with_stock(&path, &[0, 1, 3, 2, 1, 4])
    };
    let found = to([60., -20., 0.]);
    let [contact] = &found[..] else { panic!("{found:?}") };
    assert_eq!((contact.step, contact.leg, contact.phase), (3, 0, Phase::Bend));
    assert!((contact.depth.mm() - 3.0).abs() < 0.2, "{contact:?}");
    // To the other side it goes away from the strut, which is 11 degrees beside it when the bend begins.
    assert!(to([-20., 60., 0.]).is_empty());
}

/// The machine bends farther than stays in the wire: the stock goes past the vertex by that, and through the strut that ends there.
#[test]
fn a_wire_that_is_overbent_presses_on_the_vertex_that_it_closes() {
    let machine = published_machine();
    let bend = &machine.compensation.bend;
    assert!(bend.springback.as_ref().is_some_and(|model| model.bend_to(deg(90.0)) > deg(92.0)));
    let path = [[-60., -20., 0.], [0., 0., 0.], [-60., -60., 0.], [0., -60., 0.], [0., 0., 0.]];
    assert!(with_stock_bent(&path, &[0, 1, 2, 3, 1], bend).is_empty());
    // 4 mm short of the vertex it is not its strut.
    let short = [[-60., -20., 0.], [-4., 0., 0.], [-60., -60., 0.], [0., -60., 0.], [0., 0., 0.]];
    assert!(!with_stock_bent(&short, &[0, 1, 2, 3, 4], bend).is_empty());
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, ..ProptestConfig::default() })]

    /// Wherever it is drawn, a wire that comes back to a vertex is in the way of no strut that leaves it on the far side.
    #[test]
    fn a_strut_beyond_the_stock_is_never_met(
        away in 10.0..170.0_f64,
        tilt in -60.0..60.0_f64,
        length in 30.0..120.0_f64,
    ) {
        let (away, tilt) = (away.to_radians(), tilt.to_radians());
        let end = [-length * away.sin() * tilt.cos(), -length * away.cos(), length * away.sin() * tilt.sin()];
        // The corner at the vertex goes on to the far side, too.
        let path = [end, [0., 0., 0.], [-60., -60., 0.], [0., -60., 0.], [0., 0., 0.]];
        let turns = (Point3::from(path[0]).coords.normalize() - Point3::from(path[2]).coords.normalize()).norm();
        prop_assume!(turns > 0.3);
        let found = with_stock(&path, &[0, 1, 2, 3, 1]);
        prop_assert!(found.iter().all(|contact| contact.step != 2), "{found:?}");
    }

    /// With a clearance more may come near at a vertex: what is hit there all the same is hit as deep as without.
    #[test]
    fn what_is_hit_at_a_vertex_is_hit_with_a_clearance_too(
        ends in prop::array::uniform3(-60.0..60.0_f64),
        margin in 0.5..12.0_f64,
    ) {
        let path = [ends, [0., 0., 0.], [-60., -60., 0.], [0., -60., 0.], [0., 0., 0.]];
        prop_assume!(ends.iter().map(|at| at * at).sum::<f64>() > 400.0);
        let bend = BendModel { springback: None, setback: None, axis_limit: None, before_zero: false };
        let hits = |margin: f64| -> Vec<FirstContact> {
            let wire = StockWire { margin: mm(margin), ..wire() };
            of_path(&path, &[0, 1, 2, 3, 1], &bend, wire, |clearance| {
                clearance.first_contacts().into_iter().filter(FirstContact::hits).collect()
            })
        };
        prop_assert_eq!(hits(0.0), hits(margin));
    }
}
