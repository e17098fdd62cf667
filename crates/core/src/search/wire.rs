//! A wire while it is laid out: what it has run along, and the ways to bend that.

use std::collections::BTreeSet;

use super::heads::{Layer, Orientation, StepQuestion, scheduled};
use super::trail::{Pass, Passes};
use super::{Bender, FoundWire, orientations, orientations_between};
use crate::bend::{NominalProgram, program_of_path};
use crate::clearance::{Clearance, Obstacle, StockWire, passages};
use crate::route::{Route, Traversal};
use crate::units::{Angle, Length};
use crate::wireframe::Wireframe;

/// A wire that is being laid out.
#[derive(Debug, Clone)]
pub(super) struct OpenWire {
    pub start: usize,
    pub orientation: Orientation,
    /// The passes that it has run along, each with the vertex where that begins.
    pub walked: Vec<(usize, usize)>,
    /// The ways to make each step, as far as they are settled.
    pub layers: Vec<Layer>,
}

/// Why a wire cannot go on so.
#[derive(Debug, Clone, Copy)]
pub(super) struct Blocked {
    /// The step that cannot be made.
    pub step: usize,
    /// What is in the way; none where the head cannot turn so far.
    pub obstacle: Option<Obstacle>,
}

impl OpenWire {
    pub const fn new(start: usize, orientation: Orientation) -> Self {
        Self { start, orientation, walked: Vec::new(), layers: Vec::new() }
    }

    /// The vertex where it is.
    pub fn at(&self, passes: &Passes) -> usize {
        self.walked.last().map_or(self.start, |&(pass, from)| passes.all[pass].other(from))
    }

    /// Settles the ways to make its steps. `ends`: it ends here, with all of its steps; else `goes_straight_on` says whether it may
    /// go straight on, so that its last bend waits for what comes then.
    pub fn settle(
        &mut self,
        wireframe: &Wireframe,
        passes: &Passes,
        bender: &Bender,
        (ends, goes_straight_on): (bool, bool),
        still_to_come: Length,
    ) -> Result<(), Blocked> {
        let route = self.route(passes);
        let Some(trial) =
            TrialWire::new(wireframe, &route.traversals, bender, self.orientation, still_to_come)
        else {
            return Ok(());
        };
        let steps = trial.program.steps.len();
        let until = if ends { steps } else { (steps - 1).saturating_sub(usize::from(goes_straight_on)) };
        for index in self.layers.len()..until {
            let before = self.layers.last().cloned().unwrap_or_else(Layer::first);
            let layer = trial.question(bender, self.orientation, index, false).after(&before);
            if layer.states.is_empty() {
                return Err(Blocked { step: index, obstacle: layer.obstacle });
            }
            self.layers.push(layer);
        }
        Ok(())
    }

    /// What it has run along.
    pub fn route(&self, passes: &Passes) -> Route {
        let mut seen = BTreeSet::new();
        let traversal = |&(pass, from): &(usize, usize)| {
            let Pass { edge, .. } = passes.all[pass];
            let to = passes.all[pass].other(from);
            let [from, to] = [from, to].map(|place| passes.vertices[place]);
            Traversal { edge, from, to, again: !seen.insert(edge) }
        };
        Route { traversals: self.walked.iter().map(traversal).collect() }
    }

    /// It with the best of the ways to bend it, once it ends.
    pub fn found(&self, wireframe: &Wireframe, passes: &Passes, bender: &Bender) -> Option<FoundWire> {
        let route = self.route(passes);
        let path = path(wireframe, &route.traversals);
        let (_, program) = program_of_path(&path, bender.straight).ok()?;
        found(&program, route, &self.layers)
    }
}

/// A route with a program and what is in the machine while it runs.
struct TrialWire<'a> {
    program: NominalProgram,
    clearance: Clearance<'a>,
    first_bend: usize,
}

impl<'a> TrialWire<'a> {
    /// None where the route has no program.
    fn new(
        wireframe: &Wireframe,
        traversals: &[Traversal],
        bender: &Bender<'a>,
        orientation: Orientation,
        still_to_come: Length,
    ) -> Option<Self> {
        let (start, program) = program_of_path(&path(wireframe, traversals), bender.straight).ok()?;
        let passages = passages(wireframe, traversals, &program.spans);
        let wire = StockWire { tail: bender.wire.tail + still_to_come, ..bender.wire };
        let clearance =
            Clearance::new((start, &program.steps), None, passages, wire, bender.bodies, bender.bend);
        let first_bend = program.steps.iter().position(|step| step.bend != Angle::ZERO).unwrap_or(usize::MAX);
        Some(Self { clearance: clearance.turned(orientation.turn()), program, first_bend })
    }

    fn question<'b>(
        &'b self,
        bender: &'b Bender<'b>,
        orientation: Orientation,
        index: usize,
        despite_contacts: bool,
    ) -> StepQuestion<'b> {
        StepQuestion {
            bender,
            clearance: &self.clearance,
            index,
            step: self.program.steps[index],
            orientation: (index == self.first_bend).then_some(orientation),
            despite_contacts,
        }
    }
}

/// The best way to bend a route that is settled: it meets least, and of those that do it takes least. `turned`: whether the part is
/// turned to the sides, too, where nothing else is free of contacts.
pub(crate) fn bend_route(
    wireframe: &Wireframe,
    route: &Route,
    bender: &Bender,
    turned: bool,
) -> Option<FoundWire> {
    let bend = |orientation: Orientation| {
        let trial = TrialWire::new(wireframe, &route.traversals, bender, orientation, Length::ZERO)?;
        let mut layers: Vec<Layer> = Vec::new();
        for index in 0..trial.program.steps.len() {
            let before = layers.last().cloned().unwrap_or_else(Layer::first);
            layers.push(trial.question(bender, orientation, index, true).after(&before));
        }
        found(&trial.program, route.clone(), &layers)
    };
    let best_of = |turned: bool| {
        let bent = orientations(bender.head, turned).into_iter().filter_map(&bend);
        bent.min_by_key(|found| (found.met, found.nanoseconds))
    };
    let at_reference = best_of(false);
    let aside = match at_reference {
        Some(found) if found.met == 0 || !turned => return Some(found),
        _ => best_of(turned),
    };
    match aside {
        Some(found) if found.met > 0 => {
            let clear = orientations_between(bender.head).into_iter().filter_map(&bend);
            Some(clear.into_iter().find(|found| found.met == 0).unwrap_or(found))
        }
        aside => aside,
    }
}

fn found(program: &NominalProgram, route: Route, layers: &[Layer]) -> Option<FoundWire> {
    let last = layers.last()?;
    let best = last.best()?;
    let state = last.states[best];
    Some(FoundWire {
        route,
        scheduled: scheduled(program, layers, best),
        met: state.met,
        nanoseconds: state.spent,
    })
}

fn path(wireframe: &Wireframe, traversals: &[Traversal]) -> Vec<nalgebra::Point3<f64>> {
    let vertices =
        traversals.first().map(|first| first.from).into_iter().chain(traversals.iter().map(|one| one.to));
    vertices.filter_map(|vertex| wireframe.vertex(vertex)).map(|vertex| vertex.position).collect()
}
