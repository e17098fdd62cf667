//! A bender that pushes, turns and winds pieces of wire, a little at a time: none of the code that is measured but the distance of a
//! piece that stands still.

mod distance;

use nalgebra::{Isometry3, Point3, Rotation3, Translation3, Unit, UnitQuaternion, Vector3};
use wirebend_core::bend::Step;
use wirebend_core::clearance::{Body, MovesWith, Passage, Phase};
use wirebend_core::plan::Machine;
use wirebend_core::units::{Angle, Length};

pub use distance::nearest;

/// How far things turn at a time, radians: 0.05°.
const TURN: f64 = 0.000_872_664_6;
/// How far things go at a time, mm.
const GO: f64 = 0.05;
/// How far a chord of an arc turns, radians.
const CHORD: f64 = 0.05;

/// A straight piece of wire.
#[derive(Clone, Copy)]
struct Piece {
    ends: [Point3<f64>; 2],
    /// The length of the wire from its start to each end, mm.
    along: [f64; 2],
}

/// An edge that the wire has run along.
#[derive(Clone, Copy)]
struct Ran {
    passage: Passage,
    /// The length of the wire at its ends, mm.
    along: [f64; 2],
    /// In which step, and how far from the corner at which that begins, mm.
    step: usize,
    from_corner: [f64; 2],
    /// How much of it are the arcs at its ends, mm.
    arcs: [f64; 2],
}

/// The machine with the wire in it.
pub struct Bender<'a> {
    machine: &'a Machine,
    pieces: Vec<Piece>,
    /// From the frame of the wire's start to that of the machine.
    wire: Isometry3<f64>,
    /// Where the wire has its corners, as seen from its start.
    corners: Vec<Point3<f64>>,
    /// The length of the wire that is rigid.
    out: f64,
    /// What each step runs along, with lengths.
    passages: Vec<Vec<(Passage, Length)>>,
    passed: Vec<Ran>,
    /// Where the stock goes from the bend before and after it, as the part sees it.
    stock_goes: [Vector3<f64>; 2],
    /// How far things have to stay from each other, mm.
    margin: f64,
    /// The step that is run.
    step: usize,
    /// The length of the wire at the middle of the arc before.
    corner: f64,
    /// How many times as far as usual it goes between two states.
    stride: f64,
    /// Radians about +x.
    head: f64,
    /// Radians about the head's z.
    axis: f64,
    /// Whether the wire is bent beyond what stays.
    overbent: bool,
    peg_in: f64,
    /// What is left to be fed, and the tail.
    stock: f64,
    bend_before: f64,
    /// Of each step where the peg comes out and where the bend axis ends, radians; none where that is as beside straight wire.
    goes: Vec<Option<[f64; 2]>>,
}

/// When in its step something is: the phase, and how much of it has passed. While the peg comes to the wire before it bends that counts from
/// -1 to 0, then from 0 to 1 as the wire bends.
pub type Moment = (Phase, f64);

/// What is shown of each state.
pub type See<'s> = dyn FnMut(Moment, &Bender) + 's;

impl<'a> Bender<'a> {
    /// `passages`: what each step runs along. `stride`: how many times as far as 0.05 degrees and mm it goes between two states.
    #[must_use]
    pub fn new(
        machine: &'a Machine,
        steps: &[Step],
        passages: Vec<Vec<(Passage, Length)>>,
        stride: f64,
    ) -> Self {
        Self {
            machine,
            pieces: Vec::new(),
            wire: Isometry3::identity(),
            corners: vec![Point3::origin()],
            out: 0.0,
            passages,
            passed: Vec::new(),
            stock_goes: [-Vector3::x(); 2],
            margin: 0.0,
            step: 0,
            corner: 0.0,
            stride,
            head: 0.0,
            axis: 0.0,
            overbent: false,
            peg_in: machine.bodies.peg_stroke.mm(),
            stock: fed(machine, steps) + machine.limits.tail.value.mm(),
            bend_before: 0.0,
            goes: Vec::new(),
        }
    }

    /// The same with where the peg comes out and where the bend axis ends in each step, radians.
    #[must_use]
    pub fn with_axes(mut self, goes: Vec<Option<[f64; 2]>>) -> Self {
        self.goes = goes;
        self
    }

    /// The same with how far things have to stay from each other, mm.
    #[must_use]
    pub const fn with_margin(mut self, margin: f64) -> Self {
        self.margin = margin;
        self
    }

    /// How far a bend is pressed before it springs back.
    #[must_use]
    pub fn pressed(machine: &Machine, bend: Angle) -> f64 {
        let springback = machine.compensation.bend.springback.as_ref();
        springback.map_or(bend, |model| model.bend_to(bend)).abs().rad()
    }

    /// Where the axis begins to bend, touches the wire, and ends in a step, radians.
    #[must_use]
    pub fn axes(&self, index: usize, step: &Step) -> Option<[f64; 3]> {
        let model = &self.machine.compensation.bend;
        let side = step.bend.signum();
        let clear = side * self.machine.bodies.approach.rad();
        if let Some([begin, end]) = self.goes.get(index).copied().flatten() {
            return Some([begin, begin + clear, end]);
        }
        let touch = side * model.setback.as_ref()?.axis_for(Angle::ZERO)?.rad();
        Some([touch - clear, touch, model.command(step.bend).ok()?.rad()])
    }

