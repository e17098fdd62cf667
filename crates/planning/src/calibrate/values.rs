//! What was found, as values of profiles with their sources.

use serde_json::{Value, json};
use wirebend_core::calibrate::{Estimate, Figure, Fit, Parameter};
use wirebend_core::compensate::SpringbackPoint;

use super::fit::Fitted;
use super::report::{estimate, turns_stay};
use crate::profiles::set::sourced;

/// What was found, as values of profiles.
pub(super) struct Values<'a> {
    pub fitted: &'a Fitted,
    pub date: &'a str,
}

impl Values<'_> {
    /// A figure with its source: when, from how many readings, how well.
    fn figure(&self, value: f64, estimate: &Estimate, readings: usize) -> Value {
        let round = |value: f64, digits: f64| (value * digits).round() / digits;
        // Of ratios the fourth digit counts.
        let digits = if matches!(estimate.within_95, Figure::Ratio(_)) { 1e4 } else { 1e3 };
        let within = round(estimate.within_95.plain(), digits);
        let how = if estimate.is_identified() {
            format!("Calibrated {}: n = {readings}, ±{within} (95 %)", self.date)
        } else {
            format!(
                "Calibrated {}: n = {readings}, which determine it only together with others, ±{within} (95 %)",
                self.date
            )
        };
        let mut figure = sourced(&json!(round(value, 1e4)), &how, estimate.is_identified());
        figure["within_95"] = json!(within);
        figure["within_95_before"] = json!(round(estimate.within_95_before.plain(), digits));
        figure
    }

    /// How many readings all of it is from.
    pub fn readings(&self) -> usize {
        let found = &self.fitted.found;
        let bends = found.bends.as_ref().map(|bends| &bends.fit);
        let feeds = found.feeds.as_ref().map(|feeds| &feeds.fit);
        let turns = found.turns.as_ref().map(|turns| &turns.fit);
        [bends, feeds, turns].into_iter().flatten().map(|fit| fit.readings).sum()
    }

    pub fn of_machine(&self) -> Vec<(&'static str, Value)> {
        let mut values = self.of_peg();
        values.extend(self.of_motion());
        values
    }

    /// The scale of the feed goes with the K-factor that was found with it. What was found of turns goes together.
    fn of_motion(&self) -> Vec<(&'static str, Value)> {
        let found = &self.fitted.found;
        let mut values = Vec::new();
        if let Some(fit) = found.feeds.as_ref().map(|feeds| &feeds.fit)
            && let Some(scale) = changed(fit, Parameter::FeedScale)
        {
            values.push(("feed.scale", self.figure(scale.value.plain(), scale, fit.readings)));
        }
        if let Some(fit) = found.turns.as_ref().map(|turns| &turns.fit)
            && turns_stay(fit).is_none()
            && let Some(offset) = estimate(fit, Parameter::RotationOffset)
            && let Some(backlash) = estimate(fit, Parameter::RotationBacklash)
        {
            for (key, found) in [("rotate.offset_deg", offset), ("rotate.backlash_deg", backlash)] {
                if !found.is_left() {
                    values.push((key, self.figure(found.value.plain(), found, fit.readings)));
                }
            }
        }
        values
    }

    fn of_peg(&self) -> Vec<(&'static str, Value)> {
        let Some((bends, peg)) = self.fitted.found.bends.as_ref().and_then(|bends| Some((bends, bends.peg?)))
        else {
            return Vec::new();
        };
        let half = self.fitted.setup.model.wire.diameter.mm() / 2.0;
        let figures = [
            ("bend.orbit_radius_mm", Parameter::OrbitRadius, peg.orbit_radius.mm()),
            ("bend.orbit_offset_mm", Parameter::OrbitOffset, peg.orbit_offset.mm()),
            ("bend.pin_radius_mm", Parameter::BendRadius, peg.bend_radius.mm() - half),
            ("bend.rod_radius_mm", Parameter::PegRadius, peg.peg_radius.mm() - half),
        ];
        let figure = |(key, parameter, value)| {
            let estimate = changed(&bends.fit, parameter)?;
            Some((key, self.figure(value, estimate, bends.fit.readings)))
        };
        figures.into_iter().filter_map(figure).collect()
    }

    pub fn of_material(&self) -> Vec<(&'static str, Value)> {
        let mut values = Vec::new();
        if let Some(feeds) = &self.fitted.found.feeds
            && let Some(k) = changed(&feeds.fit, Parameter::KFactor)
        {
            values.push(("k_factor", self.figure(feeds.k_factor, k, feeds.fit.readings)));
        }
        let Some(bends) = self.fitted.found.bends.as_ref() else { return values };
        let moved = estimate(&bends.fit, Parameter::SpringbackShift);
        if moved.is_some_and(Estimate::is_left) {
            return values;
        }
        let springback = match (&bends.pairs, changed(&bends.fit, Parameter::Springback)) {
            (Some([positive, negative]), _) => {
                let (n, scatter) = (bends.fit.readings, bends.fit.scatter.plain());
                json!({
                    "model": "table",
                    "positive": pairs(positive),
                    "negative": pairs(negative),
                    "source": format!("Calibrated {}: n = {n}, scatter {scatter:.2} degrees", self.date),
                    "measured": true,
                })
            }
            (None, Some(loss)) => {
                let value = self.figure(loss.value.plain(), loss, bends.fit.readings);
                json!({ "model": "constant", "angle_deg": value })
            }
            (None, None) => return values,
        };
        values.push(("springback", springback));
        values
    }
}

/// The estimate of a parameter, unless it was left as it was: then its profile has it, with where it comes from.
fn changed(fit: &Fit, parameter: Parameter) -> Option<&Estimate> {
    estimate(fit, parameter).filter(|estimate| !estimate.is_left())
}

fn pairs(points: &[SpringbackPoint]) -> Value {
    let round = |value: f64| (value * 1e3).round() / 1e3;
    let pair = |point: &SpringbackPoint| json!({ "angle_deg": round(point.formed.deg()), "loss_deg": round(point.loss.deg()) });
    points.iter().map(pair).collect()
}
