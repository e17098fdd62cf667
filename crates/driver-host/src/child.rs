//! The driver's process: loads one library and answers frames.

use std::ffi::OsString;
use std::fs;
use std::io::{self, Read, Write};
use std::path::Path;
use std::process::ExitCode;
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::{Duration, Instant};

use serde_json::Value;
use wirebend_driver_api::{DriverError, Reply, SafeTable, TableError, deadline};

use crate::confine;
use crate::frame::{Frame, Mark};
use crate::library::load;
use crate::trust::Fingerprint;

/// The key of a greeting that says which minor version of the boundary the driver was built against.
pub(crate) const MINOR: &str = "built_against_minor";
/// How long one look for events may take when there are some.
const LOOK: Duration = Duration::from_millis(100);
/// The most events that one request brings.
const MAX_EVENTS: usize = 64;

/// Runs the process of a driver: the arguments are those after [`CHILD_COMMAND`](crate::CHILD_COMMAND).
/// Ends when the program that started it closes the pipe, or ends itself.
#[must_use]
pub fn child_main(arguments: &[OsString]) -> ExitCode {
    let Some(Task { library, expected, memory }) = Task::read(arguments) else {
        // Only a person who tries the hidden command by hand sees this.
        let _ = writeln!(
            std::io::stderr(),
            "this command is for the program itself: it runs a driver in a process of its own"
        );
        return ExitCode::from(2);
    };
    let Ok((requests, mut replies)) = confine::take_pipes() else { return ExitCode::FAILURE };
    let table = confine::limit(memory)
        .map_err(|error| DriverError::new("limit", format!("its memory cannot be limited: {error}"), ""))
        .and_then(|()| opened(Path::new(&library), expected.as_ref()));
    let ready = match table {
        Ok(table) => greet(table, &mut replies),
        Err(error) => {
            let _ = broken(0, &error).write(&mut replies);
            None
        }
    };
    if let Some(table) = ready {
        answer(table, listen(requests), &mut replies);
    }
    ExitCode::SUCCESS
}

struct Task {
    library: OsString,
    expected: Option<Fingerprint>,
    memory: u64,
}

impl Task {
    fn read(arguments: &[OsString]) -> Option<Self> {
        let [library, expected, memory] = arguments else { return None };
        let expected = match expected.to_str()? {
            "-" => None,
            hash => Some(hash.parse().ok()?),
        };
        Some(Self { library: library.clone(), expected, memory: memory.to_str()?.parse().ok()? })
    }
}

/// The table of the library. One that a person has accepted is loaded from a copy that nobody else can
/// write to, and that is what they accepted: between looking at a file and loading it, it can be changed.
fn opened(library: &Path, expected: Option<&Fingerprint>) -> Result<SafeTable, DriverError> {
    let loaded =
        |file: &Path| load(file).map_err(|error| DriverError::new(error.code(), error.to_string(), ""));
    let Some(expected) = expected else { return loaded(library) };
    let unread = |error: io::Error| DriverError::new("library", format!("it cannot be copied: {error}"), "");
    let private = tempfile::tempdir().map_err(unread)?;
    let copy = private.path().join(library.file_name().unwrap_or_default());
    fs::copy(library, &copy).map_err(unread)?;
    if Fingerprint::of(&copy).map_err(unread)? != *expected {
        return Err(DriverError::new("changed", "it was changed while it was being started", ""));
    }
    // The system keeps what is loaded; where it does not let go of the file, it stays until it is cleaned up.
    loaded(&copy)
}

/// Says what the driver is, unasked, as reply 0.
fn greet(mut table: SafeTable, replies: &mut impl Write) -> Option<SafeTable> {
    let mut described = reply(0, table.describe());
    if let Ok(Value::Object(mut keys)) = serde_json::from_slice(&described.body) {
        // A table tells it, and a table does not cross a pipe.
        keys.insert(MINOR.to_owned(), table.version().1.into());
        described.body = Value::Object(keys).to_string().into_bytes();
    }
    let usable = described.mark == Mark::Ok;
    described.write(replies).ok()?;
    usable.then_some(table)
}

/// Reads requests in a thread of its own, so that the end of the pipe is seen while the driver is busy.
fn listen(mut requests: impl Read + Send + 'static) -> Receiver<Frame> {
    let (sender, receiver) = channel();
    thread::spawn(move || {
        while let Ok(frame) = Frame::read(&mut requests) {
            if sender.send(frame).is_err() {
                break;
            }
        }
        // The program is gone. The driver gets the time that `close` has, and then no more.
        drop(sender);
        thread::sleep(deadline::CLOSE);
        confine::end();
    });
    receiver
}

fn answer(mut table: SafeTable, requests: Receiver<Frame>, replies: &mut impl Write) {
    let mut refused = None;
    for Frame { id, mark, body } in requests {
        let answered = match mark {
            Mark::Open => table.open(&body),
            Mark::Call => table.call(&body),
            Mark::Poll => events(&mut table, &mut refused),
            Mark::Describe => table.describe(),
            Mark::Close => table.close().map(|()| Reply::Ok(Vec::new())),
            Mark::Ok | Mark::Refused | Mark::Broken => return,
        };
        if reply(id, answered).write(replies).is_err() {
            return;
        }
    }
}

/// What there is to report, as a JSON array. What came before a refusal is reported first, and the refusal at
/// the next look.
fn events(table: &mut SafeTable, refused: &mut Option<Reply>) -> Result<Reply, TableError> {
    if let Some(refused) = refused.take() {
        return Ok(refused);
    }
    let mut all = vec![b'['];
    let begun = Instant::now();
    for count in 0..MAX_EVENTS {
        // What is left is reported at the next look: this one has a deadline, and each event may take its time.
        if count > 0 && begun.elapsed() > LOOK {
            break;
        }
        match table.poll()? {
            Reply::Ok(event) if event.is_empty() => break,
            Reply::Ok(event) => {
                if count > 0 {
                    all.push(b',');
                }
                all.extend(event);
            }
            now @ Reply::Refused(_) if count == 0 => return Ok(now),
            later @ Reply::Refused(_) => {
                *refused = Some(later);
                break;
            }
        }
    }
    all.push(b']');
    Ok(Reply::Ok(all))
}

fn reply(id: u32, answered: Result<Reply, TableError>) -> Frame {
    match answered {
        Ok(Reply::Ok(body)) => Frame { id, mark: Mark::Ok, body },
        Ok(Reply::Refused(body)) => Frame { id, mark: Mark::Refused, body },
        Err(error) => broken(id, &DriverError::new("table", error.to_string(), "")),
    }
}

fn broken(id: u32, error: &DriverError) -> Frame {
    Frame { id, mark: Mark::Broken, body: serde_json::to_vec(error).unwrap_or_default() }
}
