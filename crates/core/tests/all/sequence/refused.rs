//! Sequences that cannot be built are refused, each with its reason.

use std::ops::ControlFlow;

use nalgebra::Vector3;
use wirebend_core::sequence::{
    GivenStep, Groups, Outcome, SearchOptions, StepKind, Structure, Task, Violation, check, search,
};
use wirebend_core::units::Length;
use wirebend_core::wireframe::EdgeId;

use super::brute;
use super::frames::{abs, assembly, builder};

/// A frame of 19 struts with a sequence that can be built.
struct Built {
    structure: Structure,
    outcome: Outcome,
    given: Vec<GivenStep>,
}

fn built() -> Built {
    let structure = Structure::new(&assembly("simple_frame")).unwrap();
    let (builder, weight, groups) = (builder(), abs(), Groups::single(&structure));
    let task = Task { structure: &structure, groups: &groups, builder: &builder, weight: &weight };
    let outcome = search(&task, &SearchOptions::default(), &mut |_| ControlFlow::Continue(())).unwrap();
    let given = outcome.steps.iter().map(|step| GivenStep::of(step, &structure, &builder)).collect();
    Built { structure, outcome, given }
}

impl Built {
    /// What is found in a sequence after a change, and by brute force.
    fn with(&self, max_sag_mm: f64, change: impl Fn(&mut Vec<GivenStep>)) -> (Vec<Violation>, Vec<String>) {
        let (weight, groups) = (abs(), Groups::single(&self.structure));
        let mut builder = builder();
        builder.max_sag = Length::from_mm(max_sag_mm).unwrap();
        let task = Task { structure: &self.structure, groups: &groups, builder: &builder, weight: &weight };
        let mut steps = self.given.clone();
        change(&mut steps);
        let whole = steps.iter().all(|step| {
            step.edges.iter().all(|&edge| self.structure.strut_of(edge).is_some())
                && !step.edges.is_empty()
                && !step.joints.is_empty()
        });
        let faults = if whole { brute::faults(&task, &steps) } else { Vec::new() };
        (check(&task, &steps).violations, faults)
    }

    fn first(&self, kind: StepKind) -> usize {
        self.outcome.steps.iter().position(|step| step.kind == kind).unwrap()
    }
}

macro_rules! refused {
    ($found:expr, $pattern:pat) => {{
        let found = $found;
        assert!(found.iter().any(|violation| matches!(violation, $pattern)), "{found:?}");
    }};
}

#[test]
fn each_way_to_spoil_a_sequence_is_refused_for_its_own_reason() {
    let built = built();
    let (create, connect, last) =
        (built.first(StepKind::Create), built.first(StepKind::Connect), built.given.len() - 1);
    let spoilt = |change: &dyn Fn(&mut Vec<GivenStep>)| built.with(0.65, change);
    assert_eq!(spoilt(&|_| {}), (Vec::new(), Vec::new()));
    refused!(
        spoilt(&|steps| steps[create].edges = vec![EdgeId(9999)]).0,
        Violation::UnknownEdge { edge: EdgeId(9999), .. }
    );
    refused!(spoilt(&|steps| steps[create].edges.clear()).0, Violation::Empty { .. });
    let (found, _) = spoilt(&|steps| steps.push(steps[create].clone()));
    assert_eq!(
        found,
        [Violation::Twice { step: last + 2, edge: built.given[create].edges[0], first: create + 1 }]
    );
    let (found, faults) = spoilt(&|steps| steps.truncate(last));
    assert_eq!(found, [Violation::Missing { edges: built.given[last].edges.clone() }]);
    assert_eq!(faults, ["struts are missing"]);
    refused!(
        spoilt(&|steps| steps[last].joints[0].vertex = steps[0].joints[0].vertex).0,
        Violation::NotAnEnd { .. }
    );
    refused!(spoilt(&|steps| steps[last].joints.clear()).0, Violation::JointMissing { .. });
    refused!(
        spoilt(&|steps| steps[create].kind = Some(StepKind::Connect)).0,
        Violation::WrongKind { said: StepKind::Connect, is: StepKind::Create, .. }
    );
    for none in
        [Vector3::zeros(), Vector3::x() * 1e200, Vector3::x() * f64::INFINITY, Vector3::x() * f64::NAN]
    {
        refused!(
            spoilt(&|steps| steps[create].joints[0].directions = vec![none]).0,
            Violation::NoDirection { .. }
        );
    }
    refused!(
        spoilt(&|steps| {
            let ground = steps.remove(0);
            steps.push(ground);
        })
        .0,
        Violation::GroundLate { .. }
    );
    // A strut from a vertex that no strut on the ground touches, right after those.
    let (structure, steps) = (&built.structure, &built.outcome.steps);
    let low: Vec<usize> =
        steps[..create].iter().flat_map(|step| structure.struts()[step.struts[0]].ends).collect();
    let floating = (create..steps.len()).find(|&k| !low.contains(&steps[k].joints[0].node)).unwrap();
    let (found, faults) = spoilt(&|steps| {
        let step = steps.remove(floating);
        steps.insert(create, step);
    });
    refused!(found, Violation::Floating { .. });
    assert!(faults.iter().any(|fault| fault.contains("nothing is built")), "{faults:?}");
    let (found, faults) = spoilt(&|steps| steps[create].joints[0].directions[0].neg_mut());
    refused!(found, Violation::Approach { .. });
    assert!(faults.iter().any(|fault| fault.contains("leans")), "{faults:?}");
    // A direction that suits the way of a strut and that another strut takes.
    let (taken, axis) = (connect..built.given.len())
        .find_map(|k| {
            let (step, builder) = (&built.outcome.steps[k], builder());
            let [a, b] =
                built.structure.struts()[step.struts[0]].ends.map(|node| built.structure.nodes()[node]);
            let from_a = built.given[k].joints[0].vertex == a.vertex;
            let way = if from_a { b.at - a.at } else { a.at - b.at };
            let max = if step.kind == StepKind::Connect { builder.max_connect } else { builder.max_create };
            let met = builder.directions.within(max, &way).without(step.joints[0].free).iter().next();
            met.map(|met| (k, builder.directions.all()[met].into_inner()))
        })
        .unwrap();
    refused!(spoilt(&|steps| steps[taken].joints[0].directions = vec![axis]).0, Violation::HeadMeets { .. });
    let worst = built.outcome.steps.iter().map(|step| step.max_sag_mm).fold(0.0, f64::max);
    let (found, faults) = built.with(worst / 2.0, |_| {});
    refused!(found, Violation::Sags { .. });
    assert!(faults.iter().any(|fault| fault.contains("sags")), "{faults:?}");
}
