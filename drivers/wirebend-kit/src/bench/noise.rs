//! How wrong each motion is, drawn from a seed.

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

use super::settings::{BenchError, demand};

/// A constant error and the standard deviation of the random one, of a quantity in its own unit.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ErrorTerm {
    /// Always added, whichever way the motion went.
    pub bias: f64,
    /// Standard deviation; not negative.
    pub sigma: f64,
}

/// Errors of the motions. A motion of feed or head lasts until another axis moves, the direction changes
/// or the peg does; a bend until the wire is let go. Straights stay straight: their bow is left out.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Noise {
    /// The same seed and the same pulses make the same wire.
    pub seed: u64,
    pub feed_mm: ErrorTerm,
    /// Of each turn of the head, in degrees.
    pub rotate_deg: ErrorTerm,
    /// Of each bend that stays in the wire, in degrees.
    pub bend_deg: ErrorTerm,
}

/// The errors of one kind of motion, in the order of the motions.
#[derive(Debug, Clone)]
pub(super) struct Draw {
    term: ErrorTerm,
    random: ChaCha8Rng,
}

impl Draw {
    /// Kinds of motion have a stream each: a feed more changes no error of a bend.
    fn new(seed: u64, stream: u64, term: ErrorTerm) -> Self {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        random.set_stream(stream);
        Self { term, random }
    }

    pub fn next(&mut self) -> f64 {
        let normal: f64 = StandardNormal.sample(&mut self.random);
        self.term.bias + self.term.sigma * normal
    }
}

#[derive(Debug, Clone)]
pub(super) struct Draws {
    pub feed_mm: Draw,
    pub rotate_deg: Draw,
    pub bend_deg: Draw,
}

impl Draws {
    pub fn new(noise: &Noise) -> Result<Self, BenchError> {
        let checked = |what, stream, term: ErrorTerm| {
            demand(term.bias.is_finite(), what, term.bias, "a finite bias")?;
            let fits = term.sigma.is_finite() && term.sigma >= 0.0;
            demand(fits, what, term.sigma, "a deviation of zero or more")?;
            Ok(Draw::new(noise.seed, stream, term))
        };
        Ok(Self {
            feed_mm: checked("the error of a feed", 1, noise.feed_mm)?,
            rotate_deg: checked("the error of a turn of the head", 2, noise.rotate_deg)?,
            bend_deg: checked("the error of a bend", 3, noise.bend_deg)?,
        })
    }
}
