//! From the text of a transcript to what has to happen, line by line.

use std::collections::BTreeSet;
use std::time::Duration;

use serde_json::Value;

use super::{Place, TranscriptError};
use crate::Call;

const KNOWN: &str = "'->', '->!', '<-', '<-!', '@', 'do', 'refused', 'reply', 'event', 'on', 'unplug', or \
                     before them 'settings' and 'ignore'";

/// One line of a transcript.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Act {
    /// The driver sends these bytes.
    Out(Vec<u8>),
    /// The machine sends these bytes.
    In(Vec<u8>),
    /// Time passes.
    Pass(Duration),
    /// The program asks. What stands below it says what it is answered.
    Do { call: Box<Call>, answer: Option<(usize, Answer)> },
    /// The driver reports this.
    Event(Value),
    /// From here on the machine answers these bytes with that line; with nothing when it is absent.
    On { bytes: Vec<u8>, answer: Option<Vec<u8>> },
    /// The cable is pulled.
    Unplug,
}

/// What a call is answered.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Answer {
    /// A refusal with this code.
    Refused(String),
    /// At least this.
    Reply(Value),
}

/// A transcript that has been read.
pub(super) struct Script {
    pub file: String,
    pub settings: Value,
    /// Events that may come unmentioned.
    pub ignored: BTreeSet<String>,
    /// What happens, each with its line.
    pub acts: Vec<(usize, Act)>,
    /// The line after the last.
    pub end: usize,
}

impl Script {
    pub fn parse(file: &str, text: &str) -> Result<Self, TranscriptError> {
        let settings = Value::Object(serde_json::Map::new());
        let mut script =
            Self { file: file.to_owned(), settings, ignored: BTreeSet::new(), acts: Vec::new(), end: 1 };
        for (index, line) in text.lines().enumerate() {
            let line = line.trim();
            if !line.is_empty() && !line.starts_with('#') {
                script.line(index + 1, line).map_err(|what| script.wrong(index + 1, what))?;
            }
            script.end = index + 2;
        }
        let expects =
            |act: &Act| matches!(act, Act::Out(_) | Act::Event(_) | Act::Do { answer: Some(_), .. });
        if script.acts.iter().any(|(_, act)| expects(act)) {
            Ok(script)
        } else {
            Err(TranscriptError::ExpectsNothing { file: script.file })
        }
    }

    pub fn place(&self, line: usize) -> Place {
        Place { file: self.file.clone(), line }
    }

    fn wrong(&self, line: usize, what: String) -> TranscriptError {
        TranscriptError::Notation { place: self.place(line), what }
    }

    fn line(&mut self, number: usize, line: &str) -> Result<(), String> {
        let (word, rest) = line.split_once(' ').map_or((line, ""), |(word, rest)| (word, rest.trim_start()));
        if matches!(word, "settings" | "ignore") && !self.acts.is_empty() {
            return Err(format!("'{word}' comes too late; write it before everything that happens"));
        }
        let act = match word {
            "settings" => {
                self.settings = json(word, rest)?;
                return Ok(());
            }
            "ignore" => {
                self.ignored.extend(rest.split_whitespace().map(str::to_owned));
                return Ok(());
            }
            "refused" if rest.is_empty() => return Err("'refused' needs the code of the refusal".to_owned()),
            "refused" => return self.answered(number, word, Answer::Refused(rest.to_owned())),
            "reply" => return self.answered(number, word, Answer::Reply(json(word, rest)?)),
            "->" => Act::Out(ended(rest, b"\n")),
            "->!" => Act::Out(raw(rest)?),
            "<-" => Act::In(ended(rest, b"\r\n")),
            "<-!" => Act::In(raw(rest)?),
            "@" => Act::Pass(time(rest)?),
            "do" => Act::Do { call: json(word, rest)?, answer: None },
            "event" => Act::Event(json(word, rest)?),
            "on" => on(rest)?,
            "unplug" => Act::Unplug,
            _ => return Err(format!("'{word}' is not in the notation; expected {KNOWN}")),
        };
        self.acts.push((number, act));
        Ok(())
    }

    fn answered(&mut self, number: usize, word: &str, given: Answer) -> Result<(), String> {
        match self.acts.last_mut() {
            Some((_, Act::Do { answer: answer @ None, .. })) => {
                *answer = Some((number, given));
                Ok(())
            }
            _ => Err(format!("'{word}' belongs right below the 'do' that it answers")),
        }
    }
}

fn on(rest: &str) -> Result<Act, String> {
    let (bytes, answer) = rest.split_once(' ').unwrap_or((rest, ""));
    let answer = answer.trim_start();
    let answer = (!answer.is_empty()).then(|| ended(answer, b"\r\n"));
    Ok(Act::On { bytes: raw(bytes)?, answer })
}

fn ended(line: &str, end: &[u8]) -> Vec<u8> {
    [line.as_bytes(), end].concat()
}

fn json<T: serde::de::DeserializeOwned>(word: &str, text: &str) -> Result<T, String> {
    serde_json::from_str(text).map_err(|error| format!("'{word}' needs JSON on the same line: {error}"))
}

/// `250 ms` or `2.5 s`.
fn time(text: &str) -> Result<Duration, String> {
    let wrong =
        || format!("'{text}' is no time; expected a number and its unit, such as '250 ms' or '2.5 s'");
    let (number, unit) = text.split_once(' ').ok_or_else(wrong)?;
    let scale = match unit.trim_start() {
        "ms" => 0.001,
        "s" => 1.0,
        _ => return Err(wrong()),
    };
    let number: f64 = number.parse().map_err(|_| wrong())?;
    Duration::try_from_secs_f64(number * scale).map_err(|_| wrong())
}

/// Bytes with `\xNN`, `\n`, `\r`, `\t`, `\s` (a blank) and `\\`.
fn raw(text: &str) -> Result<Vec<u8>, String> {
    if text.is_empty() {
        return Err("bytes are missing, such as '?' or '\\x18'".to_owned());
    }
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text;
    while let Some(at) = rest.find('\\') {
        bytes.extend_from_slice(&rest.as_bytes()[..at]);
        rest = &rest[at + 1..];
        let (byte, length) = match rest.as_bytes().first() {
            Some(b'n') => (b'\n', 1),
            Some(b'r') => (b'\r', 1),
            Some(b't') => (b'\t', 1),
            Some(b's') => (b' ', 1),
            Some(b'\\') => (b'\\', 1),
            Some(b'x') => {
                let digits = rest.get(1..3).filter(|digits| digits.bytes().all(|c| c.is_ascii_hexdigit()));
                let byte = digits.and_then(|digits| u8::from_str_radix(digits, 16).ok());
                (byte.ok_or("'\\x' needs two hexadecimal digits, such as '\\x18'")?, 3)
            }
            _ => return Err("'\\' needs n, r, t, s, x and two digits, or another '\\' behind it".to_owned()),
        };
        bytes.push(byte);
        rest = &rest[length..];
    }
    bytes.extend_from_slice(rest.as_bytes());
    Ok(bytes)
}
