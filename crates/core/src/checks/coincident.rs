//! Vertices on top of each other look joined but are not.

use nalgebra::Point3;

use super::{Code, Design, Diagnostic, Limit, Place, Quantity, Severity};
use crate::units::Length;
use crate::wireframe::{VertexId, clusters};

pub(super) fn check(design: &Design, found: &mut Vec<Diagnostic>) {
    let (ids, positions): (Vec<VertexId>, Vec<Point3<f64>>) =
        design.wireframe.vertices().map(|(id, vertex)| (id, vertex.position)).unzip();
    for (k, first) in clusters(&positions, design.weld_tolerance.mm()).into_iter().enumerate() {
        if first == k {
            continue;
        }
        let apart = Length::computed((positions[k] - positions[first]).norm());
        found.push(Diagnostic {
            code: Code::CoincidentVertices,
            severity: Severity::Warning,
            place: Place::at_vertices([ids[k], ids[first]]),
            measured: Some(Quantity::Length(apart)),
            limit: Some(Limit {
                value: Quantity::Length(design.weld_tolerance),
                source: "the weld tolerance".to_owned(),
            }),
            message: format!("vertices {} and {} are {apart:.4} apart but not joined", ids[first], ids[k]),
            help: "merge them, or weld the wireframe with a larger tolerance".to_owned(),
        });
    }
}
