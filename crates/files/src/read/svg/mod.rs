//! SVG: the outlines of a drawing, in the plane z = 0.
//!
//! The y axis of SVG points down and ours up, so y changes its sign: the drawing looks the same, and lies below the
//! x axis. The size of the page, in mm or the like, gives the scale; without one 96 px are an inch. Curves are kept
//! as what they are until they are made straight edges, which is why this reads elements itself: the libraries that
//! make pictures turn them into single-precision cubics first, and drop what is not painted.
//!
//! Fill, stroke and colour mean nothing here; what is hidden, by itself or by a style sheet, is left out and counted. Nothing outside the file is
//! looked at.

mod page;
mod path;
mod shape;
mod style;
mod tree;
mod walk;

use std::str::FromStr as _;

use nalgebra::{Affine3, Vector3};
use roxmltree::Node;
use svgtypes::{AspectRatio, Length, ViewBox};

use self::page::{PIXEL_MM, Page, fit, is_physical, pixels};
use self::tree::{Tree, parse};
use self::walk::{Context, Walk};
use super::Imported;
use super::drawing::Drawing;
use super::error::{Location, ReadError};
use super::format::Format;
use super::note::NoteKind;
use super::options::ReadOptions;
use super::outline::Pen;
use super::text::{Source, decode};
use wirebend_error::ErrorRemedy;

/// Reads all shapes that are not hidden.
pub(super) fn read(bytes: &[u8], source: Source<'_>, options: &ReadOptions) -> Result<Imported, ReadError> {
    let text = decode(bytes);
    let document = parse(&text, source)?;
    let tree = Tree::new(&document, source)?;
    let root = document.root_element();
    if root.tag_name().name() != "svg" {
        let remedy = ErrorRemedy::CheckRightFile;
        let place = Location::Line(1);
        return Err(source.syntax(place, root.tag_name().name(), "an svg element around all others", remedy));
    }
    let sheet = Sheet::of(&tree, root, options)?;
    let mut drawing = Drawing { unit_mm: sheet.unit_mm, ..Drawing::default() };
    if options.units.is_none() {
        let kind = if sheet.physical { NoteKind::PageScale } else { NoteKind::PixelScale };
        drawing.notes.add(kind, 1);
    }
    drawing.notes.add(NoteKind::AxisDown, 1);
    let mirror = Affine3::from_matrix_unchecked(nalgebra::Matrix4::new_nonuniform_scaling(&Vector3::new(
        1.0, -1.0, 1.0,
    )));
    let pen = Pen::new(source, drawing, options);
    let mut walk = Walk::new(&tree, pen, &options.layers)?;
    walk.root(root, Context::new(mirror * sheet.map, sheet.page))?;
    walk.pen.finish()?.finish(Format::Svg, source, options)
}

/// The outermost page: how large it is and what its numbers measure.
struct Sheet {
    map: Affine3<f64>,
    /// In the numbers within, for lengths in per cent.
    page: Page,
    /// Whether width or height are in mm or the like.
    physical: bool,
    unit_mm: Option<f64>,
}

impl Sheet {
    fn of(tree: &Tree<'_, '_>, root: Node<'_, '_>, options: &ReadOptions) -> Result<Self, ReadError> {
        let view = view_box(tree, root)?;
        let size = |name: &'static str| -> Result<Option<Length>, ReadError> {
            let text = root.attribute(name).map(str::trim).filter(|text| *text != "auto");
            let length = text.map(Length::from_str).transpose();
            length.map_err(|error| tree.refuse(root, name, &error.to_string()))
        };
        let (width, height) = (size("width")?, size("height")?);
        let physical = width.is_some_and(is_physical) || height.is_some_and(is_physical);
        let positive = |pixels: &f64| pixels.is_finite() && *pixels > 0.0;
        let in_pixels = |length: Option<Length>| length.and_then(pixels).filter(positive);
        // What is not said follows from the other side and the view box.
        let page = match (in_pixels(width), in_pixels(height), view) {
            (Some(width), Some(height), _) => Page { width, height },
            (Some(width), None, Some(view)) => Page { width, height: width * view.h / view.w },
            (None, Some(height), Some(view)) => Page { width: height * view.w / view.h, height },
            (None, None, Some(view)) => Page { width: view.w, height: view.h },
            (width, height, None) => {
                Page { width: width.unwrap_or(f64::NAN), height: height.unwrap_or(f64::NAN) }
            }
        };
        let inner = view.map_or(page, |view| Page { width: view.w, height: view.h });
        // A unit of the person's is one of the numbers as they stand.
        let map = match view {
            Some(view) if options.units.is_none() => path::affine(&fit(view, page, aspect(tree, root)?)),
            _ => Affine3::identity(),
        };
        let unit_mm = (physical || options.units.is_none()).then_some(PIXEL_MM);
        Ok(Self { map, page: inner, physical, unit_mm })
    }
}

fn view_box(tree: &Tree<'_, '_>, node: Node<'_, '_>) -> Result<Option<ViewBox>, ReadError> {
    let view = node.attribute("viewBox").map(ViewBox::from_str).transpose();
    view.map_err(|error| tree.refuse(node, "viewBox", &error.to_string()))
}

fn aspect(tree: &Tree<'_, '_>, node: Node<'_, '_>) -> Result<AspectRatio, ReadError> {
    let aspect = node.attribute("preserveAspectRatio").map(AspectRatio::from_str).transpose();
    let aspect = aspect.map_err(|error| tree.refuse(node, "preserveAspectRatio", &error.to_string()))?;
    Ok(aspect.unwrap_or_default())
}
