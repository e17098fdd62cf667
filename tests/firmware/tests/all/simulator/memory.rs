//! EEPROM and RAM.

use wirebend_tests_firmware::{Ram, ResetCause};

use super::{asked, said, started};

/// CRC-16 with the polynomial 0x1021 taken bit by bit from the low end, which is avr-libc's `_crc_ccitt_update`.
fn crc(bytes: &[u8]) -> u16 {
    bytes.iter().fold(0xFFFF, |crc, &byte| {
        (0..8).fold(crc ^ u16::from(byte), |crc, _| if crc & 1 == 1 { crc >> 1 ^ 0x8408 } else { crc >> 1 })
    })
}

#[test]
fn the_program_reads_what_the_bench_has_written() {
    let mut uno = started();
    assert_eq!(asked(&mut uno, b"r\x05"), "FF");
    assert_eq!(asked(&mut uno, b"c"), format!("{:04X}", crc(&[0xFF; 64])));
    let bytes: Vec<u8> = (0..64).map(|i| i * 3 + 1).collect();
    uno.set_eeprom(&bytes).unwrap();
    assert_eq!(asked(&mut uno, b"r\x05"), "10"); // 5 x 3 + 1
    assert_eq!(asked(&mut uno, b"c"), format!("{:04X}", crc(&bytes)));
}

#[test]
fn the_bench_reads_what_the_program_has_written_and_resets_keep_it() {
    let mut uno = started();
    uno.send(b"w\x07Z");
    said(&mut uno);
    for cause in [ResetCause::External, ResetCause::PowerOn] {
        assert_eq!((uno.eeprom()[7], uno.eeprom()[8]), (b'Z', 0xFF));
        uno.reset(cause, Ram::Scrambled(5));
        said(&mut uno);
    }
    assert_eq!(asked(&mut uno, b"r\x07"), "5A");
}

#[test]
fn the_stack_leaves_a_trace_in_the_paint() {
    let mut uno = started();
    uno.paint_stack().unwrap();
    let free = uno.untouched_stack().unwrap();
    // 2 KB less 160 bytes of variables and the few that `main` and `get` hold.
    let end = uno.symbol("_end").unwrap();
    assert!(free > 1800 && free <= 0x900 - end, "{free} bytes, {end:#x}");
    said(&mut uno);
    let left = uno.untouched_stack().unwrap();
    // An interrupt pushes the place to return to, the flags and at least three registers.
    assert!(left <= free - 6, "{left} of {free}");
    uno.set_ram(end + 100, &[0]).unwrap();
    assert_eq!(uno.untouched_stack().unwrap(), 100);
}

#[test]
fn variables_are_found_by_name() {
    let mut uno = started();
    let ticks = uno.symbol("boots").unwrap();
    uno.set_ram(ticks, &[41]).unwrap();
    uno.reset(ResetCause::External, Ram::Kept);
    assert_eq!(said(&mut uno), "B022A"); // 42 boots
}
