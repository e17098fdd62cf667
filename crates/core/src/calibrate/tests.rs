use super::*;
use crate::compensate::{BendModel, FeedModel, MotionModel, PegGeometry, Springback};
use crate::testing::{deg, mm};
use crate::units::{Angle, Length};

mod bad_input;
mod coverage;
mod left_out;
mod real;
mod recovery;
mod settled;
mod typing;
mod uncompensated;

/// The published machine and wire, as far as dimensions can be off by: 15 %, and K by 0.1.
fn published() -> Assumed {
    let known = |value: f64| KnownLength { value: mm(value), deviation: mm(0.15 * value) };
    Assumed {
        peg: Some(KnownPeg {
            orbit_radius: known(20.4),
            orbit_offset: known(12.0),
            peg_radius: known(4.675),
        }),
        bend_radius: known(3.0),
        springback: Some(Springback::Constant(deg(10.23))),
        axis_limit: Some(deg(155.0)),
        diameter: mm(3.0),
        motion: MotionModel::default(),
        k_factor: 0.3,
        k_deviation: 0.1,
        deducts_bends: true,
        angle_reading: deg(0.5),
        length_reading: mm(0.1),
    }
}

/// A machine of these dimensions in mm (R, s, bend radius, peg radius) and this loss in degrees.
fn machine([orbit, offset, pin, peg]: [f64; 4], loss: f64) -> BendModel {
    BendModel {
        springback: Some(Springback::Constant(deg(loss))),
        setback: Some(PegGeometry::new(mm(orbit), mm(offset), mm(pin), mm(peg)).unwrap()),
        axis_limit: None,
        before_zero: false,
    }
}

/// Random numbers that are normal about zero, of a seed.
struct Normals(rand_chacha::ChaCha8Rng);

impl Normals {
    fn new(seed: u64) -> Self {
        Self(rand::SeedableRng::seed_from_u64(seed))
    }

    fn next(&mut self, sd: f64) -> f64 {
        let normal: f64 = rand_distr::Distribution::sample(&rand_distr::StandardNormal, &mut self.0);
        sd * normal
    }

    fn below(&mut self, count: u32) -> u32 {
        rand::RngExt::random_range(&mut self.0, 0..count)
    }
}

/// Bends to both sides that a ladder of the published machine asks for, read with a scatter in degrees.
fn ladder(
    truth: &BendModel,
    angles: &[f64],
    repeats: usize,
    scatter: f64,
    random: &mut Normals,
) -> Vec<AngleSample> {
    let asked = published().bend_model().unwrap();
    let sides = angles.iter().flat_map(|angle| [*angle, -*angle]);
    sides
        .map(|angle| {
            let axis = asked.command(deg(angle)).unwrap();
            let made = truth.result(axis).deg();
            let readings = (0..repeats).map(|_| Some(deg(made + random.next(scatter))));
            AngleSample::beyond_zero(axis, readings.collect())
        })
        .collect()
}

/// Sides of U-shapes as a feed model leaves them between right angles.
fn sides(
    truth: &BendModel,
    model: &FeedModel,
    scale: f64,
    scatter: f64,
    random: &mut Normals,
) -> Vec<LengthSample> {
    let asked = published();
    let axis = asked.bend_model().unwrap().command(deg(90.0)).unwrap();
    let made = truth.result(axis);
    let told = FeedModel::new(mm(1.5), mm(3.0), 0.3);
    let feeds = [35.0, 70.0, 140.0].map(|side| told.feed_for(mm(side), deg(90.0), deg(90.0)));
    let side = |feed: Length| model.segment_of(mm(scale * feed.mm()), made, made).mm();
    feeds
        .map(|feed| LengthSample {
            feed,
            axis_before: axis,
            axis_after: axis,
            readings: (0..3).map(|_| Some(mm(side(feed) + random.next(scatter)))).collect(),
        })
        .to_vec()
}

fn estimate(fit: &Fit, wanted: Parameter) -> Estimate {
    *fit.estimates.iter().find(|estimate| estimate.parameter == wanted).unwrap()
}

fn covers(estimate: &Estimate, truth: f64) -> bool {
    (estimate.value.plain() - truth).abs() <= estimate.within_95.plain()
}
