//! The process of a driver from outside: requests with deadlines, and an end in every case.

use std::collections::HashMap;
use std::ffi::OsString;
use std::io::{self, Read};
use std::path::Path;
use std::process::{Child, ChildStdout, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, SyncSender, channel, sync_channel};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

use crate::ending::{Ending, LastWords, in_words};
use crate::frame::{Frame, FrameError, Mark};

/// How long a process whose pipe is closed may take to end by itself, before it is helped.
const LAST_BREATH: Duration = Duration::from_millis(200);

/// A reply is waited for in parts of so long.
const LOOK: Duration = Duration::from_millis(20);
/// As much of a deadline one part uses up at most: a busy computer wakes up late, and one that stood still much later.
const MOST_FOR_ONE: Duration = Duration::from_millis(40);

/// Why there is no answer.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Failure {
    /// The process is gone.
    Ended(Ending),
    /// It took too long and was ended.
    Hung,
    /// It was not asked: something else came before.
    NotAllowed,
}

/// A running process. Dropping it ends it.
#[derive(Debug)]
pub(crate) struct Process(ProcessHandle);

/// The same process, for a caller that may have to stop it from another thread.
#[derive(Debug, Clone)]
pub(crate) struct ProcessHandle(Arc<Shared>);

struct Shared {
    child: Mutex<Child>,
    group: u32,
    /// What to notify at once when the process is lost.
    lost: Mutex<Option<Arc<dyn Fn() + Send + Sync>>>,
    waiting: Mutex<Waiting>,
    /// Notified when `Waiting::ending` is set.
    ended: Condvar,
    requests: Mutex<Option<Sender<Frame>>>,
    words: Mutex<Words>,
    /// Notified when the error stream is closed.
    silent: Condvar,
}

impl std::fmt::Debug for Shared {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Shared").field("group", &self.group).finish_non_exhaustive()
    }
}

#[derive(Debug, Default)]
struct Waiting {
    next_id: u32,
    replies: HashMap<u32, SyncSender<Frame>>,
    killed: bool,
    ending: Option<Ending>,
}

#[derive(Debug, Default)]
struct Words {
    last: LastWords,
    closed: bool,
}

/// What a thread that failed left behind is still true.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Process {
    /// Starts a program; gives it, and the frame that it sends unasked.
    pub fn start(program: &Path, arguments: &[OsString]) -> io::Result<(Self, Receiver<Frame>)> {
        let mut command = Command::new(program);
        command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        // A group of its own: Ctrl-C is a stop that the program itself has to bring about, and whatever
        // the driver starts ends with it.
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let mut child = command.spawn()?;
        let (Some(mut stdin), Some(stdout), Some(stderr)) =
            (child.stdin.take(), child.stdout.take(), child.stderr.take())
        else {
            return Err(io::ErrorKind::BrokenPipe.into());
        };
        let (requests, to_write) = channel::<Frame>();
        let (greeter, greeting) = sync_channel(1);
        let waiting = Waiting { next_id: 1, replies: HashMap::from([(0, greeter)]), ..Waiting::default() };
        let shared = Arc::new(Shared {
            group: child.id(),
            lost: Mutex::default(),
            child: Mutex::new(child),
            waiting: Mutex::new(waiting),
            ended: Condvar::new(),
            requests: Mutex::new(Some(requests)),
            words: Mutex::default(),
            silent: Condvar::new(),
        });
        // Writing waits when the driver does not read, so it is done apart; the pipe closes when nobody
        // can ask any more.
        thread::spawn(move || {
            for frame in to_write {
                if frame.write(&mut stdin).is_err() {
                    break;
                }
            }
        });
        let words = Arc::clone(&shared);
        thread::spawn(move || words.hear(stderr));
        let replies = Arc::clone(&shared);
        thread::spawn(move || replies.read_replies(stdout));
        Ok((Self(ProcessHandle(shared)), greeting))
    }

    /// What asks the process, and can end it, from any thread.
    pub const fn handle(&self) -> &ProcessHandle {
        &self.0
    }

    /// Waits for the frame that it sends unasked.
    pub fn greeting(&self, from: &Receiver<Frame>, deadline: Duration) -> Result<Frame, Failure> {
        self.0.0.wait(from, deadline)
    }

    /// The last that the process printed, for a message.
    pub fn said(&self) -> String {
        lock(&self.0.0.words).last.shown()
    }

    pub fn id(&self) -> u32 {
        self.0.0.group
    }
}

impl ProcessHandle {
    pub fn request(&self, mark: Mark, body: Vec<u8>, deadline: Duration) -> Result<Frame, Failure> {
        self.request_if(mark, body, deadline, || true)
    }

    /// The same, if `allowed` says so at the moment at which the request takes its place in the queue:
    /// nothing can come between the two.
    pub fn request_if(
        &self,
        mark: Mark,
        body: Vec<u8>,
        deadline: Duration,
        allowed: impl FnOnce() -> bool,
    ) -> Result<Frame, Failure> {
        self.0.request(mark, body, deadline, allowed)
    }

    /// Ends the process now.
    pub fn kill(&self) {
        self.0.kill();
    }

    /// What to notify when the process ends otherwise than by the program's leave: at once, before anything is found out
    /// about it, from whichever thread notices it first, and perhaps more than once.
    pub fn when_lost(&self, tell: impl Fn() + Send + Sync + 'static) {
        *lock(&self.0.lost) = Some(Arc::new(tell));
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        // At the end of its pipe the process has to end; what does not is ended.
        *lock(&self.0.0.requests) = None;
        if !self.0.0.wait_for_end(wirebend_driver_api::deadline::CLOSE) {
            self.0.kill();
            self.0.0.wait_for_end(Duration::from_secs(1));
        }
    }
}

