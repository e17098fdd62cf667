//! The curve that a table of springback pairs gives, at places where a person can look at it.

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_core::units::Angle;
use wirebend_profile::{LossPoint, Springback};

use crate::PlanningError;
use crate::machine;

/// Bends at which the curve is listed besides those of its pairs, degrees.
const EVERY_DEG: u32 = 15;

/// What is done without a measurement.
const RULE: &str =
    "straight from pair to pair; before the first and after the last the loss stays that of the nearest pair";

/// What a wire loses of bends, by its table.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct SpringbackReport {
    /// What lies between and beyond the pairs.
    pub rule: &'static str,
    /// To the positive side, bends ascending.
    pub positive: Vec<SpringbackSample>,
    /// To the negative side; bends without their sign.
    pub negative: Vec<SpringbackSample>,
}

/// The curve at one place.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct SpringbackSample {
    /// The bend that is left, degrees.
    pub bend_deg: f64,
    /// What the wire loses of it, degrees: it is bent that much farther.
    pub loss_deg: f64,
    /// Where it lies.
    pub place: SamplePlace,
}

/// Where a sample lies among the pairs of its table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum SamplePlace {
    /// It is one of the pairs.
    Pair,
    /// Between two pairs.
    Between,
    /// Below the first or above the last.
    Beyond,
}

/// The curve of a table; none of a constant, which is the same everywhere.
pub fn report(material: &str, stated: &Springback) -> Result<Option<SpringbackReport>, PlanningError> {
    let Springback::Table { positive, negative, .. } = stated else { return Ok(None) };
    let model = machine::springback(material, stated)?;
    let side = |pairs: &[LossPoint], sign: f64| -> Result<Vec<SpringbackSample>, PlanningError> {
        let mut bends: Vec<f64> = (1..=180 / EVERY_DEG).map(|k| f64::from(k * EVERY_DEG)).collect();
        bends.extend(pairs.iter().map(|pair| pair.angle_deg).filter(|&bend| bend > 0.0));
        bends.sort_by(f64::total_cmp);
        bends.dedup();
        let sample = |bend_deg: f64| {
            let bent = model.bend_to(machine::deg(sign * bend_deg)?);
            Ok(SpringbackSample { bend_deg, loss_deg: loss(bent, bend_deg), place: place(pairs, bend_deg) })
        };
        bends.into_iter().map(sample).collect()
    };
    let other = negative.as_deref().unwrap_or(positive);
    Ok(Some(SpringbackReport { rule: RULE, positive: side(positive, 1.0)?, negative: side(other, -1.0)? }))
}

/// To a millionth of a degree: what is more is of the arithmetic.
fn loss(bent: Angle, bend_deg: f64) -> f64 {
    ((bent.abs().deg() - bend_deg) * 1e6).round() / 1e6
}

fn place(pairs: &[LossPoint], bend_deg: f64) -> SamplePlace {
    let below = pairs.iter().filter(|pair| pair.angle_deg <= bend_deg).count();
    match below {
        _ if pairs.iter().any(|pair| (pair.angle_deg - bend_deg).abs() < 1e-9) => SamplePlace::Pair,
        0 => SamplePlace::Beyond,
        below if below == pairs.len() => SamplePlace::Beyond,
        _ => SamplePlace::Between,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two pairs: what is read off the straight line between them by hand, and the loss of the nearest beyond.
    #[test]
    fn a_curve_is_told_with_what_is_measured_of_it() {
        let pair = |angle_deg, loss_deg| LossPoint { angle_deg, loss_deg };
        let table = Springback::Table {
            positive: vec![pair(20.0, 4.0), pair(120.0, 9.0)],
            negative: None,
            source: "a test".to_owned(),
            measured: true,
        };
        let found = report("wire", &table).unwrap().unwrap();
        assert_eq!(found.positive, found.negative);
        let at =
            |bend: f64| found.positive.iter().find(|sample| (sample.bend_deg - bend).abs() < 1e-9).unwrap();
        for (bend, loss, place) in [
            (15.0, 4.0, SamplePlace::Beyond),
            (20.0, 4.0, SamplePlace::Pair),
            (60.0, 6.0, SamplePlace::Between),
            (120.0, 9.0, SamplePlace::Pair),
            (180.0, 9.0, SamplePlace::Beyond),
        ] {
            assert!((at(bend).loss_deg - loss).abs() < 1e-6, "{bend}: {:?}", at(bend));
            assert_eq!(at(bend).place, place);
        }
    }
}
