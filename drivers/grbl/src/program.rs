//! A wire as lines of G-code. Files and the live stream have the same lines, and both have them from here.

use std::rc::Rc;

use wirebend_driver_api::{DriverError, Step};

use crate::settings::{Letter, Mode, Moves, Names, Settings};

/// The largest position in units of the machine. Beyond it grbl, which counts in single precision, could no
/// longer distinguish two positions a tenth of a unit apart.
pub(crate) const MAX_POSITION: f64 = 1e6;
/// The highest line number that grbl takes (error 27).
const LAST_LINE: u32 = 9_999_999;

/// Why a step cannot be written.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub(crate) enum Unwritable {
    /// A value of the step.
    #[error("its {what} is {value}, which is not a number")]
    NotFinite { what: &'static str, value: f64 },
    #[error("its {what} ends at {position:.0} units of the machine, more than {MAX_POSITION}")]
    TooFar { what: &'static str, position: f64 },
}

/// Lines, and where the axes stand when all of them are done. Within a segment no move sets right what another has moved:
/// a line that was changed on its way shows at its end.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Segment {
    pub lines: Vec<String>,
    /// Feed, rotation and bend as written, in units of the machine, from where the program began.
    pub end: [f64; 3],
}

/// A program that is being written: where the axes are, exactly and as written.
#[derive(Debug, Clone)]
pub(crate) struct Program {
    settings: Rc<Settings>,
    start_block: Rc<[String]>,
    end_block: Rc<[String]>,
    feed: AxisAt,
    rotate: AxisAt,
    bend: AxisAt,
    lines: u32,
}

#[derive(Debug, Clone)]
struct AxisAt {
    what: &'static str,
    letter: Letter,
    /// In units of the machine a minute.
    rate: f64,
    /// Units of the machine for each mm or degree.
    units: f64,
    /// mm or degrees.
    exact: f64,
    /// In the last digit that is written.
    written: i64,
}

impl Program {
    /// Both blocks are filled here, so that a wire is refused before it begins and not at its end.
    pub fn new(settings: Rc<Settings>, names: &Names) -> Result<Self, DriverError> {
        let axis = |what, letter, rate: f64, units: f64| AxisAt {
            what,
            letter,
            rate: rate * units,
            units,
            exact: 0.0,
            written: 0,
        };
        let s = &settings;
        Ok(Self {
            start_block: names.fill("start_block", &s.start_block)?.into(),
            end_block: names.fill("end_block", &s.end_block)?.into(),
            feed: axis("feed", s.feed_axis, s.feed_rate_mm_per_min, s.feed_units_per_mm),
            rotate: axis("rotation", s.rotate_axis, s.rotate_rate_deg_per_min, s.rotate_units_per_deg),
            bend: axis("bend", s.bend_axis, s.bend_rate_deg_per_min, s.bend_units_per_deg),
            settings,
            lines: 0,
        })
    }

    /// What comes before the first step: the person's block, modes that all moves rely on, the pin taken in.
    pub fn start(&mut self) -> Vec<String> {
        let settings = Rc::clone(&self.settings);
        let mut lines = self.start_block.to_vec();
        lines.extend(["G21".to_owned(), "G94".to_owned()]);
        match settings.mode {
            Mode::Relative => lines.push("G91".to_owned()),
            Mode::Absolute => {
                let zero = settings.axes().map(|(_, axis)| format!(" {}0", axis.letter())).concat();
                lines.extend(["G90".to_owned(), format!("G92{zero}")]);
            }
        }
        lines.extend(pin_in_lines(&settings));
        self.numbered(lines)
    }

    /// The head turned from where it begins to a place, for a wire that is resumed. Nothing for zero.
    pub fn turned_to(&mut self, rotate_deg: f64) -> Result<Option<Segment>, Unwritable> {
        let settings = Rc::clone(&self.settings);
        let line = self.rotate.by(rotate_deg, &settings)?;
        let end = self.written();
        Ok(line.map(|line| Segment { lines: self.numbered(vec![line]), end }))
    }

    fn written(&self) -> [f64; 3] {
        [&self.feed, &self.rotate, &self.bend].map(|axis| axis.written(&self.settings))
    }

    /// What comes after the last step.
    pub fn end(&mut self) -> Vec<String> {
        let lines = self.end_block.to_vec();
        self.numbered(lines)
    }

