//! What is written is read back as it was, within the rounding of its format.

use std::fmt::Write as _;

use nalgebra::Point3;
use proptest::prelude::*;
use proptest::sample::Index;
use wirebend_core::bend::{Convention, Frame, Sign, Step, replay};
use wirebend_core::units::Length;
use wirebend_files::read::{Format, ReadOptions, read};
use wirebend_files::write::{Centreline, Tube, obj};

use super::{import, mm, step};

/// Programs as they come out of paths, and as other tools write them: signs, straight joints,
/// bends in a row.
fn any_steps() -> impl Strategy<Value = Vec<Step>> {
    let feed = prop_oneof![9 => 20.0..200.0_f64, 1 => Just(0.0)];
    let angle = |most: f64| prop_oneof![8 => -most..most, 1 => Just(0.0), 1 => -1e-9..1e-9];
    let one = (feed, angle(180.0), angle(160.0)).prop_map(|(feed, rotate, bend)| step(feed, rotate, bend));
    (prop::collection::vec(one, 0..12), 20.0..200.0_f64).prop_map(|(mut steps, last)| {
        steps.push(step(last, 0.0, 0.0));
        steps
    })
}

fn any_convention() -> impl Strategy<Value = Convention> {
    let sign = || prop_oneof![Just(Sign::Same), Just(Sign::Opposite)];
    (sign(), sign()).prop_map(|(bend, rotate)| Convention { bend, rotate })
}

/// How tables are spelled: what is between cells, the decimal mark, whether columns have names.
#[derive(Debug, Clone, Copy)]
struct Style {
    separator: char,
    mark: char,
    header: bool,
}

impl Style {
    fn row(self, cells: &[String]) -> String {
        format!("{}\n", cells.join(&self.separator.to_string()))
    }

    /// A table with a row of empty cells in it, as spreadsheets leave them.
    fn with_empty_row(self, text: &str, before: Index) -> String {
        let mut lines: Vec<&str> = text.lines().collect();
        let empty = self.separator.to_string().repeat(2);
        lines.insert(before.index(lines.len() + 1), &empty);
        lines.join("\n")
    }

    /// Four decimals.
    fn number(self, value: f64) -> String {
        format!("{value:.4}").replace('.', &self.mark.to_string())
    }
}

fn any_style() -> impl Strategy<Value = Style> {
    let spelled = prop_oneof![
        Just((',', '.')),
        Just((';', '.')),
        Just((';', ',')),
        Just(('\t', '.')),
        Just(('\t', ','))
    ];
    (spelled, any::<bool>()).prop_map(|((separator, mark), header)| Style { separator, mark, header })
}

/// What the numbers of a table of bends count from.
#[derive(Debug, Clone, Copy)]
struct Counted {
    distances: bool,
    corners: bool,
    absolute: bool,
}

fn any_counted() -> impl Strategy<Value = Counted> {
    let all = (any::<bool>(), any::<bool>(), any::<bool>());
    all.prop_map(|(distances, corners, absolute)| Counted { distances, corners, absolute })
}

/// A table of bends with this radius, or `None` where arcs overlap and lengths between them would be negative.
fn bend_table(steps: &[Step], radius: f64, clr: bool, style: Style, counted: Counted) -> Option<String> {
    let Counted { distances, corners, absolute } = counted;
    let length = if distances { "D" } else { "L" };
    let names = [
        format!("{length}{}_mm", if corners { "corner" } else { "" }),
        format!("R{}_deg", if absolute { "abs" } else { "" }),
        "A_deg".to_owned(),
        "CLR_mm".to_owned(),
    ];
    let columns = if clr { 4 } else { 3 };
    // Without names a table has lengths between tangents, and rotations from one bend to the next.
    let header = style.header || distances || corners || absolute;
    let mut text = if header { style.row(&names[..columns]) } else { String::new() };
    let (mut before, mut from_start, mut turned) = (0.0, 0.0, 0.0);
    for (k, step) in steps.iter().enumerate() {
        let angle = step.bend.deg().abs().to_radians();
        let after = if corners { 0.0 } else { radius * (angle / 2.0).tan() };
        let straight = step.feed.mm() - before - after;
        if straight < 0.0 {
            return None;
        }
        from_start += straight;
        turned += step.rotate.deg();
        let length = if distances { from_start } else { straight };
        let rotation = if absolute { turned.rem_euclid(360.0) } else { step.rotate.deg() };
        let mut cells = [length, rotation, step.bend.deg(), radius].map(|value| style.number(value));
        if k + 1 == steps.len() {
            cells[1..].fill(String::new());
        }
        text.push_str(&style.row(&cells[..columns]));
        from_start += if corners { 0.0 } else { radius * angle };
        before = after;
    }
    Some(text)
}

