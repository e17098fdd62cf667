//! Tables of bends by the names of their columns: which holds the angle, and what is said of the others.

use wirebend_core::units::{DisplayUnit, written_in};
use wirebend_files::read::{Format, Imported, NoteKind, ReadOptions, read};

use super::super::{import, mm, notes};

/// Bends of 90° and 45° with a radius of 30, whatever else is said of them.
const NUMBERED: [&str; 8] = [
    "Bend #,Length,Rotation,Angle,CLR\n1,100,0,90,30\n2,200,90,45,30\n3,100\n",
    "Bend,Length,Rotation,Angle,CLR\n1,100,0,90,30\n2,200,90,45,30\n3,100\n",
    "Bend No;Length;Rotation;Bend angle [deg];Radius\n1;100;0;90;30\n2;200;90;45;30\n3;100\n",
    "Bend nr.,L,R,A,CLR\n1,100,0,90,30\n2,200,90,45,30\n3,100\n",
    "Bend number,Y,B,C,CLR\n1,100,0,90,30\n2,200,90,45,30\n3,100\n",
    "Bend,Y,B,C,CLR\n1,100,0,90,30\n2,200,90,45,30\n3,100\n",
    "Bend length,Length,Rotation,Bend [deg],CLR\n47.12,100,0,90,30\n23.56,200,90,45,30\n-,100\n",
    "Bend direction,Length,Bend rotation,Bend,CLR\n1,100,0,90,30\n1,200,90,45,30\n-,100\n",
];

fn of_bends(table: &str) -> Imported {
    read(table.as_bytes(), "wire.csv", Some(Format::Lra), &ReadOptions::default())
        .unwrap_or_else(|error| panic!("{error}\n{table}"))
}

fn bends_of(imported: &Imported) -> Vec<f64> {
    let steps = &imported.program.as_ref().unwrap().program.steps;
    steps.iter().map(|step| (step.bend.deg() * 1e6).round() / 1e6).collect()
}

#[test]
fn the_number_of_a_bend_is_not_its_angle() {
    for table in NUMBERED {
        let imported = import("wire.csv", table).unwrap_or_else(|error| panic!("{error}\n{table}"));
        assert_eq!((imported.format, bends_of(&imported)), (Format::Lra, vec![90.0, 45.0, 0.0]), "{table}");
        assert!(notes(&imported.notes).contains(&"1 column ignored".to_owned()), "{table}");
        // 100 mm and the tangent of the first bend.
        let feed_mm = imported.program.unwrap().program.steps[0].feed.mm();
        assert!((feed_mm - 130.0).abs() < 1e-9, "{table}");
    }
    // Where nothing else is the angle, it is.
    assert_eq!(bends_of(&of_bends("Length,Rotation,Bend\n100,0,90\n50\n")), [90.0, 0.0]);
}

#[test]
fn the_radius_of_a_bend_is_not_its_angle() {
    for name in ["Bend radius", "Bend CLR", "bend_radius_mm"] {
        let table = format!("Length,Rotation,{name},Bend angle\n100,0,30,90\n200,90,30,45\n100\n");
        let imported = of_bends(&table);
        assert_eq!(bends_of(&imported), [90.0, 45.0, 0.0], "{table}");
        let feed_mm = imported.program.unwrap().program.steps[0].feed.mm();
        assert!((feed_mm - 130.0).abs() < 1e-9, "{table}");
    }
}

#[test]
fn two_columns_that_hold_the_same_are_refused_with_both_names() {
    for (header, said) in [
        ("Length,Rotation,Angle,Bend angle", "the angle, not both \"Angle\" and \"Bend angle\""),
        ("Length,Feed,R,A", "the length, not both \"Length\" and \"Feed\""),
        ("L,R,Twist,A", "the rotation, not both \"R\" and \"Twist\""),
        ("L,A,CLR,Bend radius", "the radius, not both \"CLR\" and \"Bend radius\""),
    ] {
        let refused = import("wire.csv", format!("{header}\n10,20,30,40\n10\n")).unwrap_err();
        assert!(refused.to_string().contains(said), "{refused}");
        assert_eq!(refused.code(), "read-syntax");
    }
    // A radius of no use, and coordinates beside letters of LRA, leave open nothing.
    assert_eq!(bends_of(&of_bends("Lcorner,R,A,CLR,Radius\n10,0,90,3,4\n10\n")), [90.0, 0.0]);
    assert_eq!(bends_of(&of_bends("N,L,R,A,X,Y,Z\n1,10,0,90,5,6,7\n2,10\n")), [90.0, 0.0]);
}

