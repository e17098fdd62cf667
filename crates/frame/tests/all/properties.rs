//! What holds for any frame, whatever its axes, numbers and ends are called.

use nalgebra::{Point3, Rotation3, Vector3};
use proptest::prelude::*;
use wirebend_frame::{
    Assembly, Flexibility, Load, Member, MemberForces, MemberId, Misfit, ModeSearch, Model, NodalLoad,
    NodeId, Pieces, Response, Section, SectionForces, SectionId, Support,
};

use crate::frames::{ABS, bunny, framefab_weight};

fn solve(model: &Model, load: &Load) -> Response {
    let assembly = Assembly::new(model).expect("a model");
    assembly.factor(&assembly.all()).expect("it stands").solve(load).expect("a response")
}

fn moved(response: &Response, node: usize) -> Vector3<f64> {
    let [x, y, z, ..] = response.displacements[node];
    Vector3::new(x, y, z)
}

#[track_caller]
fn assert_same(found: &[Vector3<f64>], expected: &[Vector3<f64>]) {
    let most = expected.iter().map(Vector3::norm).fold(0.0, f64::max);
    for (node, (found, expected)) in found.iter().zip(expected).enumerate() {
        assert!((found - expected).norm() < 1e-9 * most, "node {node}: {found:?} instead of {expected:?}");
    }
}

fn all_moved(response: &Response, nodes: usize) -> Vec<Vector3<f64>> {
    (0..nodes).map(|node| moved(response, node)).collect()
}

/// The lowest three, in Hz.
fn frequencies(model: &Model) -> Vec<f64> {
    let assembly = Assembly::new(model).expect("a model");
    let search = ModeSearch { count: 3, shift_hz: 4.0, struts: Vec::new(), masses: Vec::new() };
    let modes = assembly.modes(&assembly.all(), &search).expect("modes");
    modes.iter().map(|mode| mode.frequency_hz).collect()
}

/// How far the bunny sags after each strut, built upwards as it stood before it was turned. `named` is what a member is called.
fn sags(model: &Model, gravity: Vector3<f64>, named: impl Fn(usize) -> usize) -> Vec<f64> {
    let upright = bunny();
    let height = |member: usize| {
        let Member { a, b, .. } = upright.members[member];
        upright.nodes[a.0].z + upright.nodes[b.0].z
    };
    let mut left: Vec<usize> = (0..model.members.len()).collect();
    left.sort_by(|&one, &other| height(one).total_cmp(&height(other)));
    let assembly = Assembly::new(model).expect("a model");
    let mut flexibility = Flexibility::new(&assembly, gravity);
    let mut sags = Vec::new();
    while let Some(place) = left.iter().position(|&member| {
        let ends = model.members[named(member)];
        flexibility.stands(ends.a) || flexibility.stands(ends.b)
    }) {
        let member = MemberId(named(left.remove(place)));
        sags.push(flexibility.add(member).expect("it hangs on").max_displacement);
    }
    assert!(left.is_empty());
    sags
}

#[track_caller]
fn same_figures(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() <= 1e-9 * expected, "{found} instead of {expected}");
    }
}

/// A section that is not round, so that local axes matter.
fn flat() -> Section {
    let round = Section::round(1.5, &ABS);
    Section { iz: round.iz * 2.0, iy: round.iy / 2.0, ..round }
}

