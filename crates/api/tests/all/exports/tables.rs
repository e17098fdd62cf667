//! Tables of lengths, rotations and angles, read by our reader.

use serde_json::{Value, json};
use wirebend_api::{ApiError, DesignInput, DriverProblem, PlanningError};
use wirebend_core::bend::Step;
use wirebend_core::units::Length;
use wirebend_files::read::{Format, ReadOptions, read};

use crate::cases::{self, Case, export, texts};
use crate::exports::bounds::{Off, of_corner};
use crate::exports::compared::{Rounding, assert_numbers, assert_same_wire, axes};
use crate::exports::planned::{Outcomes, Wire, each_case};

const MACHINE: &str = "table-bender";
/// Pin of 3 mm and half of 3 mm wire.
const RADIUS_MM: f64 = 4.5;
/// Three decimals.
const DIGIT: f64 = 1e-3;

fn steps_of(format: &str, text: &str) -> Vec<Step> {
    // A YBC table has no radius in it: a person says it.
    let clr = (format == "ybc-csv").then(|| Length::from_mm(RADIUS_MM).unwrap());
    let options = ReadOptions { clr, ..ReadOptions::default() };
    let found = read(text.as_bytes(), "table.csv", Some(Format::Lra), &options)
        .unwrap_or_else(|error| panic!("{format}: {error}\n{text}"));
    found.program.unwrap().program.steps
}

/// The distance from the corner of a bend to the ends of its arc, mm.
fn corner(step: &Step) -> f64 {
    RADIUS_MM * (step.bend.abs().rad() / 2.0).tan()
}

/// Lengths between the ends of the arcs.
fn straights(steps: &[Step]) -> Vec<f64> {
    let before = std::iter::once(0.0).chain(steps.iter().map(corner));
    steps.iter().zip(before).map(|(step, before)| step.feed.mm() - before - corner(step)).collect()
}

/// Distances along the centreline from the start to each bend, the last one to the end.
fn distances(steps: &[Step]) -> Vec<f64> {
    let mut arcs = 0.0;
    let mut sum = 0.0;
    let at = |(straight, step): (f64, &Step)| {
        sum += straight;
        let at = sum + arcs;
        arcs += RADIUS_MM * step.bend.abs().rad();
        at
    };
    straights(steps).into_iter().zip(steps).map(at).collect()
}

/// The read rotations, each in the turn of the one that was meant: 180 and -180 degrees are the same.
fn in_the_same_turn(read: &[f64], meant: &[f64]) -> Vec<f64> {
    read.iter().zip(meant).map(|(read, meant)| read + 360.0 * ((meant - read) / 360.0).round()).collect()
}

/// Bends in one plane add up, and so are rounded in their sum; those in another plane start anew.
fn assert_bends(case: &str, read: &[Step], meant: &[Step]) {
    let mut plane: (Vec<f64>, Vec<f64>) = Default::default();
    let mut side = 1.0;
    for (read, meant) in read.iter().zip(meant) {
        let turned = read.rotate.deg().abs();
        if (turned - 180.0).abs() < DIGIT / 2.0 {
            side = -side;
        } else if turned >= DIGIT / 2.0 {
            plane = Default::default();
        }
        plane.0.push(side * read.bend.deg());
        plane.1.push(side * meant.bend.deg());
        assert_numbers(&format!("{case}: bend"), &plane.0, &plane.1, DIGIT, Rounding::Sum);
    }
}

/// What is measured from one row to the next.
#[derive(Clone, Copy, PartialEq)]
enum Lengths {
    Tangent,
    Corner,
    Distance,
}

#[track_caller]
fn assert_is(case: &str, lengths: Lengths, wire: &Wire, steps: &[Step]) {
    let meant = &wire.nominal;
    let [feeds, rotations, _] = axes(steps);
    let [meant_feeds, meant_rotations, _] = axes(meant);
    let (read_lengths, meant_lengths, rounding) = match lengths {
        Lengths::Tangent => (straights(steps), straights(meant), Rounding::Sum),
        Lengths::Corner => (feeds, meant_feeds, Rounding::Sum),
        Lengths::Distance => (distances(steps), distances(meant), Rounding::Each),
    };
    assert_numbers(&format!("{case}: length"), &read_lengths, &meant_lengths, DIGIT, rounding);
    let rotations = in_the_same_turn(&rotations, &meant_rotations);
    assert_numbers(&format!("{case}: rotation"), &rotations, &meant_rotations, DIGIT, Rounding::Sum);
    assert_bends(case, steps, meant);
    assert_same_wire(case, &wire.made_by(steps), &wire.corners, &off(lengths, meant));
}

