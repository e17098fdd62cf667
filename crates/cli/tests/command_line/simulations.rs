//! Simulations: on the simulated machine where there is one, by formulas where there is none.

use std::fmt::Write as _;

use serde_json::{Value, json};

use crate::{assert_fits, example, run_in};

fn simulated(machine: &str, name: &str, more: &[&str]) -> Value {
    let folder = tempfile::tempdir().unwrap();
    let plan = ["plan", &example(name), "-m", machine, "--despite-errors", "-o", "a.wbjob"];
    run_in(folder.path(), &plan, b"");
    let simulate = [&["simulate", "a.wbjob", "--json"], more].concat();
    let found = run_in(folder.path(), &simulate, b"").ended(0).json();
    assert_fits("simulate", &found);
    found
}

fn worst(found: &Value, figure: &str) -> f64 {
    found["wires"][0][figure].as_f64().unwrap()
}

/// The formulas undo what the formulas did, and so find nothing. The bench of the simulated machine does not know
/// them: it finds what they leave. The published cube stays within half a millimetre.
#[test]
fn the_simulated_machine_sees_what_formulas_cannot() {
    let kit = simulated("wirebend-kit", "cube-8-edges.obj", &[]);
    assert_eq!(kit["model"], "simulated-machine");
    let off = worst(&kit, "worst_machine_mm");
    assert!(off > 1e-3 && off < 0.5, "{off}");
    assert!(worst(&kit, "worst_systematic_mm") < 1e-6);
    let of_vertices = kit["wires"][0]["vertices"].as_array().unwrap();
    let largest = of_vertices.iter().map(|vertex| vertex["machine_mm"].as_f64().unwrap()).fold(0.0, f64::max);
    assert_eq!((of_vertices.len(), largest.to_bits()), (9, off.to_bits()));
    // Vertex 6 is passed twice: first and last distances are of the same place in the design.
    let gap = kit["wires"][0]["gaps"][0]["machine_mm"].as_f64().unwrap();
    assert!(gap > 0.0 && gap <= 2.0 * off, "{gap}");
    assert_eq!(kit["notes"], serde_json::json!([]), "nothing went wrong on the machine");

    let pensa = simulated("pensa-diwire-pro", "cube-8-edges.obj", &[]);
    assert_eq!(
        (&pensa["model"], &pensa["wires"][0]["worst_machine_mm"]),
        (&"closed-form".into(), &Value::Null)
    );
    assert!(worst(&pensa, "worst_systematic_mm") < 1e-6);
}

