//! What coarse decimals do, and do not do.

use serde_json::json;
use wirebend_driver_api::Job;

use crate::{encoded, job_of, rows};

fn column(text: &str, column: usize) -> Vec<i64> {
    let cells = text.lines().map(|line| line.split(',').nth(column).unwrap());
    cells.filter(|cell| !cell.is_empty()).map(|cell| cell.parse().unwrap()).collect()
}

/// Each length rounded alone would feed 10 mm of 14.
#[test]
fn lengths_add_up() {
    let mut steps = vec![(1.4, 90.0, 30.0); 9];
    steps.push((1.4, 0.0, 0.0));
    let text = rows("lra-csv", 0, &json!({"lengths": "intersection"}), &job_of(0.0, &steps));
    // 1.4, 2.8, 4.2, 5.6, 7.0 … are 1, 3, 4, 6, 7 …
    assert_eq!(column(&text, 0), [1, 2, 1, 2, 1, 1, 2, 1, 2, 1]);
}

/// Nine rotations of 40.4° are 363.6°: rounded alone the last plane would be off by 3.6°.
#[test]
fn rotations_add_up() {
    let mut steps = vec![(50.0, 40.4, 30.0); 9];
    steps.push((50.0, 0.0, 0.0));
    let text = rows("lra-csv", 0, &json!({}), &job_of(2.0, &steps));
    assert_eq!(column(&text, 1).iter().sum::<i64>(), 364);
    let text = rows("lra-csv", 0, &json!({"rotation": "absolute"}), &job_of(2.0, &steps));
    assert_eq!(column(&text, 1).last(), Some(&4), "363.6° on a dial");
}

/// A heptagon whose corners of 51.43° are all written as 51° does not close, by 3°. In one plane the angles add
/// up, so it is bends of 51° and 52°; with a rotation between them they do not, and each is the nearest.
#[test]
fn bends_in_one_plane_add_up() {
    let seventh = 360.0 / 7.0;
    let heptagon = |rotate| vec![(50.0, rotate, seventh); 7];
    let angles = |steps: &[(f64, f64, f64)]| column(&rows("lra-csv", 0, &json!({}), &job_of(2.0, steps)), 2);
    assert_eq!(angles(&heptagon(0.0)), [51, 52, 51, 52, 51, 52, 51]);
    assert_eq!(angles(&heptagon(90.0)), [51; 7]);
    // There and back: what the first lacks the second lacks too, whichever way a half turn is written.
    let zigzag = [(50.0, 0.0, seventh), (50.0, 0.0, -seventh), (50.0, 0.0, 0.0)];
    let turned = [(50.0, 0.0, seventh), (50.0, 180.0, seventh), (50.0, 0.0, 0.0)];
    assert_eq!((angles(&zigzag), angles(&turned)), (vec![51, 51], vec![51, 51]));
}

/// Nothing comes of rounding that was not there. -0.5° is written as -1°, which leaves half a degree over: not
/// for the straight joint, and not for the bend of 180°, which cannot be more; -0.2° + 0.5° is 0.3°, so 0°.
#[test]
fn carried_errors_stay_within_bends() {
    let bends = [-0.5, 0.0, 180.0, -0.2, 0.0].map(|bend| (50.0, 0.0, bend));
    let more = json!({"lengths": "intersection", "columns": ["A"], "unsigned_bends": false});
    assert_eq!(rows("lra-csv", 0, &more, &job_of(1.0, &bends)), "-1\n0\n180\n0\n\n");
}

/// 1.4 is written as 1 and as 2: off by 0.4 and 0.6. The radius of 0 and the angles are whole.
#[test]
fn rounding_that_can_be_seen_is_said() {
    let mut job = job_of(0.0, &[(1.4, 90.0, 30.0), (1.4, 0.0, 0.0)]);
    let notes = |decimals: u8, job: &Job| encoded("lra-csv", json!({"decimals": decimals}), job).notes;
    let said = notes(0, &job);
    assert_eq!((said.len(), said[0].code.as_str(), said[0].count), (1, "rounded", 2));
    let message = "values rounded by more than 0.05: 2; lengths by up to 0.600 mm, angles by up to 0.000 \
                   degrees; raise 'decimals' in the driver's settings";
    assert_eq!(said[0].message, message);
    assert_eq!(notes(1, &job), []);
    job.wires[0].design[0].rotate_deg = 359.7;
    assert!(notes(0, &job)[0].message.contains("angles by up to 0.300"), "{:?}", notes(0, &job));
    // An inch is 25.4 mm: a tenth of one is coarse. 1.4 mm are 0.06 inch, written as 0.1 or 0.
    let inch = encoded("lra-csv", json!({"decimals": 1, "length_unit": "inch"}), &job).notes;
    assert!(inch[0].message.contains("lengths by up to 1.4"), "{inch:?}");
    job.wires[0].path_mm = vec![[0.0; 3], [0.3, 0.0, 0.0]];
    let points = encoded("xyz-csv", json!({"decimals": 0}), &job).notes;
    assert!(points[0].message.contains("lengths by up to 0.300 mm"), "{points:?}");
}
