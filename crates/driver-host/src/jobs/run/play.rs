//! The play of a head when a wire begins or goes on: the head has to come to its place from the side from which the program takes it to
//! come, whatever turned it to zero before.

use wirebend_driver_api::Step;

use super::super::entry::EntryKind;
use super::super::part::Part;
use super::super::wire_job::WireJob;
use super::JobRun;
use crate::session::ROUNDING_DEG;

/// The drive goes so much farther than the play is, degrees: how large that is is not known exactly.
const BEYOND_DEG: f64 = 1.0;

impl JobRun {
    /// After which step the wire was begun or resumed last; nothing before that.
    pub(super) fn armed_after(&self) -> Option<u32> {
        self.journal.entries().iter().rev().find_map(|entry| match entry.what {
            EntryKind::Armed { after, resumed: false, .. } => Some(after),
            _ => None,
        })
    }

    /// How much more the step after the first `done` turns where the wire begins or goes on within it.
    pub(super) fn turns_more_after(&self, done: u32, part: Part) -> f64 {
        let WireJob { steps, head_play_deg, head_range_deg, .. } = &self.work;
        let is_new = done == 0 && part == Part::default();
        // An older driver begins a wire with the head as it stands.
        if is_new && !self.session.turns_head_first() {
            return 0.0;
        }
        let more = turns_more(steps, done, part, *head_play_deg);
        if is_new { within(more, *head_range_deg) } else { more }
    }

    /// How much more than its rest a step turns, since the wire begins or goes on in it.
    pub(super) fn turns_more_in(&self, n: u32) -> f64 {
        let (step, more) = self.turns_more;
        if n == step { more } else { 0.0 }
    }
}

/// How much more the step after the first `done` turns where a wire begins, or goes on within it: the head, which was put to zero since,
/// stands so far before, and so takes up its play as it did when it came there first. Before the first turn it is that turn whose play is
/// taken up, as programs have it. Zero where the rest of the step does that. No more than the last turn was, if there was one: so far the
/// head can stand.
pub(super) fn turns_more(steps: &[Step], done: u32, part: Part, play_deg: f64) -> f64 {
    if play_deg <= 0.0 {
        return 0.0;
    }
    let begun = usize::try_from(done).unwrap_or(usize::MAX);
    let rest = steps.get(begun).map_or(0.0, |step| step.rotate_deg - part.rotate_deg);
    // That nothing is turned yet of a step is nothing that the head came from.
    let count = begun.saturating_add(usize::from(part.rotate_deg != 0.0 || done > 0));
    let is_turn = |turn: &f64| turn.abs() > ROUNDING_DEG;
    let before = steps.iter().take(count).map(|step| step.rotate_deg).rfind(is_turn);
    let whole = play_deg + BEYOND_DEG;
    let first = || steps.iter().map(|step| step.rotate_deg).find(is_turn).map(|turn| (turn, whole));
    let Some((turn, needed)) = before.map(|turn| (turn, whole.min(turn.abs()))).or_else(first) else {
        return 0.0;
    };
    let takes_up = (rest * turn.signum()).max(0.0);
    (needed - takes_up).max(0.0) * turn.signum()
}

/// As much of it as the head has room for, which stands so far before zero: within its range, degrees.
fn within(more: f64, [min, max]: [f64; 2]) -> f64 {
    more.clamp(-max.max(0.0), (-min).max(0.0))
}

