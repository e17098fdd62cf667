//! What is refused: by key, or by wire and step, with what to do.

use serde_json::{Value, json};
use wirebend_driver_api::conformance::sample_job;
use wirebend_driver_api::{DriverError, Job, MachineDriver};
use wirebend_driver_tables::Settings;

use crate::{job_of, open, table};

const STRAIGHT: (f64, f64, f64) = (50.0, 0.0, 0.0);

fn refusal(format: &str, settings: Value, job: &Job) -> DriverError {
    open(settings).unwrap().encode(format, job).unwrap_err()
}

fn settings_refused(settings: Value, expected: &str) {
    let error = open(settings).unwrap_err();
    assert_eq!((error.code.as_str(), error.message.as_str()), ("settings", expected));
    assert!(!error.help.is_empty(), "{error}");
}

/// Arcs that overlap cannot be made, and a negative length would pull the wire back.
#[test]
fn arcs_that_overlap_are_refused_where_lengths_are_between_them() {
    // 10·tan 45° from both ends of 15 mm is 5 mm too much.
    let job = job_of(10.0, &[(50.0, 0.0, 90.0), (15.0, 0.0, 90.0), STRAIGHT]);
    for format in ["lra-csv", "ybc-csv", "cumulative-csv"] {
        let error = refusal(format, json!({}), &job);
        assert_eq!(error.code, "arcs-overlap");
        let expected = "wire 1, step 2: the arcs of radius 10 mm at its ends overlap by 5.000 mm";
        assert_eq!(error.message, expected);
        assert!(error.help.contains("'lengths' to intersection"), "{error}");
    }
    let corners = json!({"lengths": "intersection", "header": false, "decimals": 0});
    assert_eq!(table("ybc-csv", corners, &job), "50,0,90\n15,0,90\n50,,\n");
    let angles = json!({"columns": ["A"], "header": false, "decimals": 0});
    assert_eq!(table("ybc-csv", angles, &job), "90\n90\n\n", "no lengths are asked for");
}

/// Arcs that just meet leave a length of zero, whatever the last bits of a float say.
#[test]
fn arcs_that_just_meet_are_written() {
    let mut job = job_of(10.0, &[(50.0, 0.0, 90.0), (20.0, 0.0, 90.0), STRAIGHT]);
    job.wires[0].design[1].straight_mm = Some(-1e-9);
    assert_eq!(table("ybc-csv", json!({"decimals": 0}), &job), "40,0,90\n0,0,90\n40,,\n");
}

#[test]
fn a_bend_of_180_degrees_has_no_length_beside_it() {
    let job = job_of(2.0, &[STRAIGHT, (50.0, 0.0, 180.0), STRAIGHT]);
    let error = refusal("lra-csv", json!({}), &job);
    assert_eq!(error.code, "no-corner");
    assert!(error.message.starts_with("wire 1, step 2: there is no length"), "{error}");
    assert!(error.help.contains("'lengths' to intersection"), "{error}");
}

#[test]
fn the_second_wire_is_named_as_such() {
    let mut job = job_of(2.0, &[STRAIGHT]);
    job.wires.push(job_of(10.0, &[(5.0, 0.0, 90.0), STRAIGHT]).wires.remove(0));
    assert!(refusal("lra-csv", json!({}), &job).message.starts_with("wire 2, step 1: "));
}

#[test]
fn values_that_are_no_numbers_are_named() {
    for (step, what) in [
        ((f64::NAN, 0.0, 0.0), "feed is NaN"),
        ((50.0, f64::INFINITY, 0.0), "rotate is inf"),
        ((50.0, 0.0, f64::NEG_INFINITY), "bend is -inf"),
    ] {
        let error = refusal("lra-csv", json!({"lengths": "intersection"}), &job_of(2.0, &[STRAIGHT, step]));
        assert_eq!(error.code, "not-a-number");
        assert_eq!(error.message, format!("wire 1, step 2: {what}, expected a number"));
    }
    let mut job = job_of(2.0, &[STRAIGHT, STRAIGHT]);
    job.wires[0].design[1].straight_mm = Some(f64::NAN);
    assert!(refusal("ybc-csv", json!({}), &job).message.contains("step 2: straight is NaN"));
    job.wires[0].path_mm = vec![[0.0; 3], [1.0, f64::NAN, 0.0]];
    let error = refusal("xyz-csv", json!({}), &job);
    assert_eq!(error.message, "wire 1, point 2: y is NaN, expected a number");
}

