//! The motions of a step.

use super::body::{Bodies, MovesWith};
use super::centreline::Lie;
use crate::compensate::PegGeometry;
use crate::units::Angle;

/// What moves in a part of a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Phase {
    /// The wire is fed.
    Feed,
    /// The head turns.
    Rotate,
    /// The peg, which is in, goes to the side of the wire from which it bends.
    Approach,
    /// The peg comes out.
    PegOut,
    /// The bend axis goes out and bends.
    Bend,
    /// The bend axis goes back, and the wire springs back.
    Release,
    /// The peg goes in.
    PegIn,
    /// The bend axis goes back to zero.
    Return,
}

/// A motion between two states; everything moves evenly.
#[derive(Debug, Clone, Copy)]
pub(super) struct Stroke {
    pub phase: Phase,
    pub lie: Lie,
    /// 1 or -1: to which side it bends.
    pub side: f64,
    /// Centreline radius of the bend, mm.
    pub radius: f64,
    /// The bend that stays in the wire, radians, not negative.
    pub stays: f64,
    pub from: State,
    pub to: State,
}

/// Where everything is.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct State {
    /// mm of the step's feed that are through the bend point.
    pub fed: f64,
    /// Radians that the wire is bent, not negative.
    pub bent: f64,
    /// Radians that the head has turned about +x.
    pub head: f64,
    /// Radians that the bend axis has turned about the head's z.
    pub axis: f64,
    /// mm that the peg is in.
    pub peg_in: f64,
}

impl State {
    fn between(&self, to: &Self, time: f64) -> Self {
        let at = |from: f64, to: f64| from + (to - from) * time;
        Self {
            fed: at(self.fed, to.fed),
            bent: at(self.bent, to.bent),
            head: at(self.head, to.head),
            axis: at(self.axis, to.axis),
            peg_in: at(self.peg_in, to.peg_in),
        }
    }
}

impl Stroke {
    /// How far that goes which the phase is about.
    pub fn size(&self) -> f64 {
        let Self { from, to, .. } = self;
        let moved = match self.phase {
            Phase::Feed => to.fed - from.fed,
            Phase::Rotate => to.head - from.head,
            Phase::PegOut | Phase::PegIn => to.peg_in - from.peg_in,
            Phase::Approach | Phase::Bend | Phase::Release | Phase::Return => to.axis - from.axis,
        };
        moved.abs()
    }

    /// Whether the wire is bent beyond what is left in it.
    pub fn overbends(&self) -> bool {
        self.to.bent > self.stays
    }

    /// The same in one or two parts, of which only the second overbends.
    pub fn split(self) -> impl Iterator<Item = Self> {
        let Self { from, to, stays, .. } = self;
        let overbends_later = self.overbends() && from.bent < stays;
        let time = if overbends_later { (stays - from.bent) / (to.bent - from.bent) } else { 1.0 };
        let between = State { bent: stays.min(to.bent), ..self.at(time) };
        let first = if overbends_later { Self { to: between, ..self } } else { self };
        [first].into_iter().chain(overbends_later.then_some(Self { from: between, ..self }))
    }

    /// Where everything is at a time from 0 to 1.
    pub fn at(&self, time: f64) -> State {
        self.from.between(&self.to, time)
    }

    /// Whether a body moves past the wire.
    pub fn moves(&self, body: MovesWith) -> bool {
        let State { fed, bent, head, axis, peg_in } = self.from;
        let wire = fed < self.to.fed || bent < self.to.bent;
        // What springs back goes the way that it came, and was looked at there.
        match body {
            MovesWith::Frame => wire,
            MovesWith::Head => wire || differs(head, self.to.head),
            MovesWith::Peg => {
                wire || differs(bent, self.to.bent)
                    || differs(head, self.to.head)
                    || differs(axis, self.to.axis)
                    || differs(peg_in, self.to.peg_in)
            }
        }
    }
}

fn differs(one: f64, other: f64) -> bool {
    (one - other).abs() > 0.0
}

/// One way to run a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepRun {
    /// Where the head is before it turns and while it bends, right-handed about +x of the machine.
    pub head: [Angle; 2],
    /// The bend that is left in the wire, signed as it is run.
    pub bend: Angle,
}

/// What a step does, as far as its strokes ask.
pub(super) struct Moves {
    pub lie: Lie,
    pub radius: f64,
    /// mm.
    pub fed: f64,
    /// Head before and after it turns.
    pub head: [Angle; 2],
    /// The bend that is left in the wire.
    pub bend: Angle,
    /// How far the wire is bent before it springs back, as a magnitude.
    pub pressed: Angle,
    /// Where the bend axis goes.
    pub told: Angle,
    /// Where the peg comes out, where that is not its place for straight wire.
    pub approach: Option<Angle>,
}

/// So many parts make a bend whose peg follows the wire: one for each so many radians. The peg is off by the square of it; where it first
/// hits the wire is exact to 0.01 mm with this, and not with a quarter more.
const PART_OF_BEND: f64 = 0.07;

