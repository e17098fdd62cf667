//! Tables of bends: a published sample, and one wire in every way in which tables say it.

mod names;
mod units;

use nalgebra::{Point3, Vector3};
use wirebend_core::bend::{Convention, Frame, Sign, Step, program_of_path, replay};
use wirebend_core::units::Angle;
use wirebend_files::read::{Format, Handedness, Imported, LengthUnit, NoteKind, ReadOptions, read};

use super::{import, mm, notes, step};

/// A table of bends of this radius, as a file whose name leaves open what it is.
fn import_table(table: &str, options: &ReadOptions) -> Imported {
    let imported =
        read(table.as_bytes(), "wire.csv", None, options).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(imported.format, Format::Lra, "{table}");
    imported
}

fn steps_of(table: &str, options: &ReadOptions) -> Vec<Step> {
    import_table(table, options).program.unwrap().program.steps
}

fn assert_near(path: &[Point3<f64>], expected: &[Point3<f64>], tolerance_mm: f64, table: &str) {
    assert_eq!(path.len(), expected.len(), "{table}");
    for (ours, theirs) in path.iter().zip(expected) {
        assert!((ours - theirs).norm() < tolerance_mm, "{table}{ours} {theirs}");
    }
}

/// The sample that Creo's manual gives for its bend tables: points, and the table for a
/// centreline radius of 560.
const CREO_POINTS: [[f64; 3]; 5] = [
    [0., 0., 0.],
    [0., 0., 1495.39],
    [0., 10100., 1495.39],
    [0., 10100., 3989.39],
    [5718.30, 10136.89, 3989.39],
];
const CREO_TABLE: &str = "L;R;A\n935.39;-;90\n8980;180;90\n1374;90.37;90\n5158.41\n";

/// The same from the start. An arc is 560·π/2 = 879.646: 935.39 + 879.646 + 8980 = 10795.036, then + 879.646 + 1374 =
/// 13048.682, then + 879.646 + 5158.41 = 19086.738. Rotations: 180, 180 + 90.37.
const CREO_FROM_START: &str =
    "D_mm;Rabs;A;CLR\n935.390;-;90;560\n10795.036;180;90;560\n13048.682;270.37;90;560\n19086.738\n";

#[test]
fn the_published_table_becomes_the_points() {
    let options = ReadOptions { clr: Some(mm(560.0)), ..ReadOptions::default() };
    // Neither table says where the wire lies: start it as Creo does, along z, first bend to y.
    let frame = Frame::looking(Point3::origin(), Vector3::z(), Vector3::y()).unwrap();
    for table in [CREO_TABLE, CREO_FROM_START] {
        let steps = steps_of(table, &options);
        // 0.005° of twist over 5718 mm is 0.5 mm; lengths are given to 0.01.
        let tolerance = 0.01 + 5718.3 * 0.005_f64.to_radians();
        assert_near(&replay(frame, &steps), &CREO_POINTS.map(Point3::from), tolerance, table);
        // Corner to corner, without the twist's rounding, the table is exact.
        let lengths: Vec<f64> = steps.iter().map(|step| step.feed.mm()).collect();
        for (length, expected) in lengths.iter().zip([1495.39, 10100.0, 2494.0, 5718.41]) {
            assert!((length - expected).abs() < 0.01, "{lengths:?}");
        }
    }
}

/// A user who follows the published table runs the steps that we would for its points, with their signs: the mirror
/// image of the tube has a twist of -90.37 before the third bend.
#[test]
fn the_published_table_has_the_steps_of_our_program_of_its_points() {
    let options = ReadOptions { clr: Some(mm(560.0)), ..ReadOptions::default() };
    let theirs = steps_of(CREO_TABLE, &options);
    let (_, ours) = program_of_path(&CREO_POINTS.map(Point3::from), Angle::ZERO).unwrap();
    assert_eq!(ours.steps.len(), theirs.len());
    for (ours, theirs) in ours.steps.iter().zip(&theirs) {
        assert!((ours.feed.mm() - theirs.feed.mm()).abs() < 0.0101, "{ours:?} {theirs:?}");
        assert!((ours.rotate - theirs.rotate).wrapped().deg().abs() < 0.0101, "{ours:?} {theirs:?}");
        assert!((ours.bend.deg() - theirs.bend.deg()).abs() < 0.0101, "{ours:?} {theirs:?}");
    }
    assert!(ours.steps[2].rotate > Angle::ZERO && theirs[2].rotate > Angle::ZERO);
}

