//! Fixes: each does what it says, and for what a machine cannot make there is one.

mod all;
mod bends;
mod drawing;
mod examples;
mod lengths;
mod reach;
mod stock;
mod wires;

use serde_json::json;
use wirebend_editor::{Editor, Fix, LiveCheck, WireFigures};
use wirebend_planning::report::SeverityName;
use wirebend_planning::{DiagnosticReport, Installation};

use crate::app;

/// A machine like the 293 dollar bender, but for some limits.
fn machine_with(limits: &str) -> (tempfile::TempDir, Installation) {
    let folder = tempfile::tempdir().unwrap();
    let profile = format!(
        r#"{{"schema_version": 1, "kind": "machine", "id": "other", "inherits": "wirebend-kit", {limits}}}"#
    );
    let machines = folder.path().join("machines");
    std::fs::create_dir(&machines).unwrap();
    std::fs::write(machines.join("other.json"), profile).unwrap();
    let app = Installation::new(&[folder.path().to_owned()]).unwrap();
    assert!(app.refused_profiles().is_empty(), "{:?}", app.refused_profiles());
    (folder, app)
}

fn strand(app: &Installation, machine: &str, points: &[[f64; 3]]) -> Editor {
    let mut editor = Editor::new(app, Some(machine), None).unwrap();
    let draw = serde_json::from_value(json!({"edit": "draw", "through_mm": points})).unwrap();
    editor.edit(app, &draw).unwrap();
    editor
}

/// A strand on the 293 dollar bender.
fn on_kit(points: &[[f64; 3]]) -> Editor {
    strand(&app(), "wirebend-kit", points)
}

/// What is offered for a code, in order.
fn titles(fixes: &[Fix], code: &str) -> Vec<String> {
    fixes.iter().filter(|fix| fix.mends.code.as_str() == code).map(|fix| fix.title.clone()).collect()
}

/// The only fix with a title, made; what the checks say then.
fn mend(editor: &mut Editor, app: &Installation, title: &str) -> LiveCheck {
    let fixes = promised(editor, app);
    let named: Vec<&Fix> = fixes.iter().filter(|fix| fix.title == title).collect();
    assert!(!named.is_empty(), "{title}: {:?}", fixes.iter().map(|fix| &fix.title).collect::<Vec<_>>());
    editor.edit(app, &named[0].edit).unwrap();
    editor.check(app, &[]).unwrap()
}

fn codes(check: &LiveCheck) -> Vec<&str> {
    check.diagnostics.iter().map(|diagnostic| diagnostic.code.as_str()).collect()
}

fn errors(check: &LiveCheck, severity: SeverityName) -> usize {
    check.diagnostics.iter().filter(|diagnostic| diagnostic.severity == severity).count()
}

/// How often a code is said where a diagnostic is: at its edge where it is about one, else at its vertex.
fn said_there(check: &LiveCheck, diagnostic: &DiagnosticReport) -> usize {
    let edges = |d: &DiagnosticReport| -> Vec<u32> { d.edge.into_iter().chain(d.edges.clone()).collect() };
    let of_edges =
        ["edge", "feed", "arcs_overlap"].iter().any(|word| diagnostic.code.as_str().contains(word));
    let there = |d: &&DiagnosticReport| {
        d.code == diagnostic.code
            && match diagnostic.code.as_str() {
                "no_euler_path" | "stock_too_long" | "route_refused" => true,
                _ if of_edges => edges(d).iter().any(|edge| edges(diagnostic).contains(edge)),
                _ => d.vertex == diagnostic.vertex,
            }
    };
    check.diagnostics.iter().filter(there).count()
}

/// What a figure of a fix has to be: the sums of two checks, one less the other.
fn difference(
    before: &LiveCheck,
    after: &LiveCheck,
    figure: impl Fn(&WireFigures) -> Option<f64>,
) -> Option<f64> {
    let mut total = 0.0;
    for (wires, sign) in [(&after.wires, 1.0), (&before.wires, -1.0)] {
        for wire in wires {
            total += sign * figure(wire)?;
        }
    }
    Some(total)
}

