//! Bends and corners.

use wirebend_core::checks::{BendOf, Location};
use wirebend_core::compensate::NearCorner;
use wirebend_core::units::{Angle, Length};
use wirebend_core::wireframe::VertexId;

use super::number::{digits_apart, digits_beside, of_bend};

pub(super) fn too_sharp(at: &Location, of: BendOf, bend: Angle, limit: Angle) -> String {
    let digits = digits_beside(bend.abs().deg(), limit.abs().deg());
    let limit = match of {
        BendOf::Step | BendOf::Forced => limit,
        BendOf::Vertex => limit.abs(),
    };
    format!(
        "{} is {bend:.digits$}, more than the machine can bend ({limit:.digits$}){}",
        name(at, of),
        unavoidable(of)
    )
}

pub(super) fn near_limit(at: &Location, bend: Angle, limit: Angle) -> String {
    let digits = digits_beside(bend.abs().deg(), limit.abs().deg());
    format!(
        "{} is {bend:.digits$}, close to the most the machine can bend ({limit:.digits$})",
        name(at, BendOf::Step)
    )
}

pub(super) fn out_of_reach(at: &Location, of: BendOf, bend: Angle, max: Angle) -> String {
    let side = match of {
        BendOf::Step | BendOf::Forced => "to this side",
        BendOf::Vertex => "to either side",
    };
    let digits = digits_apart(bend.abs().deg(), max.deg(), 2);
    format!(
        "{} is {bend:.digits$}, out of reach: the largest possible bend {side} is {max:.digits$}{}",
        name(at, of),
        unavoidable(of)
    )
}

pub(super) fn too_small(at: &Location, bend: Angle) -> String {
    format!(
        "{} is {bend:.2}, too small: the peg would stop on the far side of the wire's axis",
        name(at, BendOf::Step)
    )
}

pub(super) fn lead_too_short(at: &Location, lead: Length, needed: Length) -> String {
    let digits = digits_apart(lead.mm(), needed.mm(), 1);
    format!(
        "{} cannot be pressed: the wire before it ends {lead:.digits$} from where the bend begins, and the peg needs {needed:.digits$}",
        name(at, BendOf::Step)
    )
}

pub(super) fn corner_too_near(at: &Location, bend: Angle) -> String {
    format!(
        "{} is {bend:.2} and cannot be pressed: the corner before it is within the peg's reach, which meets the wire too early, \
         too late or not at all",
        name(at, BendOf::Step)
    )
}

pub(super) fn corner_within_reach(at: &Location, near: &NearCorner) -> String {
    let goes = match near.further {
        Some(further) if further.abs().deg() < 0.05 => {
            "and the axis goes as far as for a straight leg".to_owned()
        }
        Some(further) if further < Angle::ZERO => {
            format!("so the axis goes {:.1} less far than for a straight leg", further.abs())
        }
        Some(further) => format!("so the axis goes {further:.1} further than for a straight leg"),
        None => "so the axis goes elsewhere than for a straight leg".to_owned(),
    };
    let gives = if near.past_other {
        ". It touches beyond a corner of another plane or to the other side, which may bend as well"
    } else {
        ""
    };
    format!("{}: the peg touches wire that was bent before, {goes}{gives}", name(at, BendOf::Step))
}

pub(super) fn head_not_measured(bends: usize) -> String {
    let bends = if bends == 1 { "1 bend".to_owned() } else { format!("{bends} bends") };
    format!(
        "the bend head of this machine was not measured: {bends} where the peg touches wire that was bent before may come \
         out some degrees off"
    )
}

pub(super) fn in_scatter(at: &Location, bend: Angle, scatter: Angle) -> String {
    let digits = digits_apart(bend.deg(), scatter.deg(), 1);
    format!(
        "{} is {bend:.digits$}, less than the scatter of bends on this machine ({scatter:.digits$}): \
         it may come out to either side",
        name(at, BendOf::Step)
    )
}

pub(super) fn corner_not_made(vertex: VertexId, corner: Angle) -> String {
    format!(
        "the corner at vertex {vertex} is {corner:.3}, below the resolution of the bend axis: the wire stays straight there, and the next bend starts from its real direction"
    )
}

pub(super) fn fold_back(at: &Location) -> String {
    format!("the wire folds straight back on itself{}", of_bend(at))
}

pub(super) fn fold_back_not_compensated(at: &Location, bend: Angle) -> String {
    format!(
        "{} is {bend:.2}: the wire folds back on itself, and the feeds on both sides cannot be compensated",
        name(at, BendOf::Step)
    )
}

fn unavoidable(of: BendOf) -> &'static str {
    match of {
        BendOf::Step | BendOf::Vertex => "",
        BendOf::Forced => "; no other order of the edges avoids it",
    }
}

fn name(at: &Location, of: BendOf) -> String {
    let bend = match of {
        BendOf::Step | BendOf::Forced => "the bend",
        BendOf::Vertex => "whichever way the wire runs, the sharpest bend",
    };
    format!("{bend}{}", of_bend(at))
}
