//! How a frame vibrates.

use std::f64::consts::FRAC_PI_2;

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_frame::{Assembly, MemberId, ModeKind, ModeSearch, Pieces};

use super::shapes::StrutShape;
use super::structure::Structure;
use crate::PlanningError;

/// The search begins at this share of the frequency of the longest strut between pins.
const BELOW: f64 = 0.2;

/// What a mode is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "lowercase")]
pub enum ModeKindName {
    /// The frame, or a part of it, moves without bending.
    Rigid,
    /// The frame bends.
    Global,
    /// One strut alone holds more than half of the kinetic energy.
    Local,
}

#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct ModeReport {
    pub frequency_hz: f64,
    pub kind: ModeKindName,
    /// The strut of a local mode.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub edge: Option<u32>,
}

impl Structure {
    /// The lowest modes, each strut cut into pieces; and how they look, where that is `drawn`.
    pub fn modes(
        &self,
        count: u32,
        pieces: u32,
        drawn: bool,
    ) -> Result<(Vec<ModeReport>, Vec<StrutShape>), PlanningError> {
        if count == 0 || self.edges.is_empty() {
            return Ok((Vec::new(), Vec::new()));
        }
        let no_modes = |reason: String| PlanningError::NoModes { reason };
        let cut = Pieces::new(self.assembly.model(), pieces as usize);
        let assembly = Assembly::new(&cut.model).map_err(|error| no_modes(error.to_string()))?;
        let search = ModeSearch { count: count as usize, shift_hz: self.shift_hz(), struts: cut.struts };
        let modes = assembly.modes(&assembly.all(), &search).map_err(|error| no_modes(error.to_string()))?;
        let shapes = modes.iter().filter(|_| drawn);
        let shapes = shapes.map(|mode| self.vibrating(&cut.model, pieces as usize, &mode.shape)).collect();
        Ok((modes.iter().map(|mode| self.mode(mode.frequency_hz, mode.kind)).collect(), shapes))
    }

    fn mode(&self, frequency_hz: f64, kind: ModeKind) -> ModeReport {
        let (kind, edge) = match kind {
            ModeKind::Rigid => (ModeKindName::Rigid, None),
            ModeKind::Global => (ModeKindName::Global, None),
            ModeKind::Local { strut } => (ModeKindName::Local, self.edges.get(strut).map(|id| id.0)),
        };
        ModeReport { frequency_hz, kind, edge }
    }

    /// Where the search begins: well below the frequency of the longest strut between pins, π/2 √(E I/(ρ A L⁴)).
    fn shift_hz(&self) -> f64 {
        let members = (0..self.assembly.model().members.len()).map(MemberId);
        let lowest = members.map(|member| {
            let (section, length) = (self.assembly.section(member), self.assembly.length(member));
            let mass = section.density * section.area * length.powi(4);
            FRAC_PI_2 * (section.e * section.iy / mass).sqrt()
        });
        BELOW * lowest.fold(f64::INFINITY, f64::min)
    }
}
