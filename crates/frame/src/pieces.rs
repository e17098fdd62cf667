//! Members cut into pieces, so that they can bend between their ends when they vibrate.

use nalgebra::Vector3;

use crate::arc::Arc;
use crate::model::{Member, Model, NodeId};

/// A model whose members are cut into pieces of equal length.
#[derive(Debug, Clone, PartialEq)]
pub struct Pieces {
    /// The nodes of the model it is made of come first, in their order; the pieces of a member follow each other.
    pub model: Model,
    /// Of each piece, the member that it is cut from.
    pub struts: Vec<usize>,
}

impl Pieces {
    /// Cuts every member of a model into so many pieces; none means one.
    #[must_use]
    pub fn new(model: &Model, pieces: usize) -> Self {
        Self::bowed(model, pieces, &[])
    }

    /// The same along circular arcs: the middle of each member is so far from that of its chord, mm, of which only what is across
    /// the chord counts. Members beyond the end of `rises` are straight, and so are those without length or section.
    ///
    /// A chain of chords is stiffer along itself than the arc: with 4 pieces the lowest mode of a truss is 1 to 2 % high, with 9 it
    /// is not.
    #[must_use]
    pub fn bowed(model: &Model, pieces: usize, rises: &[Vector3<f64>]) -> Self {
        let mut cut = Model {
            nodes: model.nodes.clone(),
            members: Vec::with_capacity(model.members.len() * pieces.max(1)),
            sections: model.sections.clone(),
            supports: model.supports.clone(),
        };
        let mut struts = Vec::with_capacity(cut.members.capacity());
        for (strut, member) in model.members.iter().enumerate() {
            let arc = rises.get(strut).and_then(|rise| arc_of(model, member, *rise));
            let mut from = member.a;
            for piece in 1..=pieces.max(1) {
                let to = if piece == pieces.max(1) {
                    member.b
                } else {
                    cut.between(member, arc.as_ref(), piece, pieces)
                };
                cut.members.push(Member { a: from, b: to, ..*member });
                struts.push(strut);
                from = to;
            }
        }
        Self { model: cut, struts }
    }
}

/// The arc that a member is, where it is one.
fn arc_of(model: &Model, member: &Member, rise: Vector3<f64>) -> Option<Arc> {
    let (a, b) = (model.nodes.get(member.a.0)?, model.nodes.get(member.b.0)?);
    let section = model.sections.get(member.section.0)?;
    (a != b && rise != Vector3::zeros()).then(|| Arc::new(*a, *b, rise, section))
}

impl Model {
    /// A new node at a share of a member. A member with an unknown end has none; its end is kept, for the check of the model.
    fn between(&mut self, member: &Member, arc: Option<&Arc>, piece: usize, pieces: usize) -> NodeId {
        let (Some(a), Some(b)) = (self.nodes.get(member.a.0), self.nodes.get(member.b.0)) else {
            return member.a;
        };
        #[allow(clippy::cast_precision_loss, reason = "pieces are few")]
        let share = piece as f64 / pieces as f64;
        let place = arc.map_or_else(|| a + (b - a) * share, |arc| arc.at(share).0);
        self.nodes.push(place);
        NodeId(self.nodes.len() - 1)
    }
}
