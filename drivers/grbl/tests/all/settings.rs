//! Settings that make no sense are refused by key, before anything is written or moved.

use serde_json::{Value, json};
use wirebend_driver_api::{DriverError, MachineDriver};
use wirebend_driver_grbl::{Grbl, Settings};

fn open(settings: &Value) -> Result<Grbl, DriverError> {
    let settings = serde_json::from_value(settings.clone()).expect("settings of the right shape");
    Grbl::open(settings)
}

#[test]
fn keeps_the_rules() {
    wirebend_driver_api::conformance::assert_kept::<Grbl>();
}

#[test]
fn values_that_make_no_sense_are_refused_by_key() {
    for (settings, key) in [
        (json!({"feed_axis": "Z"}), "bend_axis"),
        (json!({"feed_rate_mm_per_min": 0}), "feed_rate_mm_per_min"),
        (json!({"rotate_rate_deg_per_min": -1}), "rotate_rate_deg_per_min"),
        (json!({"bend_rate_deg_per_min": 1e9}), "bend_rate_deg_per_min"),
        (json!({"feed_units_per_mm": 0}), "feed_units_per_mm"),
        // 0.01 a minute at a ten-thousandth of a unit for each mm would be written as F0.
        (json!({"feed_units_per_mm": 0.0001, "feed_rate_mm_per_min": 0.01}), "feed_rate_mm_per_min"),
        (json!({"decimals": 5}), "decimals"),
        (json!({"pin_dwell_s": -0.1}), "pin_dwell_s"),
        (json!({"arc_step_deg": 0.01}), "arc_step_deg"),
        (json!({"arc_step_deg": 361}), "arc_step_deg"),
        (json!({"arc_dwell_s": 61}), "arc_dwell_s"),
        (json!({"baud": 0}), "baud"),
        (json!({"expected": {"100": 80}}), "'100'"),
        (json!({"expected": {"$x": 80}}), "'$x'"),
        (json!({"pin_out": ["M3 {speed}"]}), "'pin_out', line 1"),
        (json!({"pin_in": ["M5", "!"]}), "'pin_in', line 2"),
        (json!({"start_block": ["$H"]}), "'start_block', line 1"),
        (json!({"end_block": ["({nobody})"]}), "{nobody} is not a placeholder"),
    ] {
        let error = open(&settings).expect_err(&settings.to_string());
        assert_eq!(error.code, "settings");
        assert!(error.to_string().contains(key), "{settings}: {error}");
        assert!(!error.help.is_empty(), "{error}");
    }
}

#[test]
fn what_is_written_of_settings_is_read_back() {
    let text = serde_json::to_string(&Settings::default()).unwrap();
    assert_eq!(serde_json::from_str::<Settings>(&text).unwrap(), Settings::default());
    let words = json!({
        "mode": "absolute", "moves": "rapid", "comments": "semicolon", "homing": "switches",
        "streaming": "character-counting", "rotate_axis": "A", "expected": {"$100": 80.0}
    });
    assert!(open(&words).is_ok());
}

#[test]
fn the_settings_of_the_machine_that_comes_with_the_program_are_taken() {
    let profile = include_str!("../../../../machine-profiles/machines/grbl-bender.json");
    let profile: Value = serde_json::from_str(profile).unwrap();
    assert_eq!(profile["driver"]["id"], "grbl");
    assert!(open(&profile["driver"]["settings"]).is_ok());
}
