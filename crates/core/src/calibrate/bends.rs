//! Springback and the dimensions of the bend head, from bends that the axis was sent to known positions for.

use super::CalibrationError;
use super::assumed::{Assumed, KnownLength, PegDimensions, bend_model};
use super::estimate::{Fit, Misfit, Parameter};
use super::figure::Figure;
use super::fitting::{Search, hold};
use super::least_squares::{Belief, Solution};
use super::measured::{AngleSample, Gap, Kind, LeftOut};
use super::screen::{ReadAs, Screened, bend, screen};
use super::springback::{CURVE_NEEDS, Form, Knots, ShapeChoice, SpringbackShape};
use super::statistics::median;
use crate::compensate::{BendModel, PegGeometry, Springback, SpringbackPoint};
use crate::units::{Angle, Length};

/// How far off a loss may be that nothing tells, in degrees.
const LOSS_DEVIATION_DEG: f64 = 30.0;
/// And a loss that a profile states: the published ones scatter by so much from angle to angle (Faruqi et al., SCF '25).
const STATED_LOSS_DEVIATION_DEG: f64 = 1.63;

/// The dimensions of a bend head as they were found. Only their ratios to one another show in bends: the radius of the
/// orbit sets the scale, and stays nearly what it was taken to be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FittedPeg {
    /// Radius R of the orbit.
    pub orbit_radius: Length,
    /// Offset s of its centre.
    pub orbit_offset: Length,
    /// Centreline radius of a bend.
    pub bend_radius: Length,
    /// Effective radius of the peg.
    pub peg_radius: Length,
}

/// What bends tell.
#[derive(Debug, Clone, PartialEq)]
pub struct BendFit {
    /// The parameters and how well they fit.
    pub fit: Fit,
    /// The shape of the springback that was chosen.
    pub shape: SpringbackShape,
    /// The other shape and its error by leave-one-out, where the readings allow it.
    pub other: Option<(SpringbackShape, Misfit)>,
    /// What the wire loses.
    pub springback: Springback,
    /// For a springback that depends on the angle: pairs of each side, for a profile.
    pub pairs: Option<[Vec<SpringbackPoint>; 2]>,
    /// The bend head; none where the axis is the bend.
    pub peg: Option<FittedPeg>,
    /// The bend radius with its deviation, for what follows from it.
    pub(super) bend_radius: KnownLength,
    /// How far off bends beside the sides may be, degrees.
    pub(super) deviation_beside_deg: f64,
}

/// The bends beside the sides that are measured, as far as they are known by now.
pub(super) struct KnownBends {
    pub model: BendModel,
    pub radius: KnownLength,
    /// How far off they may be, all alike: a standard deviation, degrees.
    pub deviation_deg: f64,
}

/// Bends that nobody has measured, with the axis at each of `beside`.
pub(super) fn believed(assumed: &Assumed, beside: &[Angle]) -> Result<KnownBends, CalibrationError> {
    let model = assumed.bend_model()?;
    let told = told_beyond_zero(beside);
    let side = Side { assumed, before: &model, told: &told, held: &[] };
    let form = Form::Constant;
    let predict = side.predict(&form);
    let mut search = side.search(&form, &predict);
    if let Some((_, loss)) = search.parameters.last_mut() {
        loss.sd = STATED_LOSS_DEVIATION_DEG;
    }
    let before: Vec<f64> = search.parameters.iter().map(|(_, belief)| belief.value).collect();
    let slopes = search.problem(&Screened::default()).slopes_at(&before);
    let deviation_deg = slopes.row_iter().map(|slope| slope.norm()).fold(0.0, f64::max);
    drop(search);
    Ok(KnownBends { model: model.clone(), radius: assumed.bend_radius, deviation_deg })
}

fn told_beyond_zero(axes: &[Angle]) -> Vec<Told> {
    axes.iter().map(|&axis| Told { axis, side: axis.signum() }).collect()
}

