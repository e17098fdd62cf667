//! Members cut into pieces, so that they can bend between their ends when they vibrate.

use crate::model::Model;

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
        let mut cut = Model {
            nodes: model.nodes.clone(),
            members: Vec::with_capacity(model.members.len() * pieces.max(1)),
            sections: model.sections.clone(),
            supports: model.supports.clone(),
        };
        let mut struts = Vec::with_capacity(cut.members.capacity());
        for (strut, member) in model.members.iter().enumerate() {
            let mut from = member.a;
            for piece in 1..=pieces.max(1) {
                let to = if piece == pieces.max(1) { member.b } else { cut.between(member, piece, pieces) };
                cut.members.push(crate::Member { a: from, b: to, ..*member });
                struts.push(strut);
                from = to;
            }
        }
        Self { model: cut, struts }
    }
}

impl Model {
    /// A new node at a share of a member. A member with an unknown end has none; its end is kept, for the check of the model.
    fn between(&mut self, member: &crate::Member, piece: usize, pieces: usize) -> crate::NodeId {
        let (Some(a), Some(b)) = (self.nodes.get(member.a.0), self.nodes.get(member.b.0)) else {
            return member.a;
        };
        #[allow(clippy::cast_precision_loss, reason = "pieces are few")]
        let place = a + (b - a) * (piece as f64 / pieces as f64);
        self.nodes.push(place);
        crate::NodeId(self.nodes.len() - 1)
    }
}
