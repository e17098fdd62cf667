//! What has to be settled about the head of a connected machine before it moves.

use std::path::Path;

use wirebend_driver_host::api::{Capability, HeadBy, ReferenceBy};
use wirebend_driver_host::{HeadPlace, Session};
use wirebend_profile::MachineProfile;

use super::connection::Connection;
use super::head::{self, HeadQuestion, HeadRecord, Keeper, Known, QUESTION};
use super::person::Zero;
use crate::MachineEvent;
use crate::error::{HeadProblem, LiveProblem};
use wirebend_planning::signs::Signs;

/// Has the place of the head kept from now on, and looks what was kept of it before. A simulated machine is a new one
/// each time.
pub(super) fn know_head(runs: Option<&Path>, profile: &MachineProfile, connection: &mut Connection) {
    let Some(runs) = runs else { return };
    let limit = |figure: &Option<wirebend_profile::Sourced<f64>>, none| {
        figure.as_ref().map_or(none, |figure| figure.value)
    };
    let limits = [
        limit(&profile.limits.min_rotation_deg, f64::NEG_INFINITY),
        limit(&profile.limits.max_rotation_deg, f64::INFINITY),
    ];
    if connection.session.simulated().is_some() {
        return;
    }
    let ports = connection.session.driver().ports().unwrap_or_default();
    let is_there = |name: &str| ports.iter().any(|port| port.name == name) || Path::new(name).exists();
    let signs = connection.observer.signs;
    let HeadRecord { place, source } =
        head::read(runs, &profile.id, &connection.port, in_machine_signs(signs, limits), is_there);
    connection.observer.head = Some(Known { signs, limits, kept: place, source });
    let keeper = Keeper::new(runs, &profile.id, &connection.port);
    connection.session.keep_head(place, Box::new(keeper));
}

/// Limits in canonical signs as the machine counts: where it turns the other way round, the least is the most.
fn in_machine_signs(signs: Signs, limits: [f64; 2]) -> [f64; 2] {
    let [a, b] = limits.map(|limit| signs.head(limit));
    [a.min(b), a.max(b)]
}

/// Whether the machine can turn its head to zero by itself.
fn finds_zero(session: &Session) -> bool {
    session.driver().description().can(Capability::Home)
}

impl Connection<'_> {
    /// What a person has to be asked before this machine is homed, since it does not know it itself.
    pub fn head_question(&self) -> Option<HeadQuestion> {
        let known = self.observer.head.as_ref()?;
        let place = self.session.head_place();
        if place.is_zero() || (finds_zero(&self.session) && self.session.counts_its_head()) {
            return None;
        }
        let left_at = if let HeadPlace::At(deg) = place { Some(self.signs().head(deg)) } else { None };
        let said = known.was_said(place);
        if left_at.is_some() && (said || !finds_zero(&self.session)) {
            return None;
        }
        let first = match left_at {
            Some(_) => format!("the head of this machine is turned: {}", known.stands(place)),
            None => format!("it is not known where the head of this machine stands: {}", known.stands(place)),
        };
        let second = "look at it, and count from where its cable is unwound, whole turns too; or switch the motors off, turn it \
                      back there by hand, and say 0";
        Some(HeadQuestion { lines: vec![first, second.to_owned()], range: known.limits, left_at })
    }

    const fn signs(&self) -> Signs {
        self.observer.signs
    }

    /// What a person says of where the head stands.
    pub fn head_said(&mut self, deg: f64) -> Result<(), LiveProblem> {
        match &mut self.observer.head {
            Some(known) => known.say(&mut self.session, deg),
            // A simulated one stands where it was moved to.
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
            self.observer.progress.event(&MachineEvent::About { lines: lines.clone() });
            match self.observer.progress.place_of_head(QUESTION, range, left_at) {
                Some(deg) => self.head_said(deg)?,
                // No answer: the question whether the machine may move comes next anyway.
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
        match &self.observer.head {
            Some(known) if !finds_zero(&self.session) && !place.is_zero() => {
                Err(HeadProblem::Turned { what: known.stands(place) }.into())
            }
            _ => Ok(()),
        }
    }

    /// What a person has to know of the head before they let the machine move. `homes`: its reference is found first.
    pub fn head_lines(&self, homes: bool) -> Vec<String> {
        let Some(known) = &self.observer.head else { return Vec::new() };
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
        head::zero_lines(&self.session, self.observer.head.as_ref(), wanted)
    }

    /// Refuses a turn by hand, in canonical signs, that the head's cable does not allow.
    pub fn require_turn(&self, by: f64) -> Result<(), LiveProblem> {
        let (Some(known), HeadPlace::At(_)) = (&self.observer.head, self.session.head_place()) else {
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
