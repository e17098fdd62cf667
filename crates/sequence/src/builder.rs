//! The machine that places struts, as far as a sequence has to know it.

use nalgebra::{Point3, UnitVector3, Vector3};
use wirebend_collide::{DirectionSet, Head};
use wirebend_core::units::{Angle, Length};

/// A head that places struts, and what it has to keep to.
#[derive(Debug, Clone, PartialEq)]
pub struct StrutBuilder {
    /// Its shape from the tip.
    pub head: Head,
    /// Whether it places every strut whole, as wires and rods are, and stands at its joints alone; else it draws a strut that is alone
    /// from one end to the other.
    pub places: bool,
    /// In which directions its axis can stand, from the tip into the head.
    pub directions: HeadDirections,
    /// The angle between its axis and its way stays below this while it draws a strut into the open.
    pub max_create: Angle,
    /// The same while it draws one between two nodes that are built.
    pub max_connect: Angle,
    /// How deep a strut may be in the head where both share a node: what the machine cannot tell from a touch.
    pub touch: Length,
    /// How far its surface stays from the surface of any other strut.
    pub clearance: Length,
    /// Whether struts on the ground come before all others.
    pub ground_first: bool,
    /// A joint may be this far from where it is drawn, or the next strut misses it.
    pub max_sag: Length,
    /// The lowest and the highest corner of the box that its tip stays in, where it has one.
    pub workspace: Option<[Point3<f64>; 2]>,
    /// How fast it draws a strut and how fast it travels, mm/s, and how long it stays at a joint, s.
    pub pace: Pace,
}

impl StrutBuilder {
    /// Whether so many struts at once are placed whole: a wire or rod always is, a strut that is alone where nothing is drawn.
    #[must_use]
    pub const fn is_placed(&self, struts: usize) -> bool {
        self.places || struts > 1
    }

    /// Whether its tip gets to a point.
    #[must_use]
    pub fn reaches(&self, at: &Point3<f64>) -> bool {
        self.workspace.is_none_or(|[low, high]| *at >= low && *at <= high)
    }
}

/// How long the work of a strut builder takes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pace {
    /// While it draws a strut, mm/s.
    pub build_mm_s: f64,
    /// Between struts, mm/s.
    pub travel_mm_s: f64,
    /// At each end of a strut, s.
    pub pause_s: f64,
}

/// Directions evenly about z: both poles, and rings between them.
#[derive(Debug, Clone, PartialEq)]
pub struct HeadDirections(Vec<UnitVector3<f64>>);

/// A step that gives no directions.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("a step of {step} does not part 180°, or gives more than {} directions", DirectionSet::CAPACITY)]
pub struct DirectionStepError {
    /// The step.
    pub step: Angle,
}

impl HeadDirections {
    /// Both poles and a ring after each step between them, with a direction each step around.
    ///
    /// ```
    /// use wirebend_sequence::HeadDirections;
    /// use wirebend_core::units::Angle;
    /// let directions = HeadDirections::each(Angle::from_deg(18.0)?)?;
    /// assert_eq!(directions.all().len(), 182); // 2 + 9 · 20, as FrameFab has them
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`DirectionStepError`] where the step is no whole part of 180°, or too small.
    pub fn each(step: Angle) -> Result<Self, DirectionStepError> {
        let refused = DirectionStepError { step };
        let rings = (180.0 / step.deg()).round();
        let fits = (2.0..=20.0).contains(&rings) && (rings * step.deg() - 180.0).abs() < 1e-6;
        if !fits {
            return Err(refused);
        }
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // between 2 and 20
        let rings = rings as u32;
        let mut directions = vec![Vector3::z_axis()];
        for ring in 1..rings {
            for k in 0..2 * rings {
                let (polar, around) = (f64::from(ring) * step.rad(), f64::from(k) * step.rad());
                let flat = Vector3::new(around.cos(), around.sin(), 0.0) * polar.sin();
                directions.push(UnitVector3::new_normalize(flat + Vector3::z() * polar.cos()));
            }
        }
        directions.push(-Vector3::z_axis());
        if directions.len() > DirectionSet::CAPACITY { Err(refused) } else { Ok(Self(directions)) }
    }

    /// All of them: upwards first, then ring by ring.
    #[must_use]
    pub fn all(&self) -> &[UnitVector3<f64>] {
        &self.0
    }

    /// Those whose angle with a way is below one.
    #[must_use]
    pub fn within(&self, max: Angle, way: &Vector3<f64>) -> DirectionSet {
        // A direction that is just at the limit is over it, however it is rounded.
        let least = way.norm() * (max.rad().cos() + 1e-9);
        (0..self.0.len()).filter(|&k| self.0[k].dot(way) > least).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_step_that_does_not_go_into_half_a_turn_is_refused() {
        for deg in [0.0, -18.0, 17.0, 100.0, 180.0, 9.0, 15.0] {
            let step = Angle::from_deg(deg).unwrap();
            assert_eq!(HeadDirections::each(step), Err(DirectionStepError { step }));
        }
        assert_eq!(HeadDirections::each(Angle::from_deg(20.0).unwrap()).unwrap().all().len(), 146);
    }

    #[test]
    fn an_angle_at_the_limit_is_over_it() {
        let directions = HeadDirections::each(Angle::from_deg(18.0).unwrap()).unwrap();
        let within =
            |deg: f64| directions.within(Angle::from_deg(deg).unwrap(), &Vector3::new(0.0, 0.0, 7.0));
        assert_eq!([within(18.0).len(), within(18.1).len(), within(60.0).len()], [1, 21, 61]);
        // Half of the sphere but for the ring across.
        assert_eq!(within(90.0).len(), 81);
    }
}
