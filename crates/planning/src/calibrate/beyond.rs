//! What was found and cannot be: beyond what a profile holds, or beyond what bent wire does. Then readings are wrong.

use wirebend_core::calibrate::{Figure, Parameter};
use wirebend_profile::{Kind, ProfileError};

use super::fit::Fitted;
use super::report::{CalibrationReport, KindName, estimate};
use super::values::Values;
use crate::profiles::OwnProfile;
use crate::text::calibration as words;
use crate::{Installation, PlanningError};

/// How much farther out than its middle the neutral fibre of a round wire may be found to be, in diameters: by this much or by what
/// the readings leave open, whichever is less.
const K_OPEN: f64 = 0.1;
/// The middle of the wire: bending draws the neutral fibre inwards from there.
const K_MIDDLE: f64 = 0.5;

impl Fitted {
    /// What was found and cannot be, in words.
    pub(super) fn doubts(&self, app: &Installation) -> Result<Vec<String>, PlanningError> {
        let found = Values { fitted: self, date: "" };
        let setup = &self.setup;
        let mut doubts = Vec::new();
        let profiles = [
            (Kind::Machine, setup.machine_id(), found.of_machine()),
            (Kind::Material, setup.material_id(), found.of_material()),
        ];
        for (kind, inherits, values) in profiles {
            let mut draft = OwnProfile::draft(app, kind, inherits)?;
            for (key, value) in values {
                draft.set(key, value)?;
            }
            doubts.extend(draft.faults(app)?.iter().filter_map(|fault| beyond(&self.report, fault)));
        }
        if doubts.is_empty() {
            doubts.extend(self.neutral_fibre());
        }
        Ok(doubts)
    }

    fn neutral_fibre(&self) -> Option<String> {
        let k = estimate(&self.found.feeds.as_ref()?.fit, Parameter::KFactor)?;
        let (Figure::Ratio(value), Figure::Ratio(within)) = (k.value, k.within_95) else { return None };
        let open = within.min(K_OPEN);
        let outside = value > K_MIDDLE + open || value < -open;
        outside.then(|| words::neutral_fibre(value, &lines(&self.report, KindName::Feeds)))
    }
}

/// What is wrong with a profile because of what was found, in words; `None` where it is something else.
pub(super) fn beyond(report: &CalibrationReport, fault: &ProfileError) -> Option<String> {
    let ProfileError::Rule { key, found, expected, .. } = fault else { return None };
    let (name, kind) = match key.as_str() {
        "k_factor" => ("the K-factor", KindName::Feeds),
        "feed.scale" => ("the wire per commanded mm", KindName::Feeds),
        "rotate.offset_deg" => ("the offset of a turn", KindName::Turns),
        "rotate.backlash_deg" => ("the backlash of a turn", KindName::Turns),
        bend if bend.starts_with("bend.") => (bend, KindName::Bends),
        springback if springback.starts_with("springback") => ("the springback", KindName::Bends),
        _ => return None,
    };
    Some(words::beyond(name, found, expected, &lines(report, kind)))
}

/// The lines of a sheet that readings of a kind stand in.
fn lines(report: &CalibrationReport, kind: KindName) -> Vec<usize> {
    let values = report.kinds.iter().filter(|found| found.kind == kind).flat_map(|found| &found.values);
    let mut lines: Vec<usize> = values.map(|value| value.line).collect();
    lines.sort_unstable();
    lines.dedup();
    lines
}
