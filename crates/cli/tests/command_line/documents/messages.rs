//! Blocks of `json NAME`: messages of the boundary to drivers, a line each, compared with the committed schema of that name.

use serde_json::Value;

use crate::documents::{assert_none, documents, root};

#[test]
fn every_message_of_a_driver_fits_its_schema() {
    let mut wrong = Vec::new();
    let mut compared = 0;
    for document in documents() {
        for block in document.blocks.iter().filter(|block| block.language == "json") {
            let name = block.name.as_deref().unwrap_or_default();
            let text = block.lines.join("\n");
            if name.contains('.') {
                // A file that later commands read.
                if let Err(error) = serde_json::from_str::<Value>(&text) {
                    wrong.push(format!("{}: {error}", document.at(block.line)));
                }
                continue;
            }
            let file = root().join(format!("crates/driver-api/schema/{name}.schema.json"));
            let schema = std::fs::read(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
            let validator = jsonschema::validator_for(&serde_json::from_slice(&schema).unwrap()).unwrap();
            let messages = serde_json::Deserializer::from_str(&text).into_iter::<Value>();
            for message in messages {
                compared += 1;
                match message {
                    Ok(message) => {
                        let errors = validator.iter_errors(&message);
                        wrong.extend(
                            errors.map(|error| format!("{}: {error} in {message}", document.at(block.line))),
                        );
                    }
                    Err(error) => wrong.push(format!("{}: {error}", document.at(block.line))),
                }
            }
        }
    }
    assert_none(&wrong);
    assert!(compared > 20, "the messages of docs/drivers.md were not found");
}
