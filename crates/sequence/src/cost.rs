//! What a sequence costs the machine.

use wirebend_core::units::Length;

use super::builder::StrutBuilder;
use super::outcome::Step;
use super::structure::Structure;

/// What a sequence costs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SequenceCost {
    /// How many steps share a node with the one before.
    pub sharing: usize,
    /// How far the head draws struts.
    pub built: Length,
    /// How far it travels between them, straight.
    pub travel: Length,
    /// How long that takes with a pause at each end of a strut, s.
    pub seconds: f64,
    /// How many directions are free where fewest are.
    pub least_free: usize,
    /// How far the largest sag stays from what is allowed.
    pub margin: Length,
}

/// The cost of steps in their order.
#[must_use]
#[allow(clippy::cast_precision_loss)] // thousands
pub fn cost(steps: &[Step], structure: &Structure, builder: &StrutBuilder) -> SequenceCost {
    let nodes = |step: &Step| -> Vec<usize> {
        step.struts.iter().flat_map(|&strut| structure.struts()[strut].ends).collect()
    };
    let sharing = steps.windows(2).filter(|pair| {
        let before = nodes(&pair[0]);
        nodes(&pair[1]).iter().any(|node| before.contains(node))
    });
    let (mut built, mut travel, mut stops) = (0.0, 0.0, 0_usize);
    let mut at: Option<usize> = None;
    for step in steps {
        let mut stations: Vec<usize> = step.joints.iter().map(|joint| joint.node).collect();
        if let ([strut], [joint], false) =
            (&step.struts[..], &step.joints[..], builder.is_placed(step.struts.len()))
        {
            let [a, b] = structure.struts()[*strut].ends;
            stations.push(if joint.node == a { b } else { a });
            built += structure.length(*strut).mm();
            travel += at.map_or(0.0, |at| apart(structure, at, joint.node));
            at = stations.last().copied();
        } else {
            for &station in &stations {
                travel += at.map_or(0.0, |at| apart(structure, at, station));
                at = Some(station);
            }
        }
        stops += stations.len();
    }
    let pace = builder.pace;
    let worst = steps.iter().map(|step| step.max_sag_mm).fold(0.0, f64::max);
    let free = steps.iter().flat_map(|step| &step.joints).map(|joint| joint.free.len()).min();
    SequenceCost {
        sharing: sharing.count(),
        built: Length::computed(built),
        travel: Length::computed(travel),
        seconds: built / pace.build_mm_s + travel / pace.travel_mm_s + stops as f64 * pace.pause_s,
        least_free: free.unwrap_or(0),
        margin: Length::computed(builder.max_sag.mm() - worst),
    }
}

fn apart(structure: &Structure, one: usize, other: usize) -> f64 {
    (structure.nodes()[one].at - structure.nodes()[other].at).norm()
}
