//! How far a wire that hangs misses itself where it is joined.

use std::collections::BTreeMap;

use super::zone::Passage;
use crate::bend::{Frame, Step};
use crate::estimate::WireModel;
use crate::motion::poses;
use crate::sag::{HangingWire, down};
use crate::units::Length;
use crate::wireframe::VertexId;

/// How far the part is off where the wire comes to a vertex that it has passed before, and is joined to itself there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointSag {
    /// Index of the step, from 0, whose feed brings it there.
    pub step: usize,
    /// The vertex.
    pub vertex: VertexId,
    /// How far apart the two places of the wire are, that should be one.
    pub off: Length,
}

/// Where the wire that comes back to a vertex misses its earlier place there the most, for steps that begin at `start`. `passages`: the
/// edges of each step with their lengths. None where it never comes back to one.
#[must_use]
pub fn max_joint_sag(
    (start, steps): (Frame, &[Step]),
    passages: &[Vec<(Passage, Length)>],
    wire: &WireModel,
) -> Option<JointSag> {
    let mut frame = start;
    let mut points = vec![frame.position];
    // For each point after the first its step, and the vertex there.
    let mut places: Vec<(usize, Option<VertexId>)> = Vec::new();
    let begins = passages.first().and_then(|first| first.first()).map(|(passage, _)| passage.from);
    for (step, made) in steps.iter().enumerate() {
        let of_step = passages.get(step).map(Vec::as_slice).unwrap_or_default();
        let whole: f64 = of_step.iter().map(|(_, length)| length.mm()).sum();
        let scale = if whole > 0.0 { made.feed.mm() / whole } else { 0.0 };
        for (passage, length) in of_step {
            frame.feed(Length::computed(length.mm() * scale));
            points.push(frame.position);
            places.push((step, Some(passage.to)));
        }
        if of_step.is_empty() {
            frame.feed(made.feed);
            points.push(frame.position);
            places.push((step, None));
        }
        frame.rotate(made.rotate);
        frame.bend(made.bend);
    }
    let hanging = HangingWire::new(points, wire)?;
    let poses = poses(start, steps);
    let mut passed: BTreeMap<VertexId, Vec<usize>> =
        begins.map(|vertex| (vertex, vec![0])).into_iter().collect();
    let mut largest: Option<JointSag> = None;
    for (index, &(step, vertex)) in places.iter().enumerate() {
        let (Some(vertex), Some(pose)) = (vertex, poses.get(step)) else { continue };
        let (held, down) = (hanging.held_at(index + 1), down(&pose.turn));
        let before = passed.entry(vertex).or_default();
        for &earlier in before.iter() {
            let off = Length::computed(hanging.displacement(earlier, &held, &down).norm());
            if largest.is_none_or(|largest| off > largest.off) {
                largest = Some(JointSag { step, vertex, off });
            }
        }
        before.push(index + 1);
    }
    largest
}

#[cfg(test)]
mod tests;
