//! STOP: by the driver if it answers in time, by ending it if not.

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use serde_json::Value;
use wirebend_driver_api::{Call, deadline};

use crate::driver::to_body;
use crate::frame::Mark;
use crate::process::ProcessHandle;

/// Stops a machine from any thread.
#[derive(Debug, Clone)]
pub struct StopHandle {
    process: ProcessHandle,
    arming: Arming,
    can_stop: bool,
}

/// Which arming is in force. A stop moves it on, and so every token of before becomes stale.
#[derive(Debug, Clone)]
pub(super) struct Arming(Arc<AtomicU64>);

/// Numbers of one session are no other's: a token of another machine is stale here.
static SESSIONS: AtomicU64 = AtomicU64::new(1);

impl Arming {
    /// For a new session.
    pub fn first() -> Self {
        let session = SESSIONS.fetch_add(1, Ordering::Relaxed);
        Self(Arc::new(AtomicU64::new(session << 32)))
    }

    pub fn now(&self) -> u64 {
        self.0.load(Ordering::SeqCst)
    }

    /// The next one; `None` when `known` is no longer in force.
    pub fn follow(&self, known: u64) -> Option<u64> {
        self.0
            .compare_exchange(known, known + 1, Ordering::SeqCst, Ordering::SeqCst)
            .is_ok()
            .then_some(known + 1)
    }

    fn end(&self) {
        self.0.fetch_add(1, Ordering::SeqCst);
    }
}

/// Who brought the stop about.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StoppedBy {
    /// The driver: it has passed the stop on to the machine.
    Driver,
    /// Nobody: the machine cannot be stopped. The driver sends nothing more; what the machine has been sent it
    /// makes. Cut its power.
    NothingMore,
    /// This program: the driver did not answer in time or refused, so its process was ended and its port
    /// closed with it. What the machine holds in its own memory may still be made: cut its power.
    EndOfDriver,
}

/// How a stop went.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StopOutcome {
    /// Who brought it about.
    pub by: StoppedBy,
    /// From the call to its end.
    pub took: Duration,
}

impl StopHandle {
    pub(super) const fn new(process: ProcessHandle, arming: Arming, can_stop: bool) -> Self {
        Self { process, arming, can_stop }
    }

    /// Stops the machine. Does not depend on the driver: one that has not answered within
    /// [`deadline::STOP`] is ended, whatever else it is doing.
    #[must_use = "a driver that had to be ended cannot have told the machine"]
    pub fn stop(&self) -> StopOutcome {
        let started = Instant::now();
        // In one moment with the place in the queue: no motion that was allowed before comes after it.
        let latch = || {
            self.arming.end();
            true
        };
        let answer = self.process.request_if(Mark::Call, to_body(&Call::Stop), deadline::STOP, latch);
        // What answers nonsense cannot be relied on to have done it.
        let sound = |body: &[u8]| serde_json::from_slice::<serde_json::Map<String, Value>>(body).is_ok();
        let passed_on = answer.is_ok_and(|frame| frame.mark == Mark::Ok && sound(&frame.body));
        if !passed_on {
            self.process.kill();
        }
        let by = match (passed_on, self.can_stop) {
            (true, true) => StoppedBy::Driver,
            (true, false) => StoppedBy::NothingMore,
            (false, _) => StoppedBy::EndOfDriver,
        };
        StopOutcome { by, took: started.elapsed() }
    }
}