/// Of a machine that takes whole millimetres and degrees the formulas see nothing. Its own commands, read as a program that was
/// compensated for it, are the wire that it makes.
#[test]
fn what_a_machine_rounds_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &[&str]| run_in(folder.path(), arguments, b"").ended(0);
    let mut text = String::new();
    let (mut at, mut way) = ([0.0, 0.0_f64], 0.0_f64);
    writeln!(text, "v 0 0 0").unwrap();
    for (k, (side, corner)) in
        [(50.3, 37.4), (41.6, 61.3), (60.2, -48.7), (33.4, 0.0)].into_iter().enumerate()
    {
        at = [at[0] + side * way.cos(), at[1] + side * way.sin()];
        way += f64::to_radians(corner);
        writeln!(text, "v {} {} 0\nl {} {}", at[0], at[1], k + 1, k + 2).unwrap();
    }
    std::fs::write(folder.path().join("a.obj"), text).unwrap();
    run(&["plan", "a.obj", "--units", "mm", "-m", "howtomechatronics", "-o", "a.wbjob"]);
    let found = run(&["simulate", "a.wbjob", "--json"]).json();
    assert_eq!(found["resolution"], json!({ "feed_mm": 1.0, "rotate_deg": 1.0, "bend_deg": 1.0 }));
    let told = worst(&found, "worst_rounded_mm");
    run(&["export", "a.wbjob", "-o", "a.txt"]);
    let commands = std::fs::read_to_string(folder.path().join("a.txt")).unwrap();
    let names = [('f', 'F'), ('z', 'R'), ('b', 'B')];
    let kit: String = commands
        .split_whitespace()
        .filter_map(|word| {
            let (_, name) = names.into_iter().find(|(letter, _)| word.starts_with(*letter))?;
            Some(format!("{name} {}\n", word[1..].parse::<f64>().ok()?))
        })
        .collect();
    std::fs::write(folder.path().join("told.txt"), kit).unwrap();
    let plan = ["plan", "told.txt", "-m", "howtomechatronics", "--program", "compensated", "--json"];
    let made = run(&plan).json();
    // A turtle in the plane: its corners all lie in one, and so no rotation does more than turn the next bend over.
    let places = |plan: &Value| {
        let (mut at, mut way, mut side) = ([0.0, 0.0_f64], 0.0_f64, 1.0);
        let step = |step: &Value| {
            let figure = |name: &str| step[name].as_f64().unwrap();
            at = [at[0] + figure("feed_mm") * way.cos(), at[1] + figure("feed_mm") * way.sin()];
            side *= figure("rotate_deg").to_radians().cos().round();
            way += side * figure("bend_deg").to_radians();
            at
        };
        plan["program"]["steps"].as_array().unwrap().iter().map(step).collect::<Vec<_>>()
    };
    let wanted =
        places(&run(&["plan", "a.obj", "--units", "mm", "-m", "howtomechatronics", "--json"]).json());
    let off = places(&made)
        .iter()
        .zip(&wanted)
        .map(|(a, b)| a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt())
        .fold(0.0, f64::max);
    assert!(off > 0.3 && (told - off).abs() < 0.01, "{told} mm told, {off} mm by its commands");
}

/// A machine that knows of its feed and its head is told other commands, and makes the same wire of them.
#[test]
fn the_simulated_machine_is_what_its_profile_says() {
    let folder = tempfile::tempdir().unwrap();
    let set = ["profile", "set", "mine", "--from", "wirebend-kit", "--kind", "machine", "--source", "a rule"];
    let values = ["feed.scale=1.02", "rotate.offset_deg=2", "rotate.backlash_deg=1.5"];
    run_in(folder.path(), &[&set[..], &values].concat(), b"").ended(0);
    let off = |machine: &str, sign: &str| {
        let sign = format!("signs.rotate={sign}");
        let (set, own) = (["profile", "set", "mine", "--source", "a rule", &sign], machine == "mine");
        if own {
            run_in(folder.path(), &set, b"").ended(0);
        }
        // Bends in many planes, so that the head turns to both sides.
        let plan = [
            "plan",
            &example("cup-holder.obj"),
            "-m",
            machine,
            "--despite-errors",
            "-o",
            "a.wbjob",
            "--force",
        ];
        let _ = std::fs::remove_file(folder.path().join("a.wbjob"));
        run_in(folder.path(), &plan, b"");
        assert!(folder.path().join("a.wbjob").exists(), "{machine}");
        let simulated = run_in(folder.path(), &["simulate", "a.wbjob", "--json"], b"").ended(0).json();
        // Its head takes up its play before the wire, and has its zero somewhere in that: all of the wire is turned by it.
        let run = ["run", "a.wbjob", "--port", "sim:max", "--yes", "--json", "--despite-errors"];
        let ran = run_in(folder.path(), &run, b"").ended(0).json();
        let made = ran["wires"][0]["deviations_mm"].as_array().unwrap().iter();
        let made = made.map(|mm| mm.as_f64().unwrap()).fold(0.0, f64::max);
        let simulated = worst(&simulated, "worst_machine_mm");
        assert!((made - simulated).abs() < 0.2, "{made} mm as run, {simulated} mm as simulated");
        simulated
    };
    let exact = off("wirebend-kit", "1");
    for sign in ["1", "-1"] {
        let found = off("mine", sign);
        assert!(
            (found - exact).abs() < 0.2,
            "{found} mm for a sign of {sign}, {exact} mm for an exact machine"
        );
    }
}

