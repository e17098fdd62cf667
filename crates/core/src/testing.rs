//! The published machine and small wireframes, for the tests of this crate.

use nalgebra::Point3;

use crate::checks::{BendRadius, BendTorque, MachineLimits, Source, Sourced};
use crate::clearance::Bodies;
use crate::compensate::{BendModel, Compensation, FeedModel, MotionModel, PegGeometry, Springback};
use crate::estimate::{TimeModel, WireModel};
use crate::plan::Machine;
use crate::schedule::HeadLimits;
use crate::units::{Angle, Length};
use crate::wireframe::{Vertex, VertexId, Wireframe};

pub(crate) fn mm(value: f64) -> Length {
    Length::from_mm(value).unwrap()
}

pub(crate) fn deg(value: f64) -> Angle {
    Angle::from_deg(value).unwrap()
}

/// A figure without a reason of its own.
pub(crate) fn from(entry: &str) -> Source {
    Source { reason: None, entry: entry.to_owned() }
}

fn paper<T>(value: T) -> Sourced<T> {
    Sourced { value, source: from("the paper") }
}

/// The $293 bender with its 3 mm aluminium, as published.
pub(crate) fn published_machine() -> Machine {
    Machine {
        limits: MachineLimits {
            min_bend: paper(deg(-155.0)),
            max_bend: paper(deg(155.0)),
            min_edge: paper(mm(20.4)),
            min_feed: paper(mm(25.0)),
            max_feed: None,
            max_stock: None,
            tail: paper(mm(400.0)),
            min_diameter: paper(mm(2.8)),
            max_diameter: paper(mm(3.2)),
            bend_torque: Some(BendTorque::beside(paper(37.9), mm(3.0), 362.14)),
            bend_radius: Some(BendRadius {
                inner: mm(1.5),
                inner_within: Length::ZERO,
                diameter: mm(3.0),
                least_diameters: paper(0.5),
            }),
            min_rotation_source: from("the paper"),
            max_rotation_source: from("the paper"),
            axis_source: from("the paper"),
            head_not_measured: false,
        },
        head: HeadLimits {
            min: deg(-360.0),
            max: deg(360.0),
            seconds_per_degree: 1.0 / 131.3,
            seconds_per_turn: 0.0,
        },
        compensation: Compensation {
            feed: Some(FeedModel::new(mm(1.5), mm(3.0), 0.3)),
            bend: BendModel {
                springback: Some(Springback::Constant(deg(10.23))),
                setback: Some(PegGeometry::new(mm(20.4), mm(12.0), mm(3.0), mm(4.675)).unwrap()),
                axis_limit: None,
                before_zero: false,
            },
            motion: MotionModel::default(),
        },
        time: TimeModel {
            feed_mm_per_s: 110.2,
            rotate_deg_per_s: 131.3,
            bend_deg_per_s: 15.1,
            fixed_per_bend_s: 5.0,
            fixed_per_feed_s: 0.0,
            fixed_per_turn_s: 0.0,
        },
        wire: WireModel {
            diameter: mm(3.0),
            density_kg_per_m3: 2700.0,
            youngs_modulus_gpa: 68.03,
            price_per_mm: Some(0.00199),
        },
        bend_radius: mm(3.0),
        straight: deg(0.01676 / 2.0),
        bodies: Bodies::default(),
        scatter: None,
    }
}

/// A wireframe of points and edges between them.
pub(crate) fn wireframe(points: &[[f64; 3]], edges: &[(usize, usize)]) -> Wireframe {
    let mut w = Wireframe::new();
    let ids: Vec<VertexId> =
        points.iter().map(|&p| w.add_vertex(Vertex::at(Point3::from(p))).unwrap()).collect();
    for &(a, b) in edges {
        w.add_edge(ids[a], ids[b]).unwrap();
    }
    w
}

/// Points one after the other.
pub(crate) fn chain(points: &[[f64; 3]]) -> Wireframe {
    let edges: Vec<_> = (1..points.len()).map(|k| (k - 1, k)).collect();
    wireframe(points, &edges)
}
