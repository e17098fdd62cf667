//! What the commands answer.

use crate::{assert_fits, example, run, run_in};

/// A straight wire that is fed out is a cantilever: w L⁴ / (8 E I) = 0.7006 mm for 300 mm of the 3 mm aluminium, with
/// w = 1.8716e-4 N/mm and E I = 270.5e3 N mm².
#[test]
fn a_plan_says_how_far_the_part_sags_where_it_is_asked() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("straight.obj"), "v 0 0 0\nv 300 0 0\nl 1 2\n").unwrap();
    let plan = |more: &[&str]| {
        run_in(folder.path(), &[&["plan", "straight.obj", "--machine", "wirebend-kit"], more].concat(), b"")
    };
    let said = plan(&["--sag"]).ended(0).err;
    assert!(said.contains("sags        0.7 mm at the free end in step 1, under its own weight"), "{said}");
    let found = plan(&["--sag", "--json"]).ended(0).json();
    assert_fits("plan", &found);
    let deflection = found["sag"]["deflection_mm"].as_f64().unwrap();
    assert!((deflection - 0.7006).abs() < 1e-4 && found["sag"]["step"] == 0, "{}", found["sag"]);
    assert!(plan(&["--json"]).ended(0).json()["sag"].is_null());
    assert!(plan(&["--sag", "--wires", "1..3"]).ended(2).err.contains("numbers of wires are compared"));
}

/// 3 m of the same wire would sag by 7 m: that is no longer beam theory, and no part that can be bent without a hand below it.
#[test]
fn a_part_that_sags_too_far_is_warned_of_and_its_job_says_that_it_hangs() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("long.obj"), "v 0 0 0\nv 1500 0 0\nv 1500 1500 0\nl 1 2 3\n").unwrap();
    let on_kit = ["long.obj", "--machine", "wirebend-kit", "--sag", "--collisions"];
    let plan = |more: &[&str]| run_in(folder.path(), &[&["plan"], &on_kit[..], more].concat(), b"");
    let checked = run_in(folder.path(), &[&["check"], &on_kit[..], &["--json"]].concat(), b"").json();
    let sags = |found: &serde_json::Value| {
        let all = found["diagnostics"].as_array().unwrap();
        all.iter().find(|one| one["code"] == "part_sags").cloned().expect("a warning of the sag")
    };
    assert_eq!(sags(&checked)["severity"], "warning");
    let said = plan(&[]).err;
    assert!(said.contains("more than a tenth of that") && said.contains("hold the part up"), "{said}");
    plan(&["--clearance", "2", "--despite-errors", "-o", "long.wbjob"]);
    let job: serde_json::Value =
        serde_json::from_slice(&std::fs::read(folder.path().join("long.wbjob")).unwrap()).unwrap();
    assert_eq!((&job["wires"][0]["sag"], &job["wires"][0]["clearance_mm"]), (&true.into(), &2.0.into()));
}

/// A machine is armed after the same look as the window takes at the design.
#[test]
fn a_job_has_how_its_design_is_looked_at_and_options_replace_that() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &[&str]| run_in(folder.path(), arguments, b"").ended(0);
    run(&["import", &example("house.obj"), "--units", "mm", "-o", "house.wirebend"]);
    let file = folder.path().join("house.wirebend");
    let mut design: serde_json::Value = serde_json::from_slice(&std::fs::read(&file).unwrap()).unwrap();
    design["collisions"] = serde_json::json!({"clearance_mm": 12, "sag": true});
    std::fs::write(&file, design.to_string()).unwrap();
    for (options, clearance) in
        [(&[][..], serde_json::json!(12.0)), (&["--collisions", "--clearance", "0"], serde_json::Value::Null)]
    {
        run(&[&["plan", "house.wirebend", "-m", "wirebend-kit", "-o", "house.wbjob", "--force"], options]
            .concat());
        let job: serde_json::Value =
            serde_json::from_slice(&std::fs::read(folder.path().join("house.wbjob")).unwrap()).unwrap();
        assert_eq!((&job["wires"][0]["sag"], &job["wires"][0]["clearance_mm"]), (&true.into(), &clearance));
    }
}

