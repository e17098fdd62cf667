#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| wirebend_fuzz::loads(bytes));
