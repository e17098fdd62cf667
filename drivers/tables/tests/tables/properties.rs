//! What holds for every wire, read back by a few lines that know nothing of the writer.

use proptest::prelude::*;
use serde_json::{Value, json};
use wirebend_driver_api::{DesignStep, Job};

use crate::{job_of, table};

const RADIUS: f64 = 1.5;

/// Steps with room for arcs of [`RADIUS`], and turns that round to nothing, to half a turn and to a whole.
fn any_job() -> impl Strategy<Value = Job> {
    let rotate = prop_oneof![
        6 => -400.0..400.0_f64,
        1 => Just(0.0),
        1 => Just(180.0),
        1 => Just(-0.0),
        1 => -180.0001..-179.9999_f64,
    ];
    let bend = prop_oneof![8 => -160.0..160.0_f64, 1 => Just(0.0), 1 => -1e-6..1e-6_f64];
    let steps = prop::collection::vec((20.0..200.0_f64, rotate, bend), 0..16);
    (steps, 20.0..200.0_f64).prop_map(|(mut steps, last)| {
        steps.push((last, 0.0, 0.0));
        job_of(RADIUS, &steps)
    })
}

/// Wires that lie in a plane: turns of none or half.
fn any_flat_job() -> impl Strategy<Value = Job> {
    let rotate = prop_oneof![Just(0.0), Just(180.0), Just(-180.0)];
    let bend = prop_oneof![8 => -160.0..160.0_f64, 1 => Just(0.0)];
    prop::collection::vec((20.0..200.0_f64, rotate, bend), 1..30).prop_map(|steps| job_of(RADIUS, &steps))
}

/// Every way to write all columns but the header.
fn any_settings() -> impl Strategy<Value = Value> {
    let styles = prop_oneof![
        Just(("comma", "point")),
        Just(("semicolon", "comma")),
        Just(("tab", "comma")),
        Just(("semicolon", "point")),
    ];
    let hand = prop_oneof![Just("right"), Just("left")];
    let rotation = prop_oneof![Just("relative"), Just("absolute")];
    let lengths = prop_oneof![Just("tangent"), Just("intersection")];
    let line_end = prop_oneof![Just("lf"), Just("crlf")];
    (styles, hand, rotation, lengths, line_end, any::<bool>(), 0..=9_u8).prop_map(
        |((separator, decimal_mark), handedness, rotation, lengths, line_end, unsigned_bends, decimals)| {
            json!({
                "columns": ["L", "D", "R", "A", "CLR"], "header": false, "separator": separator,
                "decimal_mark": decimal_mark, "handedness": handedness, "rotation": rotation,
                "lengths": lengths, "line_end": line_end, "unsigned_bends": unsigned_bends, "decimals": decimals,
            })
        },
    )
}

/// Reads a table back: an empty cell is `None`.
fn parsed(text: &str, settings: &Value) -> Result<Vec<Vec<Option<f64>>>, TestCaseError> {
    let separator = match settings["separator"].as_str() {
        Some("semicolon") => b';',
        Some("tab") => b'\t',
        _ => b',',
    };
    let mut reader =
        csv::ReaderBuilder::new().delimiter(separator).has_headers(false).from_reader(text.as_bytes());
    let mut rows = Vec::new();
    for record in reader.records() {
        let mut row = Vec::new();
        for cell in &record.map_err(|error| TestCaseError::fail(error.to_string()))? {
            let is_zero = !cell.contains(|c| ('1'..='9').contains(&c));
            prop_assert!(!(cell.starts_with('-') && is_zero), "minus zero: {text}");
            let number = || cell.replace(',', ".").parse::<f64>();
            row.push(
                (!cell.is_empty())
                    .then(number)
                    .transpose()
                    .map_err(|_| TestCaseError::fail(cell.to_owned()))?,
            );
        }
        rows.push(row);
    }
    Ok(rows)
}

/// By how much two angles differ, where `turn` is as good as nothing.
fn apart(a: f64, b: f64, turn: f64) -> f64 {
    let off = (a - b).rem_euclid(turn);
    off.min(turn - off)
}

type Vector = [f64; 3];

fn turned(v: Vector, axis: Vector, degrees: f64) -> Vector {
    let side =
        [axis[1] * v[2] - axis[2] * v[1], axis[2] * v[0] - axis[0] * v[2], axis[0] * v[1] - axis[1] * v[0]];
    let (sin, cos) = degrees.to_radians().sin_cos();
    std::array::from_fn(|k| v[k] * cos + side[k] * sin)
}