    /// A step: feed and rotate with the pin in, then pin out, bend, back, pin in. A part that is too small
    /// to be written is left out here and made up for by the next.
    pub fn step(&mut self, step: &Step) -> Result<Vec<String>, Unwritable> {
        Ok(self.segments(step)?.into_iter().flat_map(|segment| segment.lines).collect())
    }

    /// The same in segments. A move to a position (G90) makes up for a wrong one of its axis before it, so that each move
    /// of a bend ends a segment there; distances (G91) leave what is wrong in them to the end of the step.
    pub fn segments(&mut self, step: &Step) -> Result<Vec<Segment>, Unwritable> {
        let settings = Rc::clone(&self.settings);
        // A step that cannot be written leaves no trace.
        let (mut feed, mut rotate, mut bend) = (self.feed.clone(), self.rotate.clone(), self.bend.clone());
        let before = bend.exact;
        let mut lines = Vec::new();
        lines.extend(feed.by(step.feed_mm, &settings)?);
        lines.extend(rotate.by(step.rotate_deg, &settings)?);
        // The moves of the bend, and where each ends.
        let mut bends: Vec<(Vec<String>, f64)> = Vec::new();
        for part in parts(step.bend_deg, settings.arc_step_deg) {
            if let Some(line) = bend.to(before + part, &settings)? {
                let mut lines: Vec<String> =
                    dwell(settings.arc_dwell_s, !bends.is_empty()).into_iter().collect();
                lines.push(line);
                bends.push((lines, bend.written(&settings)));
            }
        }
        let mut segments = Vec::new();
        let end = |bend_at| [feed.written(&settings), rotate.written(&settings), bend_at];
        if !bends.is_empty() {
            if settings.bend_returns {
                let line = bend.to(before, &settings)?;
                bends.extend(line.map(|line| (vec![line], bend.written(&settings))));
            }
            lines.extend_from_slice(&settings.pin_out);
            lines.extend(dwell(settings.pin_dwell_s, !settings.pin_out.is_empty()));
            for (moves, bend_at) in bends {
                lines.extend(moves);
                if settings.mode == Mode::Absolute {
                    segments.push(Segment { lines: std::mem::take(&mut lines), end: end(bend_at) });
                }
            }
            lines.extend(pin_in_lines(&settings));
        } else if settings.bend_returns {
            bend.exact = before;
        }
        let end = end(bend.written(&settings));
        match segments.last_mut() {
            // What takes the pin in moves no axis.
            Some(last) => last.lines.append(&mut lines),
            None => segments.push(Segment { lines, end }),
        }
        (self.feed, self.rotate, self.bend) = (feed, rotate, bend);
        for segment in &mut segments {
            segment.lines = self.numbered(std::mem::take(&mut segment.lines));
        }
        Ok(segments)
    }

    fn numbered(&mut self, lines: Vec<String>) -> Vec<String> {
        if !self.settings.line_numbers {
            return lines;
        }
        let numbered = |line: String| {
            // A comment of its own, a mark such as %, a block number of the person's: not a block to number.
            if !line
                .trim_start()
                .starts_with(|c: char| c.is_ascii_alphabetic() && !c.eq_ignore_ascii_case(&'N'))
            {
                return line;
            }
            self.lines = if self.lines >= LAST_LINE { 1 } else { self.lines + 1 };
            format!("N{} {line}", self.lines)
        };
        lines.into_iter().map(numbered).collect()
    }
}

/// Ends of the moves that make a bend, counted from its start.
fn parts(bend_deg: f64, max_deg: f64) -> impl Iterator<Item = f64> {
    let count = if max_deg > 0.0 { (bend_deg.abs() / max_deg).ceil().max(1.0) } else { 1.0 };
    // A bend that is no number is one part, and is refused when it is written.
    let count = if count <= MAX_POSITION { count } else { 1.0 };
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // 1 to a million
    let whole = count as u32;
    (1..=whole).map(move |k| if k == whole { bend_deg } else { bend_deg * f64::from(k) / count })
}

/// The pin taken in.
pub(crate) fn pin_in_lines(settings: &Settings) -> impl Iterator<Item = String> {
    settings.pin_in.iter().cloned().chain(dwell(settings.pin_dwell_s, !settings.pin_in.is_empty()))
}

fn dwell(seconds: f64, wanted: bool) -> Option<String> {
    (wanted && seconds > 0.0).then(|| format!("G4 P{}", trimmed(seconds)))
}