/// A Pensa script: every feed, and what turns by more than nothing.
fn script(steps: &[Step], comment: &str, spell: impl Fn(&str) -> String) -> String {
    let mut text = format!("({})\n", comment.replace(['(', ')'], "").replace(char::is_control, " "));
    for step in steps {
        writeln!(text, "{} {:.5}", spell("FEED"), step.feed.mm()).unwrap();
        for (command, angle) in [("ROTATE", step.rotate), ("BEND", step.bend)] {
            if angle.deg().abs() >= 0.5e-5 {
                writeln!(text, "{} {:.5}", spell(command), angle.deg()).unwrap();
            }
        }
    }
    text
}

/// A WireBend-kit program with a comment, every command on its line.
fn kit(steps: &[Step]) -> String {
    let mut text = "# design ab12\n".to_owned();
    for step in steps {
        for (letter, value) in [('F', step.feed.mm()), ('R', step.rotate.deg()), ('B', step.bend.deg())] {
            if letter == 'F' || format!("{value:.3}").parse() != Ok(0.0) {
                text.extend([letter.to_string(), format!(" {value:.3}\n")]);
            }
        }
    }
    text
}

/// Every value within half a digit of what it was.
fn assert_rounded(ours: &[Step], theirs: &[Step], digit: f64) -> Result<(), TestCaseError> {
    prop_assert_eq!(ours.len(), theirs.len());
    let half = digit / 2.0 + 1e-9;
    for (a, b) in ours.iter().zip(theirs) {
        prop_assert!((a.feed.mm() - b.feed.mm()).abs() <= half, "{:?} {:?}", a, b);
        prop_assert!((a.rotate.deg() - b.rotate.deg()).abs() <= half, "{:?} {:?}", a, b);
        prop_assert!((a.bend.deg() - b.bend.deg()).abs() <= half, "{:?} {:?}", a, b);
    }
    Ok(())
}

fn steps_of(text: &str, format: Format, convention: Convention) -> Vec<Step> {
    let options = ReadOptions { convention, ..ReadOptions::default() };
    read(text.as_bytes(), "program", Some(format), &options).unwrap().program.unwrap().program.steps
}

