//! Labels that can be read: none on the wire, none on another, and none lost without a word.

use nalgebra::Point3;
use proptest::prelude::*;
use wirebend_core::units::DisplayUnit;

use super::board::{grown, overlap};
use super::*;
use crate::write::drawing::crosses;

const STYLE: Style = Style { size: 2.5, half: 0.6, room: None, unit: DisplayUnit::Millimetre };

/// A drawing of a path whose points are on the page already, with every corner as a bend and every edge with its length.
fn drawn(path: &[Point], style: Style) -> (Vec<[Point; 2]>, Labels, [usize; 2]) {
    let in_space: Vec<Point3<f64>> = path.iter().map(|[x, y]| Point3::new(*x, *y, 0.0)).collect();
    let steps: Vec<LabelStep> = in_space
        .windows(2)
        .enumerate()
        .map(|(k, pair)| LabelStep {
            feed_mm: (pair[1] - pair[0]).norm(),
            bend_deg: if k + 2 < path.len() { 45.0 } else { 0.0 },
        })
        .collect();
    let Spots { bends, edges } = spots(&in_space, &steps);
    let flat = |point: Point3<f64>| [point.x, point.y];
    let bends: Vec<BendAt> = bends
        .iter()
        .map(|bend| BendAt {
            number: bend.number,
            at: flat(bend.at),
            sides: bend.sides.map(|side| [side.x, side.y]),
            angle_deg: bend.angle_deg,
        })
        .collect();
    let edges: Vec<EdgeAt> =
        edges.iter().map(|edge| EdgeAt { ends: edge.ends.map(flat), length_mm: edge.length_mm }).collect();
    let lines: Vec<[Point; 2]> = path.windows(2).map(|pair| [pair[0], pair[1]]).collect();
    let words = [WordAt { word: "start".into(), at: path[0], away: [-1.0, 0.0] }];
    let found = labels(&lines, &words, &bends, &edges, style);
    (lines, found, [bends.len(), edges.len()])
}

fn texts(labels: &Labels) -> Vec<&str> {
    let shapes = labels.shapes.iter();
    shapes
        .filter_map(|shape| if let Shape::Text { text, .. } = shape { Some(text.as_str()) } else { None })
        .collect()
}

/// Two sides of 60 and 40 mm: nothing is in the way, so nothing needs a leader, and the number is outside of the corner.
#[test]
fn a_simple_corner_has_all_its_labels_near() {
    let (_, found, _) = drawn(&[[0.0, 0.0], [60.0, 0.0], [60.0, 40.0]], STYLE);
    assert_eq!(texts(&found), ["start", "1", "45.0°", "60.0", "40.0"]);
    assert_eq!(found.without_length, 0);
    assert!(!found.shapes.iter().any(|shape| matches!(shape, Shape::Line(_))), "no leaders");
    let Some(Shape::Circle { centre, .. }) = found.shapes.iter().find(|s| matches!(s, Shape::Circle { .. }))
    else {
        panic!("no circle")
    };
    assert!(centre[0] > 60.0 && centre[1] < 0.0, "{centre:?}");
    let inches = Style { unit: DisplayUnit::Inch, ..STYLE };
    let (_, found, _) = drawn(&[[0.0, 0.0], [63.5, 0.0], [63.5, 40.0]], inches);
    assert!(texts(&found).contains(&"2.500"));
}

/// A comb with teeth of 3 mm: a length does not fit between them, and what does not fit is counted.
#[test]
fn what_has_no_room_is_counted() {
    let comb: Vec<Point> = (0..120_u32)
        .map(|k| [f64::from(k / 2) * 3.0, if k % 4 == 1 || k % 4 == 2 { 40.0 } else { 0.0 }])
        .collect();
    let room = Some([-5.0, -5.0, 185.0, 45.0]);
    let (_, found, [bends, edges]) = drawn(&comb, Style { room, ..STYLE });
    let lengths = edges - found.without_length;
    let words = texts(&found);
    assert!(found.without_length > 0 && found.with_angle.len() < bends);
    assert_eq!(words.iter().filter(|text| text.ends_with('°')).count(), found.with_angle.len());
    let numbers = found.numbered.len() + found.with_angle.len() + lengths + 1;
    assert_eq!(words.len(), numbers);
    assert_eq!(left_out(0, 3, 1).unwrap(), "3 angles and 1 length");
    assert_eq!(left_out(1, 2, 3).unwrap(), "1 number, 2 angles and 3 lengths");
    assert_eq!(left_out(0, 0, 0), None);
}

