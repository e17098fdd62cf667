//! What a check says whichever way a frame is turned on the ground, whatever its vertices and edges are called, and from whichever end
//! its edges were drawn.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use nalgebra::{Rotation3, Vector3};
use proptest::prelude::*;
use wirebend_core::checks::sequence::Violation;
use wirebend_core::wireframe::{Edge, EdgeId, Vertex, VertexId, Wireframe};
use wirebend_sequence::{Checked, GivenJoint, GivenStep, Groups, Structure, Task, check};

use super::confirm::searched;
use super::frames::{abs, assembly, builder};

/// A frame and steps, of which something is wrong or nothing.
#[derive(Clone)]
struct Case {
    name: &'static str,
    frame: Wireframe,
    steps: Vec<GivenStep>,
}

/// A frame as others draw it.
#[derive(Debug, Clone)]
struct Redrawn {
    turn: Rotation3<f64>,
    vertices: BTreeMap<VertexId, VertexId>,
    edges: BTreeMap<EdgeId, EdgeId>,
    /// The edges that begin at their other end.
    swapped: Vec<EdgeId>,
}

impl Redrawn {
    /// As it is.
    fn same(frame: &Wireframe) -> Self {
        Self {
            turn: Rotation3::identity(),
            vertices: frame.vertices().map(|(id, _)| (id, id)).collect(),
            edges: frame.edges().map(|(id, _)| (id, id)).collect(),
            swapped: Vec::new(),
        }
    }

    /// Numbers with gaps, in the order of keys.
    fn renumbered<T: Copy + Ord>(
        those: impl Iterator<Item = T>,
        keys: &[u32],
        number: impl Fn(u32) -> T,
    ) -> BTreeMap<T, T> {
        let those: Vec<T> = those.collect();
        let mut order: Vec<usize> = (0..those.len()).collect();
        order.sort_by_key(|&k| (keys[k], k));
        order.into_iter().zip((3..).step_by(5)).map(|(k, new)| (those[k], number(new))).collect()
    }

    fn frame(&self, frame: &Wireframe) -> Wireframe {
        let mut made = Wireframe::new();
        for (id, vertex) in frame.vertices() {
            let position = self.turn * vertex.position;
            made.insert_vertex(self.vertices[&id], Vertex { position, ..vertex }).unwrap();
        }
        for (id, edge) in frame.edges() {
            let [a, b] = if self.swapped.contains(&id) { [edge.b, edge.a] } else { [edge.a, edge.b] };
            let edge = Edge { a: self.vertices[&a], b: self.vertices[&b], ..edge };
            made.insert_edge(self.edges[&id], edge).unwrap();
        }
        made
    }

    fn steps(&self, steps: &[GivenStep]) -> Vec<GivenStep> {
        let joint = |joint: &GivenJoint| GivenJoint {
            vertex: self.vertices[&joint.vertex],
            directions: joint.directions.iter().map(|axis| self.turn * axis).collect(),
        };
        let step = |step: &GivenStep| GivenStep {
            edges: step.edges.iter().map(|edge| self.edges[edge]).collect(),
            kind: step.kind,
            joints: step.joints.iter().map(joint).collect(),
        };
        steps.iter().map(step).collect()
    }
}

fn checked(frame: &Wireframe, steps: &[GivenStep]) -> Checked {
    let (structure, builder, weight) = (Structure::new(frame).unwrap(), builder(), abs());
    let groups = Groups::single(&structure);
    check(&Task { structure: &structure, groups: &groups, builder: &builder, weight: &weight }, steps)
}

/// What is measured of a violation, mm or radian.
fn figures(violation: &Violation) -> Vec<f64> {
    match violation {
        Violation::Approach { angle, max, .. } => vec![angle.rad(), max.rad()],
        Violation::HeadMeets { distance, least, .. } => vec![distance.mm(), least.mm()],
        Violation::Sags { sag, max, .. } => sag.iter().chain([max]).map(|length| length.mm()).collect(),
        _ => Vec::new(),
    }
}

fn same(found: f64, wanted: f64) -> bool {
    (found - wanted).abs() <= 1e-9 * wanted.abs()
}

