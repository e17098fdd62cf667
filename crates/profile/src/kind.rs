//! The kinds of profile and what is common to their files.

use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The version of the file formats that this program reads and writes.
pub const SCHEMA_VERSION: u32 = 1;

/// Largest profile file that is read, in bytes (1 MiB). The shipped ones are below 10 kB.
pub const MAX_FILE_BYTES: usize = 1 << 20;

/// What a profile describes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Kind {
    /// A wire bender.
    Machine,
    /// A wire.
    Material,
    /// The errors of a bender, for simulation.
    Noise,
    /// A machine that builds a frame strut by strut.
    StrutBuilder,
}

impl Kind {
    /// All kinds, in the order in which lists show them.
    pub const ALL: [Self; 4] = [Self::Machine, Self::Material, Self::Noise, Self::StrutBuilder];

    /// The word of the file's `kind` key.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Self::Machine => "machine",
            Self::Material => "material",
            Self::Noise => "noise",
            Self::StrutBuilder => "strut-builder",
        }
    }

    /// The sub-folder of a profile folder that holds this kind.
    #[must_use]
    pub fn folder(self) -> &'static str {
        match self {
            Self::Machine => "machines",
            Self::Material => "materials",
            Self::Noise => "noise",
            Self::StrutBuilder => "strut-builders",
        }
    }

    /// The kind whose [`Kind::word`] this is.
    #[must_use]
    pub fn from_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.word() == word)
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.word())
    }
}

/// Whether `id` is a slug: lower-case letters, digits and single inner hyphens.
#[must_use]
pub fn is_slug(id: &str) -> bool {
    id.split('-').all(|part| {
        !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_slug_has_no_capitals_spaces_dots_or_stray_hyphens() {
        for good in ["a", "steel-0-9mm", "6061"] {
            assert!(is_slug(good), "{good}");
        }
        for bad in ["", "-a", "a-", "a--b", "A", "a b", "a.b", "ä", "../a"] {
            assert!(!is_slug(bad), "{bad}");
        }
    }
}
