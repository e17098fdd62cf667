//! From space to the page.

use nalgebra::{Point3, Vector3};

/// From where a picture is seen; z is up, except from the top.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum View {
    /// From (1, -1, 1): x to the right and down, y to the right and up.
    #[default]
    Isometric,
    /// From +z: x to the right, y up.
    Top,
    /// From -y: x to the right.
    Front,
    /// From +x: y to the right.
    Right,
}

impl View {
    /// To the right, up, and towards the eye.
    fn axes(self) -> [Vector3<f64>; 3] {
        let (x, y, z) = (Vector3::x(), Vector3::y(), Vector3::z());
        match self {
            Self::Isometric => [
                Vector3::new(1.0, 1.0, 0.0).normalize(),
                Vector3::new(-1.0, 1.0, 2.0).normalize(),
                Vector3::new(1.0, -1.0, 1.0).normalize(),
            ],
            Self::Top => [x, y, z],
            Self::Front => [x, z, -y],
            Self::Right => [y, z, x],
        }
    }

    /// How long a millimetre along an axis of space looks.
    pub(super) fn foreshortening(self) -> f64 {
        if self == Self::Isometric { (2.0_f64 / 3.0).sqrt() } else { 1.0 }
    }
}

/// A part of the page: left, top, right, bottom.
pub(crate) type Area = [f64; 4];

/// A parallel projection that fits everything into an area.
pub(crate) struct Projection {
    pub(super) view: View,
    /// Pixels a millimetre in the plane of the page.
    pub(super) scale: f64,
    axes: [Vector3<f64>; 3],
    centre: [f64; 2],
    middle: [f64; 2],
    depth: [f64; 2],
}

impl Projection {
    /// `None` when there is no finite point. A single point is put in the middle.
    pub(crate) fn fit(view: View, points: impl Iterator<Item = Point3<f64>>, area: Area) -> Option<Self> {
        let axes = view.axes();
        let mut min = [f64::INFINITY; 3];
        let mut max = [f64::NEG_INFINITY; 3];
        for point in points.filter(is_finite) {
            for k in 0..3 {
                let along = axes[k].dot(&point.coords);
                min[k] = min[k].min(along);
                max[k] = max[k].max(along);
            }
        }
        if min[0] > max[0] {
            return None;
        }
        let size = [area[2] - area[0], area[3] - area[1]];
        let fits = |k: usize| size[k] / (max[k] - min[k]).max(1e-6);
        Some(Self {
            view,
            scale: fits(0).min(fits(1)).min(1e4),
            axes,
            centre: [f64::midpoint(min[0], max[0]), f64::midpoint(min[1], max[1])],
            middle: [f64::midpoint(area[0], area[2]), f64::midpoint(area[1], area[3])],
            depth: [min[2], max[2]],
        })
    }

    /// The place of a point on the page.
    pub(crate) fn at(&self, point: Point3<f64>) -> [f64; 2] {
        let along = |k: usize| (self.axes[k].dot(&point.coords) - self.centre[k]) * self.scale;
        [self.middle[0] + along(0), self.middle[1] - along(1)]
    }

    /// How near a point is: 0 for the farthest, 1 for the nearest; 1 where all are as near.
    pub(super) fn nearness(&self, point: Point3<f64>) -> f64 {
        let range = self.depth[1] - self.depth[0];
        if range < 1e-9 { 1.0 } else { (self.axes[2].dot(&point.coords) - self.depth[0]) / range }
    }

    /// Where an axis of space points on the page, a unit long in space.
    pub(super) fn axis(&self, k: usize) -> [f64; 2] {
        let axis = Vector3::ith(k, 1.0);
        [self.axes[0].dot(&axis), -self.axes[1].dot(&axis)]
    }
}

pub(crate) fn is_finite(point: &Point3<f64>) -> bool {
    point.coords.iter().all(|c| c.is_finite())
}
