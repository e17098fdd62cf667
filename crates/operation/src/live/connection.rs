//! A machine that has answered: looked at, set, homed.

use wirebend_driver_host::api::{Capability, Event, Limits, ReferenceBy, Step};
use wirebend_driver_host::{Permit, Phase, Session, StopLine};

use super::observer::MachineObserver;
use super::person::Zero;
use super::refused::{PAUSE, refused, stop_of};
use crate::MachineEvent;
use crate::error::LiveProblem;
use wirebend_planning::DriverProblem;
use wirebend_planning::installation::Board;

/// A machine that has answered, and who observes it.
pub struct Connection<'a> {
    pub session: Session,
    pub observer: MachineObserver<'a>,
    pub port: String,
    /// The program's own way to the port. As long as a copy is kept, the port is not closed for good, and a board at it
    /// is not reset when it is opened again.
    pub line: Option<StopLine>,
    /// No port was named: it is the simulated machine's.
    pub unnamed: bool,
    pub driver_id: String,
    pub driver_version: String,
    /// What its driver takes.
    pub driver_limits: Limits,
    /// How far the profile lets the bend axis go to each side of zero, degrees, where a move of it begins there.
    pub bend_reach_deg: Option<f64>,
    /// Wire was fed or bent by hand through this connection since a person has last said that the wire is in.
    pub wire_used: bool,
    /// A wire was bent through this connection, whole or in part, since then. Where it was cut off it is not in the way.
    pub wire_bent: bool,
}

impl<'a> Connection<'a> {
    /// For a user who has named no port.
    pub fn why_here(&self) -> Option<String> {
        let what = "it is the simulated machine, since no port was named";
        self.unnamed.then(|| what.to_owned())
    }

    /// Whether the machine can be homed: it homes with switches, or a person has brought the axes to zero.
    pub fn can_home(&self) -> bool {
        self.session.driver().description().can(Capability::Home)
    }

    /// Looks once what there is, and waits a moment where there is nothing.
    pub fn look(&mut self, during: &'static str) -> Result<Vec<Event>, LiveProblem> {
        look(&mut self.session, &mut self.observer, during)
    }

    /// The same for a machine that is moved by hand, and stops it where it holds in that.
    pub fn look_until_held(&mut self, during: &'static str) -> Result<Vec<Event>, LiveProblem> {
        look_until_held(&mut self.session, &mut self.observer, during)
    }

    /// The same while the answer to a typed line is awaited, from a machine that may have been stopped before.
    pub fn look_for_answer(&mut self, stopped_before: bool) -> Result<Vec<Event>, LiveProblem> {
        let during = "a typed line was carried out";
        if stopped_before && self.session.phase() == Phase::Stopped {
            return heard(&mut self.session, &mut self.observer, during);
        }
        self.look_until_held(during)
    }

    /// The same for a machine of which nothing was ordered. That it was stopped before is known.
    pub fn look_at_rest(&mut self) -> Result<(), LiveProblem> {
        let stopped = matches!(self.session.phase(), Phase::Stopping | Phase::Stopped);
        match self.look("it was at rest") {
            Err(LiveProblem::Stopped { .. }) if stopped && self.session.last_stop().is_none() => Ok(()),
            looked => looked.map(drop),
        }
    }

    /// Refuses a machine that is set otherwise than its profile says, unless a person wants it so.
    pub fn require_settings(&self, machine: &str, accept: bool) -> Result<(), LiveProblem> {
        // Those that were accepted for a wire before, too: each needs a confirmation of its own.
        let settings: Vec<_> = self.observer.settings.iter().filter(|one| one.matters).cloned().collect();
        if settings.is_empty() || accept {
            return Ok(());
        }
        let writable = self.session.driver().description().can(Capability::Settings);
        let (machine, port) = (machine.to_owned(), self.port.clone());
        Err(LiveProblem::SettingsDiffer { machine, port, settings, writable })
    }

    /// Where the machine's cutter is, mm, if it has one that its driver knows to use.
    pub fn cutter_mm(&self) -> Option<f64> {
        self.driver_limits.cutter_mm.filter(|_| self.session.driver().description().can(Capability::Cut))
    }

    /// The machine, as it says itself.
    pub fn board(&self) -> Board {
        Board { port: self.port.clone(), limits: self.session.machine_limits().clone() }
    }

