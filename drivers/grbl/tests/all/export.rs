//! What is written, line by line.

use serde_json::{Value, json};
use wirebend_driver_api::conformance::sample_job;
use wirebend_driver_api::{DriverError, Job, MachineDriver, Step};
use wirebend_driver_grbl::Grbl;

fn encode(settings: Value, job: &Job) -> Result<String, DriverError> {
    let driver = Grbl::open(serde_json::from_value(settings).expect("settings")).expect("they make sense");
    let mut encoded = driver.encode("gcode", job)?;
    assert_eq!(encoded.files.len(), job.wires.len());
    Ok(encoded.files.remove(0).text)
}

fn written(settings: Value, job: &Job) -> Vec<String> {
    encode(settings, job).unwrap().lines().map(str::to_owned).collect()
}

/// A job with these steps of a machine.
fn job(steps: &[(f64, f64, f64)]) -> Job {
    let mut job = sample_job();
    let step = |&(feed_mm, rotate_deg, bend_deg): &(f64, f64, f64)| Step {
        feed_mm,
        rotate_deg,
        bend_deg,
        approach_deg: None,
    };
    job.wires[0].machine = Some(steps.iter().map(step).collect());
    job
}

/// The lines between the start and the end that are no comments.
fn moves(settings: Value, steps: &[(f64, f64, f64)]) -> Vec<String> {
    let lines = written(settings, &job(steps));
    let begin = lines.iter().position(|line| line == "(step 1)").expect("the first step");
    lines[begin..].iter().filter(|line| !line.starts_with('(')).cloned().collect()
}

#[test]
fn a_corner_is_written_as_the_readme_shows_it() {
    let lines = written(json!({}), &job(&[(60.0, 0.0, 90.0), (40.0, -90.0, -45.0), (70.0, 0.0, 0.0)]));
    let head = format!(
        "(WireBend-kit G-code: mm and degrees)\n(name sample)\n(design {})\n(job {})\n(machine sample-bender)\n\
         (material steel-2mm)\n(wire 1, 3 steps)\n(stock 420 mm)\n",
        "a5".repeat(32),
        "5a".repeat(32)
    );
    let body = "\
G21
G94
G91
M5
G4 P0.3
(step 1)
G1 X60.000 F500
M3 S1000
G4 P0.3
G1 Z90.000 F500
G1 Z-90.000 F500
M5
G4 P0.3
(step 2)
G1 X40.000 F500
G1 Y-90.000 F500
M3 S1000
G4 P0.3
G1 Z-45.000 F500
G1 Z45.000 F500
M5
G4 P0.3
(step 3)
G1 X70.000 F500";
    assert_eq!(lines.join("\n"), head + body);
    let readme = include_str!("../../README.md");
    for line in body.lines() {
        assert!(readme.contains(line), "README.md lacks {line}");
    }
}

#[test]
fn positions_count_from_the_start_and_the_bend_axis_goes_back_to_zero() {
    let settings = json!({"mode": "absolute", "decimals": 1, "pin_dwell_s": 0, "moves": "rapid"});
    let lines = written(settings.clone(), &job(&[(1.0, 0.0, 0.0)]));
    assert!(lines.join("\n").contains("G90\nG92 X0 Y0 Z0\nM5\n(step 1)\nG0 X1.0"));
    assert_eq!(
        moves(settings, &[(60.0, 30.0, 90.0), (40.0, 30.0, -45.0), (5.0, 0.0, 0.0)]),
        [
            "G0 X60.0",
            "G0 Y30.0",
            "M3 S1000",
            "G0 Z90.0",
            "G0 Z0.0",
            "M5",
            "G0 X100.0",
            "G0 Y60.0",
            "M3 S1000",
            "G0 Z-45.0",
            "G0 Z0.0",
            "M5",
            "G0 X105.0"
        ]
    );
}

#[test]
fn a_bend_axis_that_stays_counts_on() {
    let settings = json!({"mode": "absolute", "decimals": 0, "pin_dwell_s": 0, "bend_returns": false});
    let lines = moves(settings, &[(0.0, 0.0, 90.0), (0.0, 0.0, -45.0)]);
    assert_eq!(lines, ["M3 S1000", "G1 Z90 F500", "M5", "M3 S1000", "G1 Z45 F500", "M5"]);
}

#[test]
fn a_large_bend_is_made_in_parts() {
    let settings =
        json!({"arc_step_deg": 40, "arc_dwell_s": 0.25, "pin_out": [], "pin_in": [], "decimals": 2});
    assert_eq!(
        moves(settings, &[(0.0, 0.0, -100.0)]),
        // 100 degrees are three parts of 33.33…; the last one ends at 100.
        ["G1 Z-33.33 F500", "G4 P0.25", "G1 Z-33.34 F500", "G4 P0.25", "G1 Z-33.33 F500", "G1 Z100.00 F500"]
    );
}

#[test]
fn rounding_is_made_up_for_and_nothing_is_written_of_nothing() {
    // Fed in all: 0.4 → 0, 0.8 → 1, 1.2 → 1, 1.6 → 2, 2.0 → 2. Rotated: -0.2 → 0, -0.4 → 0, -0.6 → -1, -0.8 → -1,
    // -1.0 → -1. So one unit each in steps 1 and 3, and in step 2. Never a move by zero, nor by minus zero.
    let lines = moves(json!({"decimals": 0}), &[(0.4, -0.2, 0.1); 5]);
    assert_eq!(lines, ["G1 X1 F500", "G1 Y-1 F500", "G1 X1 F500"]);
    // Bends go back, so that each is rounded by itself: small ones do not add up to one that is not wanted.
    assert_eq!(moves(json!({"decimals": 0}), &[(0.0, 0.0, 0.4); 9]), Vec::<String>::new());
}

