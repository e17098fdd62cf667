//! The two frames of closing: the open wires, and the frame that they are locked to.

use std::collections::BTreeSet;

use nalgebra::{Point3, Vector3};
use petgraph::unionfind::UnionFind;
use wirebend_core::simulate::{BadErrorTerm, ErrorModel};
use wirebend_frame::{
    Arc, Assembly, EndStiffness, Factor, Member, Model, ModelError, NodeId, Section, SectionId, Support,
    Unstable,
};

use super::draw::{Draw, Terms};
use super::misfits::{FrameWire, MisfitSource, sources};
use super::surface::Surface;

/// The sine of an angle below which two struts are on one line.
const ON_ONE_LINE: f64 = 1e-6;

/// Why wires cannot be closed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ClosingError {
    /// A wire passes a vertex that is not there.
    #[error("wire {wire} passes vertex {vertex} of {vertices}")]
    NoVertex {
        /// The wire, from 0.
        wire: usize,
        /// The place of the vertex.
        vertex: usize,
        /// How many there are.
        vertices: usize,
    },
    /// A wire's program has not a strut from each of its vertices to the next.
    #[error("wire {wire} has {struts} struts and a program of {segments}")]
    OtherProgram {
        /// The wire, from 0.
        wire: usize,
        /// Struts between its vertices.
        struts: usize,
        /// Segments of its program.
        segments: usize,
    },
    /// Parts that nothing holds to each other have no common place, from which anything could be off.
    #[error("the frame is in {parts} parts")]
    SeveralParts {
        /// How many.
        parts: usize,
    },
    /// A strut has no length, or a figure of the wire is none.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// The frame does not hold together.
    #[error(transparent)]
    Unstable(#[from] Unstable),
    /// The errors are none.
    #[error(transparent)]
    Errors(#[from] BadErrorTerm),
    /// An exact expectation was asked for with bowed struts, whose stiffness is drawn too.
    #[error("struts bowed at random have no exact expectation")]
    Bowed,
}

/// A strut of a wire, between two passes that follow each other.
#[derive(Debug, Clone, Copy)]
pub(super) struct Strut {
    /// Its ends among the passes of all wires.
    pub passes: [usize; 2],
    /// Its ends among the frame's vertices.
    pub vertices: [usize; 2],
}

/// Wires on the vertices of a frame, ready to be closed again and again.
///
/// A wire that passes a vertex twice has two passes there, which are one only once they are locked.
pub struct ClosingModel {
    pub(super) vertices: Vec<Point3<f64>>,
    pub(super) section: Section,
    pub(super) wires: Vec<FrameWire>,
    /// The vertex of each pass.
    pub(super) passes: Vec<usize>,
    pub(super) struts: Vec<Strut>,
    pub(super) sources: Vec<MisfitSource>,
    /// The wires with each pass held in its place.
    open: Assembly,
    /// The frame, held at a vertex.
    joined: Assembly,
}

/// A model with struts of a shape: its two frames factored.
pub struct Prepared<'a> {
    pub(super) model: &'a ClosingModel,
    pub(super) arcs: Vec<Arc>,
    pub(super) open: Factor<'a>,
    pub(super) joined: Factor<'a>,
}

impl ClosingModel {
    /// Wires of a round section on vertices, mm.
    ///
    /// # Errors
    /// [`ClosingError`] when a wire passes no vertex, its program is that of another, a strut has no length, or the wires share no vertex.
    pub fn new(
        vertices: &[Point3<f64>],
        wires: &[FrameWire],
        section: &Section,
    ) -> Result<Self, ClosingError> {
        let (mut passes, mut struts, mut all) = (Vec::new(), Vec::new(), Vec::new());
        let mut supports = Vec::new();
        for (index, wire) in wires.iter().enumerate() {
            check(index, wire, vertices.len())?;
            let (first_pass, first_strut) = (passes.len(), struts.len());
            passes.extend(&wire.vertices);
            let ways: Vec<Vector3<f64>> =
                wire.vertices.windows(2).map(|pair| vertices[pair[1]] - vertices[pair[0]]).collect();
            struts.extend(wire.vertices.windows(2).enumerate().map(|(k, pair)| Strut {
                passes: [first_pass + k, first_pass + k + 1],
                vertices: [pair[0], pair[1]],
            }));
            let lengths: Vec<f64> = ways.iter().map(Vector3::norm).collect();
            all.extend(sources(wire, index, first_strut, &lengths));
            supports.extend(held(first_pass, &ways));
        }
        let sections = vec![*section];
        let member = |[a, b]: [usize; 2]| Member::new(NodeId(a), NodeId(b), SectionId(0));
        let open = Model {
            nodes: passes.iter().map(|&vertex| vertices[vertex]).collect(),
            members: struts.iter().map(|strut: &Strut| member(strut.passes)).collect(),
            sections: sections.clone(),
            supports,
        };
        let parts = one_of_each_part(vertices.len(), &struts);
        if parts.len() > 1 {
            return Err(ClosingError::SeveralParts { parts: parts.len() });
        }
        let joined = Model {
            nodes: vertices.to_vec(),
            members: struts.iter().map(|strut| member(strut.vertices)).collect(),
            sections,
            supports: parts,
        };
        Ok(Self {
            vertices: vertices.to_vec(),
            section: *section,
            wires: wires.to_vec(),
            passes,
            struts,
            sources: all,
            open: Assembly::new(&open)?,
            joined: Assembly::new(&joined)?,
        })
    }

