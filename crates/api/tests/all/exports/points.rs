//! Tables of points, read by our reader.

use nalgebra::Point3;
use serde_json::Value;
use wirebend_core::units::Length;
use wirebend_core::wireframe::Wireframe;
use wirebend_files::read::{Format, ReadOptions, read, wireframe_of_path};

use crate::exports::compared::{Rounding, assert_handed, assert_numbers};
use crate::exports::planned::each_case;

/// Three decimals.
const DIGIT: f64 = 1e-3;

/// The rows in their order: a reader of struts keeps each strut once, however often the wire passes it.
fn rows(text: &str) -> Vec<Point3<f64>> {
    let row = |line: &str| {
        let numbers: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        Point3::from_slice(&numbers)
    };
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("x_mm,y_mm,z_mm"));
    lines.map(row).collect()
}

/// The corners of the design as they are, a wire that folds back among them. Points do not lean on one another, so each
/// coordinate is off by half a digit wherever it is.
#[test]
fn every_case_is_the_wire_of_its_points() {
    let outcomes = each_case("table-bender", "xyz-csv", &Value::Null, |planned, wires, texts| {
        for (wire, text) in wires.iter().zip(texts) {
            let (case, points) = (&planned.name, rows(text));
            for axis in 0..3 {
                let along =
                    |points: &[Point3<f64>]| points.iter().map(|point| point[axis]).collect::<Vec<_>>();
                assert_numbers(case, &along(&points), &along(&wire.path), DIGIT, Rounding::Each);
            }
            assert_handed(case, &points, &wire.path, DIGIT);
            assert_same_struts(case, text, &wire.path);
        }
    });
    outcomes.assert(19, &[("cube-not-doubled", "route")], &[]);
}

/// Read as a wireframe, the same struts between the same vertices.
fn assert_same_struts(case: &str, text: &str, path: &[Point3<f64>]) {
    let found = read(text.as_bytes(), "points.csv", Some(Format::Xyz), &ReadOptions::default()).unwrap();
    // Points that the wire passes twice are written alike; all others are much farther apart than this.
    let meant = wireframe_of_path(path, Length::from_mm(10.0 * DIGIT).unwrap()).unwrap().wireframe;
    let struts = |wireframe: &Wireframe| -> Vec<[Point3<f64>; 2]> {
        let at = |vertex| wireframe.vertex(vertex).unwrap().position;
        wireframe.edges().map(|(_, edge)| [at(edge.a), at(edge.b)]).collect()
    };
    let (read, meant) = (struts(&found.wireframe), struts(&meant));
    assert_eq!(read.len(), meant.len(), "{case}");
    for (read, meant) in read.iter().flatten().zip(meant.iter().flatten()) {
        assert!((read - meant).amax() <= DIGIT * 0.5001, "{case}: {read} for {meant}");
    }
}
