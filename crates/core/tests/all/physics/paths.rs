//! The program, and how points become one.

use nalgebra::Point3;
use wirebend_core::bend::{Frame, Step, program_of_path, replay, straight_lengths};
use wirebend_core::schedule::{HeadLimits, schedule};

use crate::physics::document::{Document, Number};
use crate::physics::{deg, mm};

fn step(feed: f64, rotate: f64, bend: f64) -> Step {
    Step { feed: mm(feed), rotate: deg(rotate), bend: deg(bend) }
}

fn end_of(steps: &[Step]) -> Point3<f64> {
    *replay(Frame::default(), steps).last().unwrap()
}

#[track_caller]
fn are(shown: &[Number], computed: Point3<f64>) {
    shown.iter().zip(computed.iter()).for_each(|(shown, &computed)| shown.is(computed));
}

pub fn claims(page: &mut Document) {
    turtle(page);
    points(page);
    bend_table(page);
    turned_head(page);
}

fn turtle(page: &mut Document) {
    let [first, bend, second, at @ ..]: [_; 6] =
        page.sentence("Feed {}, bend {}°, feed {} ends at ({}, {}, {}).");
    let (first, bend, second) = (first.value, bend.value, second.value);
    are(&at, end_of(&[step(first, 0.0, bend), step(second, 0.0, 0.0)]));
    let [next, rotate, third, at @ ..]: [_; 6] = page.sentence(
        "With a second bend of {}° after a rotation of {}° and one more feed of {} the wire ends at ({}, {}, {});",
    );
    let turned = |rotate| {
        let second = step(second, rotate, next.value);
        end_of(&[step(first, 0.0, bend), second, step(third.value, 0.0, 0.0)])
    };
    are(&at, turned(rotate.value));
    let [mirrored, at @ ..]: [_; 4] =
        page.sentence("with a rotation of {}° it ends at ({}, {}, {}), the mirror image.");
    are(&at, turned(mirrored.value));
}

fn points(page: &mut Document) {
    let [least, most, above, up_to] =
        page.sentence("Bends of a design lie from {}° to {}°, rotations above {}° up to {}°.");
    let mut turns = Vec::new();
    // A spiral whose planes turn all the way round, and a fold.
    for k in 0..72 {
        let angle = f64::from(k).to_radians() * 5.0;
        let side = Point3::new(40.0, 10.0 * angle.cos(), 10.0 * angle.sin());
        let path = [Point3::origin(), Point3::new(10.0, 0.0, 0.0), Point3::new(20.0, 10.0, 0.0), side];
        turns.extend(program_of_path(&path, deg(1e-9)).unwrap().1.steps);
    }
    assert!(turns.iter().all(|turn| turn.bend.deg() >= least.value && turn.bend.deg() <= most.value));
    assert!(turns.iter().all(|turn| turn.rotate.deg() > above.value && turn.rotate.deg() <= up_to.value));
    assert!(
        turns.iter().any(|turn| turn.rotate.deg() < -150.0)
            && turns.iter().any(|turn| turn.rotate.deg() > 150.0)
    );
    let [fold] = page.sentence("A fold back is a bend of {}° in the plane");
    let there_and_back = [Point3::origin(), Point3::new(10.0, 0.0, 0.0), Point3::origin()];
    fold.is(program_of_path(&there_and_back, deg(1e-9)).unwrap().1.steps[0].bend.deg());
}

fn bend_table(page: &mut Document) {
    let [radius] = page.sentence("with a centreline radius of {} mm, goes through these points");
    let rows = page.table(&["Point", "x", "y", "z"]);
    let at = |row: &[Option<Number>]| {
        Point3::new(row[0].unwrap().value, row[1].unwrap().value, row[2].unwrap().value)
    };
    let path: Vec<_> = rows.iter().map(|(_, row)| at(row)).collect();
    let (_, program) = program_of_path(&path, deg(1e-9)).unwrap();
    let lengths = straight_lengths(&program.steps, mm(radius.value));
    let shown = page.table(&["Row", "L", "R", "A"]);
    assert_eq!(shown.len(), program.steps.len());
    for (k, (_, row)) in shown.iter().enumerate() {
        row[0].unwrap().is(lengths[k].unwrap().mm());
        if let (Some(rotate), Some(bend)) = (row[1], row[2]) {
            rotate.is(program.steps[k].rotate.deg());
            bend.is(program.steps[k].bend.deg());
        }
    }
    let [printed] = page.sentence("The manual prints {} for the last length;");
    let last = lengths.last().unwrap().unwrap().mm();
    // Five coordinates with two decimals, each off by up to half a hundredth.
    assert!((printed.value - last).abs() < 0.02, "the last length is {last}");
}

fn turned_head(page: &mut Document) {
    let [half] = page.sentence("(φ, θ) and (φ ± {}°, -θ) are the same bend");
    let made = |rotate: f64, bend: f64| {
        end_of(&[step(10.0, 0.0, 40.0), step(10.0, rotate, bend), step(10.0, 0.0, 0.0)])
    };
    assert!((made(25.0, 50.0) - made(25.0 + half.value, -50.0)).norm() < 1e-9);
    assert!((made(25.0, 50.0) - made(25.0 - half.value, -50.0)).norm() < 1e-9);
    let [bend, rotate, limit, turn, made] = page.sentence(
        "a bend of {}° after a rotation of {}°, with a head that turns {}° to either side, is made as a rotation of {}° and a bend of {}°.",
    );
    let path = replay(
        Frame::default(),
        &[step(10.0, 0.0, 90.0), step(10.0, rotate.value, bend.value), step(10.0, 0.0, 0.0)],
    );
    let (_, program) = program_of_path(&path, deg(1e-9)).unwrap();
    let limits = HeadLimits {
        min: deg(-limit.value),
        max: deg(limit.value),
        seconds_per_degree: 1.0,
        seconds_per_turn: 0.0,
    };
    let scheduled = schedule(&program, &limits, |_| Some(1.0)).unwrap();
    turn.is(scheduled.steps[1].rotate.deg());
    made.is(scheduled.steps[1].bend.deg());
}

#[test]
fn programs_and_tables_are_what_the_page_says() {
    claims(&mut Document::read());
}
