//! The compare output OC2A on pin B3: the peg's servo gets what the chip would give.

use proptest::prelude::*;
use wirebend_tests_firmware::{Port, Uno};

use super::{MILLISECOND, edges, started};

/// 20 overflows of 256 ticks of 64 cycles: 20.48 ms.
const FRAME: u64 = 20 * 256 * 64;

/// Start and width of each whole pulse of the next ten frames, and nothing else on the pin.
fn pulses(uno: &mut Uno) -> Vec<(u64, u64)> {
    uno.pins();
    uno.run_for(10 * FRAME).unwrap();
    let pins = uno.pins();
    let (mut up, mut down) = (edges(&pins, Port::B, 3, true), edges(&pins, Port::B, 3, false));
    if down.first() < up.first() {
        down.remove(0);
    }
    up.truncate(down.len());
    up.into_iter().zip(down).map(|(up, down)| (up, down - up)).collect()
}

/// simavr moves the pin at the end of the instruction that is running, which takes up to four cycles.
const INSTRUCTION: u64 = 4;

fn check(uno: &mut Uno, ticks: u64) {
    let pulses = pulses(uno);
    assert!(pulses.len() >= 9, "{} pulses in ten frames", pulses.len());
    assert!(pulses.iter().all(|&(_, width)| width.abs_diff(ticks * 64) < INSTRUCTION), "{pulses:?}");
    let apart = |pair: &[(u64, u64)]| pair[1].0 - pair[0].0;
    assert!(pulses.windows(2).all(|pair| apart(pair).abs_diff(FRAME) < INSTRUCTION), "{pulses:?}");
}

#[test]
fn two_matches_make_a_pulse_of_exact_width_every_20_ms() {
    let mut uno = started();
    check(&mut uno, 375); // 1.5 ms
    for (command, ticks) in [(b"u", 250), (b"v", 500)] {
        uno.send(command);
        uno.run_for(2 * FRAME).unwrap(); // a pulse that has begun ends as it was
        check(&mut uno, ticks);
    }
}

#[test]
fn a_match_may_turn_the_pin_over_and_it_falls_back_when_it_is_let_go_of() {
    let mut uno = started();
    uno.send(b"t");
    uno.run_for(2 * FRAME).unwrap();
    let pins = uno.pins();
    let up = edges(&pins, Port::B, 3, true);
    assert!(up.len() > 15, "{} edges", up.len());
    // One match each 256 ticks of 64 cycles, and two of them from edge to edge; the first edges are a servo pulse.
    let period = |pair: &[u64]| (pair[1] - pair[0]).abs_diff(2 * 256 * 64) < INSTRUCTION;
    assert!(up[2..].windows(2).all(period), "{up:?}");
    while !uno.pins().last().is_some_and(|pin| pin.level) {
        uno.run_for(1000).unwrap();
    }
    let at = uno.cycle();
    uno.send(b"t"); // lets go of it
    uno.run_for(FRAME).unwrap();
    let pins = uno.pins();
    let down = edges(&pins, Port::B, 3, false);
    assert_eq!((pins.len(), down.len()), (1, 1), "{pins:?}");
    assert!(down[0] < at + 3000, "{at} {down:?}");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(12))]

    #[test]
    fn writes_of_the_same_port_do_not_touch_the_pulse(after in 0..FRAME) {
        let mut uno = started();
        uno.run_for(25 * MILLISECOND).unwrap();
        let now = uno.cycle();
        for nth in 0..10 {
            uno.send_at(now + after + nth * (FRAME - 997), b'o');
        }
        check(&mut uno, 375);
    }
}
