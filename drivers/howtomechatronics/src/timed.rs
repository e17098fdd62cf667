//! The machine as the driver sees it: commands go out one after the other, each when the time of the one
//! before is over. No port and no clock of its own.
//!
//! The sketch collects what arrives until a second has passed in silence and takes all of it for one
//! command, so a command must not be sent while the one before is under way.

use std::collections::VecDeque;
use std::time::Duration;

use wirebend_driver_api::{
    Batch, Direction, DoneBy, DriverError, Event, HeadBy, Limits, NumberedStep, ReferenceBy, Run, Sent, Step,
};

use crate::Settings;
use crate::command::{Command, echoed, is_of_another, is_remark};
use crate::whole::Axes;

/// Steps that are taken ahead; the program sends more when they are done.
const ROOM: usize = 64;
/// A line of the machine is a few words; what is longer is noise and is cut there, in bytes.
const MAX_LINE: usize = 200;

#[derive(Debug)]
pub(crate) struct Timed {
    settings: Settings,
    state: State,
    /// What is still to be done, in order.
    queue: VecDeque<Task>,
    /// The command under way, and when its time is over.
    under_way: Option<(Command, Duration)>,
    /// The machine takes commands from the port.
    manual: bool,
    wire: Option<WireInHand>,
    line: Vec<u8>,
    output: Vec<u8>,
    events: VecDeque<Event>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    /// The board starts.
    Booting,
    Ready,
    /// The position of its axes is unknown.
    Lost,
}

#[derive(Debug)]
enum Task {
    Say(Command),
    /// All commands of this step are done.
    Step(u32),
    /// All steps are done.
    Wire,
    /// Nothing is under way any more.
    Stop,
}

#[derive(Debug)]
struct WireInHand {
    steps: u32,
    taken: u32,
    /// The last step is among them.
    complete: bool,
    axes: Axes,
    /// What has to be done before the first of them.
    turn: Vec<Command>,
}

impl Timed {
    /// At the moment at which the port has been opened.
    pub fn new(settings: Settings) -> Self {
        Self {
            settings,
            state: State::Booting,
            queue: VecDeque::new(),
            under_way: None,
            manual: false,
            wire: None,
            line: Vec::new(),
            output: Vec::new(),
            events: VecDeque::new(),
        }
    }

    pub fn arm(&mut self, run: &Run) -> Result<(), DriverError> {
        let refused = |code, message: &str, help: &str| Err(DriverError::new(code, message, help));
        match self.state {
            State::Booting => {
                refused("not-ready", "the machine is still starting", "wait until it is connected")
            }
            State::Lost => refused(
                "not-homed",
                "where the machine's axes are is not known any more",
                "disconnect, put the machine at its start by hand, and connect again",
            ),
            State::Ready if self.under_way.is_some() || !self.queue.is_empty() => {
                refused("busy", "a wire is being bent", "wait until it is finished, or stop it")
            }
            State::Ready if run.after > run.steps => {
                let message = format!("{} of {} steps cannot be done already", run.after, run.steps);
                refused("no-such-step", &message, "plan the wire again")
            }
            State::Ready => {
                let mut axes = Axes::default();
                // The head was put at its start, and has to stand elsewhere first.
                let turn = Step { rotate_deg: run.rotate_at_deg, ..Step::default() };
                let turn = axes.commands(&turn, "where the head was", self.settings.most_feed_mm)?;
                let (steps, taken) = (run.steps, run.after);
                self.wire = Some(WireInHand { steps, taken, complete: false, axes, turn });
                Ok(())
            }
        }
    }

    /// Takes steps as far as there is room. Nothing is taken of a batch that is refused.
    pub fn send(&mut self, batch: &Batch) -> Result<Sent, DriverError> {
        let mut room = self.room();
        let Some(wire) = &mut self.wire else {
            return Err(DriverError::new(
                "not-armed",
                "there is no wire to bend",
                "arm the machine for a wire",
            ));
        };
        let (mut taken, mut axes, mut tasks) = (wire.taken, wire.axes.clone(), Vec::new());
        let first_new = batch.steps.iter().skip_while(|step| step.n <= wire.taken);
        for NumberedStep { n, step } in first_new.take(room) {
            if *n != taken + 1 || *n > wire.steps {
                let message =
                    format!("step number {n} cannot follow number {taken} of a wire with {}", wire.steps);
                return Err(DriverError::new("gap", message, "send the steps in order, from 1"));
            }
            let commands = axes.commands(step, &format!("step {n}"), self.settings.most_feed_mm)?;
            tasks.extend(commands.into_iter().map(Task::Say));
            tasks.push(Task::Step(*n));
            taken = *n;
            room -= 1;
        }
        (wire.taken, wire.axes) = (taken, axes);
        if !tasks.is_empty() {
            tasks.splice(0..0, std::mem::take(&mut wire.turn).into_iter().map(Task::Say));
        }
        if !self.manual && !tasks.is_empty() {
            self.manual = true;
            self.queue.push_back(Task::Say(Command::Manual));
        }
        self.queue.extend(tasks);
        let all = batch.steps.last().is_none_or(|step| step.n <= taken);
        if batch.last && all && !wire.complete {
            wire.complete = true;
            if self.settings.end_each_wire && self.manual {
                self.manual = false;
                self.queue.push_back(Task::Say(Command::End));
            }
            self.queue.push_back(Task::Wire);
        }
        Ok(Sent { accepted: taken, free: u32::try_from(room).unwrap_or(0) })
    }

    /// Sends nothing more. The machine finishes what it was sent, and only then it is at rest.
    pub fn stop(&mut self) {
        self.tell_step_under_way();
        self.wire = None;
        self.queue.clear();
        self.state = State::Lost;
        self.queue.push_back(Task::Stop);
        self.events.push_back(Event::Warning(DriverError::new(
            "no-stop",
            "this machine cannot be stopped by the program: nothing more is sent, and it finishes what it \
             was sent",
            "cut its power to stop the motion under way",
        )));
    }

