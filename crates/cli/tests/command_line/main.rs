//! The command line as a person or a script meets it: every command, every exit status, wrong files.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)] // a test may stop at what cannot be

mod calibrations;
mod checks;
mod closings;
mod collisions;
mod compare;
#[cfg(target_os = "linux")]
mod documents;
mod drivers;
mod frame_files;
mod frames;
mod generated;
mod machine;
mod outputs;
mod own_profiles;
mod poor_readings;
mod profiles;
mod programs;
mod results;
mod sequences;
mod sequences_confirmed;
mod several_wires;
mod simulations;
mod statuses;
mod wrong_files;

#[cfg(target_os = "linux")]
#[path = "../../../../drivers/grbl/tests/all/pty/model/mod.rs"]
#[allow(dead_code)] // the driver's own tests use the rest
mod grbl_model;

use std::error::Error;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use serde_json::Value;

/// What a run of the program left.
struct Ran {
    status: i32,
    out: Vec<u8>,
    err: String,
}

impl Ran {
    fn json(&self) -> Value {
        serde_json::from_slice(&self.out).unwrap_or_else(|error| panic!("{error}: {}", self.err))
    }

    /// The run, if it ended with this status.
    #[track_caller]
    fn ended(self, status: i32) -> Self {
        let out = String::from_utf8_lossy(&self.out);
        assert_eq!(self.status, status, "{}\n{out}", self.err);
        self
    }
}

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn example(name: &str) -> String {
    root().join("examples").join(name).display().to_string()
}

/// The program with the drivers that come with it beside it.
fn wirebend() -> PathBuf {
    let program = wirebend_tests_built::wirebend();
    for driver in ["pensa", "tables", "grbl", "howtomechatronics", "wirebend-kit"] {
        assert_eq!(wirebend_tests_built::driver(driver).parent(), program.parent());
    }
    program
}

/// Runs `wirebend` in a folder with words on its standard input.
fn run_in(folder: &Path, arguments: &[&str], input: &[u8]) -> Ran {
    run_program(&wirebend(), folder, arguments, input)
}

/// Runs a copy of the program that may lie elsewhere.
fn run_program(program: &Path, folder: &Path, arguments: &[&str], input: &[u8]) -> Ran {
    let mut command = Command::new(program);
    command
        .args(arguments)
        .current_dir(folder)
        // The profiles of the user who runs the tests are not part of them.
        .env("XDG_CONFIG_HOME", folder)
        .env("XDG_DATA_HOME", folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    // A copy was open to be written to when another test began a process, which has that until it has begun.
    let mut child = loop {
        match command.spawn() {
            Err(error) if error.kind() == ErrorKind::ExecutableFileBusy => std::thread::yield_now(),
            child => break child.unwrap(),
        }
    };
    // A program that does not read its input closes it early.
    let _ = child.stdin.take().unwrap().write_all(input);
    let done = child.wait_with_output().unwrap();
    Ran {
        status: done.status.code().expect("ended by a signal"),
        out: done.stdout,
        err: String::from_utf8(done.stderr).unwrap(),
    }
}

/// Runs `wirebend` where nothing is.
fn run(arguments: &[&str]) -> Ran {
    let folder = tempfile::tempdir().unwrap();
    run_in(folder.path(), arguments, b"")
}

/// A committed schema of a result.
fn schema_file(name: &str) -> Value {
    let file = root().join(format!("crates/api/schema/{name}.schema.json"));
    serde_json::from_slice(&std::fs::read(file).unwrap()).unwrap()
}

/// Where a schema refers to another file it is one beside it.
struct SchemaFolder;

impl jsonschema::Retrieve for SchemaFolder {
    fn retrieve(&self, uri: &jsonschema::Uri<String>) -> Result<Value, Box<dyn Error + Send + Sync>> {
        let name = uri.path().as_str().trim_start_matches('/').strip_suffix(".schema.json");
        Ok(schema_file(name.ok_or("no file of a schema")?))
    }
}

/// Checks a result against the committed schema of its command.
fn assert_fits(schema: &str, value: &Value) {
    let validator = jsonschema::options().with_retriever(SchemaFolder).build(&schema_file(schema)).unwrap();
    let errors: Vec<String> =
        validator.iter_errors(value).map(|e| format!("{}: {e}", e.instance_path())).collect();
    assert!(errors.is_empty(), "{errors:#?}");
}