/// Each number is the difference of two that are off by half a digit, the angles too. A bend that is off moves the
/// corners at its ends when lengths are measured between arcs, and its own arc when distances are.
fn off(lengths: Lengths, meant: &[Step]) -> Vec<Off> {
    let corners = meant.iter().map(|step| match lengths {
        Lengths::Corner => 0.0,
        Lengths::Tangent => of_corner(RADIUS_MM, step, DIGIT),
        Lengths::Distance => of_corner(RADIUS_MM, step, DIGIT) + RADIUS_MM * DIGIT.to_radians(),
    });
    let before = std::iter::once(0.0).chain(corners.clone());
    let feeds = before.zip(corners).map(|(before, after)| DIGIT + before + after);
    feeds.map(|feed_mm| Off { feed_mm, angles_deg: 2.0 * DIGIT }).collect()
}

fn written(format: &str, settings: &Value, lengths: Lengths) -> Outcomes {
    each_case(MACHINE, format, settings, |planned, wires, texts| {
        for (wire, text) in wires.iter().zip(texts) {
            assert_is(&planned.name, lengths, wire, &steps_of(format, text));
        }
    })
}

const NO_ROUTE: [(&str, &str); 1] = [("cube-not-doubled", "route")];

/// The wire of 140 mm that is bent into a dead end and out again has a bend of half a turn after its second feed, and so
/// no corner from which a straight part could be measured. The arcs of radius 4.5 mm fit between all other bends.
#[test]
fn every_case_is_the_wire_of_its_table() {
    for (format, lengths) in
        [("lra-csv", Lengths::Tangent), ("ybc-csv", Lengths::Tangent), ("cumulative-csv", Lengths::Distance)]
    {
        let outcomes = written(format, &Value::Null, lengths);
        outcomes.assert(18, &NO_ROUTE, &[("fold-back", "no-corner", "wire 1, step 2")]);
        assert!(outcomes.refused["fold-back"].1.contains("180 degrees"), "{format}: {outcomes:?}");
    }
    // The reason, from the designs themselves: half turns, and straight parts that two arcs need.
    each_case(MACHINE, "xyz-csv", &Value::Null, |planned, wires, _| {
        for wire in wires {
            let half_turn = wire.nominal.iter().position(|step| step.bend.deg() > 179.999);
            let expected = (planned.name == "fold-back").then_some(1);
            assert_eq!(half_turn, expected, "{}", planned.name);
            let fits = straights(&wire.nominal).iter().all(|&straight| straight > 0.0);
            assert!(fits || half_turn.is_some(), "{}", planned.name);
        }
    });
}

/// Lengths from corner to corner need no arcs: every wire that has a route can be written so.
#[test]
fn every_case_is_the_wire_of_a_table_of_corners() {
    let settings = json!({"lengths": "intersection", "rotation": "absolute"});
    written("lra-csv", &settings, Lengths::Corner).assert(19, &NO_ROUTE, &[]);
}

/// Right angles on edges of 7.5 mm: each takes 4.5 mm off both its edges, so that the first edge, with one bend at
/// its end, is long enough and the second is not, by 1.5 mm.
#[test]
fn arcs_that_overlap_are_refused_where_they_do() {
    let case = Case::load(&cases::root().join("tests/golden/cube-8-edges"));
    let quarter = || DesignInput { scale: 0.25, ..case.input() };
    let refused = export(quarter(), case.choices(MACHINE), "lra-csv", &Value::Null);
    let Err(ApiError::Planning(PlanningError::Driver(DriverProblem::Unwritten { error, .. }))) = refused
    else {
        panic!("{refused:?}")
    };
    assert_eq!(error.code, "arcs-overlap");
    assert!(
        error.message.starts_with("wire 1, step 2: ") && error.message.contains("by 1.500 mm"),
        "{error}"
    );
    let corners = export(quarter(), case.choices(MACHINE), "lra-csv", &json!({"lengths": "intersection"}));
    assert!(texts(&corners.unwrap())[0].contains("\n7.500,"));
}
