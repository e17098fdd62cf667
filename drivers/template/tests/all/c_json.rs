//! The JSON reader of the driver in C, beside `serde_json`.

#![cfg(unix)] // see c_twin.rs

use proptest::prelude::*;
use serde_json::{Value, json};

use crate::checked::Checked;

/// Documents that stress a reader, good and bad; `serde_json` says which is which.
const DOCUMENTS: &[&str] = &[
    "",
    " ",
    "{}",
    "[]",
    "[[]]",
    "{\"\":{}}",
    "null",
    "true",
    "false",
    " [ 1 , 2 ] \t\r\n",
    "nul",
    "truE",
    "NaN",
    "Infinity",
    "-Infinity",
    "nan",
    "0",
    "-0",
    "-",
    "+1",
    "01",
    "1.",
    ".5",
    "1.5",
    "1e5",
    "1E+05",
    "1e-5",
    "1e",
    "1e+",
    "0x10",
    "1_000",
    "1e308",
    "-1e308",
    "1e309",
    "-1e999",
    "1e-400",
    "123456789012345678901234567890",
    "\"",
    "\"a",
    "\"\\",
    "\"\\\"",
    "\"\\q\"",
    "\"\\u12\"",
    "\"\\u12G4\"",
    "\"\\u00e9\"",
    "\"\\ud83d\\ude00\"",
    "\"\\ud83d\"",
    "\"\\ude00\"",
    "\"\\ud83dx\"",
    "\"\\ud83d\\u0041\"",
    "\"\\ud83d\\n\"",
    "\"\\u0000\"",
    "\"\\b\\f\\n\\r\\t\\/\\\\\\\"\"",
    "\"tab\there\"",
    "\"line\nend\"",
    "\"\u{7f}\"",
    "\"größer \u{1f600}\"",
    "'a'",
    "[1,]",
    "[,1]",
    "[1 2]",
    "[1",
    "{\"a\"}",
    "{\"a\":}",
    "{\"a\":1,}",
    "{a:1}",
    "{1:1}",
    "{\"a\" 1}",
    "{\"a\":1 \"b\":2}",
    "{\"a\":1",
    "{\"a",
    "]",
    "}",
    "[}",
    "{]",
    "1 2",
    "{} x",
    "[1]]",
    "/* c */ 1",
    "// c\n1",
    "\u{feff}1",
    "{\"a\":[1,{\"b\":null}],\"c\":\"d\"}",
];

/// Bytes that are no UTF-8, inside a text: stray, missing, too long, surrogate, beyond the last character.
const NOT_UTF8: &[&[u8]] = &[
    b"\x80",
    b"\xff",
    b"\xc3",
    b"\xc3(",
    b"\xc0\x80",
    b"\xc1\xbf",
    b"\xe0\x80\x80",
    b"\xe2\x82",
    b"\xed\xa0\x80",
    b"\xf0\x80\x80\x80",
    b"\xf0\x9f\x98",
    b"\xf4\x90\x80\x80",
    b"\xf8\x88\x80\x80\x80",
];

/// Whether two values are the same; numbers up to the last digits, since `serde_json` does not promise them.
fn same(a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::Number(a), Value::Number(b)) => {
            let (a, b) = (a.as_f64().unwrap(), b.as_f64().unwrap());
            (a - b).abs() <= 1e-15 * a.abs()
        }
        (Value::Array(a), Value::Array(b)) => a.len() == b.len() && a.iter().zip(b).all(|(a, b)| same(a, b)),
        (Value::Object(a), Value::Object(b)) => {
            a.len() == b.len() && a.iter().all(|(key, a)| b.get(key).is_some_and(|b| same(a, b)))
        }
        (a, b) => a == b,
    }
}

/// Holds the reader to what `serde_json` makes of the same bytes.
#[track_caller]
fn assert_as_serde(c: &mut Checked, bytes: &[u8]) {
    let (read, answer) = c.ask_with("json", bytes);
    let shown = || format!("{} -> {}", String::from_utf8_lossy(bytes), String::from_utf8_lossy(&answer));
    match serde_json::from_slice::<Value>(bytes) {
        Ok(value) => {
            assert!(read, "good, and refused: {}", shown());
            assert!(same(&value, &serde_json::from_slice(&answer).unwrap()), "{}", shown());
        }
        Err(_) => assert!(!read, "bad, and read: {}", shown()),
    }
}

