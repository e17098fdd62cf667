//! `compare`: what another machine would change.

use std::f64::consts::{FRAC_PI_4, PI};

use wirebend_api::{
    ApiError, Command, CompareRequest, CompareResponse, DesignInput, ErrorKind, ErrorRemedy, Findings,
    Installation, NoProgress, PlanChoices, Response,
};

use crate::commands::{doubled, example};

fn compare(design: DesignInput, choices: PlanChoices, against: &[&str]) -> Result<CompareResponse, ApiError> {
    let against = against.iter().map(|&id| id.to_owned()).collect();
    let request = Command::Compare(CompareRequest { design, choices, against });
    match request.run(&Installation::new(&[]).unwrap(), &NoProgress)? {
        Response::Compare(found) => Ok(*found),
        other => panic!("a comparison answered {other:?}"),
    }
}

fn bunny() -> DesignInput {
    DesignInput { face_edges: true, ..example("bunny.obj") }
}

/// How often each code is named, by code.
fn codes(findings: &Findings) -> Vec<(&str, usize)> {
    let mut codes: Vec<(&str, usize)> = Vec::new();
    for found in &findings.diagnostics {
        match codes.iter_mut().find(|(code, _)| *code == found.diagnostic.code.as_str()) {
            Some((_, number)) => *number += 1,
            None => codes.push((found.diagnostic.code.as_str(), 1)),
        }
    }
    codes.sort_unstable();
    codes
}

fn near(value: Option<f64>, expected: f64) {
    let value = value.unwrap();
    assert!((value - expected).abs() < 1e-6, "{value} is not {expected}");
}

/// The same wire on both: what its stock costs there, and what is to be known of it there and was not here.
#[test]
fn a_warning_of_the_other_machine_is_told() {
    let material = Some("aluminium-6061-t6-3mm".to_owned());
    let choices = PlanChoices { material, ..doubled("wirebend-kit") };
    let found = compare(bunny(), choices, &["pensa-diwire-pro"]).unwrap();
    let other = &found.to[0];
    // 1.99 USD for a metre.
    near(other.side.stock_cost, other.side.stock_mm.unwrap() * 1.99e-3);
    let before = found.from.stock_cost.unwrap();
    near(other.change.stock_cost, other.side.stock_cost.unwrap() - before);
    assert_eq!(codes(&other.newly_warned), [("bend_radius_small", 1)]);
}

/// `tests/golden/bunny/case.json` says why: two bends over 155 degrees, two edges under 25 mm. The Pensa
/// bends to 180 degrees and feeds from 5 mm.
#[test]
fn the_bunny_is_for_one_machine_and_not_for_the_other() {
    let (kit, pensa) = ("wirebend-kit", "pensa-diwire-pro");
    let expected = [("bend_too_sharp", 2), ("feed_too_short", 2)];
    let there = compare(bunny(), doubled(kit), &[pensa]).unwrap();
    let other = &there.to[0];
    assert_eq!((there.from.feasible, there.from.errors), (false, 4));
    assert_eq!((other.side.feasible, other.side.errors), (true, 0));
    assert_eq!(codes(&other.newly_feasible), expected);
    assert_eq!(other.newly_infeasible, Findings::default());

    let back = compare(bunny(), doubled(pensa), &[kit]).unwrap();
    let other = &back.to[0];
    assert_eq!((back.from.feasible, other.side.feasible), (true, false));
    assert_eq!(codes(&other.newly_infeasible), expected);
    assert_eq!(other.newly_feasible, Findings::default());
    let worse = &other.newly_infeasible;
    for found in &worse.diagnostics {
        assert_eq!(found.wire, Some(0));
        let step = found.diagnostic.step.unwrap();
        assert!(worse.steps.iter().any(|at| (at.wire, at.step) == (0, step)), "{step}");
        match found.diagnostic.code.as_str() {
            "bend_too_sharp" => assert!(worse.vertices.contains(&found.diagnostic.vertex.unwrap())),
            _ => assert!(worse.edges.contains(&found.diagnostic.edge.unwrap())),
        }
    }
    // The same design both times: what is more one way is less the other way.
    near(there.to[0].change.time_s, -other.change.time_s.unwrap());
    assert_eq!(other.change.bends, Some(0));
}

