//! Collisions of the open design, looked for beside the other checks.

use std::cell::{Cell, RefCell};

use serde_json::json;
use wirebend_editor::Moved;
use wirebend_planning::plan::CheckRequest;
use wirebend_planning::{DesignInput, FoundSoFar, NoProgress, PlanChoices, Progress};

use crate::{app, edit, example, open};

/// The window and the command line say the same of a file.
#[test]
fn it_says_what_the_command_says() {
    for name in ["house.obj", "cube-8-edges.obj", "spring.obj", "two-parts.obj"] {
        let mut editor = open(name);
        edit(&mut editor, &json!({"edit": "machine", "machine": "wirebend-kit", "material": null}));
        let before = editor.document().clone();
        let found = editor.collision_check(&app(), &[]).unwrap().run(&mut |_, _| true).unwrap();
        let choices =
            PlanChoices { machine: Some("wirebend-kit".into()), collisions: true, ..PlanChoices::default() };
        let request = CheckRequest { design: DesignInput::file(example(name)), choices };
        let said = wirebend_planning::plan::check(&app(), &request, &NoProgress).unwrap();
        assert_eq!(found.checked, said.collisions_checked, "{name}");
        let mut findings: Vec<_> = found.contacts.into_iter().map(|contact| contact.finding).collect();
        findings.sort_by_key(|finding| finding.severity != wirebend_planning::report::SeverityName::Error);
        let meets = said.diagnostics.into_iter().filter(|one| one.code.as_str().starts_with("meets_"));
        assert_eq!(findings, meets.collect::<Vec<_>>(), "{name}");
        assert_eq!(editor.document(), &before, "nothing was changed by asking");
    }
}

/// A clearance of the design, and whether it is looked at as it hangs, count in the window as the options of the command do; the command
/// takes them from the file of the design, too.
#[test]
fn the_design_keeps_how_they_are_looked_for() {
    let mut editor = open("house.obj");
    edit(&mut editor, &json!({"edit": "collisions", "clearance_mm": 12, "sag": true}));
    let found = editor.collision_check(&app(), &[]).unwrap().run(&mut |_, _| true).unwrap();
    let check = editor.check(&app(), &[]).unwrap();
    assert!(check.wires[0].sag.is_some_and(|sag| sag.deflection_mm > 0.0), "{check:?}");
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("house.wirebend");
    std::fs::write(&file, editor.document().to_bytes().unwrap()).unwrap();
    let machine = Some("wirebend-kit".to_owned());
    let given = PlanChoices {
        machine: machine.clone(),
        collision_margin_mm: Some(12.0),
        sag: true,
        ..PlanChoices::default()
    };
    let kept = PlanChoices { machine, ..PlanChoices::default() };
    let contacts: Vec<_> = found.contacts.into_iter().map(|contact| contact.finding).collect();
    for (input, choices) in [(example("house.obj"), given), (file, kept)] {
        let choices = PlanChoices { collisions: true, ..choices };
        let request = CheckRequest { design: DesignInput::file(input), choices };
        let said = wirebend_planning::plan::check(&app(), &request, &NoProgress).unwrap().diagnostics;
        let meets: Vec<_> = said.into_iter().filter(|one| one.code.as_str().starts_with("meets_")).collect();
        assert_eq!(meets.len(), contacts.len());
        assert!(contacts.iter().all(|contact| meets.contains(contact)), "{contacts:#?} {meets:#?}");
    }
    let plain = open("house.obj").collision_check(&app(), &[]).unwrap().run(&mut |_, _| true).unwrap();
    assert!(plain.contacts.len() < contacts.len(), "{contacts:#?}");
    let hits = |body: &Option<String>| contacts.iter().any(|one| one.body == *body && one.value >= Some(0.0));
    assert!(plain.contacts.iter().all(|contact| hits(&contact.finding.body)), "{contacts:#?}");
    let refused =
        serde_json::from_value(json!({"edit": "collisions", "clearance_mm": -1, "sag": false})).unwrap();
    let error = editor.edit(&app(), &refused).unwrap_err();
    assert_eq!(error.to_string(), "the clearance is -1 mm, expected zero or more");
}

