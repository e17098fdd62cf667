//! Lines and curves of a drawing, joined where one goes on from another, with curves cut to what can be made.
//!
//! Drawings have arcs and lines as elements of their own that only touch. What is seen as one curve is cut as one, however
//! many elements it is drawn of.

use std::collections::HashMap;
use std::ops::Range;

use nalgebra::{Point3, Vector3};
use wirebend_core::curve::{CurveEnds, EdgeLimit, cut_curve, distance_to_segment};
use wirebend_core::units::Length;
use wirebend_core::wireframe::Welder;

use super::curves::{CurveFacts, CurveRadius};
use super::error::Location;

/// A turn of more degrees than this is a corner of the drawing, less is the rounding of a file: programs write tangents
/// with three or four digits.
const CORNER_DEG: f64 = 3.0;

/// A line or a curve.
#[derive(Debug, Clone)]
pub(super) struct Part {
    pub(super) place: Location,
    /// Close points; the two ends of a line.
    pub(super) dense: Vec<Point3<f64>>,
    /// Points of which the straight edges are within the tolerance; likewise.
    pub(super) plain: Vec<Point3<f64>>,
    /// The way at both ends, as it is run through.
    pub(super) ways: [Vector3<f64>; 2],
    /// The tightest place of a curve; none of a line.
    pub(super) radius: Option<CurveRadius>,
}

impl Part {
    pub(super) fn line(place: Location, from: Point3<f64>, to: Point3<f64>) -> Self {
        let points = vec![from, to];
        Self { place, dense: points.clone(), plain: points, ways: [to - from; 2], radius: None }
    }

    fn end(&self, side: usize) -> Point3<f64> {
        if side == 0 { self.dense[0] } else { self.dense[self.dense.len() - 1] }
    }

    fn reverse(&mut self) {
        self.dense.reverse();
        self.plain.reverse();
        self.ways = [-self.ways[1], -self.ways[0]];
    }

    pub(super) fn length(&self) -> f64 {
        self.dense.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum()
    }

    fn is_curve(&self) -> bool {
        self.radius.is_some()
    }
}

/// A row of vertices with edges between them.
#[derive(Debug)]
pub(super) struct Row {
    pub(super) vertices: Vec<(Location, Point3<f64>)>,
    pub(super) closed: bool,
}

impl Row {
    /// Whether it goes from one vertex to another and straight back.
    fn is_folded(&self, weld: Length) -> bool {
        let [(_, first), .., (_, last)] = &self.vertices[..] else { return true };
        let again = !self.closed && (last - first).norm() <= weld.mm();
        self.vertices.len() - usize::from(again) < 3
    }
}

/// A row, with what was made of its curves.
struct CutRow {
    row: Row,
    facts: CurveFacts,
    /// The parts of the longest curve, which can be cut to more edges.
    longest: Option<Range<usize>>,
}

/// How many edges a curve must have, by its first part.
type MinEdges = Option<(usize, usize)>;

/// How curves are cut, all in the numbers of the parts.
pub(super) struct Cutter {
    pub(super) tolerance: Length,
    pub(super) limit: EdgeLimit,
    /// Ends that are closer are joined.
    pub(super) weld: Length,
    pub(super) facts: CurveFacts,
}

impl Cutter {
    /// The rows of all parts, in the order of the first part of each.
    pub(super) fn rows(&mut self, parts: Vec<Part>) -> Vec<Row> {
        for part in &parts {
            self.facts.radii.extend(part.radius);
        }
        let mut chains = chains(parts, self.weld);
        let mut rows: Vec<CutRow> = chains.iter_mut().map(|chain| self.row(chain, None)).collect();
        self.unfold(&mut chains, &mut rows);
        let mut made = Vec::with_capacity(rows.len());
        for CutRow { row, facts, .. } in rows {
            self.facts.add(facts);
            made.push(row);
        }
        made
    }

    /// Cuts curves again, to more edges, where an edge lies on another one and would be lost.
    fn unfold(&self, chains: &mut [Chain], rows: &mut [CutRow]) {
        // What a single edge stands for, by its ends.
        let mut single: HashMap<[u32; 2], Vec<Vec<Point3<f64>>>> = HashMap::new();
        // Lines first: they cannot be cut.
        for is_curve in [false, true] {
            for (chain, row) in chains.iter_mut().zip(&mut *rows) {
                if row.longest.is_some() != is_curve {
                    continue;
                }
                let (run, other) = if chain.returns() {
                    let Some(run) = row.longest.clone().filter(|_| row.row.is_folded(self.weld)) else {
                        continue;
                    };
                    let other = joined(&chain.parts[run.end..], |part| &part.dense);
                    let before = joined(&chain.parts[..run.start], |part| &part.dense);
                    (run, vec![other, before])
                } else if row.row.vertices.len() == 2 {
                    let [a, b] = chain.ends;
                    let known = single.entry([a.min(b), a.max(b)]).or_default();
                    let other = known.clone();
                    known.push(joined(&chain.parts, |part| &part.dense));
                    let Some(run) = row.longest.clone().filter(|_| !other.is_empty()) else { continue };
                    (run, other)
                } else {
                    continue;
                };
                let curve = joined(&chain.parts[run.clone()], |part| &part.dense);
                // What is drawn twice is one edge.
                if !other.iter().any(|other| lies_on(&curve, other, self.tolerance)) {
                    *row = self.row(chain, Some((run.start, 2)));
                }
            }
        }
    }

