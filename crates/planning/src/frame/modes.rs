//! How a frame vibrates.

use std::f64::consts::{FRAC_PI_2, TAU};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_accuracy::bows;
use wirebend_error::{ErrorRemedy, InputName};
use wirebend_frame::{Assembly, MemberId, Mode, ModeKind, ModeSearch, Model, NodeMass, Pieces};

use super::MAX_PIECES;
use super::shapes::StrutShape;
use super::structure::Structure;
use crate::PlanningError;
use crate::report::NoteReport;

/// The search begins at this share of the frequency of the longest strut between pins.
const BELOW: f64 = 0.2;

/// Fewer chords of an arc would be stiffer than it is.
const LEAST_OF_AN_ARC: u32 = 9;

/// A frequency that is by more than this share too high is told.
const TOO_FAST: f64 = 0.01;

/// At most so far do struts bow: half a circle.
const LARGEST_BOW: f64 = 0.5;

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

/// Struts that are not straight, as wire is that comes from a coil: each is an arc, in a direction of its own.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
pub struct BowChoice {
    /// From the chord of each strut to the middle of its arc, as a share of its length.
    #[schemars(range(min = 0.0, max = 0.5))]
    pub share: f64,
    /// Where the random directions start: the same seed draws the same struts.
    #[serde(default = "one")]
    pub seed: u64,
}

const fn one() -> u64 {
    1
}

/// How the frame vibrates where its struts bow.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct BowedReport {
    pub share: f64,
    pub seed: u64,
    /// By rising frequency, rigid ones foremost.
    pub modes: Vec<ModeReport>,
    /// The lowest frequency at which something bends, as a share of that of straight struts.
    pub of_straight: f64,
}

impl BowChoice {
    /// # Errors
    /// It is no bow, or no modes are looked for that it could change.
    pub(super) fn check(self, modes: u32) -> Result<(), PlanningError> {
        let wrong = |input: InputName, value: String, expected| {
            Err(PlanningError::Value { input: Some(input), name: input.words(), value, expected })
        };
        if !(self.share > 0.0 && self.share <= LARGEST_BOW) {
            return wrong(
                InputName::Bow,
                self.share.to_string(),
                "a share of their length above 0, up to 0.5",
            );
        }
        if modes == 0 {
            return wrong(
                InputName::Modes,
                "0".to_owned(),
                "at least 1 where struts bow, which changes nothing else",
            );
        }
        Ok(())
    }
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
        let (model, modes) = self.found(count, Pieces::new(self.assembly.model(), pieces as usize))?;
        let shapes = modes.iter().filter(|_| drawn);
        let shapes = shapes.map(|mode| self.vibrating(&model, pieces as usize, &mode.shape)).collect();
        Ok((self.reports(&modes), shapes))
    }

    /// The same of bowed struts, beside the modes of straight ones.
    pub fn bowed(
        &self,
        bow: BowChoice,
        pieces: u32,
        count: u32,
        straight: &[ModeReport],
    ) -> Result<Option<BowedReport>, PlanningError> {
        let lowest = |modes: &[ModeReport]| {
            modes.iter().find(|mode| mode.kind != ModeKindName::Rigid).map(|mode| mode.frequency_hz)
        };
        let Some(of_straight) = lowest(straight) else { return Ok(None) };
        let model = self.assembly.model();
        let ways = model
            .members
            .iter()
            .filter_map(|member| Some(model.nodes.get(member.b.0)? - model.nodes.get(member.a.0)?));
        let rises = bows(&ways.collect::<Vec<_>>(), bow.share, bow.seed);
        let (_, modes) =
            self.found(count, Pieces::bowed(model, pieces.max(LEAST_OF_AN_ARC) as usize, &rises))?;
        let modes = self.reports(&modes);
        let of_straight = lowest(&modes).unwrap_or_default() / of_straight;
        Ok(Some(BowedReport { share: bow.share, seed: bow.seed, modes, of_straight }))
    }

    /// The modes of a frame that was cut into pieces, and what it was cut into.
    fn found(&self, count: u32, cut: Pieces) -> Result<(Model, Vec<Mode>), PlanningError> {
        let no_modes = |reason: String| PlanningError::NoModes { reason };
        let assembly = Assembly::new(&cut.model).map_err(|error| no_modes(error.to_string()))?;
        // 1 g are 1e-6 t.
        let masses = self.joints.iter().map(|&(node, mass_g)| NodeMass { node, mass: mass_g * 1.0e-6 });
        let search = ModeSearch {
            count: count as usize,
            shift_hz: self.shift_hz(),
            struts: cut.struts,
            masses: masses.collect(),
        };
        let modes = assembly.modes(&assembly.all(), &search).map_err(|error| no_modes(error.to_string()))?;
        Ok((cut.model, modes))
    }

    fn reports(&self, modes: &[Mode]) -> Vec<ModeReport> {
        modes.iter().map(|mode| self.mode(mode.frequency_hz, mode.kind)).collect()
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
        BELOW * FRAC_PI_2 * self.slowest_per_s()
    }

    /// The least √(E I/(ρ A L⁴)) of a strut, which its frequencies are multiples of.
    fn slowest_per_s(&self) -> f64 {
        let members = (0..self.assembly.model().members.len()).map(MemberId);
        let of_struts = members.map(|member| {
            let (section, length) = (self.assembly.section(member), self.assembly.length(member));
            let mass = section.density * section.area * length.powi(4);
            (section.e * section.iy / mass).sqrt()
        });
        of_struts.fold(f64::INFINITY, f64::min)
    }

    /// From which mode on struts would have to be cut into more pieces, and into how many for all modes. A beam whose waves of motion have
    /// the wave number β comes out too fast by (β h)⁴/1440 where its pieces are h long: that is what its cubic shapes leave, with their
    /// own masses, as h goes to zero.
    pub fn too_coarse(&self, modes: &[ModeReport], pieces: u32) -> Option<NoteReport> {
        let slowest = self.slowest_per_s();
        // (β L)² = ω √(ρ A L⁴/(E I)).
        let turned = |mode: &ModeReport| TAU * mode.frequency_hz / slowest;
        let off = |mode: &ModeReport| turned(mode).powi(2) / (1440.0 * f64::from(pieces).powi(4));
        let first = modes.iter().position(|mode| off(mode) > TOO_FAST)?;
        let worst = modes.iter().map(off).fold(0.0, f64::max);
        let needed = (f64::from(pieces) * (worst / TOO_FAST).powf(0.25)).ceil();
        let most = f64::from(MAX_PIECES);
        let enough = if needed > most {
            format!("{most:.0} pieces for each strut, the most, are not enough for all modes")
        } else {
            format!("{needed:.0} pieces for each strut are enough for all modes")
        };
        Some(NoteReport {
            code: "coarse-pieces".into(),
            count: modes.len() - first,
            message: format!(
                "from mode {} on frequencies may be more than {:.0} % too high: {enough}",
                first + 1,
                100.0 * TOO_FAST,
            ),
            remedies: vec![ErrorRemedy::CorrectInput { input: InputName::Pieces }],
        })
    }
}
