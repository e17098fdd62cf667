//! Tables by the units in the names of their columns, and rows in which nothing stands.

use wirebend_core::bend::Step;
use wirebend_files::read::{Format, LengthUnit, NoteKind, ReadOptions, pin_table, read};

use super::super::{import, step};

fn steps_of(table: &str) -> Vec<Step> {
    let imported = import("wire.csv", table).unwrap_or_else(|error| panic!("{error}\n{table}"));
    assert_eq!(imported.format, Format::Lra, "{table}");
    imported.program.unwrap().program.steps
}

fn assert_steps(table: &str, expected: &[Step]) {
    let steps = steps_of(table);
    assert_eq!(steps.len(), expected.len(), "{table}");
    for (ours, expected) in steps.iter().zip(expected) {
        let is_same = (ours.feed.mm() - expected.feed.mm()).abs() < 1e-6
            && (ours.rotate.deg() - expected.rotate.deg()).abs() < 1e-6
            && (ours.bend.deg() - expected.bend.deg()).abs() < 1e-6;
        assert!(is_same, "{table}{ours:?} {expected:?}");
    }
}

/// A foot is 304.8 mm, 1000 µm are one; π/2 radians are 90°, a quarter of a turn, and 100 gon.
#[test]
fn columns_are_in_the_unit_that_they_name() {
    let expected = [step(60.96, 0.0, 90.0), step(30.48, -90.0, 90.0), step(30.48, 0.0, 0.0)];
    for table in [
        "L (ft),R (turns),A [mrad]\n0.2,0,1570.796327\n0.1,-0.25,1570.796327\n0.1,,\n",
        "L_ft,R_rev,A (gon)\n0.2,0,100\n0.1,-0.25,100\n0.1,,\n",
        "Length in feet;Rotation in turns;Angle in rad\n0,2;0;1,570796327\n0,1;-0,25;1,570796327\n0,1;;\n",
        "L (um),R (°),A (deg.)\n60960,0,90\n30480,-90,90\n30480,,\n",
        "L [\u{b5}m],R,A\n60960,0,90\n30480,-90,90\n30480,,\n",
        "L (\"),R_deg,A\n2.4,0,90\n1.2,-90,90\n1.2,,\n",
        "\"L (\"\")\",\"R (°)\",\"A (°)\"\n2.4,0,90\n1.2,-90,90\n1.2,,\n",
        "L ('),R,A\n0.2,0,90\n0.1,-90,90\n0.1,,\n",
        "D_ft,R,A\n0.2,0,90\n0.3,-90,90\n0.4,,\n",
    ] {
        assert_steps(table, &expected);
    }
}

/// As people write beside a name what it means.
#[test]
fn words_in_brackets_that_are_no_units_leave_mm_and_degrees() {
    let expected = [step(10.0, 0.0, 90.0), step(20.0, 0.0, 0.0)];
    for header in [
        "Length,Rotation,bend (outside)",
        "L (length),R (rotation),Angle (bend)",
        "Y (feed),B (twist),C (bend)",
        "length (arc),R (plane),Bend (in/out)",
        "Length (in total),R (cw),Bend angle (max)",
    ] {
        assert_steps(&format!("{header}\n10,0,90\n20,,\n"), &expected);
    }
    assert_steps("L,R,A,Centerline rad\n7,0,90,3\n17,,,\n", &expected);
    // What is not read may be in any unit.
    assert_steps("L,R,A,Force (N),Speed (px/s),Wait (turn)\n10,0,90,1,2,3\n20\n", &expected);
    // An angle beside it says what "bend" is.
    assert_steps("L,R,Bend (mm),Angle\n10,0,14,90\n20\n", &expected);
}

#[test]
fn a_unit_that_is_not_read_is_refused_with_line_and_name() {
    let lengths = "a column of lengths in mm, cm, m, inch, ft or µm, or with no unit in its name";
    let angles = "a column of angles in deg, rad, mrad, gon or turns, or with no unit in its name";
    for (names, expected, header) in [
        (["L (yd)", "length [nm]", "L_thou", "Length in steps", "Feed (mm/min)"], lengths, "_,R,A"),
        (["length (deg)", "L_rad", "D (yd)", "Y (turns)", "L (%)"], lengths, "_,R,A"),
        (["A (arcmin)", "Angle_steps", "Bend angle (deg/s)", "Angle (ft)", "A (\")"], angles, "L,R,_"),
        (["bend (mm)", "Bend [inch]", "bend_cm", "Bend (steps)", "C in mm"], angles, "L,R,_"),
        (["R (turn)", "R (mm)", "Rotation [in]", "B_steps", "Twist (px)"], angles, "L,_,A"),
        (["CLR (deg)", "Radius [yd]", "Bend radius (turns)", "CLR_thou", "Radius in px"], lengths, "L,R,A,_"),
    ] {
        for name in names {
            let table = format!("# by hand\n\n{}\n1,0,1,1\n2\n", header.replace('_', name));
            let table = if header == "L,R,A,_" { table } else { table.replace("1,0,1,1", "1,0,1") };
            let refused = import("wire.csv", &table).unwrap_err();
            assert_eq!(
                refused.to_string(),
                format!("wire.csv, line 3: found \"{name}\", expected {expected}"),
                "{table}"
            );
        }
    }
    for name in ["x (px)", "x [pt]", "x (deg)", "x_yd"] {
        let refused = import("points.csv", format!("{name},y,z\n1,2,3\n4,5,6\n")).unwrap_err();
        assert_eq!(refused.to_string(), format!("points.csv, line 1: found \"{name}\", expected {lengths}"));
        assert_eq!(refused.line(), Some(1));
    }
    for (header, name) in [("pin (mm),left", "pin (mm)"), ("pin,loss_steps", "loss_steps")] {
        let refused = pin_table("pins.csv", format!("{header}\n20,10\n").as_bytes()).unwrap_err();
        assert_eq!(refused.to_string(), format!("pins.csv, line 1: found \"{name}\", expected {angles}"));
    }
}

