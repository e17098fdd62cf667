//! A drawn wire pulled to the vertices of its frame, locked there and let go.

use nalgebra::{Point3, Vector3};
use wirebend_frame::Arc;

use super::draw::{Draw, gap, made};
use super::misfits::MisfitSource;
use super::model::{Prepared, Strut};
use super::surface::Surface;

/// Displacements and rotations, or forces and moments, of both ends of a strut.
type Ends = [f64; 12];

/// How joints are closed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Closing {
    /// Each pass is pulled to its vertex and free to turn there; then the passes of a vertex are locked, and all is let go. So do the
    /// authors, and so does a person with snap-fits. That the surface then is about half as far off as linear theory has it comes of
    /// this order and of bows of 3 %: with both it is reproduced.
    #[default]
    Aligned,
    /// The joints are rigid from the start.
    Coupled,
}

/// A closed frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Closed {
    /// Of each vertex, mm. The frame is held somewhere: only [`Surface`] makes figures of them.
    pub displacements: Vec<Vector3<f64>>,
    /// The force along the chord of each strut, N, tension positive.
    pub axial: Vec<f64>,
    /// Of each strut the mean square of its von Mises stress over four points of the surface at 20 places, in the square of MPa.
    pub von_mises_squares: Vec<f64>,
    /// The forces that pull each pass to its vertex while it is aligned, N; none where joints are rigid from the start.
    pub pulls: Option<Vec<f64>>,
    /// What is stored in the wire: when it is aligned, or in the frame where joints are rigid from the start; N mm.
    pub energy: f64,
}

impl Closed {
    /// RMS over the struts, N.
    #[must_use]
    pub fn axial_rms(&self) -> f64 {
        mean(self.axial.iter().map(|force| force * force)).sqrt()
    }

    /// RMS over the struts, MPa.
    #[must_use]
    pub fn von_mises_rms(&self) -> f64 {
        mean(self.von_mises_squares.iter().copied()).sqrt()
    }

    /// The largest force that pulls a pass to its vertex, N.
    #[must_use]
    pub fn largest_pull(&self) -> Option<f64> {
        self.pulls.as_ref().map(|pulls| pulls.iter().copied().fold(0.0, f64::max))
    }

    /// How far the surface is off, mm: see [`Surface::rms`].
    #[must_use]
    pub fn surface_rms(&self, surface: &Surface) -> f64 {
        surface.rms(&self.displacements)
    }
}

#[allow(clippy::cast_precision_loss)] // struts are far fewer than 2^52
pub(super) fn mean(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = values.len().max(1);
    values.sum::<f64>() / count as f64
}

