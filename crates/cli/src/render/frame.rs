//! What a frame carries, how it vibrates, how accurate it is, and how good a machine must be for that.

use std::io::Write;

use wirebend_api::{
    ClosingFigures, ClosingName, ClosingReport, FrameResponse, MemberReport, ModeKindName, RequirementName,
    ResourcesReport, StaticReport, ToleranceResponse,
};

use super::number::{self, count, mm};
use super::tables::table;
use super::{notes, plan, written};

/// The most modes that are listed before the rest is left to `--json`.
const LISTED_MODES: usize = 20;

pub(super) fn frame(out: &mut impl Write, found: &FrameResponse) -> std::io::Result<()> {
    notes(out, &found.notes)?;
    let figures = &found.frame;
    let held = match figures.supports {
        0 => "held nowhere".to_owned(),
        supports => format!("held at {}", count(supports, "vertex", "vertices")),
    };
    row(
        out,
        "frame",
        &format!(
            "{} at {}, {} mm of {}, {:.1} g; {held}",
            count(figures.members, "strut", "struts"),
            count(figures.nodes, "vertex", "vertices"),
            mm(figures.length_mm),
            found.material,
            figures.mass_g
        ),
    )?;
    if let Some(statics) = &found.statics {
        carried(out, statics)?;
    }
    modes(out, found)?;
    if let Some(closing) = &found.closing {
        closed(out, found, closing)?;
    }
    if let Some(resources) = &found.resources {
        takes(out, resources)?;
    }
    for finding in &found.diagnostics {
        plan::finding(out, finding, "compute it again with ")?;
    }
    written(out, found.files.iter())
}

/// A share of up to four digits in percent.
fn percent(share: f64) -> f64 {
    (share * 1.0e6).round() / 1.0e4
}

fn row(out: &mut impl Write, label: &str, words: &str) -> std::io::Result<()> {
    writeln!(out, "  {label:<18} {words}")
}

fn carried(out: &mut impl Write, found: &StaticReport) -> std::io::Result<()> {
    let most_displaced = number::or_less(found.max_displacement_mm, 4);
    row(out, "displacement", &format!("{most_displaced} mm at vertex {}", found.at_vertex))?;
    let most = |of: fn(&MemberReport) -> Option<f64>| {
        let known = found.members.iter().filter_map(|member| Some((member, of(member)?)));
        known.max_by(|a, b| a.1.total_cmp(&b.1))
    };
    let used = |share: f64| format!("{:.1} % of what yields", 100.0 * share);
    if let Some((member, stress)) = most(|member| member.von_mises_mpa) {
        let share = member.utilisation.map(|share| format!(", {}", used(share))).unwrap_or_default();
        row(out, "stress", &format!("{stress:.3} MPa in edge {}{share}", member.edge))?;
        // Of several materials another may be nearer to what it bears.
        let nearest = most(|member| member.utilisation);
        if let Some((nearest, share)) = nearest.filter(|(_, share)| Some(*share) > member.utilisation) {
            row(out, "nearest to yield", &format!("edge {}, {}", nearest.edge, used(share)))?;
        }
    }
    match most(|member| Some(member.buckling_ratio)).filter(|&(_, ratio)| ratio > 0.0) {
        Some((member, ratio)) => {
            let percent = 100.0 * ratio;
            row(out, "buckling", &format!("edge {} carries {percent:.1} % of its Euler load", member.edge))
        }
        None => Ok(()),
    }
}

fn modes(out: &mut impl Write, found: &FrameResponse) -> std::io::Result<()> {
    if found.modes.is_empty() {
        return Ok(());
    }
    let rows = found.modes.iter().take(LISTED_MODES).enumerate().map(|(k, mode)| {
        let kind = match (mode.kind, mode.edge) {
            (ModeKindName::Rigid, _) => "the frame moves without bending".to_owned(),
            (ModeKindName::Global, _) => "the frame bends".to_owned(),
            (ModeKindName::Local, edge) => format!("edge {} swings", edge.unwrap_or_default()),
        };
        [(k + 1).to_string(), format!("{:.3} Hz", mode.frequency_hz), kind]
    });
    table(out, ["mode", "frequency", "what moves"], rows)?;
    if let more @ 1.. = found.modes.len().saturating_sub(LISTED_MODES) {
        writeln!(out, "and {more} more: --json has all")?;
    }
    let Some(bowed) = &found.bowed else { return Ok(()) };
    let lowest = bowed.modes.iter().find(|mode| mode.kind != ModeKindName::Rigid);
    let Some(lowest) = lowest else { return Ok(()) };
    let words = format!(
        "the lowest frequency is {:.3} Hz, {:.1} % of that of straight struts",
        lowest.frequency_hz,
        100.0 * bowed.of_straight
    );
    row(out, &format!("bowed by {} %", percent(bowed.share)), &words)
}

