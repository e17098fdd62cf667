//! The order by the cost of `FrameFab`: layer by layer, always the cheapest strut next, back from dead ends.
//!
//! As the authors' own code has it (`FFAnalyzer.cpp`), which differs from Eqs. 4 to 7 of the paper: the cost of stability is height
//! times exp of the angle. Only their collisions are not theirs: the head is tested all along its way.

use std::ops::ControlFlow;

use wirebend_frame::ModelError;

use super::candidates::{Blocked, Candidates};
use super::descent::Stuck;
use super::group_set::GroupSet;
use super::outcome::{Obstacle, ObstacleRule, Outcome, Partial, Progress, Strategy};
use super::search::{Task, candidates, found, of_the_whole, told};
use super::stability::Stability;

/// Weights of stability, adjacency and freedom of the rest: `Wp`, `Wa` and `Wi` of `FiberPrintPARM.h`, lines 47 to 49, in the sum of
/// `FFAnalyzer.cpp`, line 319. The same as the paper's 1, 5, 1, where Eq. 7 sums stability, collision and adjacency.
const WEIGHTS: [f64; 3] = [1.0, 1.0, 5.0];
/// How fast the cost of a strut falls with its free share of directions (`FFAnalyzer.cpp`, line 314).
const FREEDOM: f64 = 5.0;

/// A set on the way up, and what was tried from there.
#[derive(Default)]
struct Level {
    /// Those that can come next, dearest first.
    open: Vec<usize>,
    /// Those of the same layer that cannot be placed from anywhere.
    shut: Vec<usize>,
    /// Those with which the frame would sag too far.
    sagging: Vec<(usize, Blocked)>,
}

/// Searches as the paper does, each strut alone. `backtracks` bounds how often it goes back from a dead end. Where it comes to none, the
/// obstacle is why nothing could come next where it came farthest; none where it was stopped.
///
/// # Errors
/// A frame that cannot be computed with.
pub fn search_by_paper(
    task: &Task<'_>,
    layers: &[usize],
    backtracks: u64,
    should_continue: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
) -> Result<Outcome, ModelError> {
    let stability = Stability::new(task.structure, task.weight)?;
    let candidates = candidates(task, &stability);
    let of = candidates.groups.all().len();
    let mut standing = GroupSet::none(of);
    let mut order: Vec<usize> = Vec::new();
    if let Some(obstacle) = of_the_whole(task, &candidates) {
        return Ok(Outcome::impossible(obstacle));
    }
    let mut levels = vec![ranked(&candidates, layers, &standing, None)];
    let mut back = 0;
    let mut farthest: Option<Stuck> = None;
    let mut stopped = Vec::new();
    while let Some(level) = levels.last_mut() {
        if order.len() == of {
            return Ok(found(&candidates, &order, Strategy::PaperCost));
        }
        let progress = Progress { strategy: Strategy::PaperCost, taken: order.len(), of };
        if should_continue(&progress).is_break() {
            stopped = order;
            break;
        }
        if let Some(group) = level.open.pop() {
            standing.insert(group);
            let blocked = match candidates.sag(&standing) {
                Ok(sag) if sag.mm <= candidates.max_sag_mm => {
                    order.push(group);
                    levels.push(ranked(&candidates, layers, &standing, Some(group)));
                    continue;
                }
                Ok(sag) => Blocked::Sags(sag),
                Err(unstable) => candidates.unsteady(&unstable),
            };
            level.sagging.push((group, blocked));
            standing.remove(group);
            continue;
        }
        let tried = levels.pop().unwrap_or_default();
        if farthest.as_ref().is_none_or(|stuck| order.len() > stuck.order.len()) {
            let blocked = tried.blocked(&candidates, &standing);
            farthest = Some(Stuck { standing: standing.clone(), blocked, order: order.clone() });
        }
        if back == backtracks {
            break;
        }
        back += 1;
        if let Some(group) = order.pop() {
            standing.remove(group);
        }
    }
    let order = farthest.as_ref().map_or(&[][..], |stuck| &stuck.order);
    let order = if stopped.len() > order.len() { &stopped } else { order };
    let first = order.iter().map(|&group| candidates.groups.all()[group].struts.clone()).collect();
    let obstacle = farthest.as_ref().map(|stuck| {
        let told = told(&candidates, stuck.order.len() + 1, &stuck.blocked);
        match told.rule {
            ObstacleRule::Sags { node, sag_mm } => {
                Obstacle { rule: ObstacleRule::SagsWith { node, sag_mm }, ..told }
            }
            _ => told,
        }
    });
    Ok(Outcome::not_found(obstacle, Partial { first, ..Partial::default() }))
}

