//! Programs of other tools: what their commands mean, and tables against a published sample.

use nalgebra::Point3;
use wirebend_core::bend::{Convention, Frame, Sign, program_of_path, replay};
use wirebend_core::units::Angle;
use wirebend_core::wireframe::VertexId;
use wirebend_files::read::{Format, LengthUnit, ReadOptions, read};
use wirebend_files::write::{Lengths, LraLayout, TableStyle, lra};

use super::{import, mm, notes, step};

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

fn creo_points() -> Vec<Point3<f64>> {
    CREO_POINTS.map(Point3::from).to_vec()
}

#[test]
fn points_become_the_published_table() {
    let (_, program) = program_of_path(&creo_points(), Angle::ZERO).unwrap();
    let style = TableStyle { decimals: 2, ..TableStyle::default() };
    let table =
        lra(&program.steps, &LraLayout { clr_column: false, table: style, ..LraLayout::lra(mm(560.0)) })
            .unwrap();
    let cell = |row: usize, column: usize| -> f64 {
        table.lines().nth(row + 1).unwrap().split(',').nth(column).unwrap().parse().unwrap()
    };
    let expected = [(935.39, 0.0, 90.0), (8980.0, 180.0, 90.0), (1374.0, 90.37, 90.0)];
    for (row, (length, twist, angle)) in expected.into_iter().enumerate() {
        assert!((cell(row, 0) - length).abs() < 0.0101, "{table}");
        assert!((cell(row, 1).abs() - twist).abs() < 0.0101, "{table}");
        assert!((cell(row, 2) - angle).abs() < 0.0101, "{table}");
    }
    // The twist before the third bend has a sign: its mirror image would have -90.37.
    assert!(cell(2, 1) > 0.0);
    assert_eq!(table.lines().last().unwrap(), "5158.42,,", "hypot(5718.30, 36.89) - 560 = 5158.419");
}

#[test]
fn the_published_table_becomes_the_points() {
    let options = ReadOptions { clr: Some(mm(560.0)), ..ReadOptions::default() };
    let read = read(CREO_TABLE.as_bytes(), "creo.csv", None, &options).unwrap();
    assert_eq!(read.format, Format::Lra);
    let path = read.program.unwrap().path;
    // The table does not say where the wire lies: start it as Creo does, along z, first bend to y.
    let frame = Frame::looking(Point3::origin(), nalgebra::Vector3::z(), nalgebra::Vector3::y()).unwrap();
    let steps = import_steps(CREO_TABLE, &options);
    let placed = replay(frame, &steps);
    assert_eq!(path.len(), 5);
    for (ours, theirs) in placed.iter().zip(creo_points()) {
        // 0.005° of twist over 5718 mm is 0.5 mm; lengths are given to 0.01.
        let tolerance = 0.01 + 5718.3 * 0.005_f64.to_radians();
        assert!((ours - theirs).norm() < tolerance, "{ours} {theirs}");
    }
    // Corner to corner, without the twist's rounding, the table is exact.
    let lengths: Vec<f64> = steps.iter().map(|step| step.feed.mm()).collect();
    for (length, expected) in lengths.iter().zip([1495.39, 10100.0, 2494.0, 5718.41]) {
        assert!((length - expected).abs() < 0.01, "{lengths:?}");
    }
}

