//! A person at a terminal: they read what happens, and are asked before anything moves.

use std::cell::Cell;
use std::io::{BufRead, IsTerminal, Write};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

use wirebend_api::{
    Cancellation, Decision, Doubt, FoundSoFar, MachineEvent, NoProgress, Observer, OrderName, PartOfStep,
    Phase, Progress, Prompt, SHOWN_AS_ZERO, SeverityName, Snapshot, StopHandle, Wish,
};

use crate::number::number;
use crate::progress::Bar;
use crate::render::plan::found_so_far;
use crate::{keyboard, render, stop};

/// How often a question looks whether Ctrl-C was pressed.
const LOOK: Duration = Duration::from_millis(50);

/// What the command line shows and asks.
pub(crate) struct Terminal {
    bar: Option<Bar>,
    /// Whether results are for a program: then nothing but questions is said here.
    json: bool,
    /// What the machine was in last.
    phase: Cell<Phase>,
    /// What Enter has asked for, until the machine does it or it is refused.
    wished: Cell<Option<Wish>>,
    /// Whether it was said of this wire that Enter pauses it.
    hinted: Cell<bool>,
    /// Whether a question is on the screen: the bar waits.
    asks: Cell<bool>,
}

impl Terminal {
    pub fn new(json: bool) -> Self {
        let bar = (std::io::stderr().is_terminal() && !json).then(Bar::new);
        Self {
            bar,
            json,
            phase: Cell::new(Phase::Closed),
            wished: Cell::new(None),
            hinted: Cell::new(false),
            asks: Cell::new(false),
        }
    }

    pub fn finish(&self) {
        self.bar.iter().for_each(Bar::finish);
    }

    /// The bar, unless it is out of the way.
    fn bar(&self) -> Option<&Bar> {
        self.bar.as_ref().filter(|_| !self.asks.get())
    }

    fn shown(&self) -> &dyn Progress {
        self.bar().map_or(&NoProgress, |bar| bar)
    }

    /// Writes a line above the bar.
    fn say(&self, line: &str) {
        let write = || {
            let _ = writeln!(anstream::stderr(), "{line}");
        };
        match self.bar() {
            Some(bar) => bar.aside(write),
            None => write(),
        }
    }

    /// Asks, and reads a line.
    fn prompt(&self, question: &str) -> Option<String> {
        self.prompt_while(question, &mut || true)
    }

    /// The same as long as there is something to ask.
    fn prompt_while(&self, question: &str, look: &mut dyn FnMut() -> bool) -> Option<String> {
        let bar = self.bar();
        let mut prompt = || {
            let _ = write!(std::io::stderr(), "{question} ");
            let _ = std::io::stderr().flush();
            self.asks.set(true);
            let line = read_line(look);
            self.asks.set(false);
            line
        };
        match bar {
            Some(bar) => bar.aside(prompt),
            None => prompt(),
        }
    }

    /// What is said of a change of the machine's phase.
    fn changed(&self, before: Phase, now: &Snapshot) -> Option<&'static str> {
        match (before, now.phase) {
            // Who has paused it elsewhere is asked.
            (_, Phase::Holding) if self.wished.get() == Some(Wish::Pause) => {
                Some("paused; press Enter to resume")
            }
            (_, Phase::Holding) => Some("paused"),
            (Phase::Holding, Phase::Making) => Some("resumed"),
            (_, Phase::Making) if keyboard::hears_enter() && now.orders.can.contains(&OrderName::Pause) => {
                (!self.hinted.replace(true)).then_some("press Enter to pause")
            }
            (_, Phase::Making) => None,
            _ => {
                self.hinted.set(false);
                None
            }
        }
    }

    /// How much of a feed or a turn was done; `None` when they do not know.
    fn measured(&self, question: &str, whole: f64) -> Option<f64> {
        if whole.abs() < SHOWN_AS_ZERO {
            return Some(0.0);
        }
        loop {
            let line =
                self.prompt(&format!("{question}, between 0 and {whole:.1}? [Enter: I do not know]"))?;
            let word = line.trim();
            if word.is_empty() {
                return None;
            }
            let within = |part: &f64| {
                *part >= whole.min(0.0) - SHOWN_AS_ZERO && *part <= whole.max(0.0) + SHOWN_AS_ZERO
            };
            if let Some(part) = number(word).filter(within) {
                return Some(part);
            }
        }
    }

    /// Asks until one of the answers is given; `None` without a user, or when they press Ctrl-C.
    fn ask(&self, question: &str, answers: &[&str]) -> Option<usize> {
        self.ask_while(question, answers, &mut || true)
    }

    /// The same as long as there is something to ask.
    fn ask_while(&self, question: &str, answers: &[&str], look: &mut dyn FnMut() -> bool) -> Option<usize> {
        if !keyboard::is_there() {
            return None;
        }
        loop {
            let line = self.prompt_while(&format!("{question} [{}]", answers.join("/")), look)?;
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

/// A line of the person's; `None` at the end of input, and when Ctrl-C was pressed. Reading cannot be broken off, so
/// it is done apart. `None`, too, once `look` says that there is nothing to ask any more.
fn read_line(look: &mut dyn FnMut() -> bool) -> Option<String> {
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
            Err(RecvTimeoutError::Timeout) if stop::was_pressed() || !look() => return None,
            Err(RecvTimeoutError::Timeout) => {}
        }
    }
}