/// What is turned of a step that turns `more` besides: what takes up the play comes first, and is nothing of it.
pub(super) fn turned_of_step(turned_deg: f64, more: f64) -> f64 {
    let of_step = turned_deg - more;
    if of_step * more < 0.0 { 0.0 } else { of_step }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// A head that its drive moves with play: it stands at one end of it or the other.
    struct Head {
        drive: f64,
        stands: f64,
        play: f64,
    }

    impl Head {
        fn turn(&mut self, by: f64) {
            self.drive += by;
            self.stands = self.stands.clamp(self.drive - self.play, self.drive);
        }
    }

    proptest! {
        /// The planes of all bends after it are those that they would have been.
        #[test]
        fn a_head_that_was_put_to_zero_stands_where_it_would_have(
            turns in prop::collection::vec(prop_oneof![Just(0.0), -90.0..90.0_f64, -3.0..3.0_f64], 1..8),
            at in 0..8_usize, share in 0.0..=1.0_f64, play in 0.1..4.0_f64, rests in 0.0..=1.0_f64,
        ) {
            let at = at % turns.len();
            let steps: Vec<Step> =
                turns.iter().map(|&rotate_deg| Step { rotate_deg, ..Step::default() }).collect();
            let part = Part { feed_mm: 0.0, rotate_deg: turns[at] * share };
            // A turn that is smaller than the play leaves the head somewhere, which nobody knows.
            let last = *turns[..=at].iter().rfind(|turn| **turn != 0.0).unwrap_or(&0.0);
            prop_assume!(last.abs() > play);
            let told = |head: &mut Head, turns: &[f64]| turns.iter().map(|&by| { head.turn(by); head.stands }).collect::<Vec<f64>>();
            let mut whole = Head { drive: 0.0, stands: -play * rests, play };
            let planned = told(&mut whole, &turns);
            let done = u32::try_from(at).unwrap();
            let more = turns_more(&steps, done, part, play);
            let mut resumed = Head { drive: 0.0, stands: -play * rests, play };
            let before: f64 = turns[..at].iter().sum();
            resumed.turn(before + part.rotate_deg - more);
            resumed.turn(turns[at] - part.rotate_deg + more);
            prop_assert!((resumed.stands - planned[at]).abs() < 1e-9, "{} instead of {}", resumed.stands, planned[at]);
            for (made, planned) in told(&mut resumed, &turns[at + 1..]).iter().zip(&planned[at + 1..]) {
                prop_assert!((made - planned).abs() < 1e-9, "{made} instead of {planned}");
            }
            // What is turned before the play is taken up is nothing of the step.
            prop_assert!(turned_of_step(0.0, more).abs() < 1e-12);
            let whole = turns[at] - part.rotate_deg;
            prop_assert!((turned_of_step(whole + more, more) - whole).abs() < 1e-9);
        }

        /// Homing turns it back from where the wire before has left it: to one side, to the other, or not at all.
        #[test]
        fn a_wire_comes_out_the_same_whatever_turned_the_head_to_zero(
            turns in prop::collection::vec(prop_oneof![Just(0.0), -90.0..90.0_f64], 1..8),
            play in 0.1..4.0_f64, off in -0.9..0.9_f64, rests in 0.0..=1.0_f64,
        ) {
            let steps: Vec<Step> =
                turns.iter().map(|&rotate_deg| Step { rotate_deg, ..Step::default() }).collect();
            let Some(first) = turns.iter().find(|turn| **turn != 0.0) else { return Ok(()) };
            let more = turns_more(&steps, 0, Part::default(), play);
            // It is not known exactly.
            let play = (play + off).max(0.0);
            let mut planned = Head { drive: 0.0, stands: if *first > 0.0 { -play } else { 0.0 }, play };
            let mut begun = Head { drive: 0.0, stands: -play * rests, play };
            begun.turn(-more);
            for (k, &by) in turns.iter().enumerate() {
                begun.turn(if k == 0 { by + more } else { by });
                planned.turn(by);
                prop_assert!((begun.stands - planned.stands).abs() < 1e-9, "{} instead of {}", begun.stands, planned.stands);
            }
        }
    }

    #[test]
    fn a_head_goes_no_farther_before_its_zero_than_it_can() {
        for (more, range, wanted) in [
            (2.5, [-360.0, 360.0], 2.5),
            (2.5, [-1.0, 360.0], 1.0),
            (2.5, [0.0, 360.0], 0.0),
            (-2.5, [0.0, 360.0], -2.5),
            (-2.5, [-360.0, 2.0], -2.0),
        ] {
            assert!((within(more, range) - wanted).abs() < 1e-12, "{more} in {range:?}");
        }
    }

    #[test]
    fn a_head_without_play_or_turns_goes_where_it_is_sent() {
        let step = |rotate_deg| Step { rotate_deg, ..Step::default() };
        let steps = [step(0.0), step(30.0), step(0.0)];
        let more = |done, turned, play| {
            turns_more(&steps, done, Part { feed_mm: 0.0, rotate_deg: turned }, play).to_bits()
        };
        for (done, turned, play, wanted) in [
            (2, 0.0, 0.0, 0.0),
            (0, 0.0, 0.0, 0.0),
            (0, 0.0, 1.5, 2.5),
            (2, 0.0, 1.5, 2.5),
            (1, 0.0, 1.5, 0.0),
            (1, 29.0, 1.5, 1.5),
        ] {
            assert_eq!(more(done, turned, play), f64::to_bits(wanted), "{done} {turned} {play}");
        }
    }
}
