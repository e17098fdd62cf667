//! A person at a terminal: they are asked, and what they answer is what happens.

use std::fs::{self, File};
use std::io::{Read, Write};
use std::process::{Child, Command, Stdio};

use rustix::process::{Pid, Signal, kill_process};
use serde_json::json;

use super::board::terminal;
use super::runs::Shop;
use crate::{example, wirebend};

/// The program with a person in front of it.
pub struct Asked {
    child: Child,
    person: File,
    seen: String,
}

impl Asked {
    pub fn start(shop: &Shop, arguments: &[&str]) -> Self {
        Self::start_with(shop, arguments, None, Stdio::null())
    }

    /// Its input is the terminal, or comes from elsewhere; what it prints for another program goes there.
    fn start_with(shop: &Shop, arguments: &[&str], input: Option<Stdio>, output: Stdio) -> Self {
        let (far, near, _) = terminal();
        let near = File::from(near);
        let input = input.unwrap_or_else(|| near.try_clone().unwrap().into());
        let child = Command::new(wirebend())
            .args(arguments)
            .current_dir(shop.path())
            .env("XDG_CONFIG_HOME", shop.path())
            .env("XDG_DATA_HOME", shop.path())
            .stdin(input)
            .stdout(output)
            .stderr(near)
            .spawn()
            .unwrap();
        Self { child, person: File::from(far), seen: String::new() }
    }

    pub fn sees(&mut self, what: &str) -> &mut Self {
        self.until(what);
        self
    }

    /// Which of these comes first.
    fn sees_one_of(&mut self, these: [&str; 2]) -> usize {
        loop {
            if let Some(first) = these.iter().position(|one| self.seen.contains(one)) {
                self.seen.clear();
                return first;
            }
            self.read();
        }
    }

    fn read(&mut self) {
        let mut bytes = [0; 1024];
        // A terminal that was closed ends with an error.
        let count = self.person.read(&mut bytes).unwrap_or_default();
        assert!(count > 0, "no more than {}", self.seen);
        self.seen.push_str(&String::from_utf8_lossy(&bytes[..count]));
    }

    /// What was said until then.
    pub fn until(&mut self, what: &str) -> String {
        while !self.seen.contains(what) {
            self.read();
        }
        std::mem::take(&mut self.seen)
    }

    pub fn says(&mut self, line: &str) -> &mut Self {
        writeln!(self.person, "{line}").unwrap();
        self
    }

    pub fn presses_ctrl_c(&mut self) -> &mut Self {
        kill_process(Pid::from_raw(i32::try_from(self.child.id()).unwrap()).unwrap(), Signal::INT).unwrap();
        self
    }

    pub fn status(&mut self) -> Option<i32> {
        self.ends().0
    }

    /// Its status, and what it has said and nobody has looked for.
    fn ends(&mut self) -> (Option<i32>, String) {
        // What it writes must go somewhere, or it waits. The end of a terminal is an error.
        let mut rest = Vec::new();
        let _ = self.person.read_to_end(&mut rest);
        let said = std::mem::take(&mut self.seen) + &String::from_utf8_lossy(&rest);
        (self.child.wait().unwrap().code(), said)
    }
}

const RUN: [&str; 4] = ["run", "a.wbjob", "--port", "sim:max"];

#[test]
fn a_wire_is_made_at_a_persons_word_and_the_next_at_another() {
    let shop = Shop::with("two-parts.obj");
    let mut asked = Asked::start(&shop, &RUN);
    asked.sees("may the machine move?").says("yes");
    asked.sees("new wire in").says("y");
    assert_eq!(asked.status(), Some(0));
    assert_eq!(shop.list().len(), 2);
}

#[test]
fn no_is_no_and_so_is_nothing_and_ctrl_c() {
    let shop = Shop::cube();
    for answer in ["n", "", "maybe\nno"] {
        let mut asked = Asked::start(&shop, &RUN);
        asked.sees("may the machine move?").says(answer);
        assert_eq!(asked.status(), Some(130), "{answer:?}");
    }
    let mut asked = Asked::start(&shop, &RUN);
    asked.sees("may the machine move?");
    asked.presses_ctrl_c();
    assert_eq!(asked.status(), Some(130));
    assert!(shop.list().is_empty(), "nothing was begun");
}

