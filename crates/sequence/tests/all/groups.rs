//! Wires and rods that are placed at once.

use wirebend_core::checks::sequence::StepKind;
use wirebend_core::wireframe::EdgeId;
use wirebend_sequence::{Groups, Structure, StrutBuilder, cost};

use super::confirm::searched;
use super::frames::{assembly, both, builder};

fn wires(structure: &Structure, wires: &[&[u32]]) -> Groups {
    let edges: Vec<Vec<EdgeId>> =
        wires.iter().map(|wire| wire.iter().copied().map(EdgeId).collect()).collect();
    Groups::together(structure, &edges).unwrap()
}

/// A cube on four pillars, as two wires with two feet each, a ring on top, and struts between them: each joint that a wire has with what
/// is built is fastened.
#[test]
fn a_cube_of_wires_and_struts_is_built() {
    let structure = Structure::new(&assembly("simple_frame")).unwrap();
    let groups = wires(&structure, &[&[15, 1, 18], &[16, 3, 17], &[5, 6, 10, 11]]);
    let outcome = searched(&structure, &groups, &builder());
    assert!(outcome.is_found(), "{:?}", outcome.obstacle);
    assert_eq!(outcome.steps.len(), groups.all().len());
    let wires: Vec<_> = outcome.steps.iter().filter(|step| step.struts.len() > 1).collect();
    let fastened: Vec<(StepKind, usize)> = wires.iter().map(|step| (step.kind, step.joints.len())).collect();
    assert_eq!(fastened[..2], [(StepKind::Ground, 2); 2]);
    assert!(fastened[2].1 >= 1 && fastened[2].0 != StepKind::Ground, "{fastened:?}");
}

/// Struts of frames that others built, two and two as bent wires.
#[test]
fn frames_that_others_built_are_built_of_bent_wires() {
    for (name, structure) in both() {
        let mut taken = vec![false; structure.struts().len()];
        let mut pairs: Vec<Vec<EdgeId>> = Vec::new();
        for strut in 0..taken.len() {
            let free = |other: usize| other != strut && !taken[other] && !structure.is_grounded(other);
            let near = structure.struts()[strut].ends.into_iter().flat_map(|node| structure.around(node));
            let mut near = near.copied().filter(|&other| free(other));
            if !taken[strut]
                && !structure.is_grounded(strut)
                && let Some(other) = near.next()
            {
                taken[strut] = true;
                taken[other] = true;
                pairs.push([strut, other].map(|strut| structure.struts()[strut].edge).to_vec());
            }
        }
        let groups = Groups::together(&structure, &pairs).unwrap();
        let outcome = searched(&structure, &groups, &builder());
        assert!(outcome.is_found(), "{name}: {:?}", outcome.obstacle);
        assert!(outcome.steps.len() < structure.struts().len() * 6 / 10, "{name}: {}", outcome.steps.len());
    }
}

/// A machine that does not draw: every rod is fastened wherever it meets what is built, and the head goes along none.
#[test]
fn frames_that_others_built_are_built_of_rods() {
    let places = StrutBuilder { places: true, ..builder() };
    for (name, structure) in both() {
        let groups = Groups::single(&structure);
        let outcome = searched(&structure, &groups, &places);
        assert!(outcome.is_found(), "{name}: {:?}", outcome.obstacle);
        for step in &outcome.steps {
            let joints = if step.kind == StepKind::Connect { 2 } else { step.joints.len() };
            assert!(step.joints.len() == joints && joints > 0, "{name}: {step:?}");
        }
        let seconds = |builder| cost(&outcome.steps, &structure, builder).seconds;
        assert!(seconds(&places) < seconds(&builder()), "{name}: nothing is drawn");
    }
}
