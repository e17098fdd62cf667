//! Models and loads that are wrong, and frames that do not stand.

use nalgebra::{Point3, Vector3};
use wirebend_frame::{
    Assembly, EndMotion, LineLoad, Load, LoadError, Member, MemberId, MemberSet, Misfit, ModeSearch, Model,
    ModelError, ModesError, NodalLoad, NodeId, NodeMass, SectionId, SolveError, Support, Unstable,
};

use crate::frames::{beam, bunny};

fn refusal(change: impl FnOnce(&mut Model)) -> ModelError {
    let mut model = bunny();
    change(&mut model);
    Assembly::new(&model).err().expect("a refusal")
}

#[test]
fn models_that_describe_no_frame() {
    let member = MemberId(3);
    let nodes = 91;
    assert_eq!(refusal(|model| model.nodes[7].y = f64::NAN), ModelError::NodeNotFinite { node: NodeId(7) });
    assert_eq!(
        refusal(|model| model.members[3].b = NodeId(91)),
        ModelError::UnknownNode { member, node: NodeId(91), nodes }
    );
    assert_eq!(
        refusal(|model| model.members[3].section = SectionId(1)),
        ModelError::UnknownSection { member, section: SectionId(1), sections: 1 }
    );
    let (a, b) = (bunny().members[3].a, bunny().members[3].b);
    assert_eq!(refusal(|model| model.nodes[a.0] = model.nodes[b.0]), ModelError::NoLength { member, a, b });
    assert_eq!(
        refusal(|model| model.members[3].b = model.members[3].a),
        ModelError::NoLength { member, a, b: a }
    );
    for times in [0.0, 2.0, f64::NAN] {
        let up = |model: &mut Model| {
            model.members[3].up = Some((model.nodes[b.0] - model.nodes[a.0]) * times);
        };
        assert_eq!(refusal(up), ModelError::UpAlongMember { member });
    }
    let figure =
        |figure: &'static str, value| ModelError::SectionFigure { section: SectionId(0), figure, value };
    assert_eq!(refusal(|model| model.sections[0].iy = 0.0), figure("iy", 0.0));
    assert_eq!(refusal(|model| model.sections[0].density = -1.0), figure("density", -1.0));
    assert_eq!(
        refusal(|model| model.supports[2].node = NodeId(100)),
        ModelError::UnknownSupport { node: NodeId(100), nodes }
    );
}

/// The message names the place in the model.
#[test]
fn refusals_say_where() {
    let text = refusal(|model| model.members[3].b = NodeId(91)).to_string();
    assert_eq!(text, "member 3 ends at node 91, and there are 91 nodes");
}

#[test]
fn a_part_without_support_is_named() {
    let mut model = bunny();
    let loose = NodeId(model.nodes.len());
    model.nodes.extend([Point3::new(500.0, 0.0, 0.0), Point3::new(600.0, 0.0, 0.0)]);
    model.members.push(Member::new(loose, NodeId(loose.0 + 1), SectionId(0)));
    let assembly = Assembly::new(&model).expect("a model");
    let refused = assembly.factor(&assembly.all()).err();
    assert_eq!(
        refused,
        Some(Unstable::PartWithoutSupport { node: loose, members: vec![MemberId(model.members.len() - 1)] })
    );
    // Without it the rest stands; the loose nodes take no part.
    let mut without = assembly.all();
    without.remove(MemberId(model.members.len() - 1));
    let response =
        assembly.factor(&without).expect("it stands").solve(&Load::self_weight()).expect("a response");
    assert!(response.displacements[loose.0].iter().all(|value| value.abs() <= 0.0));
    assert_eq!(response.forces(MemberId(model.members.len() - 1)), None);
}

#[test]
fn a_frame_without_supports_is_refused() {
    let assembly = Assembly::new(&beam(Vector3::x() * 100.0)).expect("a model");
    let refused = assembly.factor(&assembly.all()).err();
    assert_eq!(refused, Some(Unstable::PartWithoutSupport { node: NodeId(0), members: vec![MemberId(0)] }));
}

/// A lone strut on a hinge falls over, in whatever direction it points; between two it can spin about its axis.
#[test]
fn mechanisms_are_refused_by_a_node_that_moves() {
    for span in [Vector3::x(), Vector3::z(), Vector3::new(1.0, 2.0, -0.3), Vector3::new(0.31, 0.17, 0.93)] {
        let mut model = beam(span * 100.0);
        for supports in
            [vec![Support::pinned(NodeId(0))], vec![Support::pinned(NodeId(0)), Support::pinned(NodeId(1))]]
        {
            model.supports = supports;
            let assembly = Assembly::new(&model).expect("a model");
            let refused = assembly.factor(&assembly.all()).err();
            assert!(matches!(refused, Some(Unstable::Mechanism { .. })), "{span:?}: {refused:?}");
        }
    }
}

/// The bunny's feet on rails: it slides away along x.
#[test]
fn a_frame_on_rails_is_a_mechanism() {
    let mut model = bunny();
    for support in &mut model.supports {
        support.fixed = [false, true, true, true, true, true];
    }
    let assembly = Assembly::new(&model).expect("a model");
    let refused = assembly.factor(&assembly.all()).err();
    assert!(matches!(refused, Some(Unstable::Mechanism { .. })), "{refused:?}");
}