fn rotation() -> impl Strategy<Value = Rotation3<f64>> {
    (prop::array::uniform3(-1.0..1.0_f64), 0.0..std::f64::consts::PI).prop_map(|(axis, angle)| {
        let axis = Vector3::from(axis) + Vector3::new(1e-3, 0.0, 0.0);
        Rotation3::new(axis.normalize() * angle)
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    /// A frame that is turned with its gravity and the up of its members sags as before.
    #[test]
    fn axes_do_not_matter(turn in rotation(), is_flat: bool) {
        let mut model = bunny();
        if is_flat {
            model.sections = vec![flat()];
            for k in 0..model.members.len() {
                let member = model.members[k];
                let span = model.nodes[member.b.0] - model.nodes[member.a.0];
                model.members[k].up = Some(span.cross(&Vector3::new(1.0, 2.0, 3.0)));
            }
        }
        let load = framefab_weight();
        let expected = solve(&model, &load);
        let mut turned = model.clone();
        for node in &mut turned.nodes {
            *node = turn * *node;
        }
        for member in &mut turned.members {
            member.up = member.up.map(|up| turn * up);
        }
        let found = solve(&turned, &Load { gravity: turn * load.gravity, ..Load::default() });
        let back: Vec<_> = all_moved(&found, 91).iter().map(|u| turn.inverse() * u).collect();
        assert_same(&back, &all_moved(&expected, 91));
        same_figures(&frequencies(&turned), &frequencies(&model));
        same_figures(&sags(&turned, turn * load.gravity, |member| member), &sags(&model, load.gravity, |member| member));
        let most = |of: fn(&MemberForces) -> f64| expected.member_forces.iter().map(of).fold(0.0, f64::max);
        let (axial, moment) = (most(|forces| forces.axial().abs()), most(|forces| forces.at(0.3).moment()));
        for (found, expected) in found.member_forces.iter().zip(&expected.member_forces) {
            prop_assert!((found.axial() - expected.axial()).abs() < 1e-9 * axial, "{} {}", found.axial(), expected.axial());
            prop_assert!((found.at(0.3).moment() - expected.at(0.3).moment()).abs() < 1e-9 * moment);
        }
    }

    /// Ends that are swapped and nodes in another order are the same frame.
    #[test]
    fn names_do_not_matter(shuffle in Just((0..91).collect::<Vec<usize>>()).prop_shuffle(), swapped in prop::collection::vec(any::<bool>(), 179)) {
        let model = bunny();
        let mut other = model.clone();
        for (old, &new) in shuffle.iter().enumerate() {
            other.nodes[new] = model.nodes[old];
        }
        let named = |node: NodeId| NodeId(shuffle[node.0]);
        for (member, swapped) in other.members.iter_mut().zip(&swapped) {
            let (a, b) = (named(member.a), named(member.b));
            (member.a, member.b) = if *swapped { (b, a) } else { (a, b) };
        }
        other.members.reverse();
        for support in &mut other.supports {
            support.node = named(support.node);
        }
        let found = solve(&other, &framefab_weight());
        let found: Vec<_> = shuffle.iter().map(|&node| moved(&found, node)).collect();
        assert_same(&found, &all_moved(&solve(&model, &framefab_weight()), 91));
        same_figures(&frequencies(&other), &frequencies(&model));
        let gravity = framefab_weight().gravity;
        same_figures(&sags(&other, gravity, |member| 178 - member), &sags(&model, gravity, |member| member));
    }

    /// Forces at joints and by misfits balance: what supports do to the frame is what acts on it, and no more.
    #[test]
    fn all_forces_balance(node in 0..79_usize, force in prop::array::uniform3(-1.0..1.0_f64), moment in prop::array::uniform3(-10.0..10.0_f64), member in 0..179_usize, turn in prop::array::uniform3(-0.01..0.01_f64)) {
        let model = bunny();
        let (force, moment) = (Vector3::from(force), Vector3::from(moment));
        let load = Load {
            nodal: vec![NodalLoad { node: NodeId(node), force, moment }],
            misfits: vec![Misfit {
                member: MemberId(member),
                extra_length: 0.1,
                rotation_a: Vector3::from(turn),
                rotation_b: Vector3::zeros(),
            }],
            ..Load::default()
        };
        let response = solve(&model, &load);
        let held: Vector3<f64> = response.reactions.iter().map(|reaction| reaction.force).sum();
        prop_assert!((held + force).norm() < 1e-8, "{held:?}");
        let turned: Vector3<f64> = response
            .reactions
            .iter()
            .map(|reaction| reaction.moment + model.nodes[reaction.node.0].coords.cross(&reaction.force))
            .sum();
        let acts = moment + model.nodes[node].coords.cross(&force);
        prop_assert!((turned + acts).norm() < 1e-6 * (1.0 + acts.norm()), "{turned:?} {acts:?}");
        prop_assert!(response.residual < 1e-9, "{}", response.residual);
    }
}

/// Struts in three pieces are the same struts, round and flat, under weight, forces at joints and misfits, and in the forces within them.
#[test]
fn pieces_are_the_same_strut() {
    let mut model = bunny();
    for section in [model.sections[0], flat()] {
        model.sections = vec![section];
        let misfit = |member: usize| Misfit {
            member: MemberId(member),
            extra_length: 0.02,
            rotation_a: Vector3::new(1e-3, 2e-3, -1e-3),
            rotation_b: Vector3::new(0.0, -1e-3, 2e-3),
        };
        let nodal = vec![NodalLoad {
            node: NodeId(20),
            force: Vector3::new(0.01, 0.02, -0.03),
            moment: Vector3::new(0.1, 0.0, 0.2),
        }];
        let misfits = [3, 40, 170].map(misfit).to_vec();
        let load = Load { nodal: nodal.clone(), misfits: misfits.clone(), ..framefab_weight() };
        // What is too long lies in the first piece; the ends are those of the first and of the last.
        let of_pieces = misfits.iter().flat_map(|whole| {
            let none = Vector3::zeros();
            let first = Misfit { member: MemberId(3 * whole.member.0), rotation_b: none, ..*whole };
            let last = Misfit {
                member: MemberId(3 * whole.member.0 + 2),
                extra_length: 0.0,
                rotation_a: none,
                ..*whole
            };
            [first, last]
        });
        let in_pieces = Load { nodal, misfits: of_pieces.collect(), ..framefab_weight() };
        let (expected, found) = (solve(&model, &load), solve(&Pieces::new(&model, 3).model, &in_pieces));
        assert_same(&all_moved(&found, 91), &all_moved(&expected, 91));
        let largest = |of: fn(&SectionForces) -> f64| {
            expected.member_forces.iter().map(|forces| of(&forces.at(0.5)).abs()).fold(0.0, f64::max)
        };
        let kinds: [fn(&SectionForces) -> f64; 3] =
            [|at| at.axial, SectionForces::moment, |at| at.torque.abs()];
        for of in kinds {
            let most = largest(of);
            for (pieces, whole) in found.member_forces.chunks(3).zip(&expected.member_forces) {
                for (piece, share) in pieces.iter().zip([1.0 / 6.0, 0.5, 5.0 / 6.0]) {
                    let (found, expected) = (of(&piece.at(0.5)), of(&whole.at(share)));
                    assert!((found - expected).abs() < 1e-9 * most, "{found} {expected} of {most}");
                }
            }
        }
    }
}

/// Some members of a frame are the frame of those members alone, and their weight is theirs.
#[test]
fn a_subset_is_a_frame_of_its_own() {
    let model = bunny();
    let assembly = Assembly::new(&model).expect("a model");
    let mut members = assembly.all();
    for k in [0, 5, 17, 60] {
        members.remove(MemberId(k));
    }
    let found = assembly.factor(&members).expect("it stands").solve(&framefab_weight()).expect("a response");
    let mut alone = model.clone();
    alone.members = members.iter().map(|member| model.members[member.0]).collect();
    assert_same(&all_moved(&found, 91), &all_moved(&solve(&alone, &framefab_weight()), 91));
    assert_eq!(found.member_forces.len(), 175);
}

/// A strut that is too long between two clamps is pressed by E A δ / L; one that hangs free only moves its end.
#[test]
fn misfits_press_what_cannot_give_way() {
    let section = Section::round(1.5, &ABS);
    let mut model = Model {
        nodes: vec![Point3::origin(), Point3::new(30.0, 40.0, 0.0)],
        members: vec![Member::new(NodeId(0), NodeId(1), SectionId(0))],
        sections: vec![section],
        supports: vec![Support::clamped(NodeId(0)), Support::clamped(NodeId(1))],
    };
    let turn = Vector3::z() * 0.01;
    let misfit = |extra_length, rotation_a| Load {
        misfits: vec![Misfit { member: MemberId(0), extra_length, rotation_a, rotation_b: Vector3::zeros() }],
        ..Load::default()
    };
    let pressed = solve(&model, &misfit(0.5, Vector3::zeros())).member_forces[0].axial();
    assert!((pressed + section.e * section.area * 0.5 / 50.0).abs() < 1e-9, "{pressed}");
    // Clamped at both ends and turned at one: 4 E I θ / L there, 2 E I θ / L at the other end.
    let bent = solve(&model, &misfit(0.0, turn)).member_forces[0];
    let unit = section.e * section.iz * 0.01 / 50.0;
    assert!((bent.at(0.0).moment() - 4.0 * unit).abs() < 1e-9, "{bent:?}");
    assert!((bent.at(1.0).moment() - 2.0 * unit).abs() < 1e-9, "{bent:?}");

    model.supports.pop();
    let free = solve(&model, &misfit(0.5, Vector3::zeros()));
    assert!((moved(&free, 1) - Vector3::new(0.3, 0.4, 0.0)).norm() < 1e-12, "{free:?}");
    assert!(free.member_forces[0].axial().abs() < 1e-9);
}

/// Work of Clapeyron: what a force does on its way is half of force by displacement, whoever is asked first (Betti, Maxwell).
#[test]
fn work_is_reciprocal() {
    let model = bunny();
    let at = |node: usize, force: Vector3<f64>| Load {
        nodal: vec![NodalLoad { node: NodeId(node), force, moment: Vector3::zeros() }],
        ..Load::default()
    };
    let one = solve(&model, &at(3, Vector3::x()));
    let other = solve(&model, &at(40, Vector3::z()));
    assert!(
        (one.displacements[40][2] - other.displacements[3][0]).abs() < 1e-9 * one.displacements[40][2].abs()
    );
    assert!((one.work - one.displacements[3][0] / 2.0).abs() < 1e-12);
}
