//! The route along all edges.

use wirebend_core::wireframe::EdgeId;

use super::number::count;

pub(super) fn no_euler_path(odd: usize, allowed: usize) -> String {
    let wires = match allowed {
        0 => "cannot be a closed wire".to_owned(),
        2 => "needs more than one wire".to_owned(),
        more => format!("needs more than {} wires", more / 2),
    };
    format!("{wires} ({})", count(odd, "odd corner", "odd corners"))
}

pub(super) fn doubled_edge(edge: EdgeId, passes: usize) -> String {
    format!("edge {edge} is made of {passes} wires side by side")
}
