//! Pause points: the machine stands there until a person says that what is to be done is done.

use wirebend_driver_host::api::PausedBy;
use wirebend_driver_host::{PermitKind, Phase};
use wirebend_error::{ErrorCode, ProblemReport};

use super::making::{Heard, Making};
use crate::live::{MachineObserver, refused};
use crate::{LiveProblem, MachineEvent, OperationError};

impl Making<'_, '_> {
    /// Where the machine stands at a pause point a person is asked, and it is looked at meanwhile. Why it holds, if it has begun
    /// to.
    pub(super) fn ask_at_pause(
        &mut self,
        observer: &mut MachineObserver,
        heard: &mut Heard,
    ) -> Result<Option<PausedBy>, OperationError> {
        let Some(pause) = self.run.waits_at().cloned().filter(|_| self.phase() != Phase::Holding) else {
            return Ok(None);
        };
        let (front_end, of) = (observer.progress, self.run.overview().of);
        front_end.stage("waiting at a pause point");
        let lines = vec![format!("the machine stands after step {} of {of}", pause.after)];
        front_end.event(&MachineEvent::About { lines });
        let request = self.run.session().ask(PermitKind::Continue);
        let question = format!("{}: is that done, and may the machine resume?", pause.note);
        let (mut hold, mut failed) = (None, None);
        let said = front_end.confirm_pause(&question, &mut || {
            match self.look(observer, heard) {
                Ok(held) => hold = held.or(hold),
                Err(error) => failed = Some(error),
            }
            failed.is_none() && self.is_in_wire()
        });
        if let Some(error) = failed {
            return Err(error);
        }
        if self.run.session().last_stop().is_some() || !self.is_in_wire() {
            return Ok(None);
        }
        if said == Some(true) {
            let session = self.run.session();
            let permit = session.permit(request.confirm());
            let permit = permit.map_err(|error| refused(session, error, "a person was asked about it"))?;
            self.run.go_on(permit).map_err(LiveProblem::from)?;
            front_end.stage("bending the wire");
            return Ok(hold.filter(|_| self.phase() == Phase::Holding));
        }
        if said.is_none() {
            let message = format!(
                "the wire waits at a pause point ({}), and nobody is there to say that it goes on: it was stopped",
                pause.note
            );
            heard.held = Some(ProblemReport::new(ErrorCode::NotConfirmed, message, Vec::new()));
        }
        self.run.stop().1.map_err(LiveProblem::from)?;
        Ok(None)
    }

    /// The pause point at which the wire stands, for a person who is asked whether it resumes: their yes is for what is to be
    /// done there, too.
    pub(super) fn stands_at_pause(&mut self, done: u32) -> Option<String> {
        let pause = self.run.pause_ahead().filter(|pause| pause.after == done)?;
        let line = format!("it stands at a pause point, do this first: {}", pause.note);
        self.past_pause = Some(done);
        Some(line)
    }

    fn is_in_wire(&self) -> bool {
        matches!(self.phase(), Phase::Armed | Phase::Making | Phase::Holding)
    }

    fn phase(&self) -> Phase {
        self.run.overview().phase
    }
}