    /// Runs a step. `also`: moments at which it has to be seen besides.
    pub fn run(&mut self, step: &Step, also: &[Moment], see: &mut See) {
        let radius = self.machine.bend_radius.mm();
        let size = step.bend.abs().rad();
        let corner = |bend: f64| radius * (bend / 2.0).tan();
        let fed = step.feed.mm() - corner(self.bend_before) - corner(size) + radius * size;
        self.stock -= fed;
        let begin = (self.pieces.clone(), self.wire);
        for part in self.parts(fed / GO, Phase::Feed, also) {
            self.pieces.clone_from(&begin.0);
            self.wire = begin.1;
            self.place(&Isometry3::translation(fed * part, 0.0, 0.0));
            see((Phase::Feed, part), self);
        }
        let straight = fed - radius * size;
        let [from, to] = [fed, radius * size].map(|x| Point3::new(x, 0.0, 0.0));
        self.pieces.push(Piece { ends: [from, to], along: [self.out, self.out + straight] });
        self.out += straight;
        self.pass(self.out, [self.bend_before, size].map(|bend| radius * bend / 2.0));
        let ahead = Point3::new(radius * size - corner(size), 0.0, 0.0);
        self.corners.push(self.wire.inverse() * ahead);
        let from = self.head;
        // Where nothing turns nothing comes nearer.
        if step.rotate != Angle::ZERO {
            for part in self.parts(step.rotate.abs().rad() / TURN, Phase::Rotate, also) {
                self.head = from - step.rotate.rad() * part;
                see((Phase::Rotate, part), self);
            }
        }
        if size > 0.0 {
            self.wind(step, size, also, see);
        }
        self.bend_before = size;
        self.step += 1;
    }

    /// It has run along the passages of a step, up to the middle of the arc at their end. `arcs`: half of those at both ends.
    fn pass(&mut self, straight_end: f64, arcs: [f64; 2]) {
        let corner = straight_end + arcs[1];
        let own = &self.passages[self.step];
        let whole: f64 = own.iter().map(|(_, length)| length.mm()).sum();
        let (mut from, mut ran) = (self.corner, 0.0);
        for (k, (passage, length)) in own.iter().enumerate() {
            let to = from + (corner - self.corner) * length.mm() / whole;
            let from_corner = [ran, ran + length.mm()];
            let arcs = [if k == 0 { arcs[0] } else { 0.0 }, if k + 1 == own.len() { arcs[1] } else { 0.0 }];
            self.passed.push(Ran {
                passage: *passage,
                along: [from, to],
                step: self.step,
                from_corner,
                arcs,
            });
            (from, ran) = (to, from_corner[1]);
        }
        self.corner = corner;
    }

    fn wind(&mut self, step: &Step, size: f64, also: &[Moment], see: &mut See) {
        let (side, pressed) = (step.bend.signum(), Self::pressed(self.machine, step.bend));
        let machine = self.machine;
        let Some((peg, [begin, touch, end])) =
            machine.compensation.bend.setback.as_ref().zip(self.axes(self.step, step))
        else {
            return;
        };
        let beside = |bent: f64| {
            let axis = peg.axis_for(Angle::from_deg(bent.to_degrees()).unwrap_or(Angle::ZERO));
            axis.map(|axis| side * axis.rad())
        };
        // How far from beside straight wire it touches, and ends.
        let [first, last] = [(0.0, touch), (pressed, end)]
            .map(|(bent, axis)| beside(bent).map_or(0.0, |beside| axis - beside));
        let axis = Rotation3::from_axis_angle(&Vector3::x_axis(), self.head) * Vector3::z_axis();
        let unbent = Rotation3::from_axis_angle(&axis, -side * size) * -Vector3::x();
        self.stock_goes = [-Vector3::x(), unbent].map(|goes| self.wire.inverse() * goes);
        let rest = self.peg_in;
        self.swing([0.0, begin], Phase::Approach, also, see);
        self.slide([rest, 0.0], Phase::PegOut, also, see);
        let before_it: Vec<Moment> = also.iter().map(|(phase, part)| (*phase, part + 1.0)).collect();
        for part in self.parts((touch - begin).abs() / TURN, Phase::Bend, &before_it) {
            self.axis = begin + (touch - begin) * part;
            see((Phase::Bend, part - 1.0), self);
        }
        let mut bent = 0.0;
        for part in self.parts(pressed / TURN, Phase::Bend, also) {
            let next = pressed * part;
            self.turn(side, f64::midpoint(bent, next), next - bent);
            let axis = beside(next).filter(|_| part < 1.0).map(|axis| axis + first + (last - first) * part);
            (bent, self.axis) = (next, axis.unwrap_or(end));
            self.overbent = bent > size;
            see((Phase::Bend, part), self);
        }
        self.overbent = false;
        for part in self.parts((end - begin).abs() / TURN, Phase::Release, also) {
            let next = pressed + (size - pressed) * part;
            self.turn(side, f64::midpoint(bent, next), next - bent);
            (bent, self.axis) = (next, end + (begin - end) * part);
            see((Phase::Release, part), self);
        }
        self.slide([0.0, rest], Phase::PegIn, also, see);
        self.swing([begin, 0.0], Phase::Return, also, see);
        self.wound(side, size);
    }

