//! Pensa scripts, read by our reader.

use serde_json::Value;
use wirebend_core::bend::Step;
use wirebend_files::read::{Format, ReadOptions, read};

use crate::exports::bounds::{Off, of_vertices};
use crate::exports::compared::{Rounding, assert_handed, assert_same_wire, assert_steps, path};
use crate::exports::planned::each_case;

/// Five decimals are written, each number rounded alone.
const DIGIT: f64 = 1e-5;

pub fn steps_of(text: &str) -> Vec<Step> {
    let found = read(text.as_bytes(), "script.dsw", Some(Format::Pensa), &ReadOptions::default()).unwrap();
    found.program.unwrap().program.steps
}

/// It was not accepted that edges of this cube are travelled twice, so it has no route.
#[test]
fn every_case_is_the_wire_of_its_script() {
    let outcomes = each_case("pensa-diwire-pro", "pensa-script", &Value::Null, |planned, wires, texts| {
        for (wire, text) in wires.iter().zip(texts) {
            let (case, steps) = (&planned.name, steps_of(text));
            assert_steps(case, &steps, &wire.compensated, DIGIT, [Rounding::Each; 3]);
            // Half a digit of each of the three numbers.
            let off = vec![Off { feed_mm: DIGIT / 2.0, angles_deg: DIGIT }; steps.len()];
            assert_same_wire(case, &path(&steps), &path(&wire.compensated), &off);
            // This machine compensates on its own: its script is the design.
            let farthest = of_vertices(&wire.corners, &off).into_iter().fold(0.0, f64::max);
            assert_handed(case, &path(&steps), &wire.corners, farthest);
        }
    });
    outcomes.assert(19, &[("cube-not-doubled", "route")], &[]);
}
