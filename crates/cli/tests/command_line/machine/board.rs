//! A board of the kit at a terminal, as far as a test needs one: it opens sessions, answers, and takes no time to
//! make a line. Its settings are all zero.

use std::os::fd::OwnedFd;
use std::sync::mpsc::{Receiver, channel};
use std::thread;
use std::time::Instant;

use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::fs::{Mode, OFlags, open};
use rustix::pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt};
use rustix::termios::{OptionalActions, tcgetattr, tcsetattr};

const STOP: u8 = 0x80;
const NO_SESSION: u16 = 0xFFFF;

/// A pair of terminals: the far end, the near end, and the name of that.
pub fn terminal() -> (OwnedFd, OwnedFd, String) {
    let far = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY | OpenptFlags::CLOEXEC).unwrap();
    grantpt(&far).unwrap();
    unlockpt(&far).unwrap();
    let name = ptsname(&far, Vec::new()).unwrap().into_string().unwrap();
    let near = open(&name, OFlags::RDWR | OFlags::NOCTTY | OFlags::CLOEXEC, Mode::empty()).unwrap();
    (far, near, name)
}

pub struct Board {
    pub port: String,
    /// When the first STOP has arrived.
    stopped: Receiver<Instant>,
    /// What is written before anybody reads is kept as long as one side is open.
    _cable: OwnedFd,
}

impl Board {
    /// One that answers, or one that says nothing to anybody.
    pub fn new(answers: bool) -> Self {
        let (machine, cable, port) = terminal();
        let mut raw = tcgetattr(&cable).unwrap();
        raw.make_raw();
        tcsetattr(&cable, OptionalActions::Now, &raw).unwrap();
        let (sender, stopped) = channel();
        thread::spawn(move || {
            let mut controller =
                Controller { answers, session: NO_SESSION, last: 0, head: 0, line: Vec::new() };
            loop {
                let patience = Timespec { tv_sec: 60, tv_nsec: 0 };
                let ready = poll(&mut [PollFd::new(&machine, PollFlags::IN)], Some(&patience));
                let mut bytes = [0; 256];
                let (Ok(1..), Ok(count)) = (ready, rustix::io::read(&machine, &mut bytes)) else { return };
                let now = Instant::now();
                for &byte in &bytes[..count] {
                    if byte == STOP && sender.send(now).is_err() {
                        return;
                    }
                    for answer in controller.hear(byte) {
                        let _ = rustix::io::write(&machine, answer.as_bytes());
                    }
                }
            }
        });
        Self { port, stopped, _cable: cable }
    }

    /// When the first STOP has arrived.
    pub fn stopped_at(&self) -> Instant {
        self.stopped.recv_timeout(std::time::Duration::from_secs(30)).expect("no STOP arrives")
    }
}

struct Controller {
    answers: bool,
    session: u16,
    last: u32,
    /// Where it counts its head, steps.
    head: i64,
    line: Vec<u8>,
}

impl Controller {
    fn hear(&mut self, byte: u8) -> Vec<String> {
        if byte == STOP {
            return self.sealed(&["x1".to_owned()]);
        }
        if byte != b'\n' {
            self.line.push(byte);
            return Vec::new();
        }
        let line = String::from_utf8_lossy(&std::mem::take(&mut self.line)).into_owned();
        let Some((payload, _)) = line.rsplit_once('*').filter(|_| self.answers) else { return Vec::new() };
        let (letter, rest) = payload.split_at(1);
        let first: u32 = rest.split(',').next().and_then(|field| field.parse().ok()).unwrap_or_default();
        let number =
            |at| rest.split(',').nth(at).and_then(|field| field.parse::<i64>().ok()).unwrap_or_default();
        let status = |head, last| vec![format!("t0,0,0,{head},0,{last},{last},0,0,1")];
        let answers = match letter {
            "S" => {
                (self.session, self.last) = (u16::try_from(first).unwrap(), 0);
                return vec![sealed(NO_SESSION, &format!("o{first},0,0,1,100,1,1"))];
            }
            "Q" => status(self.head, self.last),
            "Z" => {
                self.head = number(0);
                status(self.head, self.last)
            }
            "C" => vec![format!("v{first},0")],
            "M" | "H" if first == self.last + 1 => {
                self.last = first;
                self.head += if letter == "M" { number(2) } else { 0 };
                vec![format!("a{first},8"), format!("d{first}")]
            }
            "M" | "H" => vec![format!("a{},8", self.last)],
            _ => Vec::new(),
        };
        self.sealed(&answers)
    }

    fn sealed(&self, answers: &[String]) -> Vec<String> {
        answers.iter().map(|answer| sealed(self.session, answer)).collect()
    }
}

fn sealed(session: u16, answer: &str) -> String {
    format!("\n{answer}*{:04X}\n", checksum(session, answer.as_bytes()))
}

/// CRC-16 of polynomial 0x8408.
fn checksum(seed: u16, payload: &[u8]) -> u16 {
    payload.iter().fold(seed, |crc, &byte| {
        (0..8).fold(crc ^ u16::from(byte), |crc, _| (crc >> 1) ^ if crc & 1 == 1 { 0x8408 } else { 0 })
    })
}
