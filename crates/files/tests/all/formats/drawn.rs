//! What the tests of drawings look at: vertices, edges, distances.

use nalgebra::Point3;
use wirebend_files::read::{Imported, ReadOptions, read};

use super::mm;

/// Two ends, each rounded to a nanometre, in the order of the file.
pub type Ends = [[f64; 3]; 2];

pub fn rounded(point: &Point3<f64>) -> [f64; 3] {
    // Adding zero makes -0 and 0 the same.
    [point.x, point.y, point.z].map(|c| (c * 1e6).round() / 1e6 + 0.0)
}

pub fn points(imported: &Imported) -> Vec<Point3<f64>> {
    imported.wireframe.vertices().map(|(_, vertex)| vertex.position).collect()
}

pub fn edges(imported: &Imported) -> Vec<Ends> {
    let at = |id| rounded(&imported.wireframe.vertex(id).unwrap().position);
    imported.wireframe.edges().map(|(_, edge)| [at(edge.a), at(edge.b)]).collect()
}

/// Edges of one polyline through points.
pub fn chain(points: &[[f64; 3]]) -> Vec<Ends> {
    points.windows(2).map(|pair| [pair[0], pair[1]]).collect()
}

pub fn length(imported: &Imported) -> f64 {
    let at = |id| imported.wireframe.vertex(id).unwrap().position;
    imported.wireframe.edges().map(|(_, edge)| (at(edge.a) - at(edge.b)).norm()).sum()
}

/// The least and the largest of each coordinate.
pub fn bounds(imported: &Imported) -> [[f64; 3]; 2] {
    let points = points(imported);
    let of = |pick: fn(f64, f64) -> f64, start: f64| {
        std::array::from_fn(|axis| points.iter().map(|point| point[axis]).fold(start, pick))
    };
    [of(f64::min, f64::INFINITY), of(f64::max, f64::NEG_INFINITY)]
}

/// Every vertex lies on a curve and every middle of an edge near it: `off` is the distance from the curve, or less.
pub fn assert_on(imported: &Imported, tolerance: f64, off: impl Fn(&Point3<f64>) -> f64) {
    for point in points(imported) {
        assert!(off(&point).abs() < 1e-9, "{point} is {} off", off(&point));
    }
    for (_, edge) in imported.wireframe.edges() {
        let [a, b] = [edge.a, edge.b].map(|id| imported.wireframe.vertex(id).unwrap().position);
        let middle = nalgebra::center(&a, &b);
        assert!(off(&middle).abs() <= tolerance + 1e-9, "{middle} is {} off", off(&middle));
    }
}

pub fn with_tolerance(name: &str, text: &str, tolerance: f64) -> Imported {
    let options = ReadOptions { tolerance: mm(tolerance), ..ReadOptions::default() };
    read(text.as_bytes(), name, None, &options).unwrap_or_else(|error| panic!("{error}"))
}

pub fn with_layers(name: &str, text: &str, layers: &[&str]) -> Imported {
    let layers = layers.iter().map(ToString::to_string).collect();
    let options = ReadOptions { layers, ..ReadOptions::default() };
    read(text.as_bytes(), name, None, &options).unwrap_or_else(|error| panic!("{error}"))
}

/// A drawing that newcomers open first.
pub fn example(name: &str) -> Imported {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples").join(name);
    let bytes = std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    super::import(name, bytes).unwrap_or_else(|error| panic!("{error}"))
}

/// Whether it is one wire from one end to the other.
pub fn is_one_wire(imported: &Imported) -> bool {
    imported.wireframe.vertex_count() == imported.wireframe.edge_count() + 1
        && imported.wireframe.vertices().all(|(id, _)| imported.wireframe.incident(id).len() <= 2)
}
