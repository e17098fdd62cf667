//! What is said of the springback that a plan is compensated for.

use wirebend_core::compensate::{Springback, SpringbackCurve};
use wirebend_core::plan::WirePlan;
use wirebend_core::units::Angle;
use wirebend_error::ErrorRemedy;
use wirebend_files::number::short;

use crate::machine::Setup;
use crate::report::NoteReport;

/// A springback that was not measured is worth a test piece.
pub(super) fn estimated(setup: &Setup) -> Option<NoteReport> {
    let measured = match setup.material.profile.springback.as_ref()? {
        wirebend_profile::Springback::Constant { angle_deg } => angle_deg.measured,
        wirebend_profile::Springback::Table { measured, .. } => *measured,
    };
    let counts = setup.model.compensation.bend.springback.is_some() && !measured;
    counts.then(|| NoteReport {
        code: "springback-estimated".into(),
        count: 1,
        message: format!("the springback of {} is an estimate and was not measured", setup.material_id()),
        remedies: vec![ErrorRemedy::BendTestPiece],
    })
}

/// How finely bends are read: one that is beyond a measured pair by less is known as well as the pair.
const AS_READ_DEG: f64 = 0.5;

/// A springback that is taken from the nearest pair of its table is worth a test piece too.
pub(super) fn held(setup: &Setup, wires: &[WirePlan]) -> Option<NoteReport> {
    let Springback::Table { positive, negative } = setup.model.compensation.bend.springback.as_ref()? else {
        return None;
    };
    let scheduled = wires.iter().filter_map(|wire| wire.scheduled.as_ref());
    let bends = scheduled.flat_map(|program| &program.steps).map(|step| step.bend);
    beyond_pairs([positive, negative], bends)
}

/// The note of bends beyond the first or the last pair of their side, the positive one first.
fn beyond_pairs(curves: [&SpringbackCurve; 2], bends: impl Iterator<Item = Angle>) -> Option<NoteReport> {
    let ranges = curves.map(|curve| {
        let points = curve.points();
        [points.first(), points.last()].map(|point| point.map_or(0.0, |point| point.formed.deg()))
    });
    let is_beyond = |bend: &Angle| {
        let [first, last] = ranges[usize::from(*bend < Angle::ZERO)];
        let size = bend.abs().deg();
        size > 0.0 && (size < first - AS_READ_DEG || size > last + AS_READ_DEG)
    };
    let beyond: Vec<f64> = bends.filter(is_beyond).map(|bend| bend.abs().deg()).collect();
    let largest = short(beyond.iter().copied().reduce(f64::max)?, 1);
    let bends = match beyond.len() {
        1 => format!("1 bend of {largest}° is"),
        several => format!("{several} bends of up to {largest}° are"),
    };
    let [positive, negative] = ranges.map(|[first, last]| match [short(first, 1), short(last, 1)] {
        [first, last] if first == last => format!("at {first}°"),
        [first, last] => format!("from {first}° to {last}°"),
    });
    let known = if positive == negative {
        positive
    } else {
        format!("{positive} to the positive side and {negative} to the negative one")
    };
    Some(NoteReport {
        code: "springback-held".into(),
        count: beyond.len(),
        message: format!("{bends} beyond the springback that is known, {known}; it is held there"),
        remedies: vec![ErrorRemedy::BendTestPiece],
    })
}

#[cfg(test)]
mod tests {
    use wirebend_core::compensate::SpringbackPoint;

    use super::*;
    use crate::machine::deg;

    fn curve(pairs: &[[f64; 2]]) -> SpringbackCurve {
        let point = |&[formed, loss]: &[f64; 2]| SpringbackPoint {
            formed: deg(formed).unwrap(),
            loss: deg(loss).unwrap(),
        };
        SpringbackCurve::new(&pairs.iter().map(point).collect::<Vec<_>>()).unwrap()
    }

    fn said(curves: [&SpringbackCurve; 2], bends: &[f64]) -> Option<String> {
        let note = beyond_pairs(curves, bends.iter().map(|&bend| deg(bend).unwrap()))?;
        assert_eq!(note.remedies, [ErrorRemedy::BendTestPiece]);
        Some(note.message)
    }

    /// Beyond its pairs a table holds the loss of the nearest one: a bend of 149.5° then loses as much as one of 40°.
    #[test]
    fn bends_beyond_the_pairs_of_a_springback_are_told() {
        let known = curve(&[[20.0, 2.0], [40.0, 6.0]]);
        let both = [&known, &known];
        assert_eq!(
            said(both, &[59.5, 149.5, 30.0, 0.0]).unwrap(),
            "2 bends of up to 149.5° are beyond the springback that is known, from 20° to 40°; it is held there"
        );
        assert_eq!(
            said(both, &[-12.0]).unwrap(),
            "1 bend of 12° is beyond the springback that is known, from 20° to 40°; it is held there"
        );
        // Nobody reads a protractor more finely.
        assert_eq!(said(both, &[0.0, 20.0, -40.0, 40.4, 19.7]), None);
    }

    #[test]
    fn each_side_of_a_springback_is_known_as_far_as_its_own_pairs_go() {
        let (far, near) = (curve(&[[0.0, 1.5], [180.0, 3.0]]), curve(&[[90.0, 3.0]]));
        assert_eq!(said([&far, &near], &[1.0, 180.0, -90.0]), None);
        assert_eq!(
            said([&far, &near], &[120.0, -120.0]).unwrap(),
            "1 bend of 120° is beyond the springback that is known, from 0° to 180° to the positive side and at 90° to the \
             negative one; it is held there"
        );
    }
}
