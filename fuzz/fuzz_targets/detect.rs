#![no_main]

use wirebend_files::read::{ReadOptions, detect, read};

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    if let Ok(format) = detect("fuzz.txt", bytes) {
        let _ = read(bytes, "fuzz.txt", Some(format), &ReadOptions::default());
    }
});