/// 12 edges of 30 mm and 3 of them twice: 15 feeds, 450 mm, a right angle between any two.
#[test]
fn the_cube_takes_other_stock_and_wire_on_another_machine() {
    let found = compare(example("cube.obj"), doubled("wirebend-kit"), &["pensa-diwire-pro"]).unwrap();
    let (kit, other) = (&found.from, &found.to[0]);
    let pensa = &other.side;
    for side in [kit, pensa] {
        assert!(side.feasible && side.errors == 0);
        assert_eq!((side.feeds, side.bends), (Some(15), Some(14)));
    }
    assert_eq!((kit.material.as_str(), pensa.material.as_str()), ("aluminium-6061-t6-3mm", "steel-0-9mm"));
    // The kit saves 6 - 1.2π mm a right angle (bend deduction, K = 0.3, 3 mm wire, 1.5 mm pin) and has a tail
    // of 400 mm; the Pensa gets the nominal program and has a tail of 200 mm.
    let on_kit = 450.0 - 14.0 * (6.0 - 1.2 * PI) + 400.0;
    near(kit.stock_mm, on_kit);
    near(pensa.stock_mm, 650.0);
    near(other.change.stock_mm, 650.0 - on_kit);
    // 3 mm of 2.7 g/cm³ against 0.9 mm of 7.8 g/cm³.
    let mass = |density: f64, diameter: f64, fed: f64| density * 1e-3 * FRAC_PI_4 * diameter * diameter * fed;
    near(other.change.mass_g, mass(7.8, 0.9, 450.0) - mass(2.7, 3.0, on_kit - 400.0));
    // The price of the other wire is not known.
    near(kit.cost, (on_kit - 400.0) * 0.00199);
    assert_eq!((pensa.cost, other.change.cost), (None, None));
    assert_eq!(codes(&other.newly_infeasible), []);
    assert_eq!(codes(&other.newly_feasible), []);
}

/// 3 mm do not fit a machine that takes 0.8 to 2 mm; its own wire does.
#[test]
fn a_machine_that_the_wire_does_not_fit_is_tried_with_its_own_wire_too() {
    let kit = "aluminium-6061-t6-3mm";
    let chosen = PlanChoices { material: Some(kit.to_owned()), ..doubled("wirebend-kit") };
    let found = compare(example("house.obj"), chosen, &["grbl-bender", "table-bender"]).unwrap();
    let [grbl, table] = found.to.as_slice() else { panic!("two machines were asked for") };
    assert_eq!((found.from.material.as_str(), grbl.side.material.as_str()), (kit, kit));
    assert_eq!(codes(&grbl.newly_infeasible), [("wire_does_not_fit", 1)]);
    let own = grbl.own_wire.as_ref().unwrap();
    assert_eq!((own.side.material.as_str(), own.side.feasible), ("steel-1mm", true));
    assert_eq!((codes(&own.newly_infeasible), &own.own_wire), (vec![], &None));
    // 3 mm lie within the 1 to 6 mm of the other one.
    assert_eq!((table.side.feasible, &table.own_wire), (true, &None));
}

#[test]
fn a_machine_beside_itself_changes_nothing() {
    let found = compare(bunny(), doubled("wirebend-kit"), &["wirebend-kit"]).unwrap();
    let other = &found.to[0];
    assert_eq!(other.side, found.from);
    assert!(!other.side.feasible, "its errors are the same ones, not gone");
    for change in [other.change.time_s, other.change.stock_mm, other.change.cost, other.change.mass_g] {
        near(change, 0.0);
    }
    assert_eq!(other.change.bends, Some(0));
    assert_eq!(
        (&other.newly_infeasible, &other.newly_feasible),
        (&Findings::default(), &Findings::default())
    );
}

