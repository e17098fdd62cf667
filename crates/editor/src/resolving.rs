//! From what a person asks for to the edits of `core`, and to what a menu calls it.

use nalgebra::{Affine3, Matrix4, Point3, Vector3};
use wirebend_core::units::{Angle, Length};
use wirebend_core::wireframe::{
    ChordLimits, EdgeId, Edit, Joint, MergeAt, MirrorMode, Vertex, VertexId, reflection,
};

use super::EditorError;
use super::construction::LinesEdit;
use super::figures::{ids, rotation, unit};
use super::request::{ConstructionChange, EditRequest, MergePlace, Placed};

impl EditRequest {
    /// The edits of the wireframe that it is; none where it changes something else.
    /// `chord_limits` is asked for what the machine of the design can make of a fillet.
    pub(super) fn of_wireframe(
        &self,
        weld: Length,
        chord_limits: impl FnOnce() -> Result<ChordLimits, EditorError>,
    ) -> Result<Option<Vec<Edit>>, EditorError> {
        let one = |edit| Ok(Some(vec![edit]));
        if let Some(edit) = self.of_figures(chord_limits)? {
            return one(edit);
        }
        match self {
            Self::Draw { from, through_mm, to } => one(Edit::Draw {
                from: from.map(VertexId),
                through: through_mm.iter().copied().map(Point3::from).collect(),
                to: to.map(VertexId),
            }),
            Self::Paste { vertices, edges } => one(Edit::Paste {
                vertices: vertices
                    .iter()
                    .map(|vertex| Vertex {
                        position: vertex.at_mm.into(),
                        support: vertex.support,
                        free: [false; 6],
                        joint: vertex.joint.map(Joint::from),
                    })
                    .collect(),
                edges: edges.iter().map(|&[a, b]| (a, b)).collect(),
            }),
            Self::Delete { vertices, edges, lines: _ } => {
                one(Edit::Delete { vertices: ids(vertices), edges: edge_ids(edges) })
            }
            Self::Move { vertices, lines: _, by_mm } => {
                one(Edit::Move { vertices: ids(vertices), by: Vector3::from(*by_mm) })
            }
            Self::Place { positions } => {
                let place = |&Placed { vertex, at_mm }: &Placed| Edit::Place {
                    vertex: VertexId(vertex),
                    position: at_mm.into(),
                };
                Ok(Some(positions.iter().map(place).collect()))
            }
            Self::Split { edge, at } => one(Edit::SplitEdge { edge: EdgeId(*edge), at: *at }),
            Self::Merge { vertices, at } => {
                let at = match at {
                    MergePlace::First => MergeAt::First,
                    MergePlace::Last => MergeAt::Last,
                    MergePlace::Centre => MergeAt::Centre,
                };
                one(Edit::Merge { vertices: ids(vertices), at })
            }
            Self::Transform { vertices, lines: _, matrix } => {
                one(Edit::Transform { vertices: ids(vertices), transform: affine(matrix)? })
            }
            Self::Mirror { vertices, lines: _, point_mm, normal, copy } => {
                let normal = unit(*normal)?;
                let mode = if *copy { MirrorMode::Copy } else { MirrorMode::InPlace };
                let point = Point3::from(*point_mm);
                one(Edit::Mirror { vertices: ids(vertices), point, normal, mode, weld })
            }
            Self::Array { vertices, lines: _, step, count } => {
                one(Edit::Array { vertices: ids(vertices), step: affine(step)?, count: *count, weld })
            }
            Self::Support { vertices, support } => {
                one(Edit::SetSupport { vertices: ids(vertices), support: *support })
            }
            Self::Joint { vertices, joint } => {
                one(Edit::SetJoint { vertices: ids(vertices), joint: joint.map(Joint::from) })
            }
            Self::Ceiling { edges, ceiling } => {
                one(Edit::SetCeiling { edges: edge_ids(edges), ceiling: *ceiling })
            }
            Self::Weld { tolerance_mm } => one(Edit::Weld { tolerance: tolerance(*tolerance_mm)? }),
            Self::Detach { edges } => one(Edit::Detach { edges: edge_ids(edges) }),
            Self::Straighten { edges, tolerance_mm } => {
                one(Edit::Straighten { edges: edge_ids(edges), tolerance: tolerance(*tolerance_mm)? })
            }
            Self::Round { edges, tolerance_mm, step_deg, least_edge_mm } => {
                one(round(edges, *tolerance_mm, *step_deg, *least_edge_mm)?)
            }
            Self::Length { .. }
            | Self::Angle { .. }
            | Self::Rotate { .. }
            | Self::Circle { .. }
            | Self::Polygon { .. }
            | Self::Helix { .. }
            | Self::Fillet { .. }
            | Self::Doublings { .. }
            | Self::Start { .. }
            | Self::Wires { .. }
            | Self::Closed { .. }
            | Self::Reversed { .. }
            | Self::Collisions { .. }
            | Self::Walks { .. }
            | Self::Pause { .. }
            | Self::Machine { .. }
            | Self::Notes { .. }
            | Self::Units { .. }
            | Self::Construction { .. }
            | Self::RemoveStencil { .. }
            | Self::PlaceStencil { .. }
            | Self::TurnStencil { .. }
            | Self::StencilLook { .. }
            | Self::PartLook { .. }
            | Self::Several { .. } => Ok(None),
        }
    }

