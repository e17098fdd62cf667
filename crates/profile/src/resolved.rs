//! A profile with its parents merged in.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use crate::merge::Origin;

/// A profile with its parents merged in, and which file set what.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Resolved<T> {
    /// The merged profile. Its `inherits` is still the file's own.
    pub profile: T,
    /// Dotted key of each value to the profile that set it.
    pub provenance: BTreeMap<String, Origin>,
    /// Ids from the profile itself to its last ancestor.
    pub chain: Vec<String>,
}

impl<T> Resolved<T> {
    /// Which file set a value, by dotted key such as `limits.max_bend_deg`; keys inside a value that is
    /// replaced whole answer for the whole. `None` for a group and for what no file set.
    #[must_use]
    pub fn origin(&self, key: &str) -> Option<&Origin> {
        origin(&self.provenance, key)
    }
}

pub(crate) fn origin<'a>(provenance: &'a BTreeMap<String, Origin>, key: &str) -> Option<&'a Origin> {
    let mut key = key;
    loop {
        if let Some(origin) = provenance.get(key) {
            return Some(origin);
        }
        key = key.rsplit_once('.')?.0;
    }
}
