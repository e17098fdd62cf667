//! The contacts of a program.

use std::cmp::Ordering;
use std::ops::{ControlFlow, Range};

use wirebend_collide::{Task, closest};

use super::asked::{Asked, Strokes};
use super::body::Body;
use super::contact::{Contact, FirstContact, MeetsAs, Obstacle};
use super::stroke::Phase;
use super::wire::Clearance;
use crate::units::Length;

/// What was met in the step before, in each of the ways that are looked for: what is near in one step must not hide what is hit in a later
/// one, nor a touch what goes through the middle.
#[derive(Default)]
struct Met {
    near: Vec<Obstacle>,
    hit: Vec<Obstacle>,
    through: Vec<Obstacle>,
}

/// Adds a contact to the first ones: of each thing the first of the severest kind is kept.
fn add(found: &mut Vec<FirstContact>, first: FirstContact) {
    let Some(known) = found.iter_mut().find(|known| known.contact.obstacle == first.contact.obstacle) else {
        found.push(first);
        return;
    };
    match first.kind.cmp(&known.kind) {
        Ordering::Less => {}
        Ordering::Equal => known.later += 1 + first.later,
        Ordering::Greater => *known = first,
    }
}

/// How exact depths are, mm, and as a share of how far what is hit is gone into.
const DEPTH_EXACT: f64 = 0.02;
const DEPTH_SHARE: f64 = 0.05;

impl Clearance<'_> {
    /// The first contact of the severest kind with each thing that the wire meets, in the order of its steps.
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
        let mut met = Met::default();
        if let Some(before) = steps.start.checked_sub(1) {
            // What it meets already is no new contact.
            self.look(&mut met, before, |_, _| {});
        }
        let mut found: Vec<FirstContact> = Vec::new();
        for step in steps {
            if !goes_on(step) {
                return None;
            }
            self.look(&mut met, step, |kind, contact| {
                add(&mut found, FirstContact { contact, depth: Length::ZERO, later: 0, kind });
            });
        }
        Some(found)
    }

    /// Takes the contacts of a step, however they meet; the steps are asked for in order.
    fn look(&mut self, met: &mut Met, step: usize, mut take: impl FnMut(MeetsAs, Contact)) {
        let margin = self.wire.margin;
        let middle = Length::computed(-self.wire.diameter.mm() / 2.0);
        let hits = self.within(Length::ZERO, &mut met.hit, step, |_| true);
        let mut through = Vec::new();
        if met.hit.contains(&Obstacle::Stock) {
            through = self.within(middle, &mut met.through, step, |obstacle| obstacle == Obstacle::Stock);
        } else {
            met.through.clear();
        }
        let touch = hits.iter().copied().find(|contact| contact.obstacle == Obstacle::Stock);
        for contact in hits {
            take(MeetsAs::Hit, contact);
        }
        for contact in through {
            // It is met where it is touched, if that is in the same step.
            take(MeetsAs::Through, touch.unwrap_or(contact));
        }
        if margin > Length::ZERO {
            for contact in self.within(margin, &mut met.near, step, |_| true) {
                take(MeetsAs::Near, contact);
            }
        }
    }

    /// The contacts of a step with another margin, of what was not met so in the step before.
    fn within(
        &mut self,
        margin: Length,
        met: &mut Vec<Obstacle>,
        step: usize,
        asks_of: impl Fn(Obstacle) -> bool,
    ) -> Vec<Contact> {
        let own = std::mem::replace(&mut self.wire.margin, margin);
        std::mem::swap(&mut self.met, met);
        let contacts = self.contacts_with(step, asks_of);
        std::mem::swap(&mut self.met, met);
        self.wire.margin = own;
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
            let depth = self.depth_of(&first.contact, first.kind);
            // What only just is hit may be measured as not hit.
            first.depth = if first.kind == MeetsAs::Near { depth } else { depth.max(Length::ZERO) };
        }
        found
    }

    /// What the wire begins to meet in a step; the steps are asked for in order. One contact for each thing that it meets.
    pub fn contacts_of(&mut self, step: usize) -> Vec<Contact> {
        self.contacts_with(step, |_| true)
    }

    fn contacts_with(&mut self, step: usize, asks_of: impl Fn(Obstacle) -> bool) -> Vec<Contact> {
        let Some(moves) = self.moves(step) else { return Vec::new() };
        let strokes = Strokes::new(self, &moves);
        let mut asked = Asked::new(self, step, &strokes);
        let all = self.bodies.all.iter().enumerate().map(|(index, body)| (Obstacle::Body(index), body));
        let all: Vec<(Obstacle, &Body)> = all.chain([(Obstacle::Stock, &self.stock[step])]).collect();
        let exact = (DEPTH_SHARE * -self.wire.margin.mm()).max(2.0 * DEPTH_EXACT);
        let mut met = Vec::new();
        let mut found = Vec::new();
        for one in all.into_iter().filter(|(obstacle, _)| asks_of(*obstacle)) {
            let Some((stroke, meeting)) = asked.first(one) else { continue };
            // What a wire that hangs may meet for all that is known of its shape is not met.
            if self.hanging.is_some() && self.least(&mut asked, one) > asked.reach() + exact {
                continue;
            }
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
        self.depth_of(contact, MeetsAs::Near)
    }

    /// The same by how they meet: what is hit is as deep with a margin as without, although more may come near at a vertex then.
    fn depth_of(&self, contact: &Contact, kind: MeetsAs) -> Length {
        let body = match contact.obstacle {
            Obstacle::Body(index) => self.bodies.all.get(index),
            Obstacle::Stock => self.stock.get(contact.step),
        };
        let Some((body, moves)) = body.zip(self.moves(contact.step)) else { return Length::ZERO };
        let strokes = Strokes::new(self, &moves);
        let asked = Asked::new(self, contact.step, &strokes);
        let mut asked = if kind == MeetsAs::Near { asked } else { asked.touching() };
        let least = self.least(&mut asked, (contact.obstacle, body)).min(asked.reach());
        Length::computed(self.wire.diameter.mm() / 2.0 - least)
    }

    /// How near to a body the centreline comes in a step, mm; infinite where it stays out of reach.
    fn least(&self, asked: &mut Asked, one: (Obstacle, &Body)) -> f64 {
        let radius = self.wire.diameter.mm() / 2.0;
        let deepest = |task: &Task| closest(task, radius, DEPTH_SHARE);
        let mut least = f64::INFINITY;
        for strokes in asked.strokes().past(one) {
            asked.answers(one, strokes, DEPTH_EXACT, deepest, &mut |(_, near)| {
                least = least.min(near.distance);
                ControlFlow::Continue(())
            });
        }
        least
    }
}