#[test]
fn every_result_fits_its_schema() {
    let folder = tempfile::tempdir().unwrap();
    let cube = example("cube-8-edges.obj");
    let job = folder.path().join("cube.wbjob").display().to_string();
    let on_kit = ["--machine", "wirebend-kit"];
    let run = |arguments: &[&str]| run_in(folder.path(), arguments, b"");

    assert_fits("machines", &run(&["machines", "--json"]).ended(0).json());
    assert_fits("materials", &run(&["materials", "--json"]).ended(0).json());
    assert_fits("import", &run(&["import", &cube, "-o", "cube.wirebend", "--json"]).ended(0).json());
    assert_fits("check", &run(&[&["check", &cube, "--json"], &on_kit[..]].concat()).ended(0).json());
    assert_fits(
        "plan",
        &run(&[&["plan", &cube, "-o", &job, "--json"], &on_kit[..]].concat()).ended(0).json(),
    );
    let bunny = example("bunny.obj");
    let infeasible = run(&[&["plan", &bunny, "--face-edges", "--double", "--json"], &on_kit[..]].concat());
    assert_fits("plan", &infeasible.ended(4).json());
    let without_route =
        run(&[&["plan", &bunny, "--face-edges", "--json"], &on_kit[..]].concat()).ended(4).json();
    assert_fits("plan", &without_route);
    assert!(without_route["route"].is_null() && without_route["compensated"].is_null());
    let two = run(&[&["plan", &example("two-parts.obj"), "--json"], &on_kit[..]].concat()).json();
    assert_fits("plan", &two);
    assert_eq!(two["wires"].as_array().unwrap().len(), 2);
    assert_fits("export", &run(&["export", &job, "-o", "cube.txt", "--json"]).ended(0).json());
    let noisy = ["simulate", &job, "--noise", "wirebend-kit", "--runs", "20", "--json"];
    assert_fits("simulate", &run(&noisy).ended(0).json());
    for stage in ["stencil", "wireframe", "route", "program", "schedule", "compensated", "job"] {
        let dumped = run(&[&["dump", stage, &cube, "--json"], &on_kit[..]].concat()).ended(0).json();
        assert_fits("dump", &dumped);
    }
    let profile = crate::root().join("machine-profiles/machines/wirebend-kit.json").display().to_string();
    assert_fits("profile-check", &run(&["profile", "check", &profile, "--json"]).ended(0).json());
    assert_fits(
        "error",
        &run(&["plan", "nowhere.obj", "--machine", "wirebend-kit", "--json"]).ended(3).json(),
    );
    let refused =
        ["export", &bunny, "--face-edges", "--double", "--machine", "wirebend-kit", "--json", "-o", "b.txt"];
    assert_fits("error", &run(&refused).ended(4).json());
}

#[test]
fn the_published_cube_shows_its_two_lengths() {
    let plan =
        run(&["plan", &example("cube-8-edges.obj"), "--machine", "wirebend-kit", "--json"]).ended(0).json();
    let figure = |pointer: &str| plan.pointer(pointer).unwrap().as_f64().unwrap();
    // 8 edges of 30 mm are 240 mm as designed (published: 241); every right angle saves 6 - 2.4·π/2,
    // and 400 mm cannot be fed.
    assert!((figure("/route/length_mm") - 240.0).abs() < 1e-9);
    let saved = 7.0 * (6.0 - 1.2 * std::f64::consts::PI);
    assert!((figure("/compensated/stock_mm") - (240.0 - saved + 400.0)).abs() < 1e-9);
    // 2:21 is published, and what the time model is fitted on.
    assert!((figure("/time_s") - 141.0).abs() < 3.0);
    // 3 mm aluminium: 2.7 g/cm³ over what is fed, and over the stock that is bought; 0.00199 USD a mm.
    let g_per_mm = 0.0027 * std::f64::consts::FRAC_PI_4 * 9.0;
    assert!((figure("/mass_g") - g_per_mm * (240.0 - saved)).abs() < 1e-6);
    assert!((figure("/stock_mass_g") - g_per_mm * (640.0 - saved)).abs() < 1e-6);
    assert!((figure("/cost") - 0.00199 * (240.0 - saved)).abs() < 1e-9);
    assert!((figure("/stock_cost") - 0.00199 * (640.0 - saved)).abs() < 1e-9);
}

