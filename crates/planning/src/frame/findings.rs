//! What is wrong with a frame, as findings.

use wirebend_core::checks::{Diagnostic, Fact, Location, Remedy, Severity};
use wirebend_core::units::Length;
use wirebend_core::wireframe::EdgeId;
use wirebend_frame::{MemberId, Unstable};

use super::material::FrameMaterial;
use super::report::{MemberReport, StaticReport};
use super::structure::Structure;

/// From this share of its Euler load on a strut is named.
const NEAR_BUCKLING: f64 = 0.5;

/// A frame that does not stand.
pub(super) fn unstable(structure: &Structure, unstable: &Unstable) -> Diagnostic {
    let vertex = |node: wirebend_frame::NodeId| structure.vertices.get(node.0).copied();
    let (at, edges, fact) = match unstable {
        Unstable::PartWithoutSupport { node, members } => {
            let edges = members.iter().filter_map(|member| structure.edges.get(member.0).copied()).collect();
            (vertex(*node), edges, Fact::FrameUnsupported { edges: members.len(), whole: !structure.held })
        }
        Unstable::Mechanism { node } => (vertex(*node), Vec::new(), Fact::FrameMechanism),
        Unstable::TooSoft { node, displacement_mm, size_mm } => {
            // More than any length: it moves freely.
            let lengths = Length::from_mm(*displacement_mm).ok().zip(Length::from_mm(*size_mm).ok());
            let fact = lengths.map_or(Fact::FrameMechanism, |(displacement, size)| Fact::FrameHardlyStands {
                displacement,
                size,
            });
            (vertex(*node), Vec::new(), fact)
        }
    };
    let remedies = match fact {
        Fact::FrameUnsupported { whole: false, .. } => vec![Remedy::SupportVertices, Remedy::ConnectParts],
        Fact::FrameUnsupported { .. } => vec![Remedy::SupportVertices],
        _ => vec![Remedy::SupportVertices, Remedy::BraceFrame],
    };
    Diagnostic {
        severity: Severity::Error,
        location: Location { vertices: at.into_iter().collect(), edges, step: None },
        fact,
        remedies,
    }
}

/// Struts that yield, and struts near buckling: one finding each, with the worst strut foremost.
pub(super) fn strong_enough(
    structure: &Structure,
    material: &FrameMaterial,
    report: &StaticReport,
) -> Vec<Diagnostic> {
    let used = |member: &MemberReport| member.utilisation.unwrap_or(0.0);
    let yields = |member: &MemberReport| {
        let place = structure.edges.binary_search(&EdgeId(member.edge)).unwrap_or_default();
        structure.assembly.section(MemberId(place)).yield_strength
    };
    let yielding = worst_first(report, used, 1.0).map(|(edges, worst)| Diagnostic {
        severity: Severity::Error,
        location: Location::at_edges(edges),
        fact: Fact::StrutOverstressed {
            stress_mpa: worst.von_mises_mpa.unwrap_or_default(),
            yield_mpa: yields(worst),
            source: material.yield_source.clone(),
        },
        remedies: vec![Remedy::BraceFrame, Remedy::SupportVertices, Remedy::ChooseMaterial],
    });
    let buckling =
        worst_first(report, |member| member.buckling_ratio, NEAR_BUCKLING).map(|(edges, worst)| Diagnostic {
            severity: if worst.buckling_ratio >= 1.0 { Severity::Error } else { Severity::Warning },
            location: Location::at_edges(edges),
            fact: Fact::StrutNearBuckling { ratio: worst.buckling_ratio, limit: NEAR_BUCKLING },
            remedies: vec![Remedy::BraceFrame, Remedy::ChooseMaterial],
        });
    yielding.into_iter().chain(buckling).collect()
}

/// The struts whose figure is at least a limit, the worst foremost, and that.
fn worst_first(
    report: &StaticReport,
    of: impl Fn(&MemberReport) -> f64,
    limit: f64,
) -> Option<(Vec<EdgeId>, &MemberReport)> {
    let mut over: Vec<&MemberReport> = report.members.iter().filter(|member| of(member) >= limit).collect();
    over.sort_by(|a, b| of(b).total_cmp(&of(a)));
    let worst = over.first().copied()?;
    Some((over.iter().map(|member| EdgeId(member.edge)).collect(), worst))
}
