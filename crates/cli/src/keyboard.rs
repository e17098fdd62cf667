//! A person's keyboard, and its Enter key while a machine bends a wire. That is looked for between two turns of the
//! machine's loop and never waited for, and only a terminal is read: what is piped to the program belongs to others.

use std::io::IsTerminal;

/// Whether a person reads and writes.
pub(crate) fn is_there() -> bool {
    std::io::stdin().is_terminal() && std::io::stderr().is_terminal()
}

/// Whether a person has pressed Enter at the terminal since the last time. Takes the line that it ends.
#[cfg(unix)]
pub(crate) fn takes_enter() -> bool {
    use std::io::BufRead;

    use rustix::event::{PollFd, PollFlags, Timespec, poll};

    if !is_there() {
        return false;
    }
    let input = std::io::stdin();
    let mut typed = [PollFd::new(&input, PollFlags::IN)];
    let at_once = Timespec { tv_sec: 0, tv_nsec: 0 };
    let is_typed = poll(&mut typed, Some(&at_once)).is_ok_and(|ready| ready > 0);
    if !is_typed || !is_in_foreground() {
        return false;
    }
    let mut line = String::new();
    // A terminal gives whole lines, and one for each time that it is read. One that was closed gives nothing, again and again.
    input.lock().read_line(&mut line).is_ok_and(|bytes| bytes > 0) && line.trim().is_empty()
}

/// A shell stops a program of the background that reads its terminal, in the middle of a wire.
#[cfg(unix)]
fn is_in_foreground() -> bool {
    // A terminal without jobs has no foreground.
    rustix::termios::tcgetpgrp(std::io::stdin()).map_or(true, |group| group == rustix::process::getpgrp())
}

/// Consoles of other systems cannot be asked whether a line was typed.
#[cfg(not(unix))]
pub(crate) const fn takes_enter() -> bool {
    false
}

/// Whether Enter is listened to, so that a person may be told.
pub(crate) fn hears_enter() -> bool {
    cfg!(unix) && is_there()
}
