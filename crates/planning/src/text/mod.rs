//! Words for what the pure rooms say in facts: the only place that makes sentences of findings, limits, remedies and
//! their errors.
//!
//! One file for each group of checks. Every match is without a wildcard, so that a new finding does not compile until it
//! has words. The words are those of no front end: a command line adds its options, a window its buttons. A message is a
//! sentence without a full stop, which begins in lower case.

mod bend;
pub mod calibration;
mod contact;
mod drawing;
pub mod error;
mod frame;
mod limit;
mod machine;
mod number;
pub mod profile;
mod remedy;
mod route;
mod sequence;
mod shown;
mod straight;
#[cfg(test)]
mod tests;

pub use limit::source;
pub use number::price;
pub use shown::{kept, kept_in, show_lengths_in, shown};
use wirebend_core::checks::{Diagnostic, Fact};

/// What a finding says, with its figures.
#[must_use]
pub fn message(diagnostic: &Diagnostic) -> String {
    let at = &diagnostic.location;
    match &diagnostic.fact {
        Fact::ZeroLengthEdge { edge, ends, .. } => drawing::zero_length(*edge, *ends),
        Fact::NoPath(error) => drawing::no_path(error, at),
        Fact::ParallelEdges { edges, ends } => drawing::parallel(*edges, *ends),
        Fact::CoincidentVertices { vertices, distance, .. } => drawing::coincident(*vertices, *distance),
        Fact::EdgesMeet { edges, near, from, along, distance, diameter, closing } => {
            let meeting = drawing::meeting(*edges, *near, *from, *along);
            drawing::edges_meet(&meeting, *distance, *diameter, diagnostic.is_error(), *closing)
        }
        Fact::IsolatedVertex { vertex } => drawing::isolated(*vertex),
        Fact::SeveralWires { wires } => drawing::several_wires(*wires),
        Fact::NoEdges => drawing::no_edges(),
        Fact::NoEulerPath { odd, allowed } => route::no_euler_path(*odd, *allowed),
        Fact::RouteRefused(error) => error::route(error),
        Fact::DoubledEdge { edge, passes } => route::doubled_edge(*edge, *passes),
        Fact::EdgeTooShort { length, limit } | Fact::EdgeNearLimit { length, limit } => {
            straight::edge(at, *length, limit.value)
        }
        Fact::FeedTooShort { designed, feed, limit, unpressed } => {
            straight::feed_too_short(at, *designed, *feed, limit.value, *unpressed)
        }
        Fact::FeedNearLimit { designed, feed, limit } => {
            straight::feed_near_limit(at, *designed, *feed, limit.value)
        }
        Fact::FeedTooLong { designed, feed, limit } => {
            straight::feed_too_long(at, *designed, *feed, limit.value)
        }
        Fact::FeedLongerThanStock { designed, feed, limit } => {
            straight::feed_longer_than_stock(at, *designed, *feed, limit.value)
        }
        Fact::ArcsOverlap { designed, needed, .. } => straight::arcs_overlap(at, *designed, *needed),
        Fact::BendTooSharp { bend, of, limit } => bend::too_sharp(at, *of, *bend, limit.value),
        Fact::BendNearLimit { bend, limit } => bend::near_limit(at, *bend, limit.value),
        Fact::BendOutOfReach { bend, of, max, .. } => bend::out_of_reach(at, *of, *bend, *max),
        Fact::BendTooSmall { bend } => bend::too_small(at, *bend),
        Fact::LeadTooShort { lead, needed, .. } => bend::lead_too_short(at, *lead, *needed),
        Fact::CornerTooNear { bend } => bend::corner_too_near(at, *bend),
        Fact::CornerWithinReach(near) => bend::corner_within_reach(at, near),
        Fact::HeadNotMeasured(bends) => bend::head_not_measured(*bends),
        Fact::BendInScatter { bend, scatter } => bend::in_scatter(at, *bend, scatter.value),
        Fact::CornerNotMade { vertex, corner, .. } => bend::corner_not_made(*vertex, *corner),
        Fact::FoldBack { .. } => bend::fold_back(at),
        Fact::FoldBackNotCompensated { bend } => bend::fold_back_not_compensated(at, *bend),
        Fact::RotationOutOfRange { wanted, commanded: false, range, .. } => {
            machine::rotation_out_of_range(at, *wanted, *range)
        }
        Fact::RotationOutOfRange { wanted, range, .. } => machine::sent_out_of_range(at, *wanted, *range),
        Fact::StockTooLong { needed, tail, limit } => machine::stock_too_long(*needed, *tail, limit.value),
        Fact::BendTorqueLow { needed_n_m, available_n_m, .. } => {
            machine::bend_torque_low(available_n_m.value, *needed_n_m)
        }
        Fact::PartSags(sag) => machine::part_sags(sag),
        Fact::BendRadiusSmall(bend) => machine::bend_radius_small(bend),
        Fact::WireDoesNotFit { diameter, range, .. } => machine::wire_does_not_fit(*diameter, *range),
        Fact::MeetsMachine { meeting, body, measured, .. } => {
            contact::meets_machine(at, meeting, body, *measured)
        }
        Fact::MeetsStock(meeting) => contact::meets_stock(at, meeting),
        Fact::NoClearProgram { checks, exhausted, obstacle, body, passed, clearance, helps } => {
            let searched = contact::searched(*checks, *exhausted);
            let obstacle = contact::obstacle(*obstacle, body.as_deref(), *clearance);
            contact::no_clear_program(at, &searched, &obstacle, *passed) + &contact::helps(helps)
        }
        Fact::FrameUnsupported { edges, whole } => frame::unsupported(at, *edges, *whole),
        Fact::FrameMechanism => frame::mechanism(at),
        Fact::StrutOverstressed { stress_mpa, yield_mpa, .. } => {
            frame::overstressed(at, *stress_mpa, *yield_mpa)
        }
        Fact::StrutNearBuckling { ratio, .. } => frame::near_buckling(at, *ratio),
        Fact::FrameHardlyStands { displacement, size } => frame::hardly_stands(at, *displacement, *size),
        Fact::FrameTooSoft { sag, max, without } => sequence::too_soft(at, *sag, *max, *without),
        Fact::StrutFloating { edge } => sequence::floating(*edge),
        Fact::NoHeadDirection { edge, blocking } => sequence::no_direction(at, *edge, *blocking),
        Fact::OutOfWorkspace => sequence::out_of_reach(at),
        Fact::SequenceNotFound { step, of, proved } => sequence::not_found(*step, *of, *proved),
        Fact::SequenceStep(violation) => sequence::violation(violation),
    }
}

/// What to do about a finding: its remedies as alternatives.
#[must_use]
pub fn help(diagnostic: &Diagnostic) -> String {
    let remedies: Vec<String> = diagnostic.remedies.iter().map(remedy::clause).collect();
    number::alternatives(&remedies)
}
