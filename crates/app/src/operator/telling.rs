//! What the commands tell and ask goes through what both threads share: the state follows from it, and a person answers.

use wirebend_driver_host::StopHandle;

use super::event::{OperatorEvent, QuestionKind};
use super::order::Answer;
use super::shared::Shared;
use super::state::{Phase, WireState};
use crate::{Decision, Doubt, News, Progress, Wait, Wish};

impl Progress for Shared {
    fn stage(&self, name: &str) {
        self.change(|state| state.doing = Some(name.to_owned()));
    }

    fn advance(&self, _done: u64, _of: u64) {}

    fn news(&self, news: &News) {
        match news {
            // It is told with the question.
            News::About { lines } => return self.about(lines.clone()),
            News::Position(position) => self.change_untold(|state| state.position = Some(*position)),
            &News::Wire { wire, made, sent, of, elapsed_s, remaining_s } => {
                // Of which job it is was known before it was begun.
                let figures = |before| WireState { wire, made, sent, of, elapsed_s, remaining_s, ..before };
                self.change_untold(|state| state.wire = state.wire.take().map(figures));
                if self.state().phase != Phase::Holding {
                    self.enter(Phase::Making);
                }
            }
            News::Homing => self.enter(Phase::Homing),
            News::Paused { .. } => self.enter(Phase::Holding),
            News::Resumed => self.enter(Phase::Making),
            News::Console { .. } | News::Warning { .. } => {}
        }
        self.hear(&OperatorEvent::News(news.clone()));
    }

    fn confirm(&self, question: &str) -> Option<bool> {
        self.ask(QuestionKind::GoOn, None, question, None);
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
        let question = "Look at the wire: how much of this step was made?";
        self.ask(QuestionKind::Doubt, Some(vec![doubt.to_string()]), question, Some(doubt.clone()));
        match self.answered(None)? {
            Answer::Made => Some(Decision::Made),
            Answer::NotMade => Some(Decision::NotMade),
            Answer::AsCounted => Some(Decision::AsCounted),
            Answer::Part(part) => Some(Decision::Part(part)),
            Answer::Yes | Answer::No | Answer::Head(_) => None,
        }
    }

    fn wish(&self) -> Option<Wish> {
        self.wished()
    }

    fn wait(&self) -> Wait {
        if self.is_closing() {
            Wait::GivenUp
        } else if self.stop_is_wanted() {
            Wait::IsOver
        } else {
            Wait::GoesOn
        }
    }

    fn connected(&self, stop: &StopHandle) {
        self.can_be_stopped(stop);
    }

    fn disconnected(&self) {
        self.is_lost();
    }
}
