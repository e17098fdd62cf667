//! Wires that were interrupted: stopped, killed, resumed, given up.

#![cfg(unix)] // signals are sent as Unix sends them

use std::io::{BufRead, BufReader, Read};
use std::process::{Child, ChildStderr, Command, Stdio};

use rustix::process::{Pid, Signal, kill_process};
use serde_json::{Value, json};
use wirebend_journal::Log;

use super::lost::driver_of;
use super::runs::Shop;
use crate::{assert_fits, wirebend};

/// A run in a process that the test does not wait for.
pub struct Going {
    child: Child,
    told: BufReader<ChildStderr>,
}

impl Going {
    /// `-v` reports every step.
    pub fn start(shop: &Shop, arguments: &[&str]) -> Self {
        let mut child = Command::new(wirebend())
            .args(arguments)
            .args(["-v", "--json"])
            .current_dir(shop.path())
            .env("XDG_CONFIG_HOME", shop.path())
            .env("XDG_DATA_HOME", shop.path())
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        let told = BufReader::new(child.stderr.take().unwrap());
        Self { child, told }
    }

    /// Reads what it reports until it has said something.
    pub fn until(&mut self, said: &str) {
        let mut all = String::new();
        while !all.contains(said) {
            if self.told.read_line(&mut all).unwrap() == 0 {
                self.child.stdout.take().unwrap().read_to_string(&mut all).unwrap();
                panic!("it has ended: {all}");
            }
        }
    }

    pub fn send(&self, signal: Signal) {
        let id = Pid::from_raw(i32::try_from(self.child.id()).unwrap()).unwrap();
        kill_process(id, signal).unwrap();
    }

    /// Its status, or none when it was killed, and what it has answered.
    pub fn end(mut self) -> (Option<i32>, Value) {
        let (mut out, mut rest) = (Vec::new(), String::new());
        self.child.stdout.take().unwrap().read_to_end(&mut out).unwrap();
        self.told.read_to_string(&mut rest).unwrap();
        let status = self.child.wait().unwrap().code();
        (status, serde_json::from_slice(&out).unwrap_or(Value::Null))
    }
}

const RUN: [&str; 5] = ["run", "a.wbjob", "--port", "sim:10", "--yes"];

/// Every entry of the only journal.
fn entries(shop: &Shop) -> Vec<Value> {
    let text = std::fs::read_to_string(shop.journal()).unwrap();
    text.lines().map(|line| serde_json::from_str::<Value>(line).unwrap()["entry"].clone()).collect()
}

fn count(shop: &Shop, record: &str) -> usize {
    entries(shop).iter().filter(|entry| entry["record"] == record).count()
}

/// Ctrl-C, and the signal that asks a program to end, in the middle of a wire.
#[test]
fn ctrl_c_stops_the_machine_and_the_wire_can_be_gone_on_with() {
    for signal in [Signal::INT, Signal::TERM] {
        let shop = Shop::cube();
        let mut going = Going::start(&shop, &RUN);
        going.until("step 2 of 8 is done");
        // As often as it is pressed: the result is reported anyway.
        for _ in 0..20 {
            going.send(signal);
            std::thread::sleep(std::time::Duration::from_millis(10));
        }
        let (status, told) = going.end();
        assert_eq!(status, Some(130), "{told}");
        assert_fits("run", &told);
        let wire = &told["wires"][0];
        assert_eq!((&wire["outcome"], &wire["stopped_by"]), (&json!("stopped"), &json!("driver")));
        let made = wire["made"].as_u64().unwrap();
        // Those that were sent after the step under way are in no doubt.
        let (step, sure) = (&wire["stopped_in"]["step"], wire["stopped_in"]["sure"] == true);
        assert_eq!(*step, json!(made + 1), "{wire}");
        let in_doubt = if sure { Value::Null } else { json!([made + 1, made + 1]) };
        assert_eq!(wire["in_doubt"], in_doubt, "{wire}");
        assert!(wire["resume"].as_str().unwrap().ends_with("--port sim:10 --resume"), "{wire}");
        assert_eq!(count(&shop, "stopped"), 1);

        // Neither begun anew nor resumed by itself.
        let said = shop.make(&["--yes"]).ended(2).err;
        assert!(said.contains("--resume") && said.contains("--abandon"), "{said}");
        // An answer counts for its own step alone.
        let other = format!("--resume=made:{}", made + 2);
        let said = shop.make(&["--yes", &other]).ended(2).err;
        assert!(said.contains(&format!("step {} is the one in doubt", made + 1)), "{said}");
        assert_eq!((count(&shop, "armed"), count(&shop, "decided")), (1, 0), "nothing has moved since");

        let nothing = format!("--resume=not-made:{}", made + 1);
        let done = shop.make(&["--yes", &nothing, "--json"]).ended(0).json();
        assert_eq!((&done["wires"][0]["outcome"], &done["wires"][0]["made"]), (&json!("made"), &json!(8)));
        assert_eq!(count(&shop, "done"), 8, "each step was done once");
        assert_eq!(count(&shop, "finished"), 1);
    }
}

