//! One interruption: what happens, what must not move, and what the journal says then.

use std::fmt;

use rustix::process::{Signal, kill_process};

use super::end::Went;
use super::job::{GEARS, Job};
use crate::jobs::at_port::AtPort;
use crate::jobs::bender::{Moment, Phase, lines};
use crate::jobs::shop::{Ran, Running};
use wirebend_tests_firmware::board::{Board, HZ, MS, Reset};

/// How a job is interrupted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum What {
    /// The program is killed, and takes its driver with it.
    ProgramKilled,
    /// The driver's process is killed: the program stops the machine itself.
    DriverKilled,
    /// The reset pin of the controller is touched.
    ControllerReset,
    /// The cable is pulled; the controller keeps its power.
    CablePulled,
    /// The cable is pulled and the power goes.
    PowerLost,
    /// A person presses Ctrl-C.
    Stopped,
}

impl What {
    /// Each with whether opening the port resets the board: no, yes, or both in turn.
    pub const ALL: [(Self, Option<bool>); 7] = [
        (Self::ProgramKilled, Some(false)),
        (Self::DriverKilled, Some(false)),
        (Self::ControllerReset, None),
        (Self::CablePulled, Some(false)),
        (Self::PowerLost, Some(true)),
        (Self::Stopped, None),
        // An Uno: its port is opened anew, and it has forgotten all.
        (Self::ProgramKilled, Some(true)),
    ];
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Case {
    pub what: What,
    /// Line of the job, from 0, and where in it.
    pub line: usize,
    pub phase: Phase,
    pub percent: usize,
    pub reset_on_open: bool,
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { what, line, phase, percent, reset_on_open } = self;
        let opened = if *reset_on_open { ", reset when opened" } else { "" };
        write!(f, "{what:?} in line {} at {percent} % of {phase:?}{opened}", line + 1)
    }
}

/// Without a valid frame for so long, no other line begins: a second and a tick of the firmware's clock.
const HOST_LOST: u64 = HZ + 25 * MS;

impl Case {
    /// Tries it; says how it went.
    pub fn try_on<B: Board + Send + 'static>(&self, job: &Job) -> Went {
        let moment = Moment::of(&job.whole().pulses, self.line, self.phase, self.percent);
        let runs = format!("{}-{self}", B::NAME).replace([' ', ',', '%'], "-");
        let at = AtPort::<B>::new(GEARS, Some(&job.stored), self.reset_on_open);
        let file = job.file.to_str().unwrap();
        let running = job.shop.start(&runs, &["run", file, "--port", &at.port, "--yes"]);
        let (since, ran) = self.interrupt(&at, moment, running);
        self.check_end(&ran);
        at.until_still();
        self.check_quiet(&at, since);
        self.go_on(job, &at, &runs)
    }

    /// Gives the cycle from which on nothing is heard of the program.
    fn interrupt<B: Board + Send + 'static>(
        &self,
        at: &AtPort<B>,
        moment: Moment,
        running: Running,
    ) -> (u64, Ran) {
        let what = self.what;
        let hears = at.at(moment, move |bender| match what {
            What::ControllerReset => bender.reset(Reset::External),
            What::PowerLost => bender.reset(Reset::PowerOn),
            _ => {}
        });
        running.reached(&hears);
        match what {
            What::ProgramKilled => running.kill(Signal::KILL),
            What::DriverKilled => kill_process(running.driver(), Signal::KILL).unwrap(),
            What::CablePulled | What::PowerLost => at.board.unplug().unwrap(),
            What::Stopped => running.kill(Signal::INT),
            What::ControllerReset => {}
        }
        let since = at.with(|bender| bender.board.now());
        let ran = running.wait();
        if matches!(what, What::CablePulled | What::PowerLost) {
            // What a cable that is plugged in again does to the board, opening it does, too.
            at.until_still();
            at.board.plug_in().unwrap();
        }
        (since, ran)
    }

    fn check_end(&self, ran: &Ran) {
        let told = format!("{}\n{}", ran.err, ran.out);
        match self.what {
            What::ProgramKilled => assert_eq!(ran.status.code(), None),
            What::Stopped => assert_eq!(ran.status.code(), Some(130), "{told}"),
            // Nothing reaches it any more, and it cannot report whether it stands.
            What::CablePulled | What::PowerLost => assert_eq!(ran.status.code(), Some(6), "{told}"),
            _ => assert_eq!(ran.status.code(), Some(5), "{told}"),
        }
        if matches!(self.what, What::Stopped | What::DriverKilled | What::ControllerReset) {
            assert!(told.contains("the machine has confirmed that it stands"), "{told}");
        }
        if self.what != What::ProgramKilled {
            assert!(told.contains("--resume"), "it does not say how to resume: {told}");
        }
    }

    /// Nothing moves that should not.
    fn check_quiet<B: Board + Send + 'static>(&self, at: &AtPort<B>, since: u64) {
        let what = self.what;
        at.with(move |bender| {
            if matches!(what, What::Stopped | What::DriverKilled) {
                assert_eq!(bender.stopped().1, 0, "pulses after the STOP");
            }
            match what {
                What::Stopped => {}
                What::ControllerReset | What::PowerLost => {
                    let last = bender.pulses.last().unwrap().at;
                    assert!(last <= since, "it moves {} cycles after the reset", last - since);
                }
                _ => {
                    let job = bender.pulses.job();
                    let begun = lines(job).last().map(|line| job[line.start].at).unwrap();
                    assert!(begun <= since + HOST_LOST, "a line begins {} cycles later", begun - since);
                }
            }
        });
    }
}
