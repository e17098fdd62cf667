use super::*;
use crate::bend::{Frame, replay};
use crate::simulate::scheduled_start;
use crate::units::Length;
use proptest::prelude::*;

fn deg(value: f64) -> Angle {
    Angle::from_deg(value).unwrap()
}

fn limits(min: f64, max: f64) -> HeadLimits {
    HeadLimits { min: deg(min), max: deg(max), seconds_per_degree: 1.0, seconds_per_turn: 0.0 }
}

fn program(turns: &[(f64, f64)]) -> NominalProgram {
    let feed = Length::from_mm(30.0).unwrap();
    let mut steps: Vec<Step> =
        turns.iter().map(|&(rotate, bend)| Step { feed, rotate: deg(rotate), bend: deg(bend) }).collect();
    if let Some(first) = steps.first_mut() {
        first.rotate = Angle::ZERO;
    }
    steps.push(Step { feed, ..Step::default() });
    NominalProgram::from_steps(steps)
}

fn head_travel(scheduled: &ScheduledProgram) -> f64 {
    scheduled.steps.iter().map(|step| step.rotate.abs().deg()).sum()
}

#[test]
fn a_flat_zigzag_never_turns_the_head() {
    let zigzag = program(&[(0.0, 90.0), (180.0, 90.0), (180.0, 60.0), (180.0, 90.0)]);
    let scheduled = schedule(&zigzag, &limits(-360.0, 360.0), |_| Some(1.0)).unwrap();
    assert!(head_travel(&scheduled) < 1e-12);
    let bends: Vec<f64> = scheduled.steps.iter().map(|step| step.bend.deg().round()).collect();
    assert_eq!(bends, [90.0, -90.0, 60.0, -90.0, 0.0]);
}

#[test]
fn a_machine_that_bends_to_one_side_turns_its_head_instead() {
    let zigzag = program(&[(0.0, 90.0), (180.0, 90.0), (180.0, 60.0)]);
    let one_sided = |bend: Angle| (bend > Angle::ZERO).then_some(1.0);
    let scheduled = schedule(&zigzag, &limits(-360.0, 360.0), one_sided).unwrap();
    assert!(scheduled.steps.iter().all(|step| step.bend >= Angle::ZERO));
    assert!((head_travel(&scheduled) - 360.0).abs() < 1e-9);
}

#[test]
fn a_head_that_cannot_turn_makes_flat_wires_only() {
    let flat = program(&[(0.0, 90.0), (180.0, 90.0)]);
    assert!(schedule(&flat, &limits(0.0, 0.0), |_| Some(1.0)).is_ok());
    let twisted = program(&[(0.0, 90.0), (180.0, 90.0), (30.0, 90.0)]);
    let error = schedule(&twisted, &limits(0.0, 0.0), |_| Some(1.0)).unwrap_err();
    assert_eq!(error.step, 2);
    assert!((error.wanted.deg() - 30.0).abs() < 1e-9);
}

#[test]
fn turns_of_steps_without_a_bend_are_not_lost() {
    let mut split = program(&[(0.0, 90.0), (25.0, 0.0), (15.0, 90.0)]);
    split.steps[1].feed = Length::ZERO;
    let scheduled = schedule(&split, &limits(-360.0, 360.0), |_| Some(1.0)).unwrap();
    assert!((scheduled.steps[2].rotate.deg() - 40.0).abs() < 1e-9);
    assert_eq!(scheduled.steps[1].rotate, Angle::ZERO);
}

