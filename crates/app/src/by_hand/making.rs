//! Moves made one after the other, each to its end before the next.

use wirebend_driver_host::api::{Capability, Event, ReferenceBy};
use wirebend_driver_host::{Armed, Purpose, SessionError, State};
use wirebend_profile::{MachineProfile, Resolved};

use super::{Hand, JogResponse, Move};
use crate::drivers::Signs;
use crate::live::{At, Connection, Unnamed, Yes, Zero, stop_of};
use crate::run::{LeftBecause, RunProblem};
use crate::{App, AppError, LiveProblem, Progress};

/// What a person is asked before moves by hand.
pub(crate) const QUESTION: &str = "May the machine move?";
/// How many moves are told before they are made.
const TOLD: usize = 12;

/// Makes moves on a machine. What stops or fails on the way is in the answer, with the moves made before.
pub(super) fn make(
    app: &App,
    machine: &Resolved<MachineProfile>,
    hand: &Hand,
    moves: &[Move],
    more: Vec<String>,
    progress: &dyn Progress,
) -> Result<JogResponse, AppError> {
    let signs = Signs::of(&machine.figures()?);
    let at = At {
        profile: &machine.profile,
        signs,
        port: hand.port,
        unnamed: Unnamed::Simulate,
        token: None,
        journal: None,
        axes_at_zero: hand.axes_at_zero,
    };
    let mut connection = app.connect(&at, progress)?;
    require(&connection, moves)?;
    connection.settle_head(hand.head_at_deg, hand.confirmed)?;
    // It counts every move from its reference.
    let homes = connection.session.state() != State::Homed
        && moves.first() != Some(&Move::Home)
        && connection.can_home();
    let lines = lines(&connection, machine, moves, more, homes);
    let yes = Yes::ask(progress, lines, QUESTION, hand.confirmed)?;
    if homes || moves.first() == Some(&Move::Home) {
        // Before any of them is made.
        connection.ask_zero(if homes { hand.zero } else { Zero::Wire })?;
    }
    let mut made = Vec::new();
    let ended = make_all(&mut connection, signs, moves, homes, &yes, |one| {
        made.push(one);
        progress.advance(made.len() as u64, moves.len() as u64);
    });
    let left_because = match &ended {
        // What was made is made: the answer tells of it.
        Err(LiveProblem::NotConfirmed | LiveProblem::ZeroNotConfirmed) if !made.is_empty() => {
            Some(LeftBecause::NobodyAsked)
        }
        Err(LiveProblem::Declined) if !made.is_empty() => Some(LeftBecause::Declined),
        _ => None,
    };
    let (stopped, problem) = match ended {
        Ok(()) => (false, None),
        Err(error) if left_because.is_some() => (false, Some(RunProblem::from(&error))),
        Err(LiveProblem::Stopped { .. }) => (true, None),
        Err(error @ (LiveProblem::Held { .. } | LiveProblem::Unstopped { .. })) => {
            (true, Some(RunProblem::from(&error)))
        }
        Err(_) if stop_of(&connection.session).is_some() => (true, None),
        Err(LiveProblem::Fault(error)) => (false, Some(RunProblem::from(&error))),
        Err(LiveProblem::Session(error)) => (false, Some(RunProblem::from(&error))),
        Err(error) => {
            connection.await_standstill();
            return Err(error.into());
        }
    };
    let standstill = connection.await_standstill();
    Ok(JogResponse {
        machine: machine.profile.id.clone(),
        port: connection.port.clone(),
        identity: connection.session.identity().to_owned(),
        made,
        of: moves.len(),
        left_because,
        stopped,
        standstill,
        problem,
        output: None,
        notes: std::mem::take(&mut connection.hearing.warnings),
    })
}

/// Refuses moves that the machine's driver does not know at all.
pub(crate) fn require(connection: &Connection, moves: &[Move]) -> Result<(), LiveProblem> {
    let description = connection.session.driver().description();
    for (needed, capability) in [
        (moves.iter().any(|one| *one != Move::Home), Capability::Jog),
        (moves.contains(&Move::Home), Capability::Home),
    ] {
        if needed && !description.can(capability) {
            let driver = description.id.clone();
            return Err(SessionError::Unsupported { driver, capability }.into());
        }
    }
    Ok(())
}

/// What a person reads before moves are made. `more`: what else they have to know of them.
pub(crate) fn lines(
    connection: &Connection,
    machine: &Resolved<MachineProfile>,
    moves: &[Move],
    more: Vec<String>,
    homes: bool,
) -> Vec<String> {
    let name = machine.profile.name.as_deref().unwrap_or(&machine.profile.id);
    let mut lines = vec![format!("{name} at {} ({})", connection.port, connection.session.identity())];
    lines.extend(connection.why_here());
    lines.extend(more);
    if homes && connection.reference() == ReferenceBy::Machine {
        lines.push("first it searches its reference: the bend axis moves at once".to_owned());
    }
    lines.extend(connection.head_lines(homes || moves.first() == Some(&Move::Home)));
    let told: Vec<String> = moves.iter().take(TOLD).map(ToString::to_string).collect();
    let more = moves.len().saturating_sub(TOLD);
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    lines.push(format!("it makes: {}{more}", told.join(", ")));
    lines
}

/// Makes moves one after the other, and tells each that was made to its end.
pub(crate) fn make_all(
    connection: &mut Connection,
    signs: Signs,
    moves: &[Move],
    homes: bool,
    yes: &Yes,
    mut made: impl FnMut(Move),
) -> Result<(), LiveProblem> {
    if homes {
        connection.home(yes)?;
    }
    let mut armed = None;
    for &one in moves {
        make_one(connection, signs, one, &mut armed, yes)?;
        made(one);
    }
    Ok(())
}

fn make_one(
    connection: &mut Connection,
    signs: Signs,
    one: Move,
    armed: &mut Option<Armed>,
    yes: &Yes,
) -> Result<(), LiveProblem> {
    if let Move::Rotate { deg } = one {
        connection.require_turn(deg)?;
    }
    let Some(motion) = signs.motion(one) else {
        // A search for the reference ends what the machine was armed for.
        *armed = None;
        return connection.home(yes);
    };
    let token = match armed.take() {
        Some(armed) => armed,
        None => connection.session.arm(Purpose::ByHand, yes.confirmed()?)?,
    };
    connection.hearing.progress.stage(&one.to_string());
    // What was said of where the axes stand was said before this.
    connection.hearing.moved();
    connection.session.jog(&token, motion)?;
    while !connection.look_until_held("it was moved by hand")?.contains(&Event::Jogged) {}
    *armed = Some(token);
    Ok(())
}