/// 60 mm along x. A quarter turn takes the side of the bend from y to z: 40 mm up. A quarter turn back about z takes
/// it from -x to y: 50 mm along y. 45° about y take it from -z to (-√½, 0, -√½), and the bend of -60° leads away
/// from there: 70 mm along (√½·sin 60°, cos 60°, √½·sin 60°).
fn wire() -> [Point3<f64>; 5] {
    let aside = 70.0 * 0.5_f64.sqrt() * 60.0_f64.to_radians().sin();
    [[0., 0., 0.], [60., 0., 0.], [60., 0., 40.], [60., 50., 40.], [60. + aside, 85., 40. + aside]]
        .map(Point3::from)
}

/// That wire with bends of radius 3, which take 3, 3 and 3·tan 30° = 1.732 mm on either side: 57, 34, 45.268 and
/// 68.268 mm are straight. -60° is half a turn more and 60°. From the start the planes are at 90°, 0° and 225°. Arcs
/// are 3·π/2 = 4.712, 4.712 and π = 3.142 mm long: bends begin at 57, 95.712 and 145.693 mm, the end is at 217.102.
const TABLES: [(&str, &str); 13] = [
    ("lengths", "L_mm,R_deg,A_deg,CLR_mm\n57,90,90,3\n34,-90,90,3\n45.268,-135,60,3\n68.268,,,\n"),
    ("signed bends", "L_mm,R_deg,A_deg,CLR_mm\n57,90,90,3\n34,-90,90,3\n45.268,45,-60,3\n68.268,,,\n"),
    ("no header", "57.000,90.000,90.000\n34.000,-90.000,90.000\n45.268,-135.000,60.000\n68.268,,\n"),
    ("YBC", "Y;B;C\n57,0;90,0;90,0\n34,0;-90,0;90,0\n45,268;-135,0;60,0\n68,268;;\n"),
    ("absolute", "L_mm,Rabs_deg,A_deg,CLR_mm\n57,90,90,3\n34,0,90,3\n45.268,225,60,3\n68.268,,,\n"),
    ("absolute, signed", "L_mm,Rabs_deg,A_deg,CLR_mm\n57,90,90,3\n34,0,90,3\n45.268,45,-60,3\n68.268,,,\n"),
    ("YBC, absolute", "Y_mm\tBabs_deg\tC_deg\n57\t90\t90\n34\t0\t90\n45,268\t225\t60\n68,268\n"),
    ("corners", "Lcorner_mm,R_deg,A_deg,CLR_mm\n60,90,90,3\n40,-90,90,3\n50,-135,60,3\n70,,,\n"),
    ("distances", "D_mm,Rabs_deg,A_deg,CLR_mm\n57,90,90,3\n95.712,0,90,3\n145.693,225,60,3\n217.102,,,\n"),
    ("distances, relative", "D_mm,R_deg,A_deg\n57,90,90\n95.712,-90,90\n145.693,-135,60\n217.102,,\n"),
    ("distances along corners", "Dcorner_mm,Rabs_deg,A_deg\n60,90,90\n100,0,90\n150,225,60\n220,,\n"),
    ("MIL-D-9898", "C,F,E,G\n57,3,90,90\n95.712,3,0,90\n145.693,3,225,60\n217.102,,,\n"),
    (
        "words",
        "Cumulative length [mm];Absolute rotation;Bend angle;Radius\n57;90;90;3\n95.712;0;90;3\n145.693;225;60;3\n217.102\n",
    ),
];