/// The corners that feed, rotate and bend lead through.
fn corners(steps: impl IntoIterator<Item = (f64, f64, f64)>) -> Vec<Vector> {
    let (mut at, mut t, mut b) = ([0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
    let mut path = vec![at];
    for (feed, rotate, bend) in steps {
        at = std::array::from_fn(|k| at[k] + feed * t[k]);
        path.push(at);
        b = turned(b, t, rotate);
        t = turned(t, b, bend);
    }
    path
}

fn steps_of(design: &[DesignStep]) -> impl Iterator<Item = (f64, f64, f64)> {
    design.iter().map(|step| (step.feed_mm, step.rotate_deg, step.bend_deg))
}

proptest! {
    /// Wherever the wire is looked at, what the table has fed and turned so far is right to half a digit.
    #[test]
    fn rounding_does_not_add_up(job in any_job(), settings in any_settings()) {
        let rows = parsed(&table("lra-csv", settings.clone(), &job), &settings)?;
        let design = &job.wires[0].design;
        prop_assert_eq!(rows.len(), design.len());
        let digit = 0.1_f64.powi(i32::try_from(settings["decimals"].as_u64().unwrap()).unwrap());
        let half = 0.5 * digit + 1e-8;
        let tangent = settings["lengths"] == "tangent";
        let hand = if settings["handedness"] == "left" { -1.0 } else { 1.0 };
        let (mut sum, mut length, mut arcs, mut turned, mut plane) = (0.0, 0.0, 0.0, 0.0, 0.0);
        for (n, (row, step)) in rows.iter().zip(design).enumerate() {
            length += if tangent { step.straight_mm.unwrap() } else { step.feed_mm };
            let fed = row[0].unwrap();
            prop_assert!(fed >= 0.0);
            sum += fed;
            prop_assert!((sum - length).abs() <= half, "row {}: {} of {}", n, sum, length);
            prop_assert!((row[1].unwrap() - length - arcs).abs() <= half, "row {}: {:?}", n, row);
            arcs += if tangent { RADIUS * step.bend_deg.abs().to_radians() } else { 0.0 };
            let (Some(rotate), Some(bend)) = (row[2], row[3]) else {
                prop_assert!(n + 1 == rows.len() && row[4].is_none());
                break;
            };
            plane = if settings["rotation"] == "absolute" { rotate } else { plane + rotate };
            turned += hand * step.rotate_deg;
            // Half a turn of the plane is the same plane; which way the wire bends in it is the next property.
            prop_assert!(apart(plane, turned, 180.0) <= half, "row {}: {} for {}", n, plane, turned);
            let size = if settings["unsigned_bends"] == true { step.bend_deg.abs() } else { step.bend_deg };
            prop_assert!((bend - size).abs() <= digit + 1e-8, "row {}: {} for {}", n, bend, step.bend_deg);
            let range = if settings["rotation"] == "absolute" { 0.0..360.0 } else { -180.0 + 1e-12..180.0 + 1e-12 };
            prop_assert!(range.contains(&rotate), "row {}: {}", n, rotate);
            prop_assert!((RADIUS - row[4].unwrap()).abs() <= half);
        }
    }

    /// A user who follows a table bends the wire that was designed, and not its mirror image.
    #[test]
    fn a_table_is_the_same_wire(job in any_job(), mut settings in any_settings()) {
        settings["lengths"] = json!("intersection");
        settings["decimals"] = json!(7);
        let rows = parsed(&table("lra-csv", settings.clone(), &job), &settings)?;
        let hand = if settings["handedness"] == "left" { -1.0 } else { 1.0 };
        let mut before = 0.0;
        let read = rows.iter().map(|row| {
            let written = row[2].unwrap_or(before);
            let rotate = if settings["rotation"] == "absolute" { written - before } else { written };
            before = written;
            (row[0].unwrap(), hand * rotate, row[3].unwrap_or(0.0))
        });
        // 17 feeds of 200 mm at most, each turned by a wrong last digit of each angle before it.
        let tolerance = 17.0 * (1e-7 + 17.0 * 200.0 * 2.0 * 1e-7_f64.to_radians());
        for (ours, theirs) in corners(steps_of(&job.wires[0].design)).iter().zip(corners(read)) {
            let off = (0..3).map(|k| (ours[k] - theirs[k]).powi(2)).sum::<f64>().sqrt();
            prop_assert!(off < tolerance, "{:?} {:?}", ours, theirs);
        }
    }

    /// A flat wire of many bends points where it should, however coarse the table.
    #[test]
    fn bends_in_a_plane_add_up(job in any_flat_job(), mut settings in any_settings()) {
        settings["rotation"] = json!("relative");
        let rows = parsed(&table("ybc-csv", settings.clone(), &job), &settings)?;
        let digit = 0.1_f64.powi(i32::try_from(settings["decimals"].as_u64().unwrap()).unwrap());
        let (mut ours, mut our_side, mut theirs, mut their_side) = (0.0, 1.0, 0.0, 1.0);
        for (row, step) in rows.iter().zip(&job.wires[0].design) {
            let (Some(rotate), Some(bend)) = (row[2], row[3]) else { break };
            our_side *= if step.rotate_deg == 0.0 { 1.0 } else { -1.0 };
            their_side *= if rotate == 0.0 { 1.0 } else { -1.0 };
            ours += our_side * step.bend_deg;
            theirs += their_side * bend;
            prop_assert!((ours - theirs).abs() <= 0.5 * digit + 1e-8, "{} {}", ours, theirs);
        }
    }

    #[test]
    fn points_are_right_to_half_a_digit(
        points in prop::collection::vec(prop::array::uniform3(prop_oneof![-1e5..1e5_f64, -1e-3..1e-3_f64]), 1..20),
        settings in any_settings(),
    ) {
        let mut job = job_of(RADIUS, &[]);
        job.wires[0].path_mm.clone_from(&points);
        let rows = parsed(&table("xyz-csv", settings.clone(), &job), &settings)?;
        let half = 0.5 * 0.1_f64.powi(i32::try_from(settings["decimals"].as_u64().unwrap()).unwrap()) + 1e-9;
        prop_assert_eq!(rows.len(), points.len());
        for (row, point) in rows.iter().zip(points) {
            for (cell, coordinate) in row.iter().zip(point) {
                prop_assert!((cell.unwrap() - coordinate).abs() <= half, "{:?} {:?}", row, point);
            }
        }
    }
}
