//! Bends whose axis stops at zero or before it, on a machine that is told their side.

use super::contact::program;
use super::*;

/// Soft wire on the published bender, or one of other dimensions.
fn soft(peg: PegGeometry, loss: f64) -> BendModel {
    BendModel {
        springback: Some(Springback::Constant(deg(loss))),
        setback: Some(peg),
        axis_limit: None,
        before_zero: true,
    }
}

fn compensation(bend: BendModel) -> Compensation {
    Compensation { feed: Some(FeedModel::new(mm(1.5), mm(3.0), 0.3)), bend, motion: MotionModel::default() }
}

/// Were the sign of the axis taken for the side, such a bend would come out to the other side, or not at all.
#[test]
fn a_small_bend_of_soft_wire_ends_before_zero() {
    let model = soft(published_peg(), 0.0);
    // By moving the peg along its orbit until it meets the leg, outside of the formulas.
    for bend in [0.5, 2.0, 5.0, 8.0] {
        let axis = model.command(deg(bend)).unwrap();
        assert!((axis.deg() - brute_force_axis(bend)).abs() < 1e-6 && axis < Angle::ZERO, "{axis}");
        assert_eq!(model.command(deg(-bend)).unwrap(), -axis);
        let refused = BendModel { before_zero: false, ..model.clone() }.command(deg(bend));
        assert_eq!(refused, Err(BendError::TooSmall { bend: deg(bend) }), "as ever without a side");
    }
}

#[test]
fn a_step_says_its_side_where_its_sign_does_not() {
    let of = |bend: f64| {
        let program = program(&[(100.0, 0.0, bend), (60.0, 0.0, 0.0)]);
        compensate(&program, &compensation(soft(published_peg(), 0.3))).unwrap()
    };
    for side in [1.0, -1.0] {
        let small = of(2.0 * side);
        let told: Vec<ToldStep> = small.told().collect();
        assert!(told[0].step.bend.signum() * side < 0.0 && told[0].bends(), "{told:?}");
        assert!((told[0].side() - side).abs() < 1e-12 && told[0].needs_side());
        assert!((told[0].approach.unwrap().deg() + 18.248 * side).abs() < 1e-3, "{told:?}");
        assert_eq!(small.peg_comes_out(0), told[0].approach);
        assert_eq!(told[1], ToldStep::from(small.steps()[1]));
        let large = of(20.0 * side);
        assert_eq!(large.told().next().unwrap().approach, None);
    }
    // An axis at zero bends all the same, if the peg comes out for it.
    let step = Step { feed: mm(100.0), ..Step::default() };
    let told = ToldStep { step, approach: Some(deg(-18.25)) };
    let left = results(&[told], &compensation(soft(published_peg(), 0.0)))[0];
    assert!((left.deg() - 8.353).abs() < 1e-3, "{left}");
}

proptest! {
    /// Whatever the bend head's dimensions are, down to a touch.
    #[test]
    fn what_is_bent_is_what_was_asked_for(
        orbit in 12.0..40.0_f64, offset in 0.0..0.8_f64, pin in 1.0..6.0_f64, peg in 0.1..0.6_f64,
        loss in 0.0..6.0_f64, part in 1e-4..1.0_f64, left in any::<bool>(),
    ) {
        let peg = PegGeometry::new(mm(orbit), mm(offset * orbit), mm(pin), mm(peg * orbit)).unwrap();
        let model = soft(peg, loss);
        let side = if left { 1.0 } else { -1.0 };
        // Where the axis is at zero, as far as that is a bend at all.
        let at_zero = peg.bend_at(Angle::ZERO).deg() - loss;
        prop_assume!(at_zero > 0.01);
        let bend = deg(side * part * at_zero);
        let axis = model.command(bend).unwrap();
        prop_assert!(axis.rad() * side <= 1e-9, "{axis} for {bend}");
        prop_assert!(axis.abs() < peg.near_side(), "the peg comes out beyond it");
        prop_assert!((model.result_to(side, axis) - bend).abs().deg() < 1e-9);
    }

    /// One bend after another, within the peg's reach or out of it; kept in a job they are the same.
    #[test]
    fn chains_of_small_bends_come_out(
        bends in prop::collection::vec((3.0..60.0_f64, -180.0..180.0_f64, 0.3..40.0_f64, any::<bool>()), 1..10),
        loss in 0.0..2.0_f64,
    ) {
        let edges: Vec<_> = bends
            .iter()
            .map(|&(edge, rotate, bend, left)| (edge, rotate, if left { bend } else { -bend }))
            .collect();
        let program = program(&edges);
        let compensation = compensation(soft(published_peg(), loss));
        let Ok(told) = compensate(&program, &compensation) else { return Ok(()) };
        let commands: Vec<ToldStep> = told.told().collect();
        for (told, step) in commands.iter().zip(&program.steps) {
            prop_assert!((told.side() - step.bend.signum()).abs() < 1e-12, "{told:?} for {}", step.bend);
        }
        let again = CompensatedProgram::from_job_steps(commands.clone(), &compensation);
        prop_assert_eq!(again.steps(), told.steps());
        prop_assert_eq!(&commands, &again.told().collect::<Vec<_>>());
        for (step, command) in commands.iter().enumerate() {
            if told.unpressed().is_empty() {
                let (at, again) = (told.peg_comes_out(step).unwrap(), again.peg_comes_out(step).unwrap());
                prop_assert!((at - again).abs().deg() < 1e-6, "{at}, {again}");
                prop_assert!(command.beyond_zero() > -at.abs().rad(), "it comes out beyond it");
            }
        }
        if told.unpressed().is_empty() {
            let left = results(&commands, &compensation);
            for (left, step) in left.iter().zip(&program.steps) {
                prop_assert!((left.deg() - step.bend.deg()).abs() < 1e-6, "{left} for {}", step.bend);
            }
        }
    }
}
