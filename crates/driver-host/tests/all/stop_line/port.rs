//! A port is a pair of terminals; what arrives at its other end is what a machine would hear.

use std::os::fd::OwnedFd;

use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::fs::{Mode, OFlags, fcntl_setfl, open};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{OptionalActions, tcgetattr, tcsetattr};

/// A terminal without a program at its other end.
pub struct Port {
    machine: OwnedFd,
    pub name: String,
    /// What is written before anybody reads is kept as long as one side is open.
    _cable: OwnedFd,
}

impl Port {
    pub fn new() -> Self {
        let machine = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY | OpenptFlags::CLOEXEC).unwrap();
        grantpt(&machine).unwrap();
        unlockpt(&machine).unwrap();
        let name = ptsname(&machine, Vec::new()).unwrap().into_string().unwrap();
        let cable = open(&name, OFlags::RDWR | OFlags::NOCTTY | OFlags::CLOEXEC, Mode::empty()).unwrap();
        let mut raw = tcgetattr(&cable).unwrap();
        raw.make_raw();
        tcsetattr(&cable, OptionalActions::Now, &raw).unwrap();
        fcntl_setfl(&machine, OFlags::NONBLOCK).unwrap();
        Self { machine, name, _cable: cable }
    }

    /// Pulls the cable. A process that another test is just starting has the machine's end too, until it runs.
    pub fn unplug(self) {
        let Self { machine, _cable: cable, .. } = self;
        drop(machine);
        let hung_up = |cable: &OwnedFd| {
            let mut looked = [PollFd::new(cable, PollFlags::empty())];
            poll(&mut looked, None).unwrap();
            looked[0].revents().contains(PollFlags::HUP)
        };
        while !hung_up(&cable) {}
    }

    /// What arrives, until there are so many bytes, or nothing comes for long.
    pub fn heard(&self, count: usize) -> Vec<u8> {
        let patience = Timespec { tv_sec: 20, tv_nsec: 0 };
        let mut bytes = Vec::new();
        while bytes.len() < count {
            let ready = poll(&mut [PollFd::new(&self.machine, PollFlags::IN)], Some(&patience)).unwrap();
            if ready == 0 {
                break;
            }
            bytes.append(&mut self.heard_so_far());
        }
        bytes
    }

    pub fn heard_so_far(&self) -> Vec<u8> {
        let mut bytes = vec![0; 4096];
        let count = rustix::io::read(&self.machine, bytes.as_mut_slice()).unwrap_or_default();
        bytes.truncate(count);
        bytes
    }
    /// What the machine says.
    pub fn says(&self, bytes: &[u8]) {
        assert_eq!(rustix::io::write(&self.machine, bytes), Ok(bytes.len()));
    }
}
