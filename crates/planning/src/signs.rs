//! Between canonical signs and those of a machine, both ways. Nowhere else are they applied.

use wirebend_core::bend::{Convention, Sign, Step};
use wirebend_core::compensate::{Compensation, ToldStep, approaches};
use wirebend_core::units::Angle;
use wirebend_driver_host::api::{self, Axis, Motion};
use wirebend_driver_host::jobs::Part;
use wirebend_profile::MachineFigures;

use crate::report::{JobStep, PartOfStep};

/// The signs of a machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Signs(Convention);

impl Signs {
    /// Of a machine's profile.
    pub fn of(figures: &MachineFigures) -> Self {
        let sign = |factor: f64| if factor < 0.0 { Sign::Opposite } else { Sign::Same };
        Self(Convention { bend: sign(figures.bend_sign), rotate: sign(figures.rotate_sign) })
    }

    /// The steps of a compensated program as the machine counts them.
    pub fn machine_steps(self, told: &[ToldStep], compensation: &Compensation) -> Vec<api::Step> {
        let step = |(told, approach): (&ToldStep, Option<Angle>)| api::Step {
            approach_deg: approach.map(|at| at.deg() * factor(self.0.bend)),
            ..self.machine(told.step)
        };
        told.iter().zip(approaches(told, compensation)).map(step).collect()
    }

    /// A step of a program as the machine counts it.
    pub fn machine(self, step: Step) -> api::Step {
        let Step { feed, rotate, bend } = self.0.apply(step);
        api::Step { feed_mm: feed.mm(), rotate_deg: rotate.deg(), bend_deg: bend.deg(), approach_deg: None }
    }

    /// A move of one axis, in mm or degrees, as the machine counts it.
    pub fn motion(self, axis: Axis, by: f64) -> Motion {
        let factor = match axis {
            Axis::Feed => 1.0,
            Axis::Rotate => factor(self.0.rotate),
            Axis::Bend => factor(self.0.bend),
        };
        Motion::new(axis, by * factor)
    }

    /// What the machine says of its axes.
    pub fn canonical(self, step: api::Step) -> JobStep {
        JobStep {
            feed_mm: step.feed_mm,
            rotate_deg: step.rotate_deg * factor(self.0.rotate),
            bend_deg: step.bend_deg * factor(self.0.bend),
            approach_deg: None,
        }
    }

    /// How much of a step is in the wire, as the machine counts it.
    pub fn part(self, part: Part) -> PartOfStep {
        PartOfStep { feed_mm: part.feed_mm, rotate_deg: self.head(part.rotate_deg) }
    }

    /// How much of a step is in the wire as a person says it, as the machine counts it.
    pub fn told_part(self, part: PartOfStep) -> Part {
        Part { feed_mm: part.feed_mm, rotate_deg: self.head(part.rotate_deg) }
    }

    /// How far a head is turned, from canonical signs to the machine's or back.
    pub fn head(self, deg: f64) -> f64 {
        deg * factor(self.0.rotate)
    }

    /// A place on a wire that was bent with the machine's signs, in the frame of the turtle that starts it.
    ///
    /// To bend the other way alone is to begin with half a turn about the wire; to rotate the other way alone
    /// makes the mirror image.
    pub fn made(self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let (bend, rotate) = (factor(self.0.bend), factor(self.0.rotate));
        [x, y * bend, z * bend * rotate]
    }
}

const fn factor(sign: Sign) -> f64 {
    match sign {
        Sign::Same => 1.0,
        Sign::Opposite => -1.0,
    }
}

#[cfg(test)]
mod tests {
    use wirebend_core::compensate::{BendModel, PegGeometry};
    use wirebend_core::units::{Angle, Length};

    use super::*;

    /// A turtle of its own: x along the wire, then the machine's steps in the machine's signs.
    fn end_of(steps: &[api::Step]) -> [f64; 3] {
        use nalgebra::{Rotation3, Vector3};
        let (mut at, mut frame) = (Vector3::zeros(), Rotation3::identity());
        for step in steps {
            at += frame * Vector3::x() * step.feed_mm;
            let rotate = Rotation3::from_axis_angle(&Vector3::x_axis(), step.rotate_deg.to_radians());
            let bend = Rotation3::from_axis_angle(&Vector3::z_axis(), step.bend_deg.to_radians());
            frame = frame * rotate * bend;
        }
        at.into()
    }

    /// Were a sign wrong here, the peg would come out on the side to which it bends.
    #[test]
    fn the_peg_comes_out_on_the_other_side_of_zero_whatever_the_signs() {
        let mm = |mm| Length::from_mm(mm).unwrap();
        let deg = |deg| Angle::from_deg(deg).unwrap();
        let peg = PegGeometry::new(mm(20.4), mm(12.0), mm(3.0), mm(4.675)).unwrap();
        let bend = BendModel { setback: Some(peg), ..BendModel::default() };
        let compensation = Compensation { bend, ..Compensation::default() };
        for side in [1.0, -1.0] {
            let step = |feed, bend| Step { feed: mm(feed), rotate: deg(0.0), bend: deg(side * bend) };
            let told = [step(80.0, 40.0), step(25.0, -40.0), step(30.0, 0.0)].map(ToldStep::from);
            for sign in [Sign::Same, Sign::Opposite] {
                let signs = Signs(Convention { bend: sign, rotate: Sign::Same });
                let steps = signs.machine_steps(&told, &compensation);
                assert!(steps[0].approach_deg.is_none() && steps[2].approach_deg.is_none(), "{steps:?}");
                let approach = steps[1].approach_deg.expect("wire is bent towards it");
                assert!(approach * steps[1].bend_deg < 0.0, "{steps:?}");
                // Where the axis stops before zero it is on the side of the axis.
                let before_zero = ToldStep { step: step(80.0, -5.0), approach: Some(deg(-18.25 * side)) };
                let steps = signs.machine_steps(&[before_zero], &compensation);
                let approach = steps[0].approach_deg.expect("it tells the side");
                assert!(approach * steps[0].bend_deg > 0.0, "{steps:?}");
            }
        }
    }

    /// Were a sign wrong here, a simulated machine's wire would be compared with its mirror image.
    #[test]
    fn a_wire_of_a_machine_with_other_signs_is_the_same_wire() {
        let step = |feed_mm: f64, rotate: f64, bend: f64| Step {
            feed: Length::from_mm(feed_mm).unwrap(),
            rotate: Angle::from_deg(rotate).unwrap(),
            bend: Angle::from_deg(bend).unwrap(),
        };
        let program =
            [step(30.0, 0.0, 40.0), step(20.0, 70.0, -55.0), step(25.0, -20.0, 90.0), step(10.0, 0.0, 0.0)];
        let same = Signs(Convention { bend: Sign::Same, rotate: Sign::Same });
        let expected = end_of(&program.map(|step| same.machine(step)));
        for bend in [Sign::Same, Sign::Opposite] {
            for rotate in [Sign::Same, Sign::Opposite] {
                let signs = Signs(Convention { bend, rotate });
                let found = signs.made(end_of(&program.map(|step| signs.machine(step))));
                let off: f64 = expected.iter().zip(found).map(|(a, b)| (a - b).abs()).sum();
                assert!(off < 1e-9, "{signs:?}: {found:?} instead of {expected:?}");
            }
        }
    }
}
