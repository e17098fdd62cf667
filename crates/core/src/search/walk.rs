//! The search for a walk: a tree of trails, each cut off where the part that is bent so far already meets something.
//!
//! What a step meets depends on the wire before it alone, and on the edges right after it. So a trail is given up as soon as a step
//! of it has no way to be made, with all trails that begin so.

use rand::RngExt;
use rand_chacha::ChaCha8Rng;

use super::heads::Orientation;
use super::trail::Passes;
use super::wire::{Blocked, OpenWire};
use super::{Bender, Found, FoundWire, Obstruction};
use crate::units::{Angle, Length};
use crate::wireframe::Wireframe;

/// How a trail goes on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Move {
    /// The wire runs along this pass.
    Along(usize),
    /// It ends, and the next one begins at this vertex.
    Begin(usize),
}

/// What a move has changed, so that it can be taken back.
struct Taken {
    what: Move,
    /// How many steps of the open wire were settled before.
    settled: usize,
    /// The open wire before another one was begun.
    before: Option<OpenWire>,
}

struct Node {
    taken: Option<Taken>,
    /// Best last.
    untried: Vec<Move>,
}

/// A search for so many wires.
pub(super) struct Walk<'a> {
    pub wireframe: &'a Wireframe,
    pub bender: &'a Bender<'a>,
    pub passes: &'a Passes,
    /// How many wires there may be.
    pub wires: usize,
    used: Vec<bool>,
    /// How many passes are used.
    count: usize,
    wire: OpenWire,
    finished: Vec<FoundWire>,
    rng: &'a mut ChaCha8Rng,
    /// How much chance there is in the order of moves.
    noise: f64,
    /// How many steps were checked.
    pub checks: u64,
    /// Whether all trails from the start were looked at, and none is possible.
    pub exhausted: bool,
    /// What was in the way where the search came farthest.
    pub obstruction: Option<Obstruction>,
}

/// A trail is given up after so many dead ends, and so many for each pass.
const DEAD_ENDS: [usize; 2] = [10, 3];

impl<'a> Walk<'a> {
    pub fn new(
        wireframe: &'a Wireframe,
        bender: &'a Bender<'a>,
        passes: &'a Passes,
        wires: usize,
        rng: &'a mut ChaCha8Rng,
    ) -> Self {
        Self {
            wireframe,
            bender,
            passes,
            wires,
            used: vec![false; passes.all.len()],
            count: 0,
            wire: OpenWire::new(0, Orientation { unflipped: Angle::ZERO }),
            finished: Vec::new(),
            rng,
            noise: 0.0,
            checks: 0,
            exhausted: false,
            obstruction: None,
        }
    }

    /// Looks for a trail from a start until it has found one, comes into too many dead ends, or `should_continue` says no; it is told how
    /// many steps were checked.
    pub fn descend(
        &mut self,
        (start, orientation): (usize, Orientation),
        noise: f64,
        should_continue: &mut dyn FnMut(u64) -> bool,
    ) -> Option<Found> {
        self.used.fill(false);
        (self.count, self.noise) = (0, noise);
        self.wire = OpenWire::new(start, orientation);
        self.finished.clear();
        let mut dead_ends = 0;
        let mut nodes = vec![Node { taken: None, untried: self.moves() }];
        while let Some(node) = nodes.last_mut() {
            if !should_continue(self.checks) {
                return None;
            }
            let Some(next) = node.untried.pop() else {
                dead_ends += 1;
                if dead_ends > DEAD_ENDS[0] + DEAD_ENDS[1] * self.passes.all.len() {
                    return None;
                }
                if let Some(taken) = nodes.pop().and_then(|node| node.taken) {
                    self.take_back(taken);
                }
                continue;
            };
            if let Some(taken) = self.take(next) {
                if self.count == self.passes.all.len() {
                    if let Some(found) = self.found() {
                        return Some(found);
                    }
                    self.take_back(taken);
                } else {
                    let untried = self.moves();
                    nodes.push(Node { taken: Some(taken), untried });
                }
            }
        }
        self.exhausted = true;
        None
    }

    /// All wires, once everything is used.
    fn found(&mut self) -> Option<Found> {
        let last = self.accepted()?;
        Some(Found { wires: self.finished.iter().cloned().chain([last]).collect() })
    }

    /// The open wire as it ends, where every check agrees.
    fn accepted(&self) -> Option<FoundWire> {
        let found = self.wire.found(self.wireframe, self.passes, self.bender)?;
        (self.bender.accepts)(&found.route, &found.scheduled).then_some(found)
    }

