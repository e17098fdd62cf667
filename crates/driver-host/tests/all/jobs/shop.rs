//! A workshop: a machine that is kept in a file, the driver that moves it, and a person who looks at the wire.

use std::path::{Path, PathBuf};
use std::time::Duration;

use serde_json::{Value, json};
use wirebend_driver_api::{Run, Step};
use wirebend_driver_host::jobs::{Clock, Heading, JobRun, Journal, Resume, StepOutcome, StepTime, WireJob};
use wirebend_driver_host::{DiscoveredDriver, Driver, Launch, Phase, Place, Session, TrustStore};

use crate::permits;

/// What each step turns the head, degrees.
pub const TURNS: [f64; 5] = [10.0, -25.0, 40.0, 0.0, 5.0];

/// How many steps the wire has.
pub const STEPS: u32 = 5;

pub struct Shop {
    pub folder: PathBuf,
    library: PathBuf,
    launch: Launch,
}

pub fn work() -> WireJob {
    let run = Run { job_hash: "5a".repeat(32), name: "bow".into(), steps: STEPS, ..Run::default() };
    let step = |rotate_deg: &f64| Step {
        feed_mm: 30.0,
        rotate_deg: *rotate_deg,
        bend_deg: 45.0,
        approach_deg: None,
    };
    let (steps, estimates) = (
        TURNS.iter().map(step).collect(),
        vec![StepTime { bend: Duration::from_secs(10), ..StepTime::default() }; 5],
    );
    WireJob { run, steps, estimates, head_play_deg: 0.0, head_range_deg: [-360.0, 360.0], pauses: Vec::new() }
}

pub fn heading() -> Heading {
    Heading { job_hash: "5a".repeat(32), steps: STEPS, name: "bow".into(), ..Heading::default() }
}

impl Shop {
    pub fn at(folder: &Path) -> Self {
        let launch = Launch { program: wirebend_tests_built::driver_child(), memory_bytes: 256 << 20 };
        let library = wirebend_tests_built::driver("hostile");
        Self { folder: folder.to_owned(), library, launch }
    }

    pub fn journal_path(&self) -> PathBuf {
        self.folder.join("wire-0.journal")
    }

    fn machine_path(&self) -> PathBuf {
        self.folder.join("machine.json")
    }

    /// What is in the machine's file.
    pub fn machine(&self) -> Value {
        let text = std::fs::read(self.machine_path());
        text.map_or(Value::Null, |text| serde_json::from_slice(&text).unwrap())
    }

    /// Does something to the machine while no program is connected to it.
    pub fn change_machine(&self, change: impl FnOnce(&mut Value)) {
        let mut machine = self.machine();
        change(&mut machine);
        std::fs::write(self.machine_path(), machine.to_string()).unwrap();
    }

    /// Every step that was ever done, in order.
    pub fn made(&self) -> Vec<u64> {
        let machine = self.machine();
        machine["made"].as_array().into_iter().flatten().map(|n| n.as_u64().unwrap()).collect()
    }

    /// A machine that has answered. `settings` are those of the driver besides the file.
    pub fn session(&self, mut settings: Value, token: Option<&str>) -> Session {
        settings["machine"] = json!(self.machine_path());
        let trust = TrustStore::open("none.json".as_ref()).unwrap();
        let found = DiscoveredDriver::at(&self.library, Place::App, &trust);
        let driver = Driver::start(&found, &self.launch).unwrap().open(&settings).unwrap();
        let mut session = match token {
            Some(token) => Session::connect_resuming(driver, "file", token, None).unwrap(),
            None => Session::connect(driver, "file", None).unwrap(),
        };
        while session.phase() == Phase::Connecting {
            session.poll().unwrap();
        }
        session
    }

    /// What a program does when it is started: the journal is begun or opened again, the machine connected.
    pub fn program(&self, settings: Value, clock: Box<dyn Clock>) -> JobRun {
        self.program_for(settings, clock, work())
    }

    pub fn program_for(&self, settings: Value, clock: Box<dyn Clock>, work: WireJob) -> JobRun {
        let path = self.journal_path();
        let journal = if path.exists() {
            Journal::open(&path).unwrap()
        } else {
            Journal::create(&path, heading(), clock.stamp()).unwrap()
        };
        let token = journal.state().token.clone();
        let session = self.session(settings, token.as_deref());
        JobRun::new(session, journal, work, clock).unwrap()
    }

    /// A person looks at the wire and says what they see, as long as they are asked; then the machine is homed
    /// where it has to be, and the wire begun.
    pub fn look_and_start(&self, run: &mut JobRun) {
        while let Resume::Ask { in_doubt, .. } = run.resume_from() {
            let made = self.made().contains(&u64::from(in_doubt));
            run.decide(in_doubt, if made { StepOutcome::Made } else { StepOutcome::NotMade }).unwrap();
        }
        match run.resume_from() {
            Resume::Arm { .. } => home(run.session()),
            Resume::Reattach { .. } => {}
            // What is left to do is to write down that it is finished.
            Resume::Nothing(_) => return drop(permits::start(run)),
            other => panic!("{other:?}"),
        }
        permits::start(run).unwrap();
    }
}

pub fn home(session: &mut Session) {
    permits::home(session).unwrap();
    while session.phase() != Phase::Ready {
        session.poll().unwrap();
    }
}