impl Progress for Terminal {
    fn stage(&self, name: &str) {
        stop::search(false);
        self.shown().stage(name);
    }

    fn search(&self, name: &str) {
        stop::search(true);
        self.shown().stage(&format!("{name} (Ctrl-C takes the best so far)"));
    }

    fn found(&self, found: FoundSoFar) {
        if let Some(text) = found_so_far(&found) {
            self.shown().stage(&text);
        }
    }

    fn goes_on(&self) -> bool {
        !stop::ends_search()
    }

    fn advance(&self, done: u64, of: u64) {
        self.shown().advance(done, of);
    }
}

impl Observer for Terminal {
    fn event(&self, event: &MachineEvent) {
        if matches!(event, MachineEvent::Warning(_)) {
            self.wished.set(None);
        }
        match event {
            MachineEvent::About { lines } if !self.json || keyboard::is_there() => {
                for line in lines {
                    self.say(line);
                }
            }
            MachineEvent::Warning(problem) if !self.json => {
                let style = render::severity_style(SeverityName::Warning);
                self.say(&format!("{style}warning{style:#}: {}", problem.message));
                for advice in render::advice::of(&problem.remedies) {
                    self.say(&format!("  help: {advice}"));
                }
            }
            _ => {}
        }
    }

    fn snapshot(&self, snapshot: &Snapshot) {
        let before = self.phase.replace(snapshot.phase);
        if before != snapshot.phase {
            let said = self.changed(before, snapshot).filter(|_| !self.json);
            self.wished.set(None);
            if let Some(line) = said {
                self.say(line);
            }
        }
        if let Some(bar) = self.bar() {
            bar.snapshot(snapshot);
        }
    }
}

impl Prompt for Terminal {
    fn confirm(&self, question: &str) -> Option<bool> {
        let said = self.ask(question, &["yes", "No"]);
        // A user who presses Ctrl-C has answered.
        said.map(|answer| answer == 0).or(stop::was_pressed().then_some(false))
    }

    fn confirm_pause(&self, question: &str, look: &mut dyn FnMut() -> bool) -> Option<bool> {
        let said = self.ask_while(question, &["yes", "No"], look);
        said.map(|answer| answer == 0).or(stop::was_pressed().then_some(false))
    }

    fn is_so(&self, said: &str) -> Option<bool> {
        // Who presses Ctrl-C takes nothing back.
        self.ask(said, &["yes", "No"]).map(|answer| answer == 0)
    }

    fn decide(&self, doubt: &Doubt) -> Option<Decision> {
        if !keyboard::is_there() {
            return None;
        }
        self.say(&format!("{doubt}. Look at the wire."));
        match self.ask("Was this step finished?", &["yes", "no", "I do not know"])? {
            0 => return Some(Decision::Made),
            1 => {}
            _ => self.say(
                "Count the bends of the wire: with the bend of this step in it, the step is done. Without it, measure.",
            ),
        }
        // An axis that stops before zero has not the sign of its bend.
        let before_zero = doubt.commanded.approach_deg.is_some();
        let whole = if before_zero { doubt.designed.bend_deg } else { doubt.commanded.bend_deg };
        self.say(&format!(
            "Its bend of {whole:.1}° starts from the beginning, so that only feed and rotation count."
        ));
        if let Some(part) = doubt.counted {
            let counted = format!(
                "Is it {:.1} mm fed and {:.1}° turned, as the machine counts?",
                part.feed_mm, part.rotate_deg
            );
            match self.ask(&counted, &["yes", "no", "I do not know"])? {
                0 => return Some(Decision::AsCounted),
                1 => {}
                _ => return None,
            }
        }
        let feed_mm = self.measured("How many mm of it were fed", doubt.commanded.feed_mm)?;
        let rotate_deg = self.measured("How many degrees was it turned", doubt.commanded.rotate_deg)?;
        Some(Decision::Part(PartOfStep { feed_mm, rotate_deg }))
    }

    fn place_of_head(&self, question: &str, [least, most]: [f64; 2], left_at: Option<f64>) -> Option<f64> {
        if !keyboard::is_there() {
            return None;
        }
        loop {
            let nothing = left_at.map_or_else(|| "leave it".to_owned(), |deg| format!("still at {deg:.1}"));
            let line = self.prompt(&format!("{question} [{least} to {most}; nothing: {nothing}]"))?;
            let word = line.trim().trim_end_matches('°').trim();
            if word.is_empty() {
                return left_at;
            }
            match number(word) {
                Some(deg) if (least..=most).contains(&deg) => return Some(deg),
                _ => self.say(&format!("'{word}' is no number from {least} to {most}")),
            }
        }
    }
}

impl Cancellation for Terminal {
    fn wish(&self) -> Option<Wish> {
        if stop::was_pressed() || !keyboard::takes_enter() {
            return None;
        }
        let wish = match self.phase.get() {
            Phase::Making => Wish::Pause,
            Phase::Holding => Wish::Resume,
            _ => return None,
        };
        // Pressed twice, it is asked for once.
        (self.wished.replace(Some(wish)) != Some(wish)).then_some(wish)
    }

    fn connected(&self, handle: &StopHandle) {
        stop::connect(Some(handle));
    }

    fn disconnected(&self) {
        stop::connect(None);
    }
}
