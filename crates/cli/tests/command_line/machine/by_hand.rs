//! Moves by hand: done, recorded, replayed, refused.

use serde_json::{Value, json};

use super::runs::Shop;
use crate::{Ran, assert_fits};

fn jog(shop: &Shop, words: &[&str]) -> Ran {
    shop.run(&[&["jog", "-m", "wirebend-kit", "--port", "sim:max"], words].concat())
}

#[test]
fn moves_are_made_recorded_and_replayed() {
    let shop = Shop::cube();
    let made = jog(
        &shop,
        &["--yes", "--json", "--record", "a.wbmoves", "home", "f", "10", "b", "45", "r", "-90", "f", "-5"],
    );
    let made = made.ended(0).json();
    assert_fits("jog", &made);
    let moves = json!([
        {"move": "home"},
        {"move": "feed", "mm": 10.0},
        {"move": "bend", "deg": 45.0},
        {"move": "rotate", "deg": -90.0},
        {"move": "feed", "mm": -5.0},
    ]);
    assert_eq!((&made["made"], &made["of"]), (&moves, &json!(5)));
    let file = shop.path().join("a.wbmoves");
    let recorded: Value = serde_json::from_slice(&std::fs::read(&file).unwrap()).unwrap();
    assert_eq!((&recorded["moves"], &recorded["machine"]), (&moves, &json!("wirebend-kit")));

    let again = shop.run(&["replay", "a.wbmoves", "--port", "sim:max", "--yes", "--json"]).ended(0).json();
    assert_fits("replay", &again);
    assert_eq!(again["made"], moves);
    let said = shop.run(&["replay", "a.wbmoves", "--port", "sim:max"]).ended(2).err;
    assert!(said.contains("--yes") && said.contains("rotate -90°"), "{said}");
    // What is there is not written over, and nothing moves before that is known.
    jog(&shop, &["--yes", "--record", "a.wbmoves", "f", "1"]).ended(2);
}

/// Another program would say of such a file that it is damaged.
#[test]
fn recordings_under_the_name_of_another_kind_are_noted() {
    let shop = Shop::cube();
    let note =
        |ending: &str, what: &str| format!("note: the name ends in .{ending}, and what is written is {what}");
    let said = shop.make(&["--yes", "--record", "a.svg"]).ended(0).err;
    assert!(said.contains(&note("svg", "the record of a wire")), "{said}");
    let id = shop.list()[0]["id"].as_str().unwrap().to_owned();
    let said = shop.run(&["runs", "export", &id, "-o", "b.stl"]).ended(0).err;
    assert!(said.contains(&note("stl", "the record of a wire")), "{said}");
    let said = jog(&shop, &["--yes", "--record", "a.txt", "f", "1"]).ended(0).err;
    assert!(said.contains(&note("txt", "recorded moves")), "{said}");
}

#[test]
fn a_dry_run_makes_the_moves_of_one_wire() {
    let shop = Shop::cube();
    let dry = |more: &[&str]| shop.run(&[&["dry-run", "a.wbjob", "--port", "sim:max"], more].concat());
    let made = dry(&["--yes", "--json"]).ended(0).json();
    assert_fits("dry-run", &made);
    assert_eq!(json!(made["made"].as_array().unwrap().len()), made["of"]);
    let said = dry(&[]).ended(2).err;
    for words in ["remove the wire from the machine", "the peg stays in", "--yes"] {
        assert!(said.contains(words), "{words}: {said}");
    }
    let said = dry(&["--yes", "--wire", "2"]).ended(2).err;
    assert!(said.contains("there is no wire 2"), "{said}");
    let two = Shop::with("two-parts.obj");
    let said = two.run(&["dry-run", "a.wbjob", "--port", "sim:max", "--yes"]).ended(2).err;
    assert!(said.contains("the job has 2 wires") && said.contains("--wire"), "{said}");
    two.run(&["dry-run", "a.wbjob", "--port", "sim:max", "--yes", "--wire", "2"]).ended(0);
}

