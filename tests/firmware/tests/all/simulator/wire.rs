//! The serial line: a byte takes its time, and what the chip would lose is lost.

use proptest::prelude::*;
use wirebend_tests_firmware::{BYTE_CYCLES, Uno, probe, vector};

use super::{asked, said, started};

/// More than any interrupt of the probe and its loop take between a byte and its echo, in cycles.
const REACTION: u64 = 600;

#[test]
fn an_echo_comes_two_bytes_after_its_start_and_not_before() {
    let mut uno = started();
    let begin = uno.cycle() + 5000;
    uno.send_at(begin, b'Q');
    assert_eq!(said_with_times(&mut uno, begin, 1), "Q");
}

#[test]
fn bytes_on_end_are_seen_one_at_a_time() {
    let mut uno = started();
    let begin = uno.cycle();
    uno.send(b"ABCDEFGHIJ");
    assert_eq!(uno.on_wire(), 10);
    assert_eq!(said_with_times(&mut uno, begin, 10), "ABCDEFGHIJ");
    assert_eq!((uno.on_wire(), uno.overruns()), (0, 0));
}

/// The echo of byte `i` begins when that byte is over at the earliest, and is over one byte later.
fn said_with_times(uno: &mut Uno, begin: u64, count: u64) -> String {
    uno.run_until(begin + (count + 5) * BYTE_CYCLES).unwrap();
    let echo = uno.received();
    for (i, &(end, _)) in (0..).zip(&echo) {
        let earliest = begin + (i + 2) * BYTE_CYCLES;
        assert!(
            (earliest..earliest + REACTION).contains(&end),
            "echo {i} is over at {end} and not {earliest}"
        );
    }
    echo.into_iter().map(|(_, byte)| char::from(byte)).collect()
}

#[test]
fn ten_bits_make_a_byte_and_not_eleven() {
    let mut uno = started();
    uno.send(b"c"); // answers four digits on end
    uno.run_for(30 * BYTE_CYCLES).unwrap();
    let ends: Vec<u64> = uno.received().into_iter().map(|(end, _)| end).collect();
    assert_eq!(ends.len(), 4);
    for pair in ends.windows(2) {
        // simavr has one place to send from where the chip has two: the next byte waits for the interrupt.
        let between = pair[1] - pair[0];
        assert!((BYTE_CYCLES..BYTE_CYCLES + 100).contains(&between), "{between} cycles between two bytes");
    }
}

#[test]
fn a_controller_that_does_not_read_loses_bytes_and_is_told() {
    let mut uno = started();
    assert_eq!(asked(&mut uno, b"e"), "00");
    uno.send(b"kABCDEFGHIJ"); // it looks away for ten bytes, of which the chip holds three
    uno.run_for(40 * BYTE_CYCLES).unwrap();
    assert!((6..=8).contains(&uno.overruns()), "{} lost", uno.overruns());
    let kept = 10 - usize::try_from(uno.overruns()).unwrap();
    assert_eq!(uno.received().len(), kept);
    assert_eq!(asked(&mut uno, b"e"), "08", "the bit DOR0 of UCSR0A");
    assert_eq!(asked(&mut uno, b"p"), "p", "and it continues");
}

#[test]
fn a_controller_that_sends_without_looking_loses_bytes() {
    let mut uno = started();
    // The data sheet: what is written to UDR0 while UDRE0 is clear is ignored. One goes out and one waits.
    assert_eq!(asked(&mut uno, b"y"), "01");
    assert_eq!(uno.lost_sending(), 3);
}

#[test]
fn a_byte_without_stop_bit_shows_as_framing_error() {
    let mut uno = started();
    uno.send_broken(b'A');
    said(&mut uno);
    assert_eq!(asked(&mut uno, b"e"), "10", "the bit FE0 of UCSR0A");
}

#[test]
fn the_same_bytes_give_the_same_answers_at_the_same_cycles() {
    let run = || {
        let mut uno = Uno::new(&probe()).unwrap();
        uno.send_at(123_456, b'a');
        uno.send_at(1_000_000, b'p');
        uno.run_until(20_000_000).unwrap();
        (uno.received(), uno.pins())
    };
    let (received, pins) = run();
    assert!(received.len() == 6 && pins.len() > 600, "{} bytes, {} pin changes", received.len(), pins.len());
    assert!((received, pins) == run());
}

#[test]
fn interrupts_are_counted_and_timed() {
    let mut uno = started();
    uno.send(b"a");
    uno.run_for(100 * 8000 + 40_000).unwrap();
    let times = uno.interrupt_times();
    let of = |vector| times.iter().find(|time| time.vector == vector).expect("it ran");
    let step = of(vector::TIMER1_COMPA);
    assert_eq!(step.count, 100);
    // The pulse of 2 us is 32 cycles of it; pushing and popping registers is far from a hundred more.
    assert!((32..160).contains(&step.worst_cycles), "{step:?}");
    // It waits for the longest other interrupt at most, and for the four cycles of the sleeping chip.
    let other = of(vector::TIMER2_OVF).worst_cycles.max(of(vector::USART_RX).worst_cycles);
    assert!(step.worst_wait_cycles <= other + 40, "{step:?}, {other}");
    assert_eq!(of(vector::USART_RX).count, 1);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn whatever_is_no_command_comes_back(bytes in prop::collection::vec(prop::num::u8::ANY, 1..40)) {
        let bytes: Vec<u8> = bytes.into_iter().filter(|byte| !byte.is_ascii_lowercase()).collect();
        let mut uno = started();
        uno.send(&bytes);
        uno.run_for((bytes.len() as u64 + 4) * BYTE_CYCLES).unwrap();
        let echo: Vec<u8> = uno.received().into_iter().map(|(_, byte)| byte).collect();
        prop_assert_eq!(echo, bytes);
    }
}
