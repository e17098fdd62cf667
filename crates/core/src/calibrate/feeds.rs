//! The feed's scale and the wire in a bend, from sides of U-shapes.

use super::CalibrationError;
use super::assumed::Assumed;
use super::bends::{KnownBends, Outcome};
use super::estimate::{Fit, Parameter};
use super::figure::Figure;
use super::fitting::{Search, hold};
use super::least_squares::{BELIEVED, Belief};
use super::measured::{Gap, Kind, LengthSample};
use super::screen::{screen, side};
use crate::compensate::{BendModel, FeedModel};
use crate::units::{Angle, Length};

/// How far off the scale of a feed may be: a drive wheel of 37.3 mm that is 0.75 mm larger or smaller.
const SCALE_DEVIATION: f64 = 0.02;

/// What sides tell.
#[derive(Debug, Clone, PartialEq)]
pub struct FeedFit {
    /// The parameters and how well they fit.
    pub fit: Fit,
    /// Wire that comes out for a commanded millimetre.
    pub scale: f64,
    /// Depth of the neutral fibre, in diameters.
    pub k_factor: f64,
    /// The feed model with these.
    pub model: FeedModel,
}

pub(super) fn fit(
    assumed: &Assumed,
    samples: &[LengthSample],
    known: &KnownBends,
    held: &[Parameter],
) -> Result<Outcome<FeedFit>, CalibrationError> {
    let KnownBends { model: bends, radius, .. } = known;
    // A slip shows beside the bends as they are known by now; what was to be expected before had those of before.
    let expected = sides_between(assumed, samples, bends, radius.value);
    let before = sides_between(assumed, samples, &assumed.bend_model()?, assumed.bend_radius.value);
    let readings: Vec<&[Option<Length>]> = samples.iter().map(|sample| sample.readings.as_slice()).collect();
    let mut screened = screen(
        Kind::Feeds,
        &readings,
        Figure::Length,
        |k| Figure::Length(expected[k]),
        |k, reading| side(expected[k], reading, assumed.diameter),
    );
    let given = screened.given;
    if screened.data.is_empty() {
        let gaps = vec![Gap::NoReadings { kind: Kind::Feeds, given }];
        return Ok(Outcome { fit: None, left_out: screened.left_out, gaps });
    }
    let used: Vec<&LengthSample> = screened.samples.iter().map(|&k| &samples[k]).collect();
    let made: Vec<[Angle; 2]> = used.iter().map(|sample| bends_beside(bends, sample)).collect();
    let before: Vec<f64> = screened.samples.iter().map(|&k| before[k].mm()).collect();
    let predict = |parameters: &[f64]| {
        let &[scale, k, radius, off_deg] = parameters else { return Vec::new() };
        let side = |(sample, made): (&&LengthSample, &[Angle; 2])| {
            let made = made.map(|bend| bend + Angle::computed(bend.signum() * off_deg.to_radians()));
            side_of(assumed, Length::computed(scale * sample.feed.mm()), made, [k, radius]).mm()
        };
        used.iter().zip(&made).map(side).collect()
    };
    let believed = vec![
        (Parameter::FeedScale, Belief { value: assumed.motion.feed_scale, sd: SCALE_DEVIATION }),
        (Parameter::KFactor, Belief { value: assumed.k_factor, sd: assumed.k_deviation.max(1e-3) }),
        (Parameter::BendRadius, Belief { value: radius.value.mm(), sd: radius.deviation.mm().max(1e-3) }),
    ];
    let search = Search {
        parameters: hold(believed, held),
        // Where bends are other than they are taken to be, sides are too: the corners lie elsewhere.
        unstated: vec![Belief { value: 0.0, sd: known.deviation_deg.max(1e-3) }],
        predict: &predict,
        reading: assumed.length_reading.mm(),
    };
    let no_solution = |_| CalibrationError::NoSolution { kind: Kind::Feeds };
    search.take_out_wild(Kind::Feeds, &mut screened).map_err(no_solution)?;
    let commanded = |k: usize| Figure::Length(used[k].feed);
    let (mut fit, solution) = search.fit(Kind::Feeds, &screened, &commanded, &before).map_err(no_solution)?;
    let mut gaps = Vec::new();
    let feed = |datum: &super::least_squares::Datum| used[datum.sample].feed;
    if !assumed.deducts_bends {
        gaps.push(Gap::DeductionLeft);
    } else if let Some(first) = screened.data.first().map(feed)
        && screened.data.iter().all(|datum| (feed(datum) - first).abs().mm() < 0.05)
    {
        gaps.push(Gap::OneLength { feed: first });
    }
    let fit = solution.parameters.first_chunk::<4>().map(|&[scale, k, fitted, off_deg]| {
        // Sides hardly tell the radius from K: K is stated for the radius that is stated with it. Sides are linear in both.
        let all = |k: f64, radius: f64| predict(&[scale, k, radius, off_deg]).iter().sum::<f64>();
        let before = radius.value.mm();
        let slope = all(k + 1.0, before) - all(k, before);
        // Without a bend there is no K.
        let k_of_radius =
            if slope.abs() < 1e-9 { 0.0 } else { (all(k, before + 1.0) - all(k, before)) / slope };
        let k_factor = k + k_of_radius * (fitted - before);
        // What the sides tell of the radius is given up, so that it is as uncertain as before, and K as much more as it went along.
        let sd = radius.deviation.mm().max(1e-3);
        let given_up = (sd.powi(2) - solution.deviation(2, sd).powi(2)).max(0.0).sqrt();
        for estimate in &mut fit.estimates {
            match estimate.parameter {
                Parameter::KFactor => {
                    let within = estimate.within_95.plain().hypot(BELIEVED * k_of_radius * given_up);
                    (estimate.value, estimate.within_95) = (Figure::Ratio(k_factor), Figure::Ratio(within));
                }
                Parameter::BendRadius => {
                    estimate.value = Figure::Length(radius.value);
                    estimate.within_95 = Figure::Length(Length::computed(BELIEVED * sd));
                    estimate.determined = 0.0;
                }
                _ => {}
            }
        }
        FeedFit { fit, scale, k_factor, model: feed_model(assumed, k_factor, before) }
    });
    Ok(Outcome { fit, left_out: screened.left_out, gaps })
}

/// The sides that samples leave between the bends of a model, with K and the feed's scale as they were assumed.
fn sides_between(
    assumed: &Assumed,
    samples: &[LengthSample],
    bends: &BendModel,
    radius: Length,
) -> Vec<Length> {
    let side = |sample: &LengthSample| {
        let fed = assumed.motion.fed(sample.feed);
        side_of(assumed, fed, bends_beside(bends, sample), [assumed.k_factor, radius.mm()])
    };
    samples.iter().map(side).collect()
}

/// The bends before and behind a side.
fn bends_beside(bends: &BendModel, sample: &LengthSample) -> [Angle; 2] {
    [sample.axis_before, sample.axis_after].map(|axis| bends.result(axis))
}

/// The side that fed wire makes between two bends, by K and the radius of a bend.
fn side_of(assumed: &Assumed, fed: Length, bends: [Angle; 2], [k_factor, radius]: [f64; 2]) -> Length {
    if assumed.deducts_bends {
        feed_model(assumed, k_factor, radius).segment_of(fed, bends[0], bends[1])
    } else {
        fed
    }
}

fn feed_model(assumed: &Assumed, k_factor: f64, bend_radius: f64) -> FeedModel {
    let pin = bend_radius - assumed.diameter.mm() / 2.0;
    FeedModel::new(Length::computed(pin), assumed.diameter, k_factor)
}
