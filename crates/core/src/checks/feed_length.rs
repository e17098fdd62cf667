//! Feeds after compensation: too short to grip, arcs that overlap, longer than the machine or its stock allows.

use super::{Diagnostic, Fact, ROUNDING, Remedy, Severity, Sourced, WireStages, is_near};
use crate::compensate::{BendError, corner, with_bend_before};
use crate::units::{Angle, Length};

pub(super) fn check(wire: &WireStages, found: &mut Vec<Diagnostic>) {
    let Some(nominal) = wire.nominal else { return };
    for (step, (before, designed)) in with_bend_before(&nominal.steps).enumerate() {
        // A fold back has no corner to calculate with; it has a check of its own.
        if before == Angle::HALF_TURN || designed.bend == Angle::HALF_TURN {
            judge(wire, step, designed.feed, designed.feed, found);
            continue;
        }
        // Bends have a radius on every machine, also on one that compensates for it by itself.
        let corner = |bend: Angle| corner(wire.bend_radius, bend);
        let straight = designed.feed - corner(before) - corner(designed.bend);
        if straight.mm() < -ROUNDING {
            found.push(Diagnostic {
                severity: Severity::Error,
                location: wire.location_of_step(step),
                fact: Fact::ArcsOverlap {
                    designed: designed.feed,
                    needed: designed.feed - straight,
                    bend_radius: wire.bend_radius,
                },
                remedies: vec![Remedy::LengthenEdge { by: None }, Remedy::EaseBends],
            });
            continue;
        }
        let model = wire.compensation.feed;
        let feed = model.map_or(designed.feed, |model| model.feed_for(designed.feed, before, designed.bend));
        judge(wire, step, designed.feed, feed, found);
    }
}

fn judge(wire: &WireStages, step: usize, designed: Length, feed: Length, found: &mut Vec<Diagnostic>) {
    let limits = wire.limits;
    let room = (feed - limits.min_feed.value).mm();
    // What the machine is told is limited there, not the wire that comes of it.
    let commanded = wire.compensation.motion.commanded(feed);
    let longest = limits.max_feed.as_ref().filter(|longest| is_beyond(commanded, longest));
    let usable_stock = limits
        .max_stock
        .as_ref()
        .map(|stock| Sourced { value: stock.value - limits.tail.value, source: stock.source.clone() });
    let (severity, fact, remedies) = if room < -ROUNDING {
        let limit = limits.min_feed.clone();
        let by = Some(Length::computed(-room));
        let unpressed = unpressed(wire, step);
        let fact = Fact::FeedTooShort { designed, feed, limit, unpressed };
        (Severity::Error, fact, vec![Remedy::LengthenEdge { by }])
    } else if let Some(limit) = longest.cloned() {
        let remedies = vec![Remedy::ShortenStraight, Remedy::AddBend];
        (Severity::Error, Fact::FeedTooLong { designed, feed: commanded, limit }, remedies)
    } else if let Some(limit) = usable_stock.filter(|usable| is_beyond(feed, usable)) {
        (Severity::Error, Fact::FeedLongerThanStock { designed, feed, limit }, vec![Remedy::SplitEdge])
    } else if is_near(room.max(0.0), limits.min_feed.value.mm()) {
        let limit = limits.min_feed.clone();
        let remedies = vec![Remedy::Leave, Remedy::LengthenEdge { by: None }];
        (Severity::Warning, Fact::FeedNearLimit { designed, feed, limit }, remedies)
    } else {
        return;
    };
    found.push(Diagnostic { severity, location: wire.location_of_step(step), fact, remedies });
}

fn is_beyond(feed: Length, most: &Sourced<Length>) -> bool {
    (feed - most.value).mm() > ROUNDING
}

/// The bend of a step that the peg cannot press for what lies before it.
fn unpressed(wire: &WireStages, step: usize) -> Option<Angle> {
    let failed = wire.unbendable.iter().find(|failed| failed.step == step)?;
    match failed.error {
        BendError::CornerTooNear { bend } | BendError::LeadTooShort { bend, .. } => Some(bend),
        _ => None,
    }
}
