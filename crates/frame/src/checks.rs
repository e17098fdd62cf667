//! Whether a model describes a frame.

use nalgebra::Vector3;

use crate::error::ModelError;
use crate::model::{MemberId, Model, NodeId, SectionId};
use crate::section::Section;

pub(crate) fn check(model: &Model) -> Result<(), ModelError> {
    for (k, node) in model.nodes.iter().enumerate() {
        if !node.coords.iter().all(|value| value.is_finite()) {
            return Err(ModelError::NodeNotFinite { node: NodeId(k) });
        }
    }
    for (k, section) in model.sections.iter().enumerate() {
        check_section(SectionId(k), section)?;
    }
    for k in 0..model.members.len() {
        check_member(model, MemberId(k))?;
    }
    let nodes = model.nodes.len();
    for support in &model.supports {
        if support.node.0 >= nodes {
            return Err(ModelError::UnknownSupport { node: support.node, nodes });
        }
    }
    Ok(())
}

fn check_section(id: SectionId, section: &Section) -> Result<(), ModelError> {
    let figures = [
        ("area", section.area),
        ("iy", section.iy),
        ("iz", section.iz),
        ("j", section.j),
        ("radius", section.radius),
        ("e", section.e),
        ("g", section.g),
        ("yield_strength", section.yield_strength),
    ];
    for (figure, value) in figures {
        if !(value.is_finite() && value > 0.0) {
            return Err(ModelError::SectionFigure { section: id, figure, value });
        }
    }
    if !(section.density.is_finite() && section.density >= 0.0) {
        return Err(ModelError::SectionFigure { section: id, figure: "density", value: section.density });
    }
    Ok(())
}

fn check_member(model: &Model, id: MemberId) -> Result<(), ModelError> {
    let member = &model.members[id.0];
    let nodes = model.nodes.len();
    for node in [member.a, member.b] {
        if node.0 >= nodes {
            return Err(ModelError::UnknownNode { member: id, node, nodes });
        }
    }
    let sections = model.sections.len();
    if member.section.0 >= sections {
        return Err(ModelError::UnknownSection { member: id, section: member.section, sections });
    }
    let span = model.nodes[member.b.0] - model.nodes[member.a.0];
    // Below this a stiffness of 12 E I / L³ is no number any more.
    if span.norm() < f64::MIN_POSITIVE.powf(0.25) {
        return Err(ModelError::NoLength { member: id, a: member.a, b: member.b });
    }
    if let Some(up) = member.up {
        let across = up.cross(&span).norm() / (up.norm() * span.norm());
        if across.is_nan() || across < ALONG || up == Vector3::zeros() {
            return Err(ModelError::UpAlongMember { member: id });
        }
    }
    Ok(())
}

/// The sine of the angle from which on two directions are not told apart.
const ALONG: f64 = 1e-9;
