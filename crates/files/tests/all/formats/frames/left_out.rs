//! What no frame can be made of.

use serde_json::{Value, json};

use crate::formats::{data, import, notes};

/// Counted from 0 as the entries of its lists, and by its line in a text.
#[test]
fn what_no_frame_can_be_made_of_is_named() {
    let mut model: Value = serde_json::from_slice(&data("conmech/four-frame.json").0).unwrap();
    let (doubled, mut flat) = (model["elements"][1].clone(), model["elements"][0].clone());
    flat["end_node_inds"] = json!([2, 2]);
    model["elements"].as_array_mut().unwrap().extend([doubled, flat]);
    let mut loose = model["nodes"][0].clone();
    (loose["node_ind"], loose["point"]) = (json!(8), json!([9.0, 9.0, 0.0]));
    model["nodes"].as_array_mut().unwrap().push(loose);
    model["supports"]
        .as_array_mut()
        .unwrap()
        .push(json!({"condition": [true, true, true, true, true, true], "node_ind": 8}));
    let found = notes(&import("a.json", model.to_string()).unwrap().notes);
    for expected in [
        "1 support that no strut ends at dropped (node 5)",
        "1 duplicate edge merged (element 4)",
        "1 edge without length dropped (element 5)",
    ] {
        assert!(found.iter().any(|note| note == expected), "{found:?}");
    }

    let text = "v 0 0 0\nv 0 0 9\nv 0 9 9\nv 4 4 4\nl 1 2 3\nl 2 1\nl 3 2\nl 3 3\np 1 1\n";
    assert_eq!(
        notes(&import("a.pwf", text).unwrap().notes),
        [
            "units not given: taken as mm",
            "1 unused vertex dropped (line 4)",
            "2 duplicate edges merged (the first: line 6)",
            "2 edges without length dropped (the first: line 8)",
        ]
    );
}
