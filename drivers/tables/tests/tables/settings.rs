//! Each setting and each preset, on one wire.

use serde_json::json;
use wirebend_driver_api::conformance::sample_job;
use wirebend_driver_api::{Content, Job, MachineDriver};
use wirebend_driver_tables::Tables;

use crate::{job_of, table};

/// Two right angles of radius 5 in different planes between 50, 50 and 50 mm: 45, 40 and 45 mm are straight.
fn corner() -> Job {
    job_of(5.0, &[(50.0, 0.0, 90.0), (50.0, 90.0, 90.0), (50.0, 0.0, 0.0)])
}

#[test]
fn the_short_presets_are_three_named_columns() {
    let numbers = "45.000,0.000,90.000\n40.000,90.000,90.000\n45.000,,\n";
    assert_eq!(table("lra-csv", json!({"preset": "lra"}), &corner()), format!("L,R,A\n{numbers}"));
    assert_eq!(table("ybc-csv", json!({"preset": "ybc"}), &corner()), format!("Y,B,C\n{numbers}"));
    assert_eq!(table("lra-csv", json!({"preset": "ybc"}), &corner()), format!("Y,B,C\n{numbers}"));
    let bare = json!({"preset": "lra", "header": false});
    assert_eq!(table("lra-csv", bare, &corner()), numbers);
}

#[test]
fn the_numbered_preset_counts_rows_from_1() {
    let expected = "N,L,R,A,CLR\n1,45.0,0.0,90.0,5.0\n2,40.0,90.0,90.0,5.0\n3,45.0,,,\n";
    assert_eq!(table("lra-csv", json!({"preset": "numbered", "decimals": 1}), &corner()), expected);
}

/// Fields C, F, E, G and Y as Siemens NX documents them for MIL-D-9898 C: C from the start to the beginning of
/// the bend, E the sum of rotations. 45, then 45 + 5·π/2 + 40 = 92.854; in all 92.854 + 5·π/2 + 45 = 145.708.
#[test]
fn the_military_preset_counts_from_the_start() {
    let expected = "C,F,E,G,Y\n\
                    45.000,5.000,0.000,90.000,45.000\n\
                    92.854,5.000,90.000,90.000,40.000\n\
                    145.708,,,,45.000\n";
    assert_eq!(table("cumulative-csv", json!({"preset": "mil-d-9898"}), &corner()), expected);
}

/// The name says that the lengths are not those between tangents, so that they are not taken for these.
#[test]
fn the_intersection_preset_measures_from_corner_to_corner() {
    let expected = "Lcorner_mm,R_deg,A_deg,CLR_mm\n\
                    50.000,0.000,90.000,5.000\n50.000,90.000,90.000,5.000\n50.000,,,\n";
    assert_eq!(table("lra-csv", json!({"preset": "intersection"}), &corner()), expected);
}

#[test]
fn the_decimal_comma_preset_is_for_spreadsheets() {
    let expected = "L_mm;R_deg;A_deg;CLR_mm\n45,0;0,0;90,0;5,0\n40,0;90,0;90,0;5,0\n45,0;;;\n";
    let settings = || json!({"preset": "decimal-comma", "decimals": 1});
    assert_eq!(table("lra-csv", settings(), &corner()), expected);
    assert!(table("xyz-csv", settings(), &sample_job()).contains("\n102,9;85,0;82,9\n"));
    // A semicolon is used where only the decimal mark is asked for, too.
    let mark = json!({"decimal_mark": "comma", "decimals": 1});
    assert_eq!(table("lra-csv", mark, &corner()), expected);
}

/// What a person sets goes before what a preset says, and the rest of the preset stays.
#[test]
fn a_key_goes_before_the_preset() {
    let settings =
        json!({"preset": "decimal-comma", "separator": "tab", "decimals": 0, "columns": ["A", "L"]});
    assert_eq!(table("lra-csv", settings, &corner()), "A_deg\tL_mm\n90\t45\n90\t40\n\t45\n");
    let settings = json!({"preset": "mil-d-9898", "columns": ["R"], "rotation": "relative", "decimals": 0});
    assert_eq!(table("cumulative-csv", settings, &corner()), "R_deg\n0\n90\n\n");
    let settings = json!({"preset": "lra", "header_names": ["Laenge", "Drehung", "Winkel"], "decimals": 0});
    assert!(table("lra-csv", settings, &corner()).starts_with("Laenge,Drehung,Winkel\n45,0,90\n"));
}

