//! A wire that is bent step after step: what the peg touches is what the bends before have left.

use super::contact::{Beyond, FormedWire};
use super::{BendError, Compensation, FOLD_DEG, PegGeometry, ToldStep};
use crate::bend::Step;
use crate::units::{Angle, Length};

/// Less than this no axis can be told.
const NEAR_DEG: f64 = 1e-3;

/// A wire whose bends are commanded one after the other.
pub(super) struct Forming<'a> {
    compensation: &'a Compensation,
    /// As the peg meets it; none where the axis is the bend.
    wire: Option<FormedWire>,
    /// Straight wire before the first bend, mm; none once there is one.
    lead: Option<f64>,
}

/// How much further the axis goes than on a straight leg, and whether the peg touches past another corner.
pub(super) type Elsewhere = (Option<Angle>, bool);

/// The command of a bend.
pub(super) struct Commanded {
    pub axis: Angle,
    pub elsewhere: Option<Elsewhere>,
    /// Where the peg comes out, unless the place for straight wire will do.
    pub approach: Option<Angle>,
}

impl<'a> Forming<'a> {
    pub fn new(compensation: &'a Compensation) -> Self {
        Self { compensation, wire: compensation.bend.setback.as_ref().map(FormedWire::new), lead: Some(0.0) }
    }

    /// The command of the next bend.
    pub fn command(&mut self, before: Angle, step: &Step) -> Result<Commanded, BendError> {
        let Step { feed, rotate, bend } = *step;
        let Compensation { feed: feeds, bend: model, .. } = self.compensation;
        let (mut straight, mut beyond) = (0.0, Beyond::default());
        if let Some(wire) = &mut self.wire {
            straight = wire.straight(feed, before, bend);
            beyond = wire.beyond(rotate, bend.signum(), straight);
            wire.push(straight, rotate, bend);
        }
        let lead = self.lead.map(|lead| lead + straight);
        self.lead = lead.filter(|_| bend == Angle::ZERO);
        if feeds.is_some() && bend.abs().deg() > FOLD_DEG {
            return Err(BendError::FoldBack { bend });
        }
        if beyond.is_empty() || bend == Angle::ZERO {
            return Ok(Commanded { axis: model.command(bend)?, elsewhere: None, approach: None });
        }
        // What is not bent yet is straight still.
        let arc = |bend: Angle| model.arc_of(bend, feeds.as_ref());
        let leg = |left: Angle| straight + (arc(bend) - arc(left)).max(0.0);
        match (model.command_on(bend, leg, &beyond), lead, &model.setback) {
            (Err(BendError::CornerTooNear { bend }), Some(lead), Some(peg)) => {
                let lead = Length::computed(lead + arc(bend));
                Err(BendError::LeadTooShort { bend, lead, needed: peg.least_lead(lead) })
            }
            (told, lead, _) => told.map(|(axis, touch, approach)| {
                let on_straight = model.axis(bend);
                let further = on_straight.map(|straight| Angle::computed(touch.axis - straight.rad()));
                let is_elsewhere = lead.is_none() && further.is_none_or(|by| by.deg().abs() > NEAR_DEG);
                let elsewhere = is_elsewhere.then_some((further, touch.past_other));
                Commanded { axis, elsewhere, approach }
            }),
        }
    }
}

/// The bends that commands leave, one after the other: what the peg touches is what those before have left. Feeds and turns are those
/// that feed and head make of the commands.
pub(crate) fn results(made: &[ToldStep], compensation: &Compensation) -> Vec<Angle> {
    let model = &compensation.bend;
    let Some(peg) = &model.setback else {
        return made.iter().map(|told| model.result_to(told.side(), told.step.bend)).collect();
    };
    bent_by(peg, made, compensation, |_, _, _| ())
}

/// What feed and head make of commands, each with the side of its bend.
pub(crate) fn made_of(told: &[ToldStep], compensation: &Compensation) -> Vec<ToldStep> {
    let steps: Vec<Step> = told.iter().map(|told| told.step).collect();
    let made = compensation.motion.result(&steps);
    made.iter().zip(told).map(|(step, told)| ToldStep { step: *step, ..*told }).collect()
}

/// For each command where the bend axis has to stand when the peg comes out, so that it is clear of the wire that the commands before
/// have left: on the side from which it bends. What a command says itself stays. Nothing where the place for straight wire will do,
/// and where there is no room anywhere.
#[must_use]
pub fn approaches(told: &[ToldStep], compensation: &Compensation) -> Vec<Option<Angle>> {
    let mut found: Vec<Option<Angle>> = told.iter().map(|told| told.approach).collect();
    let Some(peg) = &compensation.bend.setback else { return found };
    let made = made_of(told, compensation);
    bent_by(peg, &made, compensation, |index, leg, beyond| {
        let at = peg.approach(leg, beyond).ok().flatten();
        found[index] = found[index].or(at.map(|at| Angle::computed(made[index].side() * at)));
    });
    found
}

/// Bends wire step after step. `met` hears before each bend how long the leg is while nothing of it is pressed, mm, and what lies
/// beyond.
fn bent_by(
    peg: &PegGeometry,
    steps: &[ToldStep],
    compensation: &Compensation,
    mut met: impl FnMut(usize, f64, &Beyond),
) -> Vec<Angle> {
    let model = &compensation.bend;
    let mut formed = FormedWire::new(peg);
    let mut before = Angle::ZERO;
    let mut results = Vec::with_capacity(steps.len());
    for (index, told) in steps.iter().enumerate() {
        let step = &told.step;
        let leg = |bend: Angle| {
            let segment = compensation
                .feed
                .as_ref()
                .map_or(step.feed, |model| model.segment_of(step.feed, before, bend));
            formed.straight(segment, before, bend)
        };
        let bend = if told.bends() {
            let beyond = formed.beyond(step.rotate, told.side(), leg(Angle::HALF_TURN));
            if !beyond.is_empty() {
                met(index, leg(Angle::ZERO), &beyond);
            }
            model.result_on(told, leg, &beyond)
        } else {
            Angle::ZERO
        };
        formed.push(leg(bend), step.rotate, bend);
        before = bend;
        results.push(bend);
    }
    results
}
