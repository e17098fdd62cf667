//! What a person can set. The comments of the fields are shown in a form.

mod check;
mod refusal;
mod template;

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_driver_api::DriverError;

pub(crate) use template::Names;
pub(crate) use template::clean;

/// How programs are written, and how the machine is spoken to.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Settings {
    /// Letter of the axis that feeds the wire. Stock grbl has X, Y and Z only.
    pub feed_axis: Letter,
    /// Letter of the axis that turns the wire or the head about the wire.
    pub rotate_axis: Letter,
    /// Letter of the axis that bends.
    pub bend_axis: Letter,
    /// Whether moves are written as distances (G91) or as positions (G90). Positions count from where the machine stands when the program starts (G92).
    pub mode: Mode,
    /// Whether axes move at the rates below (G1) or as fast as the machine's settings allow (G0).
    pub moves: Moves,
    /// Rate of the feed, mm/min.
    #[schemars(range(min = 0.01, max = 100_000.0))]
    pub feed_rate_mm_per_min: f64,
    /// Rate of the rotation, degrees/min.
    #[schemars(range(min = 0.01, max = 100_000.0))]
    pub rotate_rate_deg_per_min: f64,
    /// Rate of the bend, degrees/min.
    #[schemars(range(min = 0.01, max = 100_000.0))]
    pub bend_rate_deg_per_min: f64,
    /// Units of the machine's feed axis for each mm of wire; 1 when its steps are set for mm.
    #[schemars(range(min = 0.0001, max = 10_000.0))]
    pub feed_units_per_mm: f64,
    /// Units of the machine's rotation axis for each degree; 1 when its steps are set for degrees.
    #[schemars(range(min = 0.0001, max = 10_000.0))]
    pub rotate_units_per_deg: f64,
    /// Units of the machine's bend axis for each degree; 1 when its steps are set for degrees.
    #[schemars(range(min = 0.0001, max = 10_000.0))]
    pub bend_units_per_deg: f64,
    /// Digits behind the decimal point of moves, 0 to 4. What rounding takes from one move the next one gets.
    #[schemars(range(min = 0, max = 4))]
    pub decimals: u8,
    /// Lines that put the bend pin out.
    pub pin_out: Vec<String>,
    /// Lines that take the bend pin in. They are sent at the start of a program, too.
    pub pin_in: Vec<String>,
    /// How long to wait for the pin after it was put out or taken in, s.
    #[schemars(range(min = 0.0, max = 60.0))]
    pub pin_dwell_s: f64,
    /// Lines that cut the wire and take the cutter back, such as M8, G4 P1, M9; none where the machine has no cutter.
    pub cut: Vec<String>,
    /// Where the cutter is: how far its blade is, along the feed, from the place where the tip of a wire is as that begins, mm. Below zero it is inside the machine, and the wire is pulled back to it.
    #[schemars(range(min = -1000.0, max = 1000.0))]
    pub cutter_mm: f64,
    /// Whether the bend axis goes back to where it was before the pin is taken in. Without it each bend counts from where the one before has ended.
    pub bend_returns: bool,
    /// The largest angle that is bent in one move, degrees; at least 0.1; 0 does every bend in one move.
    #[schemars(range(min = 0.0, max = 360.0))]
    pub arc_step_deg: f64,
    /// Pause between the parts of a bend, s.
    #[schemars(range(min = 0.0, max = 60.0))]
    pub arc_dwell_s: f64,
    /// Lines before the program. `{name}`, `{design}`, `{job}` and `{machine}` may stand in comments; `{wire}`, counted from 1, `{steps}` and `{stock_mm}` anywhere.
    pub start_block: Vec<String>,
    /// Lines after the program, with the same placeholders.
    pub end_block: Vec<String>,
    /// How comments are written into files; none leaves them out. The lines of the blocks stay as they are.
    pub comments: Comments,
    /// Whether the lines of a program are numbered (N1, N2, …).
    pub line_numbers: bool,
    /// Speed of the serial port, baud. 115200 is grbl's own.
    #[schemars(range(min = 300, max = 4_000_000))]
    pub baud: u32,
    /// How lines are handed to the machine.
    pub streaming: Streaming,
    /// How the machine finds its reference.
    pub homing: Homing,
    /// What settings of the machine have to be, such as {"$100": 80.0}. What differs is shown when the program connects.
    pub expected: BTreeMap<String, f64>,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            feed_axis: Letter::X,
            rotate_axis: Letter::Y,
            bend_axis: Letter::Z,
            mode: Mode::default(),
            moves: Moves::default(),
            // What $110 to $112 are on a machine whose settings were not changed.
            feed_rate_mm_per_min: 500.0,
            rotate_rate_deg_per_min: 500.0,
            bend_rate_deg_per_min: 500.0,
            feed_units_per_mm: 1.0,
            rotate_units_per_deg: 1.0,
            bend_units_per_deg: 1.0,
            decimals: 3,
            // $30, the speed at which the spindle output is fully on, is 1000 by default.
            pin_out: vec!["M3 S1000".to_owned()],
            pin_in: vec!["M5".to_owned()],
            pin_dwell_s: 0.3,
            cut: Vec::new(),
            cutter_mm: 0.0,
            bend_returns: true,
            arc_step_deg: 0.0,
            arc_dwell_s: 0.0,
            start_block: Vec::new(),
            end_block: Vec::new(),
            comments: Comments::default(),
            line_numbers: false,
            baud: 115_200,
            streaming: Streaming::default(),
            homing: Homing::default(),
            expected: BTreeMap::new(),
        }
    }
}

/// A letter of an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[allow(missing_docs)] // they are letters
pub enum Letter {
    X,
    Y,
    Z,
    A,
    B,
    C,
    U,
    V,
    W,
}

impl Letter {
    pub(crate) const fn letter(self) -> char {
        match self {
            Self::X => 'X',
            Self::Y => 'Y',
            Self::Z => 'Z',
            Self::A => 'A',
            Self::B => 'B',
            Self::C => 'C',
            Self::U => 'U',
            Self::V => 'V',
            Self::W => 'W',
        }
    }

    /// Its place in the positions that the machine reports.
    pub(crate) const fn index(self) -> usize {
        self as usize
    }
}

/// What the numbers of moves are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Mode {
    /// Distances, G91.
    #[default]
    Relative,
    /// Positions, G90.
    Absolute,
}

/// How fast axes move.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Moves {
    /// At the rates that are set here, G1.
    #[default]
    FeedRate,
    /// At the machine's own, G0.
    Rapid,
}

/// How comments are marked in files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Comments {
    /// (comment)
    #[default]
    Parentheses,
    /// ; comment
    Semicolon,
    /// No comments.
    None,
}

/// How lines are handed to the machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Streaming {
    /// The next line after the answer to the one before.
    #[default]
    OneLineAtATime,
    /// As many lines as the machine's receive buffer of 128 bytes holds.
    CharacterCounting,
}

/// How the machine finds its reference.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Homing {
    /// With $H, by its switches. Stock grbl homes every axis, the feed too: it needs a build that homes those with switches only.
    Switches,
    /// Homing says that the axes stand at zero now. A person has put them there; nothing moves.
    #[default]
    None,
}

impl Settings {
    /// Refuses values that make no sense, by key.
    pub(crate) fn check(&self) -> Result<(), DriverError> {
        check::check(self)
    }

    /// Letters of the axes and their keys: feed, rotate, bend.
    pub(crate) const fn axes(&self) -> [(&'static str, Letter); 3] {
        [("feed_axis", self.feed_axis), ("rotate_axis", self.rotate_axis), ("bend_axis", self.bend_axis)]
    }
}