/// The check says the same of a frame that is drawn in another way.
fn says_the_same(case: &Case, redrawn: &Redrawn) -> Result<(), TestCaseError> {
    let wanted = checked(&case.frame, &case.steps);
    let found = checked(&redrawn.frame(&case.frame), &redrawn.steps(&case.steps));
    prop_assert_eq!(&found.kinds, &wanted.kinds);
    prop_assert_eq!(&found.free, &wanted.free);
    prop_assert_eq!(&found.first_free, &wanted.first_free);
    prop_assert_eq!(found.sags_mm.len(), wanted.sags_mm.len());
    for (found, wanted) in found.sags_mm.iter().zip(&wanted.sags_mm) {
        let alike = found.zip(*wanted).map_or(found == wanted, |(found, wanted)| same(found, wanted));
        prop_assert!(alike, "{found:?} instead of {wanted:?}");
    }
    prop_assert_eq!(found.violations.len(), wanted.violations.len());
    for (found, wanted) in found.violations.iter().zip(&wanted.violations) {
        prop_assert_eq!(std::mem::discriminant(found), std::mem::discriminant(wanted));
        prop_assert_eq!(found.step(), wanted.step());
        // Of what falls any vertex may be named.
        if !matches!(wanted, Violation::Sags { sag: None, .. }) {
            prop_assert_eq!(found.vertex(), wanted.vertex().map(|vertex| redrawn.vertices[&vertex]));
        }
        let mut edges: Vec<EdgeId> = wanted.edges().iter().map(|edge| redrawn.edges[edge]).collect();
        edges.sort_unstable();
        prop_assert_eq!(found.edges(), edges);
        let (found_mm, wanted_mm) = (figures(found), figures(wanted));
        prop_assert_eq!(found_mm.len(), wanted_mm.len());
        let alike = found_mm.iter().zip(&wanted_mm).all(|(found, wanted)| same(*found, *wanted));
        prop_assert!(alike, "{found:?} instead of {wanted:?}");
    }
    Ok(())
}

/// A pillar whose arm carries a post, and another pillar with a beam that holds the first. Nothing of it is like anything else in it.
fn stage() -> Wireframe {
    let points = [
        [0.0; 3],
        [1.0, -2.0, 40.0],
        [-60.0, 3.0, 0.0],
        [-58.0, 4.0, 41.0],
        [99.0, 7.0, 40.0],
        [98.0, 6.0, 50.0],
    ];
    let mut made = Wireframe::new();
    for point in points {
        made.add_vertex(Vertex { support: point[2] == 0.0, ..Vertex::at(point.into()) }).unwrap();
    }
    for [a, b] in [[0, 1], [2, 3], [3, 1], [1, 4], [4, 5]] {
        made.add_edge(VertexId(a), VertexId(b)).unwrap();
    }
    made
}

/// A frame with the sequence that is found for it. At each joint some directions are given beside the one that was chosen.
fn built(name: &'static str, frame: Wireframe) -> Case {
    let (structure, builder) = (Structure::new(&frame).unwrap(), builder());
    let outcome = searched(&structure, &Groups::single(&structure), &builder);
    assert!(outcome.is_found(), "{name}: {:?}", outcome.obstacle);
    let steps = outcome.steps.iter().map(|step| {
        let mut given = GivenStep::of(step, &structure, &builder);
        for joint in &mut given.joints {
            let others = builder.directions.all().iter().step_by(19).map(|axis| axis.into_inner());
            joint.directions.extend(others);
        }
        given
    });
    let steps = steps.collect();
    Case { name, frame, steps }
}

/// Sequences that can be built.
static BUILT: LazyLock<Vec<Case>> = LazyLock::new(|| {
    let drawn = |name| built(name, assembly(name));
    vec![built("stage", stage()), drawn("simple_frame"), drawn("four-frame")]
});

