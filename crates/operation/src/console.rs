//! `console`: lines that a person types for a machine, and its answers.

use std::cell::RefCell;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_driver_host::api::{Capability, Direction, Event};
use wirebend_driver_host::jobs::stamp_to_ms;
use wirebend_driver_host::{Permit, PermitKind, Phase, SessionError};
use wirebend_error::ProblemReport;

use crate::FrontEnd;
use crate::live::{At, Connection, Unnamed, ask_permit, connect, stop_of};
use crate::{LiveProblem, OperationError};
use wirebend_planning::Installation;
use wirebend_planning::report::NoteReport;
use wirebend_planning::signs::Signs;

/// What a person is asked before a line that may move or change something.
pub const QUESTION: &str = "May this line be sent to the machine?";

/// Lines that are typed for a machine, one after the other. A question of them changes nothing; whatever else they are needs a yes:
/// here, or when the user is asked.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
pub struct ConsoleRequest {
    pub machine: String,
    /// Where it is; absent, the machine that its driver simulates is taken, if it has one.
    pub port: Option<String>,
    pub lines: Vec<String>,
    /// Whether the person has said already that the machine may move and be changed.
    #[serde(default)]
    pub confirmed: bool,
}

/// What went over the line.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct ConsoleResponse {
    pub machine: String,
    pub port: String,
    pub identity: String,
    /// Lines to the machine and from it since the first that was typed.
    pub lines: Vec<ConsoleEntry>,
    /// How many of the typed lines were answered.
    pub answered: usize,
    /// How many were typed.
    pub of: usize,
    /// Whether the machine was stopped.
    pub stopped: bool,
    /// Why the rest was not sent.
    pub problem: Option<ProblemReport>,
    /// What a person should know.
    pub notes: Vec<NoteReport>,
}

/// A line to the machine or from it.
#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct ConsoleEntry {
    /// When it was heard, in UTC.
    pub at: String,
    /// Whether it went to the machine.
    pub to_machine: bool,
    pub text: String,
}

pub fn console(
    app: &Installation,
    request: &ConsoleRequest,
    progress: &dyn FrontEnd,
) -> Result<ConsoleResponse, OperationError> {
    let machine = app.library.machine(&request.machine)?;
    let at = At {
        profile: &machine.profile,
        signs: Signs::of(&machine.figures()?),
        port: request.port.as_deref(),
        unnamed: Unnamed::Simulate,
        reattached: None,
        axes_at_zero: false,
    };
    let mut connection = connect(app, &at, progress)?;
    require(&connection)?;
    let entries = RefCell::new(Vec::new());
    let mut answered = 0;
    let ended = request.lines.iter().try_for_each(|line| {
        let mut heard = |event: &Event| entries.borrow_mut().extend(ConsoleEntry::of(event));
        if !ask(&mut connection, line, &mut heard)? {
            let about = lines(&connection, line);
            let (kind, confirmed) = (PermitKind::Console, request.confirmed);
            let permit = ask_permit(&mut connection.session, progress, kind, about, QUESTION, confirmed)?;
            command(&mut connection, line, permit, &mut heard)?;
        }
        answered += 1;
        Ok(())
    });
    let (stopped, problem) = match ended {
        Ok(()) => (false, None),
        Err(LiveProblem::Stopped { .. }) => (true, None),
        Err(_) if stop_of(&connection.session).is_some() => (true, None),
        // The answers so far are what was asked for.
        Err(error) if answered > 0 => (false, Some(ProblemReport::from(&error))),
        Err(error) => {
            connection.await_standstill();
            return Err(error.into());
        }
    };
    connection.await_standstill();
    Ok(ConsoleResponse {
        machine: machine.profile.id.clone(),
        port: connection.port.clone(),
        identity: connection.session.identity().to_owned(),
        lines: entries.into_inner(),
        answered,
        of: request.lines.len(),
        stopped,
        problem,
        notes: std::mem::take(&mut connection.observer.warnings),
    })
}

/// Refuses a machine whose driver takes no typed lines.
pub fn require(connection: &Connection) -> Result<(), LiveProblem> {
    let description = connection.session.driver().description();
    if description.can(Capability::Console) {
        return Ok(());
    }
    let (driver, capability) = (description.id.clone(), Capability::Console);
    Err(LiveProblem::from(SessionError::Unsupported { driver, capability }))
}

/// Passes a line on if it is a question, and waits for the answer. False where it is none: nothing was sent then.
pub fn ask(
    connection: &mut Connection,
    line: &str,
    heard: &mut dyn FnMut(&Event),
) -> Result<bool, LiveProblem> {
    if !connection.session.question(line)? {
        return Ok(false);
    }
    tracing::info!(line, "a question was typed");
    await_answer(connection, heard)?;
    Ok(true)
}

/// Passes a line on that may move or change something, and waits until the machine rests.
pub fn command(
    connection: &mut Connection,
    line: &str,
    permit: Permit,
    heard: &mut dyn FnMut(&Event),
) -> Result<(), LiveProblem> {
    tracing::info!(line, "a command was typed");
    connection.observer.moved();
    connection.observer.progress.stage(line);
    connection.wire_used = true;
    connection.session.command(line, permit)?;
    connection.observer.publish(&connection.session);
    await_answer(connection, heard)
}

fn await_answer(connection: &mut Connection, heard: &mut dyn FnMut(&Event)) -> Result<(), LiveProblem> {
    let stopped_before = connection.session.phase() == Phase::Stopped;
    loop {
        let events = connection.look_for_answer(stopped_before)?;
        events.iter().for_each(&mut *heard);
        if events.iter().any(|event| matches!(event, Event::ConsoleDone { .. })) {
            connection.observer.publish(&connection.session);
            return Ok(());
        }
    }
}

/// What a person reads before a line is sent that may move or change something.
pub fn lines(connection: &Connection, line: &str) -> Vec<String> {
    let mut lines = vec![format!("the machine at {} ({})", connection.port, connection.session.identity())];
    lines.push(format!("line: {line}"));
    lines.push("it may move the machine at once, or change what it has stored".to_owned());
    lines.push("the machine has to be homed afterwards".to_owned());
    lines
}

impl ConsoleEntry {
    fn of(event: &Event) -> Option<Self> {
        let Event::Console { direction, text } = event else { return None };
        let to_machine = *direction == Direction::ToMachine;
        Some(Self { at: stamp_to_ms(), to_machine, text: text.clone() })
    }
}