fn closed(out: &mut impl Write, found: &FrameResponse, closing: &ClosingReport) -> std::io::Result<()> {
    let figures = &closing.figures;
    let how = match closing.model {
        ClosingName::Aligned => "pulled to its vertices, locked and let go",
        ClosingName::Coupled => "joints rigid from the start",
    };
    let of = match found.runs {
        Some(runs) => format!("root mean squares of {}", count(runs as usize, "wire", "wires")),
        None => "expected of all wires".to_owned(),
    };
    row(out, "closed", &format!("{how}; {of}"))?;
    let sd = found.of_runs.and_then(|runs| runs.sd);
    let spread = |of: fn(&ClosingFigures) -> f64, unit: &str| {
        sd.map(|sd| format!(", ± {:.3} {unit} from wire to wire", of(&sd))).unwrap_or_default()
    };
    let surface = spread(|figures| figures.surface_rms_mm, "mm");
    row(out, "surface", &format!("{:.4} mm{surface}", figures.surface_rms_mm))?;
    if closing.faces.is_some() {
        let vertices = spread(|figures| figures.vertices_rms_mm, "mm");
        row(out, "vertices", &format!("{:.4} mm off the drawing{vertices}", figures.vertices_rms_mm))?;
    }
    let force = spread(|figures| figures.axial_rms_n, "N");
    row(out, "force", &format!("{:.3} N along a strut{force}", figures.axial_rms_n))?;
    let stress = spread(|figures| figures.von_mises_rms_mpa, "MPa");
    row(out, "stress", &format!("{:.2} MPa von Mises{stress}", figures.von_mises_rms_mpa))?;
    if let Some(pull) = figures.largest_pull_n {
        row(out, "largest pull", &format!("{pull:.2} N; {:.2} N mm are stored", figures.energy_n_mm))?;
    }
    match figures.gap_mm {
        Some(gap) => row(out, "gap before", &format!("{gap:.1} mm between passes through one vertex")),
        None => Ok(()),
    }
}

fn takes(out: &mut impl Write, found: &ResourcesReport) -> std::io::Result<()> {
    let energy = match (found.energy_kj, found.time_min) {
        (Some(energy), Some(time)) => format!("; {energy:.2} kJ, {time:.1} min at 25 W"),
        _ => String::new(),
    };
    let joints = match found.joints_g {
        none if none <= 0.0 => String::new(),
        joints => format!(" and {joints:.1} g of joints"),
    };
    let wire = format!("{:.3} m of wire, {}", found.length_mm / 1000.0, count(found.bends, "bend", "bends"));
    row(out, "takes", &format!("{wire}, {:.1} g{joints}{energy}", found.wire_g))
}

pub(super) fn tolerance(out: &mut impl Write, found: &ToleranceResponse) -> std::io::Result<()> {
    notes(out, &found.notes)?;
    if let Some(sigma) = found.feed_sigma_mm {
        row(out, "feeds", &format!("within {} mm (standard deviation)", number::figures(sigma, 5)))?;
    }
    if let Some(sigma) = found.angle_sigma_deg {
        row(out, "bends, rotations", &format!("within {}° (standard deviation)", number::figures(sigma, 4)))?;
    }
    let governs = match found.governed_by {
        RequirementName::Surface => "the surface",
        RequirementName::Force => "the force along struts",
        RequirementName::Stress => "the stress",
    };
    row(out, "governed by", governs)?;
    if let Some(frequency) = &found.first_frequency {
        let straight = format!("{:.3} Hz", frequency.straight_hz);
        let words = if frequency.bow > 0.0 {
            let [least, most] = frequency.bowed_between_hz;
            let bowed =
                format!("{:.3} Hz where struts bow by {} %", frequency.bowed_hz, percent(frequency.bow));
            format!("{straight}; {bowed}, as joints turn between {least:.3} and {most:.3} Hz")
        } else {
            straight
        };
        row(out, "first frequency", &words)?;
    }
    let achieved = &found.achieved;
    let stress = achieved.stress_mpa.map(|stress| format!(", {stress:.2} MPa")).unwrap_or_default();
    row(out, "achieved", &format!("{:.4} mm, {:.3} N{stress}", achieved.surface_mm, achieved.force_n))
}