impl Level {
    /// Why none of its groups could come next.
    fn blocked(self, candidates: &Candidates<'_>, standing: &GroupSet) -> Vec<(usize, Blocked)> {
        let built = candidates.built(standing);
        let stands = |strut: usize| standing.contains(candidates.groups.of_strut(strut));
        let shut = self.shut.into_iter().map(|group| {
            let there = &candidates.groups.all()[group];
            if there.nodes.iter().any(|&node| built[node]) {
                let by = candidates.free.in_the_way(there, &|node| built[node], &stands);
                (group, Blocked::NoDirection(by))
            } else {
                (group, Blocked::Floating)
            }
        });
        self.sagging.into_iter().chain(shut).collect()
    }
}

/// The struts that can come next in the lowest layer that is not done, dearest first.
fn ranked(candidates: &Candidates<'_>, layers: &[usize], standing: &GroupSet, last: Option<usize>) -> Level {
    let groups = candidates.groups.all();
    let mut shut = Vec::new();
    let strut = |group: usize| groups[group].struts[0];
    let left = || (0..groups.len()).filter(|&group| !standing.contains(group));
    let ground = left().any(|group| groups[group].grounded);
    let lowest = left().map(|group| layers[strut(group)]).min().unwrap_or(0);
    let mut open: Vec<(f64, usize)> = left()
        .filter(|&group| if ground { groups[group].grounded } else { layers[strut(group)] == lowest })
        .filter_map(|group| {
            let free = candidates.free_on(standing, group);
            if free.is_empty() || free.iter().any(|free| free.directions.is_empty()) {
                shut.push(group);
                return None;
            }
            let cost = if ground {
                middle(candidates, strut(group)).x
            } else {
                cost(candidates, layers, standing, last, group)?
            };
            Some((cost, group))
        })
        .collect();
    open.sort_by(|one, other| other.0.total_cmp(&one.0).then(other.1.cmp(&one.1)));
    Level { open: open.into_iter().map(|(_, group)| group).collect(), shut, sagging: Vec::new() }
}

fn middle(candidates: &Candidates<'_>, strut: usize) -> nalgebra::Point3<f64> {
    let [a, b] = candidates.structure.ends(strut);
    nalgebra::center(a, b)
}

fn cost(
    candidates: &Candidates<'_>,
    layers: &[usize],
    standing: &GroupSet,
    last: Option<usize>,
    group: usize,
) -> Option<f64> {
    let groups = candidates.groups.all();
    let strut = groups[group].struts[0];
    let stability = stability(candidates, layers, standing, strut)?;
    let adjacency = match last {
        Some(last) if !candidates.structure.share_a_node(strut, groups[last].struts[0]) => 1.0,
        _ => 0.0,
    };
    let freedom = freedom_of_the_rest(candidates, standing, group);
    Some(WEIGHTS[0] * stability + WEIGHTS[1] * adjacency + WEIGHTS[2] * freedom)
}

/// How high a strut is in its layer, between the lowest and the highest node of that, and how far it leans from upright into the open.
fn stability(
    candidates: &Candidates<'_>,
    layers: &[usize],
    standing: &GroupSet,
    strut: usize,
) -> Option<f64> {
    let structure = candidates.structure;
    let of_layer = (0..layers.len()).filter(|&other| layers[other] == layers[strut]);
    let z = of_layer.flat_map(|other| structure.ends(other)).map(|end| end.z);
    let [low, high] = z.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], z| [low.min(z), high.max(z)]);
    let height = (middle(candidates, strut).z - low) / (high - low).max(f64::MIN_POSITIVE);
    let built = candidates.built(standing);
    let [a, b] = structure.struts()[strut].ends;
    match [built[a], built[b]] {
        [true, true] => Some(height),
        [false, false] => None,
        [from_a, _] => {
            let way = structure.nodes()[b].at - structure.nodes()[a].at;
            let way = if from_a { way } else { -way };
            Some(height * (way.z / way.norm()).acos().exp())
        }
    }
}

/// How much a strut takes from those that are still to come.
#[allow(clippy::cast_precision_loss)] // thousands
fn freedom_of_the_rest(candidates: &Candidates<'_>, standing: &GroupSet, group: usize) -> f64 {
    let groups = candidates.groups.all();
    let left: Vec<usize> = (0..groups.len()).filter(|&other| !standing.contains(other)).collect();
    let stands = |strut: usize| {
        let of = candidates.groups.of_strut(strut);
        of == group || standing.contains(of)
    };
    let rest = left.iter().filter(|&&other| other != group);
    let sum: f64 = rest
        .map(|&other| {
            let share = candidates.free.share_among(groups[other].struts[0], &stands);
            (-FREEDOM * share * share).exp()
        })
        .sum();
    sum / left.len() as f64
}

#[cfg(test)]
mod tests {
    use nalgebra::{Point3, Vector3};
    use wirebend_collide::Head;
    use wirebend_frame::{Material, Section};

    use super::*;
    use crate::{Groups, HeadDirections, Pace, Structure, StrutBuilder, Weight};
    use wirebend_core::units::{Angle, Length};
    use wirebend_core::wireframe::{Vertex, VertexId, Wireframe};

