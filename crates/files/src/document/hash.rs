//! SHA-256 over bytes, and over the canonical form of JSON (RFC 8785), in which two files that say
//! the same are the same.

use serde::Serialize;
use sha2::{Digest, Sha256};

use super::error::DocumentError;

/// The SHA-256 of bytes, as 64 lower-case hexadecimal digits.
#[must_use]
pub fn sha256_hex(bytes: &[u8]) -> String {
    use std::fmt::Write as _;
    let mut hex = String::with_capacity(64);
    for byte in Sha256::digest(bytes) {
        let _ = write!(hex, "{byte:02x}");
    }
    hex
}

/// The SHA-256 of the canonical form of a value.
pub(crate) fn canonical_sha256(value: &impl Serialize) -> Result<String, DocumentError> {
    serde_json_canonicalizer::to_vec(value).map(|bytes| sha256_hex(&bytes)).map_err(DocumentError::Write)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hash_is_sha256() {
        // FIPS 180-2, appendix B.1.
        assert_eq!(sha256_hex(b"abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    }

    #[test]
    fn order_blanks_and_spelling_of_numbers_do_not_change_a_hash() {
        let hash =
            |text: &str| canonical_sha256(&serde_json::from_str::<serde_json::Value>(text).unwrap()).unwrap();
        assert_eq!(hash(r#"{"b": 1.50, "a": 1e1}"#), hash(r#"{"a":10,"b":1.5}"#));
        assert_ne!(hash(r#"{"a": 1}"#), hash(r#"{"a": 1.0000000000000002}"#));
    }
}
