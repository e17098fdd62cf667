//! Tables of a frame under load: a row a node, and a row a strut. Comma between columns, a point in numbers, all their digits.

use std::fmt::Write as _;

use super::FrameResult;

/// A row for each node.
#[must_use]
pub fn nodes_csv(frame: &FrameResult) -> String {
    let mut text = "vertex,x_mm,y_mm,z_mm,ux_mm,uy_mm,uz_mm,rx_rad,ry_rad,rz_rad,support\n".to_owned();
    for node in &frame.nodes {
        let _ = write!(text, "{}", node.vertex);
        let figures = [node.position.coords, node.displacement, node.rotation];
        for figure in figures.iter().flat_map(|vector| vector.iter()) {
            let _ = write!(text, ",{figure}");
        }
        let _ = writeln!(text, ",{}", u8::from(node.support));
    }
    text
}

/// A row for each strut; a figure that is not known is an empty field.
#[must_use]
pub fn members_csv(frame: &FrameResult) -> String {
    let mut text =
        "edge,vertex_a,vertex_b,length_mm,axial_n,moment_n_mm,torque_n_mm,von_mises_mpa,utilisation,\
                    buckling_ratio,step\n"
            .to_owned();
    for member in &frame.members {
        let [a, b] = member.ends.map(|end| &frame.nodes[end]);
        let length = (b.position - a.position).norm();
        let _ = write!(text, "{},{},{},{length}", member.edge, a.vertex, b.vertex);
        for figure in [member.axial_n, member.moment_n_mm, member.torque_n_mm] {
            let _ = write!(text, ",{figure}");
        }
        let known = |figure: Option<String>| figure.unwrap_or_default();
        let stress = known(member.von_mises_mpa.map(|figure| figure.to_string()));
        let utilisation = known(member.utilisation.map(|figure| figure.to_string()));
        let step = known(member.step.map(|step| step.to_string()));
        let _ = writeln!(text, ",{stress},{utilisation},{},{step}", member.buckling_ratio);
    }
    text
}
