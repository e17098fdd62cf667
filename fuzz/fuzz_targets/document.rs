#![no_main]

use wirebend_files::document::Document;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    if let Ok(document) = Document::open(bytes, "fuzz") {
        let again = document.to_bytes().expect("what was opened can be written");
        assert_eq!(Document::open(&again, "fuzz").expect("and opened"), document);
        document.design_hash().expect("and hashed");
    }
});
