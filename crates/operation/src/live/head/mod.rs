//! Where a machine's head stands, from one connection to the next: what is known, what a person has to say, what they read.

mod record;

use std::fmt;
use std::path::PathBuf;

use wirebend_driver_host::{HeadPlace, Session};

use super::person::Zero;
use crate::error::{HeadProblem, LiveProblem};
pub(super) use record::{HeadRecord, Keeper, read};
use wirebend_planning::report::shown_deg;
use wirebend_planning::signs::Signs;

/// What the user is asked where it is not known.
pub const QUESTION: &str = "Where does the head stand, in degrees from its zero?";
/// A limit is one of a profile, an angle a sum of turns.
const ROUNDING_DEG: f64 = 1e-6;

/// What is known of the head besides where it stands.
#[derive(Debug, Clone)]
pub struct Known {
    pub signs: Signs,
    /// How far its cable lets it turn, degrees in canonical signs.
    pub limits: [f64; 2],
    /// Where it stood when that was read or said.
    pub kept: HeadPlace,
    /// Where that is known from.
    pub source: Option<HeadSource>,
}

/// Where it is known from how a head stands.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum HeadSource {
    /// A person has said it.
    Said,
    /// Its record.
    Recorded { at: String },
    /// Its record cannot be read.
    Damaged { path: PathBuf },
    /// The record of a machine of this kind at a port that is gone.
    OtherPort { at: String, port: String },
}

impl fmt::Display for HeadSource {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Said => f.write_str("as you have said"),
            Self::Recorded { at } => f.write_str(at),
            Self::Damaged { path } => write!(f, "its record {} is damaged", path.display()),
            Self::OtherPort { at, port } => {
                write!(f, "{at}: a machine of this kind was at {port} then, which is gone")
            }
        }
    }
}

/// What a person is asked about the head.
#[derive(Debug, Clone, PartialEq)]
pub struct HeadQuestion {
    /// What they have to know.
    pub lines: Vec<String>,
    /// The least and the most that they can say, degrees in canonical signs.
    pub range: [f64; 2],
    /// Where it was left, where that is known: they see whether it still stands there.
    pub left_at: Option<f64>,
}

/// For a person.
fn shown(deg: f64) -> String {
    format!("{:.1}°", shown_deg(deg))
}

impl Known {
    /// Least and most, in canonical signs.
    pub fn range(&self, place: HeadPlace) -> [f64; 2] {
        let (a, b) = place.range();
        let (a, b) = (self.signs.head(a), self.signs.head(b));
        [a.min(b), a.max(b)]
    }

    /// Where it stands, for a person.
    pub fn stands(&self, place: HeadPlace) -> String {
        let [least, most] = self.range(place);
        let source = self.source.as_ref().filter(|_| place == self.kept);
        let source = source.map_or_else(String::new, |source| format!(" ({source})"));
        match place {
            HeadPlace::Unsaid => format!("nothing is known of where it stands{source}"),
            HeadPlace::At(_) => format!("it was left at {} from its zero{source}", shown(least)),
            HeadPlace::Between(..) => {
                format!("it was left between {} and {} from its zero{source}", shown(least), shown(most))
            }
        }
    }

    pub fn holds(&self, deg: f64) -> bool {
        let [least, most] = self.limits;
        (least - ROUNDING_DEG..=most + ROUNDING_DEG).contains(&deg)
    }

    /// Whether a person has said where it stands, and it stands there still.
    pub fn was_said(&self, place: HeadPlace) -> bool {
        self.source == Some(HeadSource::Said) && place == self.kept
    }

    /// What a person says of where it stands, degrees in canonical signs.
    pub fn say(&mut self, session: &mut Session, deg: f64) -> Result<(), LiveProblem> {
        let [least, most] = self.limits;
        if !self.holds(deg) {
            return Err(HeadProblem::Beyond { deg, least, most }.into());
        }
        session.head_stands_at(self.signs.head(deg))?;
        (self.kept, self.source) = (session.head_place(), Some(HeadSource::Said));
        Ok(())
    }
}

/// What a person has to know before they say that every axis stands at zero. `known`: nothing of a simulated machine.
pub(super) fn zero_lines(session: &Session, known: Option<&Known>, wanted: Zero) -> Vec<String> {
    let mut lines = wanted.lines();
    let place = session.head_place();
    if let Some(known) = known.filter(|_| !place.is_zero() && wanted == Zero::Wire) {
        lines.push(format!("the head: {}; unwind its cable first", known.stands(place)));
    }
    lines
}

/// Why the word that every axis stands at zero does not count for a head that was left elsewhere.
pub(super) fn contradiction(session: &Session, known: Option<&Known>) -> Option<LiveProblem> {
    let place = session.head_place();
    let known = known.filter(|_| !place.is_zero())?;
    Some(HeadProblem::Turned { what: known.stands(place) }.into())
}