    fn row(&self, chain: &mut Chain, min_edges: MinEdges) -> CutRow {
        let Chain { parts, closed, .. } = chain;
        let closed = *closed;
        let mut smooth = joints(parts, closed);
        let mut keeps = self.kept(parts, &smooth, closed);
        let mut facts = CurveFacts::default();
        if closed {
            // It begins with a line that stays, else at a corner.
            let count = parts.len();
            let corner = |k: &usize| !smooth[(k + count - 1) % count];
            let first = (0..count).find(|&k| keeps[k]).or_else(|| (0..count).find(corner));
            let Some(first) = first else {
                let row = self.ring(parts, min_edges, &mut facts);
                return CutRow { row, facts, longest: Some(0..parts.len()) };
            };
            parts.rotate_left(first);
            smooth.rotate_left(first);
            keeps.rotate_left(first);
        }
        let mut vertices: Vec<(Location, Point3<f64>)> = Vec::new();
        let (mut at, mut ends_in_run) = (0, false);
        let mut longest: Option<(f64, Range<usize>)> = None;
        while at < parts.len() {
            let next = if keeps[at] { at + 1 } else { run_end(&keeps, &smooth, at) };
            ends_in_run = !keeps[at];
            let place = &parts[at].place;
            if keeps[at] {
                if vertices.is_empty() {
                    vertices.push((place.clone(), parts[at].end(0)));
                }
                vertices.push((place.clone(), parts[at].end(1)));
            } else {
                let line = |k: Option<usize>, joint: bool, side: usize| {
                    k.filter(|&k| joint && keeps[k]).map(|k| parts[k].ways[side])
                };
                let last = parts.len() - 1;
                let before = at.checked_sub(1).or(closed.then_some(last));
                let behind = if next <= last { Some(next) } else { closed.then_some(0) };
                let lines =
                    [line(before, before.is_some_and(|k| smooth[k]), 1), line(behind, smooth[next - 1], 0)];
                let run = &parts[at..next];
                let length: f64 = run.iter().map(Part::length).sum();
                if run.iter().any(Part::is_curve)
                    && longest.as_ref().is_none_or(|(longest, _)| length > *longest)
                {
                    longest = Some((length, at..next));
                }
                let least = min_edges.filter(|&(first, _)| first == at).map_or(0, |(_, least)| least);
                let run = self.run(run, CurveEnds::Open(lines), least, &mut facts);
                vertices.pop();
                vertices.extend(run.into_iter().map(|point| (place.clone(), point)));
            }
            at = next;
        }
        if closed && vertices.len() > 1 {
            // The last vertex is the first once more; where a curve ends, it says where that is.
            let last = vertices.pop();
            if let (true, Some(last)) = (ends_in_run, last) {
                vertices[0] = last;
            }
        }
        CutRow { row: Row { vertices, closed }, facts, longest: longest.map(|(_, parts)| parts) }
    }

    fn ring(&self, parts: &[Part], min_edges: MinEdges, facts: &mut CurveFacts) -> Row {
        let place = &parts[0].place;
        let mut points = self.run(parts, CurveEnds::Ring, min_edges.map_or(0, |_| 3), facts);
        points.dedup();
        Row { vertices: points.into_iter().map(|point| (place.clone(), point)).collect(), closed: true }
    }

    /// The lines that stay as they are drawn: those that are long enough, and those between corners.
    fn kept(&self, parts: &[Part], smooth: &[bool], closed: bool) -> Vec<bool> {
        let count = parts.len();
        let joined = |k: usize| smooth[k] || if k > 0 { smooth[k - 1] } else { closed && smooth[count - 1] };
        let stays = |k: usize| {
            let part = &parts[k];
            !part.is_curve() && (part.length() >= self.limit.shortest.mm() || !joined(k))
        };
        (0..count).map(stays).collect()
    }

    /// Curves that go on from each other, and short lines between them, as corners; a ring without its first once more.
    fn run(
        &self,
        parts: &[Part],
        ends: CurveEnds,
        min_edges: usize,
        facts: &mut CurveFacts,
    ) -> Vec<Point3<f64>> {
        let plain = joined(parts, |part| &part.plain);
        let curves = parts.iter().filter(|part| part.is_curve()).count();
        let is_ring = ends == CurveEnds::Ring;
        let fits =
            || plain.len() > min_edges && self.limit.lacking(&plain, ends).iter().all(|&lack| lack <= 0.0);
        if curves == 0 || fits() {
            for part in parts {
                let (off, at) = off_plain(part);
                facts.far(off, at);
            }
            let count = plain.len() - usize::from(is_ring);
            return plain.into_iter().take(count).collect();
        }
        let dense = joined(parts, |part| &part.dense);
        let cut = cut_curve(&dense, ends, self.tolerance, &self.limit, min_edges);
        facts.far(cut.deviation.mm(), cut.at);
        facts.too_short += cut.too_short;
        if cut.deviation > self.tolerance {
            facts.coarser += curves;
        }
        cut.points
    }
}

