//! G-code, read by a parser of other people and run by a model of the machine.

use serde_json::{Value, json};
use wirebend_api::{Command, Input, Response, SimulateRequest};
use wirebend_core::bend::Step;
use wirebend_files::document::{Job, JobStep};

use crate::cases::run;
use crate::exports::bounds::{Off, of_corner, of_vertices};
use crate::exports::compared::{Rounding, assert_same_wire, assert_steps, other_hand, path};
use crate::exports::gcode_bender::Bender;
use crate::exports::is_flat;
use crate::exports::planned::{Outcomes, Planned, Wire, each_case};

const MACHINE: &str = "grbl-bender";
/// Three decimals are written: places along the wire and around it to the nearest, and each bend from zero.
const DIGIT: f64 = 1e-3;
const ROUNDING: [Rounding; 3] = [Rounding::Sum, Rounding::Sum, Rounding::Each];

/// Feeds and rotations are differences of two places, each off by half a digit.
fn off(steps: &[Step]) -> Vec<Off> {
    vec![Off { feed_mm: DIGIT, angles_deg: DIGIT + DIGIT / 2.0 }; steps.len()]
}

#[track_caller]
fn assert_is(planned: &Planned, wire: &Wire, steps: &[Step]) {
    assert_steps(&planned.name, steps, &wire.compensated, DIGIT, ROUNDING);
    assert_same_wire(&planned.name, &path(steps), &path(&wire.compensated), &off(steps));
}

/// A fold back has no corner from which a feed could be reckoned, and this machine's feeds are compensated.
#[track_caller]
fn assert_outcomes(outcomes: &Outcomes) {
    outcomes.assert(18, &[("cube-not-doubled", "route"), ("fold-back", "compensated")], &[]);
}

#[test]
fn every_case_is_the_wire_of_its_distances() {
    let outcomes = each_case(MACHINE, "gcode", &Value::Null, |planned, wires, texts| {
        for (wire, text) in wires.iter().zip(texts) {
            assert!(text.lines().any(|line| line == "G91"), "distances: {text}");
            assert_is(planned, wire, &Bender::run(text).steps);
        }
    });
    assert_outcomes(&outcomes);
}

/// With all that a person can put around it: blocks at both ends, numbers on the lines, bends in parts, the pin on
/// another output.
#[test]
fn every_case_is_the_wire_of_its_positions() {
    let settings = json!({
        "mode": "absolute", "moves": "rapid", "line_numbers": true, "comments": "semicolon",
        "arc_step_deg": 40, "arc_dwell_s": 0.1, "pin_out": ["M8"], "pin_in": ["M9"],
        "start_block": ["%", "(wire {wire} of {name}, {steps} steps)", "G92 Y0 (from here)"],
        "end_block": ["G90", "G0 Y0", "M30"],
    });
    let outcomes = each_case(MACHINE, "gcode", &settings, |planned, wires, texts| {
        for (wire, text) in wires.iter().zip(texts) {
            let mut bender = Bender::run(text);
            // The block at the end turns the head back to where it was. After a last feed that counts as its
            // rotation, after a last bend as a step.
            assert!(bender.at()[1].abs() < DIGIT / 2.0, "{:?}", bender.at());
            let last = bender.steps.len() - 1;
            if bender.steps.len() > wire.compensated.len() {
                let back = bender.steps.remove(last);
                assert_eq!((back.feed.mm(), back.bend.deg()), (0.0, 0.0), "{}", planned.name);
            } else {
                bender.steps[last].rotate = wire.compensated[last].rotate;
            }
            assert_is(planned, wire, &bender.steps);
        }
    });
    assert_outcomes(&outcomes);
}

/// What the job's wires are when a perfect machine runs these steps instead of its own: the farthest that a vertex is
/// from the design, for each wire.
fn bent(planned: &Planned, steps: &[Vec<Step>]) -> Vec<f64> {
    let mut contents = planned.contents.clone();
    for (wire, steps) in contents.wires.iter_mut().zip(steps) {
        wire.compensated = steps.iter().map(|&step| JobStep::from(step)).collect();
    }
    let bytes = Job::seal(contents).unwrap().to_bytes().unwrap();
    let job = Input::Bytes { name: "written.wbjob".to_owned(), bytes };
    match run(&Command::Simulate(SimulateRequest::of(job))).unwrap() {
        Response::Simulate(found) => found.wires.iter().map(|wire| wire.worst_systematic_mm).collect(),
        other => panic!("{other:?}"),
    }
}

/// The circle is closed: design, compensated program, G-code, and by way of a perfect machine the design again.
#[test]
fn a_perfect_machine_bends_the_design_from_the_file_and_not_its_mirror_image() {
    let outcomes = each_case(MACHINE, "gcode", &Value::Null, |planned, wires, texts| {
        let steps: Vec<Vec<Step>> = texts.iter().map(|text| Bender::run(text).steps).collect();
        let hands: Vec<Vec<Step>> = steps.iter().map(|steps| other_hand(steps)).collect();
        let found = bent(planned, &steps);
        for ((wire, found), image) in wires.iter().zip(found).zip(bent(planned, &hands)) {
            let bound = of_vertices(&wire.corners, &formed(wire)).into_iter().fold(0.0, f64::max);
            assert!(found <= bound, "{}: {found} mm from the design, more than {bound}", planned.name);
            assert!(is_flat(&planned.name) || image > 10.0 * bound, "{}: {image} mm, {bound}", planned.name);
        }
    });
    assert_outcomes(&outcomes);
}

/// What rounding does to the wire itself. A bend that is off moves its corner, and takes more or less wire: at both
/// ends of a straight part. Springback grows with the bend, so what is left is off by no more than the axis was.
fn formed(wire: &Wire) -> Vec<Off> {
    // Pin of 2 mm and half of 1 mm wire; the neutral fibre lies inside that.
    const RADIUS_MM: f64 = 2.5;
    let corners = wire
        .nominal
        .iter()
        .map(|step| of_corner(RADIUS_MM, step, DIGIT / 2.0) + RADIUS_MM * (DIGIT / 2.0).to_radians());
    let before = std::iter::once(0.0).chain(corners.clone());
    let feeds = before.zip(corners).map(|(before, after)| DIGIT + before + after);
    feeds.map(|feed_mm| Off { feed_mm, angles_deg: DIGIT + DIGIT / 2.0 }).collect()
}
