//! Where the struts of a frame go: under load, as they vibrate, and once their wires are closed; for a view that draws them.
//!
//! Displacements are given along each strut at true scale, so that a view enlarges them by a factor and computes nothing.

use nalgebra::{Point3, Vector3};
use schemars::JsonSchema;
use serde::Serialize;
use wirebend_frame::{Load, MemberId, Model, Response};

use super::structure::Structure;

/// Points along a strut, both ends among them.
pub(super) const POINTS: usize = 9;

/// Displacements of the points of each strut, mm, strut by strut.
pub type StrutShape = Vec<Vec<[f64; 3]>>;

/// The struts of a frame, and where they go.
#[derive(Debug, Clone, Default, PartialEq, Serialize, JsonSchema)]
pub struct FrameShapes {
    /// By edge.
    pub struts: Vec<StrutLine>,
    /// Under what acts on the frame; null where it floats or does not stand.
    pub loaded: Option<StrutShape>,
    /// Of each mode, the largest displacement 1 mm.
    pub modes: Vec<StrutShape>,
    /// The wires with the errors of the first drawn wire; null where joints are not closed, or no wire was drawn.
    pub closed: Option<ClosedShapes>,
}

/// A strut as it is drawn.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct StrutLine {
    pub edge: u32,
    /// Points along it, mm.
    pub at_mm: Vec<[f64; 3]>,
}

/// Wires with errors, before and after their joints are closed.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct ClosedShapes {
    /// As the machine bends them: each wire lies where it begins, and its passes through a vertex do not meet.
    pub made: Vec<MadeLine>,
    /// Closed, after the motion of the whole that fits the drawing best.
    pub closed: StrutShape,
    /// The largest displacement of a vertex then, and the vertex.
    pub max_closed_mm: f64,
    pub at_vertex: u32,
    /// The largest distance of a pass from its vertex as made, and that vertex.
    pub max_made_mm: f64,
    pub made_at_vertex: u32,
}

/// A wire, pass by pass.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MadeLine {
    /// The vertices that it passes, mm.
    pub at_mm: Vec<[f64; 3]>,
    /// How far each pass is from there, mm.
    pub by_mm: Vec<[f64; 3]>,
}

impl Structure {
    pub(super) fn lines(&self) -> Vec<StrutLine> {
        let model = self.assembly.model();
        let struts = self.edges.iter().zip(&model.members);
        let lines = struts.map(|(edge, member)| {
            let (a, b) = (model.nodes[member.a.0], model.nodes[member.b.0]);
            StrutLine {
                edge: edge.0,
                at_mm: shares().map(|share| (a + (b - a) * share).coords.into()).collect(),
            }
        });
        lines.collect()
    }

    /// Struts under load: bent as their ends are moved and turned, and hanging between them under what acts along them.
    pub(super) fn loaded(&self, load: &Load, response: &Response) -> StrutShape {
        let model = self.assembly.model();
        let members = (0..model.members.len()).map(MemberId);
        let struts = members.map(|id| {
            let strut = Strut::of(model, id);
            let ends = [strut.member.a, strut.member.b].map(|node| &response.displacements[node.0]);
            let section = self.assembly.section(id);
            let along: Vector3<f64> =
                load.line.iter().filter(|line| line.member == id).map(|line| line.force).sum();
            let across = strut.across(&(along + load.gravity * (section.density * section.area)));
            // w = q L⁴/(24 E I) s²(1 - s)², a strut clamped at both ends.
            let axes = self.assembly.axes(id);
            let sag: Vector3<f64> = [(1, section.iz), (2, section.iy)]
                .into_iter()
                .map(|(row, i)| {
                    let way = axes.row(row).transpose();
                    way * (across.dot(&way) * strut.length.powi(4) / (24.0 * section.e * i))
                })
                .sum();
            let at = |share: f64| strut.bent(ends, share) + sag * (share * (1.0 - share)).powi(2);
            shares().map(|share| at(share).into()).collect()
        });
        struts.collect()
    }

    /// A mode of the model whose struts are cut into pieces, the largest displacement 1 mm.
    pub(super) fn vibrating(&self, cut: &Model, pieces: usize, shape: &[[f64; 6]]) -> StrutShape {
        let struts = (0..self.edges.len()).map(|strut| {
            let points = shares().map(|share| {
                #[allow(clippy::cast_precision_loss, reason = "pieces are few")]
                let along = share * pieces as f64;
                #[allow(
                    clippy::cast_possible_truncation,
                    clippy::cast_sign_loss,
                    reason = "between 0 and the pieces"
                )]
                let piece = (along as usize).min(pieces - 1);
                let part = Strut::of(cut, MemberId(strut * pieces + piece));
                let ends = [part.member.a, part.member.b].map(|node| &shape[node.0]);
                #[allow(clippy::cast_precision_loss, reason = "pieces are few")]
                part.bent(ends, along - piece as f64)
            });
            points.collect::<Vec<Vector3<f64>>>()
        });
        let struts: Vec<Vec<Vector3<f64>>> = struts.collect();
        let largest = struts.iter().flatten().map(Vector3::norm).fold(0.0, f64::max);
        let factor = if largest > 0.0 { 1.0 / largest } else { 0.0 };
        struts.into_iter().map(|points| points.into_iter().map(|at| (at * factor).into()).collect()).collect()
    }

    /// Struts that stay straight between vertices that move.
    pub(super) fn straight(&self, moved: &[Vector3<f64>]) -> StrutShape {
        let of = |node: usize| moved.get(node).copied().unwrap_or_default();
        let members = self.assembly.model().members.iter();
        let struts = members.map(|member| {
            let (a, b) = (of(member.a.0), of(member.b.0));
            shares().map(|share| (a + (b - a) * share).into()).collect()
        });
        struts.collect()
    }
}

