//! Edits that are given in figures: lengths, angles, turns, shapes, fillets.

use nalgebra::{Affine3, Matrix3, Point3, Unit, Vector3};
use wirebend_core::units::{Angle, Length};
use wirebend_core::wireframe::{
    ChordLimits, EdgeId, Edit, EditError, PolygonSize, Rest, ShapePlane, VertexId,
};

use super::EditorError;
use super::plane::{AxisName, OwnPlane, PlaneName};
use super::request::{EditRequest, PolygonMeasure, RestPlace};

impl EditRequest {
    /// The edit that it is; none where it is not given in figures. `chord_limits`: see `of_wireframe`.
    pub(super) fn of_figures(
        &self,
        chord_limits: impl FnOnce() -> Result<ChordLimits, EditorError>,
    ) -> Result<Option<Edit>, EditorError> {
        Ok(Some(match self {
            Self::Length { edge, length_mm, stays, rest } => Edit::SetLength {
                edge: EdgeId(*edge),
                length: Length::from_mm(*length_mm).map_err(|_| EditError::EdgeLength(*length_mm))?,
                stays: VertexId(*stays),
                rest: Rest::from(*rest),
            },
            Self::Angle { vertex, between, angle_deg, normal, rest } => Edit::SetAngle {
                vertex: VertexId(*vertex),
                between: between.map(|[stays, turns]| (EdgeId(stays), EdgeId(turns))),
                angle: Angle::from_deg(*angle_deg).map_err(|_| EditError::CornerAngle(*angle_deg))?,
                normal: normal.map(unit).transpose()?,
                rest: Rest::from(*rest),
            },
            Self::Rotate { vertices, lines: _, axis, through_mm, angle_deg } => Edit::Transform {
                vertices: ids(vertices),
                transform: rotation(*axis, (*through_mm).into(), *angle_deg)?,
            },
            Self::Circle { centre_mm, plane, on, radius_mm, edges } => Edit::AddPolygon {
                plane: plane.through(*on, *centre_mm)?,
                sides: *edges,
                size: PolygonSize::Corners(shape_size(*radius_mm)?),
                turn: Angle::ZERO,
            },
            Self::Polygon { centre_mm, plane, on, sides, measure, size_mm, turn_deg } => Edit::AddPolygon {
                plane: plane.through(*on, *centre_mm)?,
                sides: *sides,
                size: measure.of(shape_size(*size_mm)?),
                turn: Angle::from_deg(*turn_deg).map_err(|_| EditorError::Turn(*turn_deg))?,
            },
            Self::Helix { centre_mm, plane, on, radius_mm, pitch_mm, turns, edges_per_turn, left } => {
                Edit::AddHelix {
                    plane: plane.through(*on, *centre_mm)?,
                    radius: shape_size(*radius_mm)?,
                    pitch: shape_size(*pitch_mm)?,
                    turns: *turns,
                    sides: *edges_per_turn,
                    left: *left,
                }
            }
            Self::Fillet { vertices, radius_mm, step_deg } => Edit::Fillet {
                vertices: ids(vertices),
                radius: Length::from_mm(*radius_mm).map_err(|_| EditError::FilletRadius(*radius_mm))?,
                step: Angle::from_deg(*step_deg).map_err(|_| EditorError::ArcStep(*step_deg))?,
                limits: chord_limits()?,
            },
            _ => return Ok(None),
        }))
    }
}

impl PolygonMeasure {
    const fn of(self, size: Length) -> PolygonSize {
        match self {
            Self::Corners => PolygonSize::Corners(size),
            Self::Flats => PolygonSize::Flats(size),
            Self::Side => PolygonSize::Side(size),
        }
    }
}

impl From<RestPlace> for Rest {
    fn from(rest: RestPlace) -> Self {
        match rest {
            RestPlace::Stays => Self::Stays,
            RestPlace::Follows => Self::Follows,
        }
    }
}

impl PlaneName {
    /// The plane of its axes through a point, or the one that is given in its place.
    fn through(self, on: Option<OwnPlane>, centre_mm: [f64; 3]) -> Result<ShapePlane, EditorError> {
        if let Some(own) = on {
            return own.through(centre_mm);
        }
        let (x, y, z) = (Vector3::x_axis(), Vector3::y_axis(), Vector3::z_axis());
        let (u, v) = match self {
            Self::Xy => (x, y),
            Self::Xz => (x, z),
            Self::Yz => (y, z),
        };
        Ok(ShapePlane { centre: centre_mm.into(), u, v })
    }
}

impl OwnPlane {
    fn through(self, [x, y, z]: [f64; 3]) -> Result<ShapePlane, EditorError> {
        let u = unit(self.u)?;
        let v = Vector3::from(self.v);
        let v = unit((v - *u * v.dot(&u)).into())?;
        let centre = Point3::from(self.origin_mm) + *u * x + *v * y + u.cross(&v) * z;
        Ok(ShapePlane { centre, u, v })
    }
}

impl AxisName {
    pub(super) fn direction(self) -> Unit<Vector3<f64>> {
        match self {
            Self::X => Vector3::x_axis(),
            Self::Y => Vector3::y_axis(),
            Self::Z => Vector3::z_axis(),
        }
    }
}

/// A turn about an axis through a point; quarter turns come out whole.
pub(super) fn rotation(axis: AxisName, through: Point3<f64>, deg: f64) -> Result<Affine3<f64>, EditorError> {
    if !deg.is_finite() {
        return Err(EditorError::Turn(deg));
    }
    let (sin, cos) = match deg.rem_euclid(360.0) {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        turned => turned.to_radians().sin_cos(),
    };
    let linear = match axis {
        AxisName::X => Matrix3::new(1.0, 0.0, 0.0, 0.0, cos, -sin, 0.0, sin, cos),
        AxisName::Y => Matrix3::new(cos, 0.0, sin, 0.0, 1.0, 0.0, -sin, 0.0, cos),
        AxisName::Z => Matrix3::new(cos, -sin, 0.0, sin, cos, 0.0, 0.0, 0.0, 1.0),
    };
    let mut matrix = linear.to_homogeneous();
    matrix.fixed_view_mut::<3, 1>(0, 3).copy_from(&(through.coords - linear * through.coords));
    Ok(Affine3::from_matrix_unchecked(matrix))
}

fn shape_size(mm: f64) -> Result<Length, EditError> {
    Length::from_mm(mm).map_err(|_| EditError::ShapeSize(mm))
}

pub(super) fn ids(list: &[u32]) -> Vec<VertexId> {
    list.iter().copied().map(VertexId).collect()
}

pub(super) fn unit(normal: [f64; 3]) -> Result<Unit<Vector3<f64>>, EditorError> {
    Unit::try_new(Vector3::from(normal), 1e-12).ok_or(EditorError::Normal)
}
