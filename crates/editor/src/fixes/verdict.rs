//! Whether an edit fixes what it is meant to, and nothing else gets worse.

use std::collections::BTreeSet;

use wirebend_core::checks::{Code, Diagnostic};

use super::trials::Trial;

/// Whether a diagnostic is gone from its place and said less often, without more errors than there were; of a warning
/// also without more warnings.
pub(super) fn is_fixed(before: &Trial, after: &Trial, diagnostic: &Diagnostic) -> bool {
    let said = |trial: &Trial| trial.diagnostics().filter(|d| d.code() == diagnostic.code()).count();
    // An edge that is moved away from one edge and into another meets one as before.
    let is_here = |other: &&Diagnostic| match diagnostic.code() {
        Code::EdgesMeet => other.code() == Code::EdgesMeet && share_edge(other, diagnostic),
        _ => same_place(other, diagnostic),
    };
    let here = |trial: &Trial| trial.diagnostics().filter(is_here).count();
    said(after) < said(before)
        && here(after) < here(before)
        && is_no_worse(before, after, diagnostic.is_error())
}

/// Whether there are no more errors than before, and no more warnings where it is not for an error.
pub(super) fn is_no_worse(before: &Trial, after: &Trial, for_error: bool) -> bool {
    no_more_errors(before, after) && (for_error || after.warnings() <= before.warnings())
}

/// Whether two diagnostics say the same of the same place. Steps are counted anew by every route, so that only vertices
/// and edges tell.
pub(super) fn same_place(one: &Diagnostic, other: &Diagnostic) -> bool {
    one.code() == other.code()
        && match one.code() {
            code if is_of_straight(code) => share_edge(one, other),
            Code::ZeroLengthEdge | Code::ParallelEdges => {
                one.location.edges.first() == other.location.edges.first()
            }
            Code::EdgesMeet => one.location.edges == other.location.edges,
            Code::NoEulerPath | Code::StockTooLong | Code::RouteRefused => true,
            _ => one.location.vertices.first() == other.location.vertices.first(),
        }
}

/// Whether a code is about a straight part of the wire.
fn is_of_straight(code: Code) -> bool {
    matches!(
        code,
        Code::EdgeTooShort
            | Code::EdgeNearLimit
            | Code::FeedTooShort
            | Code::FeedNearLimit
            | Code::ArcsOverlap
            | Code::FeedTooLong
    )
}

/// Whether two diagnostics are about a common edge.
pub(super) fn share_edge(one: &Diagnostic, other: &Diagnostic) -> bool {
    one.location.edges.iter().any(|edge| other.location.edges.contains(edge))
}

/// Whether there are no more errors than before, of those that could be found before: a wire that had no route was not
/// checked for bends, and its errors are not the fault of what gave it one.
fn no_more_errors(before: &Trial, after: &Trial) -> bool {
    let missing = |trial: &Trial, reached: fn(&wirebend_core::plan::WirePlan) -> bool| {
        trial.wires.iter().filter(|wire| !reached(wire)).count()
    };
    let further = |reached| missing(after, reached) < missing(before, reached);
    let judged: fn(Code) -> bool = if further(|wire| wire.route.is_some()) {
        |code| {
            matches!(
                code,
                Code::ZeroLengthEdge
                    | Code::NoEdges
                    | Code::NoEulerPath
                    | Code::RouteRefused
                    | Code::EdgeTooShort
                    | Code::WireDoesNotFit
            )
        }
    } else if further(|wire| wire.scheduled.is_some()) {
        |code| {
            !matches!(
                code,
                Code::BendTooSharp
                    | Code::BendOutOfReach
                    | Code::BendTooSmall
                    | Code::CornerTooNear
                    | Code::LeadTooShort
                    | Code::StockTooLong
            )
        }
    } else if further(|wire| wire.compensated.is_some()) {
        |code| code != Code::StockTooLong
    } else {
        return after.errors() <= before.errors();
    };
    distinct(after, judged) <= distinct(before, judged)
}

/// How many errors there are at different places: of an edge that is travelled twice some are said twice.
fn distinct(trial: &Trial, counts: fn(Code) -> bool) -> usize {
    let errors = trial.diagnostics().filter(|diagnostic| diagnostic.is_error() && counts(diagnostic.code()));
    let places: BTreeSet<_> = errors
        .map(|diagnostic| {
            let location = &diagnostic.location;
            let mut edges = location.edges.clone();
            edges.sort_unstable();
            let vertices = if edges.is_empty() { location.vertices.clone() } else { Vec::new() };
            (diagnostic.code(), edges, vertices)
        })
        .collect();
    places.len()
}
