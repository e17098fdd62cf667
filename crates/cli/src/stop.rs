//! Ctrl-C is STOP: in a thread of its own, whatever the program is doing. Of a search it takes the best so far.

use std::io::Write;
use std::process;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use anyhow::Context;
use wirebend_api::{Standstill, StopHandle, StoppedBy};

use crate::exit;

/// What stops the machine that is connected, if one is; a process has one terminal and one Ctrl-C.
static HANDLE: Mutex<Option<StopHandle>> = Mutex::new(None);
static PRESSED: AtomicBool = AtomicBool::new(false);
/// When the machine was last ordered to stop.
static TOLD: Mutex<Option<Instant>> = Mutex::new(None);
/// Until then the program writes down and reports the result of a stop, and ends; a press meanwhile ends it no sooner.
const ENDING: Duration = Duration::from_secs(3);
/// Whether a search is under way.
static SEARCHES: AtomicBool = AtomicBool::new(false);

/// From here on Ctrl-C, and the signal that asks a program to end, stop the machine: each time they come, for as long as one
/// is connected. The program ends by itself once the machine stands, or has not confirmed it for too long.
pub(crate) fn listen() -> anyhow::Result<()> {
    ctrlc::set_handler(pressed).context("Ctrl-C cannot be listened to, and without it nothing is moved")
}

/// From here on Ctrl-C, and the signal that asks a program to end, end the search that is under way with the best that it has: the
/// program goes on with that. Pressed again, or without a search, they end the program.
pub(crate) fn listen_while_searching() -> anyhow::Result<()> {
    let pressed = || {
        let again = PRESSED.swap(true, Ordering::SeqCst);
        if again || !SEARCHES.load(Ordering::SeqCst) {
            process::exit(exit::STOPPED.into());
        }
        let said = "ending the search with the best so far; press Ctrl-C again to end at once";
        let _ = writeln!(std::io::stderr(), "\n{said}");
    };
    ctrlc::set_handler(pressed)
        .context("Ctrl-C cannot be listened to, and without it a search cannot be ended")
}

/// A search begins, or is over.
pub(crate) fn search(begins: bool) {
    SEARCHES.store(begins, Ordering::SeqCst);
}

/// Whether a person has ended the searches of this command.
pub(crate) fn ends_search() -> bool {
    SEARCHES.load(Ordering::SeqCst) && was_pressed()
}

/// Whether a person has asked for a stop.
pub(crate) fn was_pressed() -> bool {
    PRESSED.load(Ordering::SeqCst)
}

/// A machine can be stopped, or none can any more.
pub(crate) fn connect(handle: Option<&StopHandle>) {
    let mut kept = HANDLE.lock().unwrap_or_else(PoisonError::into_inner);
    *kept = handle.cloned();
    // It was pressed before there was anything to stop.
    if was_pressed() {
        stop(kept.as_ref());
    }
}

fn pressed() {
    PRESSED.store(true, Ordering::SeqCst);
    let handle = HANDLE.lock().unwrap_or_else(PoisonError::into_inner).clone();
    let moves = handle.filter(|handle| handle.standstill() != Some(Standstill::Confirmed));
    if moves.is_some() {
        return stop(moves.as_ref());
    }
    // Nothing moves: a driver ends with the program.
    let told = *TOLD.lock().unwrap_or_else(PoisonError::into_inner);
    if told.is_none_or(|told| told.elapsed() > ENDING) {
        process::exit(exit::STOPPED.into());
    }
}

fn stop(handle: Option<&StopHandle>) {
    let Some(handle) = handle else { return };
    *TOLD.lock().unwrap_or_else(PoisonError::into_inner) = Some(Instant::now());
    let outcome = handle.stop();
    let said = match outcome.by {
        StoppedBy::Driver => "STOP was sent to the machine; waiting until it confirms that it stands",
        StoppedBy::Host => {
            "the driver did not pass STOP on: it was written to the port; waiting until the machine confirms that it stands"
        }
        StoppedBy::NothingMore => "this machine cannot be stopped: it is sent nothing more; cut its power",
        StoppedBy::EndOfDriver => {
            "the driver did not pass STOP on and was ended: cut the power of the machine"
        }
        StoppedBy::EndOfSimulation => {
            "the driver did not pass STOP on and was ended, and the machine that it simulated with it"
        }
    };
    let _ = writeln!(std::io::stderr(), "\n{said} ({} ms)", outcome.took.as_millis());
}
