//! From a machine's profile and a port to a machine that has answered.

use std::path::Path;
use std::time::{Duration, Instant};

use wirebend_driver_host::api::Capability;
use wirebend_driver_host::{OpenDriver, Phase, Session, Standstill, StopLine};
use wirebend_error::{ErrorCode, ProblemReport};
use wirebend_profile::{BendMethod, MachineProfile};

use super::connection::Connection;
use super::observer::MachineObserver;
use super::person::Zero;
use super::settle_head::know_head;
use super::under_way::wait_until_it_stands;
use crate::FrontEnd;
use crate::OperationError;
use crate::error::LiveProblem;
use wirebend_planning::Installation;
use wirebend_planning::job::opened;
use wirebend_planning::signs::Signs;

/// Longer no machine takes to answer: a board that starts needs a few seconds.
const PATIENCE: Duration = Duration::from_mins(1);

/// A machine at a port.
pub struct At<'a> {
    pub profile: &'a MachineProfile,
    pub signs: Signs,
    pub port: Option<&'a str>,
    /// What to do where no port is named.
    pub unnamed: Unnamed<'a>,
    /// The interrupted wire that is resumed.
    pub reattached: Option<Reattached<'a>>,
    /// A person has said already that every axis stands at zero, for machines whose axes they bring there.
    pub axes_at_zero: bool,
}

/// An interrupted wire that the caller resumes.
pub struct Reattached<'a> {
    /// The token of its arming, with which a machine that still is in it takes the program in.
    pub token: Option<&'a str>,
    pub journal: &'a Path,
}

/// What to do where no port is named.
#[derive(Clone, Copy)]
pub enum Unnamed<'a> {
    /// A person has to name one.
    Refuse,
    /// The machine that the driver simulates is taken, if it has one.
    Simulate,
    /// The same where the wire was begun on it: a wire of a real machine is not finished by another.
    SimulateAgain(&'a str),
}

/// Opens a port and waits for the machine's answer. Nothing moves for it.
pub fn connect<'a>(
    installation: &Installation,
    at: &At,
    progress: &'a dyn FrontEnd,
) -> Result<Connection<'a>, OperationError> {
    progress.stage("starting the driver");
    let driver = opened(installation, at.profile)?;
    let (driver_id, driver_version) = (driver.description().id.clone(), driver.description().version.clone());
    if !driver.description().can(Capability::Live) {
        let machine = at.profile.id.clone();
        return Err(LiveProblem::FilesOnly { machine, driver: driver_id }.into());
    }
    let port = match at.port {
        Some(port) => port.to_owned(),
        None => port_of_simulated(&driver, at.unnamed)?,
    };
    wait_until_it_stands(installation, &port, at.reattached.as_ref().map(|wire| wire.journal), progress)?;
    let bytes = at.profile.driver.stop_bytes.clone().unwrap_or_default();
    let reply = at.profile.driver.stop_reply.clone().unwrap_or_default();
    // The driver reports more exactly what is wrong with a port.
    let line =
        StopLine::open(&port, &bytes, &reply).inspect_err(|error| tracing::warn!("{error}")).unwrap_or(None);
    let limits = driver.limits();
    progress.stage("connecting");
    let session = match at.reattached.as_ref().and_then(|wire| wire.token) {
        Some(token) => Session::connect_resuming(driver, &port, token, line.clone()),
        None => Session::connect(driver, &port, line.clone()),
    };
    let session = session.map_err(LiveProblem::from)?;
    progress.connected(&session.stop_handle());
    tracing::info!("connected to {port}, which has not answered yet");
    let mut observer = MachineObserver {
        progress,
        signs: at.signs,
        warnings: Vec::new(),
        settings: Vec::new(),
        at_zero: at.axes_at_zero,
        zero_for: Zero::Wire,
        head: None,
        board: None,
    };
    let driver_limits = limits
        .inspect_err(|error| {
            let message = format!("its driver does not report its limits: {error}");
            observer.warn(ProblemReport::new(ErrorCode::DriverLimitsUnknown, message, error.remedies()));
        })
        .unwrap_or_default();
    let unnamed = at.port.is_none();
    let (wire_used, wire_bent) = (false, false);
    let mut connection = Connection {
        session,
        observer,
        port,
        line,
        unnamed,
        driver_id,
        driver_version,
        driver_limits,
        bend_reach_deg: bend_reach_deg(at.profile),
        wire_used,
        wire_bent,
    };
    if let Err(error) = await_answer(&mut connection) {
        // Whatever was under way there when it was connected.
        return Err(match connection.await_standstill() {
            Some(Standstill::NotConfirmed) => LiveProblem::MayMove { during: "it was connected" },
            _ => error,
        }
        .into());
    }
    // It is asked once, before anything of it is reported. A simulated machine says nothing of one that is there.
    if connection.session.simulated().is_none() {
        connection.observer.board = Some(installation.boards.met(&at.profile.id, connection.board()));
    }
    know_head(installation.runs.as_deref(), at.profile, &mut connection);
    Ok(connection)
}

fn port_of_simulated(driver: &OpenDriver, unnamed: Unnamed) -> Result<String, OperationError> {
    let listed = if driver.description().can(Capability::Ports) { driver.ports()? } else { Vec::new() };
    let simulated = listed.iter().find(|port| match unnamed {
        Unnamed::Refuse => false,
        Unnamed::Simulate => port.simulated,
        Unnamed::SimulateAgain(begun_at) => port.simulated && port.name == begun_at,
    });
    if let Some(port) = simulated {
        return Ok(port.name.clone());
    }
    Err(LiveProblem::NoPort { known: listed.into_iter().map(|port| port.name).collect() }.into())
}

fn await_answer(connection: &mut Connection) -> Result<(), LiveProblem> {
    let begun = Instant::now();
    while connection.session.phase() == Phase::Connecting {
        connection.look("it was connected")?;
        if begun.elapsed() > PATIENCE {
            return Err(LiveProblem::NoAnswer { port: connection.port.clone(), seconds: PATIENCE.as_secs() });
        }
    }
    Ok(())
}

/// Where a peg comes out beside the wire each bend begins at zero; an axis that is moved by hand from anywhere counts for itself.
fn bend_reach_deg(profile: &MachineProfile) -> Option<f64> {
    let has_peg = profile.bend.method.as_ref().is_some_and(|method| method.value == BendMethod::Peg);
    let reach = profile.bend.axis_limit_deg.as_ref().map(|reach| reach.value);
    reach.filter(|_| has_peg)
}
