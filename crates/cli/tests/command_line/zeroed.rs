//! A machine without switches: a person says that its axes stand at zero, each time that nobody knows where they are.

use std::time::{Duration, Instant};

use rustix::process::Signal;

use crate::Ran;
use crate::asked::Asked;
use crate::bender::Bender;
use crate::interrupted::Going;
use crate::runs::Shop;

const PATIENCE: Duration = Duration::from_mins(1);
/// What the profile `grbl-bender` allows, degrees, and half a step of the model.
const MOST_BEND_DEG: f64 = 120.0 + 0.5 / 80.0;
/// Where the axes stand at first.
const ZERO: &str = "[0.000, 0.000, 0.000]";

/// A bender, and a job for it.
struct Bench {
    shop: Shop,
    bender: Bender,
}

impl Bench {
    fn new() -> Self {
        Self { shop: Shop::on("u-sample.obj", "grbl-bender"), bender: Bender::without_switches() }
    }

    fn arguments<'a>(&'a self, more: &[&'a str]) -> Vec<&'a str> {
        [&["run", "a.wbjob", "--port", &self.bender.port], more].concat()
    }

    fn run(&self, more: &[&str]) -> Ran {
        self.shop.run(&self.arguments(more))
    }

    /// Begins the wire, and presses Ctrl-C in the middle of its first bend.
    fn stopped_in_a_bend(&self) {
        let going = Going::start(&self.shop, &self.arguments(&["--yes", "--axes-at-zero"]));
        let begun = Instant::now();
        while !(self.bender.model.now().pin_out && self.bender.model.now().at[2] > 30.0) {
            assert!(begun.elapsed() < PATIENCE, "it does not bend: {:?}", self.bender.model.now());
            std::thread::yield_now();
        }
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
    let jog = ["jog", "-m", "grbl-bender", "--port", &bench.bender.port, "--yes", "b", "10"];
    assert!(bench.shop.run(&jog).ended(2).err.contains("--axes-at-zero"));
    assert_eq!(bench.bender.stands(), ZERO);
    bench.shop.run(&[&jog[..], &["--axes-at-zero"]].concat()).ended(0);
    assert_eq!(bench.bender.stands(), "[0.000, 0.000, 10.000]");
}

/// After STOP in a bend the axis stands where the bend has brought it. Taken as zero, the rest of the wire would bend from
/// there, farther than the machine can.
#[test]
fn a_wire_that_was_stopped_in_a_bend_goes_on_once_the_axes_stand_at_zero() {
    let bench = Bench::new();
    bench.stopped_in_a_bend();
    let stopped = bench.bender.stands();
    // Feed and head have made their way, so that the machine knows what is left. Nobody has said that the axes were brought
    // back.
    let said = bench.run(&["--yes", "--resume"]).ended(2).err;
    assert!(said.contains("--axes-at-zero") && !said.contains("searches"), "{said}");
    assert_eq!(bench.bender.stands(), stopped, "something has moved");
    // A person is asked, and says no.
    let mut asked = Asked::start(&bench.shop, &bench.arguments(&["--resume"]));
    asked.sees("go on?").says("yes");
    asked.sees("Does every axis stand at zero?").says("no");
    assert_eq!(asked.status(), Some(130));
    assert_eq!(bench.bender.stands(), stopped, "something has moved");
    // They turn them to their marks.
    bench.bender.model.turn_to_marks();
    let mut asked = Asked::start(&bench.shop, &bench.arguments(&["--resume"]));
    asked.sees("go on?").says("yes");
    asked.sees("Does every axis stand at zero?").says("yes");
    assert_eq!(asked.status(), Some(0));
    let bends = bench.bender.model.end().bends;
    assert_eq!(bends.len(), 3, "the one that was stopped, and the two of the wire: {bends:?}");
    for [_, _, bend] in bends {
        assert!(bend.abs() <= MOST_BEND_DEG, "{bend}");
    }
}

/// What a person reads is what happens: nothing searches anything.
#[test]
fn nobody_is_told_of_a_search_that_does_not_happen() {
    let bench = Bench::new();
    let mut asked = Asked::start(&bench.shop, &bench.arguments(&[]));
    let told = asked.until("may the machine move?");
    assert!(told.contains("asked whether every axis stands at zero") && !told.contains("searches"), "{told}");
    asked.says("yes");
    let told = asked.until("Does every axis stand at zero?");
    assert!(told.contains("nothing moves for this"), "{told}");
    asked.says("no");
    assert_eq!(asked.status(), Some(130));
    assert!(bench.shop.list().is_empty(), "a wire was begun");
}

/// A search for zero in the middle of a list is asked about anew. What was made before it is made, and a script that was told
/// nothing of it would make it twice.
#[test]
fn moves_before_a_question_that_nobody_answers_are_told() {
    let bench = Bench::new();
    let jog = ["jog", "-m", "grbl-bender", "--port", &bench.bender.port];
    let moves = ["f", "2", "r", "5", "home", "b", "10"];
    let scripted = [&jog[..], &["--yes", "--axes-at-zero"], &moves].concat();
    let ran = bench.shop.run(&scripted).ended(2);
    let told = String::from_utf8_lossy(&ran.out).into_owned();
    assert!(told.contains("2 moves of 4 made") && told.contains("made: feed 2 mm, rotate 5\u{b0}"), "{told}");
    assert!(ran.err.contains("zero-not-confirmed") && ran.err.contains("--axes-at-zero"), "{}", ran.err);
    assert_eq!(bench.bender.stands(), "[2.000, 5.000, 0.000]");
    let found = bench.shop.run(&[&scripted[..], &["--json"]].concat()).ended(2).json();
    crate::assert_fits("jog", &found);
    let made = serde_json::json!([{"move": "feed", "mm": 2.0}, {"move": "rotate", "deg": 5.0}]);
    assert_eq!((&found["made"], &found["left_because"]), (&made, &serde_json::json!("nobody-asked")));
    // A person says no.
    let mut asked = Asked::start(&bench.shop, &[&jog[..], &moves].concat());
    asked.sees("May the machine move?").says("yes");
    asked.sees("count from where the axes stand now?").says("yes");
    asked.sees("Does every axis stand at zero?").says("no");
    assert_eq!(asked.status(), Some(130));
    assert_eq!(bench.bender.stands(), "[6.000, 15.000, 0.000]");
}
