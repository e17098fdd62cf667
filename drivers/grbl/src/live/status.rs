//! The report that answers `?`: `<Idle|MPos:0.000,0.000,0.000|FS:0,0|WCO:0.000,0.000,0.000>`.

use super::speeds::Speeds;

/// What the machine is doing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum State {
    Idle,
    Run,
    /// Slowing down, or at rest and ready to resume.
    Hold {
        at_rest: bool,
    },
    Jog,
    Alarm,
    /// The safety door is or was open.
    Door {
        at_rest: bool,
    },
    Check,
    Home,
    Sleep,
}

impl State {
    fn of(text: &str) -> Option<Self> {
        let (name, part) = text.split_once(':').map_or((text, None), |(name, part)| (name, Some(part)));
        Some(match name {
            "Idle" => Self::Idle,
            "Run" => Self::Run,
            "Hold" => Self::Hold { at_rest: part == Some("0") },
            "Jog" => Self::Jog,
            "Alarm" => Self::Alarm,
            // 0 closed and ready to resume, 1 open, 2 slowing down, 3 resuming.
            "Door" => Self::Door { at_rest: matches!(part, Some("0" | "1")) },
            "Check" => Self::Check,
            "Home" => Self::Home,
            "Sleep" => Self::Sleep,
            _ => return None,
        })
    }

    /// Its name for people.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Idle => "Idle",
            Self::Run => "Run",
            Self::Hold { .. } => "Hold",
            Self::Jog => "Jog",
            Self::Alarm => "Alarm",
            Self::Door { .. } => "Door",
            Self::Check => "Check",
            Self::Home => "Home",
            Self::Sleep => "Sleep",
        }
    }
}

/// Where the axes are, in the order of the machine, in its units.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Position {
    /// `MPos`: from the machine's own zero.
    Machine(Vec<f64>),
    /// `WPos`: from the program's zero.
    Work(Vec<f64>),
}

#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Status {
    pub state: State,
    pub position: Position,
    /// From the machine's zero to the program's: now and then only.
    pub offset: Option<Vec<f64>>,
    /// How fast feeds are, percent of what the program says, and rapid moves: now and then only.
    pub(super) speeds: Option<Speeds>,
}

impl Status {
    /// A report without its brackets; nothing when it has no state or no position that can be read.
    pub fn of(report: &str) -> Option<Self> {
        let mut fields = report.split('|');
        let state = State::of(fields.next()?)?;
        let (mut position, mut offset, mut speeds) = (None, None, None);
        for field in fields {
            let (name, values) = field.split_once(':').unwrap_or((field, ""));
            match name {
                "MPos" => position = Some(Position::Machine(numbers(values)?)),
                "WPos" => position = Some(Position::Work(numbers(values)?)),
                "WCO" => offset = Some(numbers(values)?),
                // What it does to the spindle comes after them.
                "Ov" => speeds = Speeds::reported(values),
                // Buffers, rates and pins are not needed.
                _ => {}
            }
        }
        Some(Self { state, position: position?, offset, speeds })
    }
}

/// As many as a machine may have axes; all of them finite.
fn numbers(values: &str) -> Option<Vec<f64>> {
    let numbers: Vec<f64> = values
        .split(',')
        .map(|value| value.parse().ok().filter(|number: &f64| number.is_finite()))
        .collect::<Option<_>>()?;
    (3..=9).contains(&numbers.len()).then_some(numbers)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn state(report: &str) -> Option<State> {
        Status::of(&format!("{report}|MPos:1.000,-2.500,0.000|FS:0,0")).map(|status| status.state)
    }

    #[test]
    fn every_state_is_read() {
        for (text, expected) in [
            ("Idle", State::Idle),
            ("Run", State::Run),
            ("Hold:0", State::Hold { at_rest: true }),
            ("Hold:1", State::Hold { at_rest: false }),
            ("Jog", State::Jog),
            ("Alarm", State::Alarm),
            ("Door:0", State::Door { at_rest: true }),
            ("Door:1", State::Door { at_rest: true }),
            ("Door:2", State::Door { at_rest: false }),
            ("Door:3", State::Door { at_rest: false }),
            ("Check", State::Check),
            ("Home", State::Home),
            ("Sleep", State::Sleep),
        ] {
            assert_eq!(state(text), Some(expected));
            assert!(text.starts_with(expected.name()));
        }
        assert_eq!(state("Rest"), None);
    }

    #[test]
    fn both_kinds_of_position_are_read_with_fields_in_any_order() {
        let status = Status::of("Run|Bf:15,128|WCO:1.000,0.000,-3.000|WPos:0.000,1.500,2.000|Ov:100,100,100");
        let status = status.expect("a report");
        assert_eq!(status.position, Position::Work(vec![0.0, 1.5, 2.0]));
        assert_eq!(status.offset, Some(vec![1.0, 0.0, -3.0]));
        let four = Status::of("Idle|MPos:1,2,3,4").expect("a report");
        assert_eq!((four.position, four.offset), (Position::Machine(vec![1.0, 2.0, 3.0, 4.0]), None));
    }

    #[test]
    fn a_report_that_lost_something_is_none() {
        for report in ["", "Idle", "Idle|FS:0,0", "Idle|MPos:1,2", "Idle|MPos:1,2,x", "Idle|MPos:1,2,NaN"] {
            assert_eq!(Status::of(report), None, "{report}");
        }
    }
}