impl BendFit {
    /// The model that compensates by what was found; `axis_limit` as before.
    #[must_use]
    pub fn model(&self, axis_limit: Option<Angle>) -> BendModel {
        let setback = self.peg.and_then(|peg| {
            PegGeometry::new(peg.orbit_radius, peg.orbit_offset, peg.bend_radius, peg.peg_radius).ok()
        });
        BendModel { springback: Some(self.springback.clone()), setback, axis_limit, before_zero: false }
    }
}

/// A kind of readings fitted, with what was left out and what is missing.
pub(super) struct Outcome<T> {
    pub fit: Option<T>,
    pub left_out: Vec<LeftOut>,
    pub gaps: Vec<Gap>,
}

/// Readings from which on their median says something.
const SEVERAL: usize = 5;
/// Readings of another kind differ from what is expected of that kind by so much less than from the bends that are expected.
const OTHER_SPREADS: f64 = 0.2;

/// What is expected of each sample, less what the readings lose in the median: a wire whose springback is far from what was taken
/// has all of them off alike, and a reading that is off by as much is no slip. And what all readings are.
fn as_the_table_has_it(samples: &[AngleSample], expected: &[Angle]) -> (Vec<Angle>, ReadAs) {
    let pairs = || {
        samples.iter().zip(expected).flat_map(|(sample, expected)| {
            let readings = sample.readings.iter().flatten();
            readings.map(|reading| [reading.abs().deg(), expected.abs().deg()])
        })
    };
    let off = |read_as: fn(f64) -> f64| -> Vec<f64> {
        let off = pairs().map(|[read, expected]| read_as(read) - expected);
        off.filter(|off| off.abs() < 180.0).collect()
    };
    let bends = off(|read| read);
    if bends.len() < SEVERAL {
        return (expected.to_vec(), ReadAs::Bends);
    }
    let spread = |off: &[f64]| {
        let middle = median(off.to_vec());
        median(off.iter().map(|off| (off - middle).abs()).collect())
    };
    let others = [(ReadAs::InnerAngles, off(|read| 180.0 - read)), (ReadAs::Radians, off(f64::to_degrees))];
    let is_other = |off: &[f64]| off.len() >= SEVERAL && spread(off) < OTHER_SPREADS * spread(&bends);
    let other = others.into_iter().find(|(_, off)| is_other(off));
    let (read_as, off) = other.unwrap_or((ReadAs::Bends, bends));
    let off = median(off).to_radians();
    let shifted = |angle: &Angle| Angle::computed(angle.signum() * (angle.abs().rad() + off).max(0.0));
    (expected.iter().map(shifted).collect(), read_as)
}

