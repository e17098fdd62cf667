//! Readings that are wrong, missing or too few: what is said of them, and what is fitted all the same.

use crate::run_in;

#[test]
fn what_cannot_be_read_or_fitted_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &[&str]| run_in(folder.path(), arguments, b"");
    run(&["calibrate", "new", "--machine", "wirebend-kit", "-o", "calibration"]).ended(0);
    let said = run(&["calibrate", "fit", "calibration/sheet.csv"]).ended(3).err;
    assert!(said.contains("no readings"), "{said}");
    for (typed, says) in [
        ("angle-40=38", "angle-40:2"),
        ("angle-41:1=38", "first column"),
        ("angle-40:1=38,abc", "numbers"),
        ("angle-40:1=nan", "numbers"),
        ("side-35=38,7", "point"),
        ("angle-40:2=-38,5,-39,12", "point"),
        ("angle-40:3=38", "counted from 1"),
    ] {
        let said = run(&["calibrate", "enter", "calibration/sheet.csv", typed]).ended(2).err;
        assert!(said.contains(says), "{typed}: {said}");
    }
    let broken = std::fs::read_to_string(folder.path().join("calibration/sheet.csv"))
        .unwrap()
        .replacen("bend,", "bent,", 1);
    std::fs::write(folder.path().join("broken.csv"), broken).unwrap();
    let said = run(&["calibrate", "fit", "broken.csv"]).ended(3).err;
    assert!(said.contains("broken.csv, line 6: found \"bent\""), "{said}");
    let too_far = ["calibrate", "new", "--machine", "wirebend-kit", "--angles", "90,170", "-o", "other"];
    let twice = ["calibrate", "new", "--machine", "wirebend-kit", "--angles", "90,40,90", "-o", "other"];
    assert!(run(&twice).ended(2).err.contains("--repeats"), "two coupons of one name");
    let said = run(&too_far).ended(2).err;
    assert!(said.contains("170.0°") && !folder.path().join("other").exists(), "{said}");
}

/// Readings that tell little: each is a sentence that says what is missing or wrong, and what is fitted all the same.
#[test]
fn of_poor_readings_it_is_said_what_is_missing_and_what_is_fitted() {
    let bends_alone = [
        "no sides were measured: K-factor and feed stay as they are in the profiles",
        "no turns of the head were measured: nothing is said of the head",
    ];
    let ladder = "angle-30:1=29,28.8 angle-30:2=-29,-28.8 angle-60:1=59,58.8 angle-60:2=-59,-58.8 \
                  angle-90:1=89,88.8 angle-90:2=-89,-88.8";
    let one_side =
        "no bend to the negative side was measured: springback and bend head are fitted from the other one";
    for (readings, pin_table, says, fitted) in [
        ("angle-30:1=29 angle-60:1=58.8 angle-90:1=88.7", "", &[one_side, bends_alone[0]][..], "springback "),
        (
            "angle-60:1=58.5,58.9",
            "",
            &["all bends were commanded alike, ", "measure another angle", one_side],
            "springback ",
        ),
        (
            ladder,
            "pin,left\n60,40\n170,121\n",
            &["121.0° belongs to a position that the bend axis does not reach: it goes to 155"],
            "orbit radius R",
        ),
        (
            "angle-30:1=-,- angle-60:1=-,- side-35:1=37.9,38.0 side-140:1=143,143.1",
            "",
            &["no bends were measured: springback and bend head stay as they are in the profiles"],
            "wire per commanded mm",
        ),
        (
            "angle-30:1=0.51,29 angle-60:1=120,-59 angle-60:2=-59,59 angle-90:1=89,88.8 angle-90:2=-89,-88.9 \
             side-35:1=1.49,37.9 side-140:1=14.3,143.1",
            "",
            &[
                "0.5° seems to be in radians",
                "120.0° seems to be the angle between the legs instead of the bend",
                "-59.0° is to the other side than was commanded",
                "1.49 mm seems to be in inches; about 37.93 mm was to be expected",
                "14.30 mm seems to be in centimetres",
            ],
            "K-factor",
        ),
        (
            "turn-90:1=90.5,90 turn-90:2=-89,-",
            "",
            &[
                "offset and backlash of turns differ from those of the profile by less than they are known: both stay",
            ],
            "backlash of a turn",
        ),
        (
            "turn-90:1=88,88.1 turn-90:2=-92,-92.1",
            "",
            &["a backlash below zero cannot be: both stay as the profile has them"],
            "backlash of a turn",
        ),
        (
            "turn-90:1=91,91.2",
            "",
            &["no turn goes back: the offset of turns is fitted", "no bends were measured"],
            "offset of a turn",
        ),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let run = |arguments: &[&str]| run_in(folder.path(), arguments, b"");
        let new = ["calibrate", "new", "--machine", "wirebend-kit", "--angles", "30,60,90", "-o", "coupons"];
        run(&new).ended(0);
        let enter = ["calibrate", "enter", "coupons/sheet.csv"];
        for reading in readings.split_whitespace() {
            run(&[&enter[..], &[reading]].concat()).ended(0);
        }
        if !pin_table.is_empty() {
            std::fs::write(folder.path().join("pins.csv"), pin_table).unwrap();
            run(&[&enter[..], &["--pin-table", "pins.csv"]].concat()).ended(0);
        }
        let ran = run(&["calibrate", "fit", "coupons/sheet.csv"]).ended(0);
        let said = ran.err.clone() + &String::from_utf8(ran.out).unwrap();
        for sentence in says {
            assert!(said.contains(sentence), "{readings}: no \"{sentence}\" in\n{said}");
        }
        assert!(said.lines().any(|line| line.trim_start().starts_with(fitted)), "{readings}: {said}");
    }
}