/// The least time over every choice of sign and winding, tried one by one.
fn min_by_trying(turns: &[(f64, f64)], min: f64, max: f64, flip_cost: f64) -> Option<f64> {
    fn go(
        turns: &[(f64, f64)],
        k: usize,
        stand: f64,
        head: f64,
        spent: f64,
        (min, max, flip): (f64, f64, f64),
    ) -> Option<f64> {
        let Some(&(rotate, _)) = turns.get(k) else {
            return Some(spent);
        };
        let stand = stand + rotate;
        let mut best: Option<f64> = None;
        for halves in -12..=12 {
            let at = stand + 180.0 * f64::from(halves);
            if at < min - 1e-9 || at > max + 1e-9 {
                continue;
            }
            let made = if halves % 2 == 0 { 1.0 } else { 1.0 + flip };
            let total = go(turns, k + 1, stand, at, spent + (at - head).abs() + made, (min, max, flip));
            best = match (best, total) {
                (Some(a), Some(b)) => Some(a.min(b)),
                (a, b) => a.or(b),
            };
        }
        best
    }
    let limits = (min, max, flip_cost);
    let straight = go(turns, 1, 0.0, 0.0, 1.0, limits);
    let flipped = go(turns, 1, 180.0, 0.0, 1.0 + flip_cost, limits);
    match (straight, flipped) {
        (Some(a), Some(b)) => Some(a.min(b)),
        (a, b) => a.or(b),
    }
}

#[test]
fn a_head_without_limits_is_scheduled_in_no_time() {
    let endless = program(&vec![(170.0, 90.0); 400]);
    let scheduled = schedule(&endless, &limits(-1.0e9, 1.0e9), |_| Some(1.0)).unwrap();
    assert!(scheduled.head.iter().all(|head| head.abs().deg() <= 7400.0));
}

proptest! {
    #[test]
    fn nothing_is_faster_and_the_shape_stays(
        turns in prop::collection::vec((-179.0..180.0_f64, 5.0..170.0_f64), 1..6),
        min in -400.0..0.0_f64, max in 0.0..400.0_f64, flip_cost in 0.0..90.0_f64,
    ) {
        let nominal = program(&turns);
        let cost = |bend: Angle| Some(if bend > Angle::ZERO { 1.0 } else { 1.0 + flip_cost });
        let found = schedule(&nominal, &limits(min, max), cost).ok();
        let tried = min_by_trying(&turns, min, max, flip_cost);
        prop_assert!(found.is_some() || tried.is_none());
        // What cannot be made with the head at zero first is made with it elsewhere, or not at all.
        if let (Some(scheduled), None) = (&found, tried) {
            prop_assert!(scheduled.head[0] != Angle::ZERO);
        }
        if let (Some(scheduled), Some(tried)) = (found, tried) {
            let bends: f64 = scheduled.steps.iter().filter(|s| s.bend != Angle::ZERO).filter_map(|s| cost(s.bend)).sum();
            prop_assert!((head_travel(&scheduled) + bends - tried).abs() < 1e-5);
            let mut at = 0.0;
            for (step, head) in scheduled.steps.iter().zip(&scheduled.head) {
                at += step.rotate.deg();
                prop_assert!((head.deg() - at).abs() < 1e-9);
                prop_assert!(at >= min - 1e-6 && at <= max + 1e-6);
            }
            // Bent to the negative side first, the wire comes out turned by half a turn about its start.
            let mut start = Frame::default();
            if scheduled.steps[0].bend < Angle::ZERO {
                start.rotate(Angle::HALF_TURN);
            }
            let (wanted, made) = (replay(Frame::default(), &nominal.steps), replay(start, &scheduled.steps));
            for (a, b) in wanted.iter().zip(&made) {
                prop_assert!((a - b).norm() < 1e-9);
            }
        }
    }
}

/// Its head has half a turn: from zero it would have to bend twice to the side to which it cannot.
#[test]
fn the_head_turns_before_the_first_bend_where_a_later_one_needs_it() {
    let wire = program(&[(0.0, 90.0), (120.0, 80.0), (-5.0, 70.0), (-115.0, 85.0)]);
    let one_sided = |bend: Angle| (bend > Angle::ZERO).then_some(1.0);
    let scheduled = schedule(&wire, &limits(-90.0, 90.0), one_sided).unwrap();
    assert!(scheduled.steps.iter().all(|step| step.bend >= Angle::ZERO));
    // -30 is the least turn with which the second bend is within 90.
    let heads: Vec<f64> = scheduled.head.iter().map(|head| head.deg().round()).collect();
    assert_eq!(heads, [-30.0, 90.0, 85.0, -30.0, -30.0]);
    // To the other side alone it stands the same way.
    let other_side = |bend: Angle| (bend < Angle::ZERO).then_some(1.0);
    let mirrored = schedule(&wire, &limits(-90.0, 90.0), other_side).unwrap();
    assert!(mirrored.steps.iter().all(|step| step.bend <= Angle::ZERO));
    let heads: Vec<f64> = mirrored.head.iter().map(|head| head.deg().round()).collect();
    assert_eq!(heads, [-30.0, 90.0, 85.0, -30.0, -30.0]);
}

