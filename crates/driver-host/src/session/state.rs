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
    /// It makes a wire.
    Running,
    /// It holds in the middle of a wire.
    Paused,
    /// The wire is made.
    Done,
    /// It was stopped.
    Stopped,
    /// It, its line or its driver failed.
    Faulted,
}

impl State {
    /// Every state.
    pub const ALL: [Self; 9] = [
        Self::Disconnected,
        Self::Connected,
        Self::Homed,
        Self::Armed,
        Self::Running,
        Self::Paused,
        Self::Done,
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
            Self::Running => "running",
            Self::Paused => "paused",
            Self::Done => "done",
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
        use State::{Armed, Connected, Done, Faulted, Homed, Paused, Running, Stopped};
        match (act, self) {
            // While it searches its reference it does not know where it is.
            (Act::Home, Connected | Homed | Done | Stopped | Faulted) => Transition::To(Connected),
            (Act::Arm, Homed | Armed | Done) | (Act::Jog, Armed) => Transition::To(Armed),
            // Holding and going on change the state when the machine says so.
            (Act::Send, Armed | Running) | (Act::Pause, Running) => Transition::To(Running),
            (Act::Send | Act::Resume, Paused) => Transition::To(Paused),
            (Act::Home, _) => Transition::Refused { expected: "connected and at rest" },
            (Act::Arm, _) => Transition::Refused { expected: "homed, or done with a wire" },
            (Act::Send, _) => Transition::Refused { expected: "armed for a wire" },
            (Act::Jog, _) => Transition::Refused { expected: "armed, with no wire in hand" },
            (Act::Pause, _) => Transition::Refused { expected: "running" },
            (Act::Resume, _) => Transition::Refused { expected: "paused" },
        }
    }

    /// What a report leads to. A report that does not fit the state changes nothing: a machine that says
    /// that it goes on after a stop is not believed.
    #[must_use]
    pub const fn after(self, event: &Event) -> Self {
        match (event, self) {
            (Event::Connected { homed: true, .. }, Self::Disconnected) | (Event::Homed, Self::Connected) => {
                Self::Homed
            }
            (Event::Connected { homed: false, .. }, Self::Disconnected) => Self::Connected,
            (Event::Finished, Self::Running) => Self::Done,
            (Event::Paused, Self::Running) => Self::Paused,
            (Event::Resumed, Self::Paused) => Self::Running,
            (Event::Stopped { .. }, Self::Disconnected | Self::Faulted) => self,
            (Event::Stopped { .. }, _) => Self::Stopped,
            (Event::Fault { .. }, _) => Self::Faulted,
            _ => self,
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;
    use wirebend_driver_api::DriverError;

    use super::*;

    const ACTS: [Act; 6] = [Act::Home, Act::Arm, Act::Send, Act::Jog, Act::Pause, Act::Resume];

    fn events() -> Vec<Event> {
        let error = DriverError::new("x", "x", "x");
        vec![
            Event::Connected { identity: String::new(), settings: Vec::new(), homed: false },
            Event::Connected { identity: String::new(), settings: Vec::new(), homed: true },
            Event::Homed,
            Event::Done { n: 1 },
            Event::Finished,
            Event::Jogged,
            Event::Paused,
            Event::Resumed,
            Event::Stopped { homed: true },
            Event::Warning(error.clone()),
            Event::Fault { error, in_doubt: None, disconnected: true },
        ]
    }

    proptest! {
        /// However a driver reports and whatever is asked: from anywhere to running there is no way that does
        /// not pass through armed, and to armed none that does not pass through a reference.
        #[test]
        fn nothing_runs_that_was_not_armed(turns in prop::collection::vec((any::<bool>(), 0_usize..11), 0..60)) {
            let (mut state, mut armed, mut referenced) = (State::Disconnected, false, false);
            for (is_act, k) in turns {
                let before = state;
                if is_act {
                    let act = ACTS[k % ACTS.len()];
                    if let Transition::To(next) = state.on(act) {
                        if act == Act::Arm {
                            prop_assert!(referenced, "armed without a reference from {before}");
                            armed = true;
                        }
                        if act == Act::Home {
                            (referenced, armed) = (false, false);
                        }
                        prop_assert!(!matches!(act, Act::Send | Act::Jog | Act::Resume) || armed, "{act} from {before}");
                        state = next;
                    }
                } else {
                    state = state.after(&events()[k]);
                    if matches!(state, State::Done | State::Stopped | State::Faulted | State::Homed) && state != before {
                        armed = false;
                    }
                    referenced = match state {
                        State::Homed => true,
                        State::Stopped | State::Faulted | State::Connected | State::Disconnected => false,
                        _ => referenced,
                    };
                }
            }
        }
    }

    #[test]
    fn a_stop_or_a_fault_is_left_by_homing_alone() {
        for state in [State::Stopped, State::Faulted] {
            for act in ACTS {
                assert_eq!(
                    matches!(state.on(act), Transition::To(_)),
                    act == Act::Home,
                    "{act} while {state}"
                );
            }
            for event in events() {
                let next = state.after(&event);
                assert!(
                    matches!(next, State::Stopped | State::Faulted),
                    "{event:?} leads from {state} to {next}"
                );
            }
        }
    }

    #[test]
    fn every_state_has_a_name_of_its_own() {
        let names: std::collections::BTreeSet<String> = State::ALL.iter().map(ToString::to_string).collect();
        assert_eq!(names.len(), State::ALL.len());
    }
}
