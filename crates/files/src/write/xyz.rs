//! A table of points.

use nalgebra::Point3;

use super::table::TableStyle;

/// Writes points (mm) as rows of x, y and z; a closed polyline repeats its first point.
#[must_use]
pub fn xyz(points: &[Point3<f64>], style: &TableStyle) -> String {
    let mut text = String::new();
    if style.header {
        text.push_str(&style.row(["x_mm", "y_mm", "z_mm"]));
    }
    for point in points {
        text.push_str(&style.row([point.x, point.y, point.z].map(|c| style.number(c))));
    }
    text
}
