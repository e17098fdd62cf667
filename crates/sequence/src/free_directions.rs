//! In which directions the head can stand while a group is placed.

use std::cell::{Cell, RefCell};
use std::collections::HashMap;
use std::ops::ControlFlow;

use wirebend_collide::{DirectionSet, Passage, between_pieces};
use wirebend_core::units::Length;

use super::builder::StrutBuilder;
use super::groups::Group;
use super::structure::Structure;

/// What the head does at once.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
enum Carried {
    /// It goes along a strut.
    Along(usize),
    /// It stands at a node.
    At(usize),
}

/// For which directions a strut is in the way, as far as somebody asked.
#[derive(Debug, Clone, Copy, Default)]
struct Known {
    asked: DirectionSet,
    met: DirectionSet,
}

/// What is near the way of a head.
#[derive(Debug, Default)]
struct Near {
    /// The struts that it could meet, nearest first: those block soonest.
    struts: Vec<u32>,
    /// What is known of each of them, as far down the list as somebody asked.
    known: Vec<Known>,
}

/// A joint of a group, or the node from which a strut is drawn, and in which directions the head can stand there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Free {
    /// The node.
    pub node: usize,
    /// The directions; none where nothing is free.
    pub directions: DirectionSet,
}

/// How much deeper than allowed a strut may be in the head unnoticed, mm.
const TOLERANCE_MM: f64 = 0.001;

/// So many pairs are kept, a quarter of a gigabyte; beyond it all are forgotten and asked again.
const MOST_PAIRS: usize = 4_000_000;

/// Asks collisions between the moving head and struts, each once as long as it is kept.
pub(super) struct FreeDirections<'a> {
    structure: &'a Structure,
    builder: &'a StrutBuilder,
    radius: Length,
    /// Directions for a strut drawn from its first end, from its second; into the open, and between nodes that are built.
    approach: Vec<[[DirectionSet; 2]; 2]>,
    near: RefCell<HashMap<Carried, Near>>,
    /// Of all of these together, how many pairs are kept.
    pairs: Cell<usize>,
}

impl<'a> FreeDirections<'a> {
    pub fn new(structure: &'a Structure, builder: &'a StrutBuilder, radius: Length) -> Self {
        let approach = (0..structure.struts().len()).map(|strut| {
            let [a, b] = structure.ends(strut);
            [builder.max_create, builder.max_connect]
                .map(|max| [b - a, a - b].map(|way| builder.directions.within(max, &way)))
        });
        Self {
            structure,
            builder,
            radius,
            approach: approach.collect(),
            near: RefCell::default(),
            pairs: Cell::default(),
        }
    }

    /// Where the head can stand while a group is placed among the struts that stand: for a strut that is drawn the end from which more
    /// directions are free, for what is placed every joint. `built` tells which nodes are. Empty where nothing of it is built.
    pub fn of(
        &self,
        group: &Group,
        built: &dyn Fn(usize) -> bool,
        stands: &dyn Fn(usize) -> bool,
    ) -> Vec<Free> {
        let Some(strut) = self.drawn(group) else {
            let joints = group.nodes.iter().filter(|&&node| built(node));
            let all = DirectionSet::first(self.builder.directions.all().len());
            // The group is there at once, and in the way as what stands.
            let stands = |other: usize| stands(other) || group.struts.contains(&other);
            let free = |&node: &usize| Free { node, directions: self.left(Carried::At(node), all, &stands) };
            return joints.map(free).collect();
        };
        let ends = self.structure.struts()[strut].ends;
        let starts = ends.map(built);
        let kind = usize::from(starts[0] && starts[1]);
        let allowed = [0, 1]
            .map(|end| if starts[end] { self.approach[strut][kind][end] } else { DirectionSet::default() });
        let left = self.left(Carried::Along(strut), allowed[0].or(allowed[1]), stands);
        let free = [0, 1].map(|end| Free { node: ends[end], directions: allowed[end].and(left) });
        let better = usize::from(free[1].directions.len() > free[0].directions.len());
        if starts == [false; 2] {
            Vec::new()
        } else {
            vec![free[if starts[better] { better } else { 1 - better }]]
        }
    }

    /// The strut that a group is, where the head draws it.
    fn drawn(&self, group: &Group) -> Option<usize> {
        group.struts.first().copied().filter(|_| !self.builder.is_placed(group.struts.len()))
    }

    /// The struts that stand and are in the way of a group in some of the directions that it could use, with how many.
    pub fn in_the_way(
        &self,
        group: &Group,
        built: &dyn Fn(usize) -> bool,
        stands: &dyn Fn(usize) -> bool,
    ) -> Vec<(usize, usize)> {
        let Some(strut) = self.drawn(group) else {
            let all = DirectionSet::first(self.builder.directions.all().len());
            let joints = group.nodes.iter().filter(|&&node| built(node));
            return joints.flat_map(|&node| self.blocking(Carried::At(node), all, stands)).collect();
        };
        let starts = self.structure.struts()[strut].ends.map(built);
        let approach = &self.approach[strut][usize::from(starts[0] && starts[1])];
        let allowed = (0..2).filter(|&end| starts[end]).map(|end| approach[end]);
        let allowed = allowed.fold(DirectionSet::default(), DirectionSet::or);
        self.blocking(Carried::Along(strut), allowed, stands)
    }