#[test]
fn a_table_without_rotations_says_that_it_is_flat() {
    let said = |table: &str| {
        let imported = of_bends(table);
        imported.notes.iter().any(|note| note.kind == NoteKind::RotationMissing)
    };
    assert!(said("Length,Plane,Angle\n10,0,90\n20,90,45\n10\n"));
    for table in
        ["L,R,A\n10,0,90\n20,90,45\n10\n", "Lcorner,Rabs,A\n10,0,90\n10\n", "10,0,90\n20,90,45\n10\n"]
    {
        assert!(!said(table), "{table}");
    }
    let message = "no column has the rotations: all bends are taken in one plane".to_owned();
    assert!(notes(&of_bends("L,A\n10,90\n20,45\n10\n").notes).contains(&message));
}

/// A wire for another machine has its radius in every bend: a person has to know that these are not in the design.
#[test]
fn radii_that_a_wireframe_does_not_keep_are_said() {
    let radii = |table: &str| {
        let said = notes(&of_bends(table).notes);
        said.into_iter()
            .filter(|note| note.contains("radi") && note.contains("corners alone"))
            .collect::<Vec<_>>()
    };
    let alone = "of which a wireframe keeps the corners alone";
    let table = "L,R,A,CLR\n100,0,90,30\n200,90,45,60\n100\n";
    assert_eq!(radii(table), [format!("2 bends have radii of 30 mm to 60 mm, {alone}")]);
    assert_eq!(radii("L,R,A,CLR\n40,0,90,4.5\n20\n"), [format!("1 bend has a radius of 4.5 mm, {alone}")]);
    assert_eq!(radii("40 0 90 3\n40 0 90 3\n20\n"), [format!("2 bends have radii of 3 mm, {alone}")]);
    let inches = "L,R,A,CLR_inch\n4,0,90,0.5\n4\n";
    assert_eq!(radii(inches), [format!("1 bend has a radius of 12.7 mm, {alone}")]);
    written_in(
        || DisplayUnit::Inch,
        || assert_eq!(radii(inches), [format!("1 bend has a radius of 0.500 in, {alone}")]),
    );
    // What has no arc is the corner, and what is straight has neither.
    for table in ["L,R,A,CLR\n40,0,90,0\n20\n", "L,R,A,CLR\n40,0,0,30\n20\n", "L,R,A\n40,0,90\n20\n"] {
        assert!(radii(table).is_empty(), "{table}");
    }
    // A radius that a person says is no column that is dropped.
    let options = ReadOptions { clr: Some(mm(5.0)), ..ReadOptions::default() };
    let told = read(b"L,R,A\n40,0,90\n20\n", "wire.csv", None, &options).unwrap();
    assert!(told.notes.iter().all(|note| note.kind != NoteKind::RadiiLost));
}

/// Without it the bends would stand on each other, and another part would come out.
#[test]
fn a_bend_needs_a_length_before_it() {
    for table in ["L,R,A,CLR\n10,0,90,3\n,0,45,3\n20,,,\n", "L,R,A\n10,0,90\n-,0,45\n20\n"] {
        let refused = import("wire.csv", table).unwrap_err().to_string();
        assert!(
            refused.contains("wire.csv, line 3") && refused.contains("a length before the bend"),
            "{refused}"
        );
    }
    let imported = import("wire.csv", "L,R,A\n10,0,90\n20,0,45\n20,,\n").unwrap();
    assert_eq!(bends_of(&imported), [90.0, 45.0, 0.0]);
}