#[test]
fn units_of_the_machine_are_those_of_its_settings() {
    let settings = json!({
        "feed_units_per_mm": 0.5, "bend_units_per_deg": 2, "feed_axis": "A", "bend_axis": "X", "pin_out": ["M8"],
        "pin_in": ["M9"], "pin_dwell_s": 0, "feed_rate_mm_per_min": 1200.5, "bend_rate_deg_per_min": 90
    });
    assert_eq!(
        moves(settings, &[(60.0, 5.0, 45.0)]),
        ["G1 A30.000 F600.25", "G1 Y5.000 F500", "M8", "G1 X90.000 F180", "G1 X-90.000 F180", "M9"]
    );
}

#[test]
fn blocks_are_filled_and_lines_are_numbered() {
    let settings = json!({
        "comments": "none", "line_numbers": true, "pin_in": [],
        "start_block": ["%", "(for {machine})", "(wire {wire} of {name})", "M8 ; {design}", "N7 G4 P{steps}"],
        "end_block": ["G0 X{stock_mm}", "M30"]
    });
    let lines = written(settings, &job(&[(1.0, 0.0, 0.0)]));
    let design = "a5".repeat(32);
    assert_eq!(
        lines,
        [
            "%",
            "(for sample-bender)",
            "(wire 1 of sample)",
            &format!("N1 M8 ; {design}"),
            "N7 G4 P1",
            "N2 G21",
            "N3 G94",
            "N4 G91",
            "N5 G1 X1.000 F500",
            "N6 G0 X420.000",
            "N7 M30"
        ]
    );
}

/// A length of 0 that was not meant could move the machine, as in `G0 X{stock_mm}`.
#[test]
fn a_stock_that_is_not_known_is_not_written() {
    let mut job = job(&[(1.0, 0.0, 0.0)]);
    let block = json!({"end_block": ["M9", "G0 X{stock_mm}"]});
    for (stock_mm, part) in [
        (None, "the stock of this wire is not known"),
        (Some(0.0), "the stock of this wire is 0 mm"),
        (Some(-1.0), "the stock of this wire is -1 mm"),
        (Some(f64::NAN), "the stock of this wire is NaN mm"),
        (Some(1e9), "the stock of this wire is 1000000000 mm"),
    ] {
        job.wires[0].stock_mm = stock_mm;
        let error = encode(block.clone(), &job).expect_err("no stock");
        assert_eq!(error.code, "no-stock");
        assert!(error.message.starts_with("wire 1: 'end_block', line 2 has {stock_mm}, and "), "{error}");
        assert!(error.message.contains(part), "{error}");
        assert!(error.help.contains("take {stock_mm} out"), "{error}");
    }
    // It is no affair of a program that does not name it.
    job.wires[0].stock_mm = None;
    assert!(!encode(json!({}), &job).unwrap().contains("stock"));
}

#[test]
fn comments_can_be_marked_otherwise() {
    let lines = written(json!({"comments": "semicolon"}), &sample_job());
    assert!(lines.contains(&format!("; design {}", "a5".repeat(32))));
    assert!(!lines.iter().any(|line| line.contains('(')));
    let bare = written(json!({"comments": "none"}), &sample_job());
    assert!(bare.iter().all(|line| line.starts_with(['G', 'M'])), "{bare:?}");
}

#[test]
fn no_name_becomes_a_command() {
    let mut job = sample_job();
    let evil = ")\nG0 X999\r(; \u{18} ! ~ ? \u{85} M3 S1000 ü {design}";
    job.name = evil.to_owned();
    job.design_hash = evil.to_owned();
    job.machine.id = evil.to_owned();
    job.material.id = evil.to_owned();
    let block = json!(["({name} {wire})", "; {machine}"]);
    for comments in ["parentheses", "semicolon"] {
        let text = encode(json!({"comments": comments, "start_block": block}), &job).unwrap();
        assert!(text.bytes().all(|byte| byte == b'\n' || (b' '..=b'~').contains(&byte)), "{text}");
        assert!(!text.contains(['!', '~', '?']), "{text}");
        let program = gcode::parse(&text).expect("it can be parsed");
        let codes = program.blocks.iter().flat_map(|block| &block.codes);
        assert!(!codes.map(ToString::to_string).any(|code| code.contains("999")), "{text}");
        // Name, design, machine and material of the head, name and machine of the block.
        assert_eq!(text.lines().filter(|line| line.contains("X999")).count(), 6, "in comments only: {text}");
        assert!(text.lines().filter(|line| line.contains("X999")).all(|line| line.starts_with(['(', ';'])));
    }
}

#[test]
fn a_step_that_cannot_be_written_is_named() {
    let refused =
        |steps: &[(f64, f64, f64)]| encode(json!({}), &job(steps)).expect_err("not writable").to_string();
    let said = refused(&[(1.0, 0.0, 0.0), (f64::NAN, 0.0, 0.0)]);
    assert!(said.starts_with("wire 1, step 2 cannot be written: its feed is NaN"), "{said}");
    let said = refused(&[(0.0, f64::INFINITY, 0.0)]);
    assert!(said.starts_with("wire 1, step 1 cannot be written: its rotation is inf"), "{said}");
    let said = refused(&[(9e5, 0.0, 0.0), (9e5, 0.0, 0.0)]);
    assert!(said.contains("step 2 cannot be written: its feed ends at 1800000 units"), "{said}");
}
