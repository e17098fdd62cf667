//! A bender that runs G-code, as a parser of other people reads it: three axes and a pin, and nothing of the driver
//! that wrote it.

use gcode::{Argument, Code, Value};
use wirebend_core::bend::Step;
use wirebend_core::units::{Angle, Length};

/// Feed in mm, rotation and bend in degrees.
const AXES: [char; 3] = ['X', 'Y', 'Z'];

/// Where the bend pin is.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
enum Pin {
    /// The program has not said yet.
    #[default]
    Unknown,
    In,
    Out,
}

/// A bender in the middle of a program.
#[derive(Debug, Default)]
pub struct Bender {
    relative: bool,
    pin: Pin,
    at: [f64; 3],
    /// Where the bend axis has been since the pin was put out.
    turns: Vec<f64>,
    /// Feed, rotation and bend of the step under way, and whether it has bent.
    step: [f64; 3],
    bent: bool,
    /// The steps that were run.
    pub steps: Vec<Step>,
    /// The program has ended.
    ended: bool,
}

impl Bender {
    /// Runs a program.
    pub fn run(text: &str) -> Self {
        let program = gcode::parse(text).unwrap_or_else(|error| panic!("{error:?} in\n{text}"));
        let mut bender = Self { turns: vec![0.0], ..Self::default() };
        let mut last_line = 0;
        for block in &program.blocks {
            assert!(block.word_addresses.is_empty(), "words without a command: {block}");
            assert!(!bender.ended || block.codes.is_empty(), "after the end: {block}");
            if let Some(line) = block.line_number {
                assert_eq!(line, last_line + 1, "lines are numbered one after the other");
                last_line = line;
            }
            for code in &block.codes {
                match code {
                    Code::General(code) => bender.general(code.number.major(), &words(text, &code.args)),
                    Code::Miscellaneous(code) => bender.miscellaneous(code.number.major()),
                    other => panic!("{other}"),
                }
            }
        }
        bender.finish_step();
        assert_eq!(bender.pin, Pin::In, "the pin at the end");
        bender
    }

    /// Where the axes are.
    pub fn at(&self) -> [f64; 3] {
        self.at
    }

    fn general(&mut self, number: u32, words: &[(char, f64)]) {
        match (number, words) {
            (21 | 94, []) => {}
            (90, []) => self.relative = false,
            (91, []) => self.relative = true,
            (92, zeros) => {
                for (letter, value) in zeros {
                    self.at[axis_of(*letter)] = *value;
                }
            }
            (4, [('P', seconds)]) => assert!(*seconds > 0.0, "a pause of {seconds} s"),
            (0, [(letter, value)]) => self.go(axis_of(*letter), *value),
            (1, [(letter, value), ('F', rate)]) => {
                assert!(*rate > 0.0, "a rate of {rate}");
                self.go(axis_of(*letter), *value);
            }
            other => panic!("G{other:?}"),
        }
    }

    fn miscellaneous(&mut self, number: u32) {
        match number {
            // The spindle output or the coolant: whichever the pin is wired to.
            3 | 8 => {
                assert_eq!(self.pin, Pin::In, "the pin before it is put out");
                (self.pin, self.turns) = (Pin::Out, vec![self.at[2]]);
            }
            5 | 9 => {
                if std::mem::replace(&mut self.pin, Pin::In) == Pin::Out {
                    self.bend();
                }
            }
            2 | 30 => self.ended = true,
            other => panic!("M{other}"),
        }
    }

    fn go(&mut self, axis: usize, value: f64) {
        let to = if self.relative { self.at[axis] + value } else { value };
        let moved = to - std::mem::replace(&mut self.at[axis], to);
        // The bend axis moves with the pin out, the wire with the pin in.
        assert_eq!(self.pin, if axis == 2 { Pin::Out } else { Pin::In }, "a move of {}", AXES[axis]);
        if axis == 2 {
            self.turns.push(to);
            return;
        }
        // Feed, rotate, bend: what comes before its turn belongs to the next step.
        if self.bent || (axis == 0 && self.step.iter().any(|&part| part != 0.0)) {
            self.finish_step();
        }
        self.step[axis] += moved;
    }

    /// The bend that the pin has bent: from where the axis stood to the farthest place, and back.
    fn bend(&mut self) {
        let from = self.turns[0];
        let to = self
            .turns
            .iter()
            .copied()
            .fold(from, |far, at| if (at - from).abs() > (far - from).abs() { at } else { far });
        assert!((self.at[2] - from).abs() < 1e-9, "the bend axis does not go back: {:?}", self.turns);
        let highest = self.turns.iter().position(|&at| at.to_bits() == to.to_bits()).unwrap();
        let grows =
            self.turns[..=highest].windows(2).all(|pair| (pair[1] - from).abs() > (pair[0] - from).abs());
        assert!(grows && highest + 2 == self.turns.len(), "out in parts and back in one: {:?}", self.turns);
        assert!(!self.bent, "two bends in one place");
        (self.step[2], self.bent) = (to - from, true);
    }

    fn finish_step(&mut self) {
        let [feed, rotate, bend] = std::mem::take(&mut self.step);
        if std::mem::take(&mut self.bent) || feed != 0.0 || rotate != 0.0 {
            let angle = |deg: f64| Angle::from_deg(deg).unwrap();
            let feed = Length::from_mm(feed).unwrap();
            self.steps.push(Step { feed, rotate: angle(rotate), bend: angle(bend) });
        }
    }
}

fn axis_of(letter: char) -> usize {
    AXES.iter().position(|&axis| axis == letter).unwrap_or_else(|| panic!("the axis {letter}"))
}

/// Letters and numbers. The parser keeps single precision, which cannot hold a place on ten metres of wire to a
/// thousandth: it says where a number stands, the digits are taken from there, and have to be its number.
fn words(text: &str, arguments: &[Argument]) -> Vec<(char, f64)> {
    let word = |argument: &Argument| {
        let Value::Literal(single) = argument.value else { panic!("a variable: {argument}") };
        let written = text[argument.span.start..argument.span.end()].trim_start_matches(argument.letter);
        let exact: f64 = written.trim().parse().unwrap_or_else(|error| panic!("{error}: '{written}'"));
        let off = (exact - f64::from(single)).abs();
        assert!(
            off <= exact.abs() * f64::from(f32::EPSILON) + f64::from(f32::MIN_POSITIVE),
            "{exact} is not {single}"
        );
        (argument.letter, exact)
    };
    arguments.iter().map(word).collect()
}
