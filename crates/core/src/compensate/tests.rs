use super::*;
use proptest::prelude::*;

fn mm(value: f64) -> Length {
    Length::from_mm(value).unwrap()
}

fn deg(value: f64) -> Angle {
    Angle::from_deg(value).unwrap()
}

/// R 20.4, s 12, pin 1.5 and rod 3.175 with 3 mm wire: the published bender.
fn published_peg() -> PegGeometry {
    PegGeometry::new(mm(20.4), mm(12.0), mm(3.0), mm(4.675)).unwrap()
}

fn published() -> BendModel {
    BendModel {
        springback: Some(Springback::Constant(deg(10.23))),
        setback: Some(published_peg()),
        axis_limit: None,
        before_zero: false,
    }
}

fn table() -> Springback {
    let points = |pairs: &[(f64, f64)]| {
        let points: Vec<_> =
            pairs.iter().map(|&(f, l)| SpringbackPoint { formed: deg(f), loss: deg(l) }).collect();
        SpringbackCurve::new(&points).unwrap()
    };
    // Measured on 1/8 inch aluminium: 4.9° lost at 10° and 8.6° at 130°.
    Springback::Table {
        positive: points(&[(10.0, 4.9), (130.0, 8.6)]),
        negative: points(&[(15.0, 3.0), (30.0, 6.1), (60.0, 6.0), (120.0, 9.5)]),
    }
}

#[test]
fn setback_is_the_published_derivation() {
    // Worked out with the law of sines outside of this program.
    for (bend, axis) in [(30.0, 32.594), (60.0, 71.931), (90.0, 102.240), (120.0, 123.421), (150.0, 137.909)]
    {
        let found = published_peg().axis_for(deg(bend)).unwrap().deg();
        assert!((found - axis).abs() < 1e-3, "a bend of {bend}° goes to {found}°, not {axis}°");
    }
    let touching = published_peg().axis_for(Angle::ZERO).unwrap().deg();
    assert!((touching + 13.25).abs() < 5e-3, "the peg touches straight wire at {touching}°, not -13.25°");
}

/// The axis position found by moving the peg itself: its centre E = `T + u·l + n·r_e` touches the
/// bent leg from outside, l along it from the tangent point T, and is R away from F = (s, 0).
fn brute_force_axis(bend: f64) -> f64 {
    brute_force_axis_at(12.0, bend)
}

