use wirebend_planning::playback::PoseReport;

use super::*;

type Vector = [f64; 3];

fn feed(mm: f64) -> Move {
    Move::Feed { mm }
}

fn rotate(deg: f64) -> Move {
    Move::Rotate { deg }
}

fn bend(deg: f64) -> Move {
    Move::Bend { deg }
}

const fn axes(feed_mm: f64, rotate_deg: f64, bend_deg: f64) -> JobStep {
    JobStep { feed_mm, rotate_deg, bend_deg, approach_deg: None }
}

/// Right-handed about an axis of length 1.
fn turned([x, y, z]: Vector, [a, b, c]: Vector, deg: f64) -> Vector {
    let (sin, cos) = deg.to_radians().sin_cos();
    let along = (a * x + b * y + c * z) * (1.0 - cos);
    [
        x * cos + (b * z - c * y) * sin + a * along,
        y * cos + (c * x - a * z) * sin + b * along,
        z * cos + (a * y - b * x) * sin + c * along,
    ]
}

/// Where the corners of a wire lie on its machine, the end that was bent first in front.
fn places(wire: &PlayedWire) -> Vec<Vector> {
    let end = *wire.corners_mm.last().unwrap();
    let PoseReport { turn: [x, y, z, w], bend_axis, bend_deg } = wire.steps.last().unwrap().pose;
    let moment = wire.steps.last().unwrap().moments.last().unwrap();
    let size = x.hypot(y).hypot(z);
    let (axis, deg) = if size > 0.0 {
        ([x / size, y / size, z / size], 2.0 * size.atan2(w).to_degrees())
    } else {
        ([1., 0., 0.], 0.0)
    };
    let place = |corner: &Vector| {
        let from_end = [corner[0] - end[0], corner[1] - end[1], corner[2] - end[2]];
        turned(turned(from_end, axis, deg), bend_axis, bend_deg * moment.bent)
    };
    wire.corners_mm.iter().map(place).collect()
}

/// A machine that knows only its moves: the wire that is out is pushed along +x, the head turns by -rotate about +x, and what
/// is out turns about the head's z.
fn bender(moves: &[Move]) -> Vec<Vector> {
    let (mut out, mut head): (Vec<Vector>, f64) = (vec![[0.0; 3]], 0.0);
    for one in moves {
        match *one {
            Move::Home => {}
            Move::Feed { mm } => out = out.iter().map(|&[x, y, z]| [x + mm, y, z]).collect(),
            Move::Rotate { deg } => head -= deg,
            Move::Bend { deg } => {
                let z = turned([0.0, 0.0, 1.0], [1.0, 0.0, 0.0], head);
                out = out.iter().map(|&at| turned(at, z, deg)).collect();
                out.push([0.0; 3]);
            }
        }
    }
    out.push([0.0; 3]);
    out
}

fn wire(moves: &[Move]) -> PlayedWire {
    let mut by_hand = WireByHand::default();
    for &one in moves {
        by_hand.made(one);
    }
    by_hand.played()
}

fn ends(moves: &[Move]) -> Vec<Vector> {
    places(&wire(moves)).into_iter().map(|at| at.map(|part| (part * 100.0).round() / 100.0 + 0.0)).collect()
}

/// Wires in space, to both sides, the head turned by more than once around: as the examples are scheduled.
#[test]
fn it_is_after_each_move_where_a_machine_has_it_that_knows_only_the_moves() {
    let program = [
        [50.0, 0.0, 90.0],
        [40.0, -53.130_102, -90.0],
        [50.0, -14.931_417, 79.062_584],
        [47.434_165, -89.010_016, -105.014_523],
        [61.032_778, 370.0, 0.0],
    ];
    let moves: Vec<Move> =
        program.iter().flat_map(|&[fed, turn, angle]| [rotate(turn), feed(fed), bend(angle)]).collect();
    for made in 1..moves.len() {
        let played = wire(&moves[..made]);
        let wanted = bender(&moves[..made]);
        let found = places(&played);
        assert_eq!(found.len(), wanted.len());
        for (found, wanted) in found.iter().zip(&wanted) {
            let off: f64 = found.iter().zip(wanted).map(|(a, b)| (a - b).abs()).sum();
            // A hair of feed stands for none.
            assert!(off < 6e-3, "after {made} moves: {found:?} instead of {wanted:?}");
        }
        let turns: f64 =
            moves[..made].iter().map(|one| if let Move::Rotate { deg } = one { *deg } else { 0.0 }).sum();
        let end = played.steps.last().unwrap().moments.last().unwrap().clone();
        assert!((end.head_deg + turns).abs() < 1e-9);
        assert_eq!((end.bend_axis_deg, end.peg_out), (0.0, 0.0), "a bend by hand is a whole one");
    }
}

#[test]
fn moves_between_bends_are_as_if_they_were_one_of_each() {
    let mixed = [feed(10.0), rotate(30.0), feed(20.0), rotate(60.0), bend(90.0), feed(5.0)];
    assert_eq!(ends(&mixed), ends(&[feed(30.0), rotate(90.0), bend(90.0), feed(5.0)]));
}

