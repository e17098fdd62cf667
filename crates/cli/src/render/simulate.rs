//! What a simulation found.

use std::io::Write;

use wirebend_api::{
    ErrorSourceName, ResolutionReport, SeverityName, SimulateResponse, SimulatedCollisions,
    SimulatedTolerance, SimulationModel, SourceShare, SourceTolerance, StepShare,
};

use super::number::count;
use super::{notes, plan, written};

pub(super) fn simulate(out: &mut impl Write, found: &SimulateResponse) -> std::io::Result<()> {
    notes(out, &found.notes)?;
    if found.model == SimulationModel::ClosedForm {
        writeln!(out, "calculated: this machine has no simulator")?;
    }
    let several = found.wires.len() > 1;
    for (index, wire) in found.wires.iter().enumerate() {
        if several {
            writeln!(out, "wire {}", index + 1)?;
        }
        if let Some(worst) = wire.worst_machine_mm {
            let label = "simulated machine";
            writeln!(out, "  {label:<18} the worst vertex is {worst:.3} mm off")?;
        }
        let label = "formulas";
        writeln!(out, "  {label:<18} the worst vertex is {:.3} mm off", wire.worst_systematic_mm)?;
        if found.model == SimulationModel::ClosedForm {
            let ResolutionReport { feed_mm, rotate_deg, bend_deg } = found.resolution;
            writeln!(
                out,
                "  {:<18} the worst vertex is {:.3} mm off: the axes go in steps of {feed_mm} mm, {rotate_deg}° (rotate) and {bend_deg}° (bend)",
                "rounded", wire.worst_rounded_mm
            )?;
        }
        if let Some(noise) = &found.noise {
            let runs = count(found.runs as usize, "run", "runs");
            writeln!(
                out,
                "  {noise:<18} the worst vertex is {:.2} mm off on average, within {:.2} mm in 95 % of {runs} (seed {})",
                wire.worst_mean_mm, wire.worst_radius_95_mm, found.seed
            )?;
            let widest = wire.gaps.iter().max_by(|a, b| a.mean_mm.total_cmp(&b.mean_mm));
            if let Some(gap) = widest {
                let label = "passes";
                writeln!(
                    out,
                    "  {label:<18} farthest apart at vertex {}: {:.2} mm on average, within {:.2} mm in 95 %",
                    gap.vertex, gap.mean_mm, gap.radius_95_mm
                )?;
            }
        }
        shares(out, &wire.sources, &wire.steps)?;
        if let Some(found) = &wire.collisions {
            collisions(out, found)?;
        }
    }
    if let Some(found) = &found.tolerance {
        tolerance(out, found)?;
    }
    writeln!(out, "distances are measured with the first vertex and the first direction fixed")?;
    written(out, found.files.iter())
}

/// Which errors move the wire most.
fn shares(out: &mut impl Write, sources: &[SourceShare], steps: &[StepShare]) -> std::io::Result<()> {
    let said: Vec<String> = sources
        .iter()
        .filter(|share| share.rms_mm > 0.0)
        .map(|share| format!("{} {:.2} mm", of(share.source), share.rms_mm))
        .collect();
    if said.is_empty() {
        return Ok(());
    }
    writeln!(out, "  {:<18} {} (root mean square, each alone)", "errors of", said.join(", "))?;
    if let Some(step) =
        steps.iter().max_by(|a, b| a.bend_mm.total_cmp(&b.bend_mm)).filter(|step| step.bend_mm > 0.0)
    {
        writeln!(
            out,
            "  {:<18} at vertex {}, step {}: {:.2} mm",
            "bend that matters", step.vertex, step.step, step.bend_mm
        )?;
    }
    Ok(())
}

/// How exact a machine must be.
fn tolerance(out: &mut impl Write, found: &SimulatedTolerance) -> std::io::Result<()> {
    let within = found.within_mm;
    if !found.possible {
        return writeln!(
            out,
            "no machine makes it within {within} mm: without errors a vertex is farther off already"
        );
    }
    writeln!(out, "within {within} mm in 95 % of the wires, where nothing else is off:")?;
    for SourceTolerance { source, sigma } in &found.alone {
        let sigma = match (source, sigma) {
            (_, None) => "any".to_owned(),
            (ErrorSourceName::Feed, Some(mm)) => format!("± {mm:.3} mm"),
            (ErrorSourceName::Rotation | ErrorSourceName::Bend, Some(deg)) => format!("± {deg:.3}°"),
            (ErrorSourceName::Curvature, Some(bow)) => format!("± {:.2} % of the length", 100.0 * bow),
        };
        writeln!(out, "  {:<18} {sigma}", of(*source))?;
    }
    match found.together {
        Some(factor) => writeln!(out, "  {:<18} {factor:.3} times the errors of the profile", "all together"),
        None => Ok(()),
    }
}

const fn of(source: ErrorSourceName) -> &'static str {
    match source {
        ErrorSourceName::Feed => "feeds",
        ErrorSourceName::Rotation => "rotations",
        ErrorSourceName::Bend => "bends",
        ErrorSourceName::Curvature => "bows of struts",
    }
}

/// Whether a simulated wire hits what it cannot pass.
pub(super) fn hits(found: &SimulateResponse) -> bool {
    let all = found.wires.iter().filter_map(|wire| wire.collisions.as_ref());
    let errors = |found: &SimulatedCollisions| {
        found.diagnostics.iter().any(|contact| contact.finding.severity == SeverityName::Error)
    };
    all.into_iter().any(errors)
}

fn collisions(out: &mut impl Write, found: &SimulatedCollisions) -> std::io::Result<()> {
    let label = "collisions";
    let several = found.wires > 1;
    let words = match (found.colliding, several) {
        (0, false) => "none".to_owned(),
        (0, true) => format!("none in {} wires", found.wires),
        (_, false) => "the wire hits the machine or itself".to_owned(),
        (colliding, true) => format!(
            "{colliding} of {} wires {} the machine or {} ({:.1} %)",
            found.wires,
            if colliding == 1 { "hits" } else { "hit" },
            if colliding == 1 { "itself" } else { "themselves" },
            100.0 * found.share
        ),
    };
    writeln!(out, "  {label:<18} {words}")?;
    for contact in &found.diagnostics {
        plan::finding(out, &contact.finding, "plan it again with ")?;
        if several {
            let wires = count(contact.wires as usize, "wire", "wires");
            writeln!(out, "    in {wires}; this is the worst, run {}", contact.run + 1)?;
        }
    }
    Ok(())
}