    /// Makes a move, or leaves everything as it is where that is not possible.
    fn take(&mut self, what: Move) -> Option<Taken> {
        match what {
            Move::Along(pass) => {
                let from = self.wire.at(self.passes);
                let settled = self.wire.layers.len();
                self.used[pass] = true;
                self.count += 1;
                self.wire.walked.push((pass, from));
                let taken = Taken { what, settled, before: None };
                let ends = self.count == self.passes.all.len();
                if self.settle(ends) {
                    return Some(taken);
                }
                self.take_back(taken);
                None
            }
            Move::Begin(vertex) => {
                let before = self.wire.clone();
                if !self.settle(true) {
                    self.wire = before;
                    return None;
                }
                let Some(found) = self.accepted() else {
                    self.wire = before;
                    return None;
                };
                self.finished.push(found);
                let same = before.orientation;
                let orientation = if self.rng.random::<bool>() { same.opposite() } else { same };
                self.wire = OpenWire::new(vertex, orientation);
                Some(Taken { what, settled: 0, before: Some(before) })
            }
        }
    }

    fn take_back(&mut self, taken: Taken) {
        match taken.what {
            Move::Along(pass) => {
                self.used[pass] = false;
                self.count -= 1;
                self.wire.walked.pop();
                self.wire.layers.truncate(taken.settled);
            }
            Move::Begin(_) => {
                self.finished.pop();
                if let Some(before) = taken.before {
                    self.wire = before;
                }
            }
        }
    }

    /// Whether the open wire can be made as far as it goes.
    fn settle(&mut self, ends: bool) -> bool {
        let settled = self.wire.layers.len();
        let straight_on = !ends && self.goes_straight_on();
        let left = self.passes.all.iter().zip(&self.used).filter(|(_, used)| !**used);
        let still_to_come: Length = left.map(|(pass, _)| self.wireframe.edge_length(pass.edge)).sum();
        let (wireframe, passes, bender) = (self.wireframe, self.passes, self.bender);
        let result = self.wire.settle(wireframe, passes, bender, (ends, straight_on), still_to_come);
        self.checks += (self.wire.layers.len() - settled) as u64;
        match result {
            Ok(()) => true,
            Err(blocked) => {
                self.checks += 1;
                self.note(blocked);
                false
            }
        }
    }

    /// Whether a pass that is left goes straight on.
    fn goes_straight_on(&self) -> bool {
        let at = self.wire.at(self.passes);
        self.passes.at[at].iter().any(|&pass| !self.used[pass] && self.bend_to(pass) <= self.bender.straight)
    }

    /// How far the wire bends if it goes on along a pass; nothing at its start.
    fn bend_to(&self, pass: usize) -> Angle {
        let Some(&(last, from)) = self.wire.walked.last() else { return Angle::ZERO };
        let at = self.passes.all[last].other(from);
        let direction = |from: usize, to: usize| self.passes.positions[to] - self.passes.positions[from];
        let before = direction(from, at);
        let next = direction(at, self.passes.all[pass].other(at));
        Angle::computed(before.cross(&next).norm().atan2(before.dot(&next)))
    }

    /// How it may go on, best last.
    fn moves(&mut self) -> Vec<Move> {
        let at = self.wire.at(self.passes);
        let allowed = self.wires - self.finished.len();
        let mut moves: Vec<(f64, Move)> = Vec::new();
        let mut seen = Vec::new();
        for &pass in &self.passes.at[at] {
            let bend = self.bend_to(pass);
            let edge = self.passes.all[pass].edge;
            if self.used[pass] || bend > self.bender.max_bend || seen.contains(&edge) {
                continue;
            }
            seen.push(edge);
            let to = self.passes.all[pass].other(at);
            self.used[pass] = true;
            let needed = self.passes.wires_needed(&self.used, Some(to));
            let ends = self.count + 1 == self.used.len();
            self.used[pass] = false;
            if ends || needed <= allowed {
                moves.push((bend.rad() + self.noise * self.rng.random::<f64>(), Move::Along(pass)));
            }
        }
        moves.sort_by(|one, other| other.0.total_cmp(&one.0));
        let mut moves: Vec<Move> = moves.into_iter().map(|(_, next)| next).collect();
        if !self.wire.walked.is_empty() && self.passes.wires_needed(&self.used, None) < allowed {
            let mut starts = self.passes.starts(&self.used);
            let first = if starts.is_empty() { 0 } else { self.rng.random_range(0..starts.len()) };
            starts.rotate_left(first);
            starts.truncate(3);
            moves.splice(..0, starts.into_iter().map(Move::Begin));
        }
        moves
    }

    /// Keeps what is in the way where the search has come farthest.
    fn note(&mut self, blocked: Blocked) {
        let count = self.count;
        if self.obstruction.as_ref().is_some_and(|farthest| farthest.passed > count) {
            return;
        }
        let route = self.wire.route(self.passes);
        let path: Vec<_> = route.vertices();
        let positions: Vec<_> =
            path.iter().filter_map(|&id| self.wireframe.vertex(id)).map(|vertex| vertex.position).collect();
        let program = crate::bend::program_of_path(&positions, self.bender.straight).ok();
        let vertex = program.and_then(|(_, program)| path.get(program.spans.get(blocked.step)?.end).copied());
        self.obstruction =
            Some(Obstruction { passed: count, of: self.used.len(), vertex, obstacle: blocked.obstacle });
    }
}
