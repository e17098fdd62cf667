//! The joints of a design, in words and numbers for a person.

use std::collections::BTreeMap;

use wirebend_core::wireframe::{Joint, JointKind, VertexId};

/// A line for each kind and mass of joint: how many, what they weigh together, and where they are. Then the sum, where there are
/// several kinds.
pub(super) fn lines(joints: &[(VertexId, Joint)]) -> Vec<String> {
    // Milligrams tell masses apart as well as any scale.
    let key = |joint: &Joint| (order(joint.kind), (joint.mass_g * 1000.0).round().to_bits());
    let mut groups: BTreeMap<_, (Joint, Vec<VertexId>)> = BTreeMap::new();
    for (id, joint) in joints {
        groups.entry(key(joint)).or_insert((*joint, Vec::new())).1.push(*id);
    }
    let mass = |count: usize, joint: &Joint| {
        #[allow(clippy::cast_precision_loss)] // a count of vertices
        let count = count as f64;
        count * joint.mass_g
    };
    let line = |(joint, at): &(Joint, Vec<VertexId>)| {
        let count = at.len();
        let (one, many) = words(joint.kind);
        let places: Vec<String> = at.iter().map(ToString::to_string).collect();
        let each = if count > 1 { format!(" of {} g", joint.mass_g) } else { String::new() };
        let what = if count > 1 { format!("{count} {many}") } else { format!("1 {one}") };
        let at = if count > 1 { "vertices" } else { "vertex" };
        format!("{what}{each}, {:.1} g: {at} {}", mass(count, joint), places.join(", "))
    };
    let mut lines: Vec<String> = groups.values().map(line).collect();
    if lines.len() > 1 {
        let sum: f64 = joints.iter().map(|(_, joint)| joint.mass_g).sum();
        lines.push(format!("{} joints, {sum:.1} g", joints.len()));
    }
    lines
}

const fn order(kind: JointKind) -> u8 {
    match kind {
        JointKind::SnapFit => 0,
        JointKind::Solder => 1,
        JointKind::ZipTie => 2,
    }
}

const fn words(kind: JointKind) -> (&'static str, &'static str) {
    match kind {
        JointKind::SnapFit => ("snap-fit joint", "snap-fit joints"),
        JointKind::Solder => ("soldered joint", "soldered joints"),
        JointKind::ZipTie => ("zip tie", "zip ties"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn joints_are_counted_by_kind_and_mass() {
        let snap = |mass_g| Joint { kind: JointKind::SnapFit, mass_g };
        let tie = Joint { kind: JointKind::ZipTie, mass_g: 0.3 };
        let joints = [(0, snap(1.2)), (4, tie), (7, snap(1.2)), (9, snap(2.0))];
        let joints = joints.map(|(id, joint)| (VertexId(id), joint));
        assert_eq!(
            lines(&joints),
            [
                "2 snap-fit joints of 1.2 g, 2.4 g: vertices 0, 7",
                "1 snap-fit joint, 2.0 g: vertex 9",
                "1 zip tie, 0.3 g: vertex 4",
                "4 joints, 4.7 g"
            ]
        );
        assert_eq!(lines(&joints[1..2]), ["1 zip tie, 0.3 g: vertex 4"]);
        assert!(lines(&[]).is_empty());
    }
}