    /// What it costs to place a strut of one layer on those that stand, after the last of them. Points are supports where it is said.
    fn cost_of(
        points: &[([f64; 3], bool)],
        edges: &[[u32; 2]],
        stand: &[usize],
        last: Option<usize>,
        strut: usize,
    ) -> Option<f64> {
        let mut made = Wireframe::new();
        for &(at, support) in points {
            made.add_vertex(Vertex { support, ..Vertex::at(Point3::from(at)) }).unwrap();
        }
        for [a, b] in edges {
            made.add_edge(VertexId(*a), VertexId(*b)).unwrap();
        }
        let structure = Structure::new(&made).unwrap();
        let (mm, deg) = (|mm| Length::from_mm(mm).unwrap(), |deg| Angle::from_deg(deg).unwrap());
        let builder = StrutBuilder {
            head: Head::new(&[[0.0, 0.0], [20.0, 11.547], [120.0, 11.547]]).unwrap(),
            places: false,
            directions: HeadDirections::each(deg(18.0)).unwrap(),
            max_create: deg(60.0),
            max_connect: deg(90.0),
            touch: mm(0.1),
            clearance: mm(0.0),
            ground_first: true,
            max_sag: mm(0.65),
            workspace: None,
            pace: Pace { build_mm_s: 10.0, travel_mm_s: 50.0, pause_s: 1.0 },
        };
        let abs = Material { e: 3457.0, g: 1294.0, density: 1210e-12, yield_strength: 40.0 };
        let weight = Weight { section: Section::round(1.5, &abs), gravity: Vector3::z() * -9806.33 };
        let groups = Groups::single(&structure);
        let task = Task { structure: &structure, groups: &groups, builder: &builder, weight: &weight };
        let stability = Stability::new(&structure, &weight).unwrap();
        let mut standing = GroupSet::none(edges.len());
        for &group in stand {
            standing.insert(group);
        }
        cost(&candidates(&task, &stability), &vec![0; edges.len()], &standing, last, strut)
    }

    #[track_caller]
    fn assert_costs(found: Option<f64>, wanted: f64) {
        assert!(found.is_some_and(|found| (found - wanted).abs() < 1e-9), "{found:?} instead of {wanted}");
    }

    /// A strut from 20 to 60 mm in a layer from the ground to 100 mm: its middle is at 0.4 of the height. It rises 40 mm on 50.
    #[test]
    fn stability_is_height_and_for_a_strut_into_the_open_times_exp_of_its_lean() {
        let foot = |y: f64| ([0.0, y, 0.0], true);
        let points = [
            foot(0.0),
            ([0.0, 0.0, 20.0], false),
            ([0.0, 30.0, 60.0], false),
            foot(30.0),
            ([200.0, 0.0, 0.0], true),
            ([200.0, 0.0, 100.0], false),
        ];
        let of = |edges: &[[u32; 2]], stand: &[usize]| cost_of(&points, edges, stand, None, 0);
        let (strut, low, high, top) = ([1, 2], [0, 1], [3, 2], [4, 5]);
        assert_costs(of(&[strut, low, top], &[1, 2]), 0.4 * 0.8_f64.acos().exp());
        // Down from its upper end, and between both.
        assert_costs(of(&[strut, high, top], &[1, 2]), 0.4 * (-0.8_f64).acos().exp());
        assert_costs(of(&[strut, low, high, top], &[1, 2, 3]), 0.4);
    }

    /// Flat on the ground, so that stability costs nothing, and the last one to come.
    #[test]
    fn adjacency_is_one_where_the_last_strut_is_elsewhere() {
        let points = [([0.0; 3], true), ([30.0, 0.0, 0.0], true), ([60.0, 0.0, 0.0], true)];
        let points = [&points[..], &[([60.0, 30.0, 0.0], true), ([60.0, 30.0, 40.0], false)]].concat();
        let edges = [[0, 1], [1, 2], [3, 4]];
        for (last, wanted) in [(None, 0.0), (Some(1), 0.0), (Some(2), 1.0)] {
            assert_costs(cost_of(&points, &edges, &[1, 2], last, 0), wanted);
        }
    }

    /// The strut is 30 mm above a short one that is still to come, and is in the way of a head that stands upright, or by 18° from that: of
    /// 1 + 20 of 182 directions. At 36° the cylinder of the head passes 6 mm beside it. A third strut to come is out of reach.
    #[test]
    fn freedom_is_what_is_left_to_each_of_the_rest() {
        let pair = |x: f64, z: f64| [([x, 0.0, z], true), ([x + 1.0, 0.0, z], true)];
        let points = [pair(0.0, 30.0), pair(0.0, 0.0), pair(500.0, 0.0)].concat();
        let left = |free: f64| (-5.0 * (free / 182.0).powi(2)).exp();
        let freedom = (left(161.0) + left(182.0)) / 3.0;
        // It is the highest of its layer, too.
        assert_costs(cost_of(&points, &[[0, 1], [2, 3], [4, 5]], &[], None, 0), 1.0 + 5.0 * freedom);
    }
}
