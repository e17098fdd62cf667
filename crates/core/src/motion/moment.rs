//! When the parts of a step happen.

use crate::bend::Step;
use crate::estimate::StepSeconds;
use crate::units::Angle;

/// What a machine does in a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MachineStep {
    /// What it does to the wire.
    pub designed: Step,
    /// What it is told: its bend axis goes farther than the wire stays bent.
    pub told: Step,
    /// Where its bend axis stands when the peg comes out; none where it stays at zero for that.
    pub comes_out: Option<Angle>,
    /// How long the parts of it take.
    pub seconds: StepSeconds,
}

/// Where wire and machine are at one moment of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moment {
    /// The part of the step's time that has passed, from 0 to 1.
    pub at: f64,
    /// How much of the feed is through the bend point, from 0 to 1.
    pub fed: f64,
    /// How much of the bend is in the wire, from 0 to 1: it stays.
    pub bent: f64,
    /// How far the head has turned about +x of the machine, right-handed.
    pub head: Angle,
    /// How far the bend axis has turned about the head's z, right-handed: it goes there and comes back.
    pub bend_axis: Angle,
    /// Where the peg is along its own axis: at 0 it is in, so that the wire can pass it, at 1 it is out and bends.
    pub peg_out: f64,
}

/// The moments between which each step moves evenly: its beginning, the end of each of its parts, its end. The parts are
/// feed, rotate, the bend axis goes to where the peg comes out, the peg comes out, the bend axis goes there, it comes back, the peg
/// goes in. What takes no time comes as two moments at the same time.
///
/// A machine that waits for its peg at no bend leaves it out. Where a step has no times at all each part that moves takes
/// as long as the others.
#[must_use]
pub fn moments(steps: &[MachineStep]) -> Vec<Vec<Moment>> {
    let retracts = steps.iter().any(|step| step.seconds.wait > 0.0);
    let peg_at_rest = if retracts { 0.0 } else { 1.0 };
    let mut head = Angle::ZERO;
    let of_step = |step: &MachineStep| {
        let begin =
            Moment { at: 0.0, fed: 0.0, bent: 0.0, head, bend_axis: Angle::ZERO, peg_out: peg_at_rest };
        // Right-handed about the direction of travel, which is -x.
        head -= step.designed.rotate;
        moments_of(step, begin, head)
    };
    steps.iter().map(of_step).collect()
}

fn moments_of(step: &MachineStep, begin: Moment, head: Angle) -> Vec<Moment> {
    let StepSeconds { feed, rotate, bend, wait } = timed(step);
    let total = feed + rotate + bend + wait;
    let fed = Moment { fed: 1.0, ..begin };
    let rotated = Moment { head, ..fed };
    let beside = step.comes_out.filter(|_| wait > 0.0);
    let beside = Moment { bend_axis: beside.unwrap_or_default(), ..rotated };
    let out = Moment { peg_out: if wait > 0.0 { 1.0 } else { begin.peg_out }, ..beside };
    let bent = Moment { bent: 1.0, bend_axis: step.told.bend, ..out };
    // On its way to zero the peg would bend on a wire that is bent before zero: it backs off and goes in first.
    let before_zero = step.comes_out.filter(|at| wait > 0.0 && at.rad() * step.told.bend.rad() >= 0.0);
    let returned = Moment { bend_axis: before_zero.unwrap_or_default(), ..bent };
    let inside = Moment { peg_out: begin.peg_out, ..returned };
    let end = Moment { bend_axis: Angle::ZERO, ..inside };
    let parts = [
        (feed, fed),
        (rotate, rotated),
        (if beside == rotated { 0.0 } else { wait / 4.0 }, beside),
        (if beside == rotated { wait / 2.0 } else { wait / 4.0 }, out),
        (bend / 2.0, bent),
        (bend / 2.0, returned),
        (if end == inside { wait / 2.0 } else { wait / 4.0 }, inside),
        (if end == inside { 0.0 } else { wait / 4.0 }, end),
    ];
    let mut moments = vec![begin];
    let mut passed = 0.0;
    for (seconds, reached) in parts {
        passed += seconds;
        let at = if total > 0.0 { passed / total } else { 1.0 };
        let last = moments.last().copied().unwrap_or(begin);
        if seconds > 0.0 || (Moment { at: last.at, ..reached }) != last {
            moments.push(Moment { at, ..reached });
        }
    }
    if let Some(last) = moments.last_mut() {
        // Whatever rounding has left.
        last.at = 1.0;
    }
    moments
}

fn timed(step: &MachineStep) -> StepSeconds {
    let StepSeconds { feed, rotate, bend, wait } = step.seconds;
    let told = StepSeconds {
        feed: feed.max(0.0),
        rotate: rotate.max(0.0),
        bend: bend.max(0.0),
        wait: wait.max(0.0),
    };
    if told.total() > 0.0 {
        return told;
    }
    let one = |moves: bool| if moves { 1.0 } else { 0.0 };
    let Step { feed, rotate, bend } = step.designed;
    StepSeconds {
        feed: one(feed.mm() != 0.0),
        rotate: one(rotate != Angle::ZERO),
        bend: one(bend != Angle::ZERO || step.told.bend != Angle::ZERO),
        wait: 0.0,
    }
}
