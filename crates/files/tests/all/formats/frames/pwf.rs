//! Frames as PWF files have them.

use wirebend_core::wireframe::VertexId;

use crate::formats::import;

/// `g` gives a strut a layer, `c` marks it as ceiling, `p` stands on a foot; each adds a strut that is not there.
#[test]
fn a_pwf_has_layers_and_a_ceiling() {
    let text = "v 0 0 0\nv 9 0 0\nv 9 9 0\nv 0 0 -9\nl 1 2 3\np 1 4\nc 2 1\ng 3 2 4\ng 1 3 5\n";
    let imported = import("a.pwf", text).unwrap();
    let frame = imported.frame.unwrap();
    let layers: Vec<Option<i64>> = frame.members.values().map(|member| member.layer).collect();
    assert_eq!(layers, [None, Some(4), None, Some(5)]);
    let ceiling: Vec<bool> = imported.wireframe.edges().map(|(_, edge)| edge.ceiling).collect();
    assert_eq!(ceiling, [true, false, false, false]);
    assert_eq!(frame.supports.keys().collect::<Vec<_>>(), [&VertexId(3)]);
    assert_eq!(frame.nodes[&4], VertexId(3), "numbers count from 1");
}

/// Loads name the vertices by these numbers, whether there are layers or not.
#[test]
fn a_pwf_without_layers_counts_from_1_too() {
    let nodes = import("a.pwf", "v 0 0 0\nv 0 0 9\nl 1 2\n").unwrap().frame.unwrap().nodes;
    assert_eq!(nodes.into_iter().collect::<Vec<_>>(), [(1, VertexId(0)), (2, VertexId(1))]);
}
