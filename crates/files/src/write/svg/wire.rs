//! The strokes: near ones darker and wider, each with a halo that cuts what lies behind it.

use super::element::{AMBER, BLUE, GREEN, INK, PAPER, Page, Type, px};
use super::view::{Projection, is_finite};
use super::{Picture, PictureWire};

struct Stroke {
    from: [f64; 2],
    to: [f64; 2],
    nearness: f64,
    doubled: bool,
}

pub(super) fn draw(page: &mut Page, picture: &Picture, projection: &Projection) {
    let mut strokes: Vec<Stroke> = picture.wires.iter().flat_map(|wire| strokes(wire, projection)).collect();
    strokes.sort_by(|a, b| a.nearness.total_cmp(&b.nearness));
    // Many struts need thin lines, few look lost with them.
    let count = u32::try_from(strokes.len().max(1)).unwrap_or(u32::MAX);
    let weight = (60.0 / f64::from(count)).sqrt().clamp(0.6, 1.25);
    for stroke in &strokes {
        let width = (1.2 + 1.4 * stroke.nearness) * weight;
        halo(page, stroke, width + 3.6);
        if stroke.doubled {
            let aside = offset(stroke, width * 0.5 + 0.8);
            let attributes = format!("stroke-width=\"{}\" stroke-linecap=\"round\"", px(width * 0.7));
            for [x, y] in [aside, aside.map(|c| -c)] {
                let moved = |p: [f64; 2]| [p[0] + x, p[1] + y];
                page.line(moved(stroke.from), moved(stroke.to), BLUE, &attributes);
            }
        } else {
            let attributes = format!("stroke-width=\"{}\" stroke-linecap=\"round\"", px(width));
            page.line(stroke.from, stroke.to, &shade(stroke.nearness), &attributes);
        }
    }
    for wire in &picture.wires {
        bends(page, wire, projection, weight);
    }
    for (k, wire) in picture.wires.iter().enumerate() {
        let label = if picture.wires.len() > 1 { format!("start {}", k + 1) } else { "start".to_owned() };
        ends(page, wire, projection, &label);
    }
}

/// Wires as they were bent: thin amber lines that add up where they agree.
pub(super) fn trials(page: &mut Page, picture: &Picture, projection: &Projection) {
    for points in &picture.trials {
        for pair in points.windows(2).filter(|pair| pair.iter().all(is_finite)) {
            let attributes = "stroke-width=\"0.8\" stroke-opacity=\"0.35\" stroke-linecap=\"round\"";
            page.line(projection.at(pair[0]), projection.at(pair[1]), AMBER, attributes);
        }
    }
}

fn strokes<'a>(wire: &'a PictureWire, projection: &'a Projection) -> impl Iterator<Item = Stroke> + 'a {
    let mut doubled = vec![false; wire.points.len()];
    for &k in &wire.doubled {
        if let Some(entry) = doubled.get_mut(k) {
            *entry = true;
        }
    }
    let pairs = wire.points.windows(2).enumerate();
    pairs.filter(|(_, pair)| pair.iter().all(is_finite)).map(move |(k, pair)| Stroke {
        from: projection.at(pair[0]),
        to: projection.at(pair[1]),
        nearness: f64::midpoint(projection.nearness(pair[0]), projection.nearness(pair[1])),
        doubled: doubled[k],
    })
}

/// From grey far away to ink in front.
fn shade(nearness: f64) -> String {
    let mix = |far: f64, near: f64| {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // between the two colours
        let value = (far + (near - far) * nearness.clamp(0.0, 1.0)).round() as u8;
        value
    };
    format!("#{:02x}{:02x}{:02x}", mix(156.0, 24.0), mix(167.0, 33.0), mix(178.0, 43.0))
}

fn direction(stroke: &Stroke) -> ([f64; 2], f64) {
    let (x, y) = (stroke.to[0] - stroke.from[0], stroke.to[1] - stroke.from[1]);
    let length = x.hypot(y);
    if length > 0.0 { ([x / length, y / length], length) } else { ([0.0; 2], 0.0) }
}

fn offset(stroke: &Stroke, by: f64) -> [f64; 2] {
    let ([x, y], _) = direction(stroke);
    [-y * by, x * by]
}

/// A band of paper around a stroke, except near its ends, where it would cut what it is joined to.
fn halo(page: &mut Page, stroke: &Stroke, width: f64) {
    let ([x, y], length) = direction(stroke);
    let spared = 9.0;
    if length > 3.0 * spared {
        let from = [stroke.from[0] + x * spared, stroke.from[1] + y * spared];
        let to = [stroke.to[0] - x * spared, stroke.to[1] - y * spared];
        page.line(from, to, PAPER, &format!("stroke-width=\"{}\"", px(width)));
    }
}

/// A dot at every vertex where the direction changes.
fn bends(page: &mut Page, wire: &PictureWire, projection: &Projection, weight: f64) {
    for corner in wire.points.windows(3).filter(|corner| corner.iter().all(is_finite)) {
        let (before, after) = (corner[1] - corner[0], corner[2] - corner[1]);
        let straight =
            before.cross(&after).norm() <= 1e-9 * before.norm() * after.norm() && before.dot(&after) >= 0.0;
        if !straight {
            let radius = 2.6 * weight;
            page.circle(
                projection.at(corner[1]),
                radius,
                &format!("fill=\"{PAPER}\" stroke=\"{INK}\" stroke-width=\"1.1\""),
            );
        }
    }
}

/// A green arrow head at the start, along the wire, and a square at the end.
fn ends(page: &mut Page, wire: &PictureWire, projection: &Projection, label: &str) {
    let places = || wire.points.iter().filter(|p| is_finite(p)).map(|&p| projection.at(p));
    let (Some(first), Some(last)) = (places().next(), places().next_back()) else {
        return;
    };
    let apart = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    let attributes = format!(
        "x=\"{}\" y=\"{}\" width=\"7\" height=\"7\" fill=\"{PAPER}\" stroke=\"{GREEN}\" stroke-width=\"1.6\"",
        px(last[0] - 3.5),
        px(last[1] - 3.5)
    );
    page.element("rect", &attributes);
    page.circle(first, 6.5, &format!("fill=\"{PAPER}\" stroke=\"{GREEN}\" stroke-width=\"1.6\""));
    let away = places().find(|p| apart(*p, first) > 1.0).unwrap_or([first[0] + 1.0, first[1]]);
    let ([x, y], _) = direction(&Stroke { from: first, to: away, nearness: 1.0, doubled: false });
    let head = [[5.4, 0.0], [-3.8, 3.3], [-1.8, 0.0], [-3.8, -3.3]];
    let head = head.map(|[a, b]| [first[0] + x * a - y * b, first[1] + y * a + x * b]);
    page.polygon(&head, &format!("fill=\"{GREEN}\""));
    // The label stands on the side that the wire does not leave to.
    tag(page, first, label, x > 0.0);
    if apart(first, last) > 40.0 {
        let before = places().rev().find(|p| apart(*p, last) > 1.0).unwrap_or(last);
        tag(page, last, &label.replacen("start", "end", 1), before[0] > last[0]);
    }
}

/// A word beside a place, on the left where asked for and where there is room.
fn tag(page: &mut Page, at: [f64; 2], label: &str, left: bool) {
    let kind = Type::new(12.0, GREEN).bold();
    let room = kind.width(label) + 16.0;
    let left = (left && at[0] > room) || at[0] + room > page.width;
    let (shift, anchor) = if left { (-11.0, "end") } else { (11.0, "start") };
    page.text([at[0] + shift, at[1] + 4.0], label, kind.anchor(anchor), true);
}