    /// The share of all directions in which a strut can still be built once another stands, however it is approached.
    #[allow(clippy::cast_precision_loss)] // fewer than two hundred
    pub fn share_beside(&self, strut: usize, other: usize) -> f64 {
        let all = DirectionSet::first(self.builder.directions.all().len());
        let mut met = DirectionSet::default();
        self.each_near(Carried::Along(strut), |near, place, there| {
            if there != other {
                return ControlFlow::Continue(());
            }
            met = self.met(Carried::Along(strut), near, place, all);
            ControlFlow::Break(())
        });
        all.without(met).len() as f64 / all.len() as f64
    }

    /// The share of all directions in which a strut can still be built among others, however it is approached.
    #[allow(clippy::cast_precision_loss)] // fewer than two hundred
    pub fn share_among(&self, strut: usize, stands: &dyn Fn(usize) -> bool) -> f64 {
        let all = DirectionSet::first(self.builder.directions.all().len());
        self.left(Carried::Along(strut), all, stands).len() as f64 / all.len() as f64
    }

    fn blocking(
        &self,
        carried: Carried,
        allowed: DirectionSet,
        stands: &dyn Fn(usize) -> bool,
    ) -> Vec<(usize, usize)> {
        let mut blocked = Vec::new();
        self.each_near(carried, |near, place, other| {
            let directions = if stands(other) { self.met(carried, near, place, allowed).len() } else { 0 };
            if directions > 0 {
                blocked.push((other, directions));
            }
            ControlFlow::Continue(())
        });
        blocked
    }

    /// What is left of directions once all that stands is in the way.
    fn left(&self, carried: Carried, allowed: DirectionSet, stands: &dyn Fn(usize) -> bool) -> DirectionSet {
        let mut left = allowed;
        self.each_near(carried, |near, place, other| {
            if left.is_empty() {
                return ControlFlow::Break(());
            }
            if stands(other) {
                left = left.without(self.met(carried, near, place, left));
            }
            ControlFlow::Continue(())
        });
        left
    }

    /// Goes through what is near, nearest first.
    fn each_near(&self, carried: Carried, mut with: impl FnMut(&mut Near, usize, usize) -> ControlFlow<()>) {
        let mut kept = self.near.borrow_mut();
        if self.pairs.get() > MOST_PAIRS {
            kept.clear();
            self.pairs.set(0);
        }
        let near = kept.entry(carried).or_insert_with(|| self.within_reach(carried));
        let before = near.known.len();
        for place in 0..near.struts.len() {
            let other = near.struts[place] as usize;
            if with(near, place, other).is_break() {
                break;
            }
        }
        self.pairs.set(self.pairs.get() + near.known.len() - before);
    }

    /// The directions of those asked in which a strut that is near is in the way.
    fn met(&self, carried: Carried, near: &mut Near, place: usize, asked: DirectionSet) -> DirectionSet {
        if near.known.len() <= place {
            near.known.resize(place + 1, Known::default());
        }
        let known = &mut near.known[place];
        let open = asked.without(known.asked);
        if !open.is_empty() {
            let other = near.struts[place] as usize;
            let limit = if self.touches(carried, other) {
                -self.builder.touch.mm()
            } else {
                self.builder.clearance.mm() + self.radius.mm()
            };
            let passage = Passage {
                motion: self.way(carried),
                piece: self.structure.ends(other),
                limit,
                tolerance: TOLERANCE_MM,
            };
            known.met = known.met.or(self.builder.head.meets(&passage, self.builder.directions.all(), open));
            known.asked = known.asked.or(open);
        }
        known.met.and(asked)
    }

    fn touches(&self, carried: Carried, other: usize) -> bool {
        match carried {
            Carried::Along(strut) => self.structure.share_a_node(strut, other),
            Carried::At(node) => self.structure.struts()[other].ends.contains(&node),
        }
    }

    fn way(&self, carried: Carried) -> [&nalgebra::Point3<f64>; 2] {
        match carried {
            Carried::Along(strut) => self.structure.ends(strut),
            Carried::At(node) => [&self.structure.nodes()[node].at; 2],
        }
    }

    /// The struts that are within the reach of the head.
    fn within_reach(&self, carried: Carried) -> Near {
        let reach = self.builder.head.reach() + self.builder.clearance.mm() + self.radius.mm();
        let way = self.way(carried).map(|end| *end);
        let mut near: Vec<(f64, u32)> = (0..)
            .zip(0..self.structure.struts().len())
            .filter(|&(_, other)| carried != Carried::Along(other))
            .map(|(id, other)| (between_pieces(&way, &self.structure.ends(other).map(|end| *end)).0, id))
            .filter(|&(distance, _)| distance < reach)
            .collect();
        near.sort_by(|one, other| one.0.total_cmp(&other.0).then(one.1.cmp(&other.1)));
        Near { struts: near.into_iter().map(|(_, other)| other).collect(), known: Vec::new() }
    }
}