/// Fits bends. `beside`: positions of the axis for the bends beside the sides that are measured. `held`: what stays as it was.
pub(super) fn fit(
    assumed: &Assumed,
    samples: &[AngleSample],
    choice: ShapeChoice,
    (beside, held): (&[Angle], &[Parameter]),
) -> Result<Outcome<BendFit>, CalibrationError> {
    let before = assumed.bend_model()?;
    let expected: Vec<Angle> =
        samples.iter().map(|sample| before.result_to(sample.side, sample.axis)).collect();
    let (likely, read_as) = as_the_table_has_it(samples, &expected);
    let readings: Vec<&[Option<Angle>]> = samples.iter().map(|sample| sample.readings.as_slice()).collect();
    let mut screened = screen(
        Kind::Bends,
        &readings,
        Figure::Angle,
        |k| Figure::Angle(expected[k]),
        |k, reading| bend(&samples[k], assumed.axis_limit, (likely[k], read_as), reading),
    );
    let none = |screened: Screened, given| Outcome {
        fit: None,
        left_out: screened.left_out,
        gaps: vec![Gap::NoReadings { kind: Kind::Bends, given }],
    };
    let given = screened.given;
    if screened.data.is_empty() {
        return Ok(none(screened, given));
    }
    let told: Vec<Told> =
        screened.samples.iter().map(|&k| Told { axis: samples[k].axis, side: samples[k].side }).collect();
    let expected: Vec<f64> = screened.samples.iter().map(|&k| expected[k].deg()).collect();
    let commanded = |k: usize| Figure::Angle(told[k].axis);
    let no_solution = |_| CalibrationError::NoSolution { kind: Kind::Bends };
    let side = Side { assumed, before: &before, told: &told, held };

    let before_moved = Form::moved(before.springback.as_ref());
    let most = match choice {
        ShapeChoice::Fixed(SpringbackShape::Constant) => Form::Constant,
        ShapeChoice::Fixed(SpringbackShape::Moved) => before_moved.clone(),
        _ => Knots::over(&expected).map_or_else(|| before_moved.clone(), Form::Cubic),
    };
    side.search(&most, &side.predict(&most))
        .take_out_wild(Kind::Bends, &mut screened)
        .map_err(no_solution)?;

    let cubic = Knots::over(&side.formed(&screened)).map(Form::Cubic);
    let too_few = choice == ShapeChoice::Fixed(SpringbackShape::Cubic) && cubic.is_none();
    let forms = match choice {
        ShapeChoice::Fixed(SpringbackShape::Constant) => vec![Form::Constant],
        ShapeChoice::Fixed(SpringbackShape::Moved) => vec![before_moved],
        ShapeChoice::Fixed(SpringbackShape::Cubic) if !too_few => cubic.into_iter().collect(),
        _ => match cubic {
            Some(cubic) => vec![Form::Constant, cubic],
            None => vec![before_moved],
        },
    };
    let mut fitted = Vec::new();
    for form in forms {
        let (fit, solution) = {
            let predict = side.predict(&form);
            let search = side.search(&form, &predict);
            search.fit(Kind::Bends, &screened, &commanded, &expected).map_err(no_solution)?
        };
        fitted.push((form, fit, solution));
    }
    // A constant is kept where a curve predicts no better what it has not seen.
    fitted.sort_by(|a, b| a.1.leave_one_out.rms.total_cmp(&b.1.leave_one_out.rms));
    let mut fitted = fitted.into_iter();
    let Some((form, fit, solution)) = fitted.next() else { return Ok(none(screened, given)) };
    let other = fitted.next().map(|(form, fit, _)| (form.shape(), fit.leave_one_out));
    let mut gaps = side.gaps(&screened);
    if assumed.springback.is_none() {
        gaps.push(Gap::SpringbackLeft);
    }
    if too_few {
        gaps.push(Gap::FewAngles { needed: CURVE_NEEDS });
    }
    let mut fit = side.found(&form, fit, &solution, other);
    fit.deviation_beside_deg = side.deviation(&form, &solution, &told_beyond_zero(beside));
    Ok(Outcome { fit: Some(fit), left_out: screened.left_out, gaps })
}

/// Where the axis went, and to which side it bent.
#[derive(Debug, Clone, Copy)]
struct Told {
    axis: Angle,
    side: f64,
}

/// The bends that were commanded, and the machine that made them.
struct Side<'a> {
    assumed: &'a Assumed,
    before: &'a BendModel,
    told: &'a [Told],
    /// What stays as it was.
    held: &'a [Parameter],
}

