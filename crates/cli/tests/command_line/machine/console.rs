//! Lines that are typed for a machine, and its answers.

use crate::{Ran, assert_fits, run_in};

fn console(words: &[&str], input: &str) -> Ran {
    let folder = tempfile::tempdir().unwrap();
    let words = [&["console", "-m", "wirebend-kit", "--port", "sim:max"], words].concat();
    run_in(folder.path(), &words, input.as_bytes())
}

fn text(ran: &Ran) -> String {
    String::from_utf8(ran.out.clone()).unwrap()
}

#[test]
fn lines_of_standard_input_are_answered_with_their_time() {
    let asked = console(&["--json"], "version\n\nC4\n").ended(0).json();
    assert_fits("console", &asked);
    assert_eq!((&asked["answered"], &asked["of"]), (&2.into(), &2.into()));
    let lines = asked["lines"].as_array().unwrap();
    let texts: Vec<&str> = lines.iter().map(|line| line["text"].as_str().unwrap()).collect();
    assert!(texts[0].starts_with('S') && texts[1].starts_with('o') && texts[2] == "C4", "{texts:?}");
    assert!(lines.iter().all(|line| line["at"].as_str().unwrap().ends_with('Z')), "{lines:?}");
    // The same for a person, without the other lines of the connection.
    let said = text(&console(&["C4"], "").ended(0));
    assert_eq!(said.lines().count(), 2, "{said}");
    assert!(said.contains("Z -> C4") && said.contains("Z <- v4,"), "{said}");
}

#[test]
fn what_may_change_something_needs_a_yes() {
    let said = console(&["W4,1500"], "").ended(2);
    assert!(said.err.contains("line: W4,1500") && said.err.contains("--yes"), "{}", said.err);
    let written = text(&console(&["--yes", "W4,1500", "C4"], "").ended(0));
    assert!(written.contains("<- v4,1500"), "{written}");
}

#[test]
fn what_is_not_passed_on_ends_the_row_and_is_named() {
    let said = console(&["M1,100,0,0"], "").ended(5).err;
    assert!(said.contains("numbers the lines that move the machine"), "{said}");
    let ran = console(&["C4", "größe", "C5"], "").ended(5);
    let out = text(&ran);
    assert!(out.contains("v4,") && !out.contains("C5"), "{out}");
    assert!(ran.err.contains("ASCII"), "{}", ran.err);
    let said = console(&[], "").ended(2).err;
    assert!(said.contains("no line to send"), "{said}");
    let said = crate::run(&["console", "-m", "pensa-diwire-pro", "--port", "x", "?"]).ended(2).err;
    assert!(said.contains("files"), "{said}");
}
