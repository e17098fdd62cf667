//! What may be done with a wire that was interrupted. A decision without a machine and without a file.

use wirebend_driver_api::GoingOn;

use super::account::{Account, Standing};

/// What may be done with a wire.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Resume {
    /// The machine still is in the session: what it has taken it makes, and sending goes on at `from`.
    GoOn {
        /// The first step that it has not taken; one more than there are when it has taken all.
        from: u32,
        /// The last that it has made.
        done: u32,
    },
    /// The machine was reset or lost, and of some steps nobody knows. A person looks whether `in_doubt` was made:
    /// yes, no, or the wire is given up. The machine has to be homed besides.
    Ask {
        /// The first step in doubt: it was made, not made, or made in part.
        in_doubt: u32,
        /// The last that was sent. When the first was made, the next one is in doubt, up to here.
        last: u32,
    },
    /// Of every step it is known whether it was made. The machine has to be homed, armed by a person's word, and
    /// goes on at `from`; this is how a new wire begins, too.
    TakeUp {
        /// The first that is not made.
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
    /// The wire is made, and that was written down.
    Finished,
    /// A person has given it up.
    Abandoned,
    /// Every step is made; that the wire is, was not heard any more.
    AllMade,
}

/// How the machine and the journal contradict each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error("{kind}: stop the machine, look at the wire, home it, and decide step by step")]
pub struct Contradiction {
    /// What is wrong.
    pub kind: ContradictionKind,
}

/// What is wrong.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum ContradictionKind {
    /// It has forgotten a step.
    #[error("the machine says that it has made {machine} steps, and has reported {journal} before")]
    MadeLess {
        /// What it says.
        machine: u32,
        /// What was written down.
        journal: u32,
    },
    /// It has steps of somebody else.
    #[error("the machine says that it has taken {machine} steps, and no more than {journal} were sent")]
    NeverSent {
        /// What it says.
        machine: u32,
        /// What was written down.
        journal: u32,
    },
    /// It has made what it has not taken.
    #[error("the machine says that it has made {done} steps and taken {accepted}")]
    MadeMoreThanTaken {
        /// Made.
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
    /// journal's token, `None` when it is not in it any more or cannot tell.
    #[must_use]
    pub fn decide(account: &Account, machine: Option<GoingOn>) -> Self {
        match account.standing {
            Standing::Finished => return Self::Nothing(Settled::Finished),
            Standing::Abandoned => return Self::Nothing(Settled::Abandoned),
            _ => {}
        }
        if let Some(machine) = machine {
            return match contradiction(account, machine) {
                Some(kind) => Self::Contradiction(Contradiction { kind }),
                None => Self::GoOn { from: machine.accepted + 1, done: machine.done },
            };
        }
        match account.in_doubt() {
            Some(steps) => Self::Ask { in_doubt: *steps.start(), last: *steps.end() },
            None if account.done >= account.heading.steps => Self::Nothing(Settled::AllMade),
            None => Self::TakeUp { from: account.done + 1 },
        }
    }
}

fn contradiction(account: &Account, machine: GoingOn) -> Option<ContradictionKind> {
    let GoingOn { accepted, done } = machine;
    if account.stopped {
        Some(ContradictionKind::Stopped)
    } else if done > accepted {
        Some(ContradictionKind::MadeMoreThanTaken { done, accepted })
    } else if accepted > account.sent {
        Some(ContradictionKind::NeverSent { machine: accepted, journal: account.sent })
    } else if done < account.done {
        Some(ContradictionKind::MadeLess { machine: done, journal: account.done })
    } else {
        // It may have taken less than was written down: what the driver had taken and not passed on died with it.
        None
    }
}
