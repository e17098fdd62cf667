//! What may be done with a wire that was interrupted. A decision without a machine and without a file.

use wirebend_driver_api::ResumeState;

use super::journal_state::{JobState, JournalState};

/// What may be done with a wire.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Resume {
    /// The machine still is in the session: it runs what it has taken, and sending resumes at `from`.
    Reattach {
        /// The first step that it has not taken; one more than there are when it has taken all.
        from: u32,
        /// The last that it has done.
        done: u32,
    },
    /// The machine was reset or lost, and some steps are in doubt. A person looks whether `in_doubt` was done:
    /// yes, no, or the wire is given up. The machine has to be homed besides.
    Ask {
        /// The first step in doubt: it was done, not done, or done in part.
        in_doubt: u32,
        /// The last that was sent. When the first was done, the next one is in doubt, up to here.
        last: u32,
    },
    /// No step is in doubt. The machine has to be homed and armed with a person's confirmation, and
    /// resumes at `from`; this is how a new wire begins, too.
    Arm {
        /// The first that is not done.
        from: u32,
    },
    /// There is nothing to be done.
    Nothing(Settled),
    /// The machine and the journal cannot both be right: nothing may be sent.
    Contradiction(Contradiction),
}

/// Why nothing is to be done.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Settled {
    /// The wire is finished, and that was written down.
    Finished,
    /// A person has given it up.
    Abandoned,
    /// Every step is done, but the report that the wire is finished was lost.
    AllMade,
}

/// How the machine and the journal contradict each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("{kind}")]
pub struct Contradiction {
    pub kind: ContradictionKind,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum ContradictionKind {
    /// It has forgotten a step.
    #[error("the machine says that it has done {machine} steps, and has reported {journal} before")]
    MadeLess {
        machine: u32,
        /// What was written down.
        journal: u32,
    },
    /// It has steps of another program.
    #[error("the machine says that it has taken {machine} steps, and no more than {journal} were sent")]
    NeverSent {
        machine: u32,
        /// What was written down.
        journal: u32,
    },
    /// It has done what it has not taken.
    #[error("the machine says that it has done {done} steps and taken {accepted}")]
    MadeMoreThanTaken {
        done: u32,
        /// Taken.
        accepted: u32,
    },
    /// A stop ends a session.
    #[error("the machine was stopped, and says that it still is in the wire")]
    Stopped,
}

impl Resume {
    /// From what was written down and what the machine says: `machine` is where it is in the session of the
    /// journal's token, `None` when it is not in it any more or does not report that.
    #[must_use]
    pub fn decide(state: &JournalState, machine: Option<ResumeState>) -> Self {
        match state.standing {
            JobState::Finished => return Self::Nothing(Settled::Finished),
            JobState::Abandoned => return Self::Nothing(Settled::Abandoned),
            _ => {}
        }
        if let Some(machine) = machine {
            return match contradiction(state, machine) {
                Some(kind) => Self::Contradiction(Contradiction { kind }),
                None => Self::Reattach { from: machine.accepted + 1, done: machine.done },
            };
        }
        match state.in_doubt() {
            Some(steps) => Self::Ask { in_doubt: *steps.start(), last: *steps.end() },
            None if state.done >= state.heading.steps => Self::Nothing(Settled::AllMade),
            None => Self::Arm { from: state.done + 1 },
        }
    }
}

fn contradiction(state: &JournalState, machine: ResumeState) -> Option<ContradictionKind> {
    let ResumeState { accepted, done } = machine;
    if state.stopped {
        Some(ContradictionKind::Stopped)
    } else if done > accepted {
        Some(ContradictionKind::MadeMoreThanTaken { done, accepted })
    } else if accepted > state.sent {
        Some(ContradictionKind::NeverSent { machine: accepted, journal: state.sent })
    } else if done < state.done {
        Some(ContradictionKind::MadeLess { machine: done, journal: state.done })
    } else {
        // It may have taken less than was written down: what the driver had taken and not passed on died with it.
        None
    }
}
