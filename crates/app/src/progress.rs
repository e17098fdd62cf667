//! How a front end hears of long work, is asked on behalf of a person, and gets at a stop.

use wirebend_driver_host::StopHandle;

use crate::{Decision, Doubt, News};

/// What a person wants of a wire that is being made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wish {
    /// The machine holds.
    Pause,
    /// It goes on after that.
    Resume,
}

/// What becomes of a wait before a port is opened.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wait {
    /// It goes on to its end.
    GoesOn,
    /// It is over: a person wants the machine stopped, for which the port has to be opened.
    IsOver,
    /// The port is not to be opened any more.
    GivenUp,
}

/// Hears what is being done. Called from the thread that runs the command.
///
/// What moves a machine asks here first. The defaults are those of a front end without a person: nobody hears,
/// nobody answers, and so nothing moves unless the request itself says that it was confirmed.
pub trait Progress {
    /// A stage begins: a word or two for a person.
    fn stage(&self, name: &str);
    /// So many of so many things are done.
    fn advance(&self, done: u64, of: u64);
    /// Something happened on a machine, or is about to.
    fn news(&self, _news: &News) {}
    /// Asks a person whether something may move. `None`: nobody is there to be asked.
    fn confirm(&self, _question: &str) -> Option<bool> {
        None
    }
    /// Asks a person whether what they have said of a wire before is so. `None`: nobody is there to be asked.
    fn is_so(&self, said: &str) -> Option<bool> {
        self.confirm(said)
    }
    /// Asks a person, who looks at the wire, what became of a step. `None`: nobody is there, or nobody knows.
    fn decide(&self, _doubt: &Doubt) -> Option<Decision> {
        None
    }
    /// Asks a person, who looks at the machine, where its head stands: degrees, from the least to the most that it can be.
    /// `left_at`: where it was left, which they may confirm. `None`: nobody is there, or nobody knows.
    fn place_of_head(&self, _question: &str, _range: [f64; 2], _left_at: Option<f64>) -> Option<f64> {
        None
    }
    /// What a person wants of the wire that is being made, once: asked at every turn of the loop.
    fn wish(&self) -> Option<Wish> {
        None
    }
    /// Whether a person still wants what the program waits for before it opens a port: asked at every turn of the wait.
    fn wait(&self) -> Wait {
        Wait::GoesOn
    }
    /// A machine can be stopped by this from now on, from any thread, whatever the command is doing. A front end
    /// keeps it until [`Progress::disconnected`], and should a person have asked for a stop before, uses it now.
    fn connected(&self, _stop: &StopHandle) {}
    /// No machine is connected any more.
    fn disconnected(&self) {}
}

/// Hears nothing.
#[derive(Debug, Clone, Copy, Default)]
pub struct NoProgress;

impl Progress for NoProgress {
    fn stage(&self, _name: &str) {}
    fn advance(&self, _done: u64, _of: u64) {}
}