    /// What it does to construction lines beside vertices, and to which; none where it has none.
    pub(super) fn of_lines(&self) -> Result<Option<(&[u32], LinesEdit)>, EditorError> {
        let (lines, edit) = match self {
            Self::Delete { lines, .. } => (lines, LinesEdit::Delete),
            Self::Move { lines, by_mm, .. } => (lines, LinesEdit::Place(shift(*by_mm))),
            Self::Transform { lines, matrix, .. } => (lines, LinesEdit::Place(affine(matrix)?)),
            Self::Rotate { lines, axis, through_mm, angle_deg, .. } => {
                (lines, LinesEdit::Place(rotation(*axis, (*through_mm).into(), *angle_deg)?))
            }
            Self::Mirror { lines, point_mm, normal, copy, .. } => {
                let image = reflection((*point_mm).into(), unit(*normal)?);
                let copies = LinesEdit::Copy { step: image, count: 1 };
                (lines, if *copy { copies } else { LinesEdit::Place(image) })
            }
            Self::Array { lines, step, count, .. } => {
                (lines, LinesEdit::Copy { step: affine(step)?, count: *count })
            }
            _ => return Ok(None),
        };
        Ok(Some((lines.as_slice(), edit)).filter(|(lines, _)| !lines.is_empty()))
    }

