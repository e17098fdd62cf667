//! Figure: what is said of a bender on grbl that was stopped, against what its model does: its driver's process is lost in a
//! bend, or the line to it is dead when the stop is sent. The firmware's counterpart is `tests/firmware/tests/all/jobs/lost.rs`.

#![allow(clippy::print_stdout)] // figures, for --nocapture

use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::Mutex;
use std::time::{Duration, Instant};

use rustix::process::{Pid, Signal, kill_process};
use wirebend_tests_built::Loose;

use super::bender::Bender;
use super::runs::{LOOK, PATIENCE, Shop};
use crate::grbl_model::Now;
use crate::wirebend;

/// From the end of the driver to the first byte of the stop.
const AT_ONCE: Duration = Duration::from_millis(150);
/// What the computer may be busy with besides.
const GRACE: Duration = Duration::from_secs(1);
/// A driver that does not answer is ended then: what a poll may take.
const HUNG: Duration = Duration::from_secs(2);
/// Longer than any of these is waited for.
const FOR_EVER: Duration = Duration::MAX;
/// A model that has not moved for so long stands: it moves at each turn of its loop, of about a millisecond.
const STILL: Duration = Duration::from_millis(300);
/// Cases that are tried beside each other.
const AT_ONCE_TRIED: usize = 2;
/// The bend axis turns by 25° in a second.
const A_SECOND_DEG: f64 = 25.0;

const STANDS: &str = "the machine has confirmed that it stands";
const MAY_MOVE: &str = "the machine has NOT confirmed that it stands: cut its power";

/// What the bender does when something happens to it.
#[derive(Debug, Clone, Copy)]
enum During {
    Feed,
    /// In its first bend, a second after that has begun.
    Bend,
    /// The bend axis goes back.
    Return,
    Rotation,
}

impl During {
    const ALL: [Self; 4] = [Self::Feed, Self::Bend, Self::Return, Self::Rotation];

    fn is_so(self, now: &Now, farthest_deg: f64) -> bool {
        let [fed, turned, bent] = now.at;
        match self {
            Self::Feed => fed > 10.0,
            Self::Bend => now.pin_out && bent > A_SECOND_DEG,
            Self::Return => farthest_deg > 2.0 * A_SECOND_DEG && bent < farthest_deg - 10.0,
            Self::Rotation => turned.abs() > 10.0,
        }
    }
}

/// A wire in its middle.
struct Bending {
    shop: Shop,
    bender: Bender,
    program: Child,
}

impl Bending {
    fn new() -> Self {
        Self::with(&wirebend(), During::Bend)
    }

    fn with(program: &Path, during: During) -> Self {
        let (shop, bender) = (Shop::on("mirror-left.obj", "grbl-bender"), Bender::slow());
        let arguments = ["run", "a.wbjob", "--port", &bender.port, "--yes", "--axes-at-zero"];
        let mut program = Command::new(program);
        program.args(arguments).current_dir(shop.path());
        program.env("XDG_CONFIG_HOME", shop.path()).env("XDG_DATA_HOME", shop.path());
        program.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let program = program.spawn().unwrap();
        let (begun, mut farthest_deg) = (Instant::now(), 0.0);
        let mut now = bender.model.now();
        while !during.is_so(&now, farthest_deg) {
            assert!(begun.elapsed() < PATIENCE, "it does not get to the {during:?}: {now:?}");
            std::thread::sleep(LOOK);
            now = bender.model.now();
            farthest_deg = now.at[2].max(farthest_deg);
        }
        Self { shop, bender, program }
    }

    fn id(&self) -> Pid {
        Pid::from_raw(i32::try_from(self.program.id()).unwrap()).unwrap()
    }

    fn press_ctrl_c(&self) {
        kill_process(self.id(), Signal::INT).unwrap();
    }

    fn driver(&self) -> Pid {
        driver_of(&self.program)
    }

