//! What a fillet or a shape would make, told before it is made.

use serde_json::{Value, json};
use wirebend_editor::{EditOutcome, EditRequest, Editor, FilletPart};

use super::{app, edit};

fn told(editor: &Editor, request: &Value) -> Option<EditOutcome> {
    let request: EditRequest = serde_json::from_value(request.clone()).unwrap();
    editor.outcome(&app(), &request).unwrap()
}

fn fillet(radius: f64) -> Value {
    json!({"edit": "fillet", "vertices": [1, 2], "radius_mm": radius, "step_deg": 15})
}

/// A hook of two corners on each machine that the browser test uses, and without one.
fn hook(machine: Option<&str>) -> Editor {
    let mut editor = Editor::new(&app(), machine, None).unwrap();
    edit(
        &mut editor,
        &json!({"edit": "draw", "through_mm": [[0, 0, 0], [0, 0, 120], [120, 0, 120], [120, 0, 0]]}),
    );
    editor
}

/// For a person who reads how many chords there will be, and takes the radius that is offered.
#[test]
fn a_fillet_is_told_as_the_machine_of_the_design_makes_it() {
    for machine in [None, Some("wirebend-kit"), Some("pensa-diwire-pro"), Some("grbl-bender")] {
        let mut editor = hook(machine);
        let before = editor.document().clone();
        for radius in [3.0, 36.0, 55.0, 70.0] {
            match told(&editor, &fillet(radius)) {
                Some(EditOutcome::Fillet { chords, shortest_mm, needed_mm, clear_mm: _ }) => {
                    assert!(shortest_mm >= needed_mm - 1e-6, "{machine:?} {radius}");
                    let new = edit(&mut editor, &fillet(radius)).edges;
                    let new = new.iter().filter(|edge| edge.id > 2).count();
                    assert_eq!(
                        u32::try_from(new).unwrap(),
                        chords.iter().sum::<u32>(),
                        "{machine:?} {radius}"
                    );
                    editor.undo().unwrap();
                }
                Some(EditOutcome::NoFillet { part, nearest_mm, length_mm, needed_mm, .. }) => {
                    assert!(length_mm <= needed_mm, "{machine:?} {radius}");
                    assert_eq!(part == FilletPart::Chords, radius < 36.0, "{machine:?} {radius}");
                    let offered = told(&editor, &fillet(nearest_mm.unwrap()));
                    assert!(
                        matches!(offered, Some(EditOutcome::Fillet { .. })),
                        "{machine:?} {radius}: {offered:?}"
                    );
                }
                other => panic!("{machine:?} {radius}: {other:?}"),
            }
        }
        assert_eq!(editor.document(), &before);
    }
}

/// Who takes the radius that is offered, for one corner, which leaves a sharp one beside it, or for all, would be warned of it at once.
#[test]
fn a_radius_that_is_offered_is_bent_without_a_warning() {
    let hook: &[[f64; 3]] = &[[0.0, 0.0, 0.0], [0.0, 0.0, 120.0], [110.0, 0.0, 120.0], [110.0, 0.0, 50.0]];
    let strand: &[[f64; 3]] = &[
        [0.0, 0.0, 0.0],
        [300.0, 0.0, 0.0],
        [300.0, 0.0, 300.0],
        [300.0, 259.8, 450.0],
        [83.5, 151.5, 387.5],
    ];
    for machine in ["wirebend-kit", "pensa-diwire-pro", "grbl-bender"] {
        for (through, vertices) in [(hook, &[1][..]), (hook, &[1, 2]), (strand, &[2]), (strand, &[1, 2, 3])] {
            for radius in [10.0, 30.0, 36.0, 85.0, 250.0] {
                let fillet = |radius: f64| json!({"edit": "fillet", "vertices": vertices, "radius_mm": radius, "step_deg": 15});
                let mut editor = Editor::new(&app(), Some(machine), None).unwrap();
                edit(&mut editor, &json!({"edit": "draw", "through_mm": through}));
                let offered = match told(&editor, &fillet(radius)) {
                    Some(EditOutcome::Fillet { clear_mm, .. }) => clear_mm,
                    Some(EditOutcome::NoFillet { nearest_mm, .. }) => nearest_mm,
                    other => panic!("{other:?}"),
                };
                edit(&mut editor, &fillet(offered.unwrap()));
                let found = editor.check(&app(), &[]).unwrap().diagnostics;
                let length =
                    |code: &str| code.contains("edge") || code.contains("feed") || code.contains("overlap");
                let said: Vec<_> =
                    found.iter().filter(|one| length(one.code.as_str())).map(|one| &one.message).collect();
                assert!(said.is_empty(), "{machine} {vertices:?} {radius} -> {offered:?}: {said:?}");
            }
        }
    }
}