impl Shared {
    fn request(
        &self,
        mark: Mark,
        body: Vec<u8>,
        deadline: Duration,
        allowed: impl FnOnce() -> bool,
    ) -> Result<Frame, Failure> {
        let (sender, reply) = sync_channel(1);
        let requests = lock(&self.requests);
        if !allowed() {
            return Err(Failure::NotAllowed);
        }
        let id = {
            let mut waiting = lock(&self.waiting);
            if let Some(ending) = &waiting.ending {
                return Err(Failure::Ended(ending.clone()));
            }
            let id = waiting.next_id;
            // The ids start again after 2^32 requests; 0 is the greeting's.
            waiting.next_id = id.checked_add(1).unwrap_or(1);
            waiting.replies.insert(id, sender);
            id
        };
        if let Some(requests) = requests.as_ref() {
            // A writer that is gone means a process that is gone: the reader knows why.
            let _ = requests.send(Frame { id, mark, body });
        }
        drop(requests);
        self.wait(&reply, deadline)
    }

    /// Waits for a reply. Time in which this program itself did not run is no time in which the driver could have answered: where the
    /// whole computer stood still, a driver is not ended for it.
    fn wait(&self, reply: &Receiver<Frame>, deadline: Duration) -> Result<Frame, Failure> {
        let mut left = deadline;
        while !left.is_zero() {
            let begun = Instant::now();
            match reply.recv_timeout(left.min(LOOK)) {
                Ok(frame) => return Ok(frame),
                Err(RecvTimeoutError::Timeout) => {
                    left = left.saturating_sub(begun.elapsed().min(MOST_FOR_ONE));
                }
                Err(RecvTimeoutError::Disconnected) => {
                    return Err(Failure::Ended(lock(&self.waiting).ending.clone().unwrap_or(Ending::Killed)));
                }
            }
        }
        self.kill();
        Err(Failure::Hung)
    }

    fn kill(&self) {
        {
            let mut waiting = lock(&self.waiting);
            if waiting.ending.is_some() {
                return;
            }
            waiting.killed = true;
        }
        self.end_now();
    }

    /// Nothing of it is left that could use the port; then the observers are notified.
    fn end_now(&self) {
        self.kill_group();
        let _ = lock(&self.child).kill();
        let tell = lock(&self.lost).clone();
        if let Some(tell) = tell {
            tell();
        }
    }

    /// Ends what the driver has started: it holds the driver's pipes and its port too.
    #[cfg(unix)]
    fn kill_group(&self) {
        if let Some(group) = i32::try_from(self.group).ok().and_then(rustix::process::Pid::from_raw) {
            let _ = rustix::process::kill_process_group(group, rustix::process::Signal::KILL);
        }
    }

    #[cfg(not(unix))]
    #[allow(clippy::unused_self)] // other systems have no such groups
    fn kill_group(&self) {}

    /// Whether the process is gone within a time.
    fn wait_for_end(&self, patience: Duration) -> bool {
        let waiting = lock(&self.waiting);
        let going = |waiting: &mut Waiting| waiting.ending.is_none();
        let (waiting, _) =
            self.ended.wait_timeout_while(waiting, patience, going).unwrap_or_else(PoisonError::into_inner);
        waiting.ending.is_some()
    }

    /// Passes replies on until the pipe ends or something comes that is no reply.
    fn read_replies(&self, mut stdout: ChildStdout) {
        let found = loop {
            let frame = match Frame::read(&mut stdout) {
                Ok(frame) => frame,
                Err(FrameError::Closed | FrameError::Io(_)) => break None,
                Err(FrameError::Garbage) => break Some(Ending::Garbage),
                Err(FrameError::TooLarge(bytes)) => break Some(Ending::TooLarge(bytes)),
            };
            let expected = matches!(frame.mark, Mark::Ok | Mark::Refused | Mark::Broken);
            match lock(&self.waiting).replies.remove(&frame.id).filter(|_| expected) {
                // The caller that waited may have given up.
                Some(waiting) => drop(waiting.try_send(frame)),
                None => break Some(Ending::Garbage),
            }
        };
        // One that was let go closes its pipe as it ends.
        if lock(&self.requests).is_some() && lock(&self.lost).is_some() {
            self.end_now();
        }
        let died = self.bury();
        let mut waiting = lock(&self.waiting);
        waiting.ending =
            Some(if waiting.killed { Ending::Killed } else { found.unwrap_or(Ending::Died(died)) });
        waiting.replies.clear();
        self.ended.notify_all();
    }

    /// Waits for the process, helping it if it must, and gives its status in words.
    fn bury(&self) -> String {
        let given_up = Instant::now() + LAST_BREATH;
        let status = loop {
            let mut child = lock(&self.child);
            match child.try_wait() {
                Ok(Some(status)) => break Ok(status),
                Ok(None) if Instant::now() < given_up => {}
                Ok(None) => {
                    let _ = child.kill();
                    break child.wait();
                }
                Err(error) => break Err(error),
            }
            drop(child);
            thread::sleep(Duration::from_millis(1));
        };
        self.kill_group();
        let words = lock(&self.words);
        let talking = |words: &mut Words| !words.closed;
        drop(self.silent.wait_timeout_while(words, LAST_BREATH / 2, talking));
        status.map_or_else(|error| format!("is gone ({error})"), in_words)
    }

    /// Keeps the last that the driver prints.
    fn hear(&self, mut stderr: impl Read) {
        let mut bytes = [0; 1024];
        while let Ok(count @ 1..) = stderr.read(&mut bytes) {
            tracing::debug!(process = self.group, "{}", String::from_utf8_lossy(&bytes[..count]).trim_end());
            lock(&self.words).last.add(&bytes[..count]);
        }
        lock(&self.words).closed = true;
        self.silent.notify_all();
    }
}