impl AxisAt {
    /// Where it is as written, in units of the machine.
    fn written(&self, settings: &Settings) -> f64 {
        #[allow(clippy::cast_precision_loss)] // at most a million with four digits
        let last_digits = self.written as f64;
        last_digits / 10f64.powi(i32::from(settings.decimals))
    }

    fn by(&mut self, amount: f64, settings: &Settings) -> Result<Option<String>, Unwritable> {
        if !amount.is_finite() {
            return Err(Unwritable::NotFinite { what: self.what, value: amount });
        }
        self.to(self.exact + amount, settings)
    }

    /// The move to a place, unless it is where the axis is as far as digits show.
    fn to(&mut self, place: f64, settings: &Settings) -> Result<Option<String>, Unwritable> {
        let position = place * self.units;
        if position.is_nan() {
            return Err(Unwritable::NotFinite { what: self.what, value: place });
        }
        if position.abs() > MAX_POSITION {
            return Err(Unwritable::TooFar { what: self.what, position });
        }
        #[allow(clippy::cast_possible_truncation)] // at most a million with four digits
        let written = (position * 10f64.powi(i32::from(settings.decimals))).round() as i64;
        let moved = written - self.written;
        (self.exact, self.written) = (place, written);
        if moved == 0 {
            return Ok(None);
        }
        let number = digits(
            match settings.mode {
                Mode::Relative => moved,
                Mode::Absolute => written,
            },
            settings.decimals,
        );
        Ok(Some(match settings.moves {
            Moves::FeedRate => format!("G1 {}{number} F{}", self.letter.letter(), trimmed(self.rate)),
            Moves::Rapid => format!("G0 {}{number}", self.letter.letter()),
        }))
    }
}

/// A whole number of last digits as a decimal number. Zero has no sign.
pub(crate) fn digits(number: i64, decimals: u8) -> String {
    let sign = if number < 0 { "-" } else { "" };
    let places = usize::from(decimals);
    let size = format!("{:0width$}", number.unsigned_abs(), width = places + 1);
    let (whole, part) = size.split_at(size.len() - places);
    if part.is_empty() { format!("{sign}{whole}") } else { format!("{sign}{whole}.{part}") }
}

/// A number with up to three decimals and no zeros at its end.
pub(crate) fn trimmed(number: f64) -> String {
    let text = format!("{number:.3}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_without_a_minus_zero() {
        assert_eq!(digits(0, 3), "0.000");
        assert_eq!(digits(-5, 3), "-0.005");
        assert_eq!(digits(60_000, 3), "60.000");
        assert_eq!(digits(-45, 0), "-45");
        assert_eq!(
            (trimmed(500.0), trimmed(0.25), trimmed(60.0)),
            ("500".into(), "0.25".into(), "60".into())
        );
    }

    #[test]
    fn a_bend_is_divided_into_equal_parts_that_end_where_it_does() {
        assert_eq!(parts(90.0, 0.0).collect::<Vec<_>>(), [90.0]);
        assert_eq!(parts(-90.0, 40.0).collect::<Vec<_>>(), [-30.0, -60.0, -90.0]);
        assert_eq!(parts(0.0, 10.0).collect::<Vec<_>>(), [0.0]);
        assert_eq!(parts(f64::INFINITY, 10.0).collect::<Vec<_>>(), [f64::INFINITY]);
    }

    #[test]
    fn a_step_that_cannot_be_written_leaves_no_trace() {
        let names = Names {
            name: "sample".to_owned(),
            design: "a5".to_owned(),
            job: "5a".to_owned(),
            machine: "sample-bender".to_owned(),
            wire: 0,
            steps: 2,
            stock_mm: None,
        };
        let mut program = Program::new(Rc::new(Settings::default()), &names).unwrap();
        let bad = Step { feed_mm: 5.0, rotate_deg: 0.0, bend_deg: f64::NAN, approach_deg: None };
        assert!(matches!(program.step(&bad), Err(Unwritable::NotFinite { what: "bend", .. })));
        let far = Step { feed_mm: 2e6, ..Step::default() };
        let said = program.step(&far).expect_err("two kilometres").to_string();
        assert_eq!(said, "its feed ends at 2000000 units of the machine, more than 1000000");
        let good = Step { feed_mm: 5.0, ..Step::default() };
        assert_eq!(program.step(&good), Ok(vec!["G1 X5.000 F500".to_owned()]));
    }
}
