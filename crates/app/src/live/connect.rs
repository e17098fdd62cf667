//! From a machine's profile and a port to a machine that has answered.

use std::path::Path;
use std::time::{Duration, Instant};

use wirebend_driver_host::api::{Capability, Event, Limits, ReferenceBy, Step};
use wirebend_driver_host::{OpenDriver, Session, Standstill, State, StopLine, StopOutcome};
use wirebend_profile::MachineProfile;

use super::LiveProblem;
use super::hearing::Hearing;
use super::person::{Yes, Zero};
use super::under_way::wait_until_it_stands;
use crate::drivers::{Board, Signs, opened};
use crate::{App, AppError, DriverProblem, News, Progress};

/// Longer no machine takes to answer: a board that starts needs a few seconds.
const PATIENCE: Duration = Duration::from_mins(1);
/// A driver that does not pass a stop on is ended within a part of this.
const STOPPING: Duration = Duration::from_millis(300);
/// Between two looks at a machine that had nothing to tell.
pub(crate) const PAUSE: Duration = Duration::from_millis(10);

/// A machine at a port.
pub(crate) struct At<'a> {
    pub profile: &'a MachineProfile,
    pub signs: Signs,
    pub port: Option<&'a str>,
    /// What to do where no port is named.
    pub unnamed: Unnamed<'a>,
    /// The token of an earlier arming.
    pub token: Option<&'a str>,
    /// The journal of a wire that is gone on with, which the caller has taken up.
    pub journal: Option<&'a Path>,
    /// A person has said already that every axis stands at zero, for machines whose axes they bring there.
    pub axes_at_zero: bool,
}

/// What to do where no port is named.
#[derive(Clone, Copy)]
pub(crate) enum Unnamed<'a> {
    /// A person has to name one.
    Refuse,
    /// The machine that the driver simulates is taken, if it has one.
    Simulate,
    /// The same where the wire was begun on it: a wire of a real machine is not finished by another.
    SimulateAgain(&'a str),
}

/// A machine that has answered, and who hears of it.
pub(crate) struct Connection<'a> {
    pub session: Session,
    pub hearing: Hearing<'a>,
    pub port: String,
    /// The program's own way to the port. As long as a copy is kept, the port is not closed for good, and a board at it
    /// is not reset when it is opened again.
    pub line: Option<StopLine>,
    /// Nobody has named the port: it is the simulated machine's.
    pub unnamed: bool,
    pub driver_id: String,
    pub driver_version: String,
    /// What its driver takes.
    pub driver_limits: Limits,
    /// Wire was fed or bent by hand through this connection since a person has last said that the wire is in.
    pub wire_used: bool,
}

impl App {
    /// Opens a port and waits for the machine's answer. Nothing moves for it.
    pub(crate) fn connect<'a>(
        &self,
        at: &At,
        progress: &'a dyn Progress,
    ) -> Result<Connection<'a>, AppError> {
        progress.stage("starting the driver");
        let driver = opened(self, at.profile)?;
        let (driver_id, driver_version) =
            (driver.description().id.clone(), driver.description().version.clone());
        if !driver.description().can(Capability::Live) {
            let machine = at.profile.id.clone();
            return Err(LiveProblem::FilesOnly { machine, driver: driver_id }.into());
        }
        let port = match at.port {
            Some(port) => port.to_owned(),
            None => port_of_simulated(&driver, at.unnamed)?,
        };
        wait_until_it_stands(self, &port, at.journal, progress)?;
        let bytes = at.profile.driver.stop_bytes.clone().unwrap_or_default();
        let reply = at.profile.driver.stop_reply.clone().unwrap_or_default();
        // The driver tells better what is wrong with a port.
        let line = StopLine::open(&port, &bytes, &reply)
            .inspect_err(|error| tracing::warn!("{error}"))
            .unwrap_or(None);
        let limits = driver.limits();
        progress.stage("connecting");
        let session = match at.token {
            Some(token) => Session::connect_resuming(driver, &port, token, line.clone()),
            None => Session::connect(driver, &port, line.clone()),
        };
        let session = session.map_err(LiveProblem::from)?;
        progress.connected(&session.stop_handle());
        tracing::info!("connected to {port}, which has not answered yet");
        let mut hearing = Hearing {
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
                hearing
                    .warn("driver-limits-unknown", &format!("its driver does not tell its limits: {error}"));
            })
            .unwrap_or_default();
        let unnamed = at.port.is_none();
        let wire_used = false;
        let mut connection = Connection {
            session,
            hearing,
            port,
            line,
            unnamed,
            driver_id,
            driver_version,
            driver_limits,
            wire_used,
        };
        if let Err(error) = connection.await_answer() {
            // Whatever was under way there when it was connected.
            return Err(match connection.await_standstill() {
                Some(Standstill::NotConfirmed) => LiveProblem::MayMove { during: "it was connected" },
                _ => error,
            }
            .into());
        }
        connection.hearing.board = Some(self.boards.met(&at.profile.id, connection.board()));
        self.know_head(at.profile, &mut connection);
        Ok(connection)
    }
}

