#![cfg(target_os = "linux")] // terminals are made as Linux makes them

use std::os::fd::OwnedFd;
use std::sync::Barrier;

use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::fs::{Mode, OFlags, open};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{OptionalActions, tcgetattr, tcsetattr};

use super::*;

const STOP: u8 = 0x80;
const REPLY: &str = "x1*";

/// The machine's end of a cable, and the name of the port at the other.
fn cable() -> (OwnedFd, OwnedFd, String) {
    let machine = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY | OpenptFlags::CLOEXEC).unwrap();
    grantpt(&machine).unwrap();
    unlockpt(&machine).unwrap();
    let name = ptsname(&machine, Vec::new()).unwrap().into_string().unwrap();
    let port = open(&name, OFlags::RDWR | OFlags::NOCTTY | OFlags::CLOEXEC, Mode::empty()).unwrap();
    let mut raw = tcgetattr(&port).unwrap();
    raw.make_raw();
    tcsetattr(&port, OptionalActions::Now, &raw).unwrap();
    (machine, port, name)
}

/// The machine answers the first stop that it hears, and no other.
fn answers_once(machine: &OwnedFd) {
    let mut looked = [PollFd::new(machine, PollFlags::IN)];
    let patience = Timespec { tv_sec: 60, tv_nsec: 0 };
    assert_eq!(poll(&mut looked, Some(&patience)).unwrap(), 1, "no stop was heard");
    rustix::io::write(machine, REPLY.as_bytes()).unwrap();
}

#[test]
fn a_loss_that_several_threads_notice_is_confirmed_by_one_reply() {
    for round in 0..300 {
        let (machine, _port, name) = cable();
        let guard = Guard::default();
        guard.use_line(StopLine::open(&name, &[STOP], REPLY).unwrap());
        guard.stop_begins();
        let together = Barrier::new(5);
        thread::scope(|scope| {
            for _ in 0..4 {
                scope.spawn(|| {
                    together.wait();
                    guard.driver_is_lost();
                });
            }
            together.wait();
            answers_once(&machine);
        });
        let awaited = |known: &mut Known| known.standstill == Some(Standstill::Awaited);
        let patience = Duration::from_mins(1);
        let settled = guard.0.settled.wait_timeout_while(guard.lock(), patience, awaited).unwrap();
        drop(settled);
        assert_eq!(guard.standstill(), Some(Standstill::Confirmed), "round {round}");
    }
}
