//! Holds a driver's side of a conversation to a transcript.

use std::collections::{BTreeMap, VecDeque};
use std::time::Duration;

use serde_json::{Value, json};

use super::notation::{Act, Answer, Script};
use super::{Answered, Conversation, TranscriptError};
use crate::DriverError;

/// How finely time passes: a driver is asked this often.
const TICK: Duration = Duration::from_millis(1);

pub(super) fn run<C: Conversation>(script: &Script, conversation: C) -> Result<(), TranscriptError> {
    let mut runner = Runner {
        script,
        conversation,
        now: Duration::ZERO,
        output: Vec::new(),
        events: VecDeque::new(),
        standing: BTreeMap::new(),
        answers: Vec::new(),
    };
    runner.settle();
    for (line, act) in &script.acts {
        match act {
            Act::Out(bytes) => runner.sends(*line, bytes)?,
            Act::Event(expected) => runner.reports(*line, expected)?,
            Act::On { bytes, answer } => runner.stand(*line, bytes, answer.as_deref())?,
            Act::In(bytes) => {
                runner.quiet(*line)?;
                runner.conversation.receive(bytes, runner.now);
                runner.settle();
            }
            Act::Pass(time) => {
                runner.quiet(*line)?;
                runner.wait(*time);
            }
            Act::Unplug => {
                runner.quiet(*line)?;
                runner.conversation.unplugged(runner.now);
                runner.settle();
            }
            Act::Do { call, answer } => {
                runner.quiet(*line)?;
                let given = runner.conversation.call(call, runner.now);
                runner.settle();
                runner.answered(*line, answer.as_ref(), given)?;
            }
        }
    }
    runner.quiet(script.end)
}

struct Runner<'a, C> {
    script: &'a Script,
    conversation: C,
    now: Duration,
    /// Sent and not yet found in the transcript.
    output: Vec<u8>,
    /// Reported and not yet found in the transcript.
    events: VecDeque<Value>,
    /// What the machine answers by itself.
    standing: BTreeMap<Vec<u8>, Vec<u8>>,
    /// Such answers that are on their way.
    answers: Vec<u8>,
}

impl<C: Conversation> Runner<'_, C> {
    /// Takes what the driver has to say; what the machine answers by itself does not count as said.
    fn settle(&mut self) {
        self.conversation.pass(self.now);
        let mut sent = self.conversation.take_output();
        for (bytes, answer) in &self.standing {
            while let Some(at) = sent.windows(bytes.len()).position(|part| part == bytes) {
                sent.drain(at..at + bytes.len());
                self.answers.extend_from_slice(answer);
            }
        }
        self.output.append(&mut sent);
        while let Some(event) = self.conversation.next_event() {
            // An event is made of strings and finite numbers; what cannot be written would match nothing.
            self.events.push_back(serde_json::to_value(event).unwrap_or_default());
        }
    }

    fn wait(&mut self, time: Duration) {
        let end = self.now + time;
        while self.now < end {
            self.now = end.min(self.now + TICK);
            let answers = std::mem::take(&mut self.answers);
            if !answers.is_empty() {
                self.conversation.receive(&answers, self.now);
            }
            self.settle();
        }
    }

    fn stand(&mut self, line: usize, bytes: &[u8], answer: Option<&[u8]>) -> Result<(), TranscriptError> {
        self.quiet(line)?;
        match answer {
            Some(answer) => self.standing.insert(bytes.to_vec(), answer.to_vec()),
            None => self.standing.remove(bytes),
        };
        Ok(())
    }

    fn sends(&mut self, line: usize, expected: &[u8]) -> Result<(), TranscriptError> {
        if self.output.starts_with(expected) {
            self.output.drain(..expected.len());
            return Ok(());
        }
        Err(TranscriptError::NotSent {
            place: self.script.place(line),
            expected: expected.escape_ascii().to_string(),
            sent: self.output.escape_ascii().to_string(),
        })
    }

    fn reports(&mut self, line: usize, expected: &Value) -> Result<(), TranscriptError> {
        // An event that may come unmentioned can be mentioned anyway.
        while let Some(event) = self.events.pop_front() {
            if holds(&event, expected) {
                return Ok(());
            }
            if !self.ignores(&event) {
                self.events.push_front(event);
                break;
            }
        }
        Err(TranscriptError::NotReported {
            place: self.script.place(line),
            expected: expected.to_string(),
            reported: self.events.front().map(ToString::to_string).unwrap_or_default(),
        })
    }

    fn ignores(&self, event: &Value) -> bool {
        event["event"].as_str().is_some_and(|kind| self.script.ignored.contains(kind))
    }

    /// Before something new happens, all that was sent and reported has to be in the transcript.
    fn quiet(&mut self, line: usize) -> Result<(), TranscriptError> {
        let place = self.script.place(line);
        if !self.output.is_empty() {
            let sent = self.output.escape_ascii().to_string();
            return Err(TranscriptError::SentMore { place, sent });
        }
        let unmentioned = self.events.iter().find(|event| !self.ignores(event));
        if let Some(reported) = unmentioned.map(ToString::to_string) {
            return Err(TranscriptError::ReportedMore { place, reported });
        }
        self.events.clear();
        Ok(())
    }

    /// `call` is the line of the call, `expected` what stands below it.
    fn answered(
        &self,
        call: usize,
        expected: Option<&(usize, Answer)>,
        given: Result<Answered, DriverError>,
    ) -> Result<(), TranscriptError> {
        let (fits, line, expected) = match (expected, &given) {
            (None, given) => (given.is_ok(), call, "no refusal".to_owned()),
            (Some((line, Answer::Refused(code))), given) => {
                let fits = given.as_ref().is_err_and(|error| error.code == *code);
                (fits, *line, format!("the refusal '{code}'"))
            }
            (Some((line, Answer::Reply(reply))), given) => {
                let fits = given.as_ref().is_ok_and(|given| holds(&written(given), reply));
                (fits, *line, reply.to_string())
            }
        };
        if fits {
            return Ok(());
        }
        let answer = match given {
            Ok(given) => written(&given).to_string(),
            Err(error) => format!("the refusal '{}': {error}", error.code),
        };
        Err(TranscriptError::Answer { place: self.script.place(line), expected, answer })
    }
}

fn written(answered: &Answered) -> Value {
    match answered {
        Answered::Taken => json!({}),
        Answered::Sent(sent) => json!({"accepted": sent.accepted, "free": sent.free}),
        Answered::Armed(armed) => json!({"token": armed.token}),
    }
}

/// Whether a value has all that is expected of it: keys that are not expected may be there, numbers are the
/// same when their values are (1 and 1.0).
fn holds(value: &Value, expected: &Value) -> bool {
    match (value, expected) {
        (Value::Object(value), Value::Object(expected)) => {
            expected.iter().all(|(key, expected)| value.get(key).is_some_and(|value| holds(value, expected)))
        }
        (Value::Array(values), Value::Array(expected)) => {
            values.len() == expected.len()
                && values.iter().zip(expected).all(|(value, expected)| holds(value, expected))
        }
        (Value::Number(value), Value::Number(expected)) => value.as_f64() == expected.as_f64(),
        (value, expected) => value == expected,
    }
}
