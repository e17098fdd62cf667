//! A set of directions by their indices.

/// How many directions a set can hold.
const CAPACITY: usize = 192;

/// A set of directions, by their indices in a list that its owner keeps; at most [`DirectionSet::CAPACITY`] of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct DirectionSet([u64; CAPACITY / 64]);

impl DirectionSet {
    /// No index is this high.
    pub const CAPACITY: usize = CAPACITY;

    /// The first `count` indices, or all where there are fewer.
    ///
    /// ```
    /// use wirebend_collide::DirectionSet;
    /// assert_eq!(DirectionSet::first(100).len(), 100);
    /// assert!(DirectionSet::default().is_empty());
    /// ```
    #[must_use]
    pub fn first(count: usize) -> Self {
        (0..count.min(CAPACITY)).collect()
    }

    /// Adds an index; one beyond the capacity is left out.
    pub fn insert(&mut self, index: usize) {
        if let Some(word) = self.0.get_mut(index / 64) {
            *word |= 1 << (index % 64);
        }
    }

    /// Takes an index away.
    pub fn remove(&mut self, index: usize) {
        if let Some(word) = self.0.get_mut(index / 64) {
            *word &= !(1 << (index % 64));
        }
    }

    /// Whether an index is in it.
    #[must_use]
    pub fn contains(&self, index: usize) -> bool {
        self.0.get(index / 64).is_some_and(|word| word >> (index % 64) & 1 == 1)
    }

    /// How many there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.0.iter().map(|word| word.count_ones() as usize).sum()
    }

    /// Whether there is none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.0 == [0; CAPACITY / 64]
    }

    /// Those that are in both.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] & other.0[k]))
    }

    /// Those that are in either.
    #[must_use]
    pub fn or(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] | other.0[k]))
    }

    /// Those that are not in the other.
    #[must_use]
    pub fn without(self, other: Self) -> Self {
        Self(std::array::from_fn(|k| self.0[k] & !other.0[k]))
    }

    /// Its indices, rising.
    pub fn iter(self) -> impl Iterator<Item = usize> {
        self.0.into_iter().enumerate().flat_map(|(k, mut word)| {
            std::iter::from_fn(move || {
                let bit = word.trailing_zeros() as usize;
                (word != 0).then(|| {
                    word &= word - 1;
                    64 * k + bit
                })
            })
        })
    }
}

impl FromIterator<usize> for DirectionSet {
    fn from_iter<T: IntoIterator<Item = usize>>(indices: T) -> Self {
        let mut set = Self::default();
        indices.into_iter().for_each(|index| set.insert(index));
        set
    }
}
