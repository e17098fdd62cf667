#![no_main]

use wirebend_files::read::frame::read_sequence;
use wirebend_files::write::frame::framefab_sequence;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    if let Ok(sequence) = read_sequence(bytes, "fuzz") {
        let again = read_sequence(framefab_sequence(&sequence).as_bytes(), "again");
        assert_eq!(again.unwrap().steps.len(), sequence.steps.len());
    }
});
