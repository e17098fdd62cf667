//! A feed that gives more or less, and a head that is off and has backlash.

use proptest::prelude::*;

use super::*;
use crate::testing::{deg, mm, published_machine};

/// A head in a fork that is wider than what it holds: it turns only once the drive lies against it. Everything that is asked for comes out with
/// the same error on top.
struct Fork {
    drive: f64,
    head: f64,
    width: f64,
    off: f64,
}

impl Fork {
    fn turn(&mut self, told: f64) -> f64 {
        if told == 0.0 {
            return 0.0;
        }
        let before = self.head;
        // In small pieces, as a motor steps.
        for _ in 0..1000 {
            self.drive += told / 1000.0;
            self.head = self.head.clamp(self.drive - self.width / 2.0, self.drive + self.width / 2.0);
        }
        self.head - before + self.off
    }
}

fn model(scale: f64, offset: f64, backlash: f64) -> MotionModel {
    MotionModel { feed_scale: scale, rotate_offset: deg(offset), rotate_backlash: deg(backlash) }
}

fn turns() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(prop_oneof![2 => -180.0..180.0_f64, 1 => Just(0.0)], 1..20)
}

proptest! {
    /// What the program commands turns such a head as the design has it.
    #[test]
    fn a_head_with_backlash_turns_as_designed(
        turns in turns(), scale in 0.9..1.1_f64, offset in -1.0..1.0_f64, backlash in 0.0..3.0_f64,
    ) {
        let steps: Vec<Step> =
            turns.iter().map(|&turn| Step { feed: mm(40.0), rotate: deg(turn), bend: deg(30.0) }).collect();
        let mut told = steps.clone();
        model(scale, offset, backlash).command(&mut told);
        // Which side the drive lies on before the first turn is not known: at the one to which it turns.
        let first = told.iter().map(|step| step.rotate.deg()).find(|turn| *turn != 0.0).unwrap_or_default();
        let head = -first.signum() * backlash / 2.0;
        let mut fork = Fork { drive: 0.0, head, width: backlash, off: offset };
        for (told, step) in told.iter().zip(&steps) {
            let made = fork.turn(told.rotate.deg());
            prop_assert!((made - step.rotate.deg()).abs() < 1e-6, "{made} instead of {}", step.rotate);
            prop_assert!((told.feed.mm() * scale - step.feed.mm()).abs() < 1e-9);
        }
    }

    /// What any commands make of such a head, small ones within its backlash included.
    #[test]
    fn commands_turn_it_as_the_inverse_says(
        turns in prop::collection::vec(-4.0..4.0_f64, 1..20), offset in -1.0..1.0_f64, backlash in 0.0..3.0_f64,
    ) {
        let told: Vec<Step> = turns.iter().map(|&turn| Step { rotate: deg(turn), ..Step::default() }).collect();
        let head = -turns[0].signum() * backlash / 2.0;
        let mut fork = Fork { drive: 0.0, head, width: backlash, off: offset };
        for (made, told) in model(1.0, offset, backlash).result(&told).iter().zip(&told) {
            let turned = fork.turn(told.rotate.deg());
            prop_assert!((made.rotate.deg() - turned).abs() < 1e-6, "{} {turned}", made.rotate);
        }
    }
}

/// A rotation that is there by rounding alone turns no head: neither the offset nor the backlash is made up for.
#[test]
fn no_rotation_is_commanded_where_there_is_none() {
    let turn = |rotate: f64| Step { rotate: deg(rotate), ..Step::default() };
    let mut steps = [90.0, -1e-12, 0.0, 0.5, -90.0].map(turn);
    model(1.0, 0.5, 2.0).command(&mut steps);
    let told = steps.map(|step| step.rotate.deg());
    let expected = [89.5, 0.0, 0.0, 0.0, -92.5];
    assert!(told.iter().zip(expected).all(|(told, expected)| (told - expected).abs() < 1e-9), "{told:?}");
}

#[test]
fn the_wire_that_feeds_take_is_counted_as_it_is() {
    let program = ScheduledProgram {
        steps: vec![Step { feed: mm(100.0), ..Step::default() }; 3],
        head: vec![Angle::ZERO; 3],
    };
    let mut compensation = published_machine().compensation;
    compensation.motion.feed_scale = 1.02;
    let told = compensate(&program, &compensation).unwrap();
    assert!((told.steps()[0].feed.mm() - 100.0 / 1.02).abs() < 1e-9);
    assert!((told.feed_total().mm() - 300.0).abs() < 1e-9);
}