fn brute_force_axis_at(offset: f64, bend: f64) -> f64 {
    let (orbit, pin, peg) = (20.4, 3.0, 4.675);
    let theta = bend.to_radians();
    let (u, n) = ((theta.cos(), theta.sin()), (theta.sin(), -theta.cos()));
    let tangent = (pin * theta.sin(), pin * (1.0 - theta.cos()));
    let centre = |l: f64| (tangent.0 + u.0 * l + n.0 * peg, tangent.1 + u.1 * l + n.1 * peg);
    let away = |l: f64| {
        let (x, y) = centre(l);
        (x - offset).hypot(y) - orbit
    };
    let (mut low, mut high) = (0.0, 100.0);
    assert!(away(low) < 0.0 && away(high) > 0.0);
    for _ in 0..200 {
        let middle = f64::midpoint(low, high);
        if away(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    let (x, y) = centre(low);
    y.atan2(x - offset).to_degrees()
}

#[test]
fn the_range_of_the_published_bender_is_within_reach() {
    let peg = published_peg();
    assert!(peg.reach().deg() > 165.23, "155° and 10.23° of springback have to be pressed");
    let model = published();
    for bend in [155.0, -155.0] {
        let axis = model.command(deg(bend)).unwrap();
        assert!(axis.deg() * bend > 0.0);
    }
}

#[test]
fn unreachable_bends_say_what_can_be_made() {
    let limited = BendModel { axis_limit: Some(deg(100.0)), ..published() };
    let Err(BendError::OutOfReach { bend, max }) = limited.command(deg(120.0)) else {
        panic!("120° needs the axis beyond 100°")
    };
    assert_eq!(bend, deg(120.0));
    assert!(limited.command(max).is_ok());
    assert!(limited.command(max + deg(1e-3)).is_err());
    assert_eq!(limited.max_bend(deg(-1.0)), max, "both sides are alike");
    // Without springback a bend of 1° is pressed before the peg's centre reaches the wire's axis.
    let bare = BendModel { springback: None, ..published() };
    assert_eq!(bare.command(deg(1.0)), Err(BendError::TooSmall { bend: deg(1.0) }));
}

#[test]
fn a_command_within_the_springback_leaves_no_bend() {
    let model = BendModel { setback: None, ..published() };
    assert_eq!(model.result(deg(10.0)), Angle::ZERO);
    assert_eq!(model.result(deg(-10.0)), Angle::ZERO);
    assert!((model.result(deg(-11.23)).deg() + 1.0).abs() < 1e-9);
    assert_eq!(published_peg().bend_at(deg(-13.3)), Angle::ZERO, "the peg does not touch yet");
}

#[test]
fn the_table_goes_through_what_was_measured_and_its_sides_differ() {
    let table = table();
    for (formed, bent) in [(10.0, 14.9), (130.0, 138.6), (-15.0, -18.0), (-60.0, -66.0), (-120.0, -129.5)] {
        assert!((table.bend_to(deg(formed)).deg() - bent).abs() < 1e-9, "{formed}");
    }
    // Outside of what was measured the loss stays that of the nearest pair.
    assert!((table.bend_to(deg(150.0)).deg() - 158.6).abs() < 1e-9);
    assert!((table.bend_to(deg(2.0)).deg() - 6.9).abs() < 1e-9);
    assert_eq!(table.formed(deg(4.8)), Angle::ZERO);
}

#[test]
fn wrong_tables_and_dimensions_are_refused() {
    let point = |formed, loss| SpringbackPoint { formed: deg(formed), loss: deg(loss) };
    assert_eq!(SpringbackCurve::new(&[]), Err(SpringbackError::Empty));
    assert_eq!(SpringbackCurve::new(&[point(-0.5, 1.0)]), Err(SpringbackError::Range(0)));
    assert_eq!(SpringbackCurve::new(&[point(5.0, -1.0)]), Err(SpringbackError::Range(0)));
    let falling = [point(10.0, 9.0), point(12.0, 6.0)];
    assert_eq!(SpringbackCurve::new(&falling), Err(SpringbackError::NotIncreasing(1)));
    assert!(matches!(
        PegGeometry::new(mm(20.0), mm(12.0), mm(0.0), mm(4.0)),
        Err(PegGeometryError::NotPositive { radius: PegRadius::Pin, .. })
    ));
    assert!(matches!(
        PegGeometry::new(mm(4.0), mm(12.0), mm(3.0), mm(4.0)),
        Err(PegGeometryError::NoContact { .. })
    ));
    // The orbit is √(20.4² - 4.675²) = 19.857 wide where it is 4.675 off the wire's axis.
    let far_back = |offset| PegGeometry::new(mm(20.4), mm(offset), mm(3.0), mm(4.675));
    assert!(far_back(-19.8).is_ok());
    assert!(matches!(far_back(-19.9), Err(PegGeometryError::Behind { .. })));
}

#[test]
fn the_middle_side_of_the_published_u_gives_up_2_230_mm() {
    let model = FeedModel::new(mm(1.5), mm(3.0), 0.3);
    assert_eq!((model.bend_radius, model.neutral_radius), (mm(3.0), mm(2.4)));
    let quarter = deg(90.0);
    // 6 - 2.4·π/2; measured without compensation: 2.25 ± 0.20 mm.
    let correction = 35.0 - model.feed_for(mm(35.0), quarter, quarter).mm();
    assert!((correction - 2.230).abs() < 1e-3, "{correction}");
}

proptest! {
    #[test]
    fn setback_agrees_with_moving_the_peg(bend in 0.0..165.0_f64) {
        let axis = published_peg().axis_for(deg(bend)).unwrap().deg();
        prop_assert!((axis - brute_force_axis(bend)).abs() < 1e-6);
    }

    #[test]
    fn what_the_peg_presses_is_what_it_was_sent_for(bend in 0.0..165.0_f64) {
        let peg = published_peg();
        let axis = peg.axis_for(deg(bend)).unwrap();
        prop_assert!((peg.bend_at(axis).deg() - bend).abs() < 1e-9);
    }

    #[test]
    fn compensate_then_bend_gives_the_angle_back(bend in -155.0..155.0_f64, kind in 0..4_u8) {
        prop_assume!(bend != 0.0);
        let model = match kind {
            0 => published(),
            1 => BendModel { springback: Some(table()), ..published() },
            2 => BendModel { springback: Some(table()), setback: None, axis_limit: None, before_zero: false },
            _ => BendModel::default(),
        };
        // The smallest bends of the weakest springback stop on the far side; those are refused.
        if let Ok(command) = model.command(deg(bend)) {
            prop_assert!((model.result(command).deg() - bend).abs() < 1e-9);
        } else {
            prop_assert!(kind == 1 && bend.abs() < 15.0);
        }
    }

    /// Two pairs say nothing of a loss that is larger than both.
    #[test]
    fn between_two_pairs_no_loss_is_beyond_theirs(bend in 0.1..179.0_f64, side: bool) {
        let table = table();
        let bend = if side { bend } else { -bend };
        let loss = table.bend_to(deg(bend)).abs().deg() - bend.abs();
        let pairs: &[(f64, f64)] =
            if side { &[(10.0, 4.9), (130.0, 8.6)] } else { &[(15.0, 3.0), (30.0, 6.1), (60.0, 6.0), (120.0, 9.5)] };
        let next = pairs.partition_point(|pair| pair.0 < bend.abs());
        let one = pairs[next.saturating_sub(1).min(pairs.len() - 1)].1;
        let other = pairs[next.min(pairs.len() - 1)].1;
        prop_assert!(loss >= one.min(other) - 1e-9 && loss <= one.max(other) + 1e-9, "{loss} at {bend}");
    }

    /// The orbit's centre may lie before the start of the bend: the equations are the same. Bends up to the reach.
    #[test]
    fn setback_holds_for_an_orbit_to_either_side(offset in -15.0..18.0_f64, part in 0.0..1.0_f64) {
        let peg = PegGeometry::new(mm(20.4), mm(offset), mm(3.0), mm(4.675)).unwrap();
        let bend = peg.reach().deg().min(170.0) * part * 0.999;
        let axis = peg.axis_for(deg(bend)).unwrap();
        prop_assert!((axis.deg() - brute_force_axis_at(offset, bend)).abs() < 1e-6, "{axis:?} at {offset}");
        prop_assert!((peg.bend_at(axis).deg() - bend).abs() < 1e-6);
    }

    #[test]
    fn larger_bends_take_larger_commands(a in 0.1..155.0_f64, b in 0.1..155.0_f64, side: bool) {
        prop_assume!((a - b).abs() > 1e-6);
        let sign = if side { 1.0 } else { -1.0 };
        let table = table();
        let (a, b) = (deg(sign * a), deg(sign * b));
        prop_assert_eq!(a.abs() < b.abs(), table.bend_to(a).abs() < table.bend_to(b).abs());
    }

    #[test]
    fn feeding_and_measuring_are_inverse(
        segment in 1.0..500.0_f64, before in -155.0..155.0_f64, after in -155.0..155.0_f64,
    ) {
        let model = FeedModel::new(mm(1.5), mm(3.0), 0.3);
        let (before, after) = (deg(before), deg(after));
        let fed = model.feed_for(mm(segment), before, after);
        prop_assert!((model.segment_of(fed, before, after).mm() - segment).abs() < 1e-9);
    }
}

mod before_zero;
mod contact;
mod motion;