impl Prepared<'_> {
    /// Closes the wires of a draw, whose struts are bowed as these are.
    #[must_use]
    pub fn close(&self, closing: Closing, draw: &Draw) -> Closed {
        let own = self.own_ends(self.model.sources.iter().zip(draw.amounts.iter().copied()));
        let mut closed = self.close_all(closing, vec![own]);
        closed.pop().unwrap_or_else(|| Closed::nothing(self.model.vertices.len()))
    }

    /// How far the passes through one vertex, of one wire or of several, are apart at most before they are closed, mm. None where no
    /// vertex is passed twice.
    #[must_use]
    pub fn gap(&self, draw: &Draw) -> Option<f64> {
        gap(self.made(draw).into_iter().flatten().collect())
    }

    /// Of each wire the vertices that it passes, as indices, and where its motions leave those passes one after the other, mm, before
    /// anything pulls.
    #[must_use]
    pub fn made(&self, draw: &Draw) -> Vec<Vec<(usize, Point3<f64>)>> {
        let model = self.model;
        let wires = model.wires.iter().enumerate();
        let passes = wires.map(|(index, wire)| {
            let at = made(wire, index, &model.vertices, &model.sources, draw);
            wire.vertices.iter().copied().zip(at).collect()
        });
        passes.collect()
    }

    /// Where the ends of each strut are without stress, seen from the drawing.
    pub(super) fn own_ends<'s>(&self, amounts: impl Iterator<Item = (&'s MisfitSource, f64)>) -> Vec<Ends> {
        let mut ends = vec![[0.0; 12]; self.model.struts.len()];
        for (source, amount) in amounts {
            for change in &source.changes {
                let along = self.model.way(&self.model.struts[change.strut]).normalize();
                let ends = &mut ends[change.strut];
                let mut add = |at: usize, way: Vector3<f64>| {
                    ends.iter_mut().skip(at).zip(&way).for_each(|(end, way)| *end += way * amount);
                };
                add(3, change.turned[0]);
                add(6, -along * change.extra_length);
                add(9, change.turned[1]);
            }
        }
        ends
    }

    /// Closes several at once.
    pub(super) fn close_all(&self, closing: Closing, own: Vec<Vec<Ends>>) -> Vec<Closed> {
        let (aligned, pulls) = match closing {
            Closing::Coupled => (own, Vec::new()),
            Closing::Aligned => self.aligned(&own),
        };
        // Locked and let go: what pulled at the passes is gone, and so is what the joints took.
        let vertices = self.model.vertices.len();
        let loads: Vec<_> =
            aligned.iter().map(|ends| self.resisted(ends, vertices, |strut| strut.vertices)).collect();
        let moved = self.joined.displacements(&loads);
        let mut pulls = pulls.into_iter();
        let closed = aligned.iter().zip(&moved);
        closed.map(|(aligned, moved)| self.closed(aligned, pulls.next(), moved)).collect()
    }

    /// The ends of struts whose passes are pulled to their vertices and turn freely there, and the forces that pull, of each pass.
    fn aligned(&self, own: &[Vec<Ends>]) -> (Vec<Vec<Ends>>, Vec<Vec<f64>>) {
        let passes = self.model.passes.len();
        let loads: Vec<_> = own.iter().map(|own| self.resisted(own, passes, |strut| strut.passes)).collect();
        let turned = self.open.displacements(&loads);
        let aligned = own.iter().zip(&turned).map(|(own, moved)| {
            let ends = self.with_moved(own, moved, |strut| strut.passes);
            let held = self.resisted(&ends, passes, |strut| strut.passes);
            let pulls = held.iter().map(|f| Vector3::new(f[0], f[1], f[2]).norm()).collect();
            (ends, pulls)
        });
        aligned.unzip()
    }

    fn closed(&self, aligned: &[Ends], pulls: Option<Vec<f64>>, moved: &[[f64; 6]]) -> Closed {
        let ends = self.with_moved(aligned, moved, |strut| strut.vertices);
        let struts = self.model.struts.iter().zip(&self.arcs).zip(&ends);
        let mut closed = Closed {
            displacements: moved.iter().map(|u| Vector3::new(u[0], u[1], u[2])).collect(),
            pulls,
            ..Closed::nothing(0)
        };
        for ((strut, arc), ends) in struts {
            let forces = arc.end_forces(ends);
            let along = self.model.way(strut).normalize();
            closed.axial.push(along.dot(&Vector3::new(forces[6], forces[7], forces[8])));
            closed.von_mises_squares.push(arc.mean_stress_square(&forces));
        }
        let stored = if closed.pulls.is_some() { aligned } else { &ends };
        let energy = |(ends, arc): (&Ends, &Arc)| {
            arc.end_forces(ends).iter().zip(ends).map(|(force, way)| force * way).sum::<f64>() / 2.0
        };
        closed.energy = stored.iter().zip(&self.arcs).map(energy).sum();
        closed
    }

    /// The ends of struts after the nodes have moved.
    fn with_moved(
        &self,
        own: &[Ends],
        moved: &[[f64; 6]],
        nodes: impl Fn(&Strut) -> [usize; 2],
    ) -> Vec<Ends> {
        let struts = self.model.struts.iter().zip(own);
        let ends = struts.map(|(strut, own)| {
            let mut ends = *own;
            for (node, from) in nodes(strut).into_iter().zip([0, 6]) {
                ends[from..].iter_mut().zip(&moved[node]).for_each(|(end, moved)| *end += moved);
            }
            ends
        });
        ends.collect()
    }

    /// What struts whose ends are so do to the nodes: forces and moments of each.
    fn resisted(&self, ends: &[Ends], nodes: usize, of: impl Fn(&Strut) -> [usize; 2]) -> Vec<[f64; 6]> {
        let mut loads = vec![[0.0; 6]; nodes];
        for ((strut, arc), ends) in self.model.struts.iter().zip(&self.arcs).zip(ends) {
            if ends.iter().all(|&x| x == 0.0) {
                continue;
            }
            let forces = arc.end_forces(ends);
            for (node, from) in of(strut).into_iter().zip([0, 6]) {
                loads[node].iter_mut().zip(&forces[from..]).for_each(|(load, force)| *load -= force);
            }
        }
        loads
    }
}

impl Closed {
    /// A frame that nothing was done to.
    fn nothing(vertices: usize) -> Self {
        Self {
            displacements: vec![Vector3::zeros(); vertices],
            axial: Vec::new(),
            von_mises_squares: Vec::new(),
            pulls: None,
            energy: 0.0,
        }
    }
}
