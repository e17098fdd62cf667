//! What is written is read back as it was, within the rounding of its format.

use nalgebra::Point3;
use proptest::prelude::*;
use wirebend_core::bend::{Convention, Frame, Sign, Step, replay};
use wirebend_core::units::Length;
use wirebend_core::wireframe::Wireframe;
use wirebend_files::read::{Format, ReadOptions, read};
use wirebend_files::write::{
    Case, Centreline, DecimalMark, KitLayout, LraLayout, PensaLayout, Separator, TableStyle, Tube, kit, lra,
    obj, pensa, xyz,
};

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

fn any_style() -> impl Strategy<Value = TableStyle> {
    let separator = prop_oneof![Just(Separator::Comma), Just(Separator::Semicolon), Just(Separator::Tab)];
    let decimal = prop_oneof![Just(DecimalMark::Point), Just(DecimalMark::Comma)];
    (separator, decimal, any::<bool>()).prop_map(|(separator, decimal, header)| TableStyle {
        separator,
        decimal,
        header,
        decimals: 4,
    })
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
        let layout = KitLayout { design_hash: Some("ab12".into()), convention, ..KitLayout::default() };
        let text = kit(&steps, &layout);
        prop_assert!(!text.contains("-0.000\n"));
        assert_rounded(&steps_of(&text, Format::Kit, convention), &steps, 1e-3)?;
    }

    #[test]
    fn pensa_scripts(steps in any_steps(), convention in any_convention(), comment: String) {
        for case in [Case::Upper, Case::Lower, Case::Title] {
            let layout = PensaLayout { case, convention, comments: vec![comment.clone()], ..PensaLayout::default() };
            let text = pensa(&steps, &layout);
            prop_assert!(!text.contains("-0.00000\n"));
            assert_rounded(&steps_of(&text, Format::Pensa, convention), &steps, 1e-5)?;
        }
    }

    #[test]
    fn lra_tables(steps in any_steps(), style in any_style(), clr_column: bool) {
        let radius = Length::from_mm(1.5).unwrap();
        let layout = LraLayout { table: style, clr_column, ..LraLayout::lra(radius) };
        // Feeds of 0 have no room for arcs: such programs have no table of tangent lengths.
        let Ok(text) = lra(&steps, &layout) else { return Ok(()) };
        let options = ReadOptions { clr: Some(radius), ..ReadOptions::default() };
        let back = read(text.as_bytes(), "table", Some(Format::Lra), &options).unwrap().program.unwrap();
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
    fn point_tables(points in prop::collection::vec(prop::array::uniform3(-1e5..1e5_f64), 2..20), style in any_style()) {
        let points: Vec<Point3<f64>> = points.into_iter().map(Point3::from).collect();
        let text = xyz(&points, &style);
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

#[test]
fn programs_are_written_as_their_machines_read_them() {
    let steps = [
        step(59.708_706, 0.0, -0.000_001),
        step(30.0, -133.786_218, -46.456_66),
        step(0.0, 0.0, 10.0),
        step(5.0, 0.0, 0.0),
    ];
    expect_test::expect![[r"
        # design ab12
        F 59.709
        F 30.000
        R -133.786
        B -46.457
        F 0.000
        B 10.000
        F 5.000
    "]]
    .assert_eq(&kit(&steps, &KitLayout { design_hash: Some("ab12".into()), ..KitLayout::default() }));
    let comments = vec!["truss (second)".to_owned()];
    expect_test::expect![[r"
        (truss [second])
        FEED 59.70871
        FEED 30.00000
        ROTATE -133.78622
        BEND -46.45666
        FEED 0.00000
        BEND 10.00000
        FEED 5.00000
    "]]
    .assert_eq(&pensa(&steps, &PensaLayout { comments, ..PensaLayout::default() }));
    expect_test::expect![[r"
        10,000;0,000;90,000;2,000
        20,000;180,000;45,000;2,000
        30,000;;;
    "]]
    .assert_eq(&semicolons());
}

/// Lengths between tangents of 10, 20 and 30 mm: each bend of radius 2 takes r·tan(θ/2) on both sides.
fn semicolons() -> String {
    let half = 2.0 * 22.5_f64.to_radians().tan();
    let steps = [step(12.0, 0.0, 90.0), step(22.0 + half, 0.0, -45.0), step(30.0 + half, 0.0, 0.0)];
    let table = TableStyle { header: false, ..TableStyle::decimal_comma() };
    lra(&steps, &LraLayout { table, ..LraLayout::lra(mm(2.0)) }).unwrap()
}

#[test]
fn the_tube_is_closed() {
    let path = [[0., 0., 0.], [50., 0., 0.], [50., 40., 0.], [50., 40., 30.]].map(Point3::from);
    let wire = wirebend_files::write::centreline(&path, mm(5.0), mm(0.05));
    let text = obj(&[wire], Some(Tube { radius: mm(1.5), sides: 8 }));
    let tube = import("wire.obj", &text).unwrap().stencil.unwrap();
    // Euler's formula for a sphere, over the vertices that faces use.
    let used: std::collections::BTreeSet<u32> = tube.faces().iter().flatten().copied().collect();
    assert_eq!(used.len() + tube.faces().len(), tube.face_edges().len() + 2);
    // The volume is that of the wire, and positive: the faces look outwards.
    let volume: f64 = tube
        .faces()
        .iter()
        .flat_map(|face| (1..face.len() - 1).map(move |k| [face[0], face[k], face[k + 1]]))
        .map(|ids| ids.map(|id| tube.vertices()[id as usize].coords))
        .map(|[a, b, c]| a.dot(&b.cross(&c)) / 6.0)
        .sum();
    let octagon = 2.0 * 2.0_f64.sqrt() * 1.5 * 1.5;
    let length = 120.0 - 4.0 * 5.0 + 2.0 * 5.0 * std::f64::consts::FRAC_PI_2;
    assert!((volume / (octagon * length) - 1.0).abs() < 0.01, "{volume}");
}

#[test]
fn an_empty_wire_is_no_wire() {
    assert_eq!(obj(&[Centreline::default()], None), "# bent wire, mm\n");
    assert_eq!(kit(&[], &KitLayout::default()), "");
    assert_eq!(Wireframe::new().vertex_count(), 0);
}
