//! Coupons by commands that the machine can be sent as they are: what a driver rounds, and carries over to the next step, would be
//! fitted as if it were springback and setback of the machine.

use wirebend_core::bend::Step;
use wirebend_core::compensate::{CompensatedProgram, ToldStep};
use wirebend_core::units::Angle;

use crate::PlanningError;
use crate::machine::{Setup, deg, mm};

/// What is rounded more finely than this shows in no reading, mm or degrees: a caliper on bent wire shows a tenth of a millimetre, a
/// protractor half a degree.
const SHOWS: f64 = 0.05;

/// The commands of a coupon in whole steps of axes whose steps are so coarse that readings show them.
pub(super) fn rounded(
    commanded: CompensatedProgram,
    setup: &Setup,
) -> Result<CompensatedProgram, PlanningError> {
    let machine = setup.machine.figures()?;
    let [feed, rotate, bend] =
        [machine.feed_resolution_mm, machine.rotate_resolution_deg, machine.bend_resolution_deg]
            .map(|step| Some(step).filter(|step| *step > SHOWS));
    if [feed, rotate, bend].iter().all(Option::is_none) {
        return Ok(commanded);
    }
    let compensation = &setup.model.compensation;
    let least_feed = setup.model.limits.min_feed.value.mm();
    let most_bend = compensation.bend.axis_limit.map_or(f64::INFINITY, Angle::deg);
    let told = |told: ToldStep| {
        let step = Step {
            feed: mm(whole(told.step.feed.mm(), feed, (least_feed, f64::INFINITY)))?,
            rotate: deg(whole(told.step.rotate.deg(), rotate, (0.0, f64::INFINITY)))?,
            bend: deg(whole(told.step.bend.deg(), bend, (0.0, most_bend)))?,
        };
        Ok::<_, PlanningError>(ToldStep { step, ..told })
    };
    let told = commanded.told().map(told).collect::<Result<Vec<_>, _>>()?;
    Ok(CompensatedProgram::from_job_steps(told, compensation))
}

/// A value in whole steps, its size between two others as far as steps allow. What is not zero stays so.
fn whole(value: f64, step: Option<f64>, (least, most): (f64, f64)) -> f64 {
    let Some(step) = step.filter(|_| value != 0.0) else { return value };
    let size = (value.abs() / step).round().max(1.0);
    let size = if size * step < least { size + 1.0 } else { size };
    let size = if size * step > most { size - 1.0 } else { size };
    value.signum() * size * step
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_becomes_whole_steps_within_its_bounds() {
        let none = (0.0, f64::INFINITY);
        for (value, step, bounds, expected) in [
            (21.8278, Some(1.0), none, 22.0),
            (-82.4811, Some(1.0), none, -82.0),
            (0.3, Some(1.0), none, 1.0),
            (0.0, Some(1.0), none, 0.0),
            (18.6657, None, none, 18.6657),
            (18.66, Some(0.1), none, 18.7),
            (20.2, Some(1.0), (20.1, 30.0), 21.0),
            (-129.7, Some(1.0), (0.0, 129.8), -129.0),
        ] {
            assert!((whole(value, step, bounds) - expected).abs() < 1e-9, "{value}");
        }
    }
}
