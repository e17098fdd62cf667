//! `frame --close` and `tolerance`: frames of bent wire whose joints are closed.

use serde_json::Value;

use crate::frames::{data, frame, near};
use crate::{assert_fits, example, run, run_in};

const TRUSS: [&str; 8] =
    ["--units", "mm", "--material", "steel-0-9mm", "--machine", "pensa-diwire-pro", "--double", "--json"];

fn faces(folder: &std::path::Path) -> String {
    let file = folder.join("faces.json");
    let list = |from: u32| (from..from + 12).map(|id| id.to_string()).collect::<Vec<_>>().join(",");
    std::fs::write(&file, format!("[[{}],[{}]]", list(0), list(12))).unwrap();
    file.display().to_string()
}

/// The same wires for the same seed, whichever processor draws them; and one of them more changes the rest by nothing.
#[test]
fn closed_joints_depend_on_the_seed_alone() {
    let folder = tempfile::tempdir().unwrap();
    let faces = faces(folder.path());
    let close = |rest: &[&str]| {
        let closing = ["--supports", "free", "--close", "--errors", "bend-forming", "--faces", &faces];
        frame(&example("truss-1.obj"), &[&TRUSS[..], &closing, rest].concat()).ended(0).json()
    };
    let first = close(&["--runs", "12", "--seed", "3"]);
    assert_fits("frame", &first);
    assert_eq!(first["runs"], 12);
    assert!(first["static"].is_null());
    let again = close(&["--runs", "12", "--seed", "3"]);
    assert_eq!((&first["closing"], &first["of_runs"]), (&again["closing"], &again["of_runs"]));
    assert_ne!(first["closing"], close(&["--runs", "12", "--seed", "4"])["closing"]);
    // With faces, the vertices count as they do without: the same wires.
    let without =
        ["--supports", "free", "--close", "--errors", "bend-forming", "--runs", "12", "--seed", "3"];
    let whole = frame(&example("truss-1.obj"), &[&TRUSS[..], &without].concat()).ended(0).json();
    assert_eq!((&first["closing"]["faces"], &whole["closing"]["faces"]), (&2.into(), &Value::Null));
    assert_eq!(whole["closing"]["surface_rms_mm"], whole["closing"]["vertices_rms_mm"]);
    assert_eq!(first["closing"]["vertices_rms_mm"], whole["closing"]["vertices_rms_mm"]);
    assert_ne!(first["closing"]["surface_rms_mm"], whole["closing"]["surface_rms_mm"]);
    let closing = &first["closing"];
    let of = |key: &str| closing[key].as_f64().unwrap();
    assert!(
        of("gap_mm") > 10.0 * of("surface_rms_mm"),
        "passes are far apart before they are pulled together"
    );
    // The root of the mean square is above the mean by what the runs spread.
    let (mean, sd) = (&first["of_runs"]["mean"]["axial_rms_n"], &first["of_runs"]["sd"]["axial_rms_n"]);
    // Of 12 wires the squares from their own mean are shared out to 11.
    let square = mean.as_f64().unwrap().powi(2) + sd.as_f64().unwrap().powi(2) * 11.0 / 12.0;
    near(&closing["axial_rms_n"], square.sqrt(), 1e-9);
    let one = close(&["--runs", "1"]);
    assert_fits("frame", &one);
    assert!(one["of_runs"]["sd"].is_null(), "one wire does not say how much others differ");
    assert!(one["of_runs"]["mean"]["axial_rms_n"].is_number());
    let coupled = close(&["--runs", "12", "--seed", "3", "--closing", "coupled"]);
    assert!(coupled["closing"]["axial_rms_n"].as_f64().unwrap() > 1.2 * of("axial_rms_n"), "bowed struts");
    assert!(coupled["closing"]["largest_pull_n"].is_null());
    // 0.33 kJ a gram at 25 W (Bend-Forming, Table 1).
    let wire_g = first["resources"]["wire_g"].as_f64().unwrap();
    near(&first["resources"]["energy_kj"], 0.33 * wire_g, 1e-9);
    near(&first["resources"]["time_min"], 0.33 * wire_g * 1000.0 / 25.0 / 60.0, 1e-9);
}