fn import_steps(table: &str, options: &ReadOptions) -> Vec<wirebend_core::bend::Step> {
    read(table.as_bytes(), "table.lra", None, options).unwrap().program.unwrap().program.steps
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
            "1 bend with a minus sign, taken as a bend to the other side",
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

#[test]
fn unsigned_angles_are_the_same_wire() {
    let steps = [step(30., 0., 45.), step(20., 30., -60.), step(25., -100., -90.), step(10., 0., 0.)];
    let layout = LraLayout { lengths: Lengths::Intersection, ..LraLayout::lra(mm(2.0)) };
    let table = lra(&steps, &layout).unwrap();
    assert!(table.lines().skip(1).all(|row| !row.split(',').nth(2).unwrap().starts_with('-')), "{table}");
    // Corner to corner, as the writer was told, is a table with a radius of 0.
    let back = import_steps(&table.replace("2.000", "0"), &ReadOptions::default());
    let (ours, theirs) = (replay(Frame::default(), &steps), replay(Frame::default(), &back));
    assert!(ours.iter().zip(&theirs).all(|(a, b)| (a - b).norm() < 0.01), "{table}");
}

#[test]
fn commands_in_any_order_make_the_same_wire() {
    // Bends in a row, a rotation before a feed, two rotations, no feed between two bends.
    let script =
        "FEED 10\nBEND 90\nROTATE 30\nROTATE 60\nBEND 20\nROTATE 15\nFEED 5\nBEND -30\nBEND 10\nFEED 7";
    let imported = import("a.dsw", script).unwrap();
    let steps = imported.program.as_ref().unwrap().program.steps.clone();
    let expected =
        [step(10., 0., 90.), step(0., 90., 20.), step(5., 15., -30.), step(0., 0., 10.), step(7., 0., 0.)];
    assert_eq!(steps, expected);
    // The turtle that takes the commands one by one ends at the same place.
    let mut frame = Frame::default();
    for line in script.lines() {
        let (command, value) = line.split_once(' ').unwrap();
        let value: f64 = value.parse().unwrap();
        match command {
            "FEED" => frame.feed(mm(value)),
            "ROTATE" => frame.rotate(Angle::from_deg(value).unwrap()),
            _ => frame.bend(Angle::from_deg(value).unwrap()),
        }
    }
    assert!((imported.program.unwrap().path.last().unwrap() - frame.position).norm() < 1e-12);
}

#[test]
fn a_script_that_ends_on_a_bend_keeps_it_and_says_so() {
    let imported = import("a.txt", "feed 10\nBend 90 (to the left)\n\nPINZ -5\nrotate 20\n").unwrap();
    assert_eq!(imported.format, Format::Pensa);
    assert_eq!(imported.program.unwrap().program.steps, [step(10., 0., 90.)]);
    expect_test::expect![[r#"
        [
            "1 comment ignored",
            "1 pin command ignored",
            "1 rotation at the end without effect ignored",
            "the program ends on a bend that no feed follows; it is kept",
        ]
    "#]]
    .assert_debug_eq(&notes(&imported.notes));
}

#[test]
fn a_node_that_is_passed_twice_is_one_vertex_and_a_strut_one_edge() {
    // A square, and its first side once more.
    let imported =
        import("a.txt", "# design 12\nF 10\nB 90\nF 10\nB 90\nF 10\nB 90\nF 10\nB 90\nF 10\n").unwrap();
    assert_eq!(imported.format, Format::Kit);
    let traversal: Vec<u32> = imported.program.unwrap().traversal.iter().map(|id| id.0).collect();
    assert_eq!(traversal, [0, 1, 2, 3, 0, 1]);
    assert_eq!((imported.wireframe.vertex_count(), imported.wireframe.edge_count()), (4, 4));
    assert!(notes(&imported.notes).contains(&"2 vertices merged into others".to_owned()));
    assert!(notes(&imported.notes).contains(&"1 duplicate edge merged".to_owned()));
}

#[test]
fn a_machine_that_counts_rotation_the_other_way_gives_the_mirror_image() {
    let script = "FEED 10\nBEND 90\nFEED 10\nROTATE 90\nBEND 90\nFEED 10";
    let opposite = Convention { rotate: Sign::Opposite, ..Convention::default() };
    let options = ReadOptions { convention: opposite, ..ReadOptions::default() };
    let end = |options: &ReadOptions| {
        *read(script.as_bytes(), "a.diw", None, options).unwrap().program.unwrap().path.last().unwrap()
    };
    assert!((end(&ReadOptions::default()) - Point3::new(10., 10., 10.)).norm() < 1e-12);
    assert!((end(&options) - Point3::new(10., 10., -10.)).norm() < 1e-12);
}

#[test]
fn units_scale_feeds_and_not_angles() {
    let options = ReadOptions { units: Some(LengthUnit::Inch), scale: 2.0, ..ReadOptions::default() };
    let imported = read(b"F 1\nB 45\nF 1", "a.txt", None, &options).unwrap();
    assert_eq!(imported.program.unwrap().program.steps, [step(50.8, 0., 45.), step(50.8, 0., 0.)]);
}

#[test]
fn a_polyline_is_closed_where_it_comes_back() {
    let imported = import("a.csv", "x;y;z\n0;0;0\n10,5;0;0\n10,5;10;0\n0;0;0\n").unwrap();
    assert_eq!(
        (imported.format, imported.wireframe.vertex_count(), imported.wireframe.edge_count()),
        (Format::Xyz, 3, 3)
    );
    assert!((imported.wireframe.vertex(VertexId(1)).unwrap().position.x - 10.5).abs() < 1e-12);
    let open = import("a.xyz", "0 0 0\n1 0 0\n1 1 0").unwrap();
    assert_eq!((open.wireframe.vertex_count(), open.wireframe.edge_count()), (3, 2));
    let named = import("a.csv", "id,z_inch,y,x\n1,1,2,3\n2,4,5,6\n").unwrap();
    let first = named.wireframe.vertex(VertexId(0)).unwrap().position;
    assert!((first - Point3::new(76.2, 50.8, 25.4)).norm() < 1e-9);
    assert_eq!(notes(&named.notes), ["the first row is a header", "1 column ignored"]);
}