#[test]
fn good_and_bad_are_told_apart() {
    let mut c = Checked::start();
    for document in DOCUMENTS {
        assert_as_serde(&mut c, document.as_bytes());
        // As a value inside something, and cut off at every byte.
        assert_as_serde(&mut c, format!("{{\"key\":[{document}]}}").as_bytes());
        for len in 0..document.len() {
            assert_as_serde(&mut c, &document.as_bytes()[..len]);
        }
    }
    for bytes in NOT_UTF8 {
        assert_as_serde(&mut c, &[b"[\"", *bytes, b"\"]"].concat());
        assert_as_serde(&mut c, &[b"[\"", *bytes].concat());
    }
}

#[test]
fn limits_are_limits() {
    let mut c = Checked::start();
    let mut read = |text: &str| c.ask_with("json", text.as_bytes()).0;
    let nested = |depth: usize| format!("{}1{}", "[".repeat(depth), "]".repeat(depth));
    assert!(read(&nested(63)) && !read(&nested(64)) && !read(&"[{\"a\":".repeat(100_000)));
    let number = |digits: usize| format!("0.{}", "3".repeat(digits - 2));
    assert!(read(&number(400)) && !read(&number(401)) && !read(&number(1_000_000)));
    let object = |keys: usize| {
        let members: Vec<String> = (0..keys).map(|key| format!("\"{key}\":0")).collect();
        format!("{{{}}}", members.join(","))
    };
    assert!(read(&object(256)) && !read(&object(257)));
    assert!(
        !read("{\"a\":1,\"b\":2,\"a\":3}")
            && !read("{\"a\":1,\"\\u0061\":2}")
            && read("[{\"a\":1},{\"a\":1}]")
    );
}

/// A program that has set a locale with a decimal comma must not turn 1.5 mm into 1 mm.
#[test]
fn a_decimal_comma_of_the_locale_changes_nothing() {
    let mut c = Checked::start();
    c.ask("point ,");
    assert_eq!(c.ask_with("json", b"[1.5,-2.25e1,3]"), (true, b"[1.5,-22.5,3]".to_vec()));
    assert!(!c.ask_with("json", b"1,5").0);
}

#[test]
fn the_place_of_an_error_is_told() {
    let mut c = Checked::start();
    let mut said = |text: &str| String::from_utf8(c.ask_with("json", text.as_bytes()).1).unwrap();
    assert_eq!(said("{\"a\": 1, \"b\" 2}"), "13: expected ':' behind a key");
    assert_eq!(said("[1, 2"), "5: expected ',' or ']'");
}

fn any_value() -> impl Strategy<Value = Value> {
    let leaf = prop_oneof![
        Just(Value::Null),
        any::<bool>().prop_map(Value::from),
        (-1e300..1e300_f64).prop_map(|number| json!(number)),
        any::<i32>().prop_map(Value::from),
        any::<String>().prop_map(Value::from),
    ];
    leaf.prop_recursive(5, 60, 8, |inside| {
        prop_oneof![
            prop::collection::vec(inside.clone(), 0..8).prop_map(Value::from),
            prop::collection::btree_map(any::<String>(), inside, 0..8)
                .prop_map(|members| members.into_iter().collect()),
        ]
    })
}

proptest! {
    /// One process for all values of a case: starting it takes longer than reading.
    #[test]
    fn any_document_is_read_as_it_was_written(values in prop::collection::vec(any_value(), 10)) {
        let mut c = Checked::start();
        for value in values {
            assert_as_serde(&mut c, value.to_string().as_bytes());
            assert_as_serde(&mut c, serde_json::to_string_pretty(&value).unwrap().as_bytes());
        }
    }

    #[test]
    fn any_damage_is_seen_as_serde_sees_it(
        value in any_value(),
        damage in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 40),
    ) {
        let mut c = Checked::start();
        let whole = value.to_string().into_bytes();
        for (at, byte) in damage {
            let mut bytes = whole.clone();
            let at = at.index(bytes.len());
            bytes[at] = byte;
            // A key that is twice is refused here and overwritten there: both are in order.
            let (read, answer) = c.ask_with("json", &bytes);
            if read || !answer.ends_with(b"every key once in its object") {
                assert_as_serde(&mut c, &bytes);
            }
        }
    }
}
