//! A wire bent by the machine's own driver on its simulated machine: the firmware's core, and a wire that gives.

use wirebend_driver_host::api::{Capability, Event, NumberedStep};
use wirebend_driver_host::{PermitKind, Phase};
use wirebend_files::document::Job;

use crate::live::{At, Connection, Unnamed, connect};
use crate::{LiveProblem, OperationError};
use wirebend_planning::job::{opened, work};
use wirebend_planning::machine::Setup;
use wirebend_planning::report::NoteReport;
use wirebend_planning::simulate::{KeptWire, Made, SimulateRequest, SimulateResponse, SimulatedMachine};
use wirebend_planning::{Installation, NoProgress, Progress};

/// The port of a simulated machine whose time goes as fast as it can be computed.
const PORT: &str = "sim:max";
/// How many steps are handed over at once.
const BATCH: usize = 64;

/// A simulated machine.
struct Simulator<'a> {
    connection: Connection<'a>,
    setup: &'a Setup,
}

impl<'a> Simulator<'a> {
    /// The simulated machine of a machine's driver; `None` where it has none.
    fn of(app: &Installation, setup: &'a Setup) -> Result<Option<Self>, OperationError> {
        let profile = &setup.machine.profile;
        let driver = opened(app, profile)?;
        let can = |capability| driver.description().can(capability);
        if ![Capability::Live, Capability::Ports, Capability::Home].into_iter().all(can)
            || !driver.ports()?.iter().any(|port| port.simulated && port.name == PORT)
        {
            return Ok(None);
        }
        drop(driver);
        let at = At {
            profile,
            signs: setup.signs,
            port: Some(PORT),
            unnamed: Unnamed::Refuse,
            reattached: None,
            axes_at_zero: false,
        };
        Ok(Some(Self { connection: connect(app, &at, &NoProgress)?, setup }))
    }

    /// Bends one wire of a job. What the machine did that a real one would not survive is among
    /// [`Simulator::warnings`].
    fn make(&mut self, job: &Job, wire: usize) -> Result<Option<Made>, OperationError> {
        let work = work(self.setup, job, "", wire)?;
        if work.run.bench.is_none() {
            return Ok(None);
        }
        let Some(simulation) = self.connection.session.simulated() else { return Ok(None) };
        let permit = simulation.permit(PermitKind::Wire);
        self.connection.home(&permit)?;
        let armed = self.connection.session.arm(work.run, permit).map_err(LiveProblem::from)?;
        let steps: Vec<NumberedStep> =
            (1..).zip(&work.steps).map(|(n, &step)| NumberedStep { n, step }).collect();
        let mut made = None;
        while !self.connection.session.is_done() {
            for event in self.connection.look("a wire was simulated")? {
                if let Event::Made { wire_mm, corners_mm } = event {
                    made = Some(Made { wire_mm, corners_mm });
                }
            }
            let session = &mut self.connection.session;
            let sent = usize::try_from(session.progress().0).unwrap_or(usize::MAX);
            let rest = steps.get(sent..).unwrap_or_default();
            if !rest.is_empty() && matches!(session.phase(), Phase::Armed | Phase::Making) {
                let some = &rest[..rest.len().min(BATCH)];
                session.send(&armed, some).map_err(LiveProblem::from)?;
            }
        }
        Ok(made)
    }

    /// What the machine reported on the way.
    fn warnings(&mut self) -> Vec<NoteReport> {
        std::mem::take(&mut self.connection.observer.warnings)
    }
}

/// The simulated machine that each machine's driver has.
pub struct OfDriver<'a>(pub &'a Installation);

impl SimulatedMachine for OfDriver<'_> {
    fn bend(&self, setup: &Setup, job: &Job, notes: &mut Vec<NoteReport>) -> Option<Vec<Made>> {
        let mut note = |code: &'static str, message: String| {
            notes.push(NoteReport { code: code.into(), count: 1, message, remedies: Vec::new() });
        };
        let mut simulator = match Simulator::of(self.0, setup) {
            Ok(Some(simulator)) => simulator,
            Ok(None) => return None,
            Err(error) => {
                note(
                    "no-simulated-machine",
                    format!("there is no simulated machine, only formulas: {error}"),
                );
                return None;
            }
        };
        let kept = &job.contents().wires;
        let made =
            (0..kept.len()).map(|wire| simulator.make(job, wire)).collect::<Result<Option<Vec<_>>, _>>();
        let warnings = simulator.warnings();
        let made = match made {
            Ok(made) => made?,
            Err(error) => {
                note(
                    "machine-failed",
                    format!("it was not bent on the simulated machine, only calculated: {error}"),
                );
                notes.extend(warnings);
                return None;
            }
        };
        for (index, (made, wire)) in made.iter().zip(kept).enumerate() {
            let fits =
                KeptWire::new("", wire, setup).is_ok_and(|kept| kept.vertices(&made.corners_mm).is_some());
            if !fits {
                let corners = made.corners_mm.len();
                note(
                    "other-corners",
                    format!(
                        "wire {} has {corners} ends and corners on the simulated machine, which are not those of the design: it has figures of formulas alone",
                        index + 1
                    ),
                );
            }
        }
        notes.extend(warnings);
        Some(made)
    }
}

/// Bends a job without a machine: on the one that its driver simulates where there is one, and by formulas.
pub fn simulate(
    installation: &Installation,
    request: &SimulateRequest,
    progress: &dyn Progress,
) -> Result<SimulateResponse, OperationError> {
    Ok(wirebend_planning::simulate::simulate(installation, request, &OfDriver(installation), progress)?)
}