    /// How many struts there are, doubled ones twice.
    #[must_use]
    pub fn strut_count(&self) -> usize {
        self.struts.len()
    }

    /// The length of the shortest strut, mm.
    #[must_use]
    pub fn shortest_strut(&self) -> f64 {
        self.struts.iter().map(|strut| self.way(strut).norm()).fold(f64::INFINITY, f64::min)
    }

    /// All vertices at which struts end, together: what is off after the motion of the whole that fits them best.
    #[must_use]
    pub fn whole(&self) -> Surface {
        let ends: BTreeSet<usize> = self.struts.iter().flat_map(|strut| strut.vertices).collect();
        Surface::whole(&self.vertices, &ends.into_iter().collect::<Vec<_>>())
    }

    /// The frame with straight struts.
    ///
    /// # Errors
    /// [`ClosingError::Unstable`] when it does not hold together.
    pub fn straight(&self) -> Result<Prepared<'_>, ClosingError> {
        self.prepared(&[])
    }

    /// The frame as a wire was drawn.
    ///
    /// # Errors
    /// [`ClosingError::Unstable`] when it does not hold together.
    pub fn bowed(&self, draw: &Draw) -> Result<Prepared<'_>, ClosingError> {
        self.prepared(&draw.rises)
    }

    /// The wire of a number that machines with such errors make, by a seed.
    ///
    /// # Errors
    /// [`ClosingError::Errors`] when a figure is none.
    pub fn draw(&self, errors: &ErrorModel, seed: u64, run: u64) -> Result<Draw, ClosingError> {
        let struts: Vec<Vector3<f64>> = self.struts.iter().map(|strut| self.way(strut)).collect();
        Ok(Terms::new(errors)?.draw(seed, run, &self.sources, &struts))
    }

    fn prepared(&self, rises: &[Vector3<f64>]) -> Result<Prepared<'_>, ClosingError> {
        let arc = |(k, strut): (usize, &Strut)| {
            let [a, b] = strut.vertices.map(|vertex| self.vertices[vertex]);
            Arc::new(a, b, rises.get(k).copied().unwrap_or_default(), &self.section)
        };
        let arcs: Vec<Arc> = self.struts.iter().enumerate().map(arc).collect();
        let stiffness: Vec<EndStiffness> = arcs.iter().map(|arc| *arc.stiffness()).collect();
        let open = self.open.factor_with(&self.open.all(), &stiffness)?;
        let joined = self.joined.factor_with(&self.joined.all(), &stiffness)?;
        Ok(Prepared { model: self, arcs, open, joined })
    }

    pub(super) fn way(&self, strut: &Strut) -> Vector3<f64> {
        let [a, b] = strut.vertices.map(|vertex| self.vertices[vertex]);
        b - a
    }
}

fn check(index: usize, wire: &FrameWire, vertices: usize) -> Result<(), ClosingError> {
    if let Some(&vertex) = wire.vertices.iter().find(|&&vertex| vertex >= vertices) {
        return Err(ClosingError::NoVertex { wire: index, vertex, vertices });
    }
    let struts = wire.vertices.len().saturating_sub(1);
    let spans = &wire.program.spans;
    let segments = spans.last().map_or(0, |span| span.end);
    let in_order = spans.windows(2).all(|pair| pair[0].end == pair[1].start);
    if segments == struts && in_order && spans.len() == wire.program.steps.len() && struts > 0 {
        Ok(())
    } else {
        Err(ClosingError::OtherProgram { wire: index, struts, segments })
    }
}

/// What holds the passes of a wire, counted from `first`, in their places. A wire on one line could still spin about it: that is held
/// where it begins, by the turn that is the most of it, which resists nothing else.
fn held(first: usize, ways: &[Vector3<f64>]) -> Vec<Support> {
    let mut supports: Vec<Support> =
        (first..=first + ways.len()).map(|pass| Support::pinned(NodeId(pass))).collect();
    let along = ways.first().map(Vector3::normalize).unwrap_or_default();
    let straight = ways.iter().all(|way| along.cross(way).norm() <= ON_ONE_LINE * way.norm());
    if let Some(start) = supports.first_mut().filter(|_| straight) {
        start.fixed[3 + along.iamax()] = true;
    }
    supports
}

/// One vertex of each part, held altogether: that keeps the frame in its place and resists nothing, since what closes it is in balance.
fn one_of_each_part(vertices: usize, struts: &[Strut]) -> Vec<Support> {
    let mut parts = UnionFind::<usize>::new(vertices);
    for strut in struts {
        parts.union(strut.vertices[0], strut.vertices[1]);
    }
    let mut first = vec![None; vertices];
    for vertex in struts.iter().flat_map(|strut| strut.vertices) {
        first[parts.find(vertex)].get_or_insert(vertex);
    }
    first.into_iter().flatten().map(|vertex| Support::clamped(NodeId(vertex))).collect()
}
