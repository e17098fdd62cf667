//! A wire on its way: lines of one step at a time, and what the reports say of it.

use std::collections::VecDeque;
use std::rc::Rc;

use wirebend_driver_api::{Batch, DriverError, Event, PausedBy, Run, Sent, Step};

use super::machine::Machine;
use super::place::{self, Standing};
use super::protocol::{Phase, Protocol};
use super::status::State;
use super::stream::dwell_of;
use crate::program::{Program, Stretch};
use crate::settings::{Names, Settings};

/// So many steps are taken ahead.
const MOST_WAITING: usize = 32;
/// How long a machine may stand idle with a line that it has not answered, besides what a dwell takes.
const ANSWER_WITHIN_S: u64 = 10;

/// The wire that is made, or about to be.
#[derive(Debug)]
pub(super) struct Making {
    program: Program,
    /// How many the wire has.
    steps: usize,
    start: Vec<String>,
    /// Turns the head to where the made part of the wire has left it.
    turn: Option<Stretch>,
    waiting: VecDeque<(u32, Vec<Stretch>)>,
    /// What is left of the step under way.
    rest: VecDeque<Stretch>,
    /// Where the axes stand when what is under way is made.
    end: [f64; 3],
    /// Where the step under way began.
    from: [f64; 3],
    /// Where they stood when the program began.
    began: Option<Standing>,
    /// The same in mm and degrees, as positions are told.
    pub(super) began_at: Option<Step>,
    /// How many lines were sent since.
    moves: u32,
    /// Lines are under way.
    busy: bool,
    /// The last report says that the axes stand elsewhere.
    displaced: bool,
    /// The last step that was taken.
    taken: Option<u32>,
    /// The last step of the wire has been taken.
    last: bool,
    pub part: Part,
    pub hold: Hold,
}

/// What the lines under way belong to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Part {
    /// Nothing has been sent.
    Armed,
    Start,
    /// The head is turned to its place.
    Turn,
    /// At rest, waiting for a step.
    Between,
    Step(u32),
    End,
}

/// Whether the machine holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Hold {
    No,
    Asked,
    Held,
    Resuming,
}

impl Making {
    /// Refuses a wire that the blocks cannot be filled for.
    pub fn new(settings: &Rc<Settings>, run: &Run) -> Result<Self, DriverError> {
        let known = |name: &String| if name.is_empty() { "unknown".to_owned() } else { name.clone() };
        let names = Names {
            name: run.name.clone(),
            design: known(&run.design_hash),
            job: run.job_hash.clone(),
            machine: known(&run.machine),
            wire: run.wire.saturating_add(1),
            steps: run.steps as usize,
            stock_mm: run.stock_mm,
        };
        if run.after > run.steps {
            let message = format!("{} of {} steps cannot be made already", run.after, run.steps);
            return Err(DriverError::new("no-such-step", message, "plan the wire again"));
        }
        let mut program = Program::new(Rc::clone(settings), &names)?;
        let start = program.start();
        // The machine was homed since, so that its head is not where the made part of the wire left it.
        let turn = program.turned_to(run.rotate_at_deg).map_err(|why| {
            DriverError::new(
                "step",
                format!("the head cannot be turned to its place: {why}"),
                "look at the plan",
            )
        })?;
        Ok(Self {
            start,
            turn,
            program,
            steps: names.steps,
            waiting: VecDeque::new(),
            rest: VecDeque::new(),
            end: [0.0; 3],
            from: [0.0; 3],
            began: None,
            began_at: None,
            moves: 0,
            busy: false,
            displaced: false,
            taken: (run.after > 0).then_some(run.after),
            last: false,
            part: Part::Armed,
            hold: Hold::No,
        })
    }

    /// Nothing has been asked of it yet.
    pub fn is_armed_only(&self) -> bool {
        self.part == Part::Armed && self.waiting.is_empty() && !self.last
    }

    /// The step under way, where it began and where it ends, in units of the machine from where the program began.
    pub const fn under_way(&self) -> Option<(u32, [f64; 3], [f64; 3])> {
        match self.part {
            Part::Step(n) => Some((n, self.from, self.end)),
            _ => None,
        }
    }

    /// What cannot be told apart of each axis, in units of the machine.
    pub fn tolerance(&self) -> Option<[f64; 3]> {
        self.began.as_ref().map(|began| began.tolerance(self.moves))
    }

