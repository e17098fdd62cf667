//! Fixes of wires and feeds that are longer than the stock.

use super::{machine_with, mend, promised, strand, titles};
use crate::edit;
use serde_json::json;

/// Of 600 mm of stock 200 mm can be fed.
const SHORT_STOCK: &str =
    r#""limits": {"max_stock_mm": {"value": 600, "source": "a test", "measured": false}}"#;

/// A zigzag of right angles with edges of 60 mm.
fn zigzag(edges: u32) -> Vec<[f64; 3]> {
    (0..=edges).map(|k| [60.0 * f64::from(k.div_ceil(2)), 60.0 * f64::from(k / 2), 0.0]).collect()
}

#[test]
fn a_wire_that_is_too_long_becomes_as_few_as_fit() {
    let (_folder, app) = machine_with(SHORT_STOCK);
    // 360 mm are two wires of 180 mm, 540 mm are three.
    for (edges, title) in
        [(6, "Split at vertex 3 into two wires"), (9, "Split at vertices 3 and 6 into 3 wires")]
    {
        let mut editor = strand(&app, "other", &zigzag(edges));
        let fixes = promised(&mut editor, &app);
        // Five right angles save 5·2.230 mm: (200 + 11.15)/360 = 0.5865. Nine edges would be too short.
        let scale = if edges == 6 { "Scale the design by 0.586" } else { title };
        let offered = titles(&fixes, "stock_too_long");
        assert!(offered.iter().any(|offer| offer == title), "{offered:?}");
        assert!(offered.iter().all(|offer| offer == title || offer == scale), "{offered:?}");
        assert_eq!(offered.len(), if edges == 6 { 2 } else { 1 });
        let check = mend(&mut editor, &app, title);
        assert!(check.feasible, "{check:?}");
        assert!(check.wires.iter().all(|wire| wire.length_mm.unwrap() < 180.1));
    }
}

#[test]
fn an_edge_longer_than_the_stock_is_two_wires_that_touch_in_its_middle() {
    let (_folder, app) = machine_with(SHORT_STOCK);
    // Drawn from either end.
    for (from, to) in [([0., 0., 0.], [300., 0., 0.]), ([300., 0., 0.], [0., 0., 0.])] {
        let mut editor = strand(&app, "other", &[from, to]);
        edit(&mut editor, &json!({"edit": "draw", "from": 1, "through_mm": [[to[0], 50, 0]]}));
        let check = mend(&mut editor, &app, "Split edge 0 in the middle, into two wires");
        assert!(check.feasible, "{check:?}");
        let mut lengths: Vec<f64> = check.wires.iter().map(|wire| wire.length_mm.unwrap()).collect();
        lengths.sort_by(f64::total_cmp);
        assert!((lengths[0] - 150.0).abs() < 1e-9 && (lengths[1] - 200.0).abs() < 1e-9, "{lengths:?}");
        assert_eq!(editor.state().undo.as_deref(), Some("split into 2 wires"));
    }
    // Where edges lie in line there is a vertex to split at.
    let mut editor = strand(&app, "other", &[[0., 0., 0.], [90., 0., 0.], [170., 0., 0.], [300., 0., 0.]]);
    assert!(mend(&mut editor, &app, "Split at vertex 2 into two wires").feasible);
}