/// Playback stops where the contact is, and draws what touches what.
#[test]
fn a_contact_is_placed_in_the_time_of_its_step_and_names_the_body_by_its_place_in_the_profile() {
    let mut editor = open("house.obj");
    let found = editor.collision_check(&app(), &[]).unwrap().run(&mut |_, _| true).unwrap();
    let [contact] = &found.contacts[..] else { panic!("{found:?}") };
    assert!(contact.at > 0.0 && contact.at < 1.0, "{contact:?}");
    assert!(contact.leg <= contact.step && contact.finding.step == Some(contact.step));
    let shapes = app().setup("wirebend-kit", None).unwrap().machine.profile.shapes.unwrap();
    let shape = &shapes[contact.body.unwrap()];
    assert_eq!((Some(&shape.name), contact.estimated), (contact.finding.body.as_ref(), !shape.measured));
    assert_eq!(
        (found.bodies, found.estimates),
        (shapes.len(), shapes.iter().filter(|s| !s.measured).count())
    );
}

/// A person who drags does not wait for what was asked before.
#[test]
fn it_is_stopped_between_two_steps_and_says_then_that_nothing_is_known() {
    let mut editor = open("house.obj");
    let mut seen = Vec::new();
    let check = editor.collision_check(&app(), &[]).unwrap();
    let stopped = check.run(&mut |done, of| {
        seen.push((done, of));
        done < 2
    });
    let stopped = stopped.unwrap();
    assert!(stopped.stopped && !stopped.checked && stopped.contacts.is_empty(), "{stopped:?}");
    assert_eq!(seen, [(0, 5), (1, 5), (2, 5)]);
    assert!(editor.collision_check(&app(), &[Moved { vertex: 99, at_mm: [0.0; 3] }]).is_err());
}

/// Without a route nothing is bent, and nothing can be said of collisions.
#[test]
fn a_design_without_a_route_is_not_checked() {
    let mut editor = open("cube.obj");
    let found = editor.collision_check(&app(), &[]).unwrap().run(&mut |_, _| true).unwrap();
    assert!(!found.checked && !found.stopped && found.contacts.is_empty(), "{found:?}");
}

/// Every fix was tried with a check for collisions, and what is no collision has its fixes elsewhere.
#[test]
fn a_fix_of_a_collision_leaves_fewer_of_them() {
    let mut editor = open("house.obj");
    let before = editor.collision_check(&app(), &[]).unwrap().run(&mut |_, _| true).unwrap();
    let fixes = editor.fix_search(&app()).unwrap().collision_fixes(&app(), &|| true).unwrap();
    for fix in &fixes {
        assert!(fix.mends.code.as_str().starts_with("meets_"), "{fix:?}");
        editor.edit(&app(), &fix.edit).unwrap();
        let after = editor.collision_check(&app(), &[]).unwrap().run(&mut |_, _| true).unwrap();
        assert!(after.checked && after.contacts.len() < before.contacts.len(), "{fix:?}");
        editor.undo().unwrap();
    }
    assert!(editor.fix_search(&app()).unwrap().collision_fixes(&app(), &|| false).unwrap().is_empty());
}

/// The order of the bends that a search has found is a fix, which stays with the design as long as it fits.
#[test]
fn an_order_that_hits_nothing_is_a_fix_and_kept_with_the_design() {
    let mut editor = open("house.obj");
    let hits = |editor: &mut wirebend_editor::Editor| {
        let found = editor.collision_check(&app(), &[]).unwrap().run(&mut |_, _| true).unwrap();
        assert!(found.checked);
        found.contacts.len()
    };
    assert_eq!(hits(&mut editor), 1);
    let fixes = editor.fix_search(&app()).unwrap().collision_fixes(&app(), &|| true).unwrap();
    let order = |fix: &&wirebend_editor::Fix| fix.title == "Bend in an order that hits nothing";
    let fix = fixes.iter().find(order).unwrap();
    assert_eq!((fix.after.wires, fix.after.collisions, fix.errors_after), (1, Some(0), 0));
    let before = editor.document().clone();
    editor.edit(&app(), &fix.edit).unwrap();
    assert_eq!(hits(&mut editor), 0);
    let walked = editor.document().clone();
    let [walk] = &walked.walks[..] else { panic!("{:?}", walked.walks) };
    let mut edges = walk.edges.clone();
    edges.sort_unstable();
    assert_eq!(edges, walked.wireframe.edges().map(|(id, _)| id).collect::<Vec<_>>());
    // It is saved, and is part of what the hash of the design covers.
    let opened = wirebend_files::document::Document::open(&walked.to_bytes().unwrap(), "a.wirebend").unwrap();
    assert_eq!(opened.walks, walked.walks);
    assert_ne!(walked.design_hash().unwrap(), before.design_hash().unwrap());
    // Where somebody chooses otherwise it is given up, and where one of its edges goes.
    for other in
        [json!({"edit": "reversed", "reversed": true}), json!({"edit": "delete", "edges": [edges[0].0]})]
    {
        edit(&mut editor, &other);
        assert!(editor.document().walks.is_empty(), "{other}");
        editor.undo().unwrap();
        assert_eq!(editor.document(), &walked);
    }
    // One that does not pass all edges is not used, and that is said.
    let last = walked.wireframe.vertices().last().unwrap().0.0;
    edit(&mut editor, &json!({"edit": "draw", "from": last, "through_mm": [[0.0, 0.0, 500.0]]}));
    assert_eq!(editor.document().walks, walked.walks);
    assert_eq!(editor.check(&app(), &[]).unwrap().wires.len(), 1);
    editor.undo().unwrap();
    editor.undo().unwrap();
    assert_eq!(editor.document(), &before);
}