/// Wrong readings that fit each other well: they are named, and so is their sheet where a profile cannot hold what they tell.
#[test]
fn what_cannot_be_is_doubted_with_the_lines_of_its_readings() {
    for (readings, warns, refused) in [
        // Both sides are less by a wire, as from middle to middle, or by two: read inside.
        ("side-35:1=35.2,35.3 side-140:1=140.2,140.3", "the K-factor is found to be 0.", false),
        ("side-35:1=32,32.1 side-140:1=137,137.1", "the K-factor is found to be 1.", true),
        ("turn-90:1=0,0,0,0,0 turn-90:2=0,0,0,0,0", "the offset of a turn is found to be -", true),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let run = |arguments: &[&str]| run_in(folder.path(), arguments, b"");
        let new = ["calibrate", "new", "--machine", "wirebend-kit", "--angles", "60,90", "-o", "coupons"];
        run(&new).ended(0);
        for reading in readings.split_whitespace() {
            run(&["calibrate", "enter", "coupons/sheet.csv", reading]).ended(0);
        }
        let lines = if readings.starts_with("side") { "lines 10 and 11" } else { "lines 12 and 13" };
        let ran = run(&["calibrate", "fit", "coupons/sheet.csv"]).ended(0);
        let said = ran.err.clone() + &String::from_utf8(ran.out).unwrap();
        assert!(
            said.contains("warning") && said.contains(warns) && said.contains(lines),
            "{readings}: {said}"
        );
        let apply = ["calibrate", "apply", "coupons/sheet.csv", "--machine-id", "tt", "--material-id", "ww"];
        let ran = run(&apply);
        assert_eq!(ran.status, if refused { 3 } else { 0 }, "{readings}: {}", ran.err);
        assert!(ran.err.contains(warns) && ran.err.contains(lines), "{readings}: {}", ran.err);
        assert!(
            !refused || ran.err.contains("coupons/sheet.csv: ") && !ran.err.contains("tt.json"),
            "{}",
            ran.err
        );
    }
}
