//! The thread: a millisecond of the controller at a time, and what came and went in it.

use std::collections::VecDeque;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, TryRecvError};
use std::time::{Duration, Instant};

use super::behind::Behind;
use super::terminal::{Happened, Seen, Terminal};
use super::{Options, Pace};
use crate::error::UnoError;
use crate::uno::HZ;

/// Cycles between two looks at the terminal: a millisecond, which is what a USB port takes too.
const SLICE: u64 = HZ / 1000;
/// Bytes that may wait for the wire before the terminal is left to hold back its other side.
const WAITING: u64 = 256;
/// Further behind than this the controller does not try to catch up: the computer was busy with something else.
const HOPELESS: Duration = Duration::from_millis(200);

/// So long the event of an opening is waited for, and the end of a close: both come at once unless the computer is busy.
const EVENT: Duration = Duration::from_millis(250);

/// What the owner of the port wants.
pub(super) enum Command<B> {
    With(Box<dyn FnOnce(&mut B) + Send>),
    Unplug(Sender<()>),
    PlugIn(Sender<()>),
}

/// The controller and its port.
pub(super) struct Runner<B> {
    board: B,
    options: Options,
    link: PathBuf,
    commands: Receiver<Command<B>>,
    connections: Arc<AtomicU64>,
    /// None while it is unplugged.
    terminal: Option<Terminal>,
    /// The terminal before: a program may just be opening it under the name that the port had.
    retired: Option<Terminal>,
    /// How many have it open.
    users: u64,
    /// Since when it is open although all who were counted have closed it: the event of another opening, or the end of the close, is
    /// about to come.
    unseen: Option<Instant>,
    outgoing: VecDeque<u8>,
    /// A moment, and the cycle that belongs to it.
    since: (Instant, u64),
}

impl<B: Behind> Runner<B> {
    pub(super) fn new(
        board: B,
        options: Options,
        link: PathBuf,
        commands: Receiver<Command<B>>,
        connections: Arc<AtomicU64>,
    ) -> Result<Self, UnoError> {
        let terminal = Some(Terminal::new(&link)?);
        let since = (Instant::now(), board.cycle());
        let outgoing = VecDeque::new();
        Ok(Self {
            board,
            options,
            link,
            commands,
            connections,
            terminal,
            retired: None,
            users: 0,
            unseen: None,
            outgoing,
            since,
        })
    }

    /// Until the owner lets go of it.
    pub(super) fn run(mut self) -> Result<B, UnoError> {
        loop {
            let seen = self.terminal.as_ref().map(Terminal::look).transpose()?.unwrap_or_default();
            self.who_came_and_went(seen)?;
            if seen.bytes && self.unseen.is_none() {
                self.carry_in()?;
            }
            self.board.run_for(SLICE)?;
            self.carry_out()?;
            if !self.obey_in_time()? {
                return Ok(self.board);
            }
        }
    }

    fn who_came_and_went(&mut self, seen: Seen) -> Result<(), UnoError> {
        let Some(terminal) = &self.terminal else { return Ok(()) };
        let mut happened = if seen.happened { terminal.happened()? } else { Vec::new() };
        if self.users == 0
            && happened.is_empty()
            && let Some(retired) = &self.retired
        {
            happened = retired.happened()?;
            if happened.contains(&Happened::Opened) {
                retired.link(&self.link)?;
                self.terminal = self.retired.take();
            }
        }
        let used = self.users > 0 || self.unseen.is_some() || happened.contains(&Happened::Opened);
        self.count(&happened);
        if used && let Some(terminal) = &self.terminal {
            let left = if happened.is_empty() { seen.left } else { terminal.look()?.left };
            let waits = !left && self.users == 0;
            self.unseen = if waits { Some(self.unseen.unwrap_or_else(Instant::now)) } else { None };
            if left {
                self.users = 0;
            } else if self.unseen.is_some_and(|since| since.elapsed() > EVENT) {
                // Events that are alike are reported as one: of two who had opened it, one is left.
                self.users = 1;
                self.unseen = None;
            }
        }
        if used && self.users == 0 && self.unseen.is_none() {
            // What was written before it was closed still goes out.
            while self.take_in()? > 0 {}
            self.outgoing.clear();
            let fresh = Terminal::new(&self.link)?;
            self.retired = self.terminal.replace(fresh);
        }
        Ok(())
    }

