//! All findings of a kind fixed at once.

use wirebend_core::checks::Code;
use wirebend_editor::{Editor, FixAll};

use super::{codes, on_kit};
use crate::app;

fn fix_all(editor: &mut Editor, code: Code) -> Option<FixAll> {
    editor.fix_search(&app()).unwrap().fix_all(&app(), code).unwrap()
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
        }
    }
}
