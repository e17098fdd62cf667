//! VTK legacy file of a frame, as `ParaView` opens it: a line for each strut, with figures at nodes and struts.

use std::fmt::Write as _;

use super::{ClosedResult, FrameResult, ResultNode};

/// A line of the format holds no more of a title.
const TITLE: usize = 200;
/// The format's number of a line cell.
const LINE: usize = 3;

/// Writes a frame. Points stand where nodes are without load: `displacement_mm` bends the picture (`ParaView`: Warp By Vector). Stress is
/// left out where it is not known of a strut, utilisation where a yield strength is missing, and `step` where a strut has none.
#[must_use]
pub fn vtk(frame: &FrameResult) -> String {
    let members = || frame.members.iter();
    let mut text = grid(&frame.title, &frame.nodes, members().map(|member| member.ends));
    scalars(&mut text, "edge int", members().map(|member| Some(member.edge.0)));
    scalars(&mut text, "axial_n double", members().map(|member| Some(member.axial_n)));
    scalars(&mut text, "moment_n_mm double", members().map(|member| Some(member.moment_n_mm)));
    scalars(&mut text, "torque_n_mm double", members().map(|member| Some(member.torque_n_mm)));
    scalars(&mut text, "von_mises_mpa double", members().map(|member| member.von_mises_mpa));
    scalars(&mut text, "utilisation double", members().map(|member| member.utilisation));
    scalars(&mut text, "buckling_ratio double", members().map(|member| Some(member.buckling_ratio)));
    scalars(&mut text, "step int", members().map(|member| member.step));
    text
}

/// Writes a frame of wires whose joints are closed, in the same form: a line for each strut of each wire, so that a strut that is
/// walked along twice has two.
#[must_use]
pub fn closed_vtk(frame: &ClosedResult) -> String {
    let struts = || frame.struts.iter();
    let mut text = grid(&frame.title, &frame.nodes, struts().map(|strut| strut.ends));
    scalars(&mut text, "edge int", struts().map(|strut| Some(strut.edge.0)));
    scalars(&mut text, "wire int", struts().map(|strut| Some(strut.wire)));
    scalars(&mut text, "axial_n double", struts().map(|strut| Some(strut.axial_n)));
    scalars(&mut text, "von_mises_rms_mpa double", struts().map(|strut| Some(strut.von_mises_rms_mpa)));
    text
}

/// Points with their displacements, and the lines between them; figures of lines come after it.
fn grid(title: &str, nodes: &[ResultNode], lines: impl ExactSizeIterator<Item = [usize; 2]>) -> String {
    let title: String = title.chars().filter(|letter| !letter.is_control()).take(TITLE).collect();
    let title = if title.is_empty() { "frame" } else { &title };
    let (points, count) = (nodes.len(), lines.len());
    let mut text = format!("# vtk DataFile Version 3.0\n{title}\nASCII\nDATASET UNSTRUCTURED_GRID\n");
    let _ = writeln!(text, "POINTS {points} double");
    for node in nodes {
        let _ = writeln!(text, "{} {} {}", node.position.x, node.position.y, node.position.z);
    }
    let _ = writeln!(text, "CELLS {count} {}", 3 * count);
    for [a, b] in lines {
        let _ = writeln!(text, "2 {a} {b}");
    }
    let _ = writeln!(text, "CELL_TYPES {count}");
    for _ in 0..count {
        let _ = writeln!(text, "{LINE}");
    }
    let _ = writeln!(text, "POINT_DATA {points}\nVECTORS displacement_mm double");
    for node in nodes {
        let u = node.displacement;
        let _ = writeln!(text, "{} {} {}", u.x, u.y, u.z);
    }
    scalars(&mut text, "vertex int", nodes.iter().map(|node| Some(node.vertex.0)));
    scalars(&mut text, "support int", nodes.iter().map(|node| Some(u8::from(node.support))));
    let _ = writeln!(text, "CELL_DATA {count}");
    text
}

/// A figure of each; nothing where one is missing.
fn scalars<T: std::fmt::Display>(text: &mut String, name: &str, values: impl Iterator<Item = Option<T>>) {
    let Some(values) = values.collect::<Option<Vec<T>>>() else { return };
    let _ = writeln!(text, "SCALARS {name} 1\nLOOKUP_TABLE default");
    for value in values {
        let _ = writeln!(text, "{value}");
    }
}
