//! A wire made by the machine's own driver on its simulated machine: the firmware's core, and a wire that gives.

use wirebend_driver_host::api::{Capability, Event, NumberedStep};
use wirebend_driver_host::{Purpose, State};
use wirebend_files::document::Job;

use crate::drivers::{opened, work};
use crate::live::{At, Connection, Unnamed, Yes};
use crate::machine::Setup;
use crate::report::NoteReport;
use crate::simulate::KeptWire;
use crate::{App, AppError, LiveProblem, NoProgress};

/// The port of a simulated machine whose time goes as fast as it can be computed.
const PORT: &str = "sim:max";
/// How many steps are handed over at once.
const BATCH: usize = 64;

/// A simulated machine.
struct Simulator<'a> {
    connection: Connection<'a>,
    setup: &'a Setup,
}

/// What it made.
pub(crate) struct Made {
    /// Points along the middle of the wire, mm, in the frame of the turtle at its start, in the machine's signs.
    pub wire_mm: Vec<[f64; 3]>,
    /// Its ends and corners, in the same frame.
    pub corners_mm: Vec<[f64; 3]>,
}

impl<'a> Simulator<'a> {
    /// The simulated machine of a machine's driver; `None` where it has none.
    fn of(app: &App, setup: &'a Setup) -> Result<Option<Self>, AppError> {
        let profile = &setup.machine.profile;
        let driver = opened(app, profile)?;
        let can = |capability| driver.description().can(capability);
        if ![Capability::Live, Capability::Ports, Capability::Home].into_iter().all(can)
            || !driver.ports()?.iter().any(|port| port.name == PORT)
        {
            return Ok(None);
        }
        drop(driver);
        let at = At {
            profile,
            signs: setup.signs,
            port: Some(PORT),
            unnamed: Unnamed::Refuse,
            token: None,
            journal: None,
            axes_at_zero: false,
        };
        Ok(Some(Self { connection: app.connect(&at, &NoProgress)?, setup }))
    }

    /// Makes one wire of a job. What the machine did that a real one would not survive is among
    /// [`Simulator::warnings`].
    fn make(&mut self, job: &Job, wire: usize) -> Result<Option<Made>, AppError> {
        let work = work(self.setup, job, "", wire)?;
        if work.run.bench.is_none() {
            return Ok(None);
        }
        let nobody = Yes::where_nothing_moves();
        self.connection.home(&nobody)?;
        let session = &mut self.connection.session;
        let armed = session.arm(Purpose::Wire(work.run), nobody.confirmed()?).map_err(LiveProblem::from)?;
        let steps: Vec<NumberedStep> =
            (1..).zip(&work.steps).map(|(n, &step)| NumberedStep { n, step }).collect();
        let mut made = None;
        while self.connection.session.state() != State::Done {
            for event in self.connection.look("a wire was simulated")? {
                if let Event::Made { wire_mm, corners_mm } = event {
                    made = Some(Made { wire_mm, corners_mm });
                }
            }
            let session = &mut self.connection.session;
            let sent = usize::try_from(session.progress().0).unwrap_or(usize::MAX);
            let rest = steps.get(sent..).unwrap_or_default();
            if !rest.is_empty() && matches!(session.state(), State::Armed | State::Running) {
                let some = &rest[..rest.len().min(BATCH)];
                session.send(&armed, some).map_err(LiveProblem::from)?;
            }
        }
        Ok(made)
    }

    /// What the machine told on the way.
    fn warnings(&mut self) -> Vec<NoteReport> {
        std::mem::take(&mut self.connection.hearing.warnings)
    }
}

/// Every wire of a job as the simulated machine makes it; `None`, with a note that says why, where that cannot be.
pub(crate) fn on_machine(
    app: &App,
    setup: &Setup,
    job: &Job,
    notes: &mut Vec<NoteReport>,
) -> Option<Vec<Made>> {
    let mut note = |code: &'static str, message: String| {
        notes.push(NoteReport { code: code.into(), count: 1, message });
    };
    let mut simulator = match Simulator::of(app, setup) {
        Ok(Some(simulator)) => simulator,
        Ok(None) => return None,
        Err(error) => {
            note("no-simulated-machine", format!("there is no simulated machine, only formulas: {error}"));
            return None;
        }
    };
    let kept = &job.contents().wires;
    let made = (0..kept.len()).map(|wire| simulator.make(job, wire)).collect::<Result<Option<Vec<_>>, _>>();
    let warnings = simulator.warnings();
    let made = match made {
        Ok(made) => made?,
        Err(error) => {
            note(
                "machine-failed",
                format!("the simulated machine did not make it, only formulas did: {error}"),
            );
            notes.extend(warnings);
            return None;
        }
    };
    for (index, (made, wire)) in made.iter().zip(kept).enumerate() {
        let fits = KeptWire::new("", wire, setup).is_ok_and(|kept| kept.vertices(&made.corners_mm).is_some());
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