/// The second part is a Z whose corners turn by 135 degrees (40 mm across, 40 mm up, drawn in the file);
/// the clone bends to 110.
#[test]
fn of_several_parts_the_wire_that_fails_is_named() {
    let choices = doubled("wirebend-kit");
    let found = compare(example("two-parts.obj"), choices, &["howtomechatronics", "grbl-bender"]).unwrap();
    // `tests/golden/two-parts/case.json`: 7 feeds in two wires, 296.569 mm.
    assert_eq!((found.from.feeds, found.from.feasible), (Some(7), true));
    // Of three right angles and two of 135 degrees each gives up 6·tan(θ/2) - 2.4·θ.
    let saved = |degrees: f64| 6.0 * (degrees.to_radians() / 2.0).tan() - 2.4 * degrees.to_radians();
    let mass = 2.7e-3 * FRAC_PI_4 * 9.0 * (296.569 - 3.0 * saved(90.0) - 2.0 * saved(135.0));
    assert!((found.from.mass_g.unwrap() - mass).abs() < 1e-4);
    let machines: Vec<&str> = found.to.iter().map(|other| other.side.machine.as_str()).collect();
    assert_eq!(machines, ["howtomechatronics", "grbl-bender"]);
    let worse = &found.to[0].newly_infeasible;
    assert_eq!(codes(worse), [("bend_too_sharp", 2)]);
    assert!(worse.diagnostics.iter().all(|found| found.wire == Some(1)));
    // Its two inner vertices of four; the ids run on from those of the square.
    assert_eq!(worse.vertices.iter().copied().collect::<Vec<_>>(), [5, 6]);
    let steps: Vec<_> = worse.steps.iter().map(|at| (at.wire, at.step)).collect();
    assert_eq!(steps, [(1, 0), (1, 1)], "a wire of three feeds has two bends");
}

#[test]
fn what_was_not_reached_has_no_sum() {
    let choices = PlanChoices { double: false, ..doubled("wirebend-kit") };
    let found = compare(example("cube.obj"), choices, &["pensa-diwire-pro"]).unwrap();
    // Eight odd corners: there is no route without doubling, on any machine.
    for side in [&found.from, &found.to[0].side] {
        assert!(!side.feasible);
        assert_eq!((side.feeds, side.bends, side.time_s, side.stock_mm), (None, None, None, None));
    }
    assert_eq!(codes(&found.to[0].newly_infeasible), [], "both say so");
    assert_eq!(found.to[0].change.time_s, None);
}

#[test]
fn a_wire_that_was_asked_for_is_in_every_machine() {
    let material = Some("aluminium-6061-o-3mm".to_owned());
    let choices = PlanChoices { material, ..doubled("wirebend-kit") };
    let found = compare(example("cube.obj"), choices, &["pensa-diwire-pro"]).unwrap();
    assert_eq!(found.from.material, "aluminium-6061-o-3mm");
    assert_eq!(found.to[0].side.material, "aluminium-6061-o-3mm");
    // A millimetre of it weighs the same on both: 400 and 200 mm of their stock are not fed.
    let per_mm = |mass: Option<f64>, stock: Option<f64>, tail: f64| mass.unwrap() / (stock.unwrap() - tail);
    let there = &found.to[0].side;
    near(
        Some(per_mm(there.mass_g, there.stock_mm, 200.0)),
        per_mm(found.from.mass_g, found.from.stock_mm, 400.0),
    );
    let said = |code: &str| found.notes.iter().filter(|note| note.code == code).count();
    assert_eq!((said("units-assumed"), said("springback-estimated")), (1, 1), "each note once");
}

#[test]
fn machines_that_are_not_there_are_refused_before_the_design_is_read() {
    let nowhere = DesignInput::file("nowhere.obj".into());
    let error = compare(nowhere.clone(), doubled("wirebend-kit"), &["pensa-diwire-pr"]).unwrap_err();
    assert_eq!((error.kind(), error.code().as_str()), (ErrorKind::Usage, "profile-unknown"));
    let offers = |remedy: &ErrorRemedy| matches!(remedy, ErrorRemedy::ChooseKnown { near, .. } if near == &["pensa-diwire-pro"]);
    assert!(error.remedies().iter().any(offers), "{:?}", error.remedies());
    let error = compare(nowhere, doubled("wirebend-kit"), &[]).unwrap_err();
    assert_eq!((error.kind(), error.code().as_str()), (ErrorKind::Usage, "value"));
}
