//! A person at a terminal: they read what happens, and are asked before anything moves.

use std::io::{BufRead, IsTerminal, Write};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

use wirebend_app::{Decision, Doubt, News, NoProgress, Progress, SeverityName, StopHandle};

use crate::progress::Bar;
use crate::{render, stop};

/// How often a question looks whether Ctrl-C was pressed.
const LOOK: Duration = Duration::from_millis(50);

/// What the command line shows and asks.
pub(crate) struct Terminal {
    bar: Option<Bar>,
    /// Whether results are for a program: then nothing but questions is said here.
    json: bool,
}

impl Terminal {
    pub fn new(json: bool) -> Self {
        let bar = (std::io::stderr().is_terminal() && !json).then(Bar::new);
        Self { bar, json }
    }

    pub fn finish(&self) {
        self.bar.iter().for_each(Bar::finish);
    }

    fn shown(&self) -> &dyn Progress {
        self.bar.as_ref().map_or(&NoProgress, |bar| bar)
    }

    /// Writes a line above the bar.
    fn say(&self, line: &str) {
        let write = || {
            let _ = writeln!(anstream::stderr(), "{line}");
        };
        match &self.bar {
            Some(bar) => bar.aside(write),
            None => write(),
        }
    }

    /// Asks until one of the answers is given; `None` when nobody is there, or they press Ctrl-C.
    fn ask(&self, question: &str, answers: &[&str]) -> Option<usize> {
        if !is_interactive() {
            return None;
        }
        loop {
            let prompt = || {
                let _ = write!(std::io::stderr(), "{question} [{}] ", answers.join("/"));
                let _ = std::io::stderr().flush();
                read_line()
            };
            let line = match &self.bar {
                Some(bar) => bar.aside(prompt),
                None => prompt(),
            }?;
            let word = line.trim().to_lowercase();
            let fits = |answer: &&str| !word.is_empty() && answer.to_lowercase().starts_with(&word);
            if let Some(found) = answers.iter().position(fits) {
                return Some(found);
            }
            // Without a word the answer is the one that moves nothing.
            if word.is_empty() {
                return Some(answers.len() - 1);
            }
        }
    }
}

/// Whether a person reads and writes.
fn is_interactive() -> bool {
    std::io::stdin().is_terminal() && std::io::stderr().is_terminal()
}

/// A line of the person's; `None` at the end of input, and when Ctrl-C was pressed. Reading cannot be broken off, so
/// it is done apart.
fn read_line() -> Option<String> {
    let (sender, receiver) = channel();
    std::thread::spawn(move || {
        let mut line = String::new();
        let read = std::io::stdin().lock().read_line(&mut line);
        let _ = sender.send(read.ok().filter(|bytes| *bytes > 0).map(|_| line));
    });
    loop {
        match receiver.recv_timeout(LOOK) {
            Ok(line) => return line,
            Err(RecvTimeoutError::Disconnected) => return None,
            Err(RecvTimeoutError::Timeout) if stop::was_pressed() => return None,
            Err(RecvTimeoutError::Timeout) => {}
        }
    }
}

impl Progress for Terminal {
    fn stage(&self, name: &str) {
        self.shown().stage(name);
    }

    fn advance(&self, done: u64, of: u64) {
        self.shown().advance(done, of);
    }

    fn news(&self, news: &News) {
        match news {
            News::About { lines } if !self.json || is_interactive() => {
                for line in lines {
                    self.say(line);
                }
            }
            News::Warning { message, .. } if !self.json => {
                let style = render::severity_style(SeverityName::Warning);
                self.say(&format!("{style}warning{style:#}: {message}"));
            }
            News::Paused { .. } if !self.json => self.say("the machine holds"),
            News::Resumed if !self.json => self.say("the machine goes on"),
            _ => {}
        }
        self.shown().news(news);
    }

    fn confirm(&self, question: &str) -> Option<bool> {
        let said = self.ask(question, &["yes", "No"]);
        // Who presses Ctrl-C has answered.
        said.map(|answer| answer == 0).or(stop::was_pressed().then_some(false))
    }

    fn decide(&self, doubt: &Doubt) -> Option<Decision> {
        if !is_interactive() {
            return None;
        }
        self.say(&format!("{doubt}. Look at the wire."));
        match self.ask("Was this step made to its end?", &["yes", "no", "I do not know"])? {
            0 => Some(Decision::Made),
            1 => Some(Decision::NotMade),
            _ => None,
        }
    }

    fn connected(&self, handle: &StopHandle) {
        stop::connect(Some(handle));
    }

    fn disconnected(&self) {
        stop::connect(None);
    }
}
