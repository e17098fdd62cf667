//! Programs read back by a parser of other people, and run: the wire that comes out is that of the job.

use gcode::{Code, Value};
use proptest::prelude::*;
use serde_json::json;
use wirebend_driver_api::conformance::sample_job;
use wirebend_driver_api::{MachineDriver, Step};
use wirebend_driver_grbl::Grbl;

/// A bend as the machine runs it: how much has been fed and rotated before, where the bend axis went from
/// and to. In units of the machine.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Bend {
    fed: f64,
    rotated: f64,
    from: f64,
    to: f64,
}

/// What a program does, with the letters of its axes: feed, rotate, bend.
#[derive(Debug, Default)]
struct Machine {
    relative: bool,
    pin_out: bool,
    at: [f64; 3],
    /// The moves of the bend axis since the pin was put out.
    turns: Vec<f64>,
    bends: Vec<Bend>,
}

impl Machine {
    fn run(text: &str, letters: [char; 3], decimals: i32) -> Self {
        let program = gcode::parse(text).expect("a program");
        let mut machine = Self::default();
        for code in program.blocks.iter().flat_map(|block| &block.codes) {
            match code {
                Code::General(general) => {
                    let words: Vec<(char, f64)> = general
                        .args
                        .iter()
                        .map(|word| match word.value {
                            // The parser has single precision: what was written is the nearest such number.
                            Value::Literal(value) => (word.letter, nearest(f64::from(value), decimals)),
                            _ => panic!("a variable in {text}"),
                        })
                        .collect();
                    machine.general(general.number.major(), &words, letters);
                }
                Code::Miscellaneous(code) => machine.pin(code.number.major()),
                other => panic!("{other} in {text}"),
            }
        }
        assert!(!machine.pin_out, "the pin stays out at the end");
        machine
    }

    fn general(&mut self, number: u32, words: &[(char, f64)], letters: [char; 3]) {
        match number {
            90 => self.relative = false,
            91 => self.relative = true,
            21 | 94 | 4 => {}
            92 => self.at = [0.0; 3],
            0 | 1 => {
                let moved: Vec<&(char, f64)> = words.iter().filter(|(letter, _)| *letter != 'F').collect();
                let [(letter, value)] = moved.as_slice() else { panic!("{words:?}: one axis at a time") };
                let axis = letters.iter().position(|known| known == letter).expect("an axis of the machine");
                assert_eq!(axis == 2, self.pin_out, "the pin is out while it bends, and only then");
                assert!(
                    self.relative || axis == 2 || (value - self.at[axis]).abs() > 1e-9,
                    "a move that moves nothing"
                );
                self.at[axis] = if self.relative { self.at[axis] + value } else { *value };
                if axis == 2 {
                    self.turns.push(self.at[2]);
                }
            }
            other => panic!("G{other}"),
        }
    }

    fn pin(&mut self, number: u32) {
        match number {
            3 => {
                assert!(!self.pin_out, "put out twice");
                self.pin_out = true;
                self.turns = vec![self.at[2]];
            }
            5 => {
                if std::mem::take(&mut self.pin_out) {
                    let from = self.turns[0];
                    let to = self
                        .turns
                        .iter()
                        .copied()
                        .max_by(|a, b| (a - from).abs().total_cmp(&(b - from).abs()));
                    let [fed, rotated, _] = self.at;
                    self.bends.push(Bend { fed, rotated, from, to: to.expect("a turn") });
                }
            }
            other => panic!("M{other}"),
        }
    }
}

/// The number with so many decimals that was written.
fn nearest(value: f64, decimals: i32) -> f64 {
    (value * 10f64.powi(decimals)).round() / 10f64.powi(decimals)
}

#[derive(Debug, Clone)]
struct Case {
    steps: Vec<Step>,
    decimals: i32,
    units: [f64; 3],
    letters: [char; 3],
    returns: bool,
    settings: serde_json::Value,
}

/// All of the settings that change what is written. The numbers stay small enough for single precision.
fn cases() -> impl Strategy<Value = Case> {
    let step =
        (-5.0..30.0f64, -60.0..60.0f64, prop_oneof![Just(0.0), -60.0..-0.6f64, 0.6..60.0f64]).prop_map(
            |(feed_mm, rotate_deg, bend_deg)| Step { feed_mm, rotate_deg, bend_deg, approach_deg: None },
        );
    let steps = prop::collection::vec(step, 1..12);
    let letters =
        prop::sample::subsequence(vec!['X', 'Y', 'Z', 'A', 'B', 'C', 'U', 'V', 'W'], 3).prop_shuffle();
    let units = prop::array::uniform3(prop::sample::select(vec![1.0, 2.0, 1.0 / 3.0, 0.125]));
    let flags = any::<[bool; 4]>();
    let arc = prop_oneof![Just(0.0), 0.1..90.0f64];
    let comments = prop::sample::select(vec!["parentheses", "semicolon", "none"]);
    (steps, 0..=4i32, units, letters, flags, arc, comments, 0.0..2.0f64).prop_map(
        |(steps, decimals, units, letters, [absolute, rapid, returns, numbers], arc, comments, dwell)| {
            let settings = json!({
                "feed_axis": letters[0], "rotate_axis": letters[1], "bend_axis": letters[2],
                "mode": if absolute { "absolute" } else { "relative" },
                "moves": if rapid { "rapid" } else { "feed-rate" },
                "feed_units_per_mm": units[0], "rotate_units_per_deg": units[1], "bend_units_per_deg": units[2],
                "decimals": decimals, "bend_returns": returns, "line_numbers": numbers,
                "arc_step_deg": arc, "arc_dwell_s": dwell, "pin_dwell_s": dwell, "comments": comments,
            });
            let letters = [letters[0], letters[1], letters[2]];
            Case { steps, decimals, units, letters, returns, settings }
        },
    )
}

proptest! {
    #[test]
    fn a_program_makes_the_wire_of_its_job(case in cases()) {
        let mut job = sample_job();
        job.wires[0].machine = Some(case.steps.clone());
        let driver = Grbl::open(serde_json::from_value(case.settings).unwrap()).unwrap();
        let text = &driver.encode("gcode", &job).unwrap().files[0].text;
        prop_assert!(!text.contains("-0 ") && !text.contains("-0.0 ") && !text.contains("-0.000 "));
        let machine = Machine::run(text, case.letters, case.decimals);

        // Half of the last digit, however many steps came before.
        let most = 0.5 * 10f64.powi(-case.decimals) + 1e-9;
        let (mut fed, mut rotated, mut bent) = (0.0, 0.0, 0.0);
        let mut bends = machine.bends.iter();
        for step in &case.steps {
            fed += step.feed_mm * case.units[0];
            rotated += step.rotate_deg * case.units[1];
            let before = if case.returns { 0.0 } else { bent };
            bent = before + step.bend_deg * case.units[2];
            let written = |place: f64| (place * 10f64.powi(case.decimals)).round();
            if (written(before) - written(bent)).abs() < 0.5 {
                continue; // too small to be written: no bend
            }
            let bend = bends.next().expect("a bend for each bend");
            for (made, meant) in [(bend.fed, fed), (bend.rotated, rotated), (bend.from, before), (bend.to, bent)] {
                prop_assert!((made - meant).abs() <= most, "{made} for {meant} in\n{text}");
            }
        }
        prop_assert_eq!(bends.next(), None);
        let end = [fed, rotated, if case.returns { 0.0 } else { bent }];
        for (made, meant) in machine.at.into_iter().zip(end) {
            prop_assert!((made - meant).abs() <= most, "{made} for {meant} at the end of\n{text}");
        }
    }
}
