//! What a machine would refuse in the middle of a wire is known before it is begun: what its driver and the machine itself say
//! of its axes holds for jobs, too, whenever they were planned.

use serde_json::{Value, json};

use super::bender::Bender;
use super::runs::Shop;
use crate::drivers::limits::machine;
use crate::grbl_model::Build;

/// The error of a run that is not begun.
fn refused(shop: &Shop, arguments: &[&str]) -> Value {
    let error = shop.run(&[arguments, &["--yes", "--json"]].concat()).ended(4).json()["error"].clone();
    assert_eq!(error["code"], "beyond-limit", "{error}");
    assert!(shop.list().is_empty(), "a wire was begun");
    error["message"].clone()
}

/// With its soft limits on the controller stops at a bend beyond its travel, with the wire in the machine.
#[test]
fn a_bend_beyond_the_travel_of_a_board_is_refused_before_the_wire() {
    let shop = Shop::on("u-sample.obj", "grbl-bender");
    let bender = Bender::new(Build { bend_travel: Some(60.0), switches: false, ..Build::default() });
    let message = refused(&shop, &["run", "a.wbjob", "--port", &bender.port]);
    let message = message.as_str().unwrap();
    assert!(message.contains("with step 1 the bend axis goes to") && message.contains("60.000"), "{message}");
    assert!(message.contains("$132") && message.contains("the machine takes"), "{message}");
    assert_eq!(bender.stands(), "[0.000, 0.000, 0.000]");
    // One that goes far enough bends it.
    let bender = Bender::new(Build { bend_travel: Some(130.0), switches: false, ..Build::default() });
    shop.run(&["run", "a.wbjob", "--port", &bender.port, "--yes", "--axes-at-zero"]).ended(0);
}

/// `$112`: however fast it is set to be, it is no faster.
#[test]
fn a_board_that_is_slower_than_its_profile_takes_longer() {
    let shop = Shop::on("u-sample.obj", "grbl-bender");
    let seconds = |bend_rate| {
        let bender = Bender::new(Build { bend_rate: Some(bend_rate), switches: false, ..Build::default() });
        // Without a yes it lists what will be bent, and nothing moves.
        let told = shop.run(&["run", "a.wbjob", "--port", &bender.port]).ended(2).err;
        let at = told.find(" on the machine").unwrap_or_else(|| panic!("{told}"));
        let words: Vec<&str> = told[..at].split_whitespace().rev().take(2).collect();
        words[1].parse::<f64>().unwrap() * if words[0] == "min" { 60.0 } else { 1.0 }
    };
    assert!(seconds(100.0) > 2.0 * seconds(500.0));
}

/// A job keeps the profile that it was planned for, and its maker may have passed over what the checks said.
#[test]
fn a_job_that_was_made_despite_the_driver_is_not_begun() {
    let shop = Shop::on("u-sample.obj", "wirebend-kit");
    machine(shop.path(), "short", "wirebend-kit", &json!({"feed_most_mm": 30}));
    let design = crate::example("u-sample.obj");
    let own = ["-m", "short", "-o", "b.wbjob", "--despite-errors"];
    shop.run(&[&["plan", &design][..], &own].concat()).ended(4);
    let message = refused(&shop, &["run", "b.wbjob"]);
    let message = message.as_str().unwrap();
    assert!(message.contains("its driver takes no more than 30.000 mm"), "{message}");
    assert!(message.contains("driver setting feed_most_mm"), "{message}");
}