    /// Takes as many steps as there is room for; none when one of them is wrong.
    pub fn take(&mut self, batch: &Batch) -> Result<Sent, DriverError> {
        let mut program = self.program.clone();
        let (mut taken, mut fresh) = (self.taken, Vec::new());
        let mut whole = true;
        for numbered in &batch.steps {
            let n = numbered.n;
            if taken.is_some_and(|taken| n <= taken) {
                continue;
            }
            self.expects(n, taken)?;
            if self.waiting.len() + fresh.len() >= MOST_WAITING {
                whole = false;
                break;
            }
            let lines = program.stretches(&numbered.step).map_err(|why| {
                DriverError::new(
                    "step",
                    format!("step {n} of the run cannot be sent: {why}"),
                    "look at the plan",
                )
            })?;
            fresh.push((n, lines));
            taken = Some(n);
        }
        (self.program, self.taken) = (program, taken);
        self.waiting.extend(fresh);
        self.last |= batch.last && whole;
        let free = MOST_WAITING.saturating_sub(self.waiting.len());
        Ok(Sent { accepted: taken.unwrap_or_default(), free: u32::try_from(free).unwrap_or_default() })
    }

    /// A wire that is taken up again starts later than with 1; from then on there are no gaps.
    fn expects(&self, n: u32, taken: Option<u32>) -> Result<(), DriverError> {
        let total = self.steps;
        if n == 0 || n as usize > total {
            let message = format!("there is no step {n}: the run has the steps 1 to {total}");
            return Err(DriverError::new("no-such-step", message, "plan the wire again"));
        }
        if self.last {
            let message = format!("step {n} comes after the last one");
            return Err(DriverError::new("after-last", message, "arm again for another wire"));
        }
        match taken {
            Some(taken) if n != taken + 1 => {
                let message = format!("step {n} comes after step {taken}");
                Err(DriverError::new("gap", message, "send the steps in order, without gaps"))
            }
            _ => Ok(()),
        }
    }

    /// What is to be sent next, where the machine is at rest and something waits.
    fn next_lines(&mut self) -> Option<Vec<String>> {
        if self.busy {
            return None;
        }
        let lines = self.next_part();
        self.busy = lines.is_some();
        lines
    }

    fn next_part(&mut self) -> Option<Vec<String>> {
        match self.part {
            Part::Armed if !self.waiting.is_empty() || self.last => {
                self.part = Part::Start;
                Some(std::mem::take(&mut self.start))
            }
            // A step of several stretches goes on with the next.
            Part::Step(_) => self.rest.pop_front().map(|stretch| self.begin(stretch)),
            Part::Between => {
                if let Some(turn) = self.turn.take() {
                    self.part = Part::Turn;
                    return Some(self.begin(turn));
                }
                if let Some((n, stretches)) = self.waiting.pop_front() {
                    (self.part, self.from) = (Part::Step(n), self.end);
                    self.rest = stretches.into();
                    return self.rest.pop_front().map(|stretch| self.begin(stretch));
                }
                if !self.last {
                    return None;
                }
                self.part = Part::End;
                Some(self.program.end())
            }
            _ => None,
        }
    }

    /// Refuses a machine that does not stand where the lines that it has taken end.
    fn arrived(&self, machine: &Machine, settings: &Settings) -> Result<(), DriverError> {
        let standing = machine.standing(settings);
        let (Some(began), Some(standing)) = (&self.began, standing) else { return Ok(()) };
        let Some(displaced) = place::displaced(began, &standing, self.end, self.moves) else { return Ok(()) };
        let during = match self.part {
            Part::Step(n) => format!("in step {n}"),
            _ => "before the first step".to_owned(),
        };
        Err(displaced.error(&during, settings))
    }

    fn begin(&mut self, stretch: Stretch) -> Vec<String> {
        self.end = stretch.end;
        self.moves = self.moves.saturating_add(u32::try_from(stretch.lines.len()).unwrap_or(u32::MAX));
        stretch.lines
    }
}

impl Protocol {
    /// Sends the next part of the wire, if it is time for one.
    pub(super) fn go_on(&mut self) {
        let Phase::Making(making) = &mut self.phase else { return };
        if let Some(lines) = making.next_lines() {
            self.stream.take(lines);
            self.asking.outdated();
            self.feed();
        }
    }

