//! The wire that is armed or running: its steps as lines, one step at a time.

use std::collections::VecDeque;
use std::rc::Rc;

use wirebend_driver_api::{Batch, DriverError, Run, Sent, Step};

use super::displacement::{ReportedPosition, displaced};
use super::machine::Machine;
use crate::program::{Program, Segment};
use crate::settings::{Names, Settings};

/// Steps that are accepted ahead of the running one.
const MAX_WAITING: usize = 32;

#[derive(Debug)]
pub(super) struct WireRun {
    program: Program,
    /// How many steps the wire has.
    steps: usize,
    start: Vec<String>,
    /// Turns the head to where it has to stand first.
    turn: Option<Segment>,
    waiting: VecDeque<(u32, Vec<Segment>)>,
    /// What is left of the step under way.
    pub rest: VecDeque<Segment>,
    /// Where the axes are after the running lines.
    end: [f64; 3],
    /// Where the running step began.
    from: [f64; 3],
    /// Where the axes were when the program began.
    pub began: Option<ReportedPosition>,
    /// The same in mm and degrees, as positions are reported.
    pub began_at: Option<Step>,
    /// How many lines were sent since.
    moves: u32,
    /// Lines were sent and are not done.
    pub busy: bool,
    /// The last report shows the axes elsewhere.
    pub displaced: bool,
    /// The last step that was taken.
    taken: Option<u32>,
    /// The last step of the wire has been taken.
    last: bool,
    pub stage: Stage,
    pub hold: Hold,
}

/// What the lines under way belong to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Stage {
    /// Nothing has been sent.
    Armed,
    Start,
    /// The head turns to its position.
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

impl WireRun {
    /// Refuses a wire whose values do not fit the blocks.
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
            let message = format!("{} of {} steps cannot be done already", run.after, run.steps);
            return Err(DriverError::new("no-such-step", message, "plan the wire again"));
        }
        let mut program = Program::new(Rc::clone(settings), &names)?;
        let start = program.start();
        // The machine was homed: the head is at zero.
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
            stage: Stage::Armed,
            hold: Hold::No,
        })
    }

    /// Armed without any steps yet.
    pub fn is_armed_only(&self) -> bool {
        self.stage == Stage::Armed && self.waiting.is_empty() && !self.last
    }

    /// The running step, its begin and its end, in units of the machine from where the program began.
    pub const fn under_way(&self) -> Option<(u32, [f64; 3], [f64; 3])> {
        match self.stage {
            Stage::Step(n) => Some((n, self.from, self.end)),
            _ => None,
        }
    }

    /// Differences that reports cannot show, for each axis, in units of the machine.
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
            if self.waiting.len() + fresh.len() >= MAX_WAITING {
                whole = false;
                break;
            }
            let lines = program.segments(&numbered.step).map_err(|why| {
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
        let free = MAX_WAITING.saturating_sub(self.waiting.len());
        Ok(Sent { accepted: taken.unwrap_or_default(), free: u32::try_from(free).unwrap_or_default() })
    }

    /// A resumed wire begins with a later step than 1; from there on steps have no gaps.
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

    /// The lines to send next, if the machine is at rest and steps wait.
    pub fn next_lines(&mut self) -> Option<Vec<String>> {
        if self.busy {
            return None;
        }
        let lines = self.next_part();
        self.busy = lines.is_some();
        lines
    }

    fn next_part(&mut self) -> Option<Vec<String>> {
        match self.stage {
            Stage::Armed if !self.waiting.is_empty() || self.last => {
                self.stage = Stage::Start;
                Some(std::mem::take(&mut self.start))
            }
            // A step of several segments continues with the next.
            Stage::Step(_) => self.rest.pop_front().map(|segment| self.begin(segment)),
            Stage::Between => {
                if let Some(turn) = self.turn.take() {
                    self.stage = Stage::Turn;
                    return Some(self.begin(turn));
                }
                if let Some((n, segments)) = self.waiting.pop_front() {
                    (self.stage, self.from) = (Stage::Step(n), self.end);
                    self.rest = segments.into();
                    return self.rest.pop_front().map(|segment| self.begin(segment));
                }
                if !self.last {
                    return None;
                }
                self.stage = Stage::End;
                Some(self.program.end())
            }
            _ => None,
        }
    }

    /// Refuses to continue if the axes are not where the sent lines end.
    pub fn arrived(&self, machine: &Machine, settings: &Settings) -> Result<(), DriverError> {
        let standing = machine.reported(settings);
        let (Some(began), Some(standing)) = (&self.began, standing) else { return Ok(()) };
        let Some(displaced) = displaced(began, &standing, self.end, self.moves) else { return Ok(()) };
        let during = match self.stage {
            Stage::Step(n) => format!("in step {n}"),
            _ => "before the first step".to_owned(),
        };
        Err(displaced.error(&during, settings))
    }

    fn begin(&mut self, segment: Segment) -> Vec<String> {
        self.end = segment.end;
        self.moves = self.moves.saturating_add(u32::try_from(segment.lines.len()).unwrap_or(u32::MAX));
        segment.lines
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
        let mut wire_run = WireRun::new(&Rc::new(Settings::default()), &run).unwrap();
        // There is room for 32: the rest, and with it the end, has to be sent again.
        assert_eq!(wire_run.take(&batch(1..=40)), Ok(Sent { accepted: 32, free: 0 }));
        assert_eq!(wire_run.take(&batch(33..=40)), Ok(Sent { accepted: 32, free: 0 }));
        wire_run.waiting.clear();
        assert_eq!(wire_run.take(&batch(33..=40)), Ok(Sent { accepted: 40, free: 24 }));
    }
}
