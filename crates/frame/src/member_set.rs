//! Some of the members of a model.

use crate::model::MemberId;

/// Which members of a model are there.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct MemberSet {
    present: Vec<bool>,
    count: usize,
}

impl MemberSet {
    /// None of so many members.
    #[must_use]
    pub fn empty(members: usize) -> Self {
        Self { present: vec![false; members], count: 0 }
    }

    /// All of so many members.
    #[must_use]
    pub fn all(members: usize) -> Self {
        Self { present: vec![true; members], count: members }
    }

    /// Puts a member in; false if it was there. Out of range panics, as an index does.
    pub fn insert(&mut self, member: MemberId) -> bool {
        let was = std::mem::replace(&mut self.present[member.0], true);
        self.count += usize::from(!was);
        !was
    }

    /// Takes a member out; false if it was not there. Out of range panics, as an index does.
    pub fn remove(&mut self, member: MemberId) -> bool {
        let was = std::mem::replace(&mut self.present[member.0], false);
        self.count -= usize::from(was);
        was
    }

    /// Whether a member is there.
    #[must_use]
    pub fn contains(&self, member: MemberId) -> bool {
        self.present.get(member.0).copied().unwrap_or(false)
    }

    /// How many are there.
    #[must_use]
    pub fn len(&self) -> usize {
        self.count
    }

    /// Whether none is there.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// Of how many members these are some.
    #[must_use]
    pub fn of(&self) -> usize {
        self.present.len()
    }

    /// Those that are there, in order.
    pub fn iter(&self) -> impl Iterator<Item = MemberId> + '_ {
        self.present.iter().enumerate().filter(|&(_, &there)| there).map(|(k, _)| MemberId(k))
    }
}
