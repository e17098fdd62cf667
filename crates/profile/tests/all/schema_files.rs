//! The committed JSON Schemas are those of the code.

use expect_test::expect_file;
use wirebend_profile::schema_files;

/// Stale schemas make editors refuse good files. Rewrite them with `UPDATE_EXPECT=1`.
#[test]
fn the_committed_schemas_are_current() {
    for (path, text) in schema_files() {
        let file = format!("{}/../../machine-profiles/{path}", env!("CARGO_MANIFEST_DIR"));
        expect_file![file].assert_eq(&text);
    }
}
