//! A feed and a head that do not make what their pulses say.

use wirebend_driver_wirebend_kit::bench::{BenchError, Drives, Made};

use super::hand::{Hand, published};

/// Bends in one plane, with turns of the head between them: how each bend stands about the wire is what the head has turned.
fn made(drives: Drives, turns: &[f64]) -> Made {
    let mut hand = Hand::new(published().with_drives(drives).unwrap());
    hand.feed(50.0).press(90.0);
    for &turn in turns {
        hand.feed(50.0).rotate(turn).press(90.0);
    }
    hand.bench.made()
}

fn heads(made: &Made) -> Vec<f64> {
    made.bends().windows(2).map(|pair| pair[1].head_deg - pair[0].head_deg).collect()
}

#[test]
fn a_feed_gives_so_much_more() {
    let exact = made(Drives::EXACT, &[0.0, 0.0]).length_mm();
    let more = made(Drives { feed_scale: 1.02, ..Drives::EXACT }, &[0.0, 0.0]).length_mm();
    assert!((more - exact - 3.0 * 0.02 * 50.0).abs() < 0.02, "{exact} {more}");
}

/// By hand: the offset comes with each turn to whichever side, the backlash of 1.5 where a turn goes against the one before, and twice to the
/// same side nothing is lost. The first turn finds the drive where it needs it.
#[test]
fn a_head_is_off_and_has_backlash() {
    let off = Drives { rotate_offset_deg: 2.0, rotate_backlash_deg: 1.5, ..Drives::EXACT };
    let turns = [40.0, 30.0, -50.0, -20.0, 60.0];
    let exact = heads(&made(Drives::EXACT, &turns));
    let found = heads(&made(off, &turns));
    for ((exact, found), by) in exact.iter().zip(&found).zip([2.0, 2.0, 3.5, 2.0, 0.5]) {
        assert!((found - exact - by).abs() < 1e-9, "{found} for {exact}, expected {by} more");
    }
}

#[test]
fn what_no_drive_does_is_refused() {
    for drives in [
        Drives { feed_scale: 0.0, ..Drives::EXACT },
        Drives { rotate_offset_deg: f64::NAN, ..Drives::EXACT },
        Drives { rotate_backlash_deg: -1.0, ..Drives::EXACT },
    ] {
        let refused = published().with_drives(drives);
        assert!(matches!(refused, Err(BenchError::Figure { .. })), "{drives:?}");
    }
}
