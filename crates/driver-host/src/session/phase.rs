//! What a machine is in, and what leads from one phase to the next. No machine, no driver: values only.

use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_driver_api::Event;
use wirebend_error::ErrorRemedy;

/// What the machine is in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Phase {
    /// It has not answered yet.
    Connecting,
    /// It has answered, and does not know where its axes are.
    Connected,
    /// It homes.
    Homing,
    /// It is homed and at rest.
    Ready,
    /// It is moved by hand.
    Moving,
    /// A person has said yes to a wire, which is not started.
    Armed,
    /// It bends a wire.
    Making,
    /// It holds in the middle of a wire.
    Holding,
    /// A stop is on its way.
    Stopping,
    /// It was stopped, and has to be homed.
    Stopped,
    /// It, its line or its driver failed.
    Failed,
    /// The operator is done: nothing is connected.
    Closed,
    /// It still is in a wire that was begun before this connection. What it has taken it may run by itself; it takes
    /// nothing more until a person has confirmed that. For a front end it is being connected until then.
    #[serde(rename = "connecting", skip_deserializing)]
    #[schemars(skip)]
    Interrupted,
    /// It carries out a line of the console. For a front end it is being moved by hand.
    #[serde(rename = "moving", skip_deserializing)]
    #[schemars(skip)]
    Commanded,
    /// It cuts off what was bent. For a front end it is being moved by hand.
    #[serde(rename = "moving", skip_deserializing)]
    #[schemars(skip)]
    Cutting,
}

impl Phase {
    pub const ALL: [Self; 15] = [
        Self::Connecting,
        Self::Connected,
        Self::Homing,
        Self::Ready,
        Self::Moving,
        Self::Armed,
        Self::Making,
        Self::Holding,
        Self::Stopping,
        Self::Stopped,
        Self::Failed,
        Self::Closed,
        Self::Interrupted,
        Self::Commanded,
        Self::Cutting,
    ];

    /// What leads on from here.
    #[must_use]
    pub const fn remedy(self) -> ErrorRemedy {
        match self {
            Self::Connecting
            | Self::Homing
            | Self::Moving
            | Self::Commanded
            | Self::Cutting
            | Self::Stopping => ErrorRemedy::Wait,
            Self::Connected | Self::Stopped => ErrorRemedy::Home,
            Self::Ready => ErrorRemedy::ArmOrJog,
            Self::Armed => ErrorRemedy::StartOrDisarm,
            Self::Making => ErrorRemedy::PauseOrStop,
            Self::Holding | Self::Interrupted => ErrorRemedy::ContinueOrStop,
            Self::Failed => ErrorRemedy::ConnectAgain,
            Self::Closed => ErrorRemedy::Connect,
        }
    }

    /// Whether something moves, may move at any moment, or is in the middle of a wire.
    #[must_use]
    pub const fn is_under_way(self) -> bool {
        matches!(
            self,
            Self::Connecting | Self::Homing | Self::Moving | Self::Commanded | Self::Cutting | Self::Stopping
        ) || self.is_in_a_wire()
    }

    /// Whether something moves, or may move without being asked again.
    #[must_use]
    pub const fn may_move(self) -> bool {
        self.is_under_way() && !matches!(self, Self::Connecting)
    }

    /// Whether the machine is in the middle of a wire.
    #[must_use]
    pub const fn is_in_a_wire(self) -> bool {
        matches!(self, Self::Making | Self::Holding | Self::Interrupted)
    }
}

impl fmt::Display for Phase {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Connecting => "being connected",
            Self::Connected => "not homed",
            Self::Homing => "homing",
            Self::Ready => "at rest",
            Self::Moving => "being moved by hand",
            Self::Armed => "armed",
            Self::Making => "bending",
            Self::Holding => "paused",
            Self::Stopping => "being stopped",
            Self::Stopped => "stopped",
            Self::Failed => "out of order",
            Self::Closed => "not connected",
            Self::Interrupted => "in an interrupted wire",
            Self::Commanded => "carrying out a line of the console",
            Self::Cutting => "cutting the wire off",
        })
    }
}

/// Something that a person or the program asks for. A stop is always possible and not among them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Act {
    /// Find the reference.
    Home,
    /// Make ready for a wire.
    Arm,
    /// Make ready for moves by hand.
    ArmByHand,
    /// Send steps.
    Send,
    /// Move one axis.
    Jog,
    /// Hold.
    Pause,
    /// Resume.
    Resume,
    /// Change the speed.
    Speed,
    /// Resume a wire that was begun before this connection.
    Reattach,
    WriteSettings,
    /// Ask something on the console.
    Ask,
    /// Pass on a line of the console that may move or change something.
    Command,
    /// Cut off what was bent.
    Cut,
}