    /// What a menu calls it after "Undo".
    pub(super) fn label(&self) -> String {
        let some = |count: usize, one: &str, many: &str| match count {
            1 => one.to_owned(),
            count => format!("{count} {many}"),
        };
        let vertices = |list: &[u32]| some(list.len(), "vertex", "vertices");
        let constructed = |count: usize| some(count, "construction line", "construction lines");
        let both = |list: &[u32], lines: &[u32]| match (list, lines) {
            (list, []) => vertices(list),
            ([], lines) => constructed(lines.len()),
            (list, lines) => format!("{} and {}", vertices(list), constructed(lines.len())),
        };
        match self {
            Self::Draw { through_mm, .. } if through_mm.is_empty() => "connect vertices".to_owned(),
            Self::Draw { .. } => "draw".to_owned(),
            Self::Paste { .. } => "paste".to_owned(),
            Self::Delete { vertices: gone, edges, lines } => {
                match (gone.as_slice(), edges.as_slice(), lines.as_slice()) {
                    (gone, [], []) => format!("delete {}", vertices(gone)),
                    ([], edges, []) => format!("delete {}", some(edges.len(), "edge", "edges")),
                    ([], [], lines) => format!("delete {}", constructed(lines.len())),
                    _ => "delete".to_owned(),
                }
            }
            Self::Move { vertices: moved, lines, .. } => format!("move {}", both(moved, lines)),
            Self::Place { positions } => format!("place {}", some(positions.len(), "vertex", "vertices")),
            Self::Length { .. } => "set length".to_owned(),
            Self::Angle { .. } => "set angle".to_owned(),
            Self::Split { .. } => "split edge".to_owned(),
            Self::Merge { vertices: merged, .. } => format!("merge {}", vertices(merged)),
            Self::Transform { vertices: turned, lines, .. } => format!("transform {}", both(turned, lines)),
            Self::Rotate { vertices: turned, lines, .. } => format!("rotate {}", both(turned, lines)),
            Self::Mirror { .. } => "mirror".to_owned(),
            Self::Array { .. } => "array".to_owned(),
            Self::Support { support: true, .. } => "fix support".to_owned(),
            Self::Support { .. } => "free support".to_owned(),
            Self::Joint { vertices: jointed, joint: Some(_) } if jointed.len() == 1 => "set joint".to_owned(),
            Self::Joint { joint: Some(_), .. } => "set joints".to_owned(),
            Self::Joint { vertices: freed, .. } if freed.len() == 1 => "remove joint".to_owned(),
            Self::Joint { .. } => "remove joints".to_owned(),
            Self::Ceiling { ceiling: true, .. } => "mark as ceiling".to_owned(),
            Self::Ceiling { .. } => "remove ceiling mark".to_owned(),
            Self::Weld { .. } => "weld".to_owned(),
            Self::Detach { edges } => format!("detach {}", some(edges.len(), "edge", "edges")),
            Self::Circle { .. } => "circle".to_owned(),
            Self::Polygon { .. } => "polygon".to_owned(),
            Self::Helix { .. } => "helix".to_owned(),
            Self::Fillet { vertices: corners, .. } => {
                format!("round {}", some(corners.len(), "corner", "corners"))
            }
            Self::Straighten { .. } => "straighten".to_owned(),
            Self::Round { .. } => "round".to_owned(),
            Self::Doublings { .. } => "doubled edges".to_owned(),
            Self::Start { .. } => "start of the wire".to_owned(),
            Self::Wires { .. } => "number of wires".to_owned(),
            Self::Closed { .. } => "closed wire".to_owned(),
            Self::Reversed { .. } => "direction of the wire".to_owned(),
            Self::Collisions { .. } => "collision settings".to_owned(),
            Self::Walks { .. } => "order of the bends".to_owned(),
            Self::Pause { .. } => "pause point".to_owned(),
            Self::Machine { .. } => "machine".to_owned(),
            Self::Notes { .. } => "notes".to_owned(),
            Self::Units { .. } => "units".to_owned(),
            Self::Construction { change } => match change {
                ConstructionChange::Draw { through_mm } => constructed(through_mm.len().saturating_sub(1)),
                ConstructionChange::Lines { edges } => constructed(edges.len()),
                ConstructionChange::Edges { lines } => some(lines.len(), "edge", "edges") + " of lines",
                ConstructionChange::Nothing { lines } => format!("delete {}", constructed(lines.len())),
            },
            Self::RemoveStencil { .. } => "remove stencil".to_owned(),
            Self::PlaceStencil { .. } => "place stencil".to_owned(),
            Self::TurnStencil { .. } => "turn stencil".to_owned(),
            Self::StencilLook { look, .. } if look.hidden => "hide stencil".to_owned(),
            Self::StencilLook { .. } => "change stencil".to_owned(),
            Self::PartLook { look, .. } if look.hidden => "hide part".to_owned(),
            Self::PartLook { .. } => "change part".to_owned(),
            Self::Several { label, .. } => label.clone(),
        }
    }
}

fn round(edges: &[u32], tolerance_mm: f64, step_deg: f64, least_edge_mm: f64) -> Result<Edit, EditorError> {
    let min_edge = not_negative(least_edge_mm).ok_or(EditorError::LeastEdge(least_edge_mm))?;
    let step = Angle::from_deg(step_deg).map_err(|_| EditorError::ArcStep(step_deg))?;
    Ok(Edit::Round { edges: edge_ids(edges), tolerance: tolerance(tolerance_mm)?, step, min_edge })
}

fn shift(by_mm: [f64; 3]) -> Affine3<f64> {
    Affine3::from_matrix_unchecked(Matrix4::new_translation(&Vector3::from(by_mm)))
}

fn edge_ids(list: &[u32]) -> Vec<EdgeId> {
    list.iter().copied().map(EdgeId).collect()
}

fn not_negative(mm: f64) -> Option<Length> {
    Length::from_mm(mm).ok().filter(|length| *length >= Length::ZERO)
}

fn tolerance(mm: f64) -> Result<Length, EditorError> {
    not_negative(mm).ok_or(EditorError::Tolerance(mm))
}

/// A matrix whose last row is 0 0 0 1.
fn affine(rows: &[[f64; 4]; 4]) -> Result<Affine3<f64>, EditorError> {
    let matrix = Matrix4::from_fn(|row, column| rows[row][column]);
    let affine = rows[3]
        .iter()
        .zip([0.0, 0.0, 0.0, 1.0])
        .all(|(found, expected)| (found - expected).abs() < f64::EPSILON);
    if affine && matrix.iter().all(|number| number.is_finite()) {
        Ok(Affine3::from_matrix_unchecked(matrix))
    } else {
        Err(EditorError::Matrix)
    }
}