/// By hand: 10 mm and 20 mm along x are one feed, then 5 mm along y, and back the same way.
#[test]
fn steps_are_found_along_the_path() {
    let path = [[0., 0.], [10., 0.], [30., 0.], [30., 5.], [30., 0.]].map(|[x, y]| Point3::new(x, y, 0.0));
    let step = |feed_mm, bend_deg| LabelStep { feed_mm, bend_deg };
    let found = spots(&path, &[step(30.0, 90.0), step(5.0, 180.0), step(5.0, 0.0)]);
    assert_eq!(
        found.bends.iter().map(|bend| (bend.number, bend.at)).collect::<Vec<_>>(),
        [(1, path[2]), (2, path[3])]
    );
    // Laid twice, an edge has one length.
    assert_eq!(found.edges.iter().map(|edge| edge.length_mm).collect::<Vec<_>>(), [30.0, 5.0]);
    assert_eq!(spots(&[], &[step(1.0, 1.0)]), Spots::default());
    let nowhere = [Point3::new(f64::NAN, 0.0, 0.0)];
    assert_eq!(spots(&nowhere, &[step(1.0, 1.0)]), Spots::default());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    /// Whatever the wire: no label is on it, none is on another, no leader runs through a label, and all stay within their room.
    #[test]
    fn labels_cover_nothing(
        points in prop::collection::vec(prop::array::uniform2(-80.0..80.0_f64), 2..24),
        bounded in any::<bool>(),
    ) {
        let room = bounded.then_some([-90.0, -90.0, 90.0, 90.0]);
        let (lines, found, [bends, edges]) = drawn(&points, Style { room, ..STYLE });
        for (k, &frame) in found.frames.iter().enumerate() {
            for line in &lines {
                prop_assert!(!crosses(line[0], line[1], grown(frame, STYLE.half)), "{frame:?} on {line:?}");
            }
            for &other in &found.frames[..k] {
                prop_assert!(!overlap(frame, other), "{frame:?} on {other:?}");
            }
            for shape in &found.shapes {
                if let Shape::Line([a, b]) = shape {
                    prop_assert!(!crosses(*a, *b, frame), "a leader through {frame:?}");
                }
            }
            if let Some(room) = room {
                prop_assert!(frame[0] >= room[0] && frame[1] >= room[1] && frame[2] <= room[2] && frame[3] <= room[3]);
            }
        }
        // What is written is in its frame, and each label is there or counted.
        for shape in &found.shapes {
            let [left, _, right, _] = shape.bounds();
            let middle = f64::midpoint(left, right);
            let inside = |frame: &Bounds| middle >= frame[0] - 1e-9 && middle <= frame[2] + 1e-9;
            prop_assert!(matches!(shape, Shape::Line(_)) || found.frames.iter().any(inside));
        }
        prop_assert!(found.with_angle.is_subset(&found.numbered) && found.numbered.len() <= bends);
        let lengths = found.frames.len() - found.numbered.len();
        prop_assert!(lengths + found.without_length >= edges);
    }

    /// On paper without an end every bend has its number, its angle and every edge its length, however the wire runs.
    #[test]
    fn an_open_spiral_has_every_label(turns in 3..14_u32, grows in 9.0..14.0_f64) {
        let points: Vec<Point> = (0..turns * 4)
            .map(|k| {
                let (sin, cos) = (f64::from(k) * TAU / 4.0 + 0.3).sin_cos();
                let radius = 20.0 + grows * f64::from(k) / 4.0 * 2.0;
                [radius * cos, radius * sin]
            })
            .collect();
        let (_, found, [bends, _]) = drawn(&points, STYLE);
        prop_assert_eq!(found.numbered.len(), bends);
        prop_assert_eq!(found.with_angle.len(), bends);
        prop_assert_eq!(found.without_length, 0);
    }
}
