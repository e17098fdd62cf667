//! Programs of other tools: what their commands mean; and tables of points.

use nalgebra::Point3;
use wirebend_core::bend::{Convention, Frame, Sign};
use wirebend_core::units::Angle;
use wirebend_core::wireframe::VertexId;
use wirebend_files::read::{Format, LengthUnit, ReadOptions, read};

use super::{import, mm, notes, step};

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
            "the program ends on a bend that no feed follows: it makes no edge, so that a plan leaves it out; the program itself, when it is run, makes it",
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

/// What a driver writes for a machine begins with the hash of the design; a remark on a design says nothing.
#[test]
fn a_program_that_a_driver_wrote_is_known() {
    let hash = "0123456789abcdef".repeat(4);
    let told = |name: &str, text: String| import(name, text).unwrap().program.unwrap().told;
    assert!(told("a.txt", format!("# design {hash}\nF 10\n")));
    assert!(told("a.dsw", format!("(design {hash})\nFEED 10\n")));
    for text in ["F 10\n".to_owned(), "# design 12\nF 10\n".to_owned(), format!("# no design {hash}\nF 10\n")]
    {
        assert!(!told("a.txt", text));
    }
    assert!(!told("a.dsw", "(design by hand)\nFEED 10\n".to_owned()));
    // A table is of the finished part, whoever wrote it.
    assert!(!told("a.csv", format!("# design {hash}\nL,R,A\n10,0,0\n")));
}

#[test]
fn a_recording_is_a_program_whose_feeds_and_turns_between_two_bends_add_up() {
    let moves = r#"{"format": "wbmoves", "version": 1, "machine": "kit", "profile_hash": "", "moves": [
        {"move": "feed", "mm": 99}, {"move": "home"},
        {"move": "feed", "mm": 30}, {"move": "rotate", "deg": 40}, {"move": "feed", "mm": -5}, {"move": "rotate", "deg": 50},
        {"move": "bend", "deg": 45}, {"move": "feed", "mm": -2}, {"move": "bend", "deg": 10}, {"move": "feed", "mm": 20}]}"#;
    let imported = import("corner.wbmoves", moves).unwrap();
    let program = imported.program.as_ref().unwrap();
    assert_eq!(
        (imported.format, program.told, program.machine.as_deref()),
        (Format::Moves, true, Some("kit"))
    );
    assert_eq!(program.program.steps, [step(25., 90., 45.), step(0., 0., 10.), step(20., 0., 0.)]);
    let said = notes(&imported.notes);
    assert!(
        said.contains(&"1 move before the machine was homed left out: a wire begins anew there".to_owned())
    );
    assert!(said.contains(&"1 feed back behind a bend left out: no wire follows it".to_owned()), "{said:?}");
    // By its contents, too; and what is newer is not guessed.
    assert_eq!(wirebend_files::read::detect("corner.json", moves.as_bytes()).unwrap(), Format::Moves);
    let newer = moves.replace("\"version\": 1", "\"version\": 2");
    assert!(import("corner.wbmoves", &newer).unwrap_err().to_string().contains("version 2"));
}
