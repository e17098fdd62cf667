//! Numbers, angles and lengths beside the wire of a template, and words at its ends.

use std::collections::BTreeSet;

use nalgebra::{Point3, Vector3};
use wirebend_core::units::DisplayUnit;

use super::{Template, outline};
use crate::number::unit_word;
use crate::write::centreline::Piece;
use crate::write::drawing::{Layer, Point, Shape};
use crate::write::labels::{BendAt, EdgeAt, LabelStep, Spots, Style, WordAt, labels, left_out, spots};
use crate::write::plane::View;

/// The size of their letters in mm: smaller than what stands under the wire.
const SIZE: f64 = 3.0;

/// What stands beside one wire, over all of its views.
pub(super) struct Labelled<'a> {
    steps: &'a [LabelStep],
    bends: usize,
    numbered: BTreeSet<usize>,
    with_angle: BTreeSet<usize>,
    without_length: usize,
}

impl<'a> Labelled<'a> {
    pub fn new(steps: &'a [LabelStep]) -> Self {
        let bends = steps.iter().filter(|step| step.bend_deg != 0.0).count();
        let (numbered, with_angle) = (BTreeSet::new(), BTreeSet::new());
        Self { steps, bends, numbered, with_angle, without_length: 0 }
    }

    /// Labels one view of several. A bend has its number and its angle in each of them, an edge its length in the one that shows it longest.
    pub fn add(
        &mut self,
        shapes: &mut Vec<(Layer, Shape)>,
        path: &[Point3<f64>],
        pieces: &[Piece],
        view: &View,
        views: &[View],
        template: &Template,
    ) {
        let centre = shapes.iter().filter(|(layer, _)| *layer == Layer::Centreline);
        let lines: Vec<[Point; 2]> = centre
            .flat_map(|(_, shape)| {
                let points = shape.points(template.chord.mm());
                points.windows(2).map(|pair| [pair[0], pair[1]]).collect::<Vec<_>>()
            })
            .collect();
        let Spots { bends, edges } = spots(path, self.steps);
        let bends: Vec<BendAt> = bends
            .iter()
            .map(|bend| BendAt {
                number: bend.number,
                at: view.point(bend.at),
                sides: bend.sides.map(|side| view.vector(side)),
                angle_deg: bend.angle_deg,
            })
            .collect();
        let edges: Vec<EdgeAt> = edges
            .iter()
            .filter(|edge| longest(edge.ends[1] - edge.ends[0], views) == Some(view))
            .map(|edge| EdgeAt { ends: edge.ends.map(|end| view.point(end)), length_mm: edge.length_mm })
            .collect();
        let style = Style { size: SIZE, half: template.diameter.mm() / 2.0, room: None, unit: template.unit };
        let found = labels(&lines, &words(pieces, view), &bends, &edges, style);
        self.numbered.extend(found.numbered);
        self.with_angle.extend(found.with_angle);
        self.without_length += found.without_length;
        shapes.extend(found.shapes.into_iter().map(|shape| (Layer::Text, shape)));
    }

    /// How to read the labels, and which are missing.
    pub fn about(&self, unit: DisplayUnit) -> Vec<String> {
        if self.steps.is_empty() {
            return Vec::new();
        }
        let read = format!(
            "in circles the steps of the job sheet, with their angles; lengths from corner to corner in {}",
            unit_word(unit)
        );
        let numbers = self.bends - self.numbered.len();
        let angles = self.bends - self.with_angle.len();
        let missing = left_out(numbers, angles, self.without_length);
        std::iter::once(read)
            .chain(missing.map(|what| format!("no room for {what}: see the job sheet")))
            .collect()
    }
}

/// The view that shows a line longest, the first of those that do.
fn longest(line: Vector3<f64>, views: &[View]) -> Option<&View> {
    let length = |view: &View| {
        let [x, y] = view.vector(line);
        x.hypot(y)
    };
    let most = views.iter().map(length).fold(0.0, f64::max);
    views.iter().find(|view| length(view) >= most * (1.0 - 1e-9))
}

/// Words at both ends of a wire, on the side where it is not.
fn words(pieces: &[Piece], view: &View) -> Vec<WordAt> {
    let ends = [(pieces.first(), 0.0, -1.0, "start"), (pieces.last(), 1.0, 1.0, "end")];
    let word = |(piece, along, sign, word): (Option<&Piece>, f64, f64, &str)| {
        let (at, tangent) = outline::end_of(piece?, along, view);
        let away = tangent.map(|c| c * sign);
        // Seen along the wire, the word stands above its end.
        let away = if away[0].hypot(away[1]) > 0.01 { away } else { [0.0, 1.0] };
        Some(WordAt { word: word.to_owned(), at, away })
    };
    ends.into_iter().filter_map(word).collect()
}