#[test]
fn a_wire_is_the_same_in_every_table() {
    // For the tables that do not say the radius.
    let options = ReadOptions { clr: Some(mm(3.0)), ..ReadOptions::default() };
    for (what, table) in TABLES {
        let path = import_table(table, &options).program.unwrap().path;
        // Five lengths of three decimals, turned by exact angles.
        assert_near(&path, &wire(), 5.0 * 0.001, what);
    }
}

/// 57, 95.712, 145.693, 217.102 and 3 mm.
#[test]
fn distances_and_radii_are_in_the_unit_that_they_name() {
    let table = "D_inch,Rabs_deg,A_deg,CLR_inch\n2.24409,90,90,0.11811\n3.76820,0,90,0.11811\n\
                 5.73593,225,60,0.11811\n8.54733,,,\n";
    let imported = import_table(table, &ReadOptions::default());
    assert_near(&imported.program.unwrap().path, &wire(), 0.005, table);
}

/// The same wire, with units that differ from column to column: 57 mm are 2.24409 inches, 90° are 1.570796 radians or 100 gon.
#[test]
fn each_column_is_in_the_unit_that_it_names() {
    for table in [
        "D_inch,Rabs_deg,A_deg,CLR_mm\n2.24409,90,90,3\n3.76820,0,90,3\n5.73593,225,60,3\n8.54733,,,\n",
        "D_mm,Rabs_deg,A_deg,CLR_cm\n57,90,90,0.3\n95.712,0,90,0.3\n145.693,225,60,0.3\n217.102,,,\n",
        "D (mm),Rabs [rad],A [gon],CLR (inch)\n57,1.570796,100,0.11811\n95.712,0,100,0.11811\n145.693,3.926991,66.66667,0.11811\n217.102,,,\n",
        "\"D_mm\",\"Rabs_deg\",\"A_deg\",\"CLR_mm\"\n\"57,0\",\"90,0\",\"90,0\",\"3,0\"\n\"95,712\",\"0,0\",\"90,0\",\"3,0\"\n\
         \"145,693\",\"225,0\",\"60,0\",\"3,0\"\n\"217,102\",,,\n",
    ] {
        let imported = import_table(table, &ReadOptions::default());
        assert_near(&imported.program.unwrap().path, &wire(), 0.005, table);
    }
    let points = "x_inch,y_mm,z\n2,50,1\n3,60,2\n";
    let imported = read(points.as_bytes(), "points.csv", None, &ReadOptions::default()).unwrap();
    let at: Vec<Point3<f64>> = imported.wireframe.vertices().map(|(_, vertex)| vertex.position).collect();
    assert_near(&at, &[Point3::new(50.8, 50.0, 25.4), Point3::new(76.2, 60.0, 50.8)], 1e-9, points);
    // Whoever says what all of them are in is told that the file says otherwise.
    let units = Some(LengthUnit::Millimetre);
    let imported =
        import_table("L_inch,R,A,CLR_mm\n20,0,90,3\n20\n", &ReadOptions { units, ..ReadOptions::default() });
    assert!((imported.program.unwrap().program.steps[0].feed.mm() - 23.0).abs() < 1e-9);
    assert!(imported.notes.iter().any(|note| note.kind == NoteKind::UnitsOverridden), "{:?}", imported.notes);
}

/// A radius is for bends that have none of their own.
#[test]
fn a_radius_that_no_bend_needs_is_noted() {
    let options = ReadOptions { clr: Some(mm(5.0)), ..ReadOptions::default() };
    for (table, unused) in [
        ("L,R,A,CLR\n30,0,90,3\n40,0,45,3\n30\n", true),
        ("L,R,A,CLR\n30,0,90,3\n40,0,45,\n30\n", false),
        ("L,R,A\n30,0,90\n30\n", false),
    ] {
        let imported = read(table.as_bytes(), "table.csv", None, &options).unwrap();
        let noted = imported.notes.iter().any(|note| note.kind == NoteKind::RadiusUnused);
        assert_eq!(noted, unused, "{table}: {:?}", imported.notes);
    }
}

