//! WireBend-kit text, read by our reader.

use serde_json::Value;
use wirebend_files::read::{Format, ReadOptions, read};

use crate::exports::bounds::Off;
use crate::exports::compared::{Rounding, assert_same_wire, assert_steps, path};
use crate::exports::planned::each_case;

/// Three decimals are written, of feeds and turns those that add up right.
const DIGIT: f64 = 1e-3;

#[test]
fn every_case_is_the_wire_of_its_text() {
    let outcomes = each_case("wirebend-kit", "wirebend-kit-text", &Value::Null, |planned, wires, texts| {
        for (wire, text) in wires.iter().zip(texts) {
            assert!(text.starts_with("# design "), "the hash of the design it is of: {text}");
            let options = ReadOptions::default();
            let found = read(text.as_bytes(), "text.txt", Some(Format::Kit), &options).unwrap();
            let steps = found.program.unwrap().program.steps;
            let case = &planned.name;
            assert_steps(
                case,
                &steps,
                &wire.compensated,
                DIGIT,
                [Rounding::Sum, Rounding::Sum, Rounding::Each],
            );
            // Half a digit of each of the three numbers.
            let off = vec![Off { feed_mm: DIGIT / 2.0, angles_deg: DIGIT }; steps.len()];
            assert_same_wire(case, &path(&steps), &path(&wire.compensated), &off);
        }
    });
    outcomes.assert(18, &[("cube-not-doubled", "route"), ("fold-back", "compensated")], &[]);
}