    /// Refuses a wire with a step that the driver or the machine would refuse in its middle, or bend to the wrong side; those before `from` are done.
    pub fn require_within(&self, wire: usize, steps: &[Step], from: u32) -> Result<(), DriverProblem> {
        DriverProblem::require_within(&self.driver_limits, "its driver", wire, steps, from)?;
        DriverProblem::require_within(self.session.machine_limits(), "the machine", wire, steps, from)?;
        let ahead = (1..).zip(steps).filter(|(n, _)| *n >= from);
        ahead
            .map(|(n, step)| (format!("step {n} of wire {}", wire + 1), step))
            .try_for_each(|(at, step)| self.session.takes(&at, step).map_err(DriverProblem::Host))
    }

    /// Writes the profile's settings to the machine, for good, and waits until it has reported the result.
    pub fn write_settings(&mut self, permit: Permit) -> Result<(), LiveProblem> {
        self.observer.progress.stage("writing settings");
        self.session.write_settings(permit)?;
        let written = |event: &Event| matches!(event, Event::SettingsWritten { .. });
        while !heard(&mut self.session, &mut self.observer, "its settings were written")?.iter().any(written)
        {
        }
        Ok(())
    }

    /// Lends the session to the loop that runs a wire. The connection is lost where that does not give it back.
    pub fn through<T>(
        mut self,
        make: impl FnOnce(Session, &mut MachineObserver<'a>) -> (Option<Session>, T),
    ) -> (Option<Self>, T) {
        let (session, made) = make(self.session, &mut self.observer);
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
            self.observer.said_zero(&self.session, wanted)?;
            self.zero_was_said(wanted)?;
        }
        Ok(())
    }

    /// The same where they were asked otherwise.
    pub fn zero_was_said(&mut self, wanted: Zero) -> Result<(), LiveProblem> {
        (self.observer.at_zero, self.observer.zero_for) = (true, wanted);
        if wanted == Zero::Wire {
            // Its head is one of the axes.
            self.session.head_stands_at(0.0)?;
        }
        Ok(())
    }

    /// Lets the machine find its reference.
    pub fn home(&mut self, permit: &Permit) -> Result<(), LiveProblem> {
        home(&mut self.session, &mut self.observer, permit)
    }
}

/// Looks once what there is, and waits a moment where there is nothing.
fn look(
    session: &mut Session,
    observer: &mut MachineObserver,
    during: &'static str,
) -> Result<Vec<Event>, LiveProblem> {
    let events = heard(session, observer, during)?;
    if matches!(session.phase(), Phase::Stopping | Phase::Stopped) {
        return Err(LiveProblem::Stopped { during });
    }
    Ok(events)
}

/// The same for a machine that may have been stopped before.
fn heard(
    session: &mut Session,
    observer: &mut MachineObserver,
    during: &'static str,
) -> Result<Vec<Event>, LiveProblem> {
    let polled = session.poll();
    observer.publish(session);
    if session.last_stop().is_some() || (polled.is_err() && stop_of(session).is_some()) {
        return Err(LiveProblem::Stopped { during });
    }
    let events = polled?;
    for event in &events {
        observer.hear(event);
        if let Event::Fault { error, .. } = event {
            return Err(LiveProblem::Fault(wirebend_driver_host::report_of(error)));
        }
    }
    if events.is_empty() {
        std::thread::sleep(PAUSE);
    }
    Ok(events)
}

/// Lets the machine find its reference.
pub fn home(
    session: &mut Session,
    observer: &mut MachineObserver,
    permit: &Permit,
) -> Result<(), LiveProblem> {
    let mut wanted = Zero::Wire;
    match session.reference() {
        ReferenceBy::Machine => {
            observer.progress.stage("homing");
            observer.progress.event(&MachineEvent::Homing);
            tracing::info!("homing");
        }
        ReferenceBy::Person => {
            // What was asked before is what it was said for.
            wanted = if observer.at_zero { observer.zero_for } else { Zero::Wire };
            observer.said_zero(session, wanted)?;
            observer.progress.stage("setting zero");
            tracing::info!("a person has said that every axis stands at zero");
        }
    }
    let homing = session.home(permit);
    homing.map_err(|error| refused(session, error, "it was about to home"))?;
    observer.publish(session);
    // The driver knows how long homing may take.
    while session.phase() != Phase::Ready {
        look_until_held(session, observer, "it was homing")?;
    }
    if session.reference() == ReferenceBy::Person && wanted == Zero::Wire {
        session.head_is_zeroed()?;
    }
    Ok(())
}

/// The same as [`look`], for a move by hand. A hold ends that: the user is not asked to resume the rest of one, which they
/// order again once they have looked.
fn look_until_held(
    session: &mut Session,
    observer: &mut MachineObserver,
    during: &'static str,
) -> Result<Vec<Event>, LiveProblem> {
    let events = look(session, observer, during)?;
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
