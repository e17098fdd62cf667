//! Errors that are planted in sequences which can be built: the check and brute force name each of them, its step, and nothing else.

mod head;
mod order;
mod steps;
mod wires;

use wirebend_core::checks::sequence::Violation;
use wirebend_core::wireframe::EdgeId;
use wirebend_sequence::{GivenStep, Groups, Structure, StrutBuilder, Task, check};
use wirebend_tests_brute::Fault;

use super::brute;
use super::confirm::searched;
use super::frames::{abs, builder, frame};

/// A frame with a sequence that can be built.
struct Built {
    structure: Structure,
    groups: Groups,
    builder: StrutBuilder,
    given: Vec<GivenStep>,
}

impl Built {
    /// A sequence that was found, without what its steps are said to be.
    fn found(structure: Structure, groups: Groups, builder: StrutBuilder) -> Self {
        let outcome = searched(&structure, &groups, &builder);
        assert!(outcome.is_found(), "{:?}", outcome.obstacle);
        let given = outcome.steps.iter().map(|step| {
            let given = GivenStep::of(step, &structure, &builder);
            GivenStep { kind: None, ..given }
        });
        let given = given.collect();
        Self { structure, groups, builder, given }
    }

    /// A pillar with an arm that carries a post, a second pillar with a beam to the first, and a third one apart:
    ///
    /// ```text
    ///                             5
    ///       3 ─── beam 2 ─── 1 ───┴ 4       7
    ///       │ 1              │ 0  arm 3     │ 5     post 4 from vertex 4 to 5
    ///       2                0              6
    /// ```
    fn stage() -> Self {
        let points = [
            [0.0; 3],
            [0.0, 0.0, 40.0],
            [-60.0, 0.0, 0.0],
            [-60.0, 0.0, 40.0],
            [ARM, 0.0, 40.0],
            [ARM, 0.0, 50.0],
            [0.0, 200.0, 0.0],
            [0.0, 200.0, 40.0],
        ];
        let structure = frame(&points, &[[0, 1], [2, 3], [3, 1], [1, 4], [4, 5], [6, 7]]);
        let groups = Groups::single(&structure);
        Self::found(structure, groups, builder())
    }

    /// What is found in the sequence after a change.
    fn planted(&self, change: impl FnOnce(&mut Vec<GivenStep>)) -> (Vec<Violation>, Vec<Fault>) {
        self.planted_for(&self.builder, change)
    }

    /// The same on another machine.
    fn planted_for(
        &self,
        builder: &StrutBuilder,
        change: impl FnOnce(&mut Vec<GivenStep>),
    ) -> (Vec<Violation>, Vec<Fault>) {
        let weight = abs();
        let task = Task { structure: &self.structure, groups: &self.groups, builder, weight: &weight };
        let mut steps = self.given.clone();
        change(&mut steps);
        (check(&task, &steps).violations, brute::faults(&task, &steps))
    }

    /// The place of the step that builds an edge.
    fn place_of(&self, edge: u32) -> usize {
        self.given.iter().position(|step| step.edges.contains(&EdgeId(edge))).unwrap()
    }
}

const ARM: f64 = 100.0;
const BEAM_EDGE: u32 = 2;
const ARM_EDGE: u32 = 3;
const POST_EDGE: u32 = 4;
const LONE_PILLAR_EDGE: u32 = 5;