/// From 0 at the beginning of a strut to 1 at its end.
fn shares() -> impl Iterator<Item = f64> {
    #[allow(clippy::cast_precision_loss, reason = "points are few")]
    (0..POINTS).map(|k| k as f64 / (POINTS - 1) as f64)
}

/// A straight member.
struct Strut {
    member: wirebend_frame::Member,
    along: Vector3<f64>,
    length: f64,
}

impl Strut {
    fn of(model: &Model, id: MemberId) -> Self {
        let member = model.members[id.0];
        let way: Vector3<f64> = model.nodes[member.b.0] - model.nodes[member.a.0];
        Self { member, along: way.normalize(), length: way.norm() }
    }

    fn across(&self, way: &Vector3<f64>) -> Vector3<f64> {
        way - self.along * way.dot(&self.along)
    }

    /// How far it has moved at a share of its length: cubic across, as its ends are moved and turned, and even along.
    fn bent(&self, [a, b]: [&[f64; 6]; 2], share: f64) -> Vector3<f64> {
        let moved = |end: &[f64; 6]| Vector3::new(end[0], end[1], end[2]);
        let slope = |end: &[f64; 6]| Vector3::new(end[3], end[4], end[5]).cross(&self.along) * self.length;
        let (from, to, s) = (moved(a), moved(b), share);
        let even = from + (to - from) * s;
        let cubic = from * (1.0 - 3.0 * s * s + 2.0 * s * s * s)
            + slope(a) * (s - 2.0 * s * s + s * s * s)
            + to * (3.0 * s * s - 2.0 * s * s * s)
            + slope(b) * (s * s * s - s * s);
        self.along * even.dot(&self.along) + self.across(&cubic)
    }
}

/// The wires as they are made, and the largest distance of a pass from its vertex, with that vertex as an index.
pub(super) fn made_lines(
    points: &[Point3<f64>],
    wires: &[Vec<(usize, Point3<f64>)>],
) -> (Vec<MadeLine>, (usize, f64)) {
    let mut farthest = (0, 0.0);
    let lines = wires.iter().map(|wire| {
        let mut line = MadeLine { at_mm: Vec::new(), by_mm: Vec::new() };
        for &(vertex, made) in wire {
            let by = made - points[vertex];
            if by.norm() > farthest.1 {
                farthest = (vertex, by.norm());
            }
            line.at_mm.push(points[vertex].coords.into());
            line.by_mm.push(by.into());
        }
        line
    });
    (lines.collect(), farthest)
}

#[cfg(test)]
mod tests {
    use super::*;
    use wirebend_frame::{Assembly, Material, Member, NodeId, Section, SectionId, Support};

    /// A strut of 1 m, its first node held.
    fn beam(supports: &[usize]) -> (Structure, f64) {
        let material = Material { e: 2.0e5, g: 8.0e4, density: 7.8e-9, yield_strength: 300.0 };
        let section = Section::round(2.0, &material);
        let model = Model {
            nodes: vec![Point3::origin(), Point3::new(1000.0, 0.0, 0.0)],
            members: vec![Member::new(NodeId(0), NodeId(1), SectionId(0))],
            sections: vec![section],
            supports: supports.iter().map(|&node| Support { node: NodeId(node), fixed: [true; 6] }).collect(),
        };
        let q = material.density * section.area * 9806.65;
        let deflection = q * 1000.0_f64.powi(4) / (material.e * section.iy);
        let structure = Structure {
            assembly: Assembly::new(&model).unwrap(),
            vertices: Vec::new(),
            edges: vec![wirebend_core::wireframe::EdgeId(0)],
            held: true,
            joints: Vec::new(),
        };
        (structure, deflection)
    }

    fn middle_and_end(supports: &[usize]) -> (f64, f64, f64) {
        let (structure, deflection) = beam(supports);
        let load = Load { gravity: Vector3::new(0.0, 0.0, -9806.65), ..Load::default() };
        let assembly = &structure.assembly;
        let response = assembly.factor(&assembly.all()).unwrap().solve(&load).unwrap();
        let shape = structure.loaded(&load, &response);
        (shape[0][4][2] / -deflection, shape[0][8][2] / -deflection, deflection)
    }

    /// Textbook: q L⁴/(384 E I) amid a strut that is clamped at both ends, q L⁴/(8 E I) at the end of a cantilever, of which
    /// 17/48 amid it.
    #[test]
    fn a_strut_hangs_as_a_beam_does() {
        let (amid, end, _) = middle_and_end(&[0, 1]);
        assert!((amid - 1.0 / 384.0).abs() < 1e-9 && end.abs() < 1e-12, "{amid} {end}");
        let (amid, end, _) = middle_and_end(&[0]);
        assert!((end - 1.0 / 8.0).abs() < 1e-9 && (amid - 17.0 / 384.0).abs() < 1e-9, "{amid} {end}");
    }

    #[test]
    fn a_pass_is_as_far_off_as_it_was_made() {
        let points = [Point3::origin(), Point3::new(10.0, 0.0, 0.0)];
        let wire = vec![(0, Point3::new(0.0, 0.0, 1.0)), (1, Point3::new(10.0, 3.0, 4.0))];
        let (lines, farthest) = made_lines(&points, &[wire]);
        assert_eq!(farthest, (1, 5.0));
        assert_eq!(lines[0].by_mm, [[0.0, 0.0, 1.0], [0.0, 3.0, 4.0]]);
    }
}