fn settings(value: serde_json::Value) -> wirebend_editor::SearchSettings {
    serde_json::from_value(value).unwrap()
}

/// How many things the wires hit.
fn hits(editor: &mut wirebend_editor::Editor) -> usize {
    let found = editor.collision_check(&app(), &[]).unwrap().run(&mut |_, _| true).unwrap();
    assert!(found.checked);
    found.contacts.len()
}

/// What a search has found to be in its way is told with the changes that were tried, and each is one change that hits nothing.
#[test]
fn a_search_without_success_comes_with_what_helps_as_edits() {
    let mut editor = open("cup-holder.obj");
    edit(&mut editor, &json!({"edit": "machine", "machine": "wirebend-kit", "material": null}));
    let now = hits(&mut editor);
    let search = editor.fix_search(&app()).unwrap();
    let one = search.avoid_collisions(&app(), &settings(json!({"wires": 1})), &NoProgress).unwrap();
    assert!(!one.found && !one.ended, "{one:?}");
    // The best that there is still hits something, and says so.
    let best = one.best.as_ref().expect("other sides of the bends hit less");
    assert_eq!(best.title, "Bend in an order that hits less");
    assert!((1..now).contains(&best.after.collisions.unwrap()), "{best:?}");
    let [unfound] = &one.unfound[..] else { panic!("{:?}", one.unfound) };
    assert!(unfound.vertex.is_some() && unfound.body.is_some() && unfound.search.is_some(), "{unfound:?}");
    let titles: Vec<&str> = one.helps.iter().map(|help| help.fix.title.as_str()).collect();
    assert_eq!(titles, ["Bend 2 wires that hit nothing", "Move vertex 1 by 1.0 mm"]);
    let before = editor.document().clone();
    for help in &one.helps {
        assert_eq!(help.fix.after.collisions, Some(0));
        editor.edit(&app(), &help.fix.edit).unwrap();
        assert_eq!(hits(&mut editor), 0, "{}", help.fix.title);
        editor.undo().unwrap();
        assert_eq!(editor.document(), &before, "one change");
    }
    // Without a limit it finds the two wires itself.
    let search = editor.fix_search(&app()).unwrap();
    let free = search.avoid_collisions(&app(), &settings(json!({})), &NoProgress).unwrap();
    assert!(free.found && free.unfound.is_empty() && free.helps.is_empty());
    assert_eq!(free.best.unwrap().title, "Bend 2 wires that hit nothing");
}

/// Has enough after so many looks.
#[derive(Default)]
struct Impatient {
    looks: Cell<u32>,
    told_how_far: Cell<bool>,
    found: RefCell<Vec<FoundSoFar>>,
}

impl Impatient {
    fn after(looks: u32) -> Self {
        Self { looks: looks.into(), ..Self::default() }
    }
}

impl Progress for Impatient {
    fn stage(&self, _name: &str) {}

    fn advance(&self, done: u64, of: u64) {
        assert!(done <= of);
        self.told_how_far.set(true);
    }

    fn found(&self, found: FoundSoFar) {
        self.found.borrow_mut().push(found);
    }

    fn goes_on(&self) -> bool {
        self.looks.set(self.looks.get().saturating_sub(1));
        self.looks.get() > 0
    }
}

