//! `plan --compare`: another machine beside the one that the design is for.

use crate::{assert_fits, example, run};

const BUNNY: [&str; 4] = ["--face-edges", "--double", "-m", "wirebend-kit"];

fn plan(design: &str, rest: &[&str]) -> crate::Ran {
    run(&[&["plan", &example(design)], rest].concat())
}

/// The row of the table with this label, its cells apart.
fn row<'a>(text: &'a str, label: &str) -> Vec<&'a str> {
    let line =
        text.lines().find(|line| line.starts_with(&format!("{label}  "))).unwrap_or_else(|| panic!("{text}"));
    line.split("  ").map(str::trim).filter(|cell| !cell.is_empty()).collect()
}

#[test]
fn a_comparison_fits_its_schema() {
    let pensa = ["--compare", "pensa-diwire-pro", "--json"];
    let bunny = plan("bunny.obj", &[&BUNNY[..], &pensa].concat()).ended(4).json();
    assert_fits("compare", &bunny);
    assert_eq!(bunny["to"][0]["newly_feasible"]["diagnostics"].as_array().unwrap().len(), 4);
    let without_route = plan("cube.obj", &[&["-m", "wirebend-kit"], &pensa[..]].concat()).ended(4).json();
    assert_fits("compare", &without_route);
    assert!(without_route["from"]["time_s"].is_null());
    let two = ["-m", "wirebend-kit", "--compare", "howtomechatronics", "--compare", "wirebend-kit", "--json"];
    let two = plan("two-parts.obj", &two).ended(0).json();
    assert_fits("compare", &two);
    let step = serde_json::json!({"wire": 1, "step": 0});
    assert_eq!(two["to"][0]["newly_infeasible"]["steps"][0], step);
}

/// The status is that of the machine that the design is for: the others are looked at.
#[test]
fn a_person_reads_what_changes() {
    // Two bends over 155 degrees, two edges under 25 mm: see the golden case.
    let said = plan("bunny.obj", &[&BUNNY[..], &["--compare", "pensa-diwire-pro"]].concat()).ended(4).err;
    assert_eq!(row(&said, "in limits"), ["in limits", "no", "yes"]);
    assert_eq!(row(&said, "errors"), ["errors", "4", "0 (-4)"]);
    assert_eq!(row(&said, "feeds"), ["feeds", "176", "176 (same)"]);
    assert_eq!(row(&said, "wire"), ["wire", "aluminium-6061-t6-3mm", "steel-0-9mm"]);
    assert!(said.contains("pensa-diwire-pro: without 4 errors of wirebend-kit: bend_too_sharp"), "{said}");

    // A corner of 135 degrees, twice; the clone bends to 110.
    let arguments = ["-m", "wirebend-kit", "--compare", "howtomechatronics", "--compare", "wirebend-kit"];
    let ran = plan("two-parts.obj", &arguments).ended(0);
    assert!(ran.out.is_empty(), "reports go to the error stream");
    assert_eq!(row(&ran.err, "in limits"), ["in limits", "yes", "no", "yes"]);
    assert!(ran.err.contains("howtomechatronics: 2 errors that wirebend-kit does not have"), "{}", ran.err);
    assert!(ran.err.contains("  vertex 5: the bend at vertex 5 is 135.0°"), "{}", ran.err);
    assert!(ran.err.contains("wirebend-kit: no other errors than on wirebend-kit"), "{}", ran.err);
    assert_eq!(row(&ran.err, "time").last().unwrap(), &"1 min 47 s (same)");

    // 450 mm and a tail of 200 mm, without compensation.
    let said =
        plan("cube.obj", &["--double", "-m", "wirebend-kit", "--compare", "pensa-diwire-pro"]).ended(0).err;
    assert!(row(&said, "stock")[2].starts_with("650.0 mm (-"), "{said}");
    assert_eq!(row(&said, "cost")[2], "unknown", "the price of its wire is not known");
}

#[test]
fn a_long_list_is_cut_and_counted() {
    // A fifth of the isogrid has struts of about 15 mm: the Pensa bends them from 11 mm, the clone from 20.
    let arguments =
        ["--scale", "0.2", "--double", "-m", "pensa-diwire-pro", "--compare", "howtomechatronics"];
    let json = plan("isogrid.obj", &[&arguments[..], &["--json"]].concat()).json();
    let all = json["to"][0]["newly_infeasible"]["diagnostics"].as_array().unwrap().len();
    assert!(all > 12, "{all}");
    let said = plan("isogrid.obj", &arguments).err;
    let is_finding =
        |line: &&str| line.starts_with("  ") && !line.starts_with("  help") && line.contains(": ");
    assert_eq!(said.lines().filter(is_finding).count(), 12, "{said}");
    assert!(said.contains(&format!("  … and {} more", all - 12)), "{said}");
}

#[test]
fn what_makes_no_job_takes_no_option_of_one() {
    let compare = ["-m", "wirebend-kit", "--compare", "pensa-diwire-pro"];
    for option in [&["-o", "cube.wbjob"][..], &["--force"], &["--despite-errors"]] {
        let said = plan("cube.obj", &[&compare[..], option].concat()).ended(2).err;
        assert!(said.contains("--compare"), "{said}");
    }
    let said = plan("cube.obj", &["-m", "wirebend-kit", "--compare", "pensa-diwire-pr"]).ended(2).err;
    assert!(said.contains("did you mean `pensa-diwire-pro`?"), "{said}");
    let said = plan("cube.obj", &["--compare", "pensa-diwire-pro"]).ended(2).err;
    assert!(said.contains("no machine is named"), "{said}");
}

/// Who chooses a machine for a part sees on which of them it hits something, and how much of that rests on estimates.
#[test]
fn collisions_are_compared_where_they_are_looked_for() {
    let machines = ["-m", "wirebend-kit", "--compare", "grbl-bender"];
    let without = plan("house.obj", &machines).ended(0).err;
    assert_eq!(row(&without, "collisions"), ["collisions", "not checked", "not checked"]);
    let looked = [&machines[..], &["--collisions"]].concat();
    let found = plan("house.obj", &[&looked[..], &["--json"]].concat()).ended(0).json();
    assert_fits("compare", &found);
    for (machine, side) in [("wirebend-kit", &found["from"]), ("grbl-bender", &found["to"][0])] {
        let check = ["check", &example("house.obj"), "-m", machine, "--collisions", "--json"];
        let checked = run(&check).ended(0).json();
        let all = checked["diagnostics"].as_array().unwrap().iter();
        let hits: Vec<_> =
            all.filter(|one| one["code"] == "meets_machine" || one["code"] == "meets_stock").collect();
        let estimated =
            hits.iter().filter(|one| one["message"].as_str().unwrap().contains("estimates")).count();
        assert_eq!(
            side["collisions"],
            serde_json::json!({"hits": hits.len(), "estimated": estimated}),
            "{machine}"
        );
    }
    assert_ne!(found["from"]["collisions"]["hits"], 0, "the house hits the head of this machine");
    assert!(row(&plan("house.obj", &looked).ended(0).err, "collisions")[1].ends_with(", estimated"));
}
