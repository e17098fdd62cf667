//! How a machine and its operator stand, as a front end draws it.

use std::collections::BTreeSet;
use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_driver_host::api::{Capability, DoneBy, SettingCheck};

use super::event::Question;
use super::order::OrderName;
use super::unfinished::Unfinished;
use crate::run::Task;
use crate::{RunProblem, StepReport};

/// What the machine is in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Phase {
    /// It has not answered yet.
    Connecting,
    /// It has answered, and does not know where its axes are.
    Connected,
    /// It searches its reference.
    Homing,
    /// It is homed and at rest.
    Ready,
    /// It is moved by hand.
    Moving,
    /// A person has said yes to a wire, which is not started.
    Armed,
    /// It makes a wire.
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
            Self::Making => "making a wire",
            Self::Holding => "holding in a wire",
            Self::Stopping => "being stopped",
            Self::Stopped => "stopped",
            Self::Failed => "out of order",
            Self::Closed => "not connected",
        })
    }
}

impl Phase {
    /// What leads on from here.
    pub(crate) const fn advice(self) -> &'static str {
        match self {
            Self::Connecting | Self::Homing | Self::Moving | Self::Stopping => "wait until that is over",
            Self::Connected | Self::Stopped => "home it first",
            Self::Ready => "arm a wire, or move it by hand",
            Self::Armed => "start the wire, or disarm it first",
            Self::Making => "pause or stop it first",
            Self::Holding => "let it go on, or stop it first",
            Self::Failed => "see what failed, and connect it again",
            Self::Closed => "connect it first",
        }
    }

    /// Whether something moves, may move at any moment, or is in the middle of a wire.
    pub(crate) const fn is_under_way(self) -> bool {
        matches!(
            self,
            Self::Connecting | Self::Homing | Self::Moving | Self::Making | Self::Holding | Self::Stopping
        )
    }
}

/// How a machine and its operator stand.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MachineState {
    /// What it is in.
    pub phase: Phase,
    /// An order is being carried out, or a person is asked because of it: what is told of the phase is not its end.
    pub busy: bool,
    /// What is being done within that, in a word or two.
    pub doing: Option<String>,
    /// The machine.
    pub machine: String,
    /// Where it is; null where no port was named and none is known yet.
    pub port: Option<String>,
    /// No machine is there: its driver computes one.
    pub simulated: bool,
    /// What it says that it is.
    pub identity: Option<String>,
    /// Its driver.
    pub driver: Option<String>,
    /// Where its axes are, in canonical signs.
    pub position: Option<StepReport>,
    /// Settings of the machine that are not those of its profile.
    pub settings: Vec<SettingCheck>,
    /// The wire that is armed or being made, or that was the last.
    pub wire: Option<WireState>,
    /// The orders that make sense now.
    pub can: Vec<OrderName>,
    /// What a person is being asked.
    pub question: Option<Question>,
    /// How many moves are recorded.
    pub recorded: usize,
    /// What failed last; null once something else was ordered.
    pub problem: Option<RunProblem>,
    /// The last wire on it, where that was interrupted and can be gone on with.
    pub unfinished: Option<Unfinished>,
}

/// How far a wire is.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct WireState {
    /// Hash of its job: the open design may make another one by now.
    pub job_hash: String,
    /// Name of the design.
    pub name: String,
    /// Index of the wire in its job, from 0.
    pub wire: usize,
    /// The last step that was made, or whose time is over where the machine does not say what it makes.
    pub made: u32,
    /// Who says so.
    pub done_by: DoneBy,
    /// The last that the machine has taken.
    pub sent: u32,
    /// How many there are.
    pub of: u32,
    /// Since it was started or taken up, s.
    pub elapsed_s: f64,
    /// What is estimated to be left, s.
    pub remaining_s: f64,
}

impl WireState {
    /// A wire of which so many steps are made, and nothing more is on its way.
    pub(super) fn of(task: &Task, wire: usize, name: String, made: u32, done_by: DoneBy) -> Self {
        let kept = task.wire(wire).ok();
        let of = kept.map_or(0, |kept| u32::try_from(kept.compensated.len()).unwrap_or(u32::MAX));
        let left = f64::from(of.saturating_sub(made)) / f64::from(of.max(1));
        Self {
            job_hash: task.job.hash().to_owned(),
            name,
            wire,
            made,
            done_by,
            sent: made,
            of,
            elapsed_s: 0.0,
            remaining_s: kept.map_or(0.0, |kept| kept.time_s * left),
        }
    }
}

impl MachineState {
    pub(super) fn connecting(machine: String, port: Option<String>) -> Self {
        Self {
            phase: Phase::Connecting,
            busy: true,
            doing: None,
            machine,
            port,
            simulated: false,
            identity: None,
            driver: None,
            position: None,
            settings: Vec::new(),
            wire: None,
            can: Vec::new(),
            question: None,
            recorded: 0,
            problem: None,
            unfinished: None,
        }
    }
}

/// Whether a driver that can do so much has nothing against an order.
pub(super) fn knows(abilities: &BTreeSet<Capability>, order: OrderName) -> bool {
    let needed = match order {
        OrderName::Home => Capability::Home,
        OrderName::Jog | OrderName::Replay => Capability::Jog,
        OrderName::Pause => Capability::Pause,
        OrderName::Resume => Capability::Resume,
        OrderName::WriteSettings => Capability::Settings,
        _ => return true,
    };
    abilities.contains(&needed)
}

/// The orders that a phase allows, whatever the driver can.
pub(super) const fn allowed(phase: Phase) -> &'static [OrderName] {
    use OrderName::{
        Abandon, Arm, Disarm, Disconnect, Home, Jog, Pause, Replay, Resume, ResumeRun, Start, WriteSettings,
    };
    match phase {
        // A wire, and a recording, begin with the search for the reference where that is not known.
        Phase::Connected | Phase::Stopped => {
            &[Home, Arm, ResumeRun, Abandon, Replay, WriteSettings, Disconnect]
        }
        Phase::Ready => &[Home, Jog, Arm, ResumeRun, Abandon, Replay, WriteSettings, Disconnect],
        Phase::Armed => &[Start, Disarm, Home, Jog, Arm, ResumeRun, Abandon, Replay, Disconnect],
        Phase::Making => &[Pause],
        Phase::Holding => &[Resume],
        // Homing ends what only the machine itself has against moving; going on connects anew.
        Phase::Failed => &[Home, ResumeRun, Abandon, Disconnect],
        Phase::Connecting | Phase::Homing | Phase::Moving | Phase::Stopping | Phase::Closed => &[],
    }
}
