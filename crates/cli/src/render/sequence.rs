//! The order in which struts are built.

use std::io::Write;

use wirebend_api::{
    DiagnosticReport, RemedyReport, SequenceResponse, SequenceStepReport, StepTypeName, StrategyName,
};

use super::number::{self, count, mm};
use super::tables::table;
use super::{notes, plan};

/// The most steps that are listed before the rest is left to `--json`.
const LISTED_STEPS: usize = 20;

pub(super) fn sequence(out: &mut impl Write, found: &SequenceResponse) -> std::io::Result<()> {
    notes(out, &found.notes)?;
    if found.feasible {
        feasible(out, found)?;
    }
    if let Some(layers) = &found.layers {
        let sizes: Vec<String> = layers.iter().map(|layer| layer.len().to_string()).collect();
        let words = format!("{} from the ground up, of {} struts", sizes.len(), sizes.join(", "));
        row(out, "layers", &words)?;
    }
    if found.feasible {
        steps(out, &found.steps)?;
    }
    for diagnostic in &found.diagnostics {
        // The options of other remedies belong to other commands.
        let here = |remedy: &&RemedyReport| matches!(remedy, RemedyReport::AllowMoreSag);
        let remedies = diagnostic.remedies.iter().filter(here).cloned().collect();
        let shown = DiagnosticReport { remedies, ..diagnostic.clone() };
        plan::finding(out, &shown, "look for it again with ")?;
    }
    found.files.iter().try_for_each(|file| writeln!(out, "wrote {}", file.display()))
}

fn row(out: &mut impl Write, label: &str, words: &str) -> std::io::Result<()> {
    writeln!(out, "  {label:<18} {words}")
}

fn feasible(out: &mut impl Write, found: &SequenceResponse) -> std::io::Result<()> {
    let how = match found.strategy {
        Some(StrategyName::FromGround) => "what is farthest from the ground comes last",
        Some(StrategyName::StiffnessPlan) => "what keeps the frame stiffest comes first",
        Some(StrategyName::Restart) => "found after others got stuck",
        Some(StrategyName::Backtracking) => "found by going back from dead ends",
        Some(StrategyName::PaperCost) => "layer by layer, by the cost of FrameFab",
        None => "as given: every step can be made",
    };
    row(
        out,
        "sequence",
        &format!("{} on {}: {how}", count(found.steps.len(), "step", "steps"), found.machine),
    )?;
    if let Some(most) = found.max_displacement_mm {
        row(
            out,
            "sag",
            &format!(
                "{} mm at most; a joint may be {:.4} mm off",
                number::or_less(most, 4),
                found.epsilon_mm
            ),
        )?;
    }
    row(
        out,
        "sharing",
        &format!("{} a vertex with the step before", count(found.sharing, "step shares", "steps share")),
    )?;
    if let Some(least) = found.min_free_directions {
        row(out, "free directions", &format!("{least} where fewest are free"))?;
    }
    match (found.time_s, found.travel_mm) {
        (Some(time), Some(travel)) => row(
            out,
            "takes",
            &format!("{}, with {} mm of travel between struts", number::duration(time), mm(travel)),
        ),
        _ => Ok(()),
    }
}

fn steps(out: &mut impl Write, steps: &[SequenceStepReport]) -> std::io::Result<()> {
    let rows = steps.iter().take(LISTED_STEPS).enumerate().map(|(k, step)| {
        let kind = match step.kind {
            StepTypeName::Ground => "on the ground",
            StepTypeName::Create => "into the open",
            StepTypeName::Connect => "between vertices",
        };
        let edges = if step.edges.is_empty() { step.edge.to_string() } else { list(&step.edges) };
        let from = step.from_vertex.map(|vertex| vertex.to_string()).unwrap_or_default();
        let direction = step.direction.map(|[x, y, z]| format!("{x:.3} {y:.3} {z:.3}")).unwrap_or_default();
        let sag =
            step.max_displacement_mm.map(|sag| format!("{} mm", number::or_less(sag, 4))).unwrap_or_default();
        [(k + 1).to_string(), edges, from, kind.to_owned(), direction, step.free_directions.to_string(), sag]
    });
    table(out, ["step", "edge", "from", "what", "head's axis", "free", "sag"], rows)?;
    match steps.len().saturating_sub(LISTED_STEPS) {
        0 => Ok(()),
        more => writeln!(out, "and {more} more: --json has all"),
    }
}

fn list(edges: &[u32]) -> String {
    edges.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")
}