/// A circle of 30 mm has edges of 15.5 mm if there are twelve; the machine feeds no less than 25 mm and takes some off at each bend, so
/// that six of 30 mm fit. Nothing is drawn.
#[test]
fn a_shape_is_told_with_the_number_of_edges_that_fits() {
    let circle =
        json!({"edit": "circle", "centre_mm": [0, 0, 0], "plane": "xy", "radius_mm": 30, "edges": 12});
    let editor = hook(Some("wirebend-kit"));
    let Some(EditOutcome::Shape { edges, length_mm, needed_mm, fits, fitting }) = told(&editor, &circle)
    else {
        panic!("a circle is a shape")
    };
    assert_eq!((edges, fits, fitting), (12, false, Some(6)));
    assert!((length_mm - 60.0 * 15.0_f64.to_radians().sin()).abs() < 1e-9 && needed_mm > 25.0);
    let free = told(&hook(None), &circle);
    assert!(matches!(free, Some(EditOutcome::Shape { fits: true, fitting: Some(12), .. })), "{free:?}");
    assert_eq!(editor.view().edges.len(), 3);
}

#[test]
fn what_would_be_refused_is_refused_alike_and_other_edits_have_no_outcome() {
    let mut editor = hook(Some("wirebend-kit"));
    for wrong in [
        json!({"edit": "fillet", "vertices": [0], "radius_mm": 30, "step_deg": 15}),
        fillet(0.0),
        json!({"edit": "circle", "centre_mm": [0, 0, 0], "plane": "xy", "radius_mm": 30, "edges": 2}),
    ] {
        let request: EditRequest = serde_json::from_value(wrong).unwrap();
        let told = editor.outcome(&app(), &request).unwrap_err().to_string();
        assert_eq!(told, editor.edit(&app(), &request).unwrap_err().to_string());
    }
    assert_eq!(told(&editor, &json!({"edit": "weld", "tolerance_mm": 1})), None);
}

/// Three vertices of a person's own: upright, 3-4-5 in x and y, and not through the origin. A second axis that is not square to the first,
/// and lengths that are not 1, are as good.
#[test]
fn shapes_lie_on_a_plane_of_ones_own() {
    let mut editor = Editor::new(&app(), None, None).unwrap();
    let on = json!({"origin_mm": [10, 0, 5], "u": [3, 4, 0], "v": [6, 8, 2]});
    let helix = json!({"edit": "helix", "centre_mm": [5, 6, 7], "plane": "xy", "on": on, "radius_mm": 50, "pitch_mm": 20,
        "turns": 1, "edges_per_turn": 4});
    edit(&mut editor, &helix);
    let places: Vec<[f64; 3]> = editor.view().vertices.iter().map(|vertex| vertex.at_mm).collect();
    // u = (0.6, 0.8, 0), v = (0, 0, 1), off the plane (0.8, -0.6, 0).
    let centre = [10.0 + 5.0 * 0.6 + 7.0 * 0.8, 5.0 * 0.8 - 7.0 * 0.6, 11.0];
    let expected = [(50.0, 0.0), (0.0, 50.0), (-50.0, 0.0), (0.0, -50.0), (50.0, 0.0)];
    assert_eq!(places.len(), expected.len());
    for (k, (place, (along, up))) in (0_u8..).zip(places.iter().zip(expected)) {
        let off = 5.0 * f64::from(k);
        let wanted =
            [centre[0] + along * 0.6 + off * 0.8, centre[1] + along * 0.8 - off * 0.6, centre[2] + up];
        let error = place.iter().zip(wanted).map(|(is, wanted)| (is - wanted).abs()).fold(0.0, f64::max);
        assert!(error < 1e-9, "{k}: {place:?}, not {wanted:?}");
    }
}