#[test]
fn the_published_jobs_cost_what_their_lengths_say() {
    // Length in mm at 0.00199 a mm: published of the designed length, of which bends save some of the wire.
    for (name, length, cost) in [
        ("house", 292.0, 0.581),
        ("phone-stand", 362.0, 0.720),
        ("cup-holder", 469.0, 0.933),
        ("spring", 641.0, 1.276),
    ] {
        let plan =
            run(&["plan", &example(&format!("{name}.obj")), "--machine", "wirebend-kit", "--json"]).json();
        assert!((plan["route"]["length_mm"].as_f64().unwrap() - length).abs() < 0.05, "{name}");
        let length_mm = plan["route"]["length_mm"].as_f64().unwrap();
        let per_mm = plan["cost"].as_f64().unwrap() / plan["compensated"]["feed_mm"].as_f64().unwrap();
        assert!((per_mm * length_mm - cost).abs() < 1e-3, "{name}");
        assert_eq!(plan["currency"], "USD");
    }
}

#[test]
fn the_same_input_gives_the_same_plan() {
    let plan = || {
        let arguments =
            ["plan", &example("teapot.obj"), "--face-edges", "--double", "-m", "wirebend-kit", "--json"];
        let mut plan = run(&arguments).json();
        plan["timings_ms"].take();
        plan
    };
    assert_eq!(plan(), plan());
}

#[test]
fn a_seed_gives_the_same_simulation() {
    let folder = tempfile::tempdir().unwrap();
    let run = |arguments: &[&str]| run_in(folder.path(), arguments, b"");
    run(&["plan", &example("spring.obj"), "-m", "wirebend-kit", "-o", "spring.wbjob"]).ended(0);
    let bent = |seed: &str| {
        let arguments =
            ["simulate", "spring.wbjob", "--noise", "bend-forming", "--runs", "30", "--seed", seed, "--json"];
        run(&arguments).ended(0).json()["wires"].clone()
    };
    assert_eq!(bent("7"), bent("7"));
    assert_ne!(bent("7"), bent("8"));
    let perfect = run(&["simulate", "spring.wbjob", "--json"]).ended(0).json();
    assert!(perfect["wires"][0]["worst_systematic_mm"].as_f64().unwrap() < 1e-6);
    assert_eq!(perfect["noise"], serde_json::Value::Null);
}

#[test]
fn a_person_reads_both_lengths_and_what_to_do() {
    let done = run(&["plan", &example("cube-8-edges.obj"), "--machine", "wirebend-kit"]).ended(0);
    for said in [
        "240.0 mm as designed",
        "624.4 mm",
        "224.4 mm fed + 400.0 mm unusable tail",
        "2 min 21 s",
        "within the machine's limits; collisions not checked",
    ] {
        assert!(done.err.contains(said), "{said} is not in\n{}", done.err);
    }
    assert!(done.out.is_empty(), "reports go to the error stream");
    let refused = run(&["plan", &example("cube.obj"), "--machine", "wirebend-kit"]).ended(4);
    for said in
        ["no_euler_path", "8 odd corners", "along 3 edges twice", "90.0 mm", "[--double]", "cannot be bent"]
    {
        assert!(refused.err.contains(said), "{said} is not in\n{}", refused.err);
    }
}
