//! All findings of a kind fixed at once.

use wirebend_core::checks::Code;
use wirebend_editor::{Editor, FixAll};

use super::{codes, on_kit};
use crate::app;

fn fix_all(editor: &mut Editor, code: Code) -> Option<FixAll> {
    editor.fix_search(&app()).unwrap().fix_all(&app(), code, &|| true).unwrap()
}

/// A comb: long teeth, joined by edges of some lengths in turn.
fn comb(gaps: &[f64]) -> Vec<[f64; 3]> {
    let mut points = vec![[0.0, 0.0, 0.0], [0.0, 80.0, 0.0]];
    let (mut x, mut up) = (0.0, true);
    for gap in gaps {
        x += gap;
        let y = if up { 80.0 } else { 0.0 };
        points.extend([[x, y, 0.0], [x, 80.0 - y, 0.0]]);
        up = !up;
    }
    points
}

#[test]
fn all_short_edges_are_fixed_by_one_change_that_one_undo_takes_back() {
    let mut editor = on_kit(&comb(&[12.0, 15.0, 9.0, 14.0]));
    let before = editor.view();
    let errors = editor.check(&app(), &[]).unwrap();
    assert_eq!(codes(&errors).iter().filter(|code| **code == "edge_too_short").count(), 4);
    let all = fix_all(&mut editor, Code::EdgeTooShort).unwrap();
    assert_eq!((all.fixed, all.of), (4, 4));
    assert_eq!(all.fix.title, "Fix all 4 places");
    editor.edit(&app(), &all.fix.edit).unwrap();
    let after = editor.check(&app(), &[]).unwrap();
    assert!(!codes(&after).contains(&"edge_too_short"), "{:?}", codes(&after));
    // What it promised.
    let left = after.diagnostics.iter().filter(|report| report.severity == super::SeverityName::Error);
    assert_eq!(left.count(), all.fix.errors_after);
    editor.undo().unwrap();
    let places = |view: &wirebend_editor::DesignView| -> Vec<[f64; 3]> {
        view.vertices.iter().map(|vertex| vertex.at_mm).collect()
    };
    assert_eq!(places(&editor.view()), places(&before));
}

#[test]
fn for_one_finding_there_is_no_fix_of_all() {
    let mut editor = on_kit(&comb(&[12.0]));
    assert_eq!(fix_all(&mut editor, Code::EdgeTooShort), None);
    assert_eq!(fix_all(&mut editor, Code::MeetsMachine), None);
}

#[test]
fn no_fix_of_all_leaves_more_errors_than_there_were() {
    let mut offered = 0;
    for gaps in [&[12.0, 15.0, 9.0][..], &[3.0, 3.0, 3.0, 3.0], &[21.0, 1.0, 22.0, 2.0]] {
        let mut editor = on_kit(&comb(gaps));
        let before = editor.check(&app(), &[]).unwrap();
        let count = |check: &wirebend_editor::LiveCheck| {
            check.diagnostics.iter().filter(|report| report.severity == super::SeverityName::Error).count()
        };
        for code in [Code::EdgeTooShort, Code::FeedTooShort] {
            let Some(all) = fix_all(&mut editor, code) else { continue };
            assert!(all.fix.errors_after <= count(&before), "{gaps:?}: {all:?}");
            assert!(all.fix.change.errors <= 0);
            offered += 1;
        }
    }
    assert!(offered > 0, "nothing was looked at");
}

#[test]
fn no_fix_of_all_moves_a_vertex_farther_than_one_fix_may() {
    // Stairs: each step is too short, and its fix pushes the next one on.
    let stairs = |step: f64, count: u32| {
        let mut points = vec![[-60.0, 0.0, 0.0]];
        for k in 0..count {
            let at = step * f64::from(k);
            points.extend([[at, at, 0.0], [at, at + step, 0.0]]);
        }
        let end = step * f64::from(count);
        points.push([end + 60.0, end, 0.0]);
        points
    };
    let mut offered = 0;
    for points in [stairs(3.0, 4), stairs(10.0, 3), comb(&[3.0, 3.0, 3.0]), comb(&[12.0, 15.0, 9.0])] {
        let mut editor = on_kit(&points);
        for code in [Code::EdgeTooShort, Code::FeedTooShort, Code::ArcsOverlap] {
            let Some(all) = fix_all(&mut editor, code) else { continue };
            offered += 1;
            let after = {
                let mut editor = on_kit(&points);
                editor.edit(&app(), &all.fix.edit).unwrap();
                editor.view()
            };
            let apart =
                |a: &[f64; 3], b: &[f64; 3]| (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt();
            let view = editor.view();
            for vertex in &after.vertices {
                let Some(before) = view.vertices.iter().find(|other| other.id == vertex.id) else { continue };
                let beside = (0..points.len() - 1).map(|k| [points[k], points[k + 1]]);
                let shortest = beside
                    .filter(|ends| ends.contains(&before.at_mm))
                    .map(|[a, b]| apart(&a, &b))
                    .fold(f64::INFINITY, f64::min);
                // Twice the shortest edge of this machine, which is 27.3 mm between right angles.
                let by = apart(&before.at_mm, &vertex.at_mm);
                assert!(by <= shortest.max(2.0 * 27.3), "{code:?}: vertex {} by {by} mm", vertex.id);
            }
        }
    }
    assert!(offered > 1, "nothing was looked at");
}

#[test]
fn a_search_that_is_given_up_offers_nothing() {
    let mut editor = on_kit(&comb(&[12.0, 15.0]));
    assert!(fix_all(&mut editor, Code::EdgeTooShort).is_some());
    let search = editor.fix_search(&app()).unwrap();
    assert_eq!(search.fix_all(&app(), Code::EdgeTooShort, &|| false).unwrap(), None);
}