/// The command that is shown finds the same journal, profiles and drivers.
#[test]
fn the_command_to_go_on_with_looks_where_this_one_has() {
    let shop = Shop::cube();
    let elsewhere = ["--runs-folder", "own runs", "--profiles", "mine"];
    let mut going = Going::start(&shop, &[&RUN[..], &elsewhere].concat());
    going.until("step 2 of 8 is done");
    going.send(Signal::INT);
    let (_, told) = going.end();
    let resume = told["wires"][0]["resume"].as_str().unwrap();
    assert!(resume.ends_with("--profiles mine --runs-folder 'own runs' --resume"), "{resume}");
}

/// The command that is shown is about the same wire.
#[test]
fn the_command_to_go_on_with_names_the_interrupted_wire() {
    let shop = Shop::with("two-parts.obj");
    let mut going = Going::start(&shop, &[RUN.as_slice(), &["--wire", "2"]].concat());
    going.until("step 1 of");
    going.send(Signal::INT);
    let (status, told) = going.end();
    assert_eq!((status, &told["wires"][0]["wire"]), (Some(130), &json!(1)));
    let resume = told["wires"][0]["resume"].as_str().unwrap();
    let said = shop.make(&["--yes", "--wire", "2"]).ended(2).err;
    assert!(said.contains("wire 2 of this job was begun") && said.contains("--wire 2 --resume"), "{said}");

    let nothing =
        format!("--resume=not-made:{} --yes --json", told["wires"][0]["made"].as_u64().unwrap() + 1);
    let words = resume.strip_prefix("wirebend ").unwrap().replace("--resume", &nothing);
    let done = shop.run(&words.split(' ').collect::<Vec<_>>()).ended(0).json();
    assert_eq!((&done["wires"][0]["wire"], &done["wires"][0]["outcome"]), (&json!(1), &json!("made")));
}

/// While it homes, in real time. Nothing was sent, so nothing is in doubt.
#[test]
fn ctrl_c_stops_a_machine_that_homes() {
    let shop = Shop::cube();
    let mut going = Going::start(&shop, &["run", "a.wbjob", "--port", "sim", "--yes", "-v"]);
    going.until("homing");
    going.send(Signal::INT);
    let (status, told) = going.end();
    assert_eq!((status, &told["wires"][0]["outcome"]), (Some(130), &json!("stopped")));
    assert_eq!((&told["wires"][0]["in_doubt"], &told["wires"][0]["resume"]), (&Value::Null, &Value::Null));
    // It can be begun anew without a further word.
    shop.make(&["--yes"]).ended(0);
}