/// Joints are closed with the wire that is bent, whatever the file says that its struts are: round PLA of 3 mm here, and no round at all
/// in the other.
#[test]
fn joints_are_closed_with_the_wire_that_is_planned() {
    let machine = ["--machine", "pensa-diwire-pro", "--double", "--json"];
    for (name, length_mm) in [("four-frame", 0.0), ("uniform_load_analytical_model", 13_000.0)] {
        let model = data(&format!("conmech/{name}.json"));
        let close = |rest: &[&str]| {
            let closing = ["--supports", "free", "--close", "--errors", "bend-forming", "--runs", "3"];
            frame(&model, &[&machine[..], &closing, rest].concat()).ended(0).json()
        };
        let (of_file, chosen) = (close(&[]), close(&["--material", "steel-0-9mm"]));
        assert_eq!((&of_file["closing"], &of_file["resources"]), (&chosen["closing"], &chosen["resources"]));
        let codes = of_file["notes"].as_array().unwrap().iter().map(|note| note["code"].as_str().unwrap());
        assert!(codes.collect::<Vec<_>>().contains(&"closed-with-wire"), "{name}: {}", of_file["notes"]);
        assert!(of_file["material"] != chosen["material"], "loads act on what the file says");
        if length_mm > 0.0 {
            // Steel of 7800 kg/m³ and 0.9 mm; every edge once.
            let grams = 7.8e-3 * std::f64::consts::PI * 0.45 * 0.45 * length_mm;
            near(&of_file["resources"]["wire_g"], grams, 1e-3);
        }
        let tolerance = [&["tolerance", model.as_str()], &machine[..], &["--require", "surface=1"]].concat();
        assert_eq!(run(&tolerance).ended(0).json()["material"], "steel-0-9mm");
    }
}

/// The first wire that is drawn, closed: a line for each strut that it walks along, also where it does so twice.
#[test]
fn the_first_closed_wire_is_written_for_other_programs() {
    let folder = tempfile::tempdir().unwrap();
    let truss = example("truss-1.obj");
    let closing = ["--supports", "free", "--close", "--errors", "bend-forming"];
    let ran = |rest: &[&str]| {
        run_in(folder.path(), &[&["frame", &truss], &TRUSS[..], &closing, rest].concat(), b"")
    };
    let one = ran(&["--runs", "1", "--closed-vtk", "closed.vtk"]).ended(0).json();
    assert_eq!(one["files"], serde_json::json!(["closed.vtk"]));
    let text = std::fs::read_to_string(folder.path().join("closed.vtk")).unwrap();
    let figures = |name: &str| -> Vec<f64> {
        let (_, after) =
            text.split_once(&format!("SCALARS {name} double 1\nLOOKUP_TABLE default\n")).unwrap();
        after.lines().map_while(|line| line.parse().ok()).collect()
    };
    let forces = figures("axial_n");
    assert!(forces.len() > 78, "struts that are doubled: {}", forces.len());
    let count = f64::from(u32::try_from(forces.len()).unwrap());
    let mean_square = |figures: &[f64]| figures.iter().map(|x| x * x).sum::<f64>() / count;
    near(&one["closing"]["axial_rms_n"], mean_square(&forces).sqrt(), 1e-9);
    near(&one["closing"]["von_mises_rms_mpa"], mean_square(&figures("von_mises_rms_mpa")).sqrt(), 1e-9);
    // It is the first of however many.
    let before = text.clone();
    ran(&["--runs", "5", "--closed-vtk", "closed.vtk", "--force"]).ended(0);
    assert_eq!(std::fs::read_to_string(folder.path().join("closed.vtk")).unwrap(), before);
    ran(&["--closed-vtk", "closed.vtk"]).ended(2);
    ran(&["--expected", "--closed-vtk", "other.vtk"]).ended(2);
}

#[test]
fn an_expectation_is_for_straight_struts() {
    let close = ["--supports", "free", "--close", "--expected", "--errors"];
    let with = |errors: &str| frame(&example("truss-1.obj"), &[&TRUSS[..], &close, &[errors]].concat());
    let none = with("none").ended(0).json();
    assert_eq!(none["closing"]["axial_rms_n"], 0.0);
    assert!(none["runs"].is_null());
    let said = with("bend-forming").ended(3).json();
    assert_eq!(said["error"]["code"], "closing-joints");
    assert!(said["error"]["message"].as_str().unwrap().contains("bowed"), "{said}");
    assert_eq!(said["error"]["help"][0], "leave out --expected");
}

