//! Values that have the right shape and make no sense all the same.

use wirebend_driver_api::DriverError;

use super::{Settings, template};

const LEAST_RATE: f64 = 0.01;
const MOST_RATE: f64 = 100_000.0;
const LEAST_UNITS: f64 = 0.0001;
const MOST_UNITS: f64 = 10_000.0;
const MOST_DECIMALS: u8 = 4;
/// A bend of half a turn is 1800 moves then.
const LEAST_ARC_DEG: f64 = 0.1;
const MOST_ARC_DEG: f64 = 360.0;
const MOST_DWELL_S: f64 = 60.0;

pub(super) fn check(settings: &Settings) -> Result<(), DriverError> {
    letters(settings)?;
    rates(settings)?;
    within("pin_dwell_s", settings.pin_dwell_s, 0.0, MOST_DWELL_S)?;
    within("arc_step_deg", settings.arc_step_deg, 0.0, MOST_ARC_DEG)?;
    within("arc_dwell_s", settings.arc_dwell_s, 0.0, MOST_DWELL_S)?;
    within("decimals", f64::from(settings.decimals), 0.0, f64::from(MOST_DECIMALS))?;
    within("baud", f64::from(settings.baud), 300.0, 4_000_000.0)?;
    if settings.arc_step_deg > 0.0 {
        within("arc_step_deg", settings.arc_step_deg, LEAST_ARC_DEG, MOST_ARC_DEG)?;
    }
    for (key, lines) in [
        ("pin_out", &settings.pin_out),
        ("pin_in", &settings.pin_in),
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
        within(rate_key, rate, LEAST_RATE, MOST_RATE)?;
        within(units_key, units, LEAST_UNITS, MOST_UNITS)?;
        if !(LEAST_RATE..=1e6).contains(&(rate * units)) {
            let what = format!(
                "'{rate_key}' is {} in units of the machine; it can be {LEAST_RATE} to 1000000",
                rate * units
            );
            return Err(refuse(what, format!("see whether '{units_key}' is right")));
        }
    }
    Ok(())
}

fn within(key: &str, value: f64, least: f64, most: f64) -> Result<(), DriverError> {
    if (least..=most).contains(&value) {
        return Ok(());
    }
    Err(refuse(format!("'{key}' is {value}"), format!("set it to {least} to {most}")))
}

pub(super) fn refuse(what: String, help: impl Into<String>) -> DriverError {
    DriverError::new("settings", what, help)
}