/// The bend is no sharper than others: the head cannot turn to where it is made to the only side.
#[test]
fn a_bend_that_no_turn_brings_to_the_only_side_is_out_of_range_of_the_head() {
    let wire = program(&[(0.0, 78.0), (159.3, 78.0), (-168.6, 54.0), (54.0, 92.0)]);
    let one_sided = |bend: Angle| (bend > Angle::ZERO).then_some(1.0);
    let refused = schedule(&wire, &limits(-60.0, 60.0), one_sided).unwrap_err();
    assert_eq!((refused.step, refused.wanted.deg().round()), (1, 159.0));
    assert!(schedule(&wire, &limits(-90.0, 90.0), one_sided).is_ok(), "from -69.3 to 90");
    // The first bend is none of them, though with it to the other side all others could be made.
    let wire = program(&[(0.0, 78.0), (170.0, 78.0), (5.0, 54.0), (-3.0, 92.0)]);
    let refused = schedule(&wire, &limits(-60.0, 60.0), one_sided).unwrap_err();
    assert_eq!((refused.step, refused.wanted.deg().round()), (1, 170.0));
    // What no side makes is not for want of turns.
    let none = |bend: Angle| (bend.abs() < deg(60.0)).then_some(1.0);
    assert!(schedule(&wire, &limits(-60.0, 60.0), none).is_ok());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    /// Where any angle of the head for the first bend makes all of them possible, they are made.
    #[test]
    fn what_can_be_bent_from_any_first_angle_is(
        turns in prop::collection::vec((-180.0..180.0_f64, 20.0..90.0_f64), 2..6),
        (least, span, both) in (-170.0..0.0_f64, 0.0..300.0_f64, prop::bool::ANY),
    ) {
        let (most, wire) = ((least + span).max(0.0), program(&turns));
        let makes = |bend: Angle| (both || bend > Angle::ZERO).then_some(1.0);
        let mut follows = vec![0.0];
        for &(turn, _) in &turns[1..] {
            follows.push(follows[follows.len() - 1] + turn);
        }
        let reached = |at: f64| {
            let ways = [0.0, 180.0].into_iter().take(if both { 2 } else { 1 });
            let head = |way: f64, whole: i32| (at + way).rem_euclid(360.0) - 360.0 * f64::from(whole);
            ways.flat_map(|way| [0, 1].map(|whole| head(way, whole))).any(|head| head >= least && head <= most)
        };
        let any = (0..720).map(|half| f64::from(half) / 2.0).find(|first| follows.iter().all(|turn| reached(first + turn)));
        let scheduled = schedule(&wire, &limits(least, most), makes);
        if let Some(first) = any {
            let scheduled = scheduled.map_err(|error| TestCaseError::fail(format!("{error}, but from {first}")))?;
            prop_assert!(scheduled.steps.iter().all(|step| both || step.bend >= Angle::ZERO), "from {first}");
            prop_assert!(scheduled.head.iter().all(|head| head.deg() >= least - 1e-6 && head.deg() <= most + 1e-6));
            let start = scheduled_start(Frame::default(), &scheduled.steps);
            for (a, b) in replay(Frame::default(), &wire.steps).iter().zip(&replay(start, &scheduled.steps)) {
                prop_assert!((a - b).norm() < 1e-6);
            }
        }
    }
}
