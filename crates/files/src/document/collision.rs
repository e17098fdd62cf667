//! How collisions of a design are looked for.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_core::units::Length;

/// How collisions are looked for.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct CollisionSettings {
    /// How far a wire has to stay from what it could hit while it is bent, mm.
    pub clearance_mm: Clearance,
    /// Whether the part already bent is looked at as it hangs under its own weight.
    pub sag: bool,
}

impl CollisionSettings {
    pub(super) fn is_default(&self) -> bool {
        *self == Self::default()
    }
}

/// How far a wire has to stay from what it could hit while it is bent: zero or more.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "f64", into = "f64")]
#[schemars(with = "f64", extend("minimum" = 0))]
pub struct Clearance(Length);

impl Clearance {
    #[must_use]
    pub const fn length(self) -> Length {
        self.0
    }
}

impl TryFrom<f64> for Clearance {
    type Error = String;

    fn try_from(mm: f64) -> Result<Self, String> {
        let length = Length::from_mm(mm).ok().filter(|length| *length >= Length::ZERO);
        length.map(Self).ok_or_else(|| format!("a clearance of {mm} mm, expected zero or more"))
    }
}

impl From<Clearance> for f64 {
    fn from(clearance: Clearance) -> Self {
        clearance.0.mm()
    }
}