/// Who ends a search keeps what it has found, and is told of nothing that was not tried.
#[test]
fn a_search_that_is_ended_keeps_its_best_and_claims_no_more() {
    let mut editor = open("house.obj");
    // It finds an order after some steps, and looks for better ones.
    let mut after = |looks: u32| {
        let impatient = Impatient::after(looks);
        let search = editor.fix_search(&app()).unwrap();
        let found = search.avoid_collisions(&app(), &settings(json!({})), &impatient).unwrap();
        assert!(impatient.told_how_far.get(), "it says how far it is");
        let last = impatient.found.borrow().last().copied().expect("and what it has");
        assert_eq!((last.part, last.parts), (1, 1));
        assert_eq!(last.best.map(|best| best.wires), found.found.then_some(1));
        found
    };
    assert!(!after(1000).ended, "it comes to an end by itself");
    let kept = (1..60).rev().map(&mut after).find(|found| found.ended).expect("one look less ends it");
    let best = kept.best.expect("one was found until then");
    assert_eq!((kept.found, best.after.collisions), (true, Some(0)));

    edit(&mut editor, &json!({"edit": "reversed", "reversed": true}));
    let at_once = Impatient::after(0);
    let search = editor.fix_search(&app()).unwrap();
    let none = search.avoid_collisions(&app(), &settings(json!({})), &at_once).unwrap();
    assert!(none.ended && !none.found && none.helps.is_empty(), "{none:?}");
    assert_eq!(at_once.found.take(), [FoundSoFar { part: 1, parts: 1, best: None }]);
    let now = hits(&mut editor);
    assert!(none.best.is_none_or(|best| best.after.collisions.unwrap() < now));
    let [unfound] = &none.unfound[..] else { panic!("{:?}", none.unfound) };
    let search = unfound.search.as_ref().unwrap();
    assert!(search.ended && search.tried.is_empty(), "{search:?}");
    assert!(unfound.message.contains("no change that could help was tried"), "{}", unfound.message);
}

/// Of several parts each is searched for itself: what was found for one is not told as that of the next.
#[test]
fn what_is_found_is_told_of_the_part_that_is_searched() {
    let mut editor = open("house.obj");
    let aside = [[1, 0, 0, 300], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]];
    let vertices: Vec<u32> = editor.document().wireframe.vertices().map(|(id, _)| id.0).collect();
    edit(&mut editor, &json!({"edit": "array", "vertices": vertices, "step": aside, "count": 1}));
    let patient = Impatient::after(u32::MAX);
    let search = editor.fix_search(&app()).unwrap();
    assert!(search.avoid_collisions(&app(), &settings(json!({})), &patient).unwrap().found);
    let told = patient.found.take();
    let (first, second): (Vec<FoundSoFar>, Vec<FoundSoFar>) =
        told.iter().copied().partition(|found| found.part == 1);
    for of_part in [first, second] {
        let [before, .., found] = &of_part[..] else { panic!("{told:?}") };
        assert_eq!((before.parts, before.best), (2, None));
        assert_eq!(found.best.map(|best| best.wires), Some(1));
    }
    assert!(told.is_sorted_by_key(|found| found.part), "{told:?}");
}

#[test]
fn settings_of_a_search_that_make_no_sense_are_refused() {
    for (wrong, said) in [
        (json!({"effort": 0}), "the effort of the search"),
        (json!({"wires": 0}), "the number of wires"),
        (json!({"weights": {"wire": 0}}), "the sum of the weights"),
    ] {
        let search = open("house.obj").fix_search(&app()).unwrap();
        let refused = search.avoid_collisions(&app(), &settings(wrong), &NoProgress).unwrap_err().to_string();
        assert!(refused.contains(said) && refused.contains("expected"), "{refused}");
    }
}

#[test]
fn a_walk_of_edges_that_are_not_there_is_refused() {
    let mut editor = open("house.obj");
    for walk in [json!({"start": 0, "edges": [99]}), json!({"start": 99, "edges": [0]})] {
        let request = serde_json::from_value(json!({"edit": "walks", "walks": [walk]})).unwrap();
        let refused = editor.edit(&app(), &request).unwrap_err().to_string();
        assert!(refused.contains("99"), "{refused}");
    }
    // It has its own direction, whatever the design says of others.
    edit(&mut editor, &json!({"edit": "reversed", "reversed": true}));
    let route = editor.check(&app(), &[]).unwrap().wires[0].route.clone();
    let found = editor.document().wireframe.clone();
    let edges: Vec<u32> = route
        .windows(2)
        .map(|pair| {
            found
                .edges()
                .find(|(_, e)| [e.a.0, e.b.0] == [pair[0], pair[1]] || [e.b.0, e.a.0] == [pair[0], pair[1]])
        })
        .map(|edge| edge.unwrap().0.0)
        .collect();
    edit(&mut editor, &json!({"edit": "walks", "walks": [{"start": route[0], "edges": edges}]}));
    assert!(editor.document().reversed);
    assert_eq!(editor.check(&app(), &[]).unwrap().wires[0].route, route);
    // Edges that do not meet are no walk: the wire runs as it is found.
    edit(&mut editor, &json!({"edit": "walks", "walks": [{"start": 0, "edges": [0, 3, 1, 2, 4, 5]}]}));
    assert!(editor.check(&app(), &[]).unwrap().feasible);
}