    /// Of the step under way nobody knows how far it comes; of those after it nothing was sent.
    fn tell_step_under_way(&mut self) {
        let step = self.queue.iter().find_map(|task| if let Task::Step(n) = task { Some(*n) } else { None });
        let moving = self.under_way.is_some_and(|(command, _)| command != Command::Manual);
        if let Some(step) = step {
            let made = if moving { None } else { Some(Step::default()) };
            self.events.push_back(Event::PartMade { step, made, exact: !moving });
        }
    }

    /// Time has passed: what is over is reported, and what is due is sent.
    pub fn pass(&mut self, now: Duration) {
        if self.state == State::Booting && now >= self.settings.boot() {
            self.state = State::Ready;
            self.greet();
        }
        loop {
            if self.under_way.is_some_and(|(_, end)| now < end) {
                return;
            }
            self.under_way = None;
            match self.queue.pop_front() {
                Some(Task::Say(command)) => self.say(command, now),
                Some(Task::Step(n)) => self.events.push_back(Event::Done { n }),
                Some(Task::Wire) => {
                    self.wire = None;
                    self.events.push_back(Event::Finished);
                }
                Some(Task::Stop) => self.events.push_back(Event::Stopped { homed: false }),
                None => return,
            }
        }
    }

    /// Bytes of the machine: lines for the console, and what it says to a command.
    pub fn receive(&mut self, bytes: &[u8], now: Duration) {
        for byte in bytes {
            if *byte != b'\n' && self.line.len() < MAX_LINE {
                self.line.push(*byte);
                continue;
            }
            let text = String::from_utf8_lossy(&std::mem::take(&mut self.line)).trim().to_owned();
            self.events.push_back(Event::Console { direction: Direction::FromMachine, text: text.clone() });
            self.heard(&text, now);
        }
    }

    pub fn unplugged(&mut self) {
        let message = "the line to the machine is gone; it finishes what it was sent";
        let help =
            "cut its power if it still moves, plug it in, put it at its start by hand, and connect again";
        self.fail(DriverError::new("unplugged", message, help), true);
    }

    pub fn take_output(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.output)
    }

    pub fn next_event(&mut self) -> Option<Event> {
        self.events.pop_front()
    }

    fn greet(&mut self) {
        self.events.push_back(Event::Connected {
            limits: Limits::default(),
            identity: "unknown: this machine does not say what it is".to_owned(),
            settings: Vec::new(),
            homed: true,
            resume: None,
            reference: ReferenceBy::default(),
            done_by: DoneBy::Clock,
            head: HeadBy::default(),
        });
        self.events.push_back(Event::Warning(DriverError::new(
            "no-acknowledgement",
            "this machine never reports that something is done: a step counts as done when the time that it is reckoned \
             to take is over, even where no machine is at the port",
            "watch it, and see that the port is the right one",
        )));
        self.events.push_back(Event::Warning(DriverError::new(
            "homed-by-hand",
            "this machine does not report where its axes are; the program takes them to be at their start",
            "before arming turn the wire head and the bend arm to their start by hand, where the sketch has not \
             done it",
        )));
    }

    fn say(&mut self, command: Command, now: Duration) {
        let text = command.to_string();
        self.output.extend_from_slice(text.as_bytes());
        self.output.push(b'\n');
        self.under_way = Some((command, now.saturating_add(self.settings.whole(command))));
        self.events.push_back(Event::Console { direction: Direction::ToMachine, text });
    }

    /// The published sketch prints each motion as it has read it, when it begins. Clones need not, so nothing
    /// is waited for; but what it says is believed.
    fn heard(&mut self, text: &str, now: Duration) {
        if self.state == State::Lost {
            return;
        }
        if is_of_another(text) {
            let message = format!("the machine says '{text}': another controller is at this port");
            let help =
                "see that the port and the machine's profile are the right ones; its driver is not this one";
            return self.fail(DriverError::new("other-machine", message, help), false);
        }
        let Some((sent, end)) = self.under_way else { return };
        let Some(read) = echoed(text) else {
            // Some send back what they were sent.
            if is_remark(text) || text == sent.to_string() {
                return;
            }
            let message =
                format!("the machine says '{text}' to '{sent}', which this driver does not understand");
            let help =
                "see that the port and the machine's profile are the right ones, and what its sketch prints";
            return self.fail(DriverError::new("not-understood", message, help), false);
        };
        if read == sent {
            // It has begun later than was reckoned with: what follows has to wait for longer.
            self.under_way = Some((sent, end.max(now.saturating_add(self.settings.motion(sent)))));
            return;
        }
        let message = format!("the machine says '{text}' where it was sent '{sent}'");
        let help = "cut its power; if it is only slower than reckoned with, set its rates or margin_percent";
        self.fail(DriverError::new("misread", message, help), false);
    }

    /// The run is over: nothing more is sent.
    fn fail(&mut self, error: DriverError, disconnected: bool) {
        let moving = self.under_way.is_some_and(|(command, _)| command != Command::Manual);
        let in_doubt = self.queue.iter().find_map(|task| match task {
            Task::Step(n) if moving => Some(*n),
            _ => None,
        });
        self.state = State::Lost;
        self.wire = None;
        self.queue.clear();
        self.events.push_back(Event::Fault { error, in_doubt, disconnected });
    }

    fn room(&self) -> usize {
        let waiting = self.queue.iter().filter(|task| matches!(task, Task::Step(_))).count();
        ROOM.saturating_sub(waiting)
    }
}

#[cfg(test)]
mod tests;