/// A chain of a hundred thin struts is soft and no mechanism; under its weight it would hang down by many lengths.
#[test]
fn a_long_chain_is_soft_and_no_mechanism() {
    let mut model = beam(Vector3::x() * 100.0);
    for k in 2..=100_u32 {
        model.nodes.push(Point3::new(f64::from(k) * 100.0, 0.0, 0.0));
        model.members.push(Member { a: NodeId(k as usize - 1), b: NodeId(k as usize), ..model.members[0] });
    }
    model.supports = vec![Support::clamped(NodeId(0))];
    let assembly = Assembly::new(&model).expect("a model");
    let refused = assembly.factor(&assembly.all()).expect("it is factored").solve(&Load::self_weight());
    let Err(SolveError::Unstable(Unstable::TooSoft { node, displacement_mm, size_mm })) = refused else {
        panic!("{refused:?}")
    };
    assert_eq!((node, size_mm), (NodeId(100), 10_000.0));
    // q L⁴ / 8 E I, which says how well the chain was solved before it was refused.
    let section = model.sections[0];
    let theory = section.density * section.area * 9806.65 * 1e16 / (8.0 * section.e * section.iy);
    assert!((displacement_mm / theory - 1.0).abs() < 1e-6, "{displacement_mm} instead of {theory}");
}

#[test]
fn loads_that_do_not_belong_to_the_frame() {
    let model = bunny();
    let assembly = Assembly::new(&model).expect("a model");
    let mut members = assembly.all();
    members.remove(MemberId(0));
    let factor = assembly.factor(&members).expect("it stands");
    let member = MemberId(0);
    let absent = Err(SolveError::Load(LoadError::AbsentMember { member }));
    let line = LineLoad { member, force: Vector3::x() };
    assert_eq!(factor.solve(&Load { line: vec![line], ..Load::default() }), absent);
    let (rotation_a, rotation_b) = (Vector3::zeros(), Vector3::zeros());
    let misfit = Misfit { member, extra_length: 1.0, rotation_a, rotation_b };
    assert_eq!(factor.solve(&Load { misfits: vec![misfit], ..Load::default() }), absent);
    let motion = EndMotion { member, ends: [0.0; 12] };
    assert_eq!(factor.solve(&Load { end_motions: vec![motion], ..Load::default() }), absent);
    let node = NodeId(91);
    let nodal = NodalLoad { node, force: Vector3::x(), moment: Vector3::zeros() };
    let refused = factor.solve(&Load { nodal: vec![nodal], ..Load::default() });
    assert_eq!(refused, Err(SolveError::Load(LoadError::AbsentNode { node })));
    let gravity = Vector3::new(0.0, f64::INFINITY, 0.0);
    assert_eq!(
        factor.solve(&Load { gravity, ..Load::default() }),
        Err(SolveError::Load(LoadError::NotFinite))
    );
}

#[test]
fn modes_that_cannot_be_looked_for() {
    let mut model = bunny();
    let refusal = |model: &Model, none: bool, shift_hz: f64, struts: usize| {
        let assembly = Assembly::new(model).expect("a model");
        let members = if none { MemberSet::empty(assembly.all().len()) } else { assembly.all() };
        let search = ModeSearch { count: 1, shift_hz, struts: vec![0; struts], masses: Vec::new() };
        assembly.modes(&members, &search).err()
    };
    let assembly = Assembly::new(&model).expect("a model");
    for (node, mass) in [(0, -1e-6), (0, f64::NAN), (91, 1e-6)] {
        let masses = vec![NodeMass { node: NodeId(node), mass }];
        let search = ModeSearch { count: 1, shift_hz: 100.0, struts: Vec::new(), masses };
        assert_eq!(
            assembly.modes(&assembly.all(), &search).err(),
            Some(ModesError::Mass { node: NodeId(node) })
        );
    }
    assert_eq!(refusal(&model, true, 100.0, 0), Some(ModesError::NoMembers));
    assert_eq!(refusal(&model, false, 0.0, 0), Some(ModesError::Shift { shift_hz: 0.0 }));
    assert_eq!(refusal(&model, false, 100.0, 3), Some(ModesError::Struts { struts: 3, members: 179 }));
    model.sections[0].density = 0.0;
    assert_eq!(refusal(&model, false, 100.0, 0), Some(ModesError::Weightless { section: SectionId(0) }));
}

/// Nothing acts, nothing moves; nothing is there, nothing is solved.
#[test]
fn nothing_is_no_error() {
    let assembly = Assembly::new(&bunny()).expect("a model");
    let response =
        assembly.factor(&assembly.all()).expect("it stands").solve(&Load::default()).expect("a response");
    assert_eq!(response.max_displacement(), (NodeId(0), 0.0));
    let none = MemberSet::empty(assembly.all().len());
    let response = assembly.factor(&none).expect("nothing").solve(&Load::self_weight()).expect("a response");
    assert!(response.reactions.is_empty() && response.member_forces.is_empty());
    let empty = Assembly::new(&Model::default()).expect("a model");
    empty.factor(&empty.all()).expect("nothing").solve(&Load::self_weight()).expect("a response");
}