/// The reflector of Bend-Forming: 50 m across, 50 mm deep, true within 1 mm, 5 N in its struts.
#[test]
fn a_reflector_asks_for_feeds_within_micrometres() {
    let arguments =
        ["tolerance", "--continuum", "408,50,50000", "--material", "steel-0-9mm", "--json", "--require"];
    let require = |limits: &str| run(&[&arguments[..], &[limits]].concat());
    let surface = require("surface=1mm").ended(0).json();
    assert_fits("tolerance", &surface);
    near(&surface["feed_sigma_mm"], 8.40e-3, 1e-3);
    assert_eq!(surface["governed_by"], "surface");
    let both = require("surface=1mm,force=5N").ended(0).json();
    near(&both["feed_sigma_mm"], 4.168e-3, 1e-3);
    assert_eq!(both["governed_by"], "force");
    assert_eq!(require("stress=100MPa").ended(2).json()["error"]["code"], "only-lengths");
    let of_wires = [&arguments[..], &["surface=1mm", "--weld", "1", "--double"]].concat();
    let refused = run(&of_wires).ended(2).json()["error"]["message"].as_str().unwrap().to_owned();
    assert!(
        refused.contains("only with a wireframe, in place of --continuum: --weld, --double"),
        "{refused}"
    );
}

#[test]
fn half_of_what_is_required_takes_half_the_errors() {
    let folder = tempfile::tempdir().unwrap();
    let faces = faces(folder.path());
    let file = example("truss-1.obj");
    let tolerance = |rest: &[&str]| {
        run(&[&["tolerance", &file], &TRUSS[..], &["--faces", &faces], rest].concat()).ended(0).json()
    };
    let whole = tolerance(&["--require", "surface=0.2,force=1000"]);
    let half = tolerance(&["--require", "surface=0.1"]);
    let of = |found: &Value| found["feed_sigma_mm"].as_f64().unwrap();
    near(&(2.0 * of(&half)).into(), of(&whole), 1e-9);
    near(&whole["achieved"]["surface_mm"], 0.2, 1e-9);
    assert!(whole["angle_sigma_deg"].is_null());
    // Two faces are not off by the same shares of both, and their mean is met with a little less than half of the square for each.
    let both = tolerance(&["--require", "surface=0.2", "--vary", "both"]);
    near(&both["achieved"]["surface_mm"], 0.2, 1e-9);
    let angles = tolerance(&["--require", "surface=0.2", "--vary", "angle"]);
    let angle = |found: &Value| found["angle_sigma_deg"].as_f64().unwrap();
    let share = of(&both) / of(&whole);
    assert!(share <= 0.5_f64.sqrt() * (1.0 + 1e-9), "{share}");
    near(&(angle(&both) / angle(&angles)).into(), share, 1e-9);
    // What can hardly be reached by angles is no figure to build by, and where struts yield before that, it is said.
    let codes = |found: &Value| -> Vec<String> {
        found["notes"]
            .as_array()
            .unwrap()
            .iter()
            .map(|note| note["code"].as_str().unwrap().to_owned())
            .collect()
    };
    let far = codes(&tolerance(&["--require", "surface=5", "--vary", "angle"]));
    assert!(
        ["beyond-proportion", "struts-yield"].iter().all(|code| far.iter().any(|one| one == code)),
        "{far:?}"
    );
    let near_enough = codes(&tolerance(&["--require", "force=2"]));
    assert!(
        !near_enough.iter().any(|code| code == "beyond-proportion" || code == "struts-yield"),
        "{near_enough:?}"
    );
    // Of one face squares add.
    let list = (0..12).map(|id| id.to_string()).collect::<Vec<_>>().join(",");
    std::fs::write(folder.path().join("faces.json"), format!("[[{list}]]")).unwrap();
    let [one, both] = ["feed", "both"].map(|vary| tolerance(&["--require", "surface=0.2", "--vary", vary]));
    assert!(both["angle_sigma_deg"].as_f64().unwrap() > 0.0);
    near(&(of(&both) / of(&one)).into(), 0.5_f64.sqrt(), 1e-9);
}

/// Half of an edge is no small deviation, and what grows in proportion up to there is not known.
#[test]
fn a_tolerance_of_much_of_a_strut_is_no_figure_to_build_by() {
    let cube = example("cube-8-edges.obj");
    let asked = ["tolerance", &cube, "--units", "mm", "--machine", "wirebend-kit", "--json", "--require"];
    let has_note = |require: &str| {
        let found = run(&[&asked[..], &[require]].concat()).ended(0).json();
        found["notes"].as_array().unwrap().iter().any(|note| note["code"] == "beyond-proportion")
    };
    assert!(has_note("stress=2000MPa") && !has_note("stress=10MPa"));
}

