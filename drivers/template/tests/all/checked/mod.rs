//! The driver in C as a process under sanitizers: `drivers/template-c/tests/check.c`.

use std::fmt::Write as _;
use std::fs::File;
use std::io::{BufRead, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::sync::OnceLock;

use wirebend_driver_api::Reply;
use wirebend_driver_api::conformance::{Broken, Subject};

/// The folder of the driver in C.
pub const SOURCES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../template-c");

/// Builds a target of the driver's Makefile and gives the folder of what was built.
pub fn make(target: &str) -> PathBuf {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("template-c");
    // Tests may run in processes of their own: one builds at a time.
    std::fs::create_dir_all(&out).unwrap();
    let lock = File::create(out.join("lock")).unwrap();
    lock.lock().unwrap();
    let made = Command::new("make")
        .args(["--no-print-directory", "-C", SOURCES, target])
        .arg(format!("OUT={}", out.display()))
        // `make test` hands its own flags down, which mean nothing here.
        .env_remove("MAKEFLAGS")
        .output()
        .expect("this test needs make and a C compiler; on Debian: apt-get install -y build-essential");
    assert!(made.status.success(), "make {target}:\n{}", String::from_utf8_lossy(&made.stderr));
    out
}

/// A running check program. It ends with an error when the driver broke a rule of C or kept memory.
pub struct Checked {
    child: Child,
    to: Option<ChildStdin>,
    from: BufReader<ChildStdout>,
}

impl Checked {
    pub fn start() -> Self {
        static PROGRAM: OnceLock<PathBuf> = OnceLock::new();
        let program = PROGRAM.get_or_init(|| make("check-program").join("check"));
        let mut command = Command::new(program);
        // Leaks are looked for where the compiler's sanitizer can.
        if cfg!(target_os = "linux") {
            command.env("ASAN_OPTIONS", "detect_leaks=1");
        }
        let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
        let (to, from) = (child.stdin.take(), BufReader::new(child.stdout.take().unwrap()));
        Self { child, to, from }
    }

    /// Asks one thing; whether it was done, and the bytes of the answer.
    pub fn ask(&mut self, what: &str) -> (bool, Vec<u8>) {
        let to = self.to.as_mut().unwrap();
        writeln!(to, "{what}").and_then(|()| to.flush()).expect("the check program has ended");
        let mut line = String::new();
        self.from.read_line(&mut line).unwrap();
        let (status, hex) = line
            .trim_end_matches('\n')
            .split_once(' ')
            .unwrap_or_else(|| panic!("the check program ended at: {what}"));
        let byte = |at: usize| u8::from_str_radix(&hex[at..at + 2], 16).unwrap();
        (status == "0", (0..hex.len()).step_by(2).map(byte).collect())
    }

    pub fn ask_with(&mut self, what: &str, bytes: &[u8]) -> (bool, Vec<u8>) {
        let mut line = format!("{what} ");
        for byte in bytes {
            write!(line, "{byte:02x}").unwrap();
        }
        self.ask(&line)
    }
}

impl Drop for Checked {
    /// Memory that was kept is found when the program ends.
    fn drop(&mut self) {
        self.to = None;
        let ended = self.child.wait().unwrap();
        assert!(ended.success() || std::thread::panicking(), "the check program: {ended}");
    }
}

#[allow(clippy::unnecessary_wraps)] // what the trait wants
fn reply((done, bytes): (bool, Vec<u8>)) -> Result<Reply, Broken> {
    Ok(if done { Reply::Ok(bytes) } else { Reply::Refused(bytes) })
}

impl Subject for Checked {
    fn describe(&mut self) -> Result<Reply, Broken> {
        reply(self.ask("describe"))
    }

    fn open(&mut self, settings: &[u8]) -> Result<Reply, Broken> {
        reply(self.ask_with("open", settings))
    }

    fn call(&mut self, request: &[u8]) -> Result<Reply, Broken> {
        reply(self.ask_with("call", request))
    }

    fn poll(&mut self) -> Result<Reply, Broken> {
        reply(self.ask("poll"))
    }

    fn close(&mut self) -> Result<(), Broken> {
        self.ask("close");
        Ok(())
    }
}
