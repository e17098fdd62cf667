//! The basic shapes: line, polyline, polygon, rect, circle, ellipse, and path.

use std::str::FromStr as _;

use nalgebra::Vector3;
use roxmltree::Node;
use svgtypes::{Length, NumberListParser};
use wirebend_core::curve::EllipticArc;
use wirebend_core::units::Angle;

use super::super::error::ReadError;
use super::super::outline::{Outline, Piece};
use super::page::{Along, Page};
use super::path::{arc, flat, outlines};
use super::tree::Tree;

/// The outlines of an element; none if it is no shape. A shape without size has no outlines.
pub(super) fn shape(
    tree: &Tree<'_, '_>,
    node: Node<'_, '_>,
    page: Page,
) -> Option<Result<Vec<Outline>, ReadError>> {
    let shape = Shape { tree, node, page };
    Some(match node.tag_name().name() {
        "path" => {
            let data = node.attribute("d").unwrap_or_default();
            outlines(data).map_err(|error| tree.refuse(node, "d", &error.to_string()))
        }
        "line" => shape.line(),
        "polyline" => shape.points(false),
        "polygon" => shape.points(true),
        "rect" => shape.rect(),
        "circle" => shape.circle(),
        "ellipse" => shape.ellipse(),
        _ => return None,
    })
}

struct Shape<'a, 'b, 'c> {
    tree: &'a Tree<'b, 'c>,
    node: Node<'b, 'c>,
    page: Page,
}

impl Shape<'_, '_, '_> {
    /// A length in the numbers of the page, if there is one.
    fn some(&self, name: &'static str, along: Along) -> Result<Option<f64>, ReadError> {
        length(self.tree, self.node, name, self.page, along)
    }

    fn length(&self, name: &'static str, along: Along) -> Result<f64, ReadError> {
        Ok(self.some(name, along)?.unwrap_or_default())
    }

    fn line(&self) -> Result<Vec<Outline>, ReadError> {
        let x = |name| self.length(name, Along::Width);
        let y = |name| self.length(name, Along::Height);
        let ends = [flat(x("x1")?, y("y1")?), flat(x("x2")?, y("y2")?)];
        Ok(Outline::polyline(ends, false).into_iter().collect())
    }

    fn points(&self, closed: bool) -> Result<Vec<Outline>, ReadError> {
        let text = self.node.attribute("points").unwrap_or_default();
        let refuse = |what: &str| self.tree.refuse(self.node, "points", what);
        let numbers = NumberListParser::from(text).collect::<Result<Vec<f64>, _>>();
        let numbers = numbers.map_err(|error| refuse(&error.to_string()))?;
        if !numbers.len().is_multiple_of(2) {
            return Err(refuse("a number without its y"));
        }
        let points = numbers.chunks_exact(2).map(|pair| flat(pair[0], pair[1]));
        Ok(Outline::polyline(points, closed).into_iter().collect())
    }

    /// With rounded corners, of one radius if the other is not given, and of half a side at most.
    fn rect(&self) -> Result<Vec<Outline>, ReadError> {
        let (x, y) = (self.length("x", Along::Width)?, self.length("y", Along::Height)?);
        let (width, height) = (self.length("width", Along::Width)?, self.length("height", Along::Height)?);
        if width <= 0.0 || height <= 0.0 {
            return Ok(Vec::new());
        }
        let (rx, ry) = (self.some("rx", Along::Width)?, self.some("ry", Along::Height)?);
        let half = |radius: Option<f64>, side: f64| radius.unwrap_or_default().max(0.0).min(side / 2.0);
        let (rx, ry) = (half(rx.or(ry), width), half(ry.or(rx), height));
        let (right, low) = (x + width, y + height);
        if rx <= 0.0 || ry <= 0.0 {
            let corners = [flat(x, y), flat(right, y), flat(right, low), flat(x, low)];
            return Ok(Outline::polyline(corners, true).into_iter().collect());
        }
        // Each side, and the arc to the next.
        let sides = [
            (flat(x + rx, y), flat(right - rx, y)),
            (flat(right, y + ry), flat(right, low - ry)),
            (flat(right - rx, low), flat(x + rx, low)),
            (flat(x, low - ry), flat(x, y + ry)),
        ];
        let mut outline = Outline::new(sides[0].0);
        for (k, (from, to)) in sides.into_iter().enumerate() {
            // A side that the radii leave nothing of.
            if from != to {
                outline.pieces.push(Piece::Line(to));
            }
            outline.pieces.push(arc(to, sides[(k + 1) % 4].0, [rx, ry], 0.0, false, true));
        }
        outline.closed = true;
        Ok(vec![outline])
    }

    fn circle(&self) -> Result<Vec<Outline>, ReadError> {
        let radius = self.length("r", Along::Diagonal)?;
        self.round(radius, radius)
    }

    fn ellipse(&self) -> Result<Vec<Outline>, ReadError> {
        let (rx, ry) = (self.some("rx", Along::Width)?, self.some("ry", Along::Height)?);
        self.round(rx.or(ry).unwrap_or_default(), ry.or(rx).unwrap_or_default())
    }

    fn round(&self, rx: f64, ry: f64) -> Result<Vec<Outline>, ReadError> {
        if rx <= 0.0 || ry <= 0.0 {
            return Ok(Vec::new());
        }
        let centre = flat(self.length("cx", Along::Width)?, self.length("cy", Along::Height)?);
        let (u, v) = (Vector3::x() * rx, Vector3::y() * ry);
        let sweep = Angle::from_rad(std::f64::consts::TAU).unwrap_or_default();
        Ok(vec![Outline::arc(EllipticArc { centre, u, v, start: Angle::ZERO, sweep })])
    }
}

/// The value of an attribute that is a length; `auto` is none.
pub(super) fn length(
    tree: &Tree<'_, '_>,
    node: Node<'_, '_>,
    name: &'static str,
    page: Page,
    along: Along,
) -> Result<Option<f64>, ReadError> {
    let Some(text) = node.attribute(name).map(str::trim).filter(|text| *text != "auto") else {
        return Ok(None);
    };
    let length = Length::from_str(text).map_err(|error| tree.refuse(node, name, &error.to_string()))?;
    let value = page.length(length, along).filter(|value| value.is_finite());
    value.map(Some).ok_or_else(|| tree.refuse(node, name, "not a length without the size of page or font"))
}
