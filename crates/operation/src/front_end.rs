//! What a front end is to an operation: it hears what happens, is asked on behalf of a person, and can stop or hold the machine.
//!
//! The defaults are those of a front end without a person: events go nowhere, questions get no answer, and so nothing moves unless the
//! request itself says that it was confirmed.

pub use wirebend_driver_host::Wish;
use wirebend_driver_host::{Snapshot, StopHandle};
use wirebend_planning::{NoProgress, Progress};

use crate::{Decision, Doubt, MachineEvent};

/// What becomes of a wait before a port is opened.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wait {
    /// It continues to its end.
    GoesOn,
    /// It is over: a person wants the machine stopped, for which the port has to be opened.
    IsOver,
    /// The port is not to be opened any more.
    GivenUp,
}

/// Hears what happens on a machine. Called from the thread that runs the operation.
pub trait Observer {
    /// Something happened, or is about to.
    fn event(&self, _event: &MachineEvent) {}
    /// How the machine stands now: said whenever something was asked of it, or it was looked at.
    fn snapshot(&self, _snapshot: &Snapshot) {}
    /// How far the machine is in the step that it runs, in part of the step's time: said with each position.
    fn in_step(&self, _part: f64) {}
}

/// Asks a person. What moves a machine asks first.
pub trait Prompt {
    /// Whether something may move. `None`: there is no user to ask.
    fn confirm(&self, _question: &str) -> Option<bool> {
        None
    }
    /// Whether what they have said of a wire before is so. `None`: there is no user to ask.
    fn is_so(&self, said: &str) -> Option<bool> {
        self.confirm(said)
    }
    /// Whether a person has done what is to be done at a pause point, and the machine, which stands there, may go on. `look` looks
    /// at the machine, again and again until there is an answer; where it gives false there is nothing to ask any more. `None`:
    /// there is no user to ask.
    fn confirm_pause(&self, _question: &str, _look: &mut dyn FnMut() -> bool) -> Option<bool> {
        None
    }
    /// What became of a step; the user looks at the wire. `None`: there is no user, or they do not know.
    fn decide(&self, _doubt: &Doubt) -> Option<Decision> {
        None
    }
    /// Where the head stands, in degrees within `range`; the person looks at the machine. `left_at`: where it was left, which
    /// they may confirm. `None`: there is no user, or they do not know.
    fn place_of_head(&self, _question: &str, _range: [f64; 2], _left_at: Option<f64>) -> Option<f64> {
        None
    }
}

/// How a person stops, holds or gives up what is under way.
pub trait Cancellation {
    /// What a person wants of the wire that is being bent, once: asked at every turn of the loop.
    fn wish(&self) -> Option<Wish> {
        None
    }
    /// Whether a person still wants what the program waits for before it opens a port: asked at every turn of the wait.
    fn wait(&self) -> Wait {
        Wait::GoesOn
    }
    /// A machine can be stopped by this from now on, from any thread, whatever the operation is doing. A front end
    /// keeps it until [`Cancellation::disconnected`], and should a person have asked for a stop before, uses it now.
    fn connected(&self, _stop: &StopHandle) {}
    /// No machine is connected any more.
    fn disconnected(&self) {}
}

pub trait FrontEnd: Progress + Observer + Prompt + Cancellation {}

impl<T: Progress + Observer + Prompt + Cancellation> FrontEnd for T {}

impl Observer for NoProgress {}
impl Prompt for NoProgress {}
impl Cancellation for NoProgress {}