/// Who counts in another way than the preset gets no name of it: under L a reader would add the tangents to lengths between corners
/// once more, and take rotations from the start under R as those from the bend before.
#[test]
fn names_of_a_preset_go_with_what_it_counts() {
    let first = |preset: &str, key: &str, value: &str| {
        let settings = json!({"preset": preset, key: value, "decimals": 0});
        table("lra-csv", settings, &corner()).lines().next().unwrap().to_owned()
    };
    assert_eq!(first("numbered", "lengths", "intersection"), "N,Lcorner_mm,R_deg,A_deg,CLR_mm");
    assert_eq!(first("lra", "rotation", "absolute"), "L_mm,Rabs_deg,A_deg");
    assert_eq!(first("mil-d-9898", "rotation", "relative"), "D_mm,CLR_mm,R_deg,A_deg,L_mm");
    assert_eq!(first("mil-d-9898", "lengths", "intersection"), "Dcorner_mm,CLR_mm,Rabs_deg,A_deg,Lcorner_mm");
    // What is set as the preset has it changes nothing, and names of one's own are as they are.
    assert_eq!(first("numbered", "lengths", "tangent"), "N,L,R,A,CLR");
    assert_eq!(first("mil-d-9898", "rotation", "absolute"), "C,F,E,G,Y");
    let named = json!({"preset": "lra", "lengths": "intersection", "header_names": ["l", "r", "a"]});
    assert!(table("lra-csv", named, &corner()).starts_with("l,r,a\n50.000,"));
}

#[test]
fn columns_are_written_in_the_order_asked_for() {
    let all = json!({"columns": ["N", "D", "A", "R", "CLR", "L"], "decimals": 0});
    let expected = "N,D_mm,A_deg,R_deg,CLR_mm,L_mm\n1,45,90,0,5,45\n2,93,90,90,5,40\n3,146,,,,45\n";
    assert_eq!(table("lra-csv", all, &corner()), expected);
    let points = json!({"point_columns": ["N", "Z", "X", "CLR"], "decimals": 0});
    let expected = "N,z_mm,x_mm,CLR_mm\n1,0,0,\n2,0,60,3\n3,40,60,3\n4,40,60,3\n5,83,103,\n";
    assert_eq!(table("xyz-csv", points, &sample_job()), expected);
}

#[test]
fn names_are_given_or_left_out() {
    let named = json!({"columns": ["L", "A"], "header_names": ["length / mm", "Ø°"], "decimals": 0});
    assert_eq!(table("ybc-csv", named, &corner()), "length / mm,Ø°\n45,90\n40,90\n45,\n");
    let points = json!({"point_header_names": ["X", "Y", "Z"], "decimals": 0});
    assert!(table("xyz-csv", points, &sample_job()).starts_with("X,Y,Z\n0,0,0\n"));
    let bare = json!({"header": false, "decimals": 0});
    assert!(table("xyz-csv", bare, &sample_job()).starts_with("0,0,0\n60,0,0\n"));
}

#[test]
fn rotations_from_the_start_are_named_so() {
    let settings = json!({"rotation": "absolute", "decimals": 0});
    let expected = "L_mm,Rabs_deg,A_deg,CLR_mm\n57,90,90,3\n34,0,90,3\n45,225,60,3\n69,,,\n";
    // 57, 91, 136.27 and 204.54 mm in all: 57, 34, 45 and 69 add up to 205.
    assert_eq!(table("lra-csv", settings, &sample_job()), expected);
}

/// 63.5 mm are 2.5 inches; angles stay degrees.
#[test]
fn inches_are_of_25_4_mm() {
    let job = job_of(12.7, &[(76.2, 0.0, 90.0), (76.2, 0.0, 0.0)]);
    let settings = || json!({"length_unit": "inch", "decimals": 2});
    assert_eq!(
        table("lra-csv", settings(), &job),
        "L_inch,R_deg,A_deg,CLR_inch\n2.50,0.00,90.00,0.50\n2.50,,,\n"
    );
    assert!(
        table("xyz-csv", settings(), &sample_job())
            .starts_with("x_inch,y_inch,z_inch\n0.00,0.00,0.00\n2.36,")
    );
}

#[test]
fn lines_end_as_windows_has_it_and_name_the_design() {
    let settings = json!({"line_end": "crlf", "comments": "number-sign", "columns": ["L"], "decimals": 0});
    let hash = "a5".repeat(32);
    assert_eq!(
        table("lra-csv", settings, &corner()),
        format!("# design {hash}\r\nL_mm\r\n45\r\n40\r\n45\r\n")
    );
    let broken = Job { design_hash: "one\n9,9,9".to_owned(), ..corner() };
    let settings = json!({"comments": "number-sign", "header": false, "columns": ["L"], "decimals": 0});
    assert_eq!(table("lra-csv", settings, &broken), "# design one 9,9,9\n45\n40\n45\n");
}

/// The machine's own steps are not in a table: it compensates itself.
#[test]
fn tables_are_of_the_design() {
    let description = Tables::describe();
    assert!(description.formats.iter().all(|format| format.content == Content::Design));
    assert!(corner().wires[0].machine.is_none(), "and so need no steps for a machine");
    let programs =
        description.formats.iter().filter(|format| format.program).map(|format| format.id.as_str());
    assert_eq!(programs.collect::<Vec<_>>(), ["lra-csv", "ybc-csv", "cumulative-csv"]);
}

/// An editor that knows the schema accepts what a profile may say.
#[test]
fn null_is_what_the_format_says() {
    let open =
        json!({"preset": "none", "columns": null, "decimals": null, "header": null, "separator": null});
    assert_eq!(table("lra-csv", open, &corner()), table("lra-csv", json!({}), &corner()));
}