#[test]
fn the_wire_is_drawn_back_as_far_as_its_last_bend() {
    let back = [feed(30.0), bend(90.0), feed(20.0), feed(-5.0)];
    assert_eq!(ends(&back), ends(&[feed(30.0), bend(90.0), feed(15.0)]));
    assert_eq!(ends(&[feed(30.0), bend(90.0), feed(-5.0)]), ends(&[feed(30.0), bend(90.0)]));
}

#[test]
fn two_bends_at_one_place_go_to_the_sides_that_the_head_was_turned_to() {
    // Out along +x, 90° to +y; turned by 90° the head's z is +y, about which what lies along +y stays.
    assert_eq!(ends(&[feed(10.0), bend(90.0)])[..1], [[0.0, 10.0, 0.0]]);
    assert_eq!(ends(&[feed(10.0), bend(90.0), rotate(90.0), bend(90.0)])[..1], [[0.0, 10.0, 0.0]]);
    assert_eq!(ends(&[feed(10.0), bend(90.0), bend(45.0)])[..1], [[-7.07, 7.07, 0.0]]);
}

#[test]
fn it_begins_with_nothing() {
    assert_eq!((wire(&[]).steps.len(), WireByHand::default().moves()), (1, 0));
    assert_eq!(ends(&[rotate(45.0)])[..1], [[0.0; 3]]);
}

/// Feed and bend of each step, and where the bend axis stands.
fn seen(by_hand: &WireByHand) -> Vec<[f64; 3]> {
    let round = |value: f64| (value * 1e6).round() / 1e6 + 0.0;
    let steps = by_hand.played().steps;
    steps
        .iter()
        .map(|step| {
            let bend_axis = step.moments.last().unwrap().bend_axis_deg;
            [step.designed.feed_mm, step.designed.bend_deg, bend_axis].map(round)
        })
        .collect()
}

#[test]
fn a_move_is_drawn_while_it_is_made_as_far_as_the_machine_reports_its_axes() {
    let mut by_hand = WireByHand::default();
    by_hand.made(feed(10.0));
    by_hand.begin(feed(20.0), Some(axes(100.0, 0.0, 0.0)));
    by_hand.position(axes(105.0, 0.0, 0.0));
    assert_eq!((seen(&by_hand), by_hand.moves()), (vec![[15.0, 0.0, 0.0]], 1));
    by_hand.made(feed(20.0));
    assert_eq!((seen(&by_hand), by_hand.moves()), (vec![[30.0, 0.0, 0.0]], 2));
    // Where the move before has ended counts, not what was reported on its way.
    by_hand.begin(bend(-60.0), Some(axes(111.0, 0.0, 0.0)));
    // The peg comes from the other side, bends, and goes back: the wire stays as it is.
    by_hand.position(axes(120.0, 0.0, 12.0));
    assert_eq!(seen(&by_hand), [[30.0, 0.0, 0.0]]);
    for (bend_deg, wanted) in [(-30.0, [30.0, -30.0, -30.0]), (-15.0, [30.0, -30.0, -15.0])] {
        by_hand.position(axes(120.0, 0.0, bend_deg));
        assert_eq!(seen(&by_hand), [wanted]);
        assert!(by_hand.played().steps[0].moments.last().unwrap().peg_out > 0.999);
    }
    by_hand.made(bend(-60.0));
    let done = [[30.0, -60.0, 0.0], [1e-3, 0.0, 0.0]];
    assert_eq!(seen(&by_hand), done);
    // What is reported between two moves moves nothing.
    by_hand.position(axes(150.0, 0.0, 0.0));
    assert_eq!(seen(&by_hand), done);
}

#[test]
fn a_move_that_is_stopped_leaves_the_wire_as_it_was_and_the_next_begins_where_the_axes_are_reported() {
    let mut by_hand = WireByHand::default();
    by_hand.begin(feed(20.0), Some(axes(0.0, 0.0, 0.0)));
    by_hand.position(axes(5.0, 0.0, 0.0));
    by_hand.interrupt();
    assert_eq!((seen(&by_hand), by_hand.moves()), (vec![[1e-3, 0.0, 0.0]], 0));
    by_hand.begin(feed(10.0), Some(axes(5.0, 0.0, 0.0)));
    by_hand.position(axes(7.0, 0.0, 0.0));
    assert_eq!(seen(&by_hand), [[2.0, 0.0, 0.0]]);
    // Where nothing is known of the axes it is drawn when it is done.
    by_hand.forget();
    by_hand.begin(feed(10.0), None);
    by_hand.position(axes(7.0, 0.0, 0.0));
    assert_eq!(seen(&by_hand), [[1e-3, 0.0, 0.0]]);
    by_hand.made(feed(10.0));
    assert_eq!(seen(&by_hand), [[10.0, 0.0, 0.0]]);
    by_hand.made(Move::Home);
    assert_eq!((seen(&by_hand), by_hand.moves()), (vec![[1e-3, 0.0, 0.0]], 0));
}
