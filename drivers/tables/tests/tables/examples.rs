//! Tables whose numbers come from elsewhere or were worked out by hand.

use serde_json::json;
use wirebend_driver_api::conformance::sample_job;

use crate::{job_of, rows, table};

/// The sample wire has feeds of 60, 40, 50 and 70 mm, radius 3. Its bends take 3·tan 45° = 3, 3 and
/// 3·tan 30° = 1.7321 mm on either side: 57, 34, 45.2679 and 68.2679 are left. The last bend is -60°: half a
/// turn more, 45° + 180° = -135°, and +60°.
#[test]
fn an_lra_table_has_lengths_between_tangents_and_unsigned_bends() {
    let expected = "L_mm,R_deg,A_deg,CLR_mm\n\
                    57.000,90.000,90.000,3.000\n\
                    34.000,-90.000,90.000,3.000\n\
                    45.268,-135.000,60.000,3.000\n\
                    68.268,,,\n";
    assert_eq!(table("lra-csv", json!({}), &sample_job()), expected);
}

/// The same three columns under the axes' names; controllers take numbers only.
#[test]
fn a_ybc_table_is_numbers_alone() {
    let expected = "57.000,90.000,90.000\n34.000,-90.000,90.000\n45.268,-135.000,60.000\n68.268,,\n";
    assert_eq!(table("ybc-csv", json!({}), &sample_job()), expected);
    let named = table("ybc-csv", json!({"header": true}), &sample_job());
    assert_eq!(named, format!("Y_mm,B_deg,C_deg\n{expected}"));
}

/// Arcs of 3·π/2 = 4.7124 mm, twice, and 3·π/3 = 3.1416 mm lie between the straight parts: bends begin
/// at 57, 57 + 4.7124 + 34 = 95.7124 and 95.7124 + 4.7124 + 45.2679 = 145.6927, and the wire is
/// 145.6927 + 3.1416 + 68.2679 = 217.1023 mm long. Rotations from the start: 90°, 0°, 45° + 180°.
#[test]
fn a_cumulative_table_says_where_each_bend_begins() {
    let expected = "D_mm,Rabs_deg,A_deg,CLR_mm\n\
                    57.000,90.000,90.000,3.000\n\
                    95.712,0.000,90.000,3.000\n\
                    145.693,225.000,60.000,3.000\n\
                    217.102,,,\n";
    assert_eq!(table("cumulative-csv", json!({}), &sample_job()), expected);
    // Along the corners it is the sum of the feeds.
    let corners = rows("cumulative-csv", 0, &json!({"lengths": "intersection"}), &sample_job());
    assert_eq!(corners, "60,90,90,3\n100,0,90,3\n150,225,60,3\n220,,,\n");
}

/// Along x; the axis turned to -y bends it up to z; turned back to -x to y. Then the axis is
/// (-√½, 0, √½) and the bend of -60° leads along (√½·sin 60°, cos 60°, √½·sin 60°), 70 mm.
#[test]
fn an_xyz_table_has_the_corners() {
    let expected = "x_mm,y_mm,z_mm\n\
                    0.000,0.000,0.000\n\
                    60.000,0.000,0.000\n\
                    60.000,0.000,40.000\n\
                    60.000,50.000,40.000\n\
                    102.866,85.000,82.866\n";
    assert_eq!(table("xyz-csv", json!({}), &sample_job()), expected);
}

/// The sample of PTC Creo's manual, "Example: Bend Machine Report" and "Example: Bend Location Report". Points
/// (0, 0, 0), (0, 0, 1495.39), (0, 10100, 1495.39), (0, 10100, 3989.39), (5718.30, 10136.89, 3989.39) and
/// radius 560 become offsets 935.39, 8980.00, 1374.00, 5158.41 with twists 180.00 and 90.37.
///
/// Along z, then y, then z, then (5718.30, 36.89, 0): all bends are right angles. Bends about -x, then x:
/// half a turn. Then from x to z × (cos ε, sin ε, 0) = (-sin ε, cos ε, 0) about z: 90° + ε, where
/// tan ε = 36.89 / 5718.30.
#[test]
fn the_published_sample_becomes_the_published_table() {
    let (east, north) = (5718.30_f64, 36.89_f64);
    let twist = 90.0 + north.atan2(east).to_degrees();
    let steps =
        [(1495.39, 0.0, 90.0), (10100.0, 180.0, 90.0), (2494.0, twist, 90.0), (east.hypot(north), 0.0, 0.0)];
    let settings = json!({"preset": "numbered", "decimals": 2});
    // The last length is 5718.41899 - 560 = 5158.419, which the manual cuts to 5158.41.
    let expected = "N,L,R,A,CLR\n\
                    1,935.39,0.00,90.00,560.00\n\
                    2,8980.00,180.00,90.00,560.00\n\
                    3,1374.00,90.37,90.00,560.00\n\
                    4,5158.42,,,\n";
    assert_eq!(table("lra-csv", settings, &job_of(560.0, &steps)), expected);
}