/// Whoever says what the numbers are has the last word, but a length is no angle.
#[test]
fn a_unit_that_is_not_read_may_be_said() {
    let options = ReadOptions { units: Some(LengthUnit::Centimetre), ..ReadOptions::default() };
    let points = read(b"x (px),y (px),z (px)\n0,0,0\n3,0,0\n", "a.csv", None, &options).unwrap();
    let reach_mm = points.wireframe.vertices().map(|(_, vertex)| vertex.position.x).fold(0.0, f64::max);
    assert!((reach_mm - 30.0).abs() < 1e-9, "{reach_mm}");
    let bends = read(b"L (yd),R,A\n3,0,90\n4\n", "a.csv", None, &options).unwrap();
    assert!((bends.program.unwrap().program.steps[0].feed.mm() - 30.0).abs() < 1e-9);
    for notes in [points.notes, bends.notes] {
        assert!(notes.iter().any(|note| note.kind == NoteKind::UnitsOverridden), "{notes:?}");
    }
    assert!(read(b"L (deg),R,A\n3,0,90\n4\n", "a.csv", None, &options).is_err());
    assert!(read(b"L,R,A (yd)\n3,0,90\n4\n", "a.csv", None, &options).is_err());
}

/// Spreadsheets save a row that was cleared, or never filled, as separators alone.
#[test]
fn a_row_of_empty_cells_is_passed_over() {
    let expected = steps_of("L,R,A\n10,0,90\n20,90,45\n30\n");
    for table in [
        "L,R,A\n10,0,90\n,,\n20,90,45\n30,,\n",
        ",,\nL,R,A\n10,0,90\n20,90,45\n30,,\n,,\n,,\n",
        "L;R;A\n10;0;90\n;;\n ; ; \n20;90;45\n30;;\n",
        "L\tR\tA\n10\t0\t90\n\t\t\n20\t90\t45\n30\t\t\n",
        "\"Y\",\"B\",\"C\"\n\"10\",\"0\",\"90\"\n\"\",\"\",\"\"\n\"20\",\"90\",\"45\"\n\"30\",\"\",\"\"\n",
        "10,0,90\n,,\n20,90,45\n30,,\n,,\n",
    ] {
        assert_eq!(steps_of(table), expected, "{table}");
    }
    for table in ["x,y,z\n0,0,0\n,,\n10,0,0\n10,5,0\n", ",,\nx,y,z\n0,0,0\n10,0,0\n10,5,0\n,,\n"] {
        let wireframe = import("points.csv", table).unwrap().wireframe;
        assert_eq!((wireframe.vertex_count(), wireframe.edge_count()), (3, 2), "{table}");
    }
    // Lines are counted all the same, and a cell that is missing is still missing.
    for (table, line) in [
        ("x,y,z\n0,0,0\n,,\n,,\n1,2,x\n", "line 5"),
        (",,\nx (px),y,z\n0,0,0\n", "line 2"),
        ("x,y,z\n0,0,0\n,,3\n", "line 3"),
        ("x,y,z\n0,0,0\n-,-,-\n", "line 3"),
        ("L,R,A\n10,0,90\n,,\n,0,45\n20\n", "line 4"),
    ] {
        let refused = import("a.csv", table).unwrap_err().to_string();
        assert!(refused.starts_with(&format!("a.csv, {line}:")), "{table}{refused}");
    }
    let pairs = pin_table("pins.csv", b"pin,left\n20,10\n,\n40,25\n").unwrap();
    assert_eq!(pairs.iter().map(|pair| pair.line).collect::<Vec<_>>(), [2, 4]);
    assert!(import("a.csv", ",,\n,,\n").unwrap_err().to_string().contains("no points in it"));
}
