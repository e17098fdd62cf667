//! Documents and jobs fit the schemas that are committed.

use expect_test::expect_file;
use serde_json::json;
use wirebend_core::mesh::Stencil;
use wirebend_files::document::{Job, StencilSource, schemas};

use super::example;
use super::jobs::example_job;

#[test]
fn the_schemas_are_the_committed_ones() {
    for (name, text) in schemas() {
        let path = format!("{}/schema/{name}", env!("CARGO_MANIFEST_DIR"));
        expect_file![path].assert_eq(&text);
    }
}

#[test]
fn documents_fit_their_schemas_and_strangers_do_not() {
    let mut packed = example();
    packed.add_stencil("bunny.stl".into(), StencilSource::Embedded(Stencil::default().into()));
    let job = Job::seal(example_job()).unwrap().to_bytes().unwrap();
    for ((name, schema), file) in schemas().into_iter().zip([job, packed.to_bytes().unwrap()]) {
        let validator = jsonschema::validator_for(&serde_json::from_str(&schema).unwrap()).unwrap();
        let mut value: serde_json::Value = serde_json::from_slice(&file).unwrap();
        assert!(validator.is_valid(&value), "{name}: {:?}", validator.iter_errors(&value).next());
        value["version"] = json!(2);
        assert!(!validator.is_valid(&value), "{name} is of version 1");
        value["version"] = json!(1);
        value["colour"] = json!("red");
        assert!(!validator.is_valid(&value), "{name} has no unknown keys");
    }
}
