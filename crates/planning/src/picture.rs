//! Pictures of wires, as SVG and as PNG.

use std::sync::Arc;

use nalgebra::Point3;
use resvg::{tiny_skia, usvg};
use wirebend_core::checks::{Code, Diagnostic, Severity};
use wirebend_core::units::Length;
use wirebend_files::write::{Mark, MarkAt, Picture, PictureWire, View, svg};

use crate::PlanningError;
use crate::plan::Planned;

/// Size of a picture in pixels.
const WIDTH_PX: u32 = 1200;
const HEIGHT_PX: u32 = 900;

/// What stands below a picture.
pub struct Caption {
    pub title: String,
    pub machine: String,
    pub material: String,
    pub length: Length,
    pub bends: usize,
}

/// A picture of wires, of what was bent of them, and with marks where something is wrong.
pub fn draw(
    caption: Caption,
    wires: Vec<PictureWire>,
    trials: Vec<Vec<Point3<f64>>>,
    marks: Vec<Mark>,
) -> String {
    svg(&Picture {
        title: caption.title,
        machine: Some(caption.machine),
        material: Some(caption.material),
        length: caption.length,
        bends: caption.bends,
        wires,
        trials,
        marks,
        view: View::Isometric,
        width_px: WIDTH_PX,
        height_px: HEIGHT_PX,
    })
}

/// Where the diagnostics of a plan are, for a picture.
pub fn marks(planned: &Planned) -> Vec<Mark> {
    let of_wires = planned.wires.iter().flat_map(|wire| &wire.diagnostics);
    planned
        .design
        .iter()
        .chain(of_wires)
        .filter_map(|diagnostic| mark(planned, diagnostic))
        .flatten()
        .collect()
}

fn mark(planned: &Planned, diagnostic: &Diagnostic) -> Option<Vec<Mark>> {
    let severity = match diagnostic.severity {
        Severity::Error => wirebend_files::write::Severity::Error,
        Severity::Warning => wirebend_files::write::Severity::Warning,
        Severity::Info => return None,
    };
    let wireframe = &planned.opened.document.wireframe;
    let position = |id| wireframe.vertex(id).map(|vertex| vertex.position);
    let at_vertex = |id: &wirebend_core::wireframe::VertexId| {
        Some(Mark {
            at: MarkAt::Vertex(position(*id)?),
            severity,
            label: label(&format!("vertex {id}"), diagnostic),
        })
    };
    let at_edge = |id: &wirebend_core::wireframe::EdgeId| {
        let edge = wireframe.edge(*id)?;
        Some(Mark {
            at: MarkAt::Edge(position(edge.a)?, position(edge.b)?),
            severity,
            label: label(&format!("edge {id}"), diagnostic),
        })
    };
    // A bend is at its vertex; a length is along its edges.
    Some(match diagnostic.code() {
        Code::EdgeTooShort
        | Code::EdgeNearLimit
        | Code::FeedTooShort
        | Code::FeedNearLimit
        | Code::FeedTooLong
        | Code::ArcsOverlap
        | Code::ParallelEdges => diagnostic.location.edges.iter().filter_map(at_edge).collect(),
        _ => diagnostic.location.vertices.iter().filter_map(at_vertex).collect(),
    })
}

/// What is wrong in a few words: the place, what was measured, and the limit.
fn label(place: &str, diagnostic: &Diagnostic) -> String {
    match (diagnostic.measured(), diagnostic.limit()) {
        (Some(measured), Some(limit)) => format!("{place}: {measured}, limit {}", limit.value),
        (Some(measured), None) => format!("{place}: {measured}"),
        _ => place.to_owned(),
    }
}

/// The pixels of an SVG picture as PNG. `false` where no font is installed: labels are then missing.
pub fn png(svg: &str) -> Result<(Vec<u8>, bool), PlanningError> {
    let mut options = usvg::Options::default();
    Arc::make_mut(&mut options.fontdb).load_system_fonts();
    let has_fonts = !options.fontdb.is_empty();
    let wrong = |error: &dyn std::fmt::Display| PlanningError::Picture(error.to_string());
    let tree = usvg::Tree::from_str(svg, &options).map_err(|error| wrong(&error))?;
    let mut pixels = tiny_skia::Pixmap::new(WIDTH_PX, HEIGHT_PX)
        .ok_or_else(|| PlanningError::Picture("the picture has no size".to_owned()))?;
    resvg::render(&tree, tiny_skia::Transform::identity(), &mut pixels.as_mut());
    Ok((pixels.encode_png().map_err(|error| wrong(&error))?, has_fonts))
}
