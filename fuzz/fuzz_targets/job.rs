#![no_main]

use wirebend_files::document::Job;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    if let Ok(job) = Job::open(bytes, "fuzz") {
        let again = job.to_bytes().expect("what was opened can be written");
        assert_eq!(Job::open(&again, "fuzz").expect("and opened"), job);
    }
});
