//! Where a program sends the head.

use super::Machine;
use crate::compensate::CompensatedProgram;
use crate::schedule::{HeadLimits, RotationOutOfRange};
use crate::units::Angle;

/// The first step for which a head that is off is sent farther than it can turn.
pub(super) fn commanded_beyond(
    program: &CompensatedProgram,
    machine: &Machine,
) -> Option<RotationOutOfRange> {
    if machine.compensation.motion.is_exact() {
        return None;
    }
    sent_beyond(program, machine, Angle::computed(1e-9))
}

/// The first step for which the head is sent farther than it can turn, but for rounding.
pub(super) fn sent_beyond(
    program: &CompensatedProgram,
    machine: &Machine,
    rounding: Angle,
) -> Option<RotationOutOfRange> {
    let HeadLimits { min, max, .. } = machine.head;
    let sent = program.steps().iter().scan(Angle::ZERO, |at, step| {
        *at += step.rotate;
        Some(*at)
    });
    let beyond = |at: &Angle| *at < min - rounding || *at > max + rounding;
    let (step, wanted) = sent.enumerate().find(|(_, at)| beyond(at))?;
    Some(RotationOutOfRange { step, wanted, commanded: true, min, max })
}