/// A machine whose dial counts the other way has 360° less each rotation.
#[test]
fn a_dial_that_counts_the_other_way_needs_the_convention() {
    let table = "D_mm,Rabs_deg,A_deg,CLR_mm\n57,270,90,3\n95.712,0,90,3\n145.693,135,60,3\n217.102\n";
    let opposite = Convention { rotate: Sign::Opposite, ..Convention::default() };
    let options = ReadOptions { convention: opposite, ..ReadOptions::default() };
    assert_near(&import_table(table, &options).program.unwrap().path, &wire(), 0.005, table);
    let mirrored = import_table(table, &ReadOptions::default()).program.unwrap().path;
    assert!((mirrored[2] - wire()[2]).norm() > 50.0, "a mirror image must not fit");
}

/// From 350° past zero to 10° is 20° on; to 190° half a turn, and back; a cell without a number turns nothing.
#[test]
fn a_dial_goes_round() {
    let table = "Lcorner,Rabs,A\n10,350,30\n10,10,30\n10,190,30\n10,10,30\n10,-,30\n10,730,30\n10\n";
    let rotations: Vec<f64> = steps_of(table, &ReadOptions::default())
        .iter()
        .map(|step| (step.rotate.deg() * 1e6).round() / 1e6)
        .collect();
    assert_eq!(rotations, [-10.0, 20.0, 180.0, 180.0, 0.0, 0.0, 0.0]);
}

/// Arcs of 90° and radius 9 are 14.137 mm long: one that begins at 40 mm ends at 54.137, written as 54. Where it
/// meets the next nothing is straight, and 9 mm to either corner are left.
#[test]
fn arcs_that_meet_may_be_rounded_into_one_another() {
    let steps = steps_of("D_mm,Rabs,A,CLR\n40,0,90,9\n54,0,90,9\n108,,,\n", &ReadOptions::default());
    let feeds: Vec<f64> = steps.iter().map(|step| step.feed.mm()).collect();
    let arc = 9.0 * std::f64::consts::FRAC_PI_2;
    let expected = [49.0, 18.0, 108.0 - 54.0 - arc + 9.0];
    assert!(feeds.iter().zip(expected).all(|(feed, expected)| (feed - expected).abs() < 1e-9), "{feeds:?}");
    // Between corners nothing is rounded into anything: two bends in one place are a feed of 0.
    let table = "Dcorner,R,A\n40.1,0,90\n40.1,90,90\n80.3\n";
    let expected = [step(40.1, 0., 90.), step(0., 90., 90.), step(80.3 - 40.1, 0., 0.)];
    assert_eq!(steps_of(table, &ReadOptions::default()), expected);
}

/// What is there twice is read once, and what is not read is said: a radius that lengths do not depend on, too.
#[test]
fn columns_that_are_not_needed_are_counted() {
    let ignored = |table: &str| {
        let imported = import_table(table, &ReadOptions::default());
        assert_near(&imported.program.unwrap().path, &wire(), 0.005, table);
        notes(&imported.notes)
    };
    let assumed = "units not given: taken as mm".to_owned();
    let header = "the first row is a header".to_owned();
    let turned = "nothing says which way rotations turn: taken by the right-hand rule along the wire; \
                  the table of a left-handed machine gives the mirror image"
        .to_owned();
    let radii = "3 bends have radii of 3 mm, of which a wireframe keeps the corners alone".to_owned();
    let said = |count: &str| [header.clone(), format!("{count} ignored"), assumed.clone(), turned.clone()];
    let [before, columns, units, hand] = said("1 column");
    let military = "C,F,E,G,Y\n57,3,90,90,57\n95.712,3,0,90,34\n145.693,3,225,60,45.268\n217.102,,,,68.268\n";
    assert_eq!(ignored(military), [before, columns, units, radii.clone(), hand]);
    let corners = "Lcorner,R,A,CLR\n60,90,90,3\n40,-90,90,3\n50,-135,60,3\n70\n";
    assert_eq!(ignored(corners), said("1 column"));
    let all = "N,D_mm,L_mm,R,Rabs,A,CLR\n1,57,57,90,90,90,3\n2,95.712,34,-90,0,90,3\n3,145.693,45.268,-135,225,60,3\n\
               4,217.102,68.268\n";
    let [before, columns, _, hand] = said("3 columns");
    assert_eq!(ignored(all), [before, columns, radii, hand]);
}

