//! `wirebend` with its driver as they are shipped, in a folder of its own.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::sync::{OnceLock, PoisonError, RwLock, RwLockReadGuard, RwLockWriteGuard};
use std::time::{Duration, Instant};

use rustix::process::{Pid, Signal, kill_process};
use serde_json::Value;

/// Longer than anything here takes on a busy computer.
pub const DEADLINE: Duration = Duration::from_mins(2);

/// How soon it is noticed that a program has ended that should not have.
const LOOK: Duration = Duration::from_millis(200);

/// The computer, which a test that measures time wants for itself. Between the tests of one process, as `cargo test` runs them; nextest
/// starts a process for each, and `.config/nextest.toml` names those that run alone.
static COMPUTER: RwLock<()> = RwLock::new(());

/// Until it is dropped, other tests may run.
pub fn shared() -> RwLockReadGuard<'static, ()> {
    COMPUTER.read().unwrap_or_else(PoisonError::into_inner)
}

/// Until it is dropped, no other test of this process runs.
pub fn alone() -> RwLockWriteGuard<'static, ()> {
    COMPUTER.write().unwrap_or_else(PoisonError::into_inner)
}

/// A folder with profiles, jobs and journals.
pub struct Shop {
    folder: tempfile::TempDir,
}

/// What a run of the program left.
#[derive(Debug)]
pub struct Ran {
    pub status: ExitStatus,
    pub out: String,
    pub err: String,
}

impl Ran {
    /// The run, if it ended with this status.
    #[track_caller]
    pub fn ended(self, status: i32) -> Self {
        assert_eq!(self.status.code(), Some(status), "{}\n{}", self.err, self.out);
        self
    }

    #[track_caller]
    pub fn json(&self) -> Value {
        serde_json::from_str(&self.out).unwrap_or_else(|error| panic!("{error}: {}\n{}", self.out, self.err))
    }

    /// The message, if it has these words.
    #[track_caller]
    pub fn says(self, words: &str) -> Self {
        assert!(self.err.contains(words), "{words:?} is not in: {}", self.err);
        self
    }
}

/// A program that runs.
pub struct Running {
    pid: Pid,
    ended: Receiver<Ran>,
}

impl Running {
    pub fn kill(&self, signal: Signal) {
        kill_process(self.pid, signal).unwrap();
    }

    /// The process of its driver.
    pub fn driver(&self) -> Pid {
        let pid = self.pid.as_raw_nonzero();
        let children = std::fs::read_to_string(format!("/proc/{pid}/task/{pid}/children")).unwrap();
        // It is started by another thread where the program has several.
        let threads = std::fs::read_dir(format!("/proc/{pid}/task")).unwrap();
        let of_threads =
            threads.filter_map(|thread| std::fs::read_to_string(thread.ok()?.path().join("children")).ok());
        let all: String = [children].into_iter().chain(of_threads).collect();
        let first = all.split_whitespace().next().expect("a driver");
        Pid::from_raw(first.parse().unwrap()).unwrap()
    }

    /// Waits for a moment of the job that it runs.
    #[track_caller]
    pub fn reached(&self, moment: &Receiver<()>) {
        self.heard(moment);
    }

    /// Waits for something that is reported of the job that it runs.
    #[track_caller]
    pub fn heard<T>(&self, tells: &Receiver<T>) -> T {
        let begun = Instant::now();
        loop {
            if let Ok(told) = tells.recv_timeout(LOOK) {
                return told;
            }
            let ended = self.ended.try_recv();
            assert!(ended.is_err() && begun.elapsed() < DEADLINE, "the job does not get there: {ended:?}");
        }
    }

    #[track_caller]
    pub fn wait(self) -> Ran {
        self.ended.recv_timeout(DEADLINE).expect("the program to end")
    }
}

/// The program, its driver beside it.
fn program() -> &'static Path {
    static PROGRAM: OnceLock<PathBuf> = OnceLock::new();
    PROGRAM.get_or_init(|| {
        let program = wirebend_tests_built::wirebend();
        let driver = wirebend_tests_built::driver("wirebend-kit");
        assert_eq!(driver.parent(), program.parent());
        program
    })
}

impl Shop {
    /// With profiles of machines of its own.
    pub fn new(machines: &[Value]) -> Self {
        let shop = Self { folder: tempfile::tempdir().unwrap() };
        let folder = shop.path("profiles/machines");
        std::fs::create_dir_all(&folder).unwrap();
        for machine in machines {
            let file = folder.join(format!("{}.json", machine["id"].as_str().unwrap()));
            std::fs::write(file, machine.to_string()).unwrap();
        }
        shop
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// Starts `wirebend` with journals in the folder `runs`.
    pub fn start(&self, runs: &str, arguments: &[&str]) -> Running {
        self.start_program(program(), runs, arguments)
    }

    /// The same with another program.
    pub fn start_program(&self, program: &Path, runs: &str, arguments: &[&str]) -> Running {
        let folder = self.folder.path();
        let mut child = Command::new(program);
        child.args(["--profiles", "profiles", "--runs-folder", runs]).args(arguments).current_dir(folder);
        // The setup of the user who runs the tests is not part of them.
        child.env("XDG_CONFIG_HOME", folder).env("XDG_DATA_HOME", folder);
        let child = child.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        let pid = Pid::from_raw(i32::try_from(child.id()).unwrap()).unwrap();
        let (end, ended) = channel();
        std::thread::spawn(move || {
            let done = child.wait_with_output().unwrap();
            let text = |bytes| String::from_utf8(bytes).unwrap();
            // A caller that does not wait for it has failed before.
            let _ = end.send(Ran { status: done.status, out: text(done.stdout), err: text(done.stderr) });
        });
        Running { pid, ended }
    }

    #[track_caller]
    pub fn ran(&self, runs: &str, arguments: &[&str]) -> Ran {
        self.start(runs, arguments).wait()
    }
}

/// An example of the repository.
pub fn example(name: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    root.join("examples").join(name).display().to_string()
}
