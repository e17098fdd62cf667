//! The exact difference between two states of a document: what undo, redo and a journal keep.

use wirebend_core::wireframe::{Delta, EdgeId, StaleDelta, VertexId};

use super::ids::{Pin, PinTarget};
use super::pause::PausePoint;
use super::project::{Document, WireCount};
use super::snapshot::ProfileSnapshot;
use super::stencil::StencilSource;
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
            $($(#[$doc])* pub $part: Option<Box<Replaced<$type>>>,)*
        }

        impl DocumentChange {
            /// A change of the wireframe alone.
            #[must_use]
            pub const fn of_wireframe(wireframe: Delta) -> Self {
                Self { wireframe, $($part: None,)* }
            }

            /// The difference that leads back.
            #[must_use]
            pub fn inverse(&self) -> Self {
                Self { wireframe: self.wireframe.inverse(), $($part: back(self.$part.as_deref()),)* }
            }

            /// The same with the parts of another change that it leaves as they are. Both are for the same document, and
            /// one at most changes its wireframe.
            #[must_use]
            pub fn and(self, other: Self) -> Self {
                let wireframe = if self.wireframe.is_empty() { other.wireframe } else { self.wireframe };
                Self { wireframe, $($part: self.$part.or(other.$part),)* }
            }

            /// Whether nothing changes.
            #[must_use]
            pub fn is_empty(&self) -> bool {
                self.wireframe.is_empty() $(&& self.$part.is_none())*
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
                self.wireframe.commit(&change.wireframe)?;
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
    stencil, set_stencil: Option<StencilSource>,
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
        Self { doublings, start, walks, pins, pauses, ..Self::of_wireframe(wireframe) }
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