/// A wire that closes no loop is pulled nowhere: no feed is too long for its forces. What was left by rounding set limits of 10^12 mm.
#[test]
fn what_pulls_at_nothing_has_no_tolerance() {
    for file in ["u-sample.obj", "spring.obj"] {
        let wire = example(file);
        let asked = ["tolerance", &wire, "--units", "mm", "--machine", "wirebend-kit", "--json"];
        for require in ["force=5N", "stress=100MPa"] {
            for vary in ["feed", "angle", "both"] {
                let refused =
                    run(&[&asked[..], &["--require", require, "--vary", vary]].concat()).ended(2).json();
                assert_eq!(refused["error"]["code"], "no-limit", "{file}, {require}, {vary}");
            }
        }
    }
}

/// Table 1 of Bend-Forming, from the scripts that its authors bent: length, bends and mass; energy and time by its factors.
#[test]
fn the_authors_scripts_take_what_table_1_has() {
    let machine = ["--machine", "pensa-diwire-pro", "--material", "steel-0-9mm", "--keep-order", "--json"];
    let closing = ["--supports", "free", "--close", "--errors", "bend-forming", "--runs", "1"];
    // Those of the bunny and the dish are fed straight past vertices and never stop there.
    for (script, weld_mm, length_m, bends, wire_g) in [
        ("AccuracyTest_TetraTruss.txt", "0.5", 5.589, 79, 27.7),
        ("AccuracyTest_BunnyPath.txt", "1", 11.887, 176, 59.0),
        ("dish_prototype.txt", "0.5", 28.529, 241, 141.6),
        ("isogrid_prototype.txt", "0.5", 27.362, 271, 135.8),
    ] {
        let script = data(&format!("bend-forming/{script}"));
        let found = frame(&script, &[&machine[..], &["--weld", weld_mm], &closing].concat()).ended(0).json();
        let takes = &found["resources"];
        near(&takes["length_mm"], 1000.0 * length_m, 1e-3);
        assert_eq!(takes["bends"], bends, "{script}");
        // As the paper prints it, and by its steel of 7800 kg/m³.
        assert!((takes["wire_g"].as_f64().unwrap() - wire_g).abs() < 0.051, "{takes}");
        near(&takes["wire_g"], length_m * std::f64::consts::PI * 0.45 * 0.45 * 7.8, 1e-3);
        let mass = takes["mass_g"].as_f64().unwrap();
        near(&takes["energy_kj"], 0.33 * mass, 1e-9);
        near(&takes["time_min"], 0.33 * mass * 1000.0 / 25.0 / 60.0, 1e-9);
    }
}

/// Eq 8 with the factor of the authors' sheet, and where it is not known.
#[test]
fn closed_formulas_have_the_first_frequency_of_few_rings() {
    let found = |truss: &str, rest: &[&str]| {
        let of = ["tolerance", "--continuum", truss, "--material", "steel-0-9mm", "--json", "--require"];
        run(&[&of[..], &["surface=1mm"], rest].concat())
    };
    let three = found("3,50,428.660705", &["--bow", "0.03"]).ended(0).json();
    assert_fits("tolerance", &three);
    near(&three["first_frequency"]["straight_hz"], 1085.2, 1e-3);
    near(&three["first_frequency"]["bowed_hz"], 185.2, 1e-3);
    // Shares of the stiffness of an arc on its own, of which frequencies are the roots.
    near(&three["first_frequency"]["bowed_between_hz"][0], 1085.2 * 0.0274_f64.sqrt(), 3e-3);
    near(&three["first_frequency"]["bowed_between_hz"][1], 1085.2 * 0.144_f64.sqrt(), 3e-3);
    let many = found("408,50,50000", &[]).ended(0).json();
    assert_eq!((&many["first_frequency"], &many["notes"]), (&Value::Null, &serde_json::json!([])));
    let many = found("408,50,50000", &["--bow", "0.01"]).ended(0).json();
    assert_eq!(many["notes"][0]["code"], "frequency-not-fitted");
    let wrong = found("3,50,428", &["--bow", "0.6"]).ended(2);
    assert!(String::from_utf8_lossy(&wrong.out).contains("from 0 to 0.5"));
}