#[test]
fn a_program_that_was_killed_is_gone_on_with_by_a_person() {
    let shop = Shop::cube();
    let mut going = Going::start(&shop, &RUN);
    going.until("step 3 of 8 is done");
    going.send(Signal::KILL);
    assert_eq!(going.end().0, None);
    let (known, sent) = (count(&shop, "done"), entries(&shop));
    let sent = sent.iter().filter_map(|entry| entry["to"].as_u64()).max().unwrap();
    assert!(known >= 3 && sent > known as u64, "{known} of {sent}");

    // The simulated machine is gone with the program. Said step by step, since more than one may be done; said three times
    // of one step, it is one that was done.
    let made = format!("--resume=made:{}", known + 1);
    for _ in 0..3 {
        let said = shop.make(&["--yes", &made]).ended(2).err;
        assert!(said.contains(&format!("step {} of 8", known + 2)), "{said}");
        assert_eq!(count(&shop, "decided"), 1);
    }
    // As long as nothing is bent after it, it can be taken back. What the machine has said cannot.
    let measured = format!("--resume=part:{}:1:0", known + 1);
    shop.make(&["--axes-at-zero", &measured]).ended(2);
    shop.make(&["--yes", &made]).ended(2);
    let reported = shop.make(&["--yes", &format!("--resume=not-made:{known}")]).ended(2).err;
    assert!(reported.contains(&format!("step {known} is not in doubt")), "{reported}");
    let nothing = format!("--resume=not-made:{}", known + 2);
    let done = shop.make(&["--yes", &nothing, "--json"]).ended(0).json();
    assert_eq!(done["wires"][0]["outcome"], "made");
    let armed: Vec<Value> = entries(&shop)
        .into_iter()
        .filter(|entry| entry["record"] == "armed")
        .map(|entry| entry["after"].clone())
        .collect();
    assert_eq!(armed, [json!(0), json!(known + 1)]);
    assert_eq!(count(&shop, "done") + 1, 8, "one was done by a person's word");
    let id = shop.list()[0]["id"].as_str().unwrap().to_owned();
    let record = shop.run(&["runs", "show", &id, "--json"]).ended(0).json()["record"].clone();
    let said: Vec<_> = record["decisions"].as_array().unwrap().iter().map(|one| &one["made"]).collect();
    assert_eq!(said, [true, false], "what holds of what was said: {record:#}");
    assert!(!record["interruptions"].as_array().unwrap().is_empty());
}

/// A rule measures wire. Where a millimetre that is commanded gives 1.25 mm of it, 5 mm are 4 mm as the machine counts.
#[test]
fn what_a_person_measures_is_wire_whatever_the_feed_gives() {
    let shop = Shop::cube();
    let set = ["profile", "set", "mine", "--from", "wirebend-kit", "--kind", "machine", "feed.scale=1.25"];
    shop.run(&[&set[..], &["--source", "a rule"]].concat()).ended(0);
    let plan = ["plan", &crate::example("cube-8-edges.obj"), "-m", "mine", "-o", "a.wbjob", "--force"];
    shop.run(&plan).ended(0);
    let mut going = Going::start(&shop, &RUN);
    going.until("step 2 of 8 is done");
    going.send(Signal::KILL);
    going.end();
    let step = count(&shop, "done") + 1;
    let asked = shop.make(&["--yes", "--resume"]).ended(2).err;
    assert!(asked.contains(&format!("step {step} of 8")), "{asked}");
    shop.make(&["--yes", &format!("--resume=part:{step}:5:0")]).ended(0);
    let parts: Vec<Value> = entries(&shop).into_iter().filter(|entry| entry["by"] == "person").collect();
    assert_eq!(parts.len(), 1, "{parts:?}");
    assert_eq!((&parts[0]["n"], &parts[0]["feed_mm"]), (&json!(step), &json!(4.0)));
}

#[test]
fn a_wire_is_given_up_and_begun_anew() {
    let shop = Shop::cube();
    shop.make(&["--resume"]).ended(2);
    shop.run(&["run", "a.wbjob", "--abandon"]).ended(2);
    let mut going = Going::start(&shop, &RUN);
    going.until("step 1 of 8 is done");
    going.send(Signal::KILL);
    going.end();
    let given = shop.run(&["run", "a.wbjob", "--abandon", "--json"]).ended(0).json();
    assert_fits("run", &given);
    assert_eq!(given["wires"][0]["outcome"], "abandoned");
    shop.make(&["--yes"]).ended(0);
    let outcomes: Vec<Value> = shop.list().iter().map(|run| run["outcome"].clone()).collect();
    assert_eq!(outcomes, [json!("abandoned"), json!("finished")]);
    // It was begun, and is finished.
    let refused = shop.run(&["run", "a.wbjob", "--abandon"]).ended(2).err;
    assert!(refused.contains("no wire of this job is unfinished"), "{refused}");
}