/// 50 mm along x, then y, then z. The first bend is about x × y = z, the second about y × z = x; from z to
/// x is a positive quarter turn about y, because z × x = y. In its mirror image, which ends along -z,
/// the second bend is about y × -z = -x, a negative quarter turn away.
const CORNER: [(f64, f64, f64); 3] = [(50.0, 0.0, 90.0), (50.0, 90.0, 90.0), (50.0, 0.0, 0.0)];
const MIRRORED: [(f64, f64, f64); 3] = [(50.0, 0.0, 90.0), (50.0, -90.0, 90.0), (50.0, 0.0, 0.0)];

/// A wire bent to the wrong hand is scrap, and looks right on paper. Lengths: 50 less 5 for each bend.
#[test]
fn a_left_handed_reader_gets_rotations_of_the_other_sign() {
    let (right, left) = ("45,0,90,5\n40,90,90,5\n45,,,\n", "45,0,90,5\n40,-90,90,5\n45,,,\n");
    let (wire, mirror) = (job_of(5.0, &CORNER), job_of(5.0, &MIRRORED));
    let written = |hand: &str, job| rows("lra-csv", 0, &json!({"handedness": hand}), job);
    assert_eq!(written("right", &wire), right);
    assert_eq!(written("left", &wire), left);
    assert_eq!(written("right", &mirror), left);
    assert_eq!(written("left", &mirror), right);
    assert_eq!(rows("lra-csv", 0, &json!({}), &wire), right, "right is what is written unasked");
    // On a dial that counts the other way a quarter turn is three quarters: 45 + 7.854 + 40 = 92.854.
    let dial = rows("cumulative-csv", 0, &json!({"handedness": "left"}), &wire);
    assert_eq!(dial, "45,0,90,5\n93,270,90,5\n146,,,\n");
}

/// Points have no rotation: they are the same wire for every reader.
#[test]
fn points_do_not_depend_on_handedness() {
    let written = |hand: &str| rows("xyz-csv", 3, &json!({"handedness": hand}), &sample_job());
    assert_eq!(written("left"), written("right"));
}

/// Negative bends come about by half a turn before and after: planes at 0°, 30° and -70° become 0°, 210° and
/// 110°, which are 0°, -150° and -100° from one to the next.
#[test]
fn bends_have_signs_only_where_a_reader_wants_them() {
    let job = job_of(2.0, &[(30.0, 0.0, 45.0), (20.0, 30.0, -60.0), (25.0, -100.0, -90.0), (10.0, 0.0, 0.0)]);
    let written = |unsigned: bool| {
        let more = json!({"lengths": "intersection", "columns": ["L", "R", "A"], "unsigned_bends": unsigned});
        rows("lra-csv", 0, &more, &job)
    };
    assert_eq!(written(true), "30,0,45\n20,-150,60\n25,-100,90\n10,,\n");
    assert_eq!(written(false), "30,0,45\n20,30,-60\n25,-100,-90\n10,,\n");
}

/// A half turn has one name, so that no reader finds -180 where its axis ends at 180.
#[test]
fn half_a_turn_is_180_and_a_whole_one_0() {
    let job = job_of(
        2.0,
        &[(30.0, -180.0, 45.0), (20.0, -179.9999, 60.0), (20.0, 359.9998, 60.0), (9.0, 0.0, 0.0)],
    );
    let written = |rotation: &str| rows("lra-csv", 2, &json!({"rotation": rotation, "columns": ["R"]}), &job);
    assert_eq!(written("relative"), "180.00\n180.00\n0.00\n\n");
    assert_eq!(written("absolute"), "180.00\n0.00\n0.00\n\n");
}

/// A wire that ends in a bend keeps it; a straight joint is a row with a bend of 0.
#[test]
fn rows_are_complete_but_for_a_straight_end() {
    let job = job_of(2.0, &[(30.0, 0.0, 0.0), (20.0, 30.0, 90.0)]);
    assert_eq!(rows("lra-csv", 0, &json!({}), &job), "30,0,0,2\n18,30,90,2\n");
}