    /// A report while a wire is made. `rests`: everything was answered before it was asked for, and the
    /// machine is idle: what was sent is done.
    pub(super) fn making(&mut self, state: State, before: Option<State>, rests: bool) {
        if matches!(state, State::Door { .. }) && !matches!(before, Some(State::Door { .. })) {
            self.event(Event::Warning(DriverError::new(
                "door",
                "the safety door is open; the machine holds and its pin output is off",
                "close the door, see whether the pin is where it was, then resume",
            )));
        }
        self.follow_hold(state);
        let Phase::Making(making) = &mut self.phase else { return };
        if making.hold != Hold::No {
            return;
        }
        if !rests {
            return self.watch_answer(state);
        }
        match making.part {
            Part::Start => {
                making.began = self.machine.standing(&self.settings);
                making.began_at = self.machine.position(&self.settings);
                making.part = Part::Between;
            }
            Part::Turn | Part::Step(_) => {
                if let Err(error) = making.arrived(&self.machine, &self.settings) {
                    // A report may have been damaged itself: the next one has the say.
                    if std::mem::replace(&mut making.displaced, true) {
                        self.fail(error);
                    }
                    return;
                }
                making.displaced = false;
                if making.rest.is_empty() {
                    let made = std::mem::replace(&mut making.part, Part::Between);
                    if let Part::Step(n) = made {
                        self.event(Event::Done { n });
                    }
                }
            }
            Part::End => {
                self.phase = Phase::Ready;
                return self.event(Event::Finished);
            }
            Part::Armed | Part::Between => {}
        }
        if let Phase::Making(making) = &mut self.phase {
            making.busy = false;
        }
        self.go_on();
    }

    /// The machine holds and goes on at the program's word, at that of a button on it, or of its door.
    fn follow_hold(&mut self, state: State) {
        let Phase::Making(making) = &mut self.phase else { return };
        match (state, making.hold) {
            (State::Hold { at_rest: true } | State::Door { at_rest: true }, Hold::No | Hold::Asked) => {
                let asked = making.hold == Hold::Asked;
                making.hold = Hold::Held;
                self.event(Event::Paused { by: if asked { PausedBy::Program } else { PausedBy::Machine } });
            }
            (State::Idle | State::Run, Hold::Held | Hold::Resuming) => {
                making.hold = Hold::No;
                // What is under way was asked while it held.
                self.asking.outdated();
                self.event(Event::Resumed);
            }
            _ => {}
        }
    }

    /// An answer that was lost on the line would be waited for for ever.
    pub(super) fn watch_answer(&mut self, state: State) {
        let Some((line, since)) = self.stream.awaited() else { return };
        let patience = std::time::Duration::from_secs(ANSWER_WITHIN_S) + dwell_of(line);
        if state == State::Idle && self.now.saturating_sub(since) > patience {
            let what = format!("the machine is idle and has not answered the line '{line}'");
            let help = "an answer was lost: see whether the USB cable is sound and away from motor cables";
            self.fail(DriverError::new("unanswered", what, help));
        }
    }
}

#[cfg(test)]
mod tests {
    use wirebend_driver_api::NumberedStep;

    use super::*;

    fn batch(numbers: std::ops::RangeInclusive<u32>) -> Batch {
        let step = Step { feed_mm: 1.0, ..Step::default() };
        Batch { steps: numbers.map(|n| NumberedStep { n, step }).collect(), last: true }
    }

    #[test]
    fn a_wire_ends_with_its_last_step_even_when_it_was_sent_too_early() {
        let run = Run { job_hash: "5a".into(), name: "long".into(), wire: 0, steps: 40, ..Run::default() };
        let mut making = Making::new(&Rc::new(Settings::default()), &run).unwrap();
        // There is room for 32: the rest, and with it the end, has to be sent again.
        assert_eq!(making.take(&batch(1..=40)), Ok(Sent { accepted: 32, free: 0 }));
        assert_eq!(making.take(&batch(33..=40)), Ok(Sent { accepted: 32, free: 0 }));
        making.waiting.clear();
        assert_eq!(making.take(&batch(33..=40)), Ok(Sent { accepted: 40, free: 24 }));
    }
}