impl Side<'_> {
    /// Bends in degrees from the dimensions of the head, where it has a peg, and the losses.
    fn predict(&self, form: &Form) -> impl Fn(&[f64]) -> Vec<f64> {
        let dimensions = if self.assumed.peg.is_some() { 4 } else { 0 };
        move |parameters| {
            let (peg, losses) = parameters.split_at(dimensions.min(parameters.len()));
            let peg = PegDimensions::try_from(peg).ok();
            let model = bend_model(peg, form.springback(losses));
            self.told.iter().map(|told| model.result_to(told.side, told.axis).deg()).collect()
        }
    }

    fn search<'s>(&self, form: &Form, predict: &'s dyn Fn(&[f64]) -> Vec<f64>) -> Search<'s> {
        let known =
            |known: KnownLength| Belief { value: known.value.mm(), sd: known.deviation.mm().max(1e-3) };
        let mut parameters = Vec::new();
        if let Some(peg) = &self.assumed.peg {
            parameters.extend([
                (Parameter::OrbitRadius, known(peg.orbit_radius)),
                (Parameter::OrbitOffset, known(peg.orbit_offset)),
                (Parameter::BendRadius, known(self.assumed.bend_radius)),
                (Parameter::PegRadius, known(peg.peg_radius)),
            ]);
        }
        let loss = |formed: f64| {
            let formed = Angle::computed(formed.to_radians());
            let bent = self.before.springback.as_ref().map_or(formed, |model| model.bend_to(formed));
            Belief { value: (bent.abs() - formed.abs()).deg(), sd: LOSS_DEVIATION_DEG }
        };
        let at = |formed: f64| Parameter::SpringbackAt(Angle::computed(formed.to_radians()));
        match form {
            Form::Constant => parameters.push((Parameter::Springback, loss(90.0))),
            Form::Moved(_) => {
                let belief = Belief { value: 0.0, sd: LOSS_DEVIATION_DEG };
                parameters.push((Parameter::SpringbackShift, belief));
            }
            Form::Cubic(Knots { positive, negative }) => {
                let signed = positive.iter().copied().chain(negative.iter().map(|knot| -knot));
                parameters.extend(signed.map(|formed| (at(formed), loss(formed))));
            }
        }
        let parameters = hold(parameters, self.held);
        Search { parameters, unstated: Vec::new(), predict, reading: self.assumed.angle_reading.deg() }
    }

    /// How far off the fitted bends of other commands may be: the largest standard deviation, degrees.
    fn deviation(&self, form: &Form, solution: &Solution, told: &[Told]) -> f64 {
        let other = Side { told, ..*self };
        let predict = other.predict(form);
        let problem = other.search(form, &predict);
        let slopes = problem.problem(&Screened::default()).slopes_at(&solution.parameters);
        slopes.row_iter().map(|slope| solution.deviation_along(&slope.transpose())).fold(0.0, f64::max)
    }

    /// The bend of each sample that has readings left: their median, in degrees.
    fn formed(&self, screened: &Screened) -> Vec<f64> {
        let of = |sample: usize| {
            screened.data.iter().filter(|datum| datum.sample == sample).map(|datum| datum.value).collect()
        };
        let medians = (0..self.told.len()).map(|sample| median(of(sample)));
        medians.filter(|angle| *angle != 0.0).collect()
    }

    fn gaps(&self, screened: &Screened) -> Vec<Gap> {
        let told = || screened.data.iter().map(|datum| self.told[datum.sample]);
        let mut axes: Vec<Angle> = told().map(|told| told.axis).collect();
        axes.sort();
        axes.dedup_by(|next, before| (*next - *before).abs().deg() < 0.05);
        let mut gaps = Vec::new();
        if let [axis] = axes[..] {
            gaps.push(Gap::OneAngle { axis });
        }
        for missing in [1.0, -1.0] {
            if told().all(|told| told.side * missing < 0.0) {
                gaps.push(Gap::OneSide { missing });
            }
        }
        gaps
    }

    fn found(
        &self,
        form: &Form,
        fit: Fit,
        solution: &Solution,
        other: Option<(SpringbackShape, Misfit)>,
    ) -> BendFit {
        let parameters = &solution.parameters;
        let losses = &parameters[if self.assumed.peg.is_some() { 4 } else { 0 }..];
        let peg = self.assumed.peg.and(parameters.first_chunk::<4>()).map(|found| {
            let [orbit_radius, orbit_offset, bend_radius, peg_radius] = found.map(Length::computed);
            FittedPeg { orbit_radius, orbit_offset, bend_radius, peg_radius }
        });
        let radius = self.assumed.bend_radius;
        let bend_radius = peg.map_or(radius, |peg| KnownLength {
            value: peg.bend_radius,
            deviation: Length::computed(solution.deviation(2, radius.deviation.mm())),
        });
        BendFit {
            fit,
            shape: form.shape(),
            other,
            springback: form.springback(losses),
            pairs: form.pairs(losses),
            peg,
            bend_radius,
            deviation_beside_deg: 0.0,
        }
    }
}
