//! Moves run one after the other, each to its end before the next.

use wirebend_driver_host::api::{Axis, Capability, Event, Motion, ReferenceBy};
use wirebend_driver_host::{Armed, Permit, PermitKind, Phase, SessionError};
use wirebend_error::ProblemReport;
use wirebend_profile::{MachineProfile, Resolved};

use super::dry_run::DryRun;
use super::{Hand, JogResponse};
use crate::FrontEnd;
use crate::live::{At, Connection, Unnamed, Zero, ask_permit, connect, stop_of};
use crate::order::Move;
use crate::run::LeftBecause;
use crate::{LiveProblem, OperationError};
use wirebend_planning::Installation;
use wirebend_planning::signs::Signs;

/// What a person is asked before moves by hand.
pub const QUESTION: &str = "May the machine move?";
/// How many moves are listed before they run.
const TOLD: usize = 12;

/// Moves that run one after the other, in canonical signs.
pub struct MoveRow<'a> {
    pub moves: &'a [Move],
    /// What else a person has to know of them.
    pub notes: Vec<String>,
    /// The wire whose moves they are, in a dry run.
    pub dry: Option<DryRun<'a>>,
}

impl MoveRow<'_> {
    fn begins_with_homing(&self) -> bool {
        self.moves.first() == Some(&Move::Home)
    }

    /// What a person is asked before they run.
    pub fn question(&self) -> &'static str {
        if self.dry.is_some() { "Has the wire been removed, and may the machine move?" } else { QUESTION }
    }
}

/// Runs moves on a machine. What stops or fails on the way is in the answer, with the moves done before.
pub(super) fn make(
    app: &Installation,
    machine: &Resolved<MachineProfile>,
    hand: &Hand,
    row: &MoveRow,
    progress: &dyn FrontEnd,
) -> Result<JogResponse, OperationError> {
    let signs = Signs::of(&machine.figures()?);
    let at = At {
        profile: &machine.profile,
        signs,
        port: hand.port,
        unnamed: Unnamed::Simulate,
        reattached: None,
        axes_at_zero: hand.answers.axes_at_zero,
    };
    let mut connection = connect(app, &at, progress)?;
    require(&connection, row)?;
    connection.settle_head(hand.answers.head_at_deg, hand.answers.confirmed)?;
    // It counts every move from its reference.
    let homes =
        connection.session.phase() != Phase::Ready && !row.begins_with_homing() && connection.can_home();
    let lines = lines(&connection, machine, row, homes);
    let kind = PermitKind::ByHand;
    let confirmed = hand.answers.confirmed;
    let permit = ask_permit(&mut connection.session, progress, kind, lines, row.question(), confirmed)?;
    if homes || row.begins_with_homing() {
        // Before any of them runs.
        connection.ask_zero(if homes { hand.zero } else { Zero::Wire })?;
    }
    let mut made = Vec::new();
    let ended = make_all(&mut connection, signs, row, homes, &permit, |told| {
        if let MoveProgress::Made(one) = told {
            made.push(one);
            progress.advance(made.len() as u64, row.moves.len() as u64);
        }
    });
    let left_because = match &ended {
        // Moves that are done stay done: the answer lists them.
        Err(LiveProblem::NotConfirmed | LiveProblem::ZeroNotConfirmed) if !made.is_empty() => {
            Some(LeftBecause::NobodyAsked)
        }
        Err(LiveProblem::Declined) if !made.is_empty() => Some(LeftBecause::Declined),
        _ => None,
    };
    let (stopped, problem) = match ended {
        Ok(()) => (false, None),
        Err(error) if left_because.is_some() => (false, Some(ProblemReport::from(&error))),
        Err(LiveProblem::Stopped { .. }) => (true, None),
        Err(error @ (LiveProblem::Held { .. } | LiveProblem::Unstopped { .. })) => {
            (true, Some(ProblemReport::from(&error)))
        }
        Err(_) if stop_of(&connection.session).is_some() => (true, None),
        Err(LiveProblem::Fault(report)) => (false, Some(report)),
        Err(LiveProblem::Session(error)) => (false, Some(ProblemReport::from(&error))),
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
        of: row.moves.len(),
        left_because,
        stopped,
        standstill,
        problem,
        output: None,
        notes: std::mem::take(&mut connection.observer.warnings),
    })
}