/// Sequences of which something is wrong.
static SPOILT: LazyLock<Vec<Case>> = LazyLock::new(|| {
    let [stage, simple, _] = &BUILT[..] else { panic!("three frames") };
    let spoil = |case: &Case, name, change: &dyn Fn(&mut Vec<GivenStep>)| {
        let mut steps = case.steps.clone();
        change(&mut steps);
        Case { name, frame: case.frame.clone(), steps }
    };
    let place = |edge| stage.steps.iter().position(|step| step.edges == [EdgeId(edge)]).unwrap();
    let (beam, arm, post) = (place(2), place(3), place(4));
    // Along its way a head meets what goes on from the end of a strut.
    let along = |steps: &mut Vec<GivenStep>| {
        for step in steps {
            let edge = simple.frame.edge(step.edges[0]).unwrap();
            let [a, b] = [edge.a, edge.b].map(|end| simple.frame.vertex(end).unwrap().position);
            let way = if step.joints[0].vertex == edge.a { b - a } else { a - b };
            step.joints[0].directions = vec![way.normalize()];
        }
    };
    let leaning = |steps: &mut Vec<GivenStep>| {
        steps[arm].joints[0].directions = vec![Vector3::new(-0.5, 0.3, 0.8), Vector3::new(-0.6, 0.3, 0.8)];
    };
    vec![
        spoil(stage, "it sags", &|steps| steps.swap(beam, arm)),
        spoil(stage, "it hangs on nothing", &|steps| {
            let moved = steps.remove(post);
            steps.insert(0, moved);
        }),
        spoil(stage, "the head leans", &leaning),
        spoil(stage, "a strut is missing", &|steps| steps.truncate(arm)),
        spoil(simple, "the head meets struts", &along),
    ]
});

/// Each is refused for its own reason, at its own step.
#[test]
fn what_is_spoilt_is_refused_and_the_rest_is_not() {
    for case in &*BUILT {
        assert_eq!(checked(&case.frame, &case.steps).violations, [], "{}", case.name);
    }
    let found = SPOILT.iter().map(|case| checked(&case.frame, &case.steps).violations);
    let found: Vec<Vec<Violation>> = found.collect();
    assert!(matches!(found[0][..], [Violation::Sags { sag: Some(_), .. }]), "{:?}", found[0]);
    assert!(matches!(found[1][0], Violation::Floating { step: 1, .. }), "{:?}", found[1]);
    assert!(matches!(found[2][..], [Violation::Approach { .. }]), "{:?}", found[2]);
    assert!(matches!(found[3][..], [Violation::Missing { .. }]), "{:?}", found[3]);
    let meets = found[4].iter().filter(|found| matches!(found, Violation::HeadMeets { .. })).count();
    assert!(meets == found[4].len() && meets > 3, "{:?}", found[4]);
}

fn keys() -> impl Strategy<Value = Vec<u32>> {
    prop::collection::vec(any::<u32>(), 24)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(5))]

    #[test]
    fn it_does_not_matter_how_a_frame_is_turned_on_the_ground(rad in -3.2..3.2_f64) {
        for case in BUILT.iter().chain(&*SPOILT) {
            let turn = Rotation3::new(Vector3::z() * rad);
            says_the_same(case, &Redrawn { turn, ..Redrawn::same(&case.frame) })?;
        }
    }

    #[test]
    fn it_does_not_matter_what_vertices_and_edges_are_called(of_vertices in keys(), of_edges in keys()) {
        for case in BUILT.iter().chain(&*SPOILT) {
            let vertices = Redrawn::renumbered(case.frame.vertices().map(|(id, _)| id), &of_vertices, VertexId);
            let edges = Redrawn::renumbered(case.frame.edges().map(|(id, _)| id), &of_edges, EdgeId);
            says_the_same(case, &Redrawn { vertices, edges, ..Redrawn::same(&case.frame) })?;
        }
    }

    #[test]
    fn it_does_not_matter_from_which_end_an_edge_is_drawn(which in any::<u32>()) {
        for case in BUILT.iter().chain(&*SPOILT) {
            let swapped = case.frame.edges().map(|(id, _)| id).filter(|id| which >> (id.0 % 32) & 1 == 1);
            says_the_same(case, &Redrawn { swapped: swapped.collect(), ..Redrawn::same(&case.frame) })?;
        }
    }
}