/// Spatial bends to both sides and vertices on straights: were a sign or a frame wrong, the wire would be off by
/// centimetres.
#[test]
fn every_example_that_can_be_made_comes_out_on_the_simulated_machine() {
    for name in ["house.obj", "cup-holder.obj", "phone-stand.obj", "spring.obj", "two-parts.obj"] {
        let found = simulated("wirebend-kit", name, &[]);
        assert_eq!(found["model"], "simulated-machine", "{name}");
        for wire in found["wires"].as_array().unwrap() {
            let off = wire["worst_machine_mm"].as_f64().unwrap();
            assert!(off < 3.0, "{name}: {off} mm");
        }
    }
}

#[test]
fn with_errors_the_figures_over_all_runs_are_of_formulas() {
    let found = simulated("wirebend-kit", "house.obj", &["--noise", "wirebend-kit", "--runs", "20"]);
    assert!(worst(&found, "worst_machine_mm") < 0.5, "the machine makes no errors of its own");
    assert!(worst(&found, "worst_radius_95_mm") > worst(&found, "worst_mean_mm"));
}

/// What a kind of error does alone, and how large it may be for a given accuracy, are the same from both sides.
#[test]
fn the_tolerance_of_a_kind_of_error_is_what_it_says() {
    let found = simulated("wirebend-kit", "phone-stand.obj", &["--noise", "bend-forming", "--within", "2"]);
    let wire = &found["wires"][0];
    let (sources, steps) = (wire["sources"].as_array().unwrap(), wire["steps"].as_array().unwrap());
    let rms: Vec<f64> = sources.iter().map(|share| share["rms_mm"].as_f64().unwrap()).collect();
    assert!(sources.len() == 4 && rms.is_sorted_by(|a, b| a >= b), "{sources:?}");
    assert_eq!(steps.len(), 7);
    let tolerance = &found["tolerance"];
    assert_eq!((&tolerance["possible"], &tolerance["within_mm"]), (&json!(true), &json!(2.0)));
    let folder = tempfile::tempdir().unwrap();
    let check = |id: &str, figures: [f64; 4]| {
        let [feed, bend, rotate, curvature] = figures;
        let value = |value: f64| json!({"value": value, "source": "a test", "measured": false});
        let noise = json!({
            "schema_version": 1, "kind": "noise", "id": id, "name": id,
            "feed": {"bias_mm": value(0.0), "sigma_mm": value(feed)},
            "bend": {"bias_deg": value(0.0), "sigma_deg": value(bend)},
            "rotate": {"bias_deg": value(0.0), "sigma_deg": value(rotate)},
            "curvature": {"bias": value(0.0), "sigma": value(curvature)},
        });
        let profiles = folder.path().join("profiles/noise");
        std::fs::create_dir_all(&profiles).unwrap();
        std::fs::write(profiles.join(format!("{id}.json")), noise.to_string()).unwrap();
        let job = folder.path().join("a.wbjob");
        let plan = ["plan", &example("phone-stand.obj"), "-m", "wirebend-kit", "-o", "a.wbjob", "--force"];
        run_in(folder.path(), &plan, b"").ended(0);
        let simulate = [
            "--profiles",
            "profiles",
            "simulate",
            job.to_str().unwrap(),
            "--noise",
            id,
            "--runs",
            "8000",
            "--json",
        ];
        let made = run_in(folder.path(), &simulate, b"").ended(0).json();
        worst(&made, "worst_radius_95_mm")
    };
    for (k, source) in ["feed", "bend", "rotation", "curvature"].into_iter().enumerate() {
        let alone =
            tolerance["alone"].as_array().unwrap().iter().find(|one| one["source"] == source).unwrap();
        let mut figures = [0.0; 4];
        figures[k] = alone["sigma"].as_f64().unwrap();
        // Other random numbers: as near as so many wires tell.
        let radius = check(source, figures);
        assert!((radius - 2.0).abs() < 0.12, "{source}: {radius} mm with {figures:?}");
    }
    let factor = tolerance["together"].as_f64().unwrap();
    let radius = check("all", [0.1 * factor, 0.75 * factor, 0.75 * factor, 0.03 * factor]);
    assert!((radius - 2.0).abs() < 0.12, "{radius} mm with {factor} times the profile");
}

