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
        // Where the machine compensates springback itself, what is left of it is nothing that a wire has.
        let compensated = self.fitted.setup.model.compensation.bend.springback.is_some();
        let Some(bends) = self.fitted.found.bends.as_ref().filter(|_| compensated) else { return values };
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

#[cfg(test)]
mod tests {
    use wirebend_core::calibrate::{Gap, ShapeChoice, settled};
    use wirebend_files::read::{MeasuringSheet, SheetQuantity, SheetRow};

    use super::super::measured::OfSheet;
    use super::super::report::CalibrationReport;
    use super::*;
    use crate::Installation;

    fn row(quantity: SheetQuantity, commanded: f64, read: f64) -> SheetRow {
        SheetRow {
            line: 0,
            coupon: format!("{commanded}"),
            quantity,
            wanted: commanded,
            commanded,
            axes_deg: (quantity == SheetQuantity::Side).then_some([90.0, 90.0]),
            readings: vec![Some(read), Some(read)],
        }
    }

    fn fitted(machine: &str, rows: Vec<SheetRow>) -> Fitted {
        let setup = Installation::new(&[]).unwrap().setup(machine, None).unwrap();
        let sheet = MeasuringSheet {
            machine: setup.machine_id().to_owned(),
            material: setup.material_id().to_owned(),
            rows,
            bent: Vec::new(),
            comments: Vec::new(),
            columns: Vec::new(),
        };
        let of_sheet = OfSheet::new(&sheet, &setup).unwrap();
        let found = settled(&setup.assumed().unwrap(), &of_sheet.measured, ShapeChoice::Better).unwrap();
        let report = CalibrationReport::new(setup.machine_id(), setup.material_id(), &found, &of_sheet);
        Fitted { setup, found, report }
    }

    /// Its commands are the design itself: sides over the outside of 0.9 mm wire are right, and a wire with another K and springback would
    /// have the next design bent wrong.
    #[test]
    fn a_machine_that_compensates_nothing_keeps_k_and_springback() {
        let bends = [60.0, -60.0, 90.0, -90.0]
            .map(|angle: f64| row(SheetQuantity::Bend, angle, angle - 2.0 * angle.signum()));
        let sides = [15.0, 60.0].map(|side| row(SheetQuantity::Side, side, side + 0.9));
        let fitted = fitted("pensa-diwire-pro", [&bends[..], &sides].concat());
        let found = Values { fitted: &fitted, date: "2026-11-25" };
        let material = found.of_material();
        assert!(material.is_empty(), "{material:?}");
        let machine = found.of_machine();
        let keys: Vec<&str> = machine.iter().map(|(key, _)| *key).collect();
        assert_eq!(keys, ["feed.scale"]);
        let scale = machine[0].1["value"].as_f64().unwrap();
        assert!((scale - 1.0).abs() < 1e-4, "{scale}");
        let gaps = &fitted.found.gaps;
        assert!(gaps.contains(&Gap::SpringbackLeft) && gaps.contains(&Gap::DeductionLeft), "{gaps:?}");
    }
}
