//! The route along all edges.

use wirebend_core::wireframe::EdgeId;

pub(super) fn no_euler_path(odd: usize, allowed: usize) -> String {
    let wires = match allowed {
        0 => "no closed wire runs".to_owned(),
        2 => "no single wire runs".to_owned(),
        more => format!("no {} wires run", more / 2),
    };
    format!("{odd} vertices are odd: {wires} through every edge once")
}

pub(super) fn doubled_edge(edge: EdgeId, passes: usize) -> String {
    format!("edge {edge} is made of {passes} wires side by side")
}
