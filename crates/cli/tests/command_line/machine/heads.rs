//! Where the head stands, from one command to the next, on a machine whose axes a person brings to zero.

use rustix::process::Signal;

use super::asked::Asked;
use super::bench::Bench;
use super::board::Board;
use super::interrupted::Going;
use super::runs::Shop;

impl Bench {
    fn stands_deg(&self) -> f64 {
        self.bender.model.now().at[1]
    }

    #[track_caller]
    fn is_at(&self, deg: f64) {
        assert!((self.stands_deg() - deg).abs() < 0.1, "{} instead of {deg}", self.stands_deg());
    }
}

/// The profile lets it turn by 180° either way. Each command counts its moves from where it begins.
#[test]
fn turns_of_one_command_after_the_other_are_added_up() {
    let bench = Bench::new();
    bench.jog(&["--yes", "--axes-at-zero", "--head-at", "0", "r", "100"]).ended(0);
    let said = bench.jog(&["--yes", "--axes-at-zero", "r", "100"]).ended(2).err;
    assert!(said.contains("100.0°") && said.contains("200.0°") && said.contains("180°"), "{said}");
    bench.is_at(100.0);
    // A user who says in a script that every axis stands at zero has said it before the head was turned.
    let said = bench.run(&["--yes", "--axes-at-zero"]).ended(2).err;
    assert!(said.contains("left at 100.0°") && said.contains("--head-at=0"), "{said}");
    assert!(bench.shop.list().is_empty(), "a wire was begun");
    bench.is_at(100.0);
    bench.jog(&["--yes", "--axes-at-zero", "r", "-100"]).ended(0);
    bench.run(&["--yes", "--axes-at-zero"]).ended(0);
    bench.is_at(0.0);
}

/// Ctrl-C in the middle of a turn: the machine says where it stands, and that is kept.
#[test]
fn a_turn_that_was_stopped_is_counted_as_far_as_it_came() {
    let bench = Bench::new();
    let going =
        Going::start(&bench.shop, &bench.jog_with(&["--yes", "--axes-at-zero", "--head-at=0", "r", "-170"]));
    bench.until(|bender| bender.model.now().at[1] <= -40.0);
    going.send(Signal::INT);
    assert_eq!(going.end().0, Some(130));
    let stands = bench.stands_deg();
    assert!((-169.0..=-40.0).contains(&stands), "it stands in the middle of the turn: {stands}");
    let said = bench.run(&["--yes", "--axes-at-zero"]).ended(2).err;
    assert!(said.contains(&format!("left at {stands:.1}°")), "{stands}: {said}");
    // Farther than the cable allows it cannot be.
    let said = bench.run(&["--yes", "--axes-at-zero", "--head-at=200"]).ended(2).err;
    assert!(said.contains("200°") && said.contains("-180° to 180°"), "{said}");
    // A person reads that, turns it to its mark, and says so.
    bench.bender.model.turn_to_marks();
    let mut asked = Asked::start(&bench.shop, &bench.run_with(&[]));
    asked.sees("may the machine move?").says("yes");
    let told = asked.until("Does every axis stand at zero?");
    assert!(told.contains(&format!("left at {stands:.1}°")), "{told}");
    asked.says("yes");
    assert_eq!(asked.status(), Some(0));
    bench.is_at(0.0);
}

/// A program that was killed has heard nothing of the end of the turn: it stands somewhere on it, at whatever port the machine
/// turns up then.
#[test]
fn a_turn_of_which_nobody_heard_the_end_is_told_as_a_range() {
    let bench = Bench::new();
    let going =
        Going::start(&bench.shop, &bench.jog_with(&["--yes", "--axes-at-zero", "--head-at=0", "r", "170"]));
    bench.until(|bender| bender.model.now().at[1] >= 20.0);
    going.send(Signal::KILL);
    going.end();
    let bench = bench.plugged_in_anew();
    let said = bench.run(&["--yes", "--axes-at-zero"]).ended(2).err;
    assert!(said.contains("between 0.0° and 170.0°") && said.contains("--head-at=0"), "{said}");
    bench.bender.model.turn_to_marks();
    bench.run(&["--yes", "--axes-at-zero", "--head-at=0"]).ended(0);
}

/// At a terminal: what makes no sense is asked again, and a head that was left turned is confirmed or corrected.
#[test]
fn a_person_at_a_terminal_says_where_the_head_stands() {
    let (shop, board) = (Shop::with("cube-8-edges.obj"), Board::new(true));
    let jog = ["jog", "-m", "wirebend-kit", "--port", &board.port];
    shop.run(&[&jog[..], &["--yes", "r", "30"]].concat()).ended(0);
    for (says, stands) in [("", "30.0°"), ("25", "25.0°")] {
        let mut asked = Asked::start(&shop, &[&jog[..], &["r", "30"]].concat());
        let told_first = asked.until("still at 30.0]");
        assert!(told_first.contains("left at 30.0°"), "{told_first}");
        asked.says(says);
        let about = asked.until("May the machine move?");
        assert!(
            about.contains("turned back to zero first")
                && about.contains(&format!("{stands} from its zero (as you have said)")),
            "{about}"
        );
        asked.says("yes");
        assert_eq!(asked.status(), Some(0));
    }
    let record = std::fs::read_dir(shop.path().join("wirebend/runs/heads")).unwrap().next().unwrap().unwrap();
    std::fs::write(record.path(), "damaged").unwrap();
    let mut asked = Asked::start(&shop, &[&jog[..], &["home"]].concat());
    asked.sees("Where does the head stand").says("400");
    asked.sees("no number from -360 to 360").says("-45");
    let about = asked.until("May the machine move?");
    assert!(about.contains("-45.0°"), "{about}");
    asked.says("no");
    assert_eq!(asked.status(), Some(130));
}

/// A machine that is simulated is a new one each time: the user is not asked, and nothing is kept.
#[test]
fn of_a_simulated_machine_nothing_is_kept() {
    let shop = Shop::cube();
    for _ in 0..2 {
        shop.run(&["jog", "-m", "wirebend-kit", "--port", "sim:max", "--yes", "r", "300"]).ended(0);
    }
    shop.make(&["--yes"]).ended(0);
    assert!(!shop.path().join("wirebend/runs/heads").exists());
}
