//! When in its step a contact is.

use super::contact::Contact;
use super::stroke::Phase;
use crate::motion::Moment;
use crate::units::Angle;

impl Contact {
    /// The part of its step's time that has passed, from 0 to 1: `moments` are those of the step, `bend` is what it leaves in the
    /// wire. There a bend goes evenly from nothing to what is left, once the peg is out, so that a contact while the wire is bent
    /// comes where it is bent as far.
    #[must_use]
    pub fn time_in(&self, moments: &[Moment], bend: Angle) -> f64 {
        let passed = self.passed.clamp(0.0, 1.0);
        let [of_feed, of_head, of_peg, of_bend, of_axis]: [fn(&Moment) -> f64; 5] = [
            |moment| moment.fed,
            |moment| moment.head.rad(),
            |moment| moment.peg_out,
            |moment| moment.bent,
            |moment| moment.bend_axis.rad(),
        ];
        // When each phase is over, which is when the one before it is where nothing moves.
        let fed = first(moments, of_feed, 1.0).unwrap_or_default();
        let turned = first(moments, of_head, 1.0).unwrap_or(fed);
        let out = first(moments, of_peg, 1.0).unwrap_or(turned);
        let bent = first(moments, of_bend, 1.0).unwrap_or(out);
        let returned = last(moments, of_axis, 1.0).unwrap_or(bent);
        let time = match self.phase {
            Phase::Feed => first(moments, of_feed, passed).unwrap_or_default(),
            Phase::Rotate => first(moments, of_head, passed).unwrap_or(fed),
            // Of a machine whose peg comes out at zero it is no motion.
            Phase::Approach => first(moments, of_axis, passed).filter(|at| *at < out).unwrap_or(turned),
            Phase::PegOut => first(moments, of_peg, passed).unwrap_or(turned),
            Phase::Bend => {
                let share = if bend == Angle::ZERO { 1.0 } else { self.bent.rad() / bend.rad() };
                first(moments, of_bend, share.clamp(0.0, 1.0)).unwrap_or(out)
            }
            Phase::Release => last(moments, of_axis, passed).unwrap_or(bent),
            Phase::PegIn => last(moments, of_peg, passed).unwrap_or(returned),
            Phase::Return => 1.0,
        };
        time.clamp(0.0, 1.0)
    }
}

/// When a figure has changed by a share of what it does in its first motion; none where it does not change.
fn first(moments: &[Moment], figure: fn(&Moment) -> f64, share: f64) -> Option<f64> {
    motions(moments, figure).next().map(|[from, to]| from + (to - from) * share)
}

/// The same of its last motion.
fn last(moments: &[Moment], figure: fn(&Moment) -> f64, share: f64) -> Option<f64> {
    motions(moments, figure).next_back().map(|[from, to]| from + (to - from) * share)
}

/// From when to when a figure changes.
fn motions(moments: &[Moment], figure: fn(&Moment) -> f64) -> impl DoubleEndedIterator<Item = [f64; 2]> + '_ {
    let moves = move |pair: &&[Moment]| (figure(&pair[0]) - figure(&pair[1])).abs() > 1e-12;
    moments.windows(2).filter(moves).map(|pair| [pair[0].at, pair[1].at])
}

#[cfg(test)]
mod tests {
    use super::super::contact::Obstacle;
    use super::*;
    use crate::bend::Step;
    use crate::estimate::StepSeconds;
    use crate::motion::{MachineStep, moments};
    use crate::testing::{deg, mm};

    /// Playback would stop too early or too late. 2 s feed, 1 s rotate, 1 s for the peg, 2 s there and back each, 1 s for the peg:
    /// the times are counted by hand from these.
    #[test]
    fn a_contact_is_where_its_phase_is_in_the_time_of_the_step() {
        let designed = Step { feed: mm(30.0), rotate: deg(40.0), bend: deg(-80.0) };
        let told = Step { bend: deg(-100.0), ..designed };
        let seconds = StepSeconds { feed: 2.0, rotate: 1.0, bend: 4.0, wait: 2.0 };
        let of_step = &moments(&[MachineStep { designed, told, comes_out: None, seconds }])[0];
        let at = |phase, passed, bent| contact(phase, passed, bent).time_in(of_step, designed.bend) * 9.0;
        for (phase, passed, bent, seconds) in [
            (Phase::Feed, 0.25, 0.0, 0.5),
            (Phase::Rotate, 0.5, 0.0, 2.5),
            (Phase::Approach, 0.7, 0.0, 3.0),
            (Phase::PegOut, 0.5, 0.0, 3.5),
            (Phase::Bend, 0.4, 0.0, 4.0),
            (Phase::Bend, 0.6, -20.0, 4.5),
            (Phase::Bend, 1.0, -84.0, 6.0),
            (Phase::Release, 0.5, -80.0, 7.0),
            (Phase::PegIn, 0.5, -80.0, 8.5),
            (Phase::Return, 0.5, -80.0, 9.0),
        ] {
            assert!(
                (at(phase, passed, bent) - seconds).abs() < 1e-9,
                "{phase:?}: {}",
                at(phase, passed, bent)
            );
        }
    }

    /// Its way to where the peg comes out takes half of a second.
    #[test]
    fn a_contact_on_the_way_to_where_the_peg_comes_out_is_there() {
        let designed = Step { feed: mm(30.0), rotate: deg(40.0), bend: deg(-80.0) };
        let told = Step { bend: deg(-100.0), ..designed };
        let seconds = StepSeconds { feed: 2.0, rotate: 1.0, bend: 4.0, wait: 2.0 };
        let step = MachineStep { designed, told, comes_out: Some(deg(18.25)), seconds };
        let of_step = &moments(&[step])[0];
        let at = |phase, passed, bent| contact(phase, passed, bent).time_in(of_step, designed.bend) * 9.0;
        for (phase, passed, bent, seconds) in [
            (Phase::Approach, 0.5, 0.0, 3.25),
            (Phase::PegOut, 0.5, 0.0, 3.75),
            (Phase::Bend, 0.6, -20.0, 4.5),
            (Phase::Release, 0.5, -80.0, 7.0),
        ] {
            assert!(
                (at(phase, passed, bent) - seconds).abs() < 1e-9,
                "{phase:?}: {}",
                at(phase, passed, bent)
            );
        }
    }

    /// A machine whose peg stays out, and a step that only feeds: nothing is divided by what does not move.
    #[test]
    fn what_does_not_move_takes_no_time() {
        let designed = Step { feed: mm(30.0), ..Step::default() };
        let seconds = StepSeconds { feed: 2.0, ..StepSeconds::default() };
        let of_step = &moments(&[MachineStep { designed, told: designed, comes_out: None, seconds }])[0];
        for phase in
            [Phase::Rotate, Phase::Approach, Phase::PegOut, Phase::Bend, Phase::Release, Phase::PegIn]
        {
            let at = contact(phase, 0.5, 0.0).time_in(of_step, Angle::ZERO);
            assert!((at - 1.0).abs() < 1e-12, "{phase:?}: {at}");
        }
        assert!(contact(Phase::Feed, 0.5, 0.0).time_in(&[], Angle::ZERO).abs() < 1e-12);
    }

    fn contact(phase: Phase, passed: f64, bent: f64) -> Contact {
        Contact {
            step: 0,
            phase,
            passed,
            fed: mm(0.0),
            head: deg(0.0),
            bent: deg(bent),
            obstacle: Obstacle::Stock,
            leg: 0,
            along: mm(0.0),
        }
    }
}
