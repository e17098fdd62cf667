//! Resets: the cause as the chip shows it, what is kept, and what comes in meanwhile.

use wirebend_tests_firmware::{BYTE_CYCLES, HZ, Ram, ResetCause, Uno, vector};

use super::{MILLISECOND, asked, said, started};

/// MCUSR as the program found it after the last reset.
fn cause(uno: &mut Uno) -> String {
    uno.run_for(20 * MILLISECOND).unwrap();
    cause_in(uno.received())
}

fn cause_in(boot_line: Vec<(u64, u8)>) -> String {
    boot_line.into_iter().skip(1).take(2).map(|(_, byte)| char::from(byte)).collect()
}

#[test]
fn each_cause_sets_its_flag() {
    let mut uno = started();
    // ATmega328P data sheet, MCUSR: PORF, EXTRF, BORF, WDRF from bit 0 up. The program clears it each time.
    let causes = [
        (ResetCause::External, "02"),
        (ResetCause::BrownOut, "04"),
        (ResetCause::Watchdog, "08"),
        (ResetCause::PowerOn, "01"),
    ];
    for (reset, flag) in causes {
        uno.reset(reset, Ram::Kept);
        assert_eq!(cause(&mut uno), flag, "{reset:?}");
    }
}

#[test]
fn flags_that_nobody_has_cleared_add_up_until_power_on() {
    let mut uno = started();
    uno.reset(ResetCause::External, Ram::Kept);
    uno.reset(ResetCause::BrownOut, Ram::Kept);
    assert_eq!(cause(&mut uno), "06");
    uno.reset(ResetCause::External, Ram::Kept);
    uno.reset(ResetCause::PowerOn, Ram::Kept);
    assert_eq!(cause(&mut uno), "01");
}

#[test]
fn a_program_that_hangs_is_reset_by_its_watchdog() {
    let mut uno = started();
    uno.run_for(3 * HZ).unwrap();
    assert_eq!(uno.watchdog_resets(), 0, "it feeds its watchdog");
    let hung = uno.cycle();
    uno.send(b"h");
    while uno.watchdog_resets() == 0 && uno.cycle() < hung + 2 * HZ {
        uno.run_for(MILLISECOND).unwrap();
    }
    assert_eq!(uno.watchdog_resets(), 1);
    // WDTO_1S is 131072 cycles of an oscillator of 128 kHz: 1.024 s.
    let after = uno.cycle() - hung;
    assert!((HZ..HZ * 11 / 10).contains(&after), "{after} cycles");
    assert_eq!(cause(&mut uno), "08");
    assert_eq!(asked(&mut uno, b"p"), "p");
    uno.send(b"h");
    uno.run_for(HZ * 11 / 10).unwrap();
    assert_eq!(uno.watchdog_resets(), 2, "a second time");
}

#[test]
fn a_watchdog_reset_keeps_the_flags_that_nobody_cleared() {
    let mut uno = started();
    uno.set_ram(uno.symbol("keep_flags").unwrap(), &[0x5A]).unwrap();
    uno.reset(ResetCause::External, Ram::Kept);
    assert_eq!(cause(&mut uno), "02");
    uno.send(b"h");
    uno.run_for(HZ * 12 / 10).unwrap();
    assert_eq!(cause_in(uno.received()), "0A", "EXTRF and WDRF");
}

#[test]
fn the_ram_is_kept_or_full_of_noise_as_asked() {
    let mut uno = started();
    let boots = uno.symbol("boots").unwrap() - 0x100;
    let before = uno.ram()[boots];
    uno.reset(ResetCause::External, Ram::Kept);
    said(&mut uno);
    assert_eq!(uno.ram()[boots], before.wrapping_add(1), "a count in .noinit");

    let noise = |uno: &mut Uno, seed| {
        uno.reset(ResetCause::PowerOn, Ram::Scrambled(seed));
        uno.ram().to_vec()
    };
    let (one, two, again) = (noise(&mut uno, 1), noise(&mut uno, 2), noise(&mut uno, 1));
    assert!(one == again && one != two);
    // 2048 bytes of noise have each value 8 times on average; none comes 40 times.
    let mut often = [0; 256];
    for &byte in &one {
        often[usize::from(byte)] += 1;
    }
    assert!(often.iter().all(|&times| times < 40), "{often:?}");
}

#[test]
fn a_byte_on_its_way_comes_through_a_reset() {
    let mut uno = started();
    uno.send_at(uno.cycle() + 200_000, b'p');
    uno.reset(ResetCause::External, Ram::Kept);
    let said = said(&mut uno);
    assert!(said.starts_with("B02") && said.ends_with('p'), "{said}");
}

#[test]
fn time_goes_on_through_a_reset() {
    let mut uno = started();
    let before = uno.cycle();
    uno.reset(ResetCause::PowerOn, Ram::Scrambled(3));
    assert_eq!(uno.cycle(), before);
    said(&mut uno);
    assert!(uno.cycle() >= before + 20 * MILLISECOND);
}

#[test]
fn a_run_ends_at_its_cycle_although_the_core_sleeps() {
    let mut uno = started();
    for cycles in [1, 10, 1000, 10_000] {
        let end = uno.cycle() + cycles;
        uno.run_until(end).unwrap();
        assert!((end..end + 10).contains(&uno.cycle()), "{} and not {end}", uno.cycle());
    }
}

#[test]
fn a_byte_that_is_being_sent_is_cut_off() {
    let mut uno = started();
    uno.send(b"p");
    uno.run_for(BYTE_CYCLES + BYTE_CYCLES / 2).unwrap();
    uno.reset(ResetCause::External, Ram::Kept);
    assert!(!said(&mut uno).contains('p'));
}

#[test]
fn an_interrupt_that_waits_at_a_reset_waits_no_longer() {
    let mut uno = started();
    uno.send(b"h"); // with interrupts off
    said(&mut uno);
    uno.reset(ResetCause::External, Ram::Kept);
    uno.run_for(HZ).unwrap();
    let times = uno.interrupt_times();
    let overflow = times.iter().find(|time| time.vector == vector::TIMER2_OVF).unwrap();
    assert!(overflow.worst_wait_cycles < 1000, "{overflow:?}");
}
