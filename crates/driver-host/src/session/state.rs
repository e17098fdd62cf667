//! The states of a session, and what leads from one to the next. No machine, no driver: values only.

use std::fmt;

use wirebend_driver_api::Event;

/// What the session knows of the machine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum State {
    /// It has not answered yet.
    Disconnected,
    /// It has answered, and does not know where its axes are.
    Connected,
    /// It knows where its axes are.
    Homed,
    /// A person has confirmed that it may move.
    Armed,
    /// It still is in a wire that was begun before this connection. What it has taken it may make by itself; it
    /// takes nothing more until a person has confirmed that.
    Interrupted,
    /// It makes a wire.
    Running,
    /// It holds in the middle of a wire.
    Paused,
    /// The wire is made.
    Done,
    /// A stop was sent, and the machine has not confirmed that it stands.
    Stopping,
    /// It was stopped, and stands.
    Stopped,
    /// It, its line or its driver failed.
    Faulted,
}

impl State {
    /// Every state.
    pub const ALL: [Self; 11] = [
        Self::Disconnected,
        Self::Connected,
        Self::Homed,
        Self::Armed,
        Self::Interrupted,
        Self::Running,
        Self::Paused,
        Self::Done,
        Self::Stopping,
        Self::Stopped,
        Self::Faulted,
    ];
}

impl fmt::Display for State {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Disconnected => "disconnected",
            Self::Connected => "connected",
            Self::Homed => "homed",
            Self::Armed => "armed",
            Self::Interrupted => "in an interrupted wire",
            Self::Running => "running",
            Self::Paused => "paused",
            Self::Done => "done",
            Self::Stopping => "being stopped",
            Self::Stopped => "stopped",
            Self::Faulted => "faulted",
        })
    }
}

/// Something that a person or the program asks for. A stop is always possible and not among them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Act {
    /// Find the reference.
    Home,
    /// Make ready to move.
    Arm,
    /// Send steps.
    Send,
    /// Move one axis.
    Jog,
    /// Hold.
    Pause,
    /// Go on.
    Resume,
    /// Go on with a wire that was begun before this connection.
    TakeUp,
    /// Write settings.
    WriteSettings,
}

impl fmt::Display for Act {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Home => "homing",
            Self::Arm => "arming",
            Self::Send => "sending steps",
            Self::Jog => "jogging",
            Self::Pause => "pausing",
            Self::Resume => "resuming",
            Self::TakeUp => "taking the wire up",
            Self::WriteSettings => "writing settings",
        })
    }
}

/// What an act leads to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Transition {
    To(State),
    Refused { expected: &'static str },
}

impl State {
    /// What an act leads to, before the machine has answered.
    pub(super) const fn on(self, act: Act) -> Transition {
        use State::{Armed, Connected, Done, Faulted, Homed, Interrupted, Paused, Running, Stopped};
        match (act, self) {
            // While it searches its reference it does not know where it is.
            // With other settings the axes are not where they are taken to be.
            (Act::Home, Connected | Homed | Armed | Done | Stopped | Faulted)
            | (Act::WriteSettings, Connected | Homed | Armed | Done) => Transition::To(Connected),
            (Act::Arm, Homed | Armed | Done) | (Act::Jog, Armed) => Transition::To(Armed),
            // Holding and going on change the state when the machine says so.
            (Act::Send, Armed | Running) | (Act::Pause, Running) | (Act::TakeUp, Interrupted) => {
                Transition::To(Running)
            }
            (Act::Send | Act::Resume, Paused) => Transition::To(Paused),
            (Act::WriteSettings, Stopped) => Transition::To(Stopped),
            (Act::WriteSettings, Faulted) => Transition::To(Faulted),
            (Act::Home | Act::WriteSettings, _) => Transition::Refused { expected: "connected and at rest" },
            (Act::Arm, _) => Transition::Refused { expected: "homed, or done with a wire" },
            (Act::Send, _) => Transition::Refused { expected: "armed for a wire" },
            (Act::Jog, _) => Transition::Refused { expected: "armed, with no wire in hand" },
            (Act::Pause, _) => Transition::Refused { expected: "running" },
            (Act::Resume, _) => Transition::Refused { expected: "paused" },
            (Act::TakeUp, _) => Transition::Refused {
                expected: "connected again, and still in the wire that was interrupted",
            },
        }
    }

    /// What a report leads to. A report that does not fit the state changes nothing: a machine that says
    /// that it goes on after a stop is not believed.
    #[must_use]
    pub const fn after(self, event: &Event) -> Self {
        match (event, self) {
            (Event::Connected { going_on: Some(_), .. }, Self::Disconnected) => Self::Interrupted,
            (Event::Connected { homed: true, .. }, Self::Disconnected) | (Event::Homed, Self::Connected) => {
                Self::Homed
            }
            (Event::Connected { homed: false, .. }, Self::Disconnected) => Self::Connected,
            // A machine that holds at its very end has made the wire all the same.
            (Event::Finished, Self::Running | Self::Paused) => Self::Done,
            (Event::Paused { .. }, Self::Running) => Self::Paused,
            (Event::Resumed, Self::Paused) => Self::Running,
            (Event::Stopped { .. }, Self::Disconnected | Self::Faulted) => self,
            (Event::Stopped { .. }, _) => Self::Stopped,
            (Event::Fault { .. }, _) => Self::Faulted,
            _ => self,
        }
    }
}

#[cfg(test)]
mod tests;
