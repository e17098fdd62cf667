//! How good a machine must be: deviations of its motions for what is required of the closed frame. Effects grow in proportion.

/// What a standard deviation of one unit does to a frame, or what a frame comes to.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Responses {
    /// How far the faces are off, RMS, mm.
    pub surface: f64,
    /// Force along a strut, RMS, N.
    pub force: f64,
    /// Von Mises stress, RMS, MPa.
    pub stress: f64,
}

/// What can be required.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Requirement {
    /// How far the faces may be off, RMS.
    Surface,
    /// Force along a strut, RMS.
    Force,
    /// Von Mises stress, RMS.
    Stress,
}

impl Requirement {
    /// All.
    pub const ALL: [Self; 3] = [Self::Surface, Self::Force, Self::Stress];

    /// The figure of it.
    #[must_use]
    pub fn of(self, responses: &Responses) -> f64 {
        match self {
            Self::Surface => responses.surface,
            Self::Force => responses.force,
            Self::Stress => responses.stress,
        }
    }
}

/// Which motions are off.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Vary {
    /// Feeds alone.
    Feed,
    /// Bends and rotations alone, both by the same.
    Angle,
    /// Both: this share, from 0 to 1, of each required square is for feeds, the rest for angles.
    Both {
        /// The share for feeds.
        feed_share: f64,
    },
}

/// How good the motions must be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tolerance {
    /// Standard deviation of feeds, mm; where they vary.
    pub feed_sigma: Option<f64>,
    /// Standard deviation of bends and rotations, in the unit of the responses; where they vary.
    pub angle_sigma: Option<f64>,
    /// The requirement that is met without any reserve.
    pub governed_by: Requirement,
    /// What the frame comes to with these.
    pub achieved: Responses,
}

/// No deviation does anything to what is required, so that none is too large.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("what is required does not depend on what varies")]
pub struct NoLimit;

/// The largest deviations with which all that is required is met. `feed` and `angle` are what a deviation of one unit does.
///
/// # Errors
/// [`NoLimit`] where nothing is required, or nothing that varies has an effect on it.
pub fn tolerance(
    feed: &Responses,
    angle: &Responses,
    required: &[(Requirement, f64)],
    vary: Vary,
) -> Result<Tolerance, NoLimit> {
    let (feed_share, angle_share) = match vary {
        Vary::Feed => (1.0, 0.0),
        Vary::Angle => (0.0, 1.0),
        Vary::Both { feed_share } => (feed_share, 1.0 - feed_share),
    };
    let largest = |effect: &Responses, share: f64| {
        let limits = required.iter().filter(|(of, _)| of.of(effect) > 0.0);
        let sigmas = limits.map(|(of, limit)| limit * share.sqrt() / of.of(effect));
        if share > 0.0 { sigmas.reduce(f64::min) } else { None }
    };
    let (feed_sigma, angle_sigma) = (largest(feed, feed_share), largest(angle, angle_share));
    let both = |of: Requirement| {
        let part = |effect: &Responses, sigma: Option<f64>| of.of(effect) * sigma.unwrap_or(0.0);
        part(feed, feed_sigma).hypot(part(angle, angle_sigma))
    };
    let used = |&(of, limit): &(Requirement, f64)| (of, both(of) / limit);
    let governing = required
        .iter()
        .map(used)
        .filter(|&(_, used)| used > 0.0)
        .reduce(|a, b| if b.1 > a.1 { b } else { a });
    let (governed_by, _) = governing.ok_or(NoLimit)?;
    Ok(Tolerance {
        feed_sigma,
        angle_sigma,
        governed_by,
        achieved: Responses {
            surface: both(Requirement::Surface),
            force: both(Requirement::Force),
            stress: both(Requirement::Stress),
        },
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const FEED: Responses = Responses { surface: 2.0, force: 50.0, stress: 10.0 };
    const ANGLE: Responses = Responses { surface: 0.5, force: 0.0, stress: 25.0 };

    #[test]
    fn the_tightest_requirement_governs() {
        let required = [(Requirement::Surface, 1.0), (Requirement::Force, 5.0)];
        let found = tolerance(&FEED, &ANGLE, &required, Vary::Feed).unwrap();
        assert_eq!(
            (found.feed_sigma, found.angle_sigma, found.governed_by),
            (Some(0.1), None, Requirement::Force)
        );
        assert!((found.achieved.surface - 0.2).abs() < 1e-12);
    }

    #[test]
    fn what_has_no_effect_sets_no_limit() {
        let force = [(Requirement::Force, 5.0)];
        assert_eq!(tolerance(&FEED, &ANGLE, &force, Vary::Angle), Err(NoLimit));
        assert_eq!(tolerance(&FEED, &ANGLE, &[], Vary::Feed), Err(NoLimit));
    }

    proptest! {
        /// However the allowance is split, nothing that is required is exceeded, and one requirement of each kind is used up.
        #[test]
        fn what_is_required_is_kept(share in 0.01..0.99_f64, w in 0.1..10.0_f64, p in 1.0..100.0_f64, s in 1.0..100.0_f64) {
            let required = [(Requirement::Surface, w), (Requirement::Force, p), (Requirement::Stress, s)];
            let found = tolerance(&FEED, &ANGLE, &required, Vary::Both { feed_share: share }).unwrap();
            for (of, limit) in required {
                prop_assert!(of.of(&found.achieved) <= limit * (1.0 + 1e-12));
            }
            let used = |effect: &Responses, sigma: f64, share: f64| {
                required.iter().map(|(of, limit)| of.of(effect) * sigma / (limit * share.sqrt())).fold(0.0, f64::max)
            };
            prop_assert!((used(&FEED, found.feed_sigma.unwrap(), share) - 1.0).abs() < 1e-12);
            prop_assert!((used(&ANGLE, found.angle_sigma.unwrap(), 1.0 - share) - 1.0).abs() < 1e-12);
        }
    }
}
