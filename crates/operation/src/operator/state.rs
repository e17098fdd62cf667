//! How a machine and its operator stand, as a front end draws it.

use schemars::JsonSchema;
use serde::Serialize;
use wirebend_driver_host::api::{DoneBy, SettingCheck};
use wirebend_driver_host::jobs::Piece;
use wirebend_driver_host::{OrderName, Phase, RefusedOrder, WireProgress};
use wirebend_error::ProblemReport;

use super::ConnectRequest;
use super::question::Question;
use super::unfinished::Unfinished;
use crate::MachineEvent;
use crate::run::Task;
use wirebend_planning::JobStep;
use wirebend_planning::job::SimulatedAs;

/// How a machine and its operator stand.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MachineState {
    pub phase: Phase,
    /// Something moves, or may move without being asked again.
    pub may_move: bool,
    /// An order is being carried out, or a person is asked because of it: what is reported of the phase is not its end.
    pub busy: bool,
    /// What is being done within that, in a word or two.
    pub doing: Option<String>,
    pub machine: String,
    /// Where it is; null where no port was named and none is known yet.
    pub port: Option<String>,
    /// No machine is there: its driver computes one.
    pub simulated: bool,
    /// What it simulates where that is not what its profile says.
    pub simulated_as: SimulatedAs,
    /// What it says that it is.
    pub identity: Option<String>,
    pub driver: Option<String>,
    /// Where its axes are, in canonical signs.
    pub position: Option<JobStep>,
    /// How fast it is, percent of the programmed speed; null where that cannot be changed.
    pub speed_percent: Option<u8>,
    /// Where its cutter is, mm, if it has one: how far beyond the place where a wire begins, or inside of it below zero.
    pub cutter_mm: Option<f64>,
    /// Settings of the machine that are not those of its profile.
    pub settings: Vec<SettingCheck>,
    /// The wire that is armed or being bent, or that was the last.
    pub wire: Option<WireState>,
    /// The orders that are possible now.
    pub can: Vec<OrderName>,
    /// The others, and why they are not possible now.
    pub cannot: Vec<RefusedOrder>,
    /// What a person is being asked.
    pub question: Option<Question>,
    /// How many moves are recorded.
    pub recorded: usize,
    /// What failed last; null once something else was ordered.
    pub problem: Option<ProblemReport>,
    /// The last wire on it, where that was interrupted and can be resumed.
    pub unfinished: Option<Unfinished>,
}

/// How far a wire is.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct WireState {
    /// Hash of its job: the open design may give another one by now.
    pub job_hash: String,
    /// Name of the design.
    pub name: String,
    /// Index of the wire in its job, from 0.
    pub wire: usize,
    /// Which piece it is, where several are bent in a row.
    pub piece: Option<Piece>,
    /// Wire that is left before it, mm; null where that is not known.
    pub stock_left_mm: Option<f64>,
    /// The last step that is done, or whose time is over where the machine does not report that.
    pub made: u32,
    /// Whether the machine or the clock says so.
    pub done_by: DoneBy,
    /// The last that the machine has taken.
    pub sent: u32,
    /// How many there are.
    pub of: u32,
    /// How far the machine is in the step after `made`, in part of the step's time, from where it reports its axes; 0 where
    /// it reports none.
    pub in_step: f64,
    /// How long the machine was at work on it, in all of its parts, without pauses, s.
    pub elapsed_s: f64,
    /// What is estimated to be left, s.
    pub remaining_s: f64,
}

impl WireState {
    /// A wire of which so many steps are done, and nothing more is on its way.
    pub(super) fn of(task: &Task, wire: usize, name: String, made: u32, done_by: DoneBy) -> Self {
        let kept = task.wire(wire).ok();
        let of = kept.map_or(0, |kept| u32::try_from(kept.compensated.len()).unwrap_or(u32::MAX));
        let left = f64::from(of.saturating_sub(made)) / f64::from(of.max(1));
        Self {
            job_hash: task.job.hash().to_owned(),
            name,
            wire,
            piece: task.pieces.get().piece(),
            stock_left_mm: task.pieces.get().left_mm(),
            made,
            done_by,
            sent: made,
            of,
            in_step: 0.0,
            elapsed_s: 0.0,
            remaining_s: kept.map_or(0.0, |kept| kept.time_s * left),
        }
    }

    /// How far it is, as the session says.
    pub(super) const fn take(&mut self, progress: WireProgress) {
        let WireProgress { made, sent, of, elapsed, remaining } = progress;
        if made != self.made {
            self.in_step = 0.0;
        }
        (self.made, self.sent, self.of) = (made, sent, of);
        (self.elapsed_s, self.remaining_s) = (elapsed.as_secs_f64(), remaining.as_secs_f64());
    }

    /// The same as news.
    pub(super) const fn news(&self) -> MachineEvent {
        let Self { wire, made, sent, of, in_step, elapsed_s, remaining_s, .. } = *self;
        MachineEvent::Wire { wire, made, sent, of, in_step, elapsed_s, remaining_s }
    }
}

impl MachineState {
    pub(super) fn connecting(ConnectRequest { machine, port, simulated_as }: ConnectRequest) -> Self {
        Self {
            phase: Phase::Connecting,
            may_move: false,
            busy: true,
            doing: None,
            machine,
            port,
            simulated: false,
            simulated_as,
            identity: None,
            driver: None,
            position: None,
            speed_percent: None,
            cutter_mm: None,
            settings: Vec::new(),
            wire: None,
            can: Vec::new(),
            cannot: Vec::new(),
            question: None,
            recorded: 0,
            problem: None,
            unfinished: None,
        }
    }
}
