//! What the commands report and ask goes through what both threads share: the state follows from it, and a person answers.

use std::time::Duration;

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
            // Who stops the machine takes nothing back.
            Answer::No if !self.lock().withdrawn => Some(false),
            _ => None,
        }
    }

    fn confirm_pause(&self, question: &str, look: &mut dyn FnMut() -> bool) -> Option<bool> {
        self.ask(QuestionKind::Pause, None, question, None);
        loop {
            if let Some(answer) = self.answered(Some(Duration::ZERO)) {
                return Some(answer == Answer::Yes);
            }
            // It waits a moment where there is nothing new.
            if !look() {
                self.close_question();
                return None;
            }
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

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::operator::{ConnectRequest, MachineState};

    /// Were it a no, a journal would say that a person has taken back what they said of a step.
    #[test]
    fn a_stop_takes_nothing_back_that_was_said_before() {
        let state = MachineState::connecting(ConnectRequest::simulated("kit"));
        let shared = Shared::new(state, Arc::new(|_: &OperatorEvent| {}));
        let asked = |answer: &dyn Fn()| {
            std::thread::scope(|scope| {
                let asking = scope.spawn(|| shared.is_so("step 3 is done"));
                while shared.lock().state.question.is_none() {
                    std::thread::sleep(Duration::from_millis(1));
                }
                answer();
                asking.join().unwrap()
            })
        };
        let said = |shared: &Shared, answer| {
            let open = shared.lock().asked;
            shared.answer(open, answer).unwrap();
        };
        assert_eq!(asked(&|| said(&shared, Answer::Yes)), Some(true));
        assert_eq!(asked(&|| said(&shared, Answer::No)), Some(false));
        assert_eq!(asked(&|| assert!(shared.stop())), None);
    }
}