#[test]
fn what_is_no_wire_is_refused() {
    let intersection = || json!({"lengths": "intersection"});
    let error = refusal("lra-csv", intersection(), &job_of(2.0, &[(-1.0, 0.0, 0.0)]));
    assert_eq!(error.code, "negative-length");
    assert_eq!(error.message, "wire 1, step 1: the length is -1 mm, expected 0 or more");
    let error = refusal("lra-csv", intersection(), &job_of(2.0, &[(50.0, 0.0, 200.0), STRAIGHT]));
    assert_eq!(error.code, "bend-range");
    assert_eq!(error.message, "wire 1, step 1: the bend is 200 degrees, expected -180 to 180");
    let mut job = job_of(2.0, &[]);
    assert_eq!(refusal("lra-csv", json!({}), &job).message, "wire 1 has no steps, expected one at least");
    job.wires[0].path_mm.clear();
    let error = refusal("xyz-csv", json!({}), &job);
    assert_eq!(
        (error.code.as_str(), error.message.as_str()),
        ("empty-wire", "wire 1 has no points, expected one at least")
    );
    for radius in [-1.0, f64::NAN] {
        assert_eq!(refusal("lra-csv", json!({}), &job_of(radius, &[STRAIGHT])).code, "bend-radius");
    }
}

/// Beyond 15 digits a float cannot distinguish neighbours, and the last digits would be invented.
#[test]
fn more_digits_than_there_are_is_refused() {
    let job = job_of(2.0, &[(900_000.0, 0.0, 90.0), (900_000.0, 0.0, 0.0)]);
    let error = refusal("lra-csv", json!({"decimals": 9, "lengths": "intersection"}), &job);
    assert_eq!(error.code, "too-long");
    assert!(error.message.starts_with("wire 1: 1800000 mm with 9 decimals"), "{error}");
    table("lra-csv", json!({"decimals": 8}), &job);
    let mut far = sample_job();
    far.wires[0].path_mm[1][2] = -2e6;
    assert!(refusal("xyz-csv", json!({"decimals": 9}), &far).message.contains("-2000000 mm"));
}

#[test]
fn settings_that_make_no_sense_are_named() {
    settings_refused(json!({"decimals": 10}), "'decimals' is 10; it can be 0 to 9");
    let both = "'separator' is comma and 'decimal_mark' is comma: nobody could tell them apart";
    settings_refused(json!({"separator": "comma", "decimal_mark": "comma"}), both);
    settings_refused(json!({"separator": "comma", "preset": "decimal-comma"}), both);
    settings_refused(json!({"columns": []}), "'columns' is an empty list");
    settings_refused(json!({"columns": ["L", "CLR", "L"]}), "'columns' lists \"L\" twice");
    settings_refused(json!({"point_columns": ["X", "X"]}), "'point_columns' lists \"X\" twice");
    settings_refused(
        json!({"header_names": ["a", "b", "c"]}),
        "'header_names' is set and 'columns' is not: the formats have different columns",
    );
    settings_refused(
        json!({"columns": ["L", "A"], "header_names": ["a"]}),
        "the length of 'header_names' is 1, expected 2",
    );
    settings_refused(
        json!({"preset": "numbered", "header_names": ["a"]}),
        "the length of 'header_names' is 1, expected 5",
    );
    settings_refused(
        json!({"point_header_names": ["a"]}),
        "the length of 'point_header_names' is 1, expected 3",
    );
    for name in ["a,b", "a\"b", "a\nb"] {
        let expected = format!(
            "'header_names' has the name {name:?} with a separator, a quotation mark or a control character in it"
        );
        settings_refused(json!({"columns": ["L"], "header_names": [name]}), &expected);
    }
    // A comma is an ordinary character where cells are parted by something else.
    open(json!({"columns": ["L"], "header_names": ["a,b"], "separator": "tab"})).unwrap();
}

#[test]
fn words_and_formats_that_are_not_there_are_named() {
    let unknown = |settings: Value| serde_json::from_value::<Settings>(settings).unwrap_err().to_string();
    assert!(unknown(json!({"columns": ["Y"]})).contains("`CLR`"));
    assert!(unknown(json!({"preset": "acme-3000"})).contains("`mil-d-9898`"));
    assert!(unknown(json!({"colums": ["L"]})).contains("`columns`"));
    let error = refusal("pensa-script", json!({}), &sample_job());
    assert_eq!(error.code, "unknown-format");
    assert!(error.help.contains("lra-csv, ybc-csv, xyz-csv, cumulative-csv"), "{error}");
}

#[test]
fn the_driver_opens_with_nothing_set() {
    let driver = wirebend_driver_tables::Tables::open(Settings::default()).unwrap();
    assert_eq!(driver.encode("lra-csv", &sample_job()).unwrap().notes, []);
}