/// After a crash a person looks at the wire, and says step by step what they see.
#[test]
fn a_person_says_what_became_of_steps_in_doubt() {
    let shop = Shop::cube();
    let mut going = super::interrupted::Going::start(&shop, &["run", "a.wbjob", "--port", "sim:10", "--yes"]);
    going.until("step 2 of 8 is done");
    going.send(Signal::KILL);
    going.end();
    let mut asked = Asked::start(&shop, &[&RUN[..], &["--resume"]].concat());
    asked.sees("Was this step finished?").says("I do not know");
    // They are told how to find out, and may not be able to.
    let told = asked.until("mm of it were fed");
    assert!(told.contains("Count the bends"), "{told}");
    asked.says("");
    assert_eq!(asked.status(), Some(2), "it is not known, and so nothing moves");
    let mut asked = Asked::start(&shop, &[&RUN[..], &["--resume"]].concat());
    asked.sees("Was this step finished?");
    asked.presses_ctrl_c();
    assert_eq!(asked.status(), Some(130), "that is no answer");
    let mut asked = Asked::start(&shop, &[&RUN[..], &["--resume"]].concat());
    asked.sees("Was this step finished?").says("yes");
    asked.sees("Was this step finished?").says("no");
    // What cannot be is asked again.
    asked.sees("mm of it were fed").says("1000");
    asked.sees("mm of it were fed").says("4,5");
    // Which of the steps turn the head is for the plan to say.
    if asked.sees_one_of(["degrees was it turned", "and resume?"]) == 0 {
        asked.says("0").sees("and resume?");
    }
    asked.says("yes");
    assert_eq!(asked.status(), Some(0));
    assert_eq!(shop.list()[0]["outcome"], "finished");
}

/// An answer counts once it is given, and a person who said no to the rest may find that it was wrong.
#[test]
fn what_was_said_before_is_asked_again_and_can_be_corrected() {
    let shop = Shop::cube();
    let mut going = super::interrupted::Going::start(&shop, &["run", "a.wbjob", "--port", "sim:10", "--yes"]);
    going.until("step 2 of 8 is done");
    going.send(Signal::KILL);
    going.end();
    let resume = || Asked::start(&shop, &[&RUN[..], &["--resume"]].concat());
    let mut asked = resume();
    while asked.sees_one_of(["Was this step finished?", "and resume?"]) == 0 {
        asked.says("yes");
    }
    asked.says("no");
    assert_eq!(asked.status(), Some(130));
    let mut asked = resume();
    let told = asked.until("Is that so?");
    assert!(told.contains("You have said before: step"), "{told}");
    asked.says("no");
    asked.sees("Was this step finished?").says("no");
    asked.sees("mm of it were fed").says("0");
    if asked.sees_one_of(["degrees was it turned", "and resume?"]) == 0 {
        asked.says("0").sees("and resume?");
    }
    asked.says("yes");
    assert_eq!(asked.status(), Some(0));
    let id = shop.list()[0]["id"].as_str().unwrap().to_owned();
    let shown = shop.run(&["runs", "show", &id]).ended(0);
    let shown = String::from_utf8(shown.out).unwrap();
    let decided: Vec<&str> = shown.lines().filter(|line| line.contains("decided")).collect();
    assert_eq!(decided.len(), 1, "{shown}");
    assert!(decided[0].contains("0.0 mm were fed") || decided[0].contains("was not done"), "{shown}");
}

