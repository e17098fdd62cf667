//! The route along all edges.

use wirebend_core::wireframe::EdgeId;

pub(super) fn no_euler_path(odd: usize, allowed: usize) -> String {
    let wire = if allowed == 0 { "closed wire" } else { "single wire" };
    format!("{odd} vertices are odd: no {wire} runs through every edge once")
}

pub(super) fn doubled_edge(edge: EdgeId, passes: usize) -> String {
    format!("edge {edge} is made of {passes} wires side by side")
}
