//! Pieces cut off by the machine.

use wirebend_driver_host::api::{Capability, Event};
use wirebend_driver_host::{Permit, PermitKind, Session, Standstill};
use wirebend_error::ProblemReport;

use super::absence::Watch;
use super::report::RunResponse;
use super::task::Task;
use crate::live::{Connection, refused, stop_of};
use crate::{LiveProblem, OperationError};

/// During which a machine can be stopped.
const DURING: &str = "the wire was cut off";

/// A yes to one wire, or to several that are each cut off.
pub struct WirePermit {
    /// For the wire that is next.
    pub wire: Permit,
    /// For those that follow it, and the cuts.
    pub row: Option<Permit>,
}

/// What follows a wire that was to be cut off.
pub enum AfterCut {
    /// The next one, as a person has permitted.
    GoesOn(Permit),
    /// The next one, once a person has said that it may: the computer slept meanwhile, and they may have their hands in the machine.
    Asks,
    /// Nothing: it is not cut off.
    Ends,
}

impl WirePermit {
    pub fn new(session: &Session, permit: Permit, cuts: bool) -> Result<Self, LiveProblem> {
        if !cuts {
            return Ok(Self { wire: permit, row: None });
        }
        let wire = session.permit_in_row(&permit);
        let wire = wire.map_err(|error| refused(session, error, "the next wire was to be begun"))?;
        Ok(Self { wire, row: Some(permit) })
    }
}

impl Task<'_> {
    /// Takes note of the machine's cutter. Refuses wires that it is wanted for and cannot cut off.
    pub fn require_cutter(&self, connection: &Connection, wires: &[usize]) -> Result<(), OperationError> {
        let cutter_mm = connection.cutter_mm();
        self.pieces.set(self.pieces.get().with_cutter(cutter_mm));
        if !self.request.repeat.cut {
            return Ok(());
        }
        let Some(cutter_mm) = cutter_mm else {
            let machine = self.setup.machine_id().to_owned();
            let able = connection.session.driver().description().can(Capability::Cut);
            return Err(LiveProblem::NoCutter { machine, driver: connection.driver_id.clone(), able }.into());
        };
        for &index in wires {
            let wire = self.wire(index)?;
            self.pieces.get().require_enough(wire)?;
            let straight = wire.compensated.iter().rev().take_while(|step| step.bend_deg == 0.0);
            let straight_mm = straight.map(|step| step.feed_mm).sum::<f64>();
            if straight_mm < -cutter_mm {
                return Err(LiveProblem::EndTooShort { wire: index, straight_mm, back_mm: -cutter_mm }.into());
            }
        }
        Ok(())
    }

    /// What a person is asked to permit before a wire.
    pub const fn permit_kind(&self) -> PermitKind {
        if self.request.repeat.cut { PermitKind::Row } else { PermitKind::Wire }
    }

    /// Cuts off the wire that has come to its end. If that fails, the report of the wire says why.
    pub fn cut_off(&self, connection: &mut Connection, row: Permit, response: &mut RunResponse) -> AfterCut {
        let mut watch = Watch::default();
        let Err(error) = cut(connection, &row, &mut watch) else {
            return if watch.was_away() { AfterCut::Asks } else { AfterCut::GoesOn(row) };
        };
        let stop = stop_of(&connection.session);
        let standstill = connection.await_standstill();
        if let Some(made) = response.wires.last_mut() {
            let error = match stop {
                Some(_) if standstill == Some(Standstill::Confirmed) => {
                    LiveProblem::Stopped { during: DURING }
                }
                Some(_) => LiveProblem::MayMove { during: DURING },
                None => error,
            };
            (made.problem, made.standstill) = (Some(ProblemReport::from(&error)), standstill);
            made.stopped_by = stop.map(|outcome| outcome.by);
        }
        AfterCut::Ends
    }
}

fn cut(connection: &mut Connection, row: &Permit, watch: &mut Watch) -> Result<(), LiveProblem> {
    connection.observer.moved();
    connection.observer.progress.stage("cutting the wire off");
    // Where it ends before its end, the tip is not where a wire begins.
    connection.wire_used = true;
    let session = &mut connection.session;
    let begun = session.cut(row);
    begun.map_err(|error| refused(session, error, DURING))?;
    connection.observer.publish(&connection.session);
    watch.look();
    while !connection.look_until_held(DURING)?.iter().any(|event| matches!(event, Event::Cut)) {
        watch.look();
    }
    watch.look();
    (connection.wire_used, connection.wire_bent) = (false, false);
    connection.observer.publish(&connection.session);
    Ok(())
}
