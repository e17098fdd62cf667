//! For lengths that do not suit the machine: the whole design larger or smaller.

use nalgebra::Vector3;
use wirebend_core::checks::{Code, Diagnostic, Quantity};
use wirebend_core::wireframe::Wireframe;
use wirebend_files::document::{PlacedStencil, PlacementFile};

use super::super::EditRequest;
use super::trials::Trials;
use super::{Candidate, Finding};

/// A design of which a vertex would go so far, mm, is in another unit, or for another machine.
const TOO_FAR_MM: f64 = 1000.0;
/// How often the factor is raised where the bends do not grow with the edges.
const MAX_ATTEMPTS: usize = 4;

/// Which of some findings needs the design larger by most, and by what factor; none where it is the only one.
pub(super) fn neediest(findings: &[Finding], of: &[usize], wireframe: &Wireframe) -> Option<(usize, f64)> {
    let factor = |&k: &usize| Some((k, needed(wireframe, findings[k].diagnostic)?));
    let factors: Vec<(usize, f64)> = of.iter().filter_map(factor).collect();
    // Of equals the first.
    let most = factors.iter().rev().max_by(|a, b| a.1.total_cmp(&b.1)).copied();
    most.filter(|_| factors.len() > 1)
}

/// The smallest factor of three digits, from one on, by which nothing is too short any more.
pub(super) fn up(from: f64, trials: &mut Trials) -> Option<Candidate> {
    let mut factor = rounded(from, f64::ceil);
    for _ in 0..MAX_ATTEMPTS {
        let candidate = scaled(trials, factor)?;
        let trial = trials.of(&candidate.edit)?;
        // The trial's edges are of the size that they have there.
        let mut after = trials.document().wireframe.clone();
        after.commit(&trial.change.wireframe).ok()?;
        let still = trial.diagnostics().filter_map(|diagnostic| needed(&after, diagnostic));
        match still.max_by(f64::total_cmp) {
            Some(more) => factor = rounded(factor * more.max(1.0 + 1e-9), f64::ceil),
            None => return Some(candidate),
        }
    }
    None
}

/// The largest factor of three digits by which the wire, or the feed, fits the stock.
pub(super) fn down(finding: Finding, trials: &Trials) -> Option<Candidate> {
    let diagnostic = finding.diagnostic;
    let length = match diagnostic.code() {
        Code::StockTooLong => finding.wire?.nominal.as_ref()?.length().mm(),
        _ => edges_length(&trials.document().wireframe, diagnostic),
    };
    let factor = rounded(fitting(diagnostic, length)?, f64::floor);
    (factor > 0.0 && factor < 1.0).then(|| scaled(trials, factor)).flatten()
}

/// By how much the design has to grow for a part that is too short.
fn needed(wireframe: &Wireframe, diagnostic: &Diagnostic) -> Option<f64> {
    matches!(diagnostic.code(), Code::EdgeTooShort | Code::FeedTooShort | Code::ArcsOverlap)
        .then(|| fitting(diagnostic, edges_length(wireframe, diagnostic)))
        .flatten()
}

fn edges_length(wireframe: &Wireframe, diagnostic: &Diagnostic) -> f64 {
    diagnostic.location.edges.iter().map(|&edge| wireframe.edge_length(edge).mm()).sum()
}

/// The factor on a designed length, mm, by which what was measured is at its limit. What bends take of it, and the
/// tail of the stock, do not change.
fn fitting(diagnostic: &Diagnostic, length: f64) -> Option<f64> {
    let (Quantity::Length(measured), Quantity::Length(limit)) =
        (diagnostic.measured()?, diagnostic.limit()?.value)
    else {
        return None;
    };
    (length > 0.0).then(|| (limit.mm() - measured.mm() + length) / length)
}

/// The next number of three digits.
fn rounded(factor: f64, to: fn(f64) -> f64) -> f64 {
    let unit = 10_f64.powf(factor.log10().floor() - 2.0);
    // A number of three digits is taken as it is, in spite of how it is stored.
    let nearest = (factor / unit).round();
    if (factor / unit - nearest).abs() < 1e-9 { nearest * unit } else { to(factor / unit) * unit }
}

/// The design scaled about the middle of its bounding box, with its stencils and construction lines; none where a vertex would go too far.
fn scaled(trials: &Trials, factor: f64) -> Option<Candidate> {
    let wireframe = &trials.document().wireframe;
    let mut points = wireframe.vertices().map(|(_, vertex)| vertex.position.coords);
    let first = points.next()?;
    let (low, high) = points
        .fold((first, first), |(low, high): (Vector3<f64>, Vector3<f64>), p| (low.inf(&p), high.sup(&p)));
    if (high - low).norm() * 0.5 * (1.0 - factor).abs() >= TOO_FAR_MM {
        return None;
    }
    let move_by = (low + high) * 0.5 * (1.0 - factor);
    let row = |k: usize| {
        let mut row = [0.0, 0.0, 0.0, move_by[k]];
        row[k] = factor;
        row
    };
    let document = trials.document();
    let wire = EditRequest::Transform {
        vertices: wireframe.vertices().map(|(id, _)| id.0).collect(),
        lines: (0..).zip(&document.construction).map(|(place, _)| place).collect(),
        matrix: [row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]],
    };
    let stencils = document.stencils.iter().map(|PlacedStencil { id, placement, .. }| {
        let PlacementFile { shift_mm, turn_deg, scale } = PlacementFile::from(placement);
        let shift = Vector3::from(shift_mm) * factor + move_by;
        let placement = PlacementFile { shift_mm: shift.into(), turn_deg, scale: scale * factor };
        EditRequest::PlaceStencil { stencil: id.0, placement }
    });
    let mut edits: Vec<EditRequest> = std::iter::once(wire).chain(stencils).collect();
    let edit = if edits.len() > 1 {
        EditRequest::Several { label: "scale the design".to_owned(), edits }
    } else {
        edits.pop()?
    };
    Some(Candidate { title: format!("Scale the design by {}", three_digits(factor)), edit })
}

fn three_digits(factor: f64) -> String {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // a few digits
    let decimals = (2.0 - factor.log10().floor()).clamp(0.0, 9.0) as usize;
    format!("{factor:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factors_have_three_digits_on_the_safe_side() {
        for (factor, up, down) in [
            (1.0, "1.00", "1.00"),
            (1.2301, "1.24", "1.23"),
            (0.87651, "0.877", "0.876"),
            (45.61, "45.7", "45.6"),
        ] {
            assert_eq!(three_digits(rounded(factor, f64::ceil)), up);
            assert_eq!(three_digits(rounded(factor, f64::floor)), down);
        }
    }
}