    /// Counts who has it open; whoever opens it first resets the board.
    fn count(&mut self, happened: &[Happened]) {
        for happened in happened {
            match happened {
                Happened::Opened => {
                    self.connections.fetch_add(1, Ordering::SeqCst);
                    self.users += 1;
                    if self.users == 1 && self.options.reset_on_open {
                        self.outgoing.clear();
                        self.board.reset_by_port();
                    }
                }
                Happened::Closed => self.users = self.users.saturating_sub(1),
            }
        }
    }

    fn carry_in(&mut self) -> Result<(), UnoError> {
        while self.board.on_wire() < WAITING && self.take_in()? > 0 {}
        Ok(())
    }

    fn take_in(&mut self) -> Result<usize, UnoError> {
        let mut room = [0; 64];
        let Some(terminal) = &self.terminal else { return Ok(0) };
        let count = terminal.read(&mut room)?;
        self.board.send(room.get(..count).unwrap_or_default());
        Ok(count)
    }

    /// Bytes for a port that is not open are lost, as on a real one.
    fn carry_out(&mut self) -> Result<(), UnoError> {
        let sent = self.board.take_sent();
        let is_open = self.users > 0 || self.unseen.is_some();
        let Some(terminal) = self.terminal.as_ref().filter(|_| is_open) else { return Ok(()) };
        self.outgoing.extend(sent);
        if self.unseen.is_some() {
            return Ok(());
        }
        while !self.outgoing.is_empty() {
            let taken = terminal.write(self.outgoing.make_contiguous())?;
            if taken == 0 {
                break;
            }
            self.outgoing.drain(..taken);
        }
        Ok(())
    }

    /// Obeys until the controller's next millisecond is due; false when it is to end.
    fn obey_in_time(&mut self) -> Result<bool, UnoError> {
        loop {
            let ahead = self.ahead();
            let command = if ahead.is_zero() {
                self.commands.try_recv().map_err(|why| why == TryRecvError::Disconnected)
            } else {
                self.commands.recv_timeout(ahead).map_err(|why| why == RecvTimeoutError::Disconnected)
            };
            match command {
                Ok(command) => self.obey(command)?,
                Err(ended) => return Ok(!ended),
            }
        }
    }

    /// How far the controller is before its time.
    fn ahead(&mut self) -> Duration {
        let Pace::Times(times) = self.options.pace else { return Duration::ZERO };
        let (moment, cycle) = self.since;
        let nanoseconds = (self.board.cycle() - cycle) * 125 / (2 * u64::from(times.max(1))); // 62.5 a cycle
        let (due, passed) = (Duration::from_nanos(nanoseconds), moment.elapsed());
        if passed > due + HOPELESS {
            self.since = (Instant::now(), self.board.cycle());
        }
        due.saturating_sub(passed)
    }

    fn obey(&mut self, command: Command<B>) -> Result<(), UnoError> {
        let done = match command {
            Command::With(what) => {
                what(&mut self.board);
                return Ok(());
            }
            Command::Unplug(done) => {
                self.terminal = None;
                self.retired = None;
                self.users = 0;
                self.unseen = None;
                self.outgoing.clear();
                // Gone already when it was unplugged before.
                drop(std::fs::remove_file(&self.link));
                done
            }
            Command::PlugIn(done) => {
                if self.terminal.is_none() {
                    self.terminal = Some(Terminal::new(&self.link)?);
                }
                done
            }
        };
        // No caller waits for the answer when the owner's thread has ended.
        let _ = done.send(());
        Ok(())
    }
}
