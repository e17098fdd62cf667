//! How good a machine must be: deviations of its motions for what is required of the closed frame. Effects grow in proportion.

use super::closing::mean;
use super::model::ClosingModel;

/// Effects of a mm or a degree are none below this share of what a strut does that is a mm too long.
const ROUNDING: f64 = 1e-12;

/// What a standard deviation of one unit does to a frame.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Effects {
    /// How far each of the faces is off, RMS, mm. Squares of these add, and those of their mean do not.
    pub faces: Vec<f64>,
    /// Force along a strut, RMS, N.
    pub force: f64,
    /// Von Mises stress, RMS, MPa.
    pub stress: f64,
}

impl Effects {
    /// The same without those that are rounding: wires that close no loop are forced to nothing.
    #[must_use]
    pub fn without_rounding(self, of: &ClosingModel) -> Self {
        let above = |effect: f64, scale: f64| if effect > ROUNDING * scale { effect } else { 0.0 };
        let shortest = of.shortest_strut();
        let stress = of.section.e / shortest;
        Self {
            faces: self.faces.into_iter().map(|off| above(off, shortest)).collect(),
            force: above(self.force, stress * of.section.area),
            stress: above(self.stress, stress),
        }
    }
}

/// What a frame comes to.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Responses {
    /// How far the faces are off, the mean of their RMS, mm.
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
/// Where both vary and several faces are off by different shares, their mean is more than its parts: then both deviations are
/// smaller by the same factor.
///
/// # Errors
/// [`NoLimit`] where nothing is required, or nothing that varies has an effect on it.
pub fn tolerance(
    feed: &Effects,
    angle: &Effects,
    required: &[(Requirement, f64)],
    vary: Vary,
) -> Result<Tolerance, NoLimit> {
    let shares = match vary {
        Vary::Feed => [1.0, 0.0],
        Vary::Angle => [0.0, 1.0],
        Vary::Both { feed_share } => [feed_share, 1.0 - feed_share],
    };
    let alone = [together(feed, 1.0, angle, 0.0), together(feed, 0.0, angle, 1.0)];
    // What one requirement allows; nothing limits what has no effect on it.
    let allowed = |&(of, limit): &(Requirement, f64)| -> [Option<f64>; 2] {
        let sigmas: [Option<f64>; 2] = std::array::from_fn(|k| {
            let effect = of.of(&alone[k]);
            (effect > 0.0 && shares[k] > 0.0).then(|| limit * shares[k].sqrt() / effect)
        });
        let [by_feed, by_angle] = sigmas.map(Option::unwrap_or_default);
        let over = (of.of(&together(feed, by_feed, angle, by_angle)) / limit).max(1.0);
        sigmas.map(|sigma| sigma.map(|sigma| sigma / over))
    };
    let least = |k: usize| required.iter().filter_map(|one| allowed(one)[k]).reduce(f64::min);
    let (feed_sigma, angle_sigma) = (least(0), least(1));
    let achieved = together(feed, feed_sigma.unwrap_or_default(), angle, angle_sigma.unwrap_or_default());
    let used = |&(of, limit): &(Requirement, f64)| (of, of.of(&achieved) / limit);
    let governing = required
        .iter()
        .map(used)
        .filter(|&(_, used)| used > 0.0)
        .reduce(|a, b| if b.1 > a.1 { b } else { a });
    let (governed_by, _) = governing.ok_or(NoLimit)?;
    Ok(Tolerance { feed_sigma, angle_sigma, governed_by, achieved })
}