/// The strokes of a step, in order. `in_parts`: whether a bend is divided so that the peg follows the wire as it does;
/// nothing else of the machine cares how.
pub(super) fn strokes(
    moves: &Moves,
    bodies: &Bodies,
    peg: Option<&PegGeometry>,
    in_parts: bool,
) -> Vec<Stroke> {
    let Moves { lie, radius, fed, head, bend, .. } = *moves;
    let bends = bend != Angle::ZERO;
    let rest = bodies.peg_stroke.mm();
    let mut state = State { head: head[0].rad(), peg_in: rest, ..State::default() };
    let mut strokes = Vec::new();
    let mut go = |phase: Phase, change: &dyn Fn(&mut State)| {
        let from = state;
        change(&mut state);
        if state != from {
            let side = bend.signum();
            strokes.push(Stroke { phase, lie, side, radius, stays: bend.abs().rad(), from, to: state });
        }
    };
    go(Phase::Feed, &|state| state.fed = fed);
    go(Phase::Rotate, &|state| state.head = head[1].rad());
    if !bends {
        return strokes;
    }
    let path = AxisPath::new(moves, bodies, peg, in_parts);
    go(Phase::Approach, &|state| state.axis = path.begin);
    go(Phase::PegOut, &|state| state.peg_in = 0.0);
    go(Phase::Bend, &|state| state.axis = path.touch);
    for &(bent, axis) in &path.bending {
        go(Phase::Bend, &|state| (state.bent, state.axis) = (bent, axis));
    }
    go(Phase::Release, &|state| (state.bent, state.axis) = (bend.abs().rad(), path.begin));
    go(Phase::PegIn, &|state| state.peg_in = rest);
    go(Phase::Return, &|state| state.axis = 0.0);
    strokes
}

/// Where the bend axis is, radians.
struct AxisPath {
    /// Where the peg comes out.
    begin: f64,
    /// Where it touches the wire.
    touch: f64,
    /// How far the wire is bent, and where the axis is then.
    bending: Vec<(f64, f64)>,
}

impl AxisPath {
    fn new(moves: &Moves, bodies: &Bodies, peg: Option<&PegGeometry>, in_parts: bool) -> Self {
        let (side, pressed) = (moves.bend.signum(), moves.pressed.rad());
        let parts = if in_parts && peg.is_some() { (pressed / PART_OF_BEND).ceil().max(1.0) } else { 1.0 };
        let mut bent = 0.0;
        let mut bending = Vec::new();
        let beside = |bent: Angle| peg.and_then(|peg| peg.axis_for(bent)).map(|axis| side * axis.rad());
        let touching = beside(Angle::ZERO);
        // Without a peg it stands as far from the wire on this side as it does at rest.
        let straight =
            touching.unwrap_or_else(|| -side * bodies.peg_rest.abs().rad() - bodies.peg_rest.rad());
        let clear = if touching.is_some() { side * bodies.approach.rad() } else { 0.0 };
        let touch = moves.approach.map_or(straight, |approach| approach.rad() + clear);
        let begin = touch - clear;
        let end = if touching.is_some() { moves.told.rad() } else { touch + moves.told.rad() };
        // A corner within the peg's reach makes it touch the wire and end elsewhere; from the one to the other it goes little by little.
        let off = [touch - straight, beside(moves.pressed).map_or(0.0, |axis| end - axis)];
        let mut part = 0.0;
        while part < parts {
            part += 1.0;
            bent = if part < parts { pressed * part / parts } else { pressed.max(bent) };
            let share = part / parts;
            let follows = beside(Angle::computed(bent)).filter(|_| part < parts);
            let axis = follows
                .map_or(touch + (end - touch) * share, |axis| axis + off[0] + (off[1] - off[0]) * share);
            bending.push((bent, axis));
        }
        Self { begin, touch, bending }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{Point3, UnitQuaternion};

    use super::*;
    use crate::testing::{deg, mm, published_machine};

    /// The peg comes out and goes in where the program has it, on either side; where it says nothing, 5 degrees before it touches
    /// straight wire. From there it turns evenly to where the bend ends: a bend of 40 degrees is ten parts.
    #[test]
    fn the_peg_comes_out_where_the_program_has_it() {
        let machine = published_machine();
        let peg = machine.compensation.bend.setback.as_ref();
        let bodies = Bodies { peg_stroke: mm(10.0), approach: deg(5.0), ..Bodies::default() };
        for side in [1.0, -1.0] {
            for (approach, expected) in [(None, -18.248), (Some(deg(-40.0 * side)), -40.0)] {
                let moves = Moves {
                    lie: Lie { turn: UnitQuaternion::identity(), begin: Point3::origin() },
                    radius: 3.0,
                    fed: 30.0,
                    head: [Angle::ZERO; 2],
                    bend: deg(side * 30.0),
                    pressed: deg(40.0),
                    told: deg(side * 47.0),
                    approach,
                };
                let all = strokes(&moves, &bodies, peg, true);
                let bending = all.iter().filter(|stroke| stroke.to.bent > stroke.from.bent);
                let turns: Vec<f64> =
                    bending.map(|stroke| side * (stroke.to.axis - stroke.from.axis)).collect();
                let [least, most] = [f64::min, f64::max].map(|of| turns.iter().copied().reduce(of).unwrap());
                assert!(turns.len() == 10 && least > 0.0 && most < 1.5 * least, "{approach:?}: {turns:?}");
                for (phase, at) in [(Phase::PegOut, expected), (Phase::PegIn, expected), (Phase::Return, 0.0)]
                {
                    let stroke = all.iter().find(|stroke| stroke.phase == phase).unwrap();
                    let axis = side * stroke.to.axis.to_degrees();
                    assert!((axis - at).abs() < 1e-3, "{phase:?} to {side}: {axis}");
                }
            }
        }
    }
}