/// A head that can bend to 40 degrees only: the firmware was not told so.
#[test]
fn a_bend_by_hand_stays_within_what_the_profile_says() {
    let shop = Shop::cube();
    let set = ["profile", "set", "mine", "--from", "wirebend-kit", "--kind", "machine", "--source", "a rule"];
    shop.run(&[&set[..], &["bend.axis_limit_deg=40"]].concat()).ended(0);
    let jog = |moves: &[&str]| {
        shop.run(&[&["jog", "--machine", "mine", "--port", "sim:max", "--yes"], moves].concat())
    };
    let said = jog(&["home", "b", "-41"]).ended(2).err;
    assert!(said.contains("-41.0°") && said.contains("40.0°"), "{said}");
    jog(&["home", "b", "-40"]).ended(0);
}

#[test]
fn a_recording_is_for_its_machine() {
    let shop = Shop::cube();
    jog(&shop, &["--yes", "--record", "a.wbmoves", "f", "10"]).ended(0);
    let file = shop.path().join("a.wbmoves");
    let text = std::fs::read_to_string(&file).unwrap();
    shop.run(&["profile", "new", "my-kit", "--from", "wirebend-kit", "--kind", "machine", "--name", "Mine"])
        .ended(0);
    let replay =
        |more: &[&str]| shop.run(&[&["replay", "a.wbmoves", "--port", "sim:max", "--yes"], more].concat());
    // Said by name, it is replayed elsewhere, and a person hears of it.
    let said = replay(&["--machine", "my-kit"]).ended(0).err;
    assert!(said.contains("recorded on 'wirebend-kit', not on 'my-kit'"), "{said}");
    // The machine's profile is not what it was.
    let hash: Value = serde_json::from_str(&text).unwrap();
    let other = text.replace(hash["profile_hash"].as_str().unwrap(), &"0".repeat(64));
    std::fs::write(&file, other).unwrap();
    let said = replay(&[]).ended(2).err;
    assert!(said.contains("before the profile of 'wirebend-kit' was changed"), "{said}");
    replay(&["--machine", "wirebend-kit"]).ended(0);
}

#[test]
fn what_is_no_recording_is_refused_with_its_place() {
    let shop = Shop::cube();
    jog(&shop, &["--yes", "--record", "a.wbmoves", "f", "10"]).ended(0);
    let good = std::fs::read_to_string(shop.path().join("a.wbmoves")).unwrap();
    for (text, said) in [
        ("no JSON".to_owned(), "no recording"),
        ("{}".to_owned(), "\"wbmoves\""),
        (good.replace("\"version\": 1", "\"version\": 9"), "newer"),
        (good.replace("\"mm\"", "\"inch\""), "line"),
        (good.replace("10.0", "1e999"), "out of range"),
    ] {
        std::fs::write(shop.path().join("b.wbmoves"), &text).unwrap();
        let ran = shop.run(&["replay", "b.wbmoves", "--port", "sim:max", "--yes"]).ended(3);
        assert!(ran.err.contains(said), "{said}: {}", ran.err);
    }
}

#[test]
fn what_is_no_move_is_refused_before_anything_is_connected() {
    let shop = Shop::cube();
    for words in [&["--yes", "f"][..], &["--yes", "x", "1"], &["--yes", "b", "ten"]] {
        jog(&shop, words).ended(2);
    }
    let said = jog(&shop, &["f", "10"]).ended(2).err;
    assert!(said.contains("--yes") && said.contains("feed 10 mm"), "{said}");
    let said =
        shop.run(&["jog", "-m", "pensa-diwire-pro", "--port", "/dev/null", "--yes", "f", "1"]).ended(2).err;
    assert!(said.contains("writes files"), "{said}");
    let said = shop.run(&["jog", "-m", "nobody", "--port", "sim", "--yes", "f", "1"]).ended(2).err;
    assert!(said.contains("nobody"), "{said}");
}

/// A machine says no in the middle: what was done is reported and recorded, the rest is not done.
#[test]
fn what_was_made_before_a_refusal_is_told() {
    let shop = Shop::cube();
    let words = ["--yes", "--json", "--record", "a.wbmoves", "f", "10", "r", "400", "f", "10"];
    let made = jog(&shop, &words).ended(5).json();
    assert_fits("jog", &made);
    assert_eq!(made["made"], json!([{"move": "feed", "mm": 10.0}]));
    assert!(made["problem"]["message"].as_str().unwrap().contains("soft limit"), "{made}");
    let recorded: Value =
        serde_json::from_slice(&std::fs::read(shop.path().join("a.wbmoves")).unwrap()).unwrap();
    assert_eq!(recorded["moves"], made["made"]);
}