proptest! {
    #[test]
    fn kit_text(steps in any_steps(), convention in any_convention()) {
        let counted: Vec<Step> = steps.iter().map(|step| convention.apply(*step)).collect();
        let text = kit(&counted);
        assert_rounded(&steps_of(&text, Format::Kit, convention), &steps, 1e-3)?;
    }

    /// Whatever the case, every feed, rotation and bend of a script is there.
    #[test]
    fn pensa_scripts(steps in any_steps(), convention in any_convention(), comment: String) {
        let counted: Vec<Step> = steps.iter().map(|step| convention.apply(*step)).collect();
        let title = |word: &str| format!("{}{}", &word[..1], word[1..].to_lowercase());
        for spell in [&str::to_owned as &dyn Fn(&str) -> String, &str::to_lowercase, &title] {
            let text = script(&counted, &comment, spell);
            assert_rounded(&steps_of(&text, Format::Pensa, convention), &steps, 1e-5)?;
        }
    }

    /// Whatever its spelling and whatever its numbers count from, a table is the same wire.
    #[test]
    fn bend_tables(
        steps in any_steps(),
        style in any_style(),
        counted in any_counted(),
        convention in any_convention(),
        clr_column: bool,
        empty: Index,
    ) {
        let radius = mm(1.5);
        let turned: Vec<Step> = steps.iter().map(|step| convention.apply(*step)).collect();
        // Feeds of 0 have no room for arcs: such programs have no table of tangent lengths.
        let Some(text) = bend_table(&turned, radius.mm(), clr_column, style, counted) else { return Ok(()) };
        let text = style.with_empty_row(&text, empty);
        let options = ReadOptions { clr: Some(radius), convention, ..ReadOptions::default() };
        let back = read(text.as_bytes(), "table", Some(Format::Lra), &options).unwrap().program.unwrap();
        prop_assert_eq!(steps.len(), back.program.steps.len());
        for (a, b) in steps.iter().zip(&back.program.steps) {
            // Half a digit of the distance at either end; and on either side of the edge what half a digit of a
            // bend changes, which is at 160° 1.5·(1 + tan² 80°)/2 = 25 mm for a radian, so 2.2e-5 mm.
            prop_assert!((a.feed.mm() - b.feed.mm()).abs() < 1e-4 + 2.0 * 2.5e-5, "{}\n{:?} {:?}", text, a, b);
        }
        let ours = replay(Frame::default(), &steps);
        let reach = 200.0 * 13.0;
        // A wrong last digit of an angle moves the far end by its share of the whole length.
        let tolerance = 13.0 * (1e-4 + reach * 1e-4_f64.to_radians() * 2.0);
        prop_assert_eq!(ours.len(), back.path.len());
        for (a, b) in ours.iter().zip(&back.path) {
            prop_assert!((a - b).norm() < tolerance, "{}\n{} {}", text, a, b);
        }
    }

    #[test]
    fn point_tables(
        points in prop::collection::vec(prop::array::uniform3(-1e5..1e5_f64), 2..20),
        style in any_style(),
        empty: Index,
    ) {
        let points: Vec<Point3<f64>> = points.into_iter().map(Point3::from).collect();
        let mut text = if style.header { style.row(&["x_mm", "y_mm", "z_mm"].map(str::to_owned)) } else { String::new() };
        for point in &points {
            text.push_str(&style.row(&[point.x, point.y, point.z].map(|value| style.number(value))));
        }
        let text = style.with_empty_row(&text, empty);
        let back = read(text.as_bytes(), "points", Some(Format::Xyz), &ReadOptions::default()).unwrap().wireframe;
        prop_assert_eq!((back.vertex_count(), back.edge_count()), (points.len(), points.len() - 1));
        for ((_, vertex), point) in back.vertices().zip(&points) {
            prop_assert!((vertex.position - point).amax() <= 0.5e-4 + 1e-9);
        }
    }

    #[test]
    fn centrelines(points in prop::collection::vec(prop::array::uniform3(-1e3..1e3_f64), 2..20), sides in 3_usize..9) {
        let points: Vec<Point3<f64>> = points.into_iter().map(Point3::from).collect();
        let wire = Centreline { points: points.clone(), tightened: vec![] };
        let tube = Tube { radius: Length::from_mm(1.5).unwrap(), sides };
        let text = obj(&[wire.clone(), wire], Some(tube));
        let back = import("wire.obj", &text).unwrap();
        // The same wire twice: the weld makes one of it.
        prop_assert_eq!((back.wireframe.vertex_count(), back.wireframe.edge_count()), (points.len(), points.len() - 1));
        let tube = back.stencil.unwrap();
        prop_assert_eq!(tube.faces().len(), 2 * ((points.len() - 1) * sides + 2));
        for (k, corner) in tube.vertices().iter().skip(points.len()).take(points.len() * sides).enumerate() {
            let off = (corner - points[k / sides]).norm();
            prop_assert!((off - 1.5).abs() < 1e-3, "a corner of the tube is {} mm from the centreline", off);
        }
    }
}