impl fmt::Display for Act {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Home => "homing",
            Self::Arm | Self::ArmByHand => "arming",
            Self::Send => "sending steps",
            Self::Jog => "jogging",
            Self::Pause => "pausing",
            Self::Resume => "resuming",
            Self::Speed => "changing the speed",
            Self::Reattach => "reattaching the wire",
            Self::WriteSettings => "writing settings",
            Self::Ask | Self::Command => "a line of the console",
            Self::Cut => "cutting the wire off",
        })
    }
}

/// What an act leads to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Transition {
    To(Phase),
    Refused { expected: &'static str },
}

impl Phase {
    /// What an act leads to, before the machine has answered.
    pub(super) const fn on(self, act: Act) -> Transition {
        use Phase::{
            Armed, Commanded, Connected, Cutting, Failed, Holding, Homing, Interrupted, Making, Moving,
            Ready, Stopped,
        };
        match (act, self) {
            (Act::Home, Connected | Ready | Moving | Armed | Stopped | Failed) => Transition::To(Homing),
            // With other settings the axes are not where they are taken to be.
            (Act::WriteSettings, Connected | Ready | Moving | Armed) | (Act::Ask, Connected) => {
                Transition::To(Connected)
            }
            // A token for the other purpose is refused as such.
            (Act::Arm, Ready | Moving | Armed) | (Act::Jog, Armed) => Transition::To(Armed),
            (Act::ArmByHand, Ready | Moving | Armed) | (Act::Jog | Act::Send, Moving) => {
                Transition::To(Moving)
            }
            // Holding and resuming change the phase when the machine says so.
            (Act::Send, Armed | Making)
            | (Act::Pause | Act::Speed, Making)
            | (Act::Reattach, Interrupted) => Transition::To(Making),
            (Act::Send | Act::Resume | Act::Speed, Holding) => Transition::To(Holding),
            (Act::WriteSettings | Act::Ask, Stopped) => Transition::To(Stopped),
            (Act::Ask, Ready) => Transition::To(Ready),
            (Act::Command, Connected | Ready | Stopped) => Transition::To(Commanded),
            (Act::Cut, Ready) => Transition::To(Cutting),
            (Act::WriteSettings, Failed) => Transition::To(Failed),
            (Act::Home | Act::WriteSettings, _) => Transition::Refused { expected: "connected and at rest" },
            (Act::Ask | Act::Command, _) => Transition::Refused { expected: "at rest, with no wire armed" },
            (Act::Cut, _) => Transition::Refused { expected: "homed and at rest, with no wire armed" },
            (Act::Arm | Act::ArmByHand, _) => Transition::Refused { expected: "homed, or done with a wire" },
            (Act::Send, _) => Transition::Refused { expected: "armed for a wire" },
            (Act::Jog, _) => Transition::Refused { expected: "armed, with no wire in hand" },
            (Act::Pause, _) => Transition::Refused { expected: "running" },
            (Act::Speed, _) => Transition::Refused { expected: "running or paused" },
            (Act::Resume, _) => Transition::Refused { expected: "paused" },
            (Act::Reattach, _) => Transition::Refused {
                expected: "connected again, and still in the wire that was interrupted",
            },
        }
    }

    /// What a report leads to. A report that does not fit the state changes nothing: a machine that says
    /// that it resumes after a stop is not believed.
    #[must_use]
    pub const fn after(self, event: &Event) -> Self {
        match (event, self) {
            (Event::Connected { resume: Some(_), .. }, Self::Connecting) => Self::Interrupted,
            (Event::Connected { homed: true, .. }, Self::Connecting)
            | (Event::Homed, Self::Connected | Self::Homing)
            // A machine that holds at its very end has finished the wire anyway.
            | (Event::Finished, Self::Making | Self::Holding)
            | (Event::Cut, Self::Cutting) => Self::Ready,
            (Event::Connected { homed: false, .. }, Self::Connecting)
            // After what may have moved it, the axes are not where they are taken to be.
            | (Event::ConsoleDone { .. }, Self::Commanded)
            | (Event::ConsoleDone { homed: false, .. }, Self::Ready) => Self::Connected,
            (Event::Paused { .. }, Self::Making) => Self::Holding,
            (Event::Resumed, Self::Holding) => Self::Making,
            (Event::Stopped { .. }, Self::Connecting | Self::Failed) => self,
            (Event::Stopped { .. }, _) => Self::Stopped,
            (Event::Fault { .. }, _) => Self::Failed,
            _ => self,
        }
    }
}

#[cfg(test)]
mod tests;
