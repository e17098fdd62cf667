//! Which groups stand.

/// A set of groups by their places.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub(super) struct GroupSet {
    words: Vec<u64>,
    count: usize,
}

impl GroupSet {
    pub fn none(groups: usize) -> Self {
        Self { words: vec![0; groups.div_ceil(64)], count: 0 }
    }

    pub fn all(groups: usize) -> Self {
        let mut set = Self::none(groups);
        (0..groups).for_each(|group| set.insert(group));
        set
    }

    pub fn contains(&self, group: usize) -> bool {
        self.words[group / 64] >> (group % 64) & 1 == 1
    }

    pub fn insert(&mut self, group: usize) {
        self.count += usize::from(!self.contains(group));
        self.words[group / 64] |= 1 << (group % 64);
    }

    pub fn remove(&mut self, group: usize) {
        self.count -= usize::from(self.contains(group));
        self.words[group / 64] &= !(1 << (group % 64));
    }

    pub fn len(&self) -> usize {
        self.count
    }

    pub fn iter(&self) -> impl Iterator<Item = usize> + '_ {
        (0..64 * self.words.len()).filter(|&group| self.contains(group))
    }
}