    /// Waits for the program, and compares what it says with what the machine does then and what the journal has. Gives
    /// when it has ended.
    #[track_caller]
    fn told_truly(self, status: i32, case: &str) -> (Bender, Instant) {
        let done = self.program.wait_with_output().unwrap();
        let ended = Instant::now();
        let said =
            format!("{}{}", String::from_utf8_lossy(&done.stderr), String::from_utf8_lossy(&done.stdout));
        let moves = moves(&self.bender, STILL);
        assert_eq!(done.status.code(), Some(status), "{case}: {said}");
        let stands = said.contains(STANDS);
        assert!(stands != said.contains(MAY_MOVE), "{case}: one of the two is said: {said}");
        assert!(!stands || !moves, "{case}: it is said to stand, and moves");
        assert_eq!(stands, status != 6, "{case}: {said}");
        assert!(said.contains("--resume"), "{case}: how to resume: {said}");
        let journal = std::fs::read_to_string(self.shop.journal()).unwrap();
        let written = format!("\"record\":\"standstill\",\"confirmed\":{stands}");
        assert!(journal.contains(&written), "{case}: {journal}");
        (self.bender, ended)
    }
}

/// The process of a program's driver. It is started by any thread of the program.
pub fn driver_of(program: &Child) -> Pid {
    let threads = std::fs::read_dir(format!("/proc/{}/task", program.id())).unwrap();
    let children = |thread: std::io::Result<std::fs::DirEntry>| {
        std::fs::read_to_string(thread.ok()?.path().join("children")).ok()
    };
    let all: String = threads.filter_map(children).collect();
    let first = all.split_whitespace().next().expect("a driver");
    Pid::from_raw(first.parse().unwrap()).unwrap()
}

/// Whether anything moves within a time.
pub fn moves(bender: &Bender, time: Duration) -> bool {
    let (begun, at) = (Instant::now(), bender.stands());
    while begun.elapsed() < time {
        if bender.stands() != at {
            return true;
        }
        std::thread::sleep(LOOK);
    }
    false
}

/// However its process ends, and where it does not: the machine is stopped, and it is not said before it stands.
#[test]
fn a_bender_whose_driver_is_lost_is_stopped() {
    for (how, signal, noticed) in [
        ("killed", Signal::KILL, Duration::ZERO),
        ("ended by a segmentation fault", Signal::SEGV, Duration::ZERO),
        ("aborted", Signal::ABORT, Duration::ZERO),
        ("ended", Signal::TERM, Duration::ZERO),
        ("hung", Signal::STOP, HUNG),
    ] {
        let bending = Bending::new();
        let lost = Instant::now();
        let driver = bending.driver();
        kill_process(driver, signal).unwrap();
        if signal == Signal::SEGV {
            // The first takes away the handler that Rust has for a full stack, and two at once count as one.
            while kill_process(driver, signal).is_ok() && lost.elapsed() < PATIENCE {
                std::thread::sleep(LOOK);
            }
        }
        let (bender, ended) = bending.told_truly(5, how);
        let took = bender.first_reset().expect("a reset").saturating_duration_since(lost);
        let said = ended - lost;
        println!("driver {how}: 0x18 at the port after {took:?}, said after {said:?}");
        assert!(took < noticed + AT_ONCE + GRACE, "{how}: {took:?}");
        let at = bender.model.now().at[2];
        // The bend goes to 92.36°, and the axis back to zero.
        let hung = noticed.as_secs_f64() * A_SECOND_DEG;
        assert!((A_SECOND_DEG..A_SECOND_DEG * 2.0 + hung).contains(&at), "{how}: it stands at {at}");
        assert_eq!(bender.model.end().bends.len(), 1, "{how}: in the middle of the first bend");
    }
}

