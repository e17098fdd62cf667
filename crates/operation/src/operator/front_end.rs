//! What the commands report and ask goes through what both threads share: the state follows from it, and a person answers.

use wirebend_driver_host::{Snapshot, StopHandle};

use super::event::OperatorEvent;
use super::question::QuestionKind;
use super::shared::Shared;
use crate::order::Answer;
use crate::{Cancellation, Decision, Doubt, MachineEvent, Observer, Prompt, Wait, Wish};
use wirebend_planning::Progress;

impl Progress for Shared {
    fn stage(&self, name: &str) {
        self.change(|state| state.doing = Some(name.to_owned()));
    }

    fn advance(&self, _done: u64, _of: u64) {}
}

impl Observer for Shared {
    fn event(&self, event: &MachineEvent) {
        match event {
            // It is shown with the question.
            MachineEvent::About { lines } => self.about(lines.clone()),
            event => self.hear(&OperatorEvent::Machine(event.clone())),
        }
    }

    fn snapshot(&self, snapshot: &Snapshot) {
        self.stands(snapshot);
    }

    fn in_step(&self, part: f64) {
        self.is_in_step(part);
    }
}

impl Prompt for Shared {
    fn confirm(&self, question: &str) -> Option<bool> {
        self.ask(QuestionKind::Resume, None, question, None);
        Some(self.answered(None) == Some(Answer::Yes))
    }

    fn is_so(&self, said: &str) -> Option<bool> {
        self.ask(QuestionKind::Said, Some(Vec::new()), said, None);
        match self.answered(None)? {
            Answer::Yes => Some(true),
            Answer::No => Some(false),
            _ => None,
        }
    }

    fn decide(&self, doubt: &Doubt) -> Option<Decision> {
        let question = "Look at the wire: how much of this step was done?";
        self.ask(QuestionKind::Doubt, Some(vec![doubt.to_string()]), question, Some(doubt.clone()));
        match self.answered(None)? {
            Answer::Made => Some(Decision::Made),
            Answer::NotMade => Some(Decision::NotMade),
            Answer::AsCounted => Some(Decision::AsCounted),
            Answer::Part(part) => Some(Decision::Part(part)),
            Answer::Yes | Answer::No | Answer::Head(_) => None,
        }
    }
}

impl Cancellation for Shared {
    fn wish(&self) -> Option<Wish> {
        self.wished()
    }

    fn wait(&self) -> Wait {
        if self.actor.is_closing() {
            Wait::GivenUp
        } else if self.actor.stop_is_wanted() {
            Wait::IsOver
        } else {
            Wait::GoesOn
        }
    }

    fn connected(&self, stop: &StopHandle) {
        self.can_be_stopped(stop);
    }

    fn disconnected(&self) {
        self.actor.disconnected();
    }
}
