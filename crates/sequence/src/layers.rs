//! Layers: a frame cut into few struts after few struts, each cut where it is easy to build across.
//!
//! An arc from a strut to one beside it costs little where the second has far more directions left once the first stands than the
//! other way round, and high up. The cheapest cut between ground and ceiling parts the frame; the lower part is cut again. After
//! Huang et al., `FrameFab`, 2016, section 4, where the same is written as a relaxed quadratic program; here the cut is exact. Its Eq. 9
//! as printed favours the wrong order; this is the order of the authors' own code.

use petgraph::algo::dinics;
use petgraph::graph::{DiGraph, NodeIndex};
use petgraph::visit::EdgeRef;
use wirebend_core::units::Length;
use wirebend_core::wireframe::EdgeId;
use wirebend_frame::ModelError;

use super::builder::StrutBuilder;
use super::free_directions::FreeDirections;
use super::search::Task;
use super::stability::{Stability, unsteady};
use super::structure::Structure;

/// How layers are cut.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LayerOptions {
    /// A part of so many struts is not cut any more.
    pub enough: usize,
    /// Without ceilings, the struts that reach so near to the top are.
    pub top: Length,
}

impl Default for LayerOptions {
    fn default() -> Self {
        // FrameFab cuts until 20 are left. The top is that of its authors' models.
        Self { enough: 20, top: Length::computed(5.0) }
    }
}

/// How much the order of directions counts, and how much height (`FrameFab`, section 4).
const LAMBDA_DIRECTIONS: f64 = 0.5;
const LAMBDA_HEIGHT: f64 = 3.0;
/// Costs are cut as whole numbers.
const SCALE: f64 = 1e6;

/// The layer of each strut of a structure, from 0 at the ground.
///
/// Each layer stands on those below without sagging too far, unless no cut of what is left does.
///
/// # Errors
/// A frame that cannot be computed with.
pub fn layers(
    task: &Task<'_>,
    ceilings: &[EdgeId],
    options: &LayerOptions,
) -> Result<Vec<usize>, ModelError> {
    let stability = Stability::new(task.structure, task.weight)?;
    let radius = Length::computed(task.weight.section.radius);
    let free = FreeDirections::new(task.structure, task.builder, radius);
    let cutter = Cutter {
        structure: task.structure,
        stability: &stability,
        builder: task.builder,
        arcs: arcs(task.structure, &free),
    };
    let count = task.structure.struts().len();
    let mut lower = vec![true; count];
    let mut sink = ceiling(task.structure, ceilings, options.top);
    // From the top downwards.
    let mut cut: Vec<Vec<usize>> = Vec::new();
    while lower.iter().filter(|there| **there).count() > options.enough {
        let Some(next) = cutter.stable_cut(&lower, &sink) else { break };
        cut.push((0..count).filter(|&strut| lower[strut] && !next[strut]).collect());
        sink = (0..count)
            .map(|strut| next[strut] && cutter.reaches(strut, |other| lower[other] && !next[other]))
            .collect();
        lower = next;
    }
    let mut layer = vec![0; count];
    for (below, struts) in cut.iter().rev().enumerate() {
        for &strut in struts {
            layer[strut] = below + 1;
        }
    }
    Ok(layer)
}

/// The struts that are the top of a frame.
fn ceiling(structure: &Structure, ceilings: &[EdgeId], top: Length) -> Vec<bool> {
    let struts = 0..structure.struts().len();
    if ceilings.iter().any(|&edge| structure.strut_of(edge).is_some()) {
        struts.map(|strut| ceilings.contains(&structure.struts()[strut].edge)).collect()
    } else {
        struts
            .map(|strut| structure.ends(strut).iter().any(|end| end.z >= structure.top() - top.mm()))
            .collect()
    }
}

/// From one strut to one that shares a node with it, and what it costs to cut there.
struct Arc {
    from: usize,
    to: usize,
    /// The height of the node.
    z: f64,
    /// The cost by directions alone, up to 1.
    cost: f64,
}

impl Arc {
    /// The cost within a part that reaches from one height to another. High up it is less, so that what is cut off is the top.
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // between 0 and 1e6
    fn cost_between(&self, [low, high]: [f64; 2]) -> u64 {
        let height = (self.z - low) / (high - low).max(f64::MIN_POSITIVE);
        (self.cost * (-LAMBDA_HEIGHT * height * height).exp() * SCALE).round().max(1.0) as u64
    }
}

