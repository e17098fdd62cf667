//! One wire of the many that a machine could make: how far each of its motions is off, and how its struts are bowed.

use std::f64::consts::TAU;

use nalgebra::{Point3, Vector3};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, Normal, Uniform};
use wirebend_core::simulate::{BadErrorTerm, ErrorModel, ErrorSource, ErrorTerm, fractions};
use wirebend_core::units::{Angle, Length};

use super::misfits::{FrameWire, MisfitSource};

/// How far everything is off in one wire.
#[derive(Debug, Clone, PartialEq)]
pub struct Draw {
    /// For each source of misfits, mm or radian.
    pub(super) amounts: Vec<f64>,
    /// For each strut, from its chord to the middle of its arc, mm; none where all are straight.
    pub(super) rises: Vec<Vector3<f64>>,
}

/// The errors of a model as they apply to the sources, with mm and radian.
#[derive(Debug, Clone, Copy)]
pub(super) struct Terms {
    model: ErrorModel,
}

impl Terms {
    /// # Errors
    /// A figure that is not finite, or a deviation below zero.
    pub fn new(model: &ErrorModel) -> Result<Self, BadErrorTerm> {
        model.check()?;
        Ok(Self { model: *model })
    }

    /// Of a source in mm or radian; of the curvature as a share.
    pub fn of(&self, of: ErrorSource) -> ErrorTerm {
        let ErrorTerm { bias, sigma } = self.model.term(of);
        match of {
            ErrorSource::Feed | ErrorSource::Curvature => ErrorTerm { bias, sigma },
            ErrorSource::Rotation | ErrorSource::Bend => {
                ErrorTerm { bias: bias.to_radians(), sigma: sigma.to_radians() }
            }
        }
    }

    /// Whether struts are bowed.
    pub fn bows(&self) -> bool {
        let ErrorTerm { bias, sigma } = self.model.curvature;
        bias != 0.0 || sigma > 0.0
    }

    /// The wire of a number, by a seed: the same whichever is drawn before it, and on whichever thread.
    pub fn draw(&self, seed: u64, run: u64, sources: &[MisfitSource], struts: &[Vector3<f64>]) -> Draw {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        random.set_stream(run);
        let mut normal = |ErrorTerm { bias, sigma }| {
            Normal::new(bias, sigma).map_or(bias, |normal| normal.sample(&mut random))
        };
        let of = |source: &MisfitSource| {
            let term = self.of(source.of);
            ErrorTerm { bias: term.bias * source.side, ..term }
        };
        let amounts = sources.iter().map(|source| normal(of(source))).collect();
        if !self.bows() {
            return Draw { amounts, rises: Vec::new() };
        }
        let heights: Vec<f64> = struts.iter().map(|_| normal(self.model.curvature)).collect();
        Draw { amounts, rises: rises(&mut random, struts, heights) }
    }
}

/// Struts that all bow by a share of their length, each in a direction of its own, by a seed: from the chord of each to the middle of
/// its arc.
#[must_use]
pub fn bows(struts: &[Vector3<f64>], share: f64, seed: u64) -> Vec<Vector3<f64>> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    rises(&mut random, struts, struts.iter().map(|_| share))
}

fn rises(
    random: &mut ChaCha8Rng,
    struts: &[Vector3<f64>],
    heights: impl IntoIterator<Item = f64>,
) -> Vec<Vector3<f64>> {
    let around = Uniform::new(0.0, TAU);
    let rise = |(strut, height): (&Vector3<f64>, f64)| {
        let angle = around.map_or(0.0, |around| around.sample(random));
        across(strut, angle) * (height * strut.norm())
    };
    struts.iter().zip(heights).map(rise).collect()
}

/// A direction across a strut, at an angle about it.
fn across(strut: &Vector3<f64>, angle: f64) -> Vector3<f64> {
    let along = strut.normalize();
    let side = along.cross(&Vector3::ith(along.iamin(), 1.0)).normalize();
    side * angle.cos() + along.cross(&side) * angle.sin()
}

/// How far passes through one vertex are apart at most, mm: each is a vertex and where it is passed. None where none is passed twice.
pub(super) fn gap(mut passes: Vec<(usize, Point3<f64>)>) -> Option<f64> {
    passes.sort_by_key(|&(vertex, _)| vertex);
    let again = passes.chunk_by(|(a, _), (b, _)| a == b).filter(|passes| passes.len() > 1);
    let distances = again.flat_map(|passes| {
        passes.iter().flat_map(move |(_, a)| passes.iter().map(move |(_, b)| (a - b).norm()))
    });
    distances.reduce(f64::max)
}

/// The passes of a wire as its motions leave them one after the other, mm, in the order of the wire. Bows do not count: the ends of a
/// bowed strut stay where they are.
pub(super) fn made(
    wire: &FrameWire,
    index: usize,
    points: &[Point3<f64>],
    sources: &[MisfitSource],
    draw: &Draw,
) -> Vec<Point3<f64>> {
    let path: Vec<Point3<f64>> = wire.vertices.iter().filter_map(|&k| points.get(k).copied()).collect();
    let mut steps = wire.program.steps.clone();
    for (source, &amount) in sources.iter().zip(&draw.amounts).filter(|(source, _)| source.wire == index) {
        let Some(step) = steps.get_mut(source.step) else { continue };
        match source.of {
            ErrorSource::Feed => step.feed += Length::computed(amount),
            ErrorSource::Rotation => step.rotate += Angle::computed(amount),
            ErrorSource::Bend => step.bend += Angle::computed(amount),
            ErrorSource::Curvature => {}
        }
    }
    let mut frame = wire.start;
    let mut made = vec![frame.position];
    for (step, shares) in steps.iter().zip(fractions(&path, wire.program.spans.iter().cloned())) {
        let from = frame.position;
        made.extend(shares.iter().map(|share| from + frame.t() * (step.feed.mm() * share)));
        frame.feed(step.feed);
        frame.rotate(step.rotate);
        frame.bend(step.bend);
    }
    made
}
