//! A simulated controller behind a pseudo-terminal, where a program opens it like an Arduino's port.
//!
//! A thread runs the controller and carries bytes between its serial line and the terminal; each byte takes its
//! time on the wire. The port is a link in a folder of its own, so that its name stays the same although every
//! connection gets a fresh terminal: one that was killed may have left its terminal locked.

mod behind;
mod runner;
mod terminal;

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Sender, channel};
use std::thread::JoinHandle;

use crate::error::UnoError;
use crate::uno::{Ram, ResetCause, Uno};
pub use behind::Behind;
use runner::{Command, Runner};

/// How fast the controller's time goes by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pace {
    /// So many seconds of the controller in one of ours, or as many as this computer can: 1 is real time.
    Times(u32),
    /// As fast as this computer can. The time limits of a driver count real time, those of the firmware the
    /// controller's: a host that asks every 250 ms may be taken for dead.
    AsFastAsItCan,
}

/// How the controller behaves behind its port.
#[derive(Clone, Copy, Debug)]
pub struct Options {
    /// How fast its time goes by.
    pub pace: Pace,
    /// Opening the port resets the controller, as it does an Uno. The boot loader, which listens for a second
    /// there, is not simulated.
    pub reset_on_open: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self { pace: Pace::Times(1), reset_on_open: true }
    }
}

/// A controller that runs in a thread behind a port: an [`Uno`], or another that is [`Behind`] one.
pub struct OnPty<B = Uno> {
    commands: Sender<Command<B>>,
    thread: JoinHandle<Result<B, UnoError>>,
    port: PathBuf,
    connections: Arc<AtomicU64>,
    /// The folder of the link.
    _folder: tempfile::TempDir,
}

impl Uno {
    /// Runs this controller in a thread, its serial line on a pseudo-terminal.
    ///
    /// # Errors
    /// When the terminal cannot be created.
    pub fn on_pty(self, options: Options) -> Result<OnPty, UnoError> {
        OnPty::new(self, options)
    }
}

impl OnPty {
    /// Resets the controller; a program that has opened the port keeps it open.
    ///
    /// # Errors
    /// As [`Self::with`].
    pub fn reset(&self, cause: ResetCause, ram: Ram) -> Result<(), UnoError> {
        self.with(move |uno| uno.reset(cause, ram))
    }
}

impl<B: Behind> OnPty<B> {
    /// Runs a controller in a thread, its serial line on a pseudo-terminal.
    ///
    /// # Errors
    /// When the terminal cannot be created.
    pub fn new(board: B, options: Options) -> Result<Self, UnoError> {
        let failed = |why| UnoError::Terminal { doing: "making a folder for the port", why };
        let folder = tempfile::tempdir().map_err(failed)?;
        let port = folder.path().join("port");
        let connections = Arc::new(AtomicU64::new(0));
        let (commands, to_do) = channel();
        let runner = Runner::new(board, options, port.clone(), to_do, Arc::clone(&connections))?;
        let thread = std::thread::spawn(move || runner.run());
        Ok(Self { commands, thread, port, connections, _folder: folder })
    }

    /// The port to open. While it is unplugged there is nothing of that name.
    #[must_use]
    pub fn port(&self) -> &Path {
        &self.port
    }

    /// How often the port has been opened.
    #[must_use]
    pub fn connections(&self) -> u64 {
        self.connections.load(Ordering::SeqCst)
    }

    /// Does something with the controller between two of its milliseconds, and waits for it.
    ///
    /// # Errors
    /// When the controller has ended; [`Self::stop`] says why.
    pub fn with<T: Send + 'static>(
        &self,
        what: impl FnOnce(&mut B) -> T + Send + 'static,
    ) -> Result<T, UnoError> {
        let (done, answer) = channel();
        // There is no listener any more when the caller's thread has ended, which does no harm.
        let work = Box::new(move |board: &mut B| drop(done.send(what(board))));
        self.command(Command::With(work))?;
        answer.recv().map_err(|_| UnoError::Ended)
    }

    /// Pulls the cable: a program that has opened the port loses it. The controller keeps running, as one with a supply of
    /// its own does; what it sends is lost.
    ///
    /// # Errors
    /// As [`Self::with`].
    pub fn unplug(&self) -> Result<(), UnoError> {
        let (done, answer) = channel();
        self.command(Command::Unplug(done))?;
        answer.recv().map_err(|_| UnoError::Ended)
    }

    /// Plugs the cable in again: the port is there to be opened.
    ///
    /// # Errors
    /// When the controller has ended or the terminal cannot be created; [`Self::stop`] says why.
    pub fn plug_in(&self) -> Result<(), UnoError> {
        let (done, answer) = channel();
        self.command(Command::PlugIn(done))?;
        answer.recv().map_err(|_| UnoError::Ended)
    }

    /// Ends the thread and gives the controller back, with all of it that was not taken.
    ///
    /// # Errors
    /// When the program of the controller crashed, or the terminal failed.
    pub fn stop(self) -> Result<B, UnoError> {
        drop(self.commands);
        self.thread.join().unwrap_or(Err(UnoError::Ended))
    }

    fn command(&self, command: Command<B>) -> Result<(), UnoError> {
        self.commands.send(command).map_err(|_| UnoError::Ended)
    }
}