fn arcs(structure: &Structure, free: &FreeDirections<'_>) -> Vec<Arc> {
    let mut arcs = Vec::new();
    for node in 0..structure.nodes().len() {
        for &from in structure.around(node) {
            for &to in structure.around(node).iter().filter(|&&to| to != from) {
                let gain = (free.share_beside(to, from) - free.share_beside(from, to)).max(0.0);
                let cost = (-LAMBDA_DIRECTIONS * gain * gain).exp();
                arcs.push(Arc { from, to, z: structure.nodes()[node].at.z, cost });
            }
        }
    }
    arcs
}

struct Cutter<'a> {
    structure: &'a Structure,
    stability: &'a Stability,
    builder: &'a StrutBuilder,
    arcs: Vec<Arc>,
}

impl Cutter<'_> {
    /// The lower part after the cheapest cut that leaves it stiff enough; none where there is nothing left to cut.
    fn stable_cut(&self, part: &[bool], sink: &[bool]) -> Option<Vec<bool>> {
        let count = part.len();
        let mut source: Vec<bool> =
            (0..count).map(|strut| part[strut] && self.structure.is_grounded(strut)).collect();
        loop {
            let open = (0..count).any(|strut| part[strut] && sink[strut] && !source[strut]);
            if !open {
                return None;
            }
            let lower = self.cut(part, &source, sink);
            let struts = (0..count).filter(|&strut| lower[strut]);
            let worst = match self.stability.sag(struts) {
                Ok(sag) if sag.mm <= self.builder.max_sag.mm() => return Some(lower),
                Ok(sag) => sag.node,
                Err(unstable) => unsteady(&unstable, self.builder.max_sag.mm()).0,
            };
            // What would hold that node belongs below.
            let holding = self.structure.around(worst).iter().filter(|&&strut| part[strut] && !lower[strut]);
            let held = holding.map(|&strut| source[strut] = true).count();
            if held == 0 {
                return None;
            }
        }
    }

    /// What stays on the side of the ground when the cheapest arcs between ground and ceiling are cut.
    fn cut(&self, part: &[bool], source: &[bool], sink: &[bool]) -> Vec<bool> {
        let mut network = DiGraph::<(), u64>::new();
        let nodes: Vec<NodeIndex> = part.iter().map(|_| network.add_node(())).collect();
        let [ground, top] = [network.add_node(()), network.add_node(())];
        let z = (0..part.len()).filter(|&strut| part[strut]).flat_map(|strut| self.structure.ends(strut));
        let height =
            z.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], end| [low.min(end.z), high.max(end.z)]);
        let arcs = self.arcs.iter().filter(|arc| part[arc.from] && part[arc.to]);
        let arcs: Vec<(&Arc, u64)> = arcs.map(|arc| (arc, arc.cost_between(height))).collect();
        // More than all arcs together.
        let never = 1 + arcs.iter().map(|(_, cost)| cost).sum::<u64>();
        for (strut, &node) in nodes.iter().enumerate().filter(|&(strut, _)| part[strut]) {
            if source[strut] {
                network.add_edge(ground, node, never);
            } else if sink[strut] {
                network.add_edge(node, top, never);
            }
        }
        for (arc, cost) in arcs {
            network.add_edge(nodes[arc.from], nodes[arc.to], cost);
        }
        let (_, flows) = dinics(&network, ground, top);
        let mut reached = vec![false; network.node_count()];
        let mut open = vec![ground];
        reached[ground.index()] = true;
        while let Some(node) = open.pop() {
            let onwards = network.edges(node).filter(|arc| flows[arc.id().index()] < *arc.weight());
            let back = network.edges_directed(node, petgraph::Direction::Incoming);
            let back = back.filter(|arc| flows[arc.id().index()] > 0);
            for next in onwards.map(|arc| arc.target()).chain(back.map(|arc| arc.source())) {
                if !std::mem::replace(&mut reached[next.index()], true) {
                    open.push(next);
                }
            }
        }
        nodes.iter().enumerate().map(|(strut, node)| part[strut] && reached[node.index()]).collect()
    }

    fn reaches(&self, strut: usize, wanted: impl Fn(usize) -> bool) -> bool {
        let near =
            self.structure.struts()[strut].ends.into_iter().flat_map(|node| self.structure.around(node));
        near.copied().any(wanted)
    }
}