/// Lengths between corners need no radius, single lengths no cell but their own: what is beside them may be missing.
#[test]
fn of_several_lengths_the_plainest_is_read() {
    for table in [
        "D_mm,Dcorner,L_mm,Lcorner,R,A\n57,60,57,60,90,90\n-,-,-,40,-90,90\n-,-,-,50,-135,60\n-,-,-,70\n",
        "D_mm,L_mm,R,A,CLR\n57,57,90,90,3\n-,34,-90,90,3\n-,45.268,-135,60,3\n-,68.268\n",
        "D_mm,Dcorner,R,A\n57,60,90,90\n-,100,-90,90\n-,150,-135,60\n-,220\n",
    ] {
        let imported = import_table(table, &ReadOptions::default());
        assert!(notes(&imported.notes).iter().all(|note| !note.starts_with("no bend radius")), "{table}");
        assert_near(&imported.program.unwrap().path, &wire(), 0.005, table);
    }
}

/// A single letter of MIL-D-9898 does not make C of a YBC table a distance.
#[test]
fn a_column_g_is_no_reason_to_read_another_table() {
    let steps = steps_of("Y_mm,B,C,G\n10,0,90,1\n20,45,60,2\n30\n", &ReadOptions::default());
    assert_eq!(steps, [step(10., 0., 90.), step(20., 45., 60.), step(30., 0., 0.)]);
}

/// A fold back has no corner, and so no length beside it but one between corners.
#[test]
fn lengths_between_corners_hold_fold_backs() {
    for table in ["Lcorner,R,A,CLR\n60,0,180,3\n40\n", "Dcorner,R,A,CLR\n60,0,180,3\n100\n"] {
        let steps = steps_of(table, &ReadOptions::default());
        assert_eq!(steps, [step(60., 0., 180.), step(40., 0., 0.)], "{table}");
    }
}

