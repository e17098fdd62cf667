//! What is left of a wire as a record for later.

use serde_json::{Value, json};
use wirebend_driver_host::jobs::{Outcome, Record};

use super::Ticking;
use super::shop::{STEPS, Shop};

#[test]
fn a_record_tells_what_became_of_a_wire() {
    let folder = tempfile::tempdir().unwrap();
    let shop = Shop::at(folder.path());
    let mut run = shop.program(json!({"faults": [{"at": 2, "how": "reset"}]}), Box::new(Ticking::default()));
    shop.look_and_start(&mut run);
    super::drive(&mut run);
    assert_eq!(run.record().unwrap().outcome, Outcome::Unfinished);
    drop(run);
    // A program looks how it stands, and leaves it at that.
    drop(shop.program(json!({}), Box::new(Ticking::default())));
    let mut run = shop.program(json!({}), Box::new(Ticking::default()));
    shop.look_and_start(&mut run);
    super::drive(&mut run);
    run.note_made(Vec::new(), Some(vec![0.0, 0.25])).unwrap();
    let record = run.record().unwrap();
    assert_eq!(
        (record.outcome, record.made, record.ended.as_deref()),
        (Outcome::Finished, STEPS, Some("noon"))
    );
    assert_eq!(record.interruptions.len(), 1, "{record:?}");
    assert!(record.interruptions[0].what.contains("as it was told to"), "{record:?}");
    assert_eq!((record.decisions[0].step, record.decisions[0].made), (2, false), "{record:?}");
    assert_eq!(record.deviations_mm, Some(vec![0.0, 0.25]));

    let path = Record::path_beside(&shop.journal_path());
    assert!(path.ends_with("wire-0.record.json"), "{}", path.display());
    record.write(&path).unwrap();
    let text = std::fs::read_to_string(path).unwrap();
    assert_eq!(serde_json::from_str::<Record>(&text).unwrap(), record);
    // Every key is in the schema, and no other is allowed.
    let schema = Record::schema();
    let keys: Value = serde_json::from_str(&text).unwrap();
    assert_eq!(schema["additionalProperties"], false);
    assert!(keys.as_object().unwrap().keys().all(|key| schema["properties"].get(key).is_some()), "{schema}");
}

#[test]
fn a_wire_that_was_given_up_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let shop = Shop::at(folder.path());
    let mut run = shop.program(json!({"faults": [{"at": 3, "how": "reset"}]}), Box::new(Ticking::default()));
    shop.look_and_start(&mut run);
    super::drive(&mut run);
    run.abandon().unwrap();
    let record = run.record().unwrap();
    assert_eq!((record.outcome, record.made), (Outcome::Abandoned, 2));
    assert!(run.advance().unwrap().is_empty() && run.is_over());
}