/// Where the run that begins at a part ends: behind its last part.
fn run_end(keeps: &[bool], smooth: &[bool], from: usize) -> usize {
    let mut next = from + 1;
    while next < keeps.len() && !keeps[next] && smooth[next - 1] {
        next += 1;
    }
    next
}

/// The points of parts one after another, each joint once.
fn joined(parts: &[Part], of: impl Fn(&Part) -> &Vec<Point3<f64>>) -> Vec<Point3<f64>> {
    let mut points: Vec<Point3<f64>> = Vec::new();
    for part in parts {
        points.extend(of(part).iter().skip(usize::from(!points.is_empty())));
    }
    points
}

/// How far the plain edges of a part are from it at most, and where: both are run through side by side.
fn off_plain(part: &Part) -> (f64, Point3<f64>) {
    let (mut edge, mut farthest) = (0, (0.0, part.dense[0]));
    let off = |point: &Point3<f64>, k: usize| distance_to_segment(point, &part.plain[k], &part.plain[k + 1]);
    for point in &part.dense {
        while edge + 2 < part.plain.len() && off(point, edge + 1) <= off(point, edge) {
            edge += 1;
        }
        let distance = off(point, edge);
        if distance > farthest.0 {
            farthest = (distance, *point);
        }
    }
    farthest
}

/// Whether places all along a curve are near another one.
fn lies_on(curve: &[Point3<f64>], other: &[Point3<f64>], tolerance: Length) -> bool {
    let near = |point: &Point3<f64>| {
        other.windows(2).any(|pair| distance_to_segment(point, &pair[0], &pair[1]) <= tolerance.mm())
    };
    curve.iter().step_by((curve.len() / 16).max(1)).all(near)
}

/// Parts that go on from each other.
struct Chain {
    parts: Vec<Part>,
    /// Whether the last goes on in the first.
    closed: bool,
    /// Where it begins and ends.
    ends: [u32; 2],
}

impl Chain {
    fn returns(&self) -> bool {
        self.ends[0] == self.ends[1]
    }
}

/// Joins parts wherever the ends of just two of them meet.
fn chains(parts: Vec<Part>, weld: Length) -> Vec<Chain> {
    let mut welder = Welder::new(weld);
    let mut nodes: Vec<[u32; 2]> = Vec::with_capacity(parts.len());
    let mut at: HashMap<u32, Vec<usize>> = HashMap::new();
    for (k, part) in parts.iter().enumerate() {
        let ends = [0, 1].map(|side| {
            let own = u32::try_from(2 * k + side).unwrap_or(u32::MAX);
            let node = welder.put(own, part.end(side));
            at.entry(node).or_default().push(k);
            node
        });
        nodes.push(ends);
    }
    let passes = |node: u32| at.get(&node).is_some_and(|parts| parts.len() == 2);
    let mut parts: Vec<Option<Part>> = parts.into_iter().map(Some).collect();
    let mut chains = Vec::new();
    // First those with ends, then what is left, which are rings.
    for ring in [false, true] {
        for first in 0..parts.len() {
            let Some(side) = [0, 1].into_iter().find(|&side| ring || !passes(nodes[first][side])) else {
                continue;
            };
            let (mut chain, mut k, mut side) = (Vec::new(), first, side);
            let mut ends = [nodes[first][side]; 2];
            while let Some(mut part) = parts[k].take() {
                if side == 1 {
                    part.reverse();
                }
                chain.push(part);
                let node = nodes[k][1 - side];
                ends[1] = node;
                // Where many meet, none of them has to be looked at.
                let next =
                    if passes(node) { at[&node].iter().copied().find(|&other| other != k) } else { None };
                let Some(next) = next else { break };
                side = usize::from(nodes[next][0] != node);
                k = next;
            }
            if !chain.is_empty() {
                chains.push((first, Chain { parts: chain, closed: ring, ends }));
            }
        }
    }
    chains.sort_by_key(|(first, _)| *first);
    chains.into_iter().map(|(_, chain)| chain).collect()
}

/// Of each part whether it goes on in the next without a corner; of the last whether in the first.
fn joints(parts: &[Part], closed: bool) -> Vec<bool> {
    let straight = |one: Vector3<f64>, other: Vector3<f64>| {
        one.norm() > 0.0 && other.norm() > 0.0 && one.angle(&other).to_degrees() <= CORNER_DEG
    };
    let of = |k: usize| match parts.get(k + 1) {
        Some(next) => straight(parts[k].ways[1], next.ways[0]),
        None => closed && straight(parts[k].ways[1], parts[0].ways[0]),
    };
    (0..parts.len()).map(of).collect()
}
