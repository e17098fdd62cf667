//! A calibration for profiles: what the readings do not determine stays as it was, and all else is fitted with that.
//!
//! Values that were found together belong together: with one of them as it was, the others have to be fitted to it.

use super::estimate::{Fit, Parameter};
use super::measured::{Kind, Measurements};
use super::springback::ShapeChoice;
use super::statistics::count;
use super::{Assumed, Calibration, CalibrationError, calibrate, calibrate_holding};

/// Readings speak against values that are held where their squares grow by more than this for each, in variances of a reading: 95 %
/// of the distribution of chi-square with one degree of freedom.
const GROWS: f64 = 3.84;

/// As [`calibrate`], but what the readings do not determine is left as it was, unless they contradict several such values together.
/// The intervals are those of [`calibrate`], and wider by as much as a value is another.
///
/// # Errors
/// As [`calibrate`].
pub fn settled(
    assumed: &Assumed,
    measured: &Measurements,
    choice: ShapeChoice,
) -> Result<Calibration, CalibrationError> {
    let free = calibrate(assumed, measured, choice)?;
    let kinds = [Kind::Bends, Kind::Feeds, Kind::Turns];
    let mut held = kinds.map(|kind| fit(&free, kind).map(undetermined).unwrap_or_default());
    let choice = free.bends.as_ref().map_or(choice, |bends| ShapeChoice::Fixed(bends.shape));
    let used = without_left_out(measured, &free);
    loop {
        if held.iter().all(Vec::is_empty) {
            return Ok(free);
        }
        let mut found = calibrate_holding(assumed, &used, choice, &held.concat())?;
        let against = (0..kinds.len()).find(|&k| {
            let fits = fit(&free, kinds[k]).zip(fit(&found, kinds[k]));
            !held[k].is_empty()
                && fits.is_some_and(|(free, held_fit)| contradicts(free, held_fit, held[k].len()))
        });
        if let Some(k) = against {
            // What the readings tell the most of is let go.
            held[k].pop();
            continue;
        }
        let all = held.concat();
        for kind in kinds {
            if let Some((free, found)) = fit(&free, kind).zip(fit_mut(&mut found, kind)) {
                take_over(found, free, &all);
            }
        }
        if let (Some(found), Some(free)) = (&mut found.bends, &free.bends) {
            found.other = free.other;
        }
        found.left_out = [free.left_out, found.left_out].concat();
        found.gaps = free.gaps;
        return Ok(found);
    }
}

fn fit(found: &Calibration, kind: Kind) -> Option<&Fit> {
    match kind {
        Kind::Bends => found.bends.as_ref().map(|bends| &bends.fit),
        Kind::Feeds => found.feeds.as_ref().map(|feeds| &feeds.fit),
        Kind::Turns => found.turns.as_ref().map(|turns| &turns.fit),
    }
}

fn fit_mut(found: &mut Calibration, kind: Kind) -> Option<&mut Fit> {
    match kind {
        Kind::Bends => found.bends.as_mut().map(|bends| &mut bends.fit),
        Kind::Feeds => found.feeds.as_mut().map(|feeds| &mut feeds.fit),
        Kind::Turns => found.turns.as_mut().map(|turns| &mut turns.fit),
    }
}

/// What a fit does not determine, and least of all the first.
fn undetermined(fit: &Fit) -> Vec<Parameter> {
    let mut open: Vec<_> = fit.estimates.iter().filter(|estimate| !estimate.is_identified()).collect();
    open.sort_by(|a, b| a.determined.total_cmp(&b.determined));
    open.into_iter().map(|estimate| estimate.parameter).collect()
}

/// Whether the readings fit so much worse with values held that they speak against these.
fn contradicts(free: &Fit, with_held: &Fit, held: usize) -> bool {
    let squares = |fit: &Fit| count(fit.readings) * fit.after.rms.powi(2);
    squares(with_held) - squares(free) > GROWS * count(held) * free.scatter.plain().powi(2)
}

/// What was measured without the readings that were left out.
fn without_left_out(measured: &Measurements, found: &Calibration) -> Measurements {
    let mut used = measured.clone();
    for left in &found.left_out {
        let (sample, repeat) = (left.place.sample, left.place.repeat);
        match left.kind {
            Kind::Bends => used.angles[sample].readings[repeat] = None,
            Kind::Feeds => used.lengths[sample].readings[repeat] = None,
            Kind::Turns => used.turns[sample].readings[repeat] = None,
        }
    }
    used
}

/// How well each parameter is known: as well as without values held.
fn take_over(found: &mut Fit, free: &Fit, held: &[Parameter]) {
    found.rank = free.rank;
    for (estimate, free) in found.estimates.iter_mut().zip(&free.estimates) {
        let parameter = estimate.parameter;
        estimate.within_95_before = free.within_95_before;
        if held.contains(&parameter) {
            estimate.value = estimate.before;
            estimate.determined = free.determined;
        } else {
            estimate.determined = estimate.determined.max(free.determined);
        }
        let moved = (estimate.value.plain() - free.value.plain()).abs();
        estimate.within_95 = parameter.figure(free.within_95.plain() + moved);
    }
}