#[test]
fn an_accuracy_that_is_none_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let plan = ["plan", &example("house.obj"), "-m", "wirebend-kit", "-o", "a.wbjob"];
    run_in(folder.path(), &plan, b"").ended(0);
    for wrong in ["0", "-1", "nan", "inf"] {
        let told = run_in(folder.path(), &["simulate", "a.wbjob", "--within", wrong], b"").ended(2).err;
        assert!(told.contains("the accuracy") && told.contains("--within"), "{told}");
    }
}

/// A person hears which of the two it was.
#[test]
fn the_report_says_how_it_was_found() {
    let folder = tempfile::tempdir().unwrap();
    for (machine, said) in
        [("wirebend-kit", "simulated machine"), ("grbl-bender", "this machine has no simulator")]
    {
        let job = format!("{machine}.wbjob");
        run_in(
            folder.path(),
            &["plan", &example("house.obj"), "-m", machine, "--despite-errors", "-o", &job],
            b"",
        );
        let told = run_in(folder.path(), &["simulate", &job], b"").ended(0).err;
        assert!(told.contains(said), "{told}");
    }
}

fn checked(machine: &str, name: &str) -> Value {
    let check = ["check", &example(name), "-m", machine, "--collisions", "--json"];
    run_in(std::path::Path::new("."), &check, b"").ended(0).json()
}

/// A wire that comes out as designed hits what the check of its design says, with the same words and keys.
#[test]
fn without_errors_a_simulated_wire_hits_what_its_design_hits() {
    for (name, hits) in [("house.obj", true), ("u-sample.obj", false)] {
        let designed = checked("wirebend-kit", name);
        for (more, wires) in [(&["--collisions"][..], 1), (&["--collisions", "--noise", "none"][..], 200)] {
            let found = simulated("wirebend-kit", name, more);
            let collisions = &found["wires"][0]["collisions"];
            assert_eq!(collisions["wires"], wires, "{name}");
            assert_eq!(collisions["colliding"], if hits { wires } else { 0 }, "{name}");
            assert_eq!(collisions["share"], if hits { 1.0 } else { 0.0 }, "{name}");
            let said = |of: &Value| -> Vec<Value> {
                let of = of.as_array().unwrap().iter();
                of.filter(|one| one["code"] == "meets_machine")
                    .map(|one| serde_json::json!([one["severity"], one["step"], one["body"], one["unit"]]))
                    .collect()
            };
            assert_eq!(said(&collisions["diagnostics"]), said(&designed["diagnostics"]), "{name}");
        }
        assert_eq!(simulated("wirebend-kit", name, &[])["wires"][0]["collisions"], Value::Null);
    }
}

