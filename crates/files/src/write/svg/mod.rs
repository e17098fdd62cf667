//! A picture of the wire, as SVG: to look at, to print, to put into a report.

mod element;
mod marks;
mod sheet;
mod view;
mod wire;

use nalgebra::Point3;
use wirebend_core::units::Length;

pub(super) use element::escape;
pub use view::View;
pub(super) use view::{Projection, is_finite};

use element::Page;

/// What is drawn, in mm.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// The name of the design.
    pub title: String,
    /// The machine, if there is one.
    pub machine: Option<String>,
    /// The wire, if it is known.
    pub material: Option<String>,
    /// The length of all wires.
    pub length: Length,
    /// How many bends they have.
    pub bends: usize,
    pub wires: Vec<PictureWire>,
    /// The same wires as they were bent, thin and behind; each its points in mm.
    pub trials: Vec<Vec<Point3<f64>>>,
    /// What is to be fixed.
    pub marks: Vec<Mark>,
    /// From where it is seen.
    pub view: View,
    /// Width in pixels; 320 at least.
    pub width_px: u32,
    /// Height in pixels; 240 at least.
    pub height_px: u32,
}

#[derive(Debug, Clone, PartialEq, Default)]
pub struct PictureWire {
    pub points: Vec<Point3<f64>>,
    /// The segments (k joins points k and k + 1) that lie on an edge that is laid twice: both passes.
    pub doubled: Vec<usize>,
}

/// Something to fix, with its place.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    pub at: MarkAt,
    pub severity: Severity,
    /// What, in a few words.
    pub label: String,
}

/// The place of a mark.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum MarkAt {
    Vertex(Point3<f64>),
    /// An edge, from one end to the other.
    Edge(Point3<f64>, Point3<f64>),
}

/// How bad something is. Red triangles are errors, amber diamonds warnings.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Severity {
    /// The machine cannot.
    Error,
    Warning,
}

/// Draws a picture. The same picture gives the same text; points that are not finite are left out.
#[must_use]
pub fn svg(picture: &Picture) -> String {
    let mut page = Page::new(picture.width_px.max(320), picture.height_px.max(240), &picture.title);
    let layout = sheet::Layout::of(picture, &page);
    let points = picture.wires.iter().map(|wire| &wire.points).chain(&picture.trials).flatten().copied();
    let marked = picture.marks.iter().flat_map(|mark| match mark.at {
        MarkAt::Vertex(point) => vec![point],
        MarkAt::Edge(a, b) => vec![a, b],
    });
    let projection = Projection::fit(picture.view, points.chain(marked), layout.drawing);
    match &projection {
        Some(projection) => {
            wire::trials(&mut page, picture, projection);
            wire::draw(&mut page, picture, projection);
            marks::draw(&mut page, &picture.marks, projection);
            sheet::scale_bar(&mut page, projection, &layout);
            sheet::axes(&mut page, projection, &layout);
        }
        None => sheet::nothing(&mut page, &layout),
    }
    sheet::title_block(&mut page, picture, &layout);
    marks::list(&mut page, &picture.marks, &layout);
    page.finish()
}