#[test]
fn a_damaged_journal_is_named_with_its_line_and_set_aside_at_a_word() {
    let shop = Shop::cube();
    let mut going = Going::start(&shop, &RUN);
    going.until("step 2 of 8 is done");
    going.send(Signal::KILL);
    going.end();
    let journal = shop.journal();
    let mut bytes = std::fs::read(&journal).unwrap();
    let second = bytes.iter().position(|byte| *byte == b'\n').unwrap() + 20;
    bytes[second] ^= 1;
    std::fs::write(&journal, bytes).unwrap();
    for more in [&["--yes"][..], &["--yes", "--resume"], &["--yes", "--resume=made:4"]] {
        let said = shop.make(more).ended(3).err;
        assert!(said.contains("line 2") && said.contains("--abandon"), "{said}");
    }
    let listed = &shop.list()[0];
    assert!(listed["problem"].as_str().unwrap().contains("line 2"), "{listed}");
    let said = shop.run(&["run", "a.wbjob", "--abandon"]).ended(0);
    let said = format!("{}{}", said.err, String::from_utf8_lossy(&said.out));
    assert!(said.contains("how much of it was bent is not known") && !said.contains("0 of 8"), "{said}");
    assert!(journal.with_extension("damaged").exists());
    shop.make(&["--yes"]).ended(0);
    assert_eq!(shop.list().len(), 1, "one that was set aside is no record");
}

/// Two programs do not bend the same wire.
#[test]
fn a_wire_that_is_being_made_is_left_alone() {
    let shop = Shop::cube();
    let mut going = Going::start(&shop, &RUN);
    going.until("step 1 of 8 is done");
    for more in [&["--yes", "--resume=made:2"][..], &["--abandon"]] {
        let said = shop.make(more).ended(5).err;
        assert!(said.contains("in use"), "{said}");
    }
    let said = shop.make(&["--yes"]).ended(5).err;
    assert!(said.contains("bends the wire 'a'") && !said.contains("--resume"), "{said}");
    going.send(Signal::INT);
    assert_eq!(going.end().0, Some(130));
}

/// A simulated machine is part of its driver: where that has to be ended, there is nothing left that could move.
#[test]
fn a_simulated_machine_stands_once_its_driver_is_ended() {
    for signal in [Signal::STOP, Signal::KILL] {
        let shop = Shop::cube();
        let mut going = Going::start(&shop, &RUN);
        going.until("step 1 of 8 is done");
        kill_process(driver_of(&going.child), signal).unwrap();
        let hangs = signal == Signal::STOP;
        if hangs {
            going.send(Signal::INT);
        }
        let (status, told) = going.end();
        assert_eq!(status, Some(if hangs { 130 } else { 5 }), "{told}");
        assert_eq!(told["wires"][0]["standstill"], "confirmed", "{told}");
        let standstill = entries(&shop).into_iter().find(|entry| entry["record"] == "standstill").unwrap();
        assert_eq!(standstill["confirmed"], true, "{standstill}");
        // The wire in it is no other than one of a machine that was stopped.
        let said = shop.make(&["--yes"]).ended(2).err;
        assert!(said.contains("--resume") && said.contains("--abandon"), "{said}");
    }
}

/// Half of a wire that lies in a real machine is not finished by a simulated one.
#[test]
fn a_wire_goes_on_where_it_was_begun_or_where_a_person_says() {
    let shop = Shop::cube();
    let mut going = Going::start(&shop, &RUN);
    going.until("step 2 of 8 is done");
    going.send(Signal::KILL);
    going.end();
    // It was begun on a simulated machine, and so it may resume there.
    let asked = shop.run(&["run", "a.wbjob", "--yes", "--resume"]).ended(2).err;
    assert!(asked.contains("--resume=made:"), "{asked}");
    // Were it begun at a real one, the user would have to name that.
    let journal = shop.journal();
    let text = std::fs::read_to_string(&journal).unwrap();
    std::fs::remove_file(&journal).unwrap();
    let mut lines = text.lines().map(|line| serde_json::from_str::<Value>(line).unwrap()["entry"].clone());
    let mut heading = lines.next().unwrap();
    heading["port"] = json!("/dev/ttyACM0");
    let mut log = Log::create(&journal, &heading.to_string()).unwrap();
    lines.for_each(|entry| log.add(&entry.to_string()).unwrap());
    drop(log);
    let before = std::fs::read(&journal).unwrap();
    let refused = shop.run(&["run", "a.wbjob", "--yes", "--resume=made:3"]).ended(2).err;
    assert!(refused.contains("say with --port where the machine is"), "{refused}");
    assert_eq!(std::fs::read(&journal).unwrap(), before, "nothing was decided");
}