/// The first straight part swings over the wire that follows with 1 mm between them: as designed nothing is hit, and with errors of some
/// millimetres some wires hit and others do not.
#[test]
fn errors_make_some_wires_hit_what_the_design_passes() {
    let folder = tempfile::tempdir().unwrap();
    let passing = "v 0 0 0\nv 100 0 0\nv 100 60 0\nv 50 60 4\nv 50 30 4\nl 1 2\nl 2 3\nl 3 4\nl 4 5\n";
    std::fs::write(folder.path().join("passing.obj"), passing).unwrap();
    run_in(folder.path(), &["plan", "passing.obj", "-m", "table-bender", "-o", "a.wbjob"], b"").ended(0);
    let simulate = |more: &[&str]| {
        run_in(folder.path(), &[&["simulate", "a.wbjob", "--collisions"], more].concat(), b"")
    };
    assert!(simulate(&[]).ended(0).err.contains("collisions         none\n"));
    let near = simulate(&["--clearance", "2", "--json"]).ended(0).json();
    let near = &near["wires"][0]["collisions"];
    assert_eq!((&near["colliding"], &near["diagnostics"][0]["wires"]), (&0.into(), &1.into()));
    assert!(near["diagnostics"][0]["message"].as_str().unwrap().contains("comes within 1.0 mm of"), "{near}");
    // Where one goes deeper than any machine could bend it, the command ends with another status: not with this seed.
    let noise = ["--noise", "wirebend-kit", "--runs", "40", "--seed", "4", "--json"];
    let found = simulate(&noise).ended(0).json();
    assert_fits("simulate", &found);
    let found = &found["wires"][0]["collisions"];
    let colliding = found["colliding"].as_u64().unwrap();
    assert!((1..40).contains(&colliding), "{found}");
    assert_eq!(found["share"].as_f64(), Some(f64::from(u32::try_from(colliding).unwrap()) / 40.0));
    let worst = &found["diagnostics"][0];
    assert_eq!(worst["code"], "meets_stock");
    assert!(worst["run"].as_u64().unwrap() < 40 && worst["wires"].as_u64() == Some(colliding), "{worst}");
    // The same seed, the same wires.
    assert_eq!(&simulate(&noise).ended(0).json()["wires"][0]["collisions"], found);
    let told = simulate(&noise[..6]).ended(0).err;
    assert!(told.contains(&format!("  collisions         {colliding} of 40 wires hit")), "{told}");
    assert!(told.contains("[plan it again with --avoid-collisions"), "{told}");
    for wrong in ["-1", "nan"] {
        assert!(simulate(&["--clearance", wrong]).ended(2).err.contains("help: correct --clearance"));
    }
    assert!(
        run_in(folder.path(), &["simulate", "a.wbjob", "--clearance", "1"], b"")
            .ended(2)
            .err
            .contains("--collisions")
    );
}

/// A script learns of what no machine can bend by the status, as from a check.
#[test]
fn a_simulated_wire_that_cannot_pass_itself_has_a_status_of_its_own() {
    let folder = tempfile::tempdir().unwrap();
    let through = "v 0 0 0\nv 100 0 0\nv 100 60 0\nv 50 60 0\nv 50 -40 0\nl 1 2\nl 2 3\nl 3 4\nl 4 5\n";
    std::fs::write(folder.path().join("through.obj"), through).unwrap();
    let plan = ["plan", "through.obj", "-m", "table-bender", "--despite-errors", "-o", "a.wbjob"];
    run_in(folder.path(), &plan, b"");
    let told = run_in(folder.path(), &["simulate", "a.wbjob", "--collisions"], b"").ended(4).err;
    assert!(told.contains("  collisions         the wire hits the machine or itself\n"), "{told}");
    assert!(
        told.contains(
            "error[meets_stock]: step 3: the wire hits the wire that is still to be bent when step 3"
        ),
        "{told}"
    );
    run_in(folder.path(), &["simulate", "a.wbjob"], b"").ended(0);
}

/// By what it is told the head would end 2° before its begin.
#[test]
fn a_run_says_where_the_head_ends_in_the_wire() {
    let folder = tempfile::tempdir().unwrap();
    let set = "profile set mine --from wirebend-kit --kind machine rotate.backlash_deg=2 --source";
    run_in(folder.path(), &set.split(' ').chain(["a rule"]).collect::<Vec<_>>(), b"").ended(0);
    let plan = ["plan", &example("cube-8-edges.obj"), "-m", "mine", "-o", "a.wbjob"];
    run_in(folder.path(), &plan, b"").ended(0);
    let ran = run_in(folder.path(), &["run", "a.wbjob", "--port", "sim:max", "--yes"], b"").ended(0);
    assert!(ran.err.contains("the head turns between 0.0° and 90.0°, and ends at 0.0°"), "{}", ran.err);
}
