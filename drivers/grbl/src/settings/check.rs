//! Values that have the right shape and make no sense anyway.

use wirebend_driver_api::DriverError;

use super::refusal::refuse;
use super::{Settings, template};

const MIN_RATE: f64 = 0.01;
const MAX_RATE: f64 = 100_000.0;
const MIN_UNITS: f64 = 0.0001;
const MAX_UNITS: f64 = 10_000.0;
const MAX_DECIMALS: u8 = 4;
/// A bend of half a turn is 1800 moves then.
const MIN_ARC_DEG: f64 = 0.1;
const MAX_ARC_DEG: f64 = 360.0;
const MAX_DWELL_S: f64 = 60.0;
/// No bender is longer.
const MAX_CUTTER_MM: f64 = 1000.0;

pub(super) fn check(settings: &Settings) -> Result<(), DriverError> {
    letters(settings)?;
    rates(settings)?;
    within("pin_dwell_s", settings.pin_dwell_s, 0.0, MAX_DWELL_S)?;
    within("cutter_mm", settings.cutter_mm, -MAX_CUTTER_MM, MAX_CUTTER_MM)?;
    within("arc_step_deg", settings.arc_step_deg, 0.0, MAX_ARC_DEG)?;
    within("arc_dwell_s", settings.arc_dwell_s, 0.0, MAX_DWELL_S)?;
    within("decimals", f64::from(settings.decimals), 0.0, f64::from(MAX_DECIMALS))?;
    within("baud", f64::from(settings.baud), 300.0, 4_000_000.0)?;
    if settings.arc_step_deg > 0.0 {
        within("arc_step_deg", settings.arc_step_deg, MIN_ARC_DEG, MAX_ARC_DEG)?;
    }
    for (key, lines) in [
        ("pin_out", &settings.pin_out),
        ("pin_in", &settings.pin_in),
        ("cut", &settings.cut),
        ("start_block", &settings.start_block),
        ("end_block", &settings.end_block),
    ] {
        template::check(key, lines, key.ends_with("_block"))?;
    }
    for (key, value) in &settings.expected {
        let number = key.strip_prefix('$').filter(|number| (1..=4).contains(&number.len()));
        if !number.is_some_and(|number| number.bytes().all(|byte| byte.is_ascii_digit())) {
            let what = format!("'expected' has the key '{key}', which is not a setting of grbl");
            return Err(refuse(what, "write it as the machine does, such as \"$100\""));
        }
        if !value.is_finite() {
            let what = format!("'expected' has no number for '{key}'");
            return Err(refuse(what, "write what the machine shows for $$"));
        }
    }
    Ok(())
}

fn letters(settings: &Settings) -> Result<(), DriverError> {
    let axes = settings.axes();
    for (at, (key, letter)) in axes.iter().enumerate() {
        if let Some((other, _)) = axes[..at].iter().find(|(_, before)| before == letter) {
            let what = format!("'{key}' is {}, and so is '{other}'", letter.letter());
            return Err(refuse(what, "give each of the three axes a letter of its own"));
        }
    }
    Ok(())
}

/// Each rate, and that rate in the machine's own units, since the program has that.
fn rates(settings: &Settings) -> Result<(), DriverError> {
    let axes = [
        (
            "feed_rate_mm_per_min",
            settings.feed_rate_mm_per_min,
            "feed_units_per_mm",
            settings.feed_units_per_mm,
        ),
        (
            "rotate_rate_deg_per_min",
            settings.rotate_rate_deg_per_min,
            "rotate_units_per_deg",
            settings.rotate_units_per_deg,
        ),
        (
            "bend_rate_deg_per_min",
            settings.bend_rate_deg_per_min,
            "bend_units_per_deg",
            settings.bend_units_per_deg,
        ),
    ];
    for (rate_key, rate, units_key, units) in axes {
        within(rate_key, rate, MIN_RATE, MAX_RATE)?;
        within(units_key, units, MIN_UNITS, MAX_UNITS)?;
        if !(MIN_RATE..=1e6).contains(&(rate * units)) {
            let what = format!(
                "'{rate_key}' is {} in units of the machine; it can be {MIN_RATE} to 1000000",
                rate * units
            );
            return Err(refuse(what, format!("see whether '{units_key}' is right")));
        }
    }
    Ok(())
}

fn within(key: &str, value: f64, min: f64, max: f64) -> Result<(), DriverError> {
    if (min..=max).contains(&value) {
        return Ok(());
    }
    Err(refuse(format!("'{key}' is {value}"), format!("set it to {min} to {max}")))
}
