//! Pins: every change of an output at its cycle, and inputs that stay where a switch holds them.

use wirebend_tests_firmware::{Port, Ram, ResetCause};

use super::{asked, edges, said, started};

#[test]
fn step_pulses_come_at_the_timer_s_pace() {
    let mut uno = started();
    uno.send(b"a");
    uno.run_for(100 * 8000 + 40_000).unwrap();
    let pins = uno.pins();
    let direction = edges(&pins, Port::D, 5, true);
    assert_eq!(direction.len(), 1);
    for bit in [2, 3, 4] {
        let (up, down) = (edges(&pins, Port::D, bit, true), edges(&pins, Port::D, bit, false));
        assert_eq!((up.len(), down.len()), (100, 100), "pin D{bit}");
        assert!(direction[0] < up[0]);
        // CTC with OCR1A = 999 and prescaler 8: 1000 x 8 cycles. Another interrupt may hold up one step by 300.
        for (i, &cycle) in (0..).zip(&up) {
            assert!(cycle.abs_diff(up[0] + i * 8000) < 300, "step {i} of D{bit} at {cycle}");
        }
        // DRV8825: high for 1.9 us or more, which is 30.4 cycles.
        assert!(up.iter().zip(&down).all(|(up, down)| down - up >= 31));
    }
}

#[test]
fn direction_is_seen_both_ways() {
    let mut uno = started();
    for (command, level) in [(b"a", true), (b"b", false)] {
        uno.send(command);
        uno.run_for(100 * 8000 + 40_000).unwrap();
        assert_eq!(edges(&uno.pins(), Port::D, 5, level).len(), 1, "direction {level}");
    }
}

#[test]
fn a_switch_holds_its_level_when_the_program_writes_its_port() {
    let mut uno = started();
    let open = |uno: &mut _| u8::from_str_radix(&asked(uno, b"i"), 16).unwrap() & 1 << 1 != 0;
    assert!(open(&mut uno), "the pull-up of B1");
    uno.set_input(Port::B, 1, false).unwrap();
    assert!(!open(&mut uno));
    uno.send(b"o"); // writes PORTB
    said(&mut uno);
    assert!(!open(&mut uno), "a write of the port let go of the switch");
    uno.reset(ResetCause::External, Ram::Kept);
    said(&mut uno);
    assert!(!open(&mut uno), "a reset let go of the switch");
    uno.set_input(Port::B, 1, true).unwrap();
    assert!(open(&mut uno));
}

#[test]
fn inputs_are_read_after_a_reset_as_before() {
    let mut uno = started();
    uno.set_input(Port::B, 2, true).unwrap();
    for _ in 0..3 {
        // Bit 1 has a pull-up and nothing drives it, bit 2 is driven; 0 and 3 are outputs.
        assert_eq!(asked(&mut uno, b"i"), "06");
        uno.reset(ResetCause::External, Ram::Kept);
        said(&mut uno);
    }
}

#[test]
fn a_pin_that_becomes_an_output_is_seen_each_time() {
    let mut uno = started();
    for _ in 0..3 {
        uno.reset(ResetCause::External, Ram::Kept);
        uno.pins();
        said(&mut uno);
        assert_eq!(edges(&uno.pins(), Port::C, 0, true).len(), 1);
    }
}

#[test]
fn a_write_of_what_stood_there_before_the_reset_is_seen() {
    let mut uno = started();
    for _ in 0..3 {
        uno.send(b"a");
        uno.run_for(100 * 8000 + 40_000).unwrap();
        let pins = uno.pins();
        let (direction, step) = (edges(&pins, Port::D, 5, true)[0], edges(&pins, Port::D, 2, true)[0]);
        // The timer starts behind the direction, and its first match is 8000 cycles later.
        assert!(step - direction >= 8000, "{direction} {step}");
        uno.reset(ResetCause::External, Ram::Kept);
        said(&mut uno);
    }
}

#[test]
fn a_reset_lets_go_of_every_output_and_the_next_write_is_seen() {
    let mut uno = started();
    uno.send(b"o");
    said(&mut uno);
    assert_eq!(edges(&uno.pins(), Port::B, 0, true).len(), 1);
    let at = uno.cycle();
    uno.reset(ResetCause::External, Ram::Kept);
    assert_eq!(edges(&uno.pins(), Port::B, 0, false), [at]);
    said(&mut uno);
    uno.send(b"o");
    said(&mut uno);
    assert_eq!(edges(&uno.pins(), Port::B, 0, true).len(), 1);
}