fn close(one: Option<f64>, other: Option<f64>) -> bool {
    match (one, other) {
        (Some(one), Some(other)) => (one - other).abs() < 1e-6,
        (None, None) => true,
        _ => false,
    }
}

/// The fixes of a design, each made, checked and undone: it does what it says, and asking for it changes nothing.
fn promised(editor: &mut Editor, app: &Installation) -> Vec<Fix> {
    let document = editor.document().clone();
    let before = editor.check(app, &[]).unwrap();
    let fixes = editor.fixes(app).unwrap();
    assert_eq!(editor.document(), &document, "asking changes nothing");
    assert!(fixes.len() <= 60);
    for fix in &fixes {
        let alike = fixes.iter().filter(|other| other.mends == fix.mends);
        let most = if fix.mends.code.as_str() == "no_euler_path" { 6 } else { 3 };
        assert!(alike.count() <= most, "{}", fix.title);
        assert!(before.diagnostics.contains(&fix.mends), "{}", fix.title);
        let view = editor.view();
        let change = editor.edit(app, &fix.edit).unwrap();
        let after = editor.check(app, &[]).unwrap();
        let said = &fix.title;
        assert!(
            said_there(&after, &fix.mends) < said_there(&before, &fix.mends),
            "{said}: it is still there"
        );
        assert_eq!(fix.errors_after, errors(&after, SeverityName::Error), "{said}");
        assert_eq!(fix.feasible_after, after.feasible, "{said}");
        let more = |severity| {
            i64::try_from(errors(&after, severity)).unwrap()
                - i64::try_from(errors(&before, severity)).unwrap()
        };
        assert_eq!(fix.change.errors, more(SeverityName::Error), "{said}");
        assert_eq!(fix.change.warnings, more(SeverityName::Warning), "{said}");
        for (told, figure) in [
            (fix.change.length_mm, (|wire| wire.length_mm) as fn(&WireFigures) -> Option<f64>),
            (fix.change.stock_mm, |wire| wire.stock_mm),
            (fix.change.time_s, |wire| wire.time_s),
            (fix.change.cost, |wire| wire.stock_cost),
        ] {
            let measured = difference(&before, &after, figure);
            assert!(close(told, measured), "{said}: {told:?} is told, {measured:?} is measured");
        }
        let sum =
            |figure: fn(&WireFigures) -> Option<f64>| after.wires.iter().map(figure).sum::<Option<f64>>();
        assert!(close(fix.after.stock_mm, sum(|wire| wire.stock_mm)), "{said}");
        assert!(close(fix.after.time_s, sum(|wire| wire.time_s)), "{said}");
        assert!(close(fix.after.cost, sum(|wire| wire.stock_cost)), "{said}");
        assert_eq!(fix.after.wires, after.wires.len(), "{said}");
        // Errors that a wire without a route, or without turns of the head, was not checked for.
        let further =
            [(|wire| !wire.route.is_empty()) as fn(&WireFigures) -> bool, |wire| wire.time_s.is_some()]
                .into_iter()
                .any(|reached| {
                    let missing =
                        |check: &LiveCheck| check.wires.iter().filter(|wire| !reached(wire)).count();
                    missing(&after) < missing(&before)
                });
        assert!(fix.change.errors <= 0 || further, "{said} brings errors");
        // What is drawn beforehand is what is drawn then.
        assert_eq!(fix.preview.gone_edges, change.gone_edges, "{said}");
        for moved in &fix.preview.moved {
            assert!(change.vertices.iter().any(|v| (v.id, v.at_mm) == (moved.vertex, moved.at_mm)), "{said}");
        }
        let was: Vec<u32> = view.vertices.iter().map(|vertex| vertex.id).collect();
        let changed = change.vertices.iter().filter(|vertex| was.contains(&vertex.id)).count();
        assert_eq!(fix.preview.moved.len(), changed, "{said}");
        let mut doubled = change.state.doublings.clone();
        for edge in &view.state.doublings {
            doubled.iter().position(|other| other == edge).map(|at| doubled.remove(at));
        }
        doubled.dedup();
        assert_eq!(fix.preview.doubled, doubled, "{said}");
        editor.undo().unwrap();
        assert_eq!(editor.document(), &document, "{said}");
    }
    fixes
}
