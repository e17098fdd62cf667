//! The contacts of a program.

use std::ops::{ControlFlow, Range};

use wirebend_collide::{Task, closest};

use super::asked::{Asked, Strokes};
use super::body::Body;
use super::contact::{Contact, FirstContact, Obstacle};
use super::stroke::Phase;
use super::wire::Clearance;
use crate::units::Length;

/// How contacts are looked for, from one step to the next.
struct Look {
    /// Whether what is found is hit.
    hits: bool,
    margin: Length,
    /// What was met in the step before.
    met: Vec<Obstacle>,
}

/// Adds a contact to the first ones: of what is hit anywhere the first hit, of all else where it is first near.
fn add(found: &mut Vec<FirstContact>, first: FirstContact) {
    let known = found.iter_mut().find(|known| known.contact.obstacle == first.contact.obstacle);
    match known {
        None => found.push(first),
        Some(known) if known.hits == first.hits => known.later += 1 + first.later,
        Some(known) if first.hits => *known = first,
        Some(_) => {}
    }
}

/// How exact depths are, mm, and as a share of how far what is hit is gone into.
const DEPTH_EXACT: f64 = 0.02;
const DEPTH_SHARE: f64 = 0.05;

impl Clearance<'_> {
    /// The first contact with each thing that the wire meets, in the order of its steps.
    #[must_use]
    pub fn first_contacts(self) -> Vec<FirstContact> {
        self.first_contacts_while(|_| true).unwrap_or_default()
    }

    /// The same for whoever may be stopped: `goes_on` is asked before each step, with its index. `None` where it does not.
    #[must_use]
    pub fn first_contacts_while(mut self, goes_on: impl FnMut(usize) -> bool) -> Option<Vec<FirstContact>> {
        let all = self.first_contacts_in(0..self.steps(), goes_on)?;
        Some(self.merged([all]))
    }

    /// The same of some steps, so that several threads can share a long wire. How deep they are is not measured yet: what is found of
    /// steps that follow one another gives the whole by [`Clearance::merged`].
    pub fn first_contacts_in(
        &mut self,
        steps: Range<usize>,
        mut goes_on: impl FnMut(usize) -> bool,
    ) -> Option<Vec<FirstContact>> {
        let margin = self.wire.margin;
        // What is near in one step must not hide what is hit in a later one.
        let mut looks = vec![Look { hits: true, margin: Length::ZERO, met: Vec::new() }];
        if margin > Length::ZERO {
            looks.push(Look { hits: false, margin, met: Vec::new() });
        }
        if let Some(before) = steps.start.checked_sub(1) {
            // What it meets already is no new contact.
            for look in &mut looks {
                self.looked(look, before);
            }
        }
        let mut found: Vec<FirstContact> = Vec::new();
        for step in steps {
            if !goes_on(step) {
                return None;
            }
            for look in &mut looks {
                for contact in self.looked(look, step) {
                    add(&mut found, FirstContact { contact, depth: Length::ZERO, later: 0, hits: look.hits });
                }
            }
        }
        Some(found)
    }

    /// The contacts of a step, as a look has them.
    fn looked(&mut self, look: &mut Look, step: usize) -> Vec<Contact> {
        let margin = std::mem::replace(&mut self.wire.margin, look.margin);
        std::mem::swap(&mut self.met, &mut look.met);
        let contacts = self.contacts_of(step);
        std::mem::swap(&mut self.met, &mut look.met);
        self.wire.margin = margin;
        contacts
    }

    /// The first contacts of the whole wire, from those of its parts in the order of their steps.
    #[must_use]
    pub fn merged(&self, parts: impl IntoIterator<Item = Vec<FirstContact>>) -> Vec<FirstContact> {
        let mut found: Vec<FirstContact> = Vec::new();
        for first in parts.into_iter().flatten() {
            add(&mut found, first);
        }
        found.sort_by(|one, other| {
            let [one, other] = [one.contact, other.contact];
            one.step
                .cmp(&other.step)
                .then(one.phase.cmp(&other.phase))
                .then(one.passed.total_cmp(&other.passed))
        });
        for first in &mut found {
            let depth = self.depth(&first.contact);
            // What only just is hit may be measured as not hit. What a wire that hangs may hit for all that is known of its shape is not.
            let just_hit = first.hits && depth.mm() >= -2.0 * DEPTH_EXACT;
            first.depth = if just_hit { depth.max(Length::ZERO) } else { depth };
            first.hits = first.depth >= Length::ZERO;
        }
        found
    }

    /// What the wire begins to meet in a step; the steps are asked for in order. One contact for each thing that it meets.
    pub fn contacts_of(&mut self, step: usize) -> Vec<Contact> {
        let Some(moves) = self.moves(step) else { return Vec::new() };
        let strokes = Strokes::new(self, &moves);
        let mut asked = Asked::new(self, step, &strokes);
        let all = self.bodies.all.iter().enumerate().map(|(index, body)| (Obstacle::Body(index), body));
        let all: Vec<(Obstacle, &Body)> = all.chain([(Obstacle::Stock, &self.stock[step])]).collect();
        let mut met = Vec::new();
        let mut found = Vec::new();
        for one in all {
            let Some((stroke, meeting)) = asked.first(one) else { continue };
            met.push(one.0);
            let goes_on = stroke.phase == Phase::Feed && meeting.time <= 0.0;
            if !(goes_on && self.met.contains(&one.0)) {
                found.push(asked.contact(one.0, (stroke, meeting)));
            }
        }
        self.met = met;
        found.sort_by(|one, other| one.phase.cmp(&other.phase).then(one.passed.total_cmp(&other.passed)));
        found
    }

    /// How deep the wire and what it meets are in each other at the worst of the step, to a twentieth; below zero where they only come
    /// nearer than the margin.
    #[must_use]
    pub fn depth(&self, contact: &Contact) -> Length {
        let body = match contact.obstacle {
            Obstacle::Body(index) => self.bodies.all.get(index),
            Obstacle::Stock => self.stock.get(contact.step),
        };
        let Some((body, moves)) = body.zip(self.moves(contact.step)) else { return Length::ZERO };
        let strokes = Strokes::new(self, &moves);
        let mut asked = Asked::new(self, contact.step, &strokes);
        let radius = self.wire.diameter.mm() / 2.0;
        let deepest = |task: &Task| closest(task, radius, DEPTH_SHARE);
        let mut least = self.wire.reach();
        for strokes in strokes.past(body.moves_with) {
            asked.answers((contact.obstacle, body), strokes, DEPTH_EXACT, deepest, &mut |(_, near)| {
                least = least.min(near.distance);
                ControlFlow::Continue(())
            });
        }
        Length::computed(radius - least)
    }
}