fn port_of_simulated(driver: &OpenDriver, unnamed: Unnamed) -> Result<String, AppError> {
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

impl<'a> Connection<'a> {
    /// For whoever has named no port.
    pub fn why_here(&self) -> Option<String> {
        let what =
            "it is the simulated machine, since no port was named: `wirebend ports` tells where others are";
        self.unnamed.then(|| what.to_owned())
    }

    /// Whether the machine can be homed: it searches its reference, or a person has brought the axes there.
    pub fn can_home(&self) -> bool {
        self.session.driver().description().can(Capability::Home)
    }

    fn await_answer(&mut self) -> Result<(), LiveProblem> {
        let begun = Instant::now();
        while self.session.state() == State::Disconnected {
            self.look("it was connected")?;
            if begun.elapsed() > PATIENCE {
                return Err(LiveProblem::NoAnswer { port: self.port.clone(), seconds: PATIENCE.as_secs() });
            }
        }
        Ok(())
    }

    /// Looks once what there is, and waits a moment where there is nothing.
    pub fn look(&mut self, during: &'static str) -> Result<Vec<Event>, LiveProblem> {
        look(&mut self.session, &mut self.hearing, during)
    }

    /// The same for a machine that is moved by hand, and stops it where it holds in that.
    pub fn look_until_held(&mut self, during: &'static str) -> Result<Vec<Event>, LiveProblem> {
        look_until_held(&mut self.session, &mut self.hearing, during)
    }

    /// The same for a machine of which nothing was ordered. That it was stopped before is known.
    pub fn look_at_rest(&mut self) -> Result<(), LiveProblem> {
        let stopped = matches!(self.session.state(), State::Stopping | State::Stopped);
        match self.look("it was at rest") {
            Err(LiveProblem::Stopped { .. }) if stopped && self.session.last_stop().is_none() => Ok(()),
            looked => looked.map(drop),
        }
    }

    /// Refuses a machine that is set otherwise than its profile says, unless a person wants it so.
    pub fn require_settings(&self, machine: &str, accept: bool) -> Result<(), LiveProblem> {
        // Those that were accepted for a wire before, too: each is made at a word of its own.
        let settings: Vec<_> = self.hearing.settings.iter().filter(|one| one.matters).cloned().collect();
        if settings.is_empty() || accept {
            return Ok(());
        }
        let writable = self.session.driver().description().can(Capability::Settings);
        let (machine, port) = (machine.to_owned(), self.port.clone());
        Err(LiveProblem::SettingsDiffer { machine, port, settings, writable })
    }

    /// The machine, as it says itself.
    pub fn board(&self) -> Board {
        Board { port: self.port.clone(), limits: self.session.machine_limits().clone() }
    }

    /// Refuses a wire with a step that the driver or the machine would refuse in its middle; those before `from` are made.
    pub fn require_within(&self, wire: usize, steps: &[Step], from: u32) -> Result<(), DriverProblem> {
        DriverProblem::require_within(&self.driver_limits, "its driver", wire, steps, from)?;
        DriverProblem::require_within(self.session.machine_limits(), "the machine", wire, steps, from)
    }

    /// Writes the profile's settings to the machine, for good, and waits until it has told what came of it.
    pub fn write_settings(&mut self, yes: &Yes) -> Result<(), LiveProblem> {
        self.hearing.progress.stage("writing settings");
        self.session.write_settings(&yes.confirmed()?)?;
        let written = |event: &Event| matches!(event, Event::SettingsWritten { .. });
        while !heard(&mut self.session, &mut self.hearing, "its settings were written")?.iter().any(written) {
        }
        Ok(())
    }

    /// Lends the session to what makes a wire. The connection is lost where that does not give it back.
    pub fn through<T>(
        mut self,
        make: impl FnOnce(Session, &mut Hearing<'a>) -> (Option<Session>, T),
    ) -> (Option<Self>, T) {
        let (session, made) = make(self.session, &mut self.hearing);
        (session.map(|session| Self { session, ..self }), made)
    }

    /// Who brings the axes to their reference, where the machine can be homed.
    pub fn reference(&self) -> ReferenceBy {
        self.session.reference()
    }

    /// Asks whether every axis stands at zero, where a person brings them there and has not said it yet. The next homing
    /// does not ask again.
    pub fn ask_zero(&mut self, wanted: Zero) -> Result<(), LiveProblem> {
        let by_hand = self.reference() == ReferenceBy::Person;
        if by_hand {
            self.hearing.said_zero(&self.session, wanted)?;
            self.zero_was_said(wanted)?;
        }
        Ok(())
    }

    /// The same where they were asked otherwise.
    pub fn zero_was_said(&mut self, wanted: Zero) -> Result<(), LiveProblem> {
        (self.hearing.at_zero, self.hearing.zero_for) = (true, wanted);
        if wanted == Zero::Wire {
            // Its head is one of the axes.
            self.session.head_stands_at(0.0, &Yes::where_nothing_moves().confirmed()?)?;
        }
        Ok(())
    }

    /// Lets the machine find its reference.
    pub fn home(&mut self, yes: &Yes) -> Result<(), LiveProblem> {
        home(&mut self.session, &mut self.hearing, yes)
    }
}

/// How a stop went, if there was one. A stop is on its way before it is noted how it went: what else fails meanwhile
/// is its doing.
pub(crate) fn stop_of(session: &Session) -> Option<StopOutcome> {
    let begun = Instant::now();
    while session.last_stop().is_none() && begun.elapsed() < STOPPING {
        std::thread::sleep(PAUSE);
    }
    session.last_stop()
}

/// Looks once what there is, and waits a moment where there is nothing.
fn look(
    session: &mut Session,
    hearing: &mut Hearing,
    during: &'static str,
) -> Result<Vec<Event>, LiveProblem> {
    let events = heard(session, hearing, during)?;
    if matches!(session.state(), State::Stopping | State::Stopped) {
        return Err(LiveProblem::Stopped { during });
    }
    Ok(events)
}

/// The same for a machine that may have been stopped before.
fn heard(
    session: &mut Session,
    hearing: &mut Hearing,
    during: &'static str,
) -> Result<Vec<Event>, LiveProblem> {
    let polled = session.poll();
    if session.last_stop().is_some() || (polled.is_err() && stop_of(session).is_some()) {
        return Err(LiveProblem::Stopped { during });
    }
    let events = polled?;
    for event in &events {
        hearing.hear(event);
        if let Event::Fault { error, .. } = event {
            return Err(LiveProblem::Fault(error.clone()));
        }
    }
    if events.is_empty() {
        std::thread::sleep(PAUSE);
    }
    Ok(events)
}

/// Lets the machine find its reference.
pub(crate) fn home(session: &mut Session, hearing: &mut Hearing, yes: &Yes) -> Result<(), LiveProblem> {
    let mut wanted = Zero::Wire;
    match session.reference() {
        ReferenceBy::Machine => {
            hearing.progress.stage("homing");
            hearing.progress.news(&News::Homing);
            tracing::info!("homing");
        }
        ReferenceBy::Person => {
            // What was asked before is what it was said for.
            wanted = if hearing.at_zero { hearing.zero_for } else { Zero::Wire };
            hearing.said_zero(session, wanted)?;
            hearing.progress.stage("setting zero");
            tracing::info!("a person has said that every axis stands at zero");
        }
    }
    let homing = session.home(&yes.confirmed()?);
    if homing.is_err() && stop_of(session).is_some() {
        return Err(LiveProblem::Stopped { during: "it was to search its reference" });
    }
    homing?;
    // How long it may search the driver knows.
    while session.state() != State::Homed {
        look_until_held(session, hearing, "it searched its reference")?;
    }
    if session.reference() == ReferenceBy::Person && wanted == Zero::Wire {
        session.head_is_zeroed(&yes.confirmed()?)?;
    }
    Ok(())
}

/// The same as [`look`], for a move by hand. A hold ends that: nobody is asked to go on with the rest of one, which a person
/// orders anew once they have looked.
fn look_until_held(
    session: &mut Session,
    hearing: &mut Hearing,
    during: &'static str,
) -> Result<Vec<Event>, LiveProblem> {
    let events = look(session, hearing, during)?;
    let held = events.iter().find_map(|event| match event {
        Event::Paused { by } => Some(*by),
        _ => None,
    });
    let Some(by) = held else { return Ok(events) };
    let stop = session.stop();
    if stop.driver_ended {
        return Err(LiveProblem::Unstopped { during, by: stop.by });
    }
    Err(LiveProblem::Held { during, by })
}
