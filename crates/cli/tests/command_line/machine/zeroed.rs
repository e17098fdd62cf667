//! A machine without switches: a person says that its axes stand at zero, each time that it is not known where they are.

use rustix::process::Signal;

use super::asked::Asked;
use super::bench::Bench;
use super::interrupted::Going;

/// What the profile `grbl-bender` allows, degrees, and half a step of the model.
const MAX_BEND_DEG: f64 = 120.0 + 0.5 / 80.0;
/// Where the axes stand at first.
const ZERO: &str = "[0.000, 0.000, 0.000]";

impl Bench {
    /// Begins the wire, and presses Ctrl-C in the middle of its first bend.
    fn stopped_in_a_bend(&self) {
        let going = Going::start(&self.shop, &self.run_with(&["--yes", "--axes-at-zero"]));
        self.until(|bender| bender.model.now().pin_out && bender.model.now().at[2] > 30.0);
        going.send(Signal::INT);
        going.end();
        let at = self.bender.model.now().at[2];
        assert!((30.0..90.0).contains(&at), "it stands in the middle of the bend: {at}");
    }
}

/// Without the option a script moves nothing, whatever else it says, and nothing is begun.
#[test]
fn yes_alone_does_not_say_where_the_axes_stand() {
    let bench = Bench::new();
    for arguments in [&["--yes"][..], &["--yes", "--json"]] {
        let ran = bench.run(arguments).ended(2);
        let said = ran.err.clone() + &String::from_utf8_lossy(&ran.out);
        assert!(said.contains("--axes-at-zero"), "{said}");
    }
    assert!(bench.shop.list().is_empty(), "a wire was begun");
    let jog = ["--yes", "b", "10"];
    assert!(bench.jog(&jog).ended(2).err.contains("--axes-at-zero"));
    assert_eq!(bench.bender.stands(), ZERO);
    bench.jog(&[&jog[..], &["--axes-at-zero"]].concat()).ended(0);
    assert_eq!(bench.bender.stands(), "[0.000, 0.000, 10.000]");
}

/// After STOP in a bend the axis stands where the bend has brought it. Taken as zero, the rest of the wire would bend from
/// there, farther than the machine can.
#[test]
fn a_wire_that_was_stopped_in_a_bend_goes_on_once_the_axes_stand_at_zero() {
    let bench = Bench::new();
    bench.stopped_in_a_bend();
    let stopped = bench.bender.stands();
    // Feed and head are done, so that the machine knows what is left. It was not confirmed that the axes were brought
    // back.
    let said = bench.run(&["--yes", "--resume"]).ended(2).err;
    assert!(said.contains("--axes-at-zero") && !said.contains("homes"), "{said}");
    assert_eq!(bench.bender.stands(), stopped, "something has moved");
    // A person is asked, and says no.
    let mut asked = Asked::start(&bench.shop, &bench.run_with(&["--resume"]));
    asked.sees("and resume?").says("yes");
    asked.sees("Does every axis stand at zero?").says("no");
    assert_eq!(asked.status(), Some(130));
    assert_eq!(bench.bender.stands(), stopped, "something has moved");
    // They turn them to their marks.
    bench.bender.model.turn_to_marks();
    let mut asked = Asked::start(&bench.shop, &bench.run_with(&["--resume"]));
    asked.sees("and resume?").says("yes");
    asked.sees("Does every axis stand at zero?").says("yes");
    assert_eq!(asked.status(), Some(0));
    let bends = bench.bender.model.end().bends;
    assert_eq!(bends.len(), 3, "the one that was stopped, and the two of the wire: {bends:?}");
    for [_, _, bend] in bends {
        assert!(bend.abs() <= MAX_BEND_DEG, "{bend}");
    }
}

/// What a person reads is what happens: nothing homes.
#[test]
fn nobody_is_told_of_a_search_that_does_not_happen() {
    let bench = Bench::new();
    let mut asked = Asked::start(&bench.shop, &bench.run_with(&[]));
    let told = asked.until("may the machine move?");
    assert!(told.contains("asked whether every axis stands at zero") && !told.contains("homes"), "{told}");
    asked.says("yes");
    let told = asked.until("Does every axis stand at zero?");
    assert!(told.contains("nothing moves for this"), "{told}");
    asked.says("no");
    assert_eq!(asked.status(), Some(130));
    assert!(bench.shop.list().is_empty(), "a wire was begun");
}

/// A homing in the middle of a list is asked about again. What was done before it stays done, and a script that did not
/// hear of it would do it twice.
#[test]
fn moves_before_a_question_that_nobody_answers_are_told() {
    let bench = Bench::new();
    let moves = ["f", "2", "r", "5", "home", "b", "10"];
    let scripted = [&["--yes", "--axes-at-zero"], &moves[..]].concat();
    let ran = bench.jog(&scripted).ended(2);
    let told = String::from_utf8_lossy(&ran.out).into_owned();
    assert!(told.contains("2 moves of 4 done") && told.contains("done: feed 2 mm, rotate 5\u{b0}"), "{told}");
    assert!(ran.err.contains("zero-not-confirmed") && ran.err.contains("--axes-at-zero"), "{}", ran.err);
    assert_eq!(bench.bender.stands(), "[2.000, 5.000, 0.000]");
    let found = bench.jog(&[&scripted[..], &["--json"]].concat()).ended(2).json();
    crate::assert_fits("jog", &found);
    let made = serde_json::json!([{"move": "feed", "mm": 2.0}, {"move": "rotate", "deg": 5.0}]);
    assert_eq!((&found["made"], &found["left_because"]), (&made, &serde_json::json!("nobody-asked")));
    // A person says no.
    let mut asked = Asked::start(&bench.shop, &bench.jog_with(&moves));
    asked.sees("May the machine move?").says("yes");
    asked.sees("count from where the axes stand now?").says("yes");
    asked.sees("Does every axis stand at zero?").says("no");
    assert_eq!(asked.status(), Some(130));
    assert_eq!(bench.bender.stands(), "[6.000, 15.000, 0.000]");
}
