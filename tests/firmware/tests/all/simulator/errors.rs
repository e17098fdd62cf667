//! What the bench says when it cannot do what is asked.

use wirebend_tests_firmware::{Port, Ram, ResetCause, Uno, UnoError, probe};

use super::{MILLISECOND, asked, said, started};

#[test]
fn a_file_that_is_no_avr_program_is_refused_with_its_name() {
    let own = std::env::current_exe().unwrap();
    for file in [own.as_path(), "Cargo.toml".as_ref(), "no such file".as_ref()] {
        let why = Uno::new(file).err().expect("it must be refused");
        assert!(matches!(why, UnoError::NoProgram { .. }));
        assert!(why.to_string().contains(&file.display().to_string()), "{why}");
    }
}

#[test]
fn an_elf_file_cut_short_is_refused() {
    let whole = std::fs::read(probe()).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("cut.elf");
    for length in [20, 51, 52, 200, whole.len() / 2] {
        std::fs::write(&file, &whole[..length]).unwrap();
        assert!(matches!(Uno::new(&file), Err(UnoError::NoProgram { .. })), "{length} bytes");
    }
}

#[test]
fn a_crash_says_when_and_where_and_a_reset_helps() {
    let mut uno = started();
    uno.send(b"j");
    let why = uno.run_for(10 * MILLISECOND).unwrap_err();
    let UnoError::Crashed { cycle, program_counter, .. } = why else { panic!("{why}") };
    assert_eq!(program_counter, 0x6000, "the probe jumps to word 0x3000");
    assert_eq!(cycle, uno.cycle());
    assert!(matches!(uno.run_for(1), Err(UnoError::Crashed { .. })), "and it stays crashed");
    uno.reset(ResetCause::External, Ram::Kept);
    assert!(said(&mut uno).starts_with("B02"));
}

#[test]
fn sleep_without_interrupts_is_an_error() {
    let mut uno = started();
    uno.send(b"z");
    let why = uno.run_for(10 * MILLISECOND).unwrap_err();
    assert!(matches!(why, UnoError::AsleepForEver { .. }), "{why}");
    uno.reset(ResetCause::External, Ram::Kept);
    said(&mut uno);
    assert_eq!(asked(&mut uno, b"p"), "p");
}

#[test]
fn what_does_not_exist_is_refused() {
    let mut uno = started();
    assert!(matches!(uno.set_input(Port::C, 8, true), Err(UnoError::NoBit { bit: 8 })));
    assert!(matches!(uno.symbol("nobody"), Err(UnoError::NoSymbol { .. })));
    assert!(matches!(uno.set_eeprom(&[0; 1025]), Err(UnoError::OutOfMemory { .. })));
    for (address, count) in [(0xFF, 1), (0x8FF, 2), (usize::MAX, 1)] {
        assert!(matches!(uno.set_ram(address, &vec![0; count]), Err(UnoError::OutOfMemory { .. })));
    }
}
