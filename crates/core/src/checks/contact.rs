//! Whether the wire already bent meets the machine, or the wire that is still to come.

use super::{Diagnostic, Fact, Location, Meeting, Remedy, Severity, Source, Sourced, WireStages};
use crate::clearance::{Contact, FirstContact, MeetsAs, Obstacle};
use crate::units::Length;

pub(super) fn check(wire: &WireStages, found: &mut Vec<Diagnostic>) {
    found.extend(wire.contacts.iter().filter_map(|contact| finding(wire, contact)));
}

fn finding(wire: &WireStages, first: &FirstContact) -> Option<Diagnostic> {
    let FirstContact { contact, depth, later, kind } = *first;
    let Contact { phase, fed, bent, head, .. } = contact;
    let struck = wire.edges_of_step(contact.leg);
    let meeting = Meeting { struck: struck.clone(), phase, fed, bent, head, depth, later };
    let mut location = wire.location_of_step(contact.step);
    let search = (!wire.searched).then_some(Remedy::AvoidCollisions);
    let Obstacle::Body(body) = contact.obstacle else {
        // The stock lies where the next straight part will be.
        let next = wire.edges_of_step(contact.step + 1);
        let edges = struck.iter().chain(&next).copied().collect();
        let own = [Remedy::MoveApart, Remedy::ChooseStart, Remedy::SplitDesign];
        return Some(Diagnostic {
            // Wires that touch give way to each other; where one is in the middle of the other, neither can.
            severity: if kind == MeetsAs::Through { Severity::Error } else { Severity::Warning },
            location: Location { edges, ..location },
            fact: Fact::MeetsStock(meeting),
            remedies: search.into_iter().chain(own).collect(),
        });
    };
    let body = wire.bodies.get(body)?;
    location.edges = struck;
    let source = Source { reason: Some(body.source.clone()), entry: body.entry.clone() };
    // What is only estimated may be elsewhere, and what only comes near does not hit: worth a look, not an error.
    let severity = if body.measured && first.hits() { Severity::Error } else { Severity::Warning };
    let own = [Remedy::ChooseStart, Remedy::SplitDesign, Remedy::ChooseMachine];
    let measure = (!body.measured).then_some(Remedy::MeasureBody);
    Some(Diagnostic {
        severity,
        location,
        fact: Fact::MeetsMachine {
            meeting,
            body: body.name.clone(),
            measured: body.measured,
            limit: Sourced { value: Length::ZERO, source },
        },
        remedies: measure.into_iter().chain(search).chain(own).collect(),
    })
}

#[cfg(test)]
mod tests;
