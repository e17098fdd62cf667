//! A person who says yes to every question.

use wirebend_driver_api::Run;
use wirebend_driver_host::jobs::{JobError, JobRun};
use wirebend_driver_host::{Armed, Permit, PermitKind, Session, SessionError};

pub fn yes(session: &mut Session, kind: PermitKind) -> Permit {
    asked(session, kind).unwrap()
}

/// A stop of another thread can come between the question and its answer.
fn asked(session: &mut Session, kind: PermitKind) -> Result<Permit, SessionError> {
    let confirmation = session.ask(kind).confirm();
    session.permit(confirmation)
}

pub fn home(session: &mut Session) -> Result<(), SessionError> {
    let permit = asked(session, PermitKind::ByHand)?;
    session.home(&permit)
}

pub fn arm(session: &mut Session, run: Run) -> Result<Armed, SessionError> {
    let permit = asked(session, PermitKind::Wire)?;
    session.arm(run, permit)
}

pub fn arm_by_hand(session: &mut Session) -> Result<Armed, SessionError> {
    let permit = asked(session, PermitKind::ByHand)?;
    session.arm_by_hand(&permit)
}

pub fn write_settings(session: &mut Session) -> Result<(), SessionError> {
    let permit = asked(session, PermitKind::Settings)?;
    session.write_settings(permit)
}

pub fn command(session: &mut Session, line: &str) -> Result<(), SessionError> {
    let permit = asked(session, PermitKind::Console)?;
    session.command(line, permit)
}

pub fn cut(session: &mut Session) -> Result<(), SessionError> {
    let permit = asked(session, PermitKind::Row)?;
    session.cut(&permit)
}

pub fn start(run: &mut JobRun) -> Result<(), JobError> {
    let permit = yes(run.session(), PermitKind::Wire);
    run.start(permit)
}
