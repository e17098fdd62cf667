//! How far a fix may move a vertex.

use wirebend_core::plan::Machine;
use wirebend_core::wireframe::{VertexId, Wireframe};
use wirebend_planning::MachineEdges;

use super::super::EditRequest;
use super::trials::{Trial, Trials};

/// An edge of no length is made as long as the machine's shortest by moving its end that far; a lead before a bend, or an
/// edge between sharp corners, is up to twice as long.
const SHORTEST_EDGES: f64 = 2.0;

/// Whether each vertex goes no farther than the shortest edge at it is long, or twice the machine's shortest edge where
/// that is more. Beyond that it is another design and no repair. Where the whole is scaled it goes with all of it: that has a
/// limit of its own.
pub(super) fn is_near(edit: &EditRequest, trial: &Trial, trials: &Trials) -> bool {
    if scales(edit) {
        return true;
    }
    let before = &trials.document().wireframe;
    let mut after = before.clone();
    after.commit(&trial.change.wireframe).is_ok() && stay_near(before, &after, trials.machine())
}

/// The same of all vertices that are still there after any number of edits.
pub(super) fn stay_near(before: &Wireframe, after: &Wireframe, machine: &Machine) -> bool {
    let least = SHORTEST_EDGES * MachineEdges::of(machine).shortest_edge_mm;
    before.vertices().all(|(id, vertex)| {
        after.vertex(id).is_none_or(|moved| {
            let by = (moved.position - vertex.position).norm();
            by <= least || by <= shortest_at(before, id)
        })
    })
}

/// Whether the whole is scaled, alone or among other edits.
pub(super) fn scales(edit: &EditRequest) -> bool {
    match edit {
        EditRequest::Several { edits, .. } => edits.iter().any(scales),
        one => matches!(one, EditRequest::Transform { .. }),
    }
}

/// The length of the shortest edge at a vertex, mm; none of a vertex alone.
fn shortest_at(wireframe: &Wireframe, id: VertexId) -> f64 {
    let lengths = wireframe.incident(id).into_iter().map(|edge| wireframe.edge_length(edge).mm());
    lengths.min_by(f64::total_cmp).unwrap_or(0.0)
}
