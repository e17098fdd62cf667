//! Jobs run on the simulated machine, and what is kept of them.

use std::path::{Path, PathBuf};
use std::sync::{PoisonError, RwLock, RwLockReadGuard, RwLockWriteGuard};
use std::time::Duration;

use serde_json::{Value, json};

use crate::{Ran, assert_fits, example, run_in};

/// Longer than anything here takes on a busy computer.
pub const PATIENCE: Duration = Duration::from_mins(1);
/// Between two looks at what is waited for.
pub const LOOK: Duration = Duration::from_millis(1);

/// Simulated machines have deadlines as real ones have: they are not run beside a test that keeps every core busy.
/// Between the tests of one process, as `cargo test` runs them; for nextest `.config/nextest.toml` names those that run alone.
static CORES: RwLock<()> = RwLock::new(());

/// A folder with a job for the kit.
pub struct Shop {
    folder: tempfile::TempDir,
    _cores: Cores,
}

enum Cores {
    Shared { _guard: RwLockReadGuard<'static, ()> },
    Alone { _guard: RwLockWriteGuard<'static, ()> },
}

impl Shop {
    pub fn with(name: &str) -> Self {
        Self::planned(name, &[])
    }

    pub fn planned(name: &str, more: &[&str]) -> Self {
        Self::new("wirebend-kit", name, more, Self::shared())
    }

    /// For another machine.
    pub fn on(name: &str, machine: &str) -> Self {
        Self::new(machine, name, &[], Self::shared())
    }

    fn shared() -> Cores {
        Cores::Shared { _guard: CORES.read().unwrap_or_else(PoisonError::into_inner) }
    }

    /// While no other shop is open.
    pub fn alone(name: &str, more: &[&str]) -> Self {
        let guard = CORES.write().unwrap_or_else(PoisonError::into_inner);
        Self::new("wirebend-kit", name, more, Cores::Alone { _guard: guard })
    }

    fn new(machine: &str, name: &str, more: &[&str], cores: Cores) -> Self {
        let shop = Self { folder: tempfile::tempdir().unwrap(), _cores: cores };
        let plan = ["plan", &example(name), "-m", machine, "-o", "a.wbjob"];
        shop.run(&[&plan[..], more].concat()).ended(0);
        shop
    }

    pub fn cube() -> Self {
        Self::with("cube-8-edges.obj")
    }

    pub fn path(&self) -> &Path {
        self.folder.path()
    }

    pub fn run(&self, arguments: &[&str]) -> Ran {
        run_in(self.folder.path(), arguments, b"")
    }

    /// `run` of the job as fast as it goes.
    pub fn make(&self, more: &[&str]) -> Ran {
        self.run(&[&["run", "a.wbjob", "--port", "sim:max"], more].concat())
    }

    pub fn list(&self) -> Vec<Value> {
        let found = self.run(&["runs", "--json"]).ended(0).json();
        assert_fits("runs", &found);
        found["runs"].as_array().unwrap().clone()
    }

    /// The only journal that there is.
    pub fn journal(&self) -> PathBuf {
        let id = self.list()[0]["id"].as_str().unwrap().to_owned();
        self.path().join(format!("wirebend/runs/{id}.journal"))
    }
}

/// What a machine has done is told whatever becomes of the file for it; and where there is no folder for that, nothing is moved at all.
#[test]
fn a_record_that_cannot_be_written_hides_nothing() {
    let shop = Shop::cube();
    shop.make(&["--yes", "--record", "nowhere/made.json"]).ended(5);
    let refused =
        shop.run(&["jog", "-m", "wirebend-kit", "--port", "sim:max", "--yes", "--record", ".", "f", "10"]);
    assert!(refused.ended(5).err.contains("it is a folder"));
    assert_eq!(shop.list(), Vec::<Value>::new(), "nothing was begun");
    // No system has such names.
    let long = format!("{}.json", "a".repeat(300));
    let made = shop.make(&["--yes", "--json", "--record", &long]).ended(0).json();
    assert_eq!(made["wires"][0]["outcome"], "made");
    let jog =
        ["jog", "-m", "wirebend-kit", "--port", "sim:max", "--yes", "--json", "--record", &long, "f", "10"];
    let moved = shop.run(&jog).ended(0).json();
    assert_eq!(moved["made"].as_array().map(Vec::len), Some(1));
    for found in [made, moved] {
        let notes = found["notes"].as_array().unwrap();
        assert!(notes.iter().any(|note| note["code"] == "not-saved"), "{found}");
    }
}

#[test]
fn a_job_is_made_and_recorded() {
    let shop = Shop::cube();
    let ran = shop.make(&["--yes", "--json", "--record", "made.json"]).ended(0);
    let made = ran.json();
    assert_fits("run", &made);
    assert_eq!((made["machine"].as_str(), made["port"].as_str()), (Some("wirebend-kit"), Some("sim:max")));
    let wire = &made["wires"][0];
    assert_eq!((&wire["outcome"], &wire["made"], &wire["steps"]), (&json!("made"), &json!(8), &json!(8)));
    // 8 edges of 30 mm, each of 7 right angles saves 6 - 2.4·π/2, and 400 mm cannot be fed.
    let stock = 240.0 - 7.0 * (6.0 - 1.2 * std::f64::consts::PI) + 400.0;
    assert!((wire["stock_mm"].as_f64().unwrap() - stock).abs() < 1e-6);
    let off: Vec<f64> =
        wire["deviations_mm"].as_array().unwrap().iter().map(|mm| mm.as_f64().unwrap()).collect();
    assert!(off.len() == 9 && off.iter().all(|mm| *mm < 0.5), "{off:?}");

    // What is kept says the same, whichever way it is asked for.
    let id = wire["id"].as_str().unwrap();
    let listed = &shop.list()[0];
    assert_eq!(
        (&listed["id"], &listed["outcome"], &listed["made"]),
        (&json!(id), &json!("finished"), &json!(8))
    );
    let shown = shop.run(&["runs", "show", &id[..9], "--json"]).ended(0).json();
    assert_fits("runs-show", &shown);
    assert_eq!(shown["record"]["job"]["job_hash"], made["job_hash"]);
    let text = String::from_utf8(shop.run(&["runs", "show", id]).ended(0).out).unwrap();
    assert!(text.contains("finished, 8 of 8 steps") && text.contains("aluminium-6061-t6-3mm"), "{text}");
    let exported = shop.run(&["runs", "export", id, "-o", "again.json", "--json"]).ended(0).json();
    assert_fits("runs-export", &exported);
    let read = |name: &str| std::fs::read(shop.path().join(name)).unwrap();
    assert_eq!(read("again.json"), read("made.json"));
    let record: Value = serde_json::from_slice(&read("made.json")).unwrap();
    assert_eq!(record, shown["record"]);
    assert_eq!(record["outcome"], "finished");
    assert_eq!(shop.run(&["runs", "export", id]).ended(0).out, read("made.json"));
    shop.run(&["runs", "export", id, "-o", "again.json"]).ended(2);
    shop.run(&["runs", "show", "ffff"]).ended(2);

    // A finished wire stays finished; a second piece is a wire of its own.
    let again = shop.make(&["--resume", "--json"]).ended(0).json();
    assert_eq!(again["wires"][0]["outcome"], "made-before");
    shop.make(&["--yes"]).ended(0);
    let ids: Vec<Value> = shop.list().iter().map(|run| run["id"].clone()).collect();
    assert_eq!(ids, [json!(id), json!(format!("{}2", &id[..id.len() - 1]))]);
}

/// A flat wire that begins with 80 mm along x; then the length of each edge, mm, and its direction from there, degrees.
fn flat_wire(shop: &Shop, name: &str, edges: &[(f64, f64)]) {
    let mut corners = vec![[0.0, 0.0], [80.0, 0.0]];
    for (edge, turn) in edges {
        let [x, y] = corners[corners.len() - 1];
        let (sin, cos) = turn.to_radians().sin_cos();
        corners.push([x + edge * cos, y + edge * sin]);
    }
    let mut lines: Vec<String> = corners.iter().map(|[x, y]| format!("v {x} {y} 0")).collect();
    let row: Vec<String> = (1..=corners.len()).map(|k| k.to_string()).collect();
    lines.push(format!("l {}\n", row.join(" ")));
    std::fs::write(shop.path().join(name), lines.join("\n")).unwrap();
}

/// Bends of 30 degrees to one side and the other, so near to each other that the wire lies where the peg comes out for straight wire:
/// it comes out farther, for a job and for its text.
#[test]
fn the_peg_comes_out_beside_wire_that_is_bent_towards_it() {
    let shop = Shop::cube();
    flat_wire(&shop, "zigzag.obj", &[(27.0, 30.0), (27.0, 0.0), (27.0, 30.0), (60.0, 0.0)]);
    shop.run(&["plan", "zigzag.obj", "-m", "wirebend-kit", "-o", "a.wbjob", "--force"]).ended(0);
    shop.run(&["export", "a.wbjob", "-o", "a.txt"]).ended(0);
    for file in [&["a.wbjob"][..], &["a.txt", "-m", "wirebend-kit"]] {
        let arguments = [&["run"], file, &["--port", "sim:max", "--yes", "--json"]].concat();
        let ran = shop.run(&arguments).ended(0);
        assert!(!ran.err.contains("mishap"), "{}", ran.err);
        let made = ran.json();
        let off = made["wires"][0]["deviations_mm"].as_array().unwrap();
        let worst = off.iter().map(|mm| mm.as_f64().unwrap()).fold(0.0, f64::max);
        assert!(worst < 0.5, "{off:?}");
    }
}

/// A slight bend away from a corner within the peg's reach: the wire is in the peg's way before the axis is at zero. The job says to
/// which side it bends, and the machine makes it so; a machine that cannot be told is not asked to.
#[test]
fn a_bend_may_end_before_the_axis_is_at_zero() {
    let shop = Shop::cube();
    flat_wire(&shop, "slight.obj", &[(27.0, 40.0), (80.0, 37.0)]);
    shop.run(&["plan", "slight.obj", "-m", "wirebend-kit", "-o", "a.wbjob", "--force"]).ended(0);
    let job: Value = serde_json::from_slice(&std::fs::read(shop.path().join("a.wbjob")).unwrap()).unwrap();
    let told = &job["wires"][0]["compensated"][1];
    let (bend, approach) = (told["bend_deg"].as_f64().unwrap(), told["approach_deg"].as_f64().unwrap());
    let designed = job["wires"][0]["scheduled"][1]["bend_deg"].as_f64().unwrap();
    assert!(bend * designed < 0.0 && bend * approach > 0.0 && approach.abs() > bend.abs(), "{told}");
    assert!(job["wires"][0]["compensated"][0].get("approach_deg").is_none(), "its sign is its side");

    let ran = shop.run(&["run", "a.wbjob", "--port", "sim:max", "--yes", "--json"]).ended(0);
    assert!(!ran.err.contains("mishap"), "{}", ran.err);
    let made = ran.json();
    let off = made["wires"][0]["deviations_mm"].as_array().unwrap();
    let worst = off.iter().map(|mm| mm.as_f64().unwrap()).fold(0.0, f64::max);
    assert!(worst < 0.6, "{off:?}");

    // The text of the machine's authors has no place for a side.
    let said = shop.run(&["export", "a.wbjob", "-o", "a.txt"]).ended(4).err;
    assert!(said.contains("wire 1, step 2"), "{said}");
    // Without the figure it cannot be pressed, as ever.
    let machines = shop.path().join("profiles/machines");
    std::fs::create_dir_all(&machines).unwrap();
    let plain = json!({"schema_version": 1, "kind": "machine", "id": "plain", "inherits": "wirebend-kit",
        "bend": {"before_zero": false}});
    std::fs::write(machines.join("plain.json"), plain.to_string()).unwrap();
    let said =
        shop.run(&["--profiles", "profiles", "plan", "slight.obj", "-m", "plain", "--json"]).ended(4).json();
    let codes = said["diagnostics"].as_array().unwrap();
    assert!(codes.iter().any(|found| found["code"] == "corner_too_near"), "{said}");
}

/// The machine that is there before anybody has bought one. A machine that cannot be simulated has to be named.
#[test]
fn where_no_port_is_named_the_simulated_machine_makes_the_wire() {
    let shop = Shop::cube();
    // What will happen is said before anybody is asked.
    for arguments in [&["run", "a.wbjob"][..], &["jog", "-m", "wirebend-kit", "home"]] {
        let said = shop.run(arguments).ended(2).err;
        assert!(said.contains("WireBend-kit at sim (WireBend-kit, firmware"), "{said}");
        assert!(said.contains("the simulated machine, since no port was named"), "{said}");
    }
    for arguments in
        [&["machine-settings", "-m", "wirebend-kit"][..], &["jog", "-m", "grbl-bender", "--yes", "home"]]
    {
        let said = shop.run(arguments).ended(2).err;
        assert!(said.contains("say with --port where the machine is"), "{said}");
    }
}

#[test]
fn a_person_reads_what_will_happen_and_what_did() {
    let shop = Shop::cube();
    let ran = shop.make(&["--yes"]).ended(0);
    for said in ["firmware", "8 steps, 7 bends", "625 mm", "the machine homes", "between 0.0° and 90.0°"] {
        assert!(ran.err.contains(said), "{said}: {}", ran.err);
    }
    let out = String::from_utf8(ran.out).unwrap();
    assert!(out.contains("wire 1: finished in") && out.contains("mm off"), "{out}");
}

/// Nothing moves because the user forgot a word.
#[test]
fn what_is_not_confirmed_does_not_move() {
    let shop = Shop::cube();
    let said = shop.make(&[]).ended(2).err;
    assert!(said.contains("--yes"), "{said}");
    let refused = shop.make(&["--json"]).ended(2).json();
    assert_fits("error", &refused);
    assert_eq!(refused["error"]["code"], "not-confirmed");
    assert!(shop.list().is_empty(), "nothing was begun");
}

#[test]
fn a_port_that_is_named_has_to_be_there() {
    let shop = Shop::cube();
    let said = shop.run(&["run", "a.wbjob", "--yes", "--port", "/dev/nowhere"]).ended(5).err;
    assert!(said.contains("/dev/nowhere"), "{said}");
    let said = shop.run(&["run", "a.wbjob", "--yes", "--port", "sim:never"]).ended(5).err;
    assert!(said.contains("sim:10"), "{said}");
    // A machine whose driver writes files is not run.
    shop.run(&["plan", &example("house.obj"), "-m", "pensa-diwire-pro", "-o", "p.wbjob"]).ended(0);
    let said = shop.run(&["run", "p.wbjob", "--yes", "--port", "/dev/null"]).ended(2).err;
    assert!(said.contains("wirebend export"), "{said}");
    assert!(shop.list().is_empty());
}

#[test]
fn a_job_that_was_changed_is_not_made() {
    let shop = Shop::cube();
    let file = shop.path().join("a.wbjob");
    let text = std::fs::read_to_string(&file).unwrap();
    std::fs::write(&file, text.replacen("110.39", "110.49", 1)).unwrap();
    assert!(text.contains("110.39"), "a right angle with setback and springback compensated");
    let said = shop.make(&["--yes"]).ended(3).err;
    assert!(said.contains("hash"), "{said}");
    let said = shop.run(&["run", &example("cube.obj"), "--port", "sim:max", "--yes"]).ended(2).err;
    assert!(said.contains("wirebend plan"), "{said}");
}

/// The user who said yes could not know when the next wire would be in the machine.
#[test]
fn one_yes_is_for_one_wire() {
    let shop = Shop::with("two-parts.obj");
    let made = shop.make(&["--yes", "--json"]).ended(2).json();
    assert_fits("run", &made);
    assert_eq!((made["wires"].as_array().unwrap().len(), &made["left"]), (1, &json!([1])));
    assert_eq!(made["left_because"], "nobody-asked");
    let second = shop.make(&["--yes", "--json", "--wire", "2"]).ended(0).json();
    assert_eq!((&second["wires"][0]["wire"], &second["left"]), (&json!(1), &json!([])));
    let said = Shop::with("two-parts.obj").make(&["--yes"]).ended(2).err;
    assert!(said.contains("not begun: wire 2, "), "{said}");
    let said = shop.make(&["--yes", "--wire", "3"]).ended(2).err;
    assert!(said.contains("there is no wire 3: the job has 2"), "{said}");
    let said = shop.make(&["--yes", "--wire", "0"]).ended(2).err;
    assert!(said.contains("'--wire <N>'"), "{said}");
}

#[test]
fn records_are_kept_where_they_shall_be() {
    let shop = Shop::cube();
    shop.make(&["--yes", "--runs-folder", "here"]).ended(0);
    assert!(shop.list().is_empty());
    let list = shop.run(&["runs", "--runs-folder", "here", "--json"]).ended(0).json();
    assert_eq!(list["runs"].as_array().unwrap().len(), 1);
}

#[test]
fn ports_are_listed_for_a_machine_a_driver_or_all() {
    let shop = Shop::cube();
    for which in [&["-m", "wirebend-kit"][..], &["--driver", "wirebend-kit"], &[]] {
        let found = shop.run(&[&["ports", "--json"], which].concat()).ended(0).json();
        assert_fits("ports", &found);
        let ports = found["ports"].as_array().unwrap();
        let sim = ports.iter().find(|port| port["name"] == "sim:max").unwrap();
        assert_eq!(sim["drivers"], json!(["wirebend-kit"]));
    }
    let table = String::from_utf8(shop.run(&["ports"]).ended(0).out).unwrap();
    assert!(table.contains("sim:10"), "{table}");
    shop.run(&["ports", "-m", "pensa-diwire-pro"]).ended(2);
}

#[test]
fn settings_are_compared_and_written() {
    let shop = Shop::cube();
    let at = ["machine-settings", "-m", "wirebend-kit", "--port", "sim:max"];
    let found = shop.run(&[&at[..], &["--json"]].concat()).ended(0).json();
    assert_fits("machine-settings", &found);
    assert_eq!((&found["fits"], &found["written"]), (&json!(true), &json!(false)));
    assert!(found["identity"].as_str().unwrap().contains("firmware 1.13"), "{found}");
    let said = shop.run(&[&at[..], &["--write"]].concat()).ended(2).err;
    assert!(said.contains("--yes"), "{said}");
    let found = shop.run(&[&at[..], &["--write", "--yes", "--json"]].concat()).ended(0).json();
    assert_fits("machine-settings", &found);
    assert_eq!((&found["fits"], &found["written"]), (&json!(true), &json!(true)));
}

/// The job has its machine in it: what was changed in the profile since does not count, and the user is not left to believe it does.
#[test]
fn a_profile_that_was_changed_since_the_job_was_planned_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let machines = folder.path().join("profiles/machines");
    std::fs::create_dir_all(&machines).unwrap();
    let profile = |name: &str, offset_mm: f64| {
        let figure = json!({"value": offset_mm, "source": "a caliper", "measured": true});
        let mine = json!({"schema_version": 1, "kind": "machine", "id": "mine", "inherits": "wirebend-kit", "name": name,
            "bend": {"orbit_offset_mm": figure}});
        std::fs::write(machines.join("mine.json"), mine.to_string()).unwrap();
    };
    let run = |arguments: &[&str]| {
        let ran = run_in(folder.path(), &[&["--profiles", "profiles"], arguments].concat(), b"").ended(0);
        ran.err
    };
    profile("Mine", 12.0);
    run(&["plan", &example("u-sample.obj"), "-m", "mine", "-o", "a.wbjob"]);
    let make = ["run", "a.wbjob", "--port", "sim:max", "--yes"];
    profile("My own", 12.0);
    let said = run(&make);
    assert!(!said.contains("has changed"), "{said}");
    profile("My own", 11.4);
    let said = run(&make);
    assert!(
        said.contains("the profile 'mine' has changed since the job was planned (bend.orbit_offset_mm)"),
        "{said}"
    );
}

/// A wire that hits itself is bent if a person wants it all the same, whether it comes as a job or as the text of the machine.
#[test]
fn what_hits_itself_is_run_only_on_request() {
    let shop = Shop::planned("truss-1.obj", &["--double"]);
    shop.run(&["export", "a.wbjob", "-o", "a.txt"]).ended(0);
    for file in [&["a.wbjob"][..], &["a.txt", "-m", "wirebend-kit"]] {
        let arguments = [&["run"], file, &["--port", "sim:max", "--yes"]].concat();
        let said = shop.run(&arguments).ended(4).err;
        assert!(said.contains("meets_stock") && said.contains("--despite-errors"), "{said}");
        assert!(shop.list().is_empty(), "a wire was begun");
    }
    shop.run(&["run", "a.wbjob", "--port", "sim:max", "--yes", "--despite-errors"]).ended(0);
}