/// Whatever it does, and wherever the wire is: it is the real driver until then.
#[test]
fn a_bender_whose_driver_misbehaves_is_stopped() {
    let cases = ["exit", "lie", "nonsense", "garbage"].into_iter();
    let left = Mutex::new(cases.flat_map(|how| During::ALL.map(|during| (how, during))));
    std::thread::scope(|scope| {
        for _ in 0..AT_ONCE_TRIED {
            scope.spawn(|| {
                loop {
                    let Some((how, during)) = left.lock().unwrap().next() else { return };
                    misbehaves(how, during);
                }
            });
        }
    });
}

fn misbehaves(how: &str, during: During) {
    let case = format!("{how} in the {during:?}");
    let folder = tempfile::tempdir_in(env!("CARGO_TARGET_TMPDIR")).unwrap();
    let loose = Loose::new(folder.path(), "grbl", how);
    let bending = Bending::with(&loose.program, during);
    let lost = Instant::now();
    loose.let_loose();
    let (bender, _) = bending.told_truly(5, &case);
    let took = bender.first_reset().expect("a reset").saturating_duration_since(lost);
    println!("driver does {case}: 0x18 at the port after {took:?}");
    assert!(took < AT_ONCE + GRACE, "{case}: {took:?}");
}

/// A person sees that it hangs before the program does.
#[test]
fn ctrl_c_stops_a_bender_whose_driver_hangs() {
    let bending = Bending::new();
    kill_process(bending.driver(), Signal::STOP).unwrap();
    let pressed = Instant::now();
    bending.press_ctrl_c();
    let (bender, _) = bending.told_truly(130, "hangs");
    let took = bender.first_reset().expect("a reset").saturating_duration_since(pressed);
    println!("driver hung, then Ctrl-C: 0x18 at the port after {took:?}");
    // What a driver has for passing a stop on comes first.
    assert!(took < Duration::from_millis(100) + AT_ONCE + GRACE, "{took:?}");
}

/// The computer sleeps for longer than the bender has work. Nobody would expect it to begin again when the lid is opened.
#[test]
fn a_bender_is_sent_nothing_more_when_the_computer_has_slept() {
    let bending = Bending::new();
    kill_process(bending.id(), Signal::STOP).unwrap();
    std::thread::sleep(Duration::from_secs(11));
    let asleep = bending.bender.stands();
    kill_process(bending.id(), Signal::CONT).unwrap();
    let done = bending.program.wait_with_output().unwrap();
    let said = String::from_utf8_lossy(&done.stderr).into_owned();
    assert_eq!(done.status.code(), Some(130), "{said}");
    assert!(said.contains("it was not confirmed that the wire goes on: it was stopped"), "{said}");
    assert!(said.contains(STANDS), "{said}");
    assert_eq!(bending.bender.stands(), asleep, "it has moved on: {said}");
}

/// All that is sent to the machine is lost for a time, the stop with it.
#[test]
fn what_is_said_of_a_bender_after_a_stop_is_true_however_long_the_line_was_dead() {
    for (dead, status) in [
        (Duration::ZERO, 130),
        (Duration::from_millis(300), 130),
        (Duration::from_secs(1), 130),
        (Duration::from_secs(5), 130),
        (FOR_EVER, 6),
    ] {
        let bending = Bending::new();
        bending.bender.deafen(dead);
        let pressed = Instant::now();
        bending.press_ctrl_c();
        let case = if dead == FOR_EVER { "dead for ever".to_owned() } else { format!("dead for {dead:?}") };
        let (bender, ended) = bending.told_truly(status, &case);
        let said = ended - pressed;
        println!("line {case}: said after {said:?}");
        assert!(said > dead.min(Duration::from_secs(10)), "{case}: said after {said:?}");
        let heard = bender.model.end().resets > 0;
        assert_eq!(heard, status == 130, "{case}");
    }
}

/// It has stopped by itself, and is asked anyway.
#[test]
fn a_bender_with_a_closed_limit_switch_says_that_it_stands() {
    let bending = Bending::new();
    bending.bender.model.hit_limit();
    let (bender, _) = bending.told_truly(5, "limit");
    assert!(bender.model.resets() >= 1, "its alarm is answered");
}