/// What the frame comes to when feeds and angles are off by so much: they are independent, and squares add.
fn together(feed: &Effects, by_feed: f64, angle: &Effects, by_angle: f64) -> Responses {
    let both = |feed: f64, angle: f64| (feed * by_feed).hypot(angle * by_angle);
    let count = feed.faces.len().max(angle.faces.len());
    let of = |faces: &[f64], k: usize| faces.get(k).copied().unwrap_or_default();
    Responses {
        surface: mean((0..count).map(|k| both(of(&feed.faces, k), of(&angle.faces, k)))),
        force: both(feed.force, angle.force),
        stress: both(feed.stress, angle.stress),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn effects(surface: f64, force: f64, stress: f64) -> Effects {
        Effects { faces: vec![surface], force, stress }
    }

    fn feed() -> Effects {
        effects(2.0, 50.0, 10.0)
    }

    fn angle() -> Effects {
        effects(0.5, 0.0, 25.0)
    }

    #[test]
    fn the_tightest_requirement_governs() {
        let required = [(Requirement::Surface, 1.0), (Requirement::Force, 5.0)];
        let found = tolerance(&feed(), &angle(), &required, Vary::Feed).unwrap();
        assert_eq!(
            (found.feed_sigma, found.angle_sigma, found.governed_by),
            (Some(0.1), None, Requirement::Force)
        );
        assert!((found.achieved.surface - 0.2).abs() < 1e-12);
    }

    #[test]
    fn what_has_no_effect_sets_no_limit() {
        let force = [(Requirement::Force, 5.0)];
        assert_eq!(tolerance(&feed(), &angle(), &force, Vary::Angle), Err(NoLimit));
        assert_eq!(tolerance(&feed(), &angle(), &[], Vary::Feed), Err(NoLimit));
    }

    /// One face is off by feeds alone and one by angles alone: each has the root of half of the squares, and so has their mean. Had the
    /// roots of squares of means been taken, the faces would be off by 1.41 mm where 1 mm is required.
    #[test]
    fn faces_that_are_off_by_different_motions_do_not_make_up_for_each_other() {
        let of = |faces: [f64; 2]| Effects { faces: faces.to_vec(), ..Effects::default() };
        let both = Vary::Both { feed_share: 0.5 };
        let required = [(Requirement::Surface, 1.0)];
        let found = tolerance(&of([2.0, 0.0]), &of([0.0, 4.0]), &required, both).unwrap();
        assert!((found.achieved.surface - 1.0).abs() < 1e-12, "{found:?}");
        assert!((found.feed_sigma.unwrap() - 0.5).abs() < 1e-12, "{found:?}");
        assert!((found.angle_sigma.unwrap() - 0.25).abs() < 1e-12, "{found:?}");
        // Where both are off alike, squares of the means add.
        let found = tolerance(&of([2.0, 2.0]), &of([4.0, 4.0]), &required, both).unwrap();
        assert!((found.feed_sigma.unwrap() - 0.5_f64.sqrt() / 2.0).abs() < 1e-12, "{found:?}");
    }

    proptest! {
        /// However the allowance is split, nothing that is required is exceeded, and one requirement of each kind is used up.
        #[test]
        fn what_is_required_is_kept(share in 0.01..0.99_f64, w in 0.1..10.0_f64, p in 1.0..100.0_f64, s in 1.0..100.0_f64) {
            let required = [(Requirement::Surface, w), (Requirement::Force, p), (Requirement::Stress, s)];
            let found = tolerance(&feed(), &angle(), &required, Vary::Both { feed_share: share }).unwrap();
            for (of, limit) in required {
                prop_assert!(of.of(&found.achieved) <= limit * (1.0 + 1e-12));
            }
            let used = |effect: &Effects, sigma: f64, share: f64| {
                let effect = together(effect, 1.0, effect, 0.0);
                required.iter().map(|(of, limit)| of.of(&effect) * sigma / (limit * share.sqrt())).fold(0.0, f64::max)
            };
            prop_assert!((used(&feed(), found.feed_sigma.unwrap(), share) - 1.0).abs() < 1e-12);
            prop_assert!((used(&angle(), found.angle_sigma.unwrap(), 1.0 - share) - 1.0).abs() < 1e-12);
        }
    }
}
