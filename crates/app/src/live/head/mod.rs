//! Where a machine's head stands, from one connection to the next: what is known, what a person has to say, what they read.

mod problem;
mod record;

use std::path::Path;

use wirebend_driver_host::api::{Capability, HeadBy, ReferenceBy};
use wirebend_driver_host::{HeadPlace, Session};
use wirebend_profile::MachineProfile;

use super::LiveProblem;
use super::connect::Connection;
use super::hearing::Hearing;
use super::person::{Yes, Zero};
use crate::drivers::Signs;
use crate::report::shown_deg;
use crate::{App, News};
pub use problem::HeadProblem;
use record::{Keeper, Kept};

/// What a person is asked where nobody knows it.
pub(crate) const QUESTION: &str = "Where does the head stand, in degrees from its zero?";
/// When it was heard of where a person has looked.
const SAID: &str = "as you have said";
/// A limit is one of a profile, an angle a sum of turns.
const ROUNDING_DEG: f64 = 1e-6;

/// What is known of the head besides where it stands.
#[derive(Debug, Clone)]
pub(crate) struct Known {
    signs: Signs,
    /// How far its cable lets it turn, degrees in canonical signs.
    pub limits: [f64; 2],
    /// Where it stood when that was read or said.
    kept: HeadPlace,
    /// When that was, and what has to be known of it.
    heard: Option<String>,
}

/// What a person is asked about the head.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct HeadQuestion {
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
    fn range(&self, place: HeadPlace) -> [f64; 2] {
        let (a, b) = place.range();
        let (a, b) = (self.signs.head(a), self.signs.head(b));
        [a.min(b), a.max(b)]
    }

    /// Where it stands, for a person.
    fn stands(&self, place: HeadPlace) -> String {
        let [least, most] = self.range(place);
        let heard = self.heard.as_ref().filter(|_| place == self.kept);
        let heard = heard.map_or_else(String::new, |heard| format!(" ({heard})"));
        match place {
            HeadPlace::Unsaid => format!("nothing is known of where it stands{heard}"),
            HeadPlace::At(_) => format!("it was left at {} from its zero{heard}", shown(least)),
            HeadPlace::Between(..) => {
                format!("it was left between {} and {} from its zero{heard}", shown(least), shown(most))
            }
        }
    }

    fn holds(&self, deg: f64) -> bool {
        let [least, most] = self.limits;
        (least - ROUNDING_DEG..=most + ROUNDING_DEG).contains(&deg)
    }

    /// What a person says of where it stands, degrees in canonical signs.
    fn say(&mut self, session: &mut Session, deg: f64) -> Result<(), LiveProblem> {
        let [least, most] = self.limits;
        if !self.holds(deg) {
            return Err(HeadProblem::Beyond { deg, least, most }.into());
        }
        let said = Yes::where_nothing_moves().confirmed()?;
        session.head_stands_at(self.signs.head(deg), &said)?;
        (self.kept, self.heard) = (session.head_place(), Some(SAID.to_owned()));
        Ok(())
    }
}

impl App {
    /// Has the place of the head kept from now on, and looks what was kept of it before. A simulated machine is a new one
    /// each time.
    pub(super) fn know_head(&self, profile: &MachineProfile, connection: &mut Connection) {
        let Some(runs) = &self.runs else { return };
        let limit = |figure: &Option<wirebend_profile::Sourced<f64>>, none| {
            figure.as_ref().map_or(none, |figure| figure.value)
        };
        let limits = [
            limit(&profile.limits.min_rotation_deg, f64::NEG_INFINITY),
            limit(&profile.limits.max_rotation_deg, f64::INFINITY),
        ];
        let ports = connection.session.driver().ports().unwrap_or_default();
        if connection.unnamed || ports.iter().any(|port| port.simulated && port.name == connection.port) {
            return;
        }
        let is_there = |name: &str| ports.iter().any(|port| port.name == name) || Path::new(name).exists();
        let Kept { place, heard } = record::read(runs, &profile.id, &connection.port, limits, is_there);
        connection.hearing.head = Some(Known { signs: connection.hearing.signs, limits, kept: place, heard });
        let keeper = Keeper::new(runs, &profile.id, &connection.port);
        connection.session.keep_head(place, Box::new(keeper));
    }
}

/// Whether the machine can turn its head to zero by itself.
fn finds_zero(session: &Session) -> bool {
    session.driver().description().can(Capability::Home)
}