/// A person who opened the door of a machine, or pressed its button, may be at it still.
#[test]
fn a_machine_that_was_made_to_hold_goes_on_at_a_persons_word() {
    for (answer, status, outcome) in [("yes", 0, "finished"), ("no", 130, "unfinished")] {
        let shop = Shop::cube();
        let driver = shop.path().join("mine/hostile.so");
        fs::create_dir(shop.path().join("mine")).unwrap();
        fs::copy(wirebend_tests_built::driver("hostile"), &driver).unwrap();
        let settings = json!({"machine": shop.path().join("kept"), "faults": [{"at": 2, "how": "hold"}]});
        let profile = json!({"schema_version": 1, "kind": "machine", "id": "held", "inherits": "wirebend-kit",
            "driver": {"id": "hostile", "settings": settings}, "export": {"native": "hostile-text"}});
        fs::create_dir_all(shop.path().join("wirebend/machines")).unwrap();
        fs::write(shop.path().join("wirebend/machines/held.json"), profile.to_string()).unwrap();
        let mine = ["--driver-path", "mine"];
        let hash =
            shop.run(&["driver", "trust", "mine/hostile.so", "--json"]).ended(2).json()["sha256"].clone();
        shop.run(&["driver", "trust", "mine/hostile.so", "--sha256", hash.as_str().unwrap()]).ended(0);
        let plan = ["plan", &example("cube-8-edges.obj"), "-m", "held", "-o", "held.wbjob"];
        shop.run(&[&plan[..], &mine].concat()).ended(0);
        let run = ["run", "held.wbjob", "--port", "anywhere", "--yes"];
        let mut asked = Asked::start(&shop, &[&run[..], &mine].concat());
        asked.sees("paused at the machine itself. May it resume?").says(answer);
        assert_eq!(asked.status(), Some(status), "{answer}");
        assert_eq!(shop.list()[0]["outcome"], outcome);
        let made = fs::read_to_string(shop.path().join("kept")).unwrap();
        let expected = if answer == "yes" { r#""made":[1,2,3,4,5,6,7,8]"# } else { r#""made":[1,2]"# };
        assert!(made.contains(expected), "{made}");
    }
}

/// Who sees something wrong pauses the wire with the largest key, looks, and lets it resume.
#[test]
fn enter_pauses_a_wire_and_enter_resumes_it() {
    let shop = Shop::cube();
    let mut asked = Asked::start(&shop, &["run", "a.wbjob", "--port", "sim:10", "--yes", "-v"]);
    asked.sees("press Enter to pause").sees("step 1 of 8 is done").says("");
    asked.sees("paused; press Enter to resume");
    // A word is no Enter.
    asked.says("go").says("");
    let said = asked.until("resumed");
    assert!(!said.contains("is done"), "a step was done while it was paused: {said}");
    let said = asked.until("step 8 of 8 is done");
    assert!(!said.contains("press Enter"), "it is said once for each wire: {said}");
    assert_eq!(asked.status(), Some(0));
    assert_eq!(shop.list()[0]["outcome"], "finished");
}

/// A script that feeds the program would pause the machine, and lose its own input.
#[test]
fn what_is_piped_to_a_run_is_left_to_others() {
    let shop = Shop::cube();
    let (unread, input) = rustix::pipe::pipe().unwrap();
    let mut input = File::from(input);
    input.write_all(b"\n\nof others\n").unwrap();
    let piped = unread.try_clone().unwrap().into();
    let mut asked = Asked::start_with(&shop, &[&RUN[..], &["--yes"]].concat(), Some(piped), Stdio::null());
    let (status, said) = asked.ends();
    assert_eq!(status, Some(0), "{said}");
    assert!(said.contains("watch it") && !said.contains("Enter") && !said.contains("paused"), "{said}");
    drop(input);
    let mut left = String::new();
    File::from(unread).read_to_string(&mut left).unwrap();
    assert_eq!(left, "\n\nof others\n");
}

/// The cube of this size has no program that hits nothing: its search would go on for hours.
const SEARCH: [&str; 12] = [
    "--units",
    "mm",
    "--double",
    "-m",
    "wirebend-kit",
    "--avoid-collisions",
    "--wires",
    "1",
    "--effort",
    "4000000000",
    "-o",
    "best.wbjob",
];

/// Who has waited long enough keeps what was found until then.
#[test]
fn ctrl_c_ends_a_search_with_the_best_so_far_and_pressed_again_the_program() {
    let shop = Shop::cube();
    let cube = example("cube.obj");
    let plan = [&["plan", &cube], &SEARCH[..]].concat();
    let mut asked = Asked::start(&shop, &plan);
    asked.sees("searching for a program without collisions (Ctrl-C").presses_ctrl_c();
    asked.sees("ending the search with the best so far; press Ctrl-C again to end at once");
    // Nothing was found until then that hits nothing.
    let said = asked.until("no job was written");
    assert!(said.contains("; ended by you") && said.contains("[no_clear_program]"), "{said}");
    assert!(said.contains("no change that could help was tried") && !said.contains("tried:"), "{said}");
    assert_eq!(asked.status(), Some(4));
    assert!(!shop.path().join("best.wbjob").exists());

    let anyway = [&plan[..], &["--despite-errors"]].concat();
    let mut asked = Asked::start(&shop, &anyway);
    asked.sees("searching for a program without collisions (Ctrl-C").presses_ctrl_c();
    asked.until("wrote best.wbjob");
    assert_eq!(asked.status(), Some(4));
    assert!(shop.path().join("best.wbjob").exists());

    // A job that nobody reads keeps the program from its end until it is pressed again.
    let (unread, output) = rustix::pipe::pipe().unwrap();
    rustix::pipe::fcntl_setpipe_size(&output, 4096).unwrap();
    let to_output = [&plan[..plan.len() - 1], &["-", "--despite-errors"]].concat();
    let mut asked = Asked::start_with(&shop, &to_output, None, output.into());
    asked.sees("searching for a program without collisions (Ctrl-C").presses_ctrl_c();
    asked.sees("ending the search").presses_ctrl_c();
    assert_eq!(asked.status(), Some(130));
    drop(unread);
}
