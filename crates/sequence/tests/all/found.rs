//! Sequences that are found, and that none is found where there is none.

use std::ops::ControlFlow;

use wirebend_sequence::{
    Groups, LayerOptions, Outcome, Partial, SearchOptions, Strategy, Structure, Task, cost, layers, search,
    search_by_paper, stiffest_order,
};

use super::confirm::{agreed, confirmed};
use super::frames::{abs, both, builder};

fn found(structure: &Structure) -> Outcome {
    let (builder, weight, groups) = (builder(), abs(), Groups::single(structure));
    let task = Task { structure, groups: &groups, builder: &builder, weight: &weight };
    search(&task, &SearchOptions::default(), &mut |_| ControlFlow::Continue(())).unwrap()
}

/// 155 of 178 and 191 of 198 steps share a node in sequences of an independent search; the sags are those of the whole frames, by
/// two other programs.
#[test]
fn frames_that_others_built_are_built_at_once() {
    for ((name, structure), (max_sag, least_sharing)) in
        both().into_iter().zip([(0.427_187, 155), (0.223_261, 191)])
    {
        let outcome = found(&structure);
        assert!(outcome.is_found() && outcome.proved, "{name}: {:?}", outcome.obstacle);
        assert_eq!(outcome.strategy, Some(Strategy::FromGround), "{name}");
        let (builder, weight, groups) = (builder(), abs(), Groups::single(&structure));
        let task = Task { structure: &structure, groups: &groups, builder: &builder, weight: &weight };
        let worst = outcome.steps.iter().map(|step| step.max_sag_mm).fold(0.0, f64::max);
        assert!((worst - max_sag).abs() < 1e-5 * max_sag, "{name}: {worst}");
        let cost = cost(&outcome.steps, &structure, &builder);
        assert!(cost.sharing >= least_sharing && cost.least_free > 0, "{name}: {cost:?}");
        assert_eq!(agreed(&task, &outcome).len(), structure.struts().len());
        assert_eq!(found(&structure), outcome, "{name}: the same question has the same answer");
    }
}

/// As far as it has come: what a search takes off first is built last.
#[test]
fn a_search_that_is_stopped_has_the_last_steps() {
    let [(_, structure), _] = both();
    let whole = found(&structure);
    let (builder, weight, groups) = (builder(), abs(), Groups::single(&structure));
    let task = Task { structure: &structure, groups: &groups, builder: &builder, weight: &weight };
    let stopped = search(&task, &SearchOptions::default(), &mut |progress| {
        if progress.taken == 100 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    })
    .unwrap();
    assert!(!stopped.is_found() && !stopped.proved);
    let last = whole.steps[whole.steps.len() - 100..].iter().map(|step| step.struts.clone());
    assert_eq!(stopped.partial, Partial { first: Vec::new(), last: last.collect() });
}

/// The largest sags of orders that an independent program found by stiffness alone.
#[test]
fn the_stiffest_order_sags_no_more_than_the_whole_frame() {
    let frames =
        both().into_iter().zip([0.427_187, 0.223_261]).map(|((_, structure), wanted)| (structure, wanted));
    for (structure, wanted) in frames {
        let (builder, weight, groups) = (builder(), abs(), Groups::single(&structure));
        let task = Task { structure: &structure, groups: &groups, builder: &builder, weight: &weight };
        let (order, worst) = stiffest_order(&task).unwrap();
        assert_eq!(order.len(), structure.struts().len());
        assert!((worst - wanted).abs() < 1e-4 * wanted, "{worst} instead of {wanted}");
    }
}

#[test]
fn by_the_cost_of_the_paper_they_are_built_layer_by_layer() {
    for (name, structure) in both() {
        let (builder, weight, groups) = (builder(), abs(), Groups::single(&structure));
        let task = Task { structure: &structure, groups: &groups, builder: &builder, weight: &weight };
        let layer = layers(&task, &[], &LayerOptions::default()).unwrap();
        let outcome = search_by_paper(&task, &layer, 1000, &mut |_| ControlFlow::Continue(())).unwrap();
        confirmed(&task, &outcome);
        let built: Vec<usize> = outcome.steps.iter().map(|step| layer[step.struts[0]]).collect();
        assert!(built.is_sorted(), "{name}: {built:?}");
    }
}
