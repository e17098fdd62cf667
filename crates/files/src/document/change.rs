//! The exact difference between two states of a document: what undo, redo and a journal keep.

use std::collections::BTreeMap;

use wirebend_core::wireframe::{Change, Delta, EdgeId, StaleDelta, VertexId};

use super::collision::CollisionSettings;
use super::construction::ConstructionLine;
use super::ids::{Pin, PinTarget, StencilId};
use super::look::Look;
use super::part::{PartLook, after_edit, with_look};
use super::pause::PausePoint;
use super::project::{Document, WireCount};
use super::snapshot::ProfileSnapshot;
use super::stencil::{PlacedStencil, StencilSource};
use super::walk::Walk;
use crate::length_unit::LengthUnit;

/// A value before and after.
#[derive(Debug, Clone, PartialEq)]
pub struct Replaced<T> {
    pub before: T,
    /// As it becomes.
    pub after: T,
}

/// A change was committed to a document that it was not made for.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum StaleChange {
    /// Its wireframe is another.
    #[error(transparent)]
    Wireframe(#[from] StaleDelta),
    /// Another part is.
    #[error("the {0} of the document is not as this change found it")]
    Part(&'static str),
}

macro_rules! parts {
    ($($(#[$doc:meta])* $part:ident, $set:ident: $type:ty,)*) => {
        /// A difference: what changes, from what, to what. All but the wireframe changes as a whole.
        #[derive(Debug, Clone, PartialEq)]
        pub struct DocumentChange {
            pub wireframe: Delta,
            /// Surfaces that come, go or are others. Only these are named: they may be large.
            pub surfaces: BTreeMap<StencilId, Change<StencilSource>>,
            $($(#[$doc])* pub $part: Option<Box<Replaced<$type>>>,)*
        }

        impl DocumentChange {
            /// A change of the wireframe alone.
            #[must_use]
            pub const fn of_wireframe(wireframe: Delta) -> Self {
                Self { wireframe, surfaces: BTreeMap::new(), $($part: None,)* }
            }

            /// The difference that leads back.
            #[must_use]
            pub fn inverse(&self) -> Self {
                let surfaces = self.surfaces.iter().map(|(id, change)| (*id, change.inverse())).collect();
                Self {
                    wireframe: self.wireframe.inverse(),
                    surfaces,
                    $($part: back(self.$part.as_deref()),)*
                }
            }

            /// The same with the parts of another change that it leaves as they are. Both are for the same document, and
            /// one at most changes its wireframe.
            #[must_use]
            pub fn and(self, other: Self) -> Self {
                let wireframe = if self.wireframe.is_empty() { other.wireframe } else { self.wireframe };
                let surfaces = if self.surfaces.is_empty() { other.surfaces } else { self.surfaces };
                Self { wireframe, surfaces, $($part: self.$part.or(other.$part),)* }
            }

            /// Whether nothing changes.
            #[must_use]
            pub fn is_empty(&self) -> bool {
                self.wireframe.is_empty() && self.surfaces.is_empty() $(&& self.$part.is_none())*
            }
        }

        impl Document {
            /// Commits a difference. On success the document is exactly what the difference says; on failure it is
            /// untouched.
            ///
            /// # Errors
            /// [`StaleChange`] when the document is not the one that the difference was made for.
            pub fn commit(&mut self, change: &DocumentChange) -> Result<(), StaleChange> {
                $(if change.$part.as_ref().is_some_and(|swap| swap.before != self.$part) {
                    return Err(StaleChange::Part(stringify!($part)));
                })*
                if change.surfaces.iter().any(|(id, swap)| swap.before.as_ref() != self.surfaces.get(id)) {
                    return Err(StaleChange::Part("surfaces"));
                }
                self.wireframe.commit(&change.wireframe)?;
                for (id, swap) in &change.surfaces {
                    match &swap.after {
                        Some(surface) => self.surfaces.insert(*id, surface.clone()),
                        None => self.surfaces.remove(id),
                    };
                }
                $(if let Some(swap) = &change.$part {
                    self.$part.clone_from(&swap.after);
                })*
                Ok(())
            }

            $(#[doc = concat!("The change that sets `", stringify!($part), "`; none where it is so already.")]
            #[must_use]
            pub fn $set(&self, after: $type) -> Option<DocumentChange> {
                if after == self.$part {
                    return None;
                }
                let swap = Replaced { before: self.$part.clone(), after };
                let change = DocumentChange::of_wireframe(Delta::none(&self.wireframe));
                Some(DocumentChange { $part: Some(Box::new(swap)), ..change })
            })*
        }
    };
}

parts! {
    /// The stencils but for their surfaces.
    stencils, set_stencils: Vec<PlacedStencil>,
    /// How parts look.
    parts, set_parts: Vec<PartLook>,
    /// Lines that are no wire.
    construction, set_construction: Vec<ConstructionLine>,
    machine, set_machine: Option<ProfileSnapshot>,
    material, set_material: Option<ProfileSnapshot>,
    /// Edges that may be laid twice.
    doublings, set_doublings: Vec<EdgeId>,
    /// Where the wire starts.
    start, set_start: Option<VertexId>,
    /// How many wires there may be.
    wires, set_wires: WireCount,
    /// Whether the wire ends where it starts.
    closed, set_closed: bool,
    /// Whether the wire runs the other way.
    reversed, set_reversed: bool,
    /// The walks of the wires, where they were chosen.
    walks, set_walks: Vec<Walk>,
    /// How collisions are looked for.
    collisions, set_collisions: CollisionSettings,
    /// Remarks pinned to places.
    pins, set_pins: Vec<Pin>,
    /// Where the machine waits for a person.
    pauses, set_pauses: Vec<PausePoint>,
    /// Remarks on the whole.
    notes, set_notes: String,
    /// The unit that lengths are shown in.
    units, set_units: LengthUnit,
}

impl DocumentChange {
    /// A change of the wireframe, and of whatever points at a vertex or an edge that it takes away.
    #[must_use]
    pub fn of_edit(document: &Document, wireframe: Delta) -> Self {
        let gone_vertex =
            |id: VertexId| wireframe.vertices.get(&id).is_some_and(|change| change.after.is_none());
        let gone_edge = |id: EdgeId| wireframe.edges.get(&id).is_some_and(|change| change.after.is_none());
        let gone = |on: PinTarget| match on {
            PinTarget::Vertex(id) => gone_vertex(id),
            PinTarget::Edge(id) => gone_edge(id),
        };
        let doublings = kept(&document.doublings, |id| !gone_edge(*id));
        let pins = kept(&document.pins, |pin| !gone(pin.on));
        let pauses = kept(&document.pauses, |pause| !gone_vertex(pause.vertex));
        let start = document.start.filter(|id| gone_vertex(*id));
        let start = start.map(|id| Box::new(Replaced { before: Some(id), after: None }));
        // A walk without one of its edges is none, and what is left of the others is not the design.
        let is_broken = |walk: &Walk| gone_vertex(walk.start) || walk.edges.iter().any(|id| gone_edge(*id));
        let broken = document.walks.iter().any(is_broken);
        let walks = broken.then(|| Box::new(Replaced { before: document.walks.clone(), after: Vec::new() }));
        let parts = after_edit(&document.parts, &document.wireframe, &wireframe);
        let parts = (parts != document.parts)
            .then(|| Box::new(Replaced { before: document.parts.clone(), after: parts }));
        Self { parts, doublings, start, walks, pins, pauses, ..Self::of_wireframe(wireframe) }
    }
}

impl Document {
    /// The change that puts a surface into the document, as a stencil that lies as in its file.
    #[must_use]
    pub fn with_stencil(&self, name: String, surface: StencilSource) -> DocumentChange {
        let id = self.next_stencil();
        let mut stencils = self.stencils.clone();
        stencils.push(PlacedStencil::new(id, name));
        self.with_stencils(stencils, id, Change { before: None, after: Some(surface) })
    }

    /// The change that takes a stencil away; none where it is not there.
    #[must_use]
    pub fn without_stencil(&self, id: StencilId) -> Option<DocumentChange> {
        let before = self.surfaces.get(&id)?.clone();
        let stencils = self.stencils.iter().filter(|stencil| stencil.id != id).cloned().collect();
        Some(self.with_stencils(stencils, id, Change { before: Some(before), after: None }))
    }

    fn with_stencils(
        &self,
        after: Vec<PlacedStencil>,
        id: StencilId,
        surface: Change<StencilSource>,
    ) -> DocumentChange {
        let stencils = Some(Box::new(Replaced { before: self.stencils.clone(), after }));
        let surfaces = BTreeMap::from([(id, surface)]);
        DocumentChange { surfaces, stencils, ..DocumentChange::of_wireframe(Delta::none(&self.wireframe)) }
    }

    /// The change that makes the surfaces those of another state of the document; none where they are.
    #[must_use]
    pub fn set_surfaces(&self, after: &BTreeMap<StencilId, StencilSource>) -> Option<DocumentChange> {
        let ids = self.surfaces.keys().chain(after.keys());
        let surfaces: BTreeMap<_, _> = ids
            .map(|id| (*id, Change { before: self.surfaces.get(id).cloned(), after: after.get(id).cloned() }))
            .filter(|(_, change)| change.before != change.after)
            .collect();
        (!surfaces.is_empty()).then(|| DocumentChange {
            surfaces,
            ..DocumentChange::of_wireframe(Delta::none(&self.wireframe))
        })
    }

    /// The change of how the part looks that an edge belongs to; none where it looks so already.
    #[must_use]
    pub fn set_part_look(&self, edge: EdgeId, look: Look) -> Option<DocumentChange> {
        self.set_parts(with_look(&self.parts, &self.wireframe, edge, look))
    }
}

/// The change that leaves out what is not to be kept; none where all is.
fn kept<T: Clone>(all: &[T], keep: impl Fn(&T) -> bool) -> Option<Box<Replaced<Vec<T>>>> {
    let after: Vec<T> = all.iter().filter(|one| keep(one)).cloned().collect();
    (after.len() < all.len()).then(|| Box::new(Replaced { before: all.to_vec(), after }))
}

fn back<T: Clone>(swap: Option<&Replaced<T>>) -> Option<Box<Replaced<T>>> {
    swap.map(|Replaced { before, after }| Box::new(Replaced { before: after.clone(), after: before.clone() }))
}