#[test]
fn a_radius_of_each_row_and_the_names_of_ybc() {
    let table = "Step,Y,B,C,Radius\n1,10,0,90,5\n2,20,45,-60,3\n3,30,,,\n";
    let imported = import("part.ybc", table).unwrap();
    let steps = imported.program.unwrap().program.steps;
    let setback = |radius: f64, deg: f64| radius * (deg.to_radians() / 2.0).tan();
    let expected = [
        10.0 + setback(5.0, 90.0),
        20.0 + setback(5.0, 90.0) + setback(3.0, 60.0),
        30.0 + setback(3.0, 60.0),
    ];
    for (step, feed) in steps.iter().zip(expected) {
        assert!((step.feed.mm() - feed).abs() < 1e-9);
    }
    assert!((steps[1].bend.deg() + 60.0).abs() < 1e-9 && (steps[1].rotate.deg() - 45.0).abs() < 1e-9);
    expect_test::expect![[r#"
        [
            "the first row is a header",
            "1 column ignored",
            "units not given: taken as mm",
            "2 bends have radii of 3 mm to 5 mm, of which a wireframe keeps the corners alone",
            "1 bend with a minus sign, taken as a bend to the other side",
            "nothing says which way rotations turn: taken by the right-hand rule along the wire; the table of a left-handed machine gives the mirror image",
        ]
    "#]]
    .assert_debug_eq(&notes(&imported.notes));
}

#[test]
fn a_table_without_radius_says_what_it_assumed() {
    let imported = import("part.lra", "10 0 90\n20\n").unwrap();
    assert!(notes(&imported.notes).iter().any(|note| note.starts_with("no bend radius given")));
    assert_eq!(imported.program.unwrap().program.steps, [step(10., 0., 90.), step(20., 0., 0.)]);
}

/// Planes at 0°, 30° and -70°. A negative bend is half a turn and a positive one: 0°, 210° and 110°, which are 0°,
/// -150° and -100° from one to the next.
#[test]
fn unsigned_angles_are_the_same_wire() {
    let path = |table: &str| import("table.lra", table).unwrap().program.unwrap().path;
    let signed = path("30,0,45,0\n20,30,-60,0\n25,-100,-90,0\n10\n");
    let unsigned = path("30,0,45,0\n20,-150,60,0\n25,-100,90,0\n10\n");
    assert_near(&signed, &unsigned, 1e-9, "");
}

/// As spreadsheets write it where the decimal mark is a comma. Bends of radius 2 take 2·tan 45° = 2 and 2·tan 22.5° =
/// 0.828 mm off both sides.
#[test]
fn a_table_of_a_spreadsheet_without_names() {
    let table = "10,000;0,000;90,000;2,000\n20,000;180,000;45,000;2,000\n30,000;;;\n";
    let steps = steps_of(table, &ReadOptions::default());
    let half = 2.0 * (2.0_f64.sqrt() - 1.0);
    let expected = [step(12.0, 0.0, 90.0), step(22.0 + half, 180.0, 45.0), step(30.0 + half, 0.0, 0.0)];
    for (ours, expected) in steps.iter().zip(expected) {
        assert!((ours.feed.mm() - expected.feed.mm()).abs() < 1e-9, "{ours:?} {expected:?}");
        assert_eq!((ours.rotate, ours.bend), (expected.rotate, expected.bend));
    }
}

/// The same wire for a machine that counts rotations the other way.
#[test]
fn the_table_of_a_left_handed_machine_says_so_or_is_told() {
    let mirrored = "L,R,A,CLR\n57,-90,90,3\n34,90,90,3\n45.268,135,60,3\n68.268\n";
    let left = ReadOptions { handedness: Some(Handedness::Left), ..ReadOptions::default() };
    let said = "the table is left-handed: its rotations are turned the other way";
    for (options, table) in [
        (&left, mirrored.to_owned()),
        (&ReadOptions::default(), format!("# Handedness: left\n{mirrored}")),
        (&ReadOptions::default(), format!("# part 7, left-handed control\n{mirrored}")),
        (&ReadOptions::default(), mirrored.replace("L,R,", "L,R [left],")),
        (&ReadOptions::default(), mirrored.replace("L,R,", "L,R_lh,")),
    ] {
        let imported = import_table(&table, options);
        assert!(notes(&imported.notes).contains(&said.to_owned()), "{table}");
        assert_near(&imported.program.unwrap().path, &wire(), 0.005, &table);
    }
    let assumed = |table: &str, options: &ReadOptions| {
        notes(&import_table(table, options).notes)
            .iter()
            .any(|note| note.starts_with("nothing says which way rotations turn"))
    };
    let plain = ReadOptions::default();
    assert!(assumed(mirrored, &plain));
    let right = ReadOptions { handedness: Some(Handedness::Right), ..ReadOptions::default() };
    assert!(!assumed(mirrored, &right) && !assumed(mirrored, &left));
    assert!(!assumed(&format!("# right-handed\n{mirrored}"), &plain));
    assert!(
        assumed(&format!("# left over from a right turn\n{mirrored}"), &plain),
        "words alone say nothing"
    );
    // A flat wire has no other hand.
    assert!(!assumed("L,R,A\n10,180,90\n20,-180,45\n30\n", &plain));
}
