//! `run --repeat`, and jobs of several wires of which some were not begun.

use serde_json::json;

use super::runs::Shop;
use crate::{assert_fits, example};

/// What is simulated is in nobody's way, and so one yes is for all pieces; each has its record.
#[test]
fn one_yes_is_for_all_pieces_of_a_simulated_machine() {
    let shop = Shop::cube();
    let made = shop.make(&["--yes", "--json", "--repeat", "2", "--stock", "2000"]).ended(0).json();
    assert_fits("run", &made);
    assert_eq!((&made["pieces"]["made"], &made["pieces"]["of"]), (&json!(2), &json!(2)));
    assert_eq!((made["wires"].as_array().unwrap().len(), &made["left"]), (2, &json!([])));
    assert_eq!(shop.list().len(), 2);
}

/// A wire that was never begun is no success of `--resume`.
#[test]
fn what_was_never_begun_is_told_where_a_job_is_resumed() {
    let shop = Shop::with("two-parts.obj");
    shop.make(&["--yes", "--wire", "1"]).ended(0);
    let again = shop.make(&["--yes", "--resume"]).ended(2);
    assert!(String::from_utf8_lossy(&again.out).contains("wire 1: finished before"));
    assert!(again.err.contains("not begun: wire 2, so that there is nothing to resume"), "{}", again.err);
}

/// The wire waits at a pause for somebody who is not there: what it has fed until then is not left any more. 67.8, 59.6 and 51.6 mm are
/// the feeds of the first three steps, as `plan --json` has them.
#[test]
fn the_wire_that_is_left_is_less_what_an_interrupted_piece_has_fed() {
    let shop = Shop::with("house.obj");
    let plan = [
        "plan",
        &example("house.obj"),
        "-m",
        "wirebend-kit",
        "--pause",
        "3:turn it",
        "-o",
        "a.wbjob",
        "--force",
        "--json",
    ];
    let planned = shop.run(&plan).json();
    let feeds = planned["compensated"]["steps"].as_array().unwrap()[..3].iter();
    let fed: f64 = feeds.map(|step| step["feed_mm"].as_f64().unwrap()).sum();
    assert!((fed - 179.0).abs() < 0.1, "{fed}");
    let stopped = shop.make(&["--yes", "--json", "--repeat", "3", "--stock", "2000"]).json();
    assert_eq!(
        (&stopped["pieces"]["made"], &stopped["wires"][0]["made"]),
        (&json!(0), &json!(3)),
        "{stopped}"
    );
    let left = stopped["pieces"]["stock_left_mm"].as_f64().unwrap();
    assert!((2000.0 - fed - left).abs() < 0.1, "{left}");
}

/// A second piece would be bent into the first one, which nobody has cut off, however long the wire is.
#[cfg(target_os = "linux")]
#[test]
fn one_yes_is_refused_for_several_pieces_of_a_real_machine_before_anything_moves() {
    let (shop, board) = (Shop::cube(), super::board::Board::new(true));
    let run = ["run", "a.wbjob", "--port", &board.port, "--yes", "--repeat", "2", "--stock", "9000"];
    let said = shop.run(&[&run[..], &["--accept-settings"]].concat()).ended(2).err;
    assert!(said.contains("cut off") && said.contains("leave out --yes"), "{said}");
    assert!(shop.list().is_empty(), "nothing was begun");
}