impl Connection<'_> {
    /// What a person has to be asked before this machine is homed, since it does not know it itself.
    pub fn head_question(&self) -> Option<HeadQuestion> {
        let known = self.hearing.head.as_ref()?;
        let place = self.session.head_place();
        if place.is_zero() || (finds_zero(&self.session) && self.session.counts_its_head()) {
            return None;
        }
        let left_at = if let HeadPlace::At(deg) = place { Some(self.signs().head(deg)) } else { None };
        let said = known.heard.as_deref() == Some(SAID) && place == known.kept;
        if left_at.is_some() && (said || !finds_zero(&self.session)) {
            return None;
        }
        let first = match left_at {
            Some(_) => format!("the head of this machine is turned: {}", known.stands(place)),
            None => format!("nobody knows where the head of this machine stands: {}", known.stands(place)),
        };
        let second = "look at it, and count from where its cable is unwound, whole turns too; or switch the motors off, turn it \
                      back there by hand, and say 0";
        Some(HeadQuestion { lines: vec![first, second.to_owned()], range: known.limits, left_at })
    }

    const fn signs(&self) -> Signs {
        self.hearing.signs
    }

    /// What a person says of where the head stands.
    pub fn head_said(&mut self, deg: f64) -> Result<(), LiveProblem> {
        match &mut self.hearing.head {
            Some(known) => known.say(&mut self.session, deg),
            // A simulated one stands where it was made to.
            None => Ok(()),
        }
    }

    /// Sees to it that the place of the head is known before anything moves. `said`: what a person has said already;
    /// `confirmed`: they are not asked whether it still stands where it was left.
    pub fn settle_head(&mut self, said: Option<f64>, confirmed: bool) -> Result<(), LiveProblem> {
        if let Some(deg) = said {
            self.head_said(deg)?;
        }
        let question = self.head_question().filter(|question| question.left_at.is_none() || !confirmed);
        if let Some(HeadQuestion { lines, range, left_at }) = question {
            self.hearing.progress.news(&News::About { lines: lines.clone() });
            match self.hearing.progress.place_of_head(QUESTION, range, left_at) {
                Some(deg) => self.head_said(deg)?,
                // Nobody is there: whoever may be is asked whether the machine may move.
                None if left_at.is_some() => {}
                None => {
                    let what = lines.into_iter().next().unwrap_or_default();
                    return Err(HeadProblem::Unknown { what }.into());
                }
            }
        }
        self.require_head_unturned()
    }

    /// A machine that cannot turn its head back has it where a wire begins, or it is not moved.
    pub fn require_head_unturned(&self) -> Result<(), LiveProblem> {
        let place = self.session.head_place();
        match &self.hearing.head {
            Some(known) if !finds_zero(&self.session) && !place.is_zero() => {
                Err(HeadProblem::Turned { what: known.stands(place) }.into())
            }
            _ => Ok(()),
        }
    }

    /// What a person has to know of the head before they let the machine move. `homes`: its reference is found first.
    pub fn head_lines(&self, homes: bool) -> Vec<String> {
        let Some(known) = &self.hearing.head else { return Vec::new() };
        let place = self.session.head_place();
        let line = match (self.session.head_by(), self.session.reference()) {
            // They are asked.
            (HeadBy::Reference, ReferenceBy::Person) => None,
            _ if place == HeadPlace::Unsaid && (homes || !finds_zero(&self.session)) => Some(
                "the head is taken to stand at zero, with its cable unwound: turn it there first if it does not"
                    .to_owned(),
            ),
            (HeadBy::Program | HeadBy::Kept, _) if homes && !place.is_zero() => Some(format!(
                "the head is turned back to zero first: {}",
                known.stands(place)
            )),
            _ => None,
        };
        line.into_iter().collect()
    }

    /// What a person has to know before they say that every axis stands at zero.
    pub fn zero_lines(&self, wanted: Zero) -> Vec<String> {
        zero_lines(&self.session, &self.hearing, wanted)
    }

    /// Refuses a turn by hand, in canonical signs, that the head's cable does not allow.
    pub fn require_turn(&self, by: f64) -> Result<(), LiveProblem> {
        let (Some(known), HeadPlace::At(_)) = (&self.hearing.head, self.session.head_place()) else {
            return Ok(());
        };
        let [from, _] = known.range(self.session.head_place());
        let [least, most] = known.limits;
        // Back towards zero is always possible.
        if known.holds(from + by) || (from + by).abs() < from.abs() {
            return Ok(());
        }
        Err(HeadProblem::TooFar { from, to: from + by, least, most }.into())
    }
}

pub(super) fn zero_lines(session: &Session, hearing: &Hearing, wanted: Zero) -> Vec<String> {
    let mut lines = wanted.lines();
    let place = session.head_place();
    if let Some(known) = hearing.head.as_ref().filter(|_| !place.is_zero() && wanted == Zero::Wire) {
        lines.push(format!("the head: {}; unwind its cable first", known.stands(place)));
    }
    lines
}

/// Why the word that every axis stands at zero does not count for a head that was left elsewhere.
pub(super) fn contradiction(session: &Session, hearing: &Hearing) -> Option<LiveProblem> {
    let place = session.head_place();
    let known = hearing.head.as_ref().filter(|_| !place.is_zero())?;
    Some(HeadProblem::Turned { what: known.stands(place) }.into())
}