    fn parts(&self, count: f64, phase: Phase, also: &[Moment]) -> Vec<f64> {
        parts(count / self.stride, phase, also)
    }

    fn swing(&mut self, [from, to]: [f64; 2], phase: Phase, also: &[Moment], see: &mut See) {
        for part in self.parts((to - from).abs() / TURN, phase, also) {
            self.axis = from + (to - from) * part;
            see((phase, part), self);
        }
    }

    fn slide(&mut self, [from, to]: [f64; 2], phase: Phase, also: &[Moment], see: &mut See) {
        for part in self.parts((to - from).abs() / GO, phase, also) {
            self.peg_in = from + (to - from) * part;
            see((phase, part), self);
        }
    }

    /// Where the wire leaves the pin when it is bent so far.
    fn leaves(&self, side: f64, bent: f64) -> Point3<f64> {
        let radius = self.machine.bend_radius.mm();
        let across = Rotation3::from_axis_angle(&Vector3::x_axis(), self.head) * Vector3::y() * side;
        Point3::from(Vector3::x() * (radius * bent.sin()) + across * (radius * (1.0 - bent.cos())))
    }

    /// Turns the rigid wire about where it leaves the pin.
    fn turn(&mut self, side: f64, bent: f64, by: f64) {
        let axis = Rotation3::from_axis_angle(&Vector3::x_axis(), self.head) * Vector3::z();
        let turn = UnitQuaternion::from_axis_angle(&Unit::new_normalize(axis), side * by);
        let about = self.leaves(side, bent);
        self.place(&(Translation3::from(about.coords) * turn * Translation3::from(-about.coords)));
    }

    fn place(&mut self, by: &Isometry3<f64>) {
        self.wire = by * self.wire;
        for piece in &mut self.pieces {
            piece.ends = piece.ends.map(|end| by * end);
        }
    }

    /// The arc that is wound around the pin belongs to the rigid wire from now on.
    fn wound(&mut self, side: f64, size: f64) {
        let arc = self.machine.bend_radius.mm() * size;
        let points: Vec<(Point3<f64>, f64)> = parts(size / CHORD, Phase::Feed, &[])
            .into_iter()
            .map(|part| (self.leaves(side, size * (1.0 - part)), self.out + arc * part))
            .collect();
        for pair in points.windows(2) {
            self.pieces.push(Piece { ends: [pair[0].0, pair[1].0], along: [pair[0].1, pair[1].1] });
        }
        self.out += arc;
    }

    /// Forgets the wire that is bent, of which only the corners stay known.
    pub fn forget(&mut self) {
        self.pieces.clear();
    }

    /// From the frame of the wire's start to that of the machine.
    #[must_use]
    pub const fn wire(&self) -> &Isometry3<f64> {
        &self.wire
    }

    /// Where the wire has its corners, and its ends, as seen from its start.
    pub fn corners(&self) -> impl Iterator<Item = &Point3<f64>> {
        self.corners.iter()
    }

    /// Where a body is.
    #[must_use]
    pub fn placed(&self, body: &Body) -> Isometry3<f64> {
        let head = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), self.head);
        let pivot = self.machine.bodies.pivot.mm();
        let axis = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), self.axis);
        let about_pivot =
            Translation3::new(pivot, 0.0, 0.0) * axis * Translation3::new(-pivot, 0.0, -self.peg_in);
        match body.moves_with {
            MovesWith::Frame => body.at,
            MovesWith::Head => head * body.at,
            MovesWith::Peg => head * about_pivot * body.at,
        }
    }
}

/// 0 to 1 in so many parts, and what has to be seen besides.
fn parts(count: f64, phase: Phase, also: &[Moment]) -> Vec<f64> {
    let count = count.ceil();
    let next = |k: &f64| (*k < count).then_some(k + 1.0);
    let share = |k: f64| if count > 0.0 { k / count } else { 1.0 };
    let mut all: Vec<f64> = std::iter::successors(Some(0.0), next).map(share).collect();
    all.extend(
        also.iter().filter(|(of, part)| *of == phase && (0.0..=1.0).contains(part)).map(|(_, part)| *part),
    );
    all.sort_by(f64::total_cmp);
    all
}

/// How much wire a program feeds, mm.
fn fed(machine: &Machine, steps: &[Step]) -> f64 {
    let radius = machine.bend_radius.mm();
    let rounded = |step: &Step| {
        let size = step.bend.abs().rad();
        2.0 * radius * (size / 2.0).tan() - radius * size
    };
    steps.iter().map(|step| step.feed.mm() - rounded(step)).sum()
}
