//! Numbers, angles and lengths on what is printed, in the unit that was asked for, and flat wire as it is.

use nalgebra::Point3;
use wirebend_core::bend::{Frame, Step, replay};
use wirebend_core::units::DisplayUnit;
use wirebend_files::write::{
    Drawing, JobSheet, LabelStep, PictureWire, SheetStep, SheetWire, Template, job_sheet, template,
};

use super::super::step;
use super::pages::{Page, pages, sheet};
use super::templates::{centreline, of, texts};

/// The template of a program, with what stands beside it.
fn labelled(steps: &[Step], unit: DisplayUnit) -> Drawing {
    let labels = steps.iter().map(|step| LabelStep { feed_mm: step.feed.mm(), bend_deg: step.bend.deg() });
    let path = replay(Frame::default(), steps);
    template(&Template { steps: vec![labels.collect()], unit, ..of(vec![path]) })
}

/// Whoever lays the wire on its template sees which bend it is, how far it turns and how long its sides are.
#[test]
fn bends_and_edges_have_their_figures() {
    let flat = [step(40.0, 0.0, 90.0), step(50.8, 180.0, 45.0), step(20.0, 0.0, 0.0)];
    let drawing = labelled(&flat, DisplayUnit::Millimetre);
    let said = texts(&drawing);
    for expected in ["1", "90.0°", "2", "45.0°", "40.0", "50.8", "20.0", "start", "end"] {
        assert_eq!(said.iter().filter(|text| **text == expected).count(), 1, "{expected}: {said:?}");
    }
    assert!(said.join(" ").contains("lengths from corner to corner in mm"));
    let inches = labelled(&flat, DisplayUnit::Inch);
    let said = texts(&inches).join(" ");
    assert!(
        said.contains("2.000") && said.contains("in inches") && said.contains("wire of 0.1181 in"),
        "{said}"
    );
    // The wire itself is as large in both.
    assert_eq!(centreline(&inches), centreline(&drawing));
    // In three views each edge has its length once, and each bend its number in all of them.
    let turned = [step(30.0, 0.0, 90.0), step(25.0, 90.0, 90.0), step(35.0, 0.0, 0.0)];
    let drawing = labelled(&turned, DisplayUnit::Millimetre);
    let said = texts(&drawing);
    for (expected, count) in [("30.0", 1), ("25.0", 1), ("35.0", 1), ("1", 3), ("2", 3)] {
        assert_eq!(said.iter().filter(|text| **text == expected).count(), count, "{expected}: {said:?}");
    }
}

/// A sheet of a path of three edges, as it is designed.
fn bent(path: &[[f64; 3]], steps: &[[f64; 3]], unit: DisplayUnit) -> Vec<Page> {
    let points = path.iter().copied().map(Point3::from).collect();
    let step = |designed: &[f64; 3]| SheetStep {
        designed: *designed,
        told: Some(*designed),
        before_zero: false,
        fed_mm: designed[0],
    };
    let wire = SheetWire {
        picture: PictureWire { points, doubled: Vec::new() },
        facts: Vec::new(),
        steps: steps.iter().map(step).collect(),
    };
    pages(&job_sheet(&JobSheet { wires: vec![wire], unit, ..sheet(0) }).bytes)
}

/// Flat wire is seen straight on, however it lies in space: its edges are as long beside each other on paper as in the design, and its right
/// angle is one. Wire that is not flat is seen from a corner.
#[test]
fn flat_wire_is_drawn_flat() {
    let steps = [[40.0, 0.0, 90.0], [20.0, 0.0, 0.0]];
    for (path, view) in [
        ([[0., 0., 0.], [40., 0., 0.], [40., 20., 0.]], ", as in the view Top: its first bend turns left."),
        (
            [[0., 0., 0.], [0., 40., 0.], [20., 40., 0.]],
            ", as in the view Bottom: its first bend turns left.",
        ),
        (
            [[0., 0., 0.], [0., 0., 40.], [0., -20., 40.]],
            ", as in the view Right: its first bend turns left.",
        ),
        ([[0., 0., 0.], [24., 32., 0.], [24., 32., 20.]], ": its first bend turns left."),
    ] {
        let pages = bent(&path, &steps, DisplayUnit::Millimetre);
        assert!(pages[0].says(&format!("Seen straight from above its plane{view}")), "{path:?}");
        let length = |[a, b]: &[[f64; 2]; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
        let joined = |pair: &&[[[f64; 2]; 2]]| {
            let ([a, b], [c, d]) = (pair[0], pair[1]);
            let across = (b[0] - a[0]) * (d[0] - c[0]) + (b[1] - a[1]) * (d[1] - c[1]);
            let same = (b[0] - c[0]).hypot(b[1] - c[1]) < 1e-3;
            same && across.abs() < 0.1 && (length(&pair[0]) / length(&pair[1]) - 2.0).abs() < 1e-3
        };
        assert!(pages[0].lines.windows(2).any(|pair| joined(&pair)), "{path:?}");
    }
    let path = [[0., 0., 0.], [30., 0., 0.], [30., 20., 0.], [30., 20., 10.]];
    let pages =
        bent(&path, &[[30.0, 0.0, 90.0], [20.0, 90.0, 90.0], [10.0, 0.0, 0.0]], DisplayUnit::Millimetre);
    assert!(pages[0].says("In circles") && !pages[0].says("from above"));
}

/// Whoever measures in inches reads inches, but the machine's numbers are what it is sent.
#[test]
fn lengths_are_in_the_unit_that_was_asked_for() {
    let path = [[0., 0., 0.], [50.8, 0., 0.], [50.8, 25.4, 0.]];
    let steps = [[50.8, 0.0, 90.0], [25.4, 0.0, 0.0]];
    let page = &bent(&path, &steps, DisplayUnit::Inch)[0];
    for expected in [
        "2.000",
        "1.000",
        "lengths in inches",
        "2.0000",
        "50.800",
        "feed in",
        "run in",
        "as sent to the machine, in mm",
    ] {
        assert!(page.says(expected), "{expected}: {}", page.all());
    }
    let page = &bent(&path, &steps, DisplayUnit::Millimetre)[0];
    assert!(page.says("50.8") && page.says("90.0°") && !page.says("feed in"));
}