/// Refuses moves that the machine's driver does not know at all, and those of a wire that the machine cannot make.
pub fn require(connection: &Connection, row: &MoveRow) -> Result<(), OperationError> {
    let description = connection.session.driver().description();
    for (needed, capability) in [
        (row.moves.iter().any(|one| *one != Move::Home), Capability::Jog),
        (row.moves.contains(&Move::Home), Capability::Home),
        (row.dry.is_some(), Capability::DryRun),
    ] {
        if needed && !description.can(capability) {
            let driver = description.id.clone();
            return Err(LiveProblem::from(SessionError::Unsupported { driver, capability }).into());
        }
    }
    for one in row.moves {
        if let (&Move::Bend { deg }, Some(reach)) = (one, connection.bend_reach_deg)
            && row.dry.is_none()
            && deg.abs() > reach
        {
            return Err(LiveProblem::BendTooFar { deg, reach }.into());
        }
    }
    row.dry.as_ref().map_or(Ok(()), |dry| dry.require_within(connection))
}

/// What the user reads before moves run.
pub fn lines(
    connection: &Connection,
    machine: &Resolved<MachineProfile>,
    row: &MoveRow,
    homes: bool,
) -> Vec<String> {
    let name = machine.profile.name.as_deref().unwrap_or(&machine.profile.id);
    let mut lines = vec![format!("{name} at {} ({})", connection.port, connection.session.identity())];
    lines.extend(connection.why_here());
    lines.extend(row.notes.iter().cloned());
    if homes && connection.reference() == ReferenceBy::Machine {
        lines.push("first it homes: the bend axis moves at once".to_owned());
    }
    lines.extend(connection.head_lines(homes || row.begins_with_homing()));
    let told: Vec<String> = row.moves.iter().take(TOLD).map(ToString::to_string).collect();
    let more = row.moves.len().saturating_sub(TOLD);
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    lines.push(format!("moves: {}{more}", told.join(", ")));
    lines
}

/// What happens to a move of a row.
#[derive(Debug, Clone, Copy)]
pub enum MoveProgress {
    Begins(Move),
    /// To its end.
    Made(Move),
}

/// Runs moves one after the other.
pub fn make_all(
    connection: &mut Connection,
    signs: Signs,
    row: &MoveRow,
    homes: bool,
    permit: &Permit,
    mut told: impl FnMut(MoveProgress),
) -> Result<(), LiveProblem> {
    if homes {
        connection.home(permit)?;
    }
    let mut armed = None;
    let ended = row.moves.iter().try_for_each(|&one| {
        told(MoveProgress::Begins(one));
        make_one(connection, signs, one, row.dry.is_some(), &mut armed, permit)?;
        told(MoveProgress::Made(one));
        Ok(())
    });
    connection.session.end_moves();
    connection.observer.publish(&connection.session);
    ended
}

fn make_one(
    connection: &mut Connection,
    signs: Signs,
    one: Move,
    dry: bool,
    armed: &mut Option<Armed>,
    permit: &Permit,
) -> Result<(), LiveProblem> {
    if let Move::Rotate { deg } = one {
        connection.require_turn(deg)?;
    }
    let motion = match one {
        Move::Home => {
            // Homing ends what the machine was armed for.
            *armed = None;
            return connection.home(permit);
        }
        Move::Feed { mm } => signs.motion(Axis::Feed, mm),
        Move::Rotate { deg } => signs.motion(Axis::Rotate, deg),
        Move::Bend { deg } => signs.motion(Axis::Bend, deg),
    };
    let token = match armed.take() {
        Some(armed) => armed,
        None => connection.session.arm_by_hand(permit)?,
    };
    connection.observer.progress.stage(&one.to_string());
    // What was said of where the axes stand was said before this.
    connection.observer.moved();
    connection.session.jog(&token, Motion { dry, ..motion })?;
    connection.observer.publish(&connection.session);
    while !connection.look_until_held("it was moved by hand")?.contains(&Event::Jogged) {}
    *armed = Some(token);
    Ok(())
}
