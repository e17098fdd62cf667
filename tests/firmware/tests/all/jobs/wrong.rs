//! Ports that are no machine, machines that are not as the profile says, and two programs at one port.

use rustix::process::Signal;
use serde_json::json;
use wirebend_driver_wirebend_kit::protocol::{Lines, NO_SESSION, sealed};
use wirebend_tests_firmware::{Behind, OnPty, Options, Port, Uno, UnoError, firmware};

use crate::jobs::at_port::AtPort;
use crate::jobs::bender::{Moment, ways};
use crate::jobs::interrupted::{GEARS, Job, MACHINE, coarse};
use crate::jobs::shop::{Running, Shop, example, shared};
use wirebend_tests_firmware::board::{Host, MS};

/// Where the stored settings end.
const SETTINGS_END: usize = 102;

type Answer = Box<dyn FnMut(&[u8]) -> Vec<u8> + Send>;

/// What is behind a port instead of the machine.
#[derive(Default)]
struct Other {
    now: u64,
    say: Vec<u8>,
    answer: Option<Answer>,
    /// Says this all the time.
    noise: Option<u64>,
}

impl Behind for Other {
    fn cycle(&self) -> u64 {
        self.now
    }

    fn run_for(&mut self, cycles: u64) -> Result<(), UnoError> {
        self.now += cycles;
        if let Some(state) = &mut self.noise {
            // Ten bytes a millisecond are a full line; Knuth's generator.
            for _ in 0..10 * cycles / MS {
                *state =
                    state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                self.say.push(state.to_be_bytes()[0]);
            }
        }
        Ok(())
    }

    fn send(&mut self, bytes: &[u8]) {
        if let Some(answer) = &mut self.answer {
            self.say.extend(answer(bytes));
        }
    }

    fn on_wire(&self) -> u64 {
        0
    }

    fn take_sent(&mut self) -> Vec<u8> {
        std::mem::take(&mut self.say)
    }

    fn reset_by_port(&mut self) {}
}

/// A firmware of a later protocol opens a session.
fn of_later_protocol() -> impl FnMut(&[u8]) -> Vec<u8> + Send {
    let mut lines = Lines::default();
    move |bytes| {
        let heard: Vec<_> = bytes.iter().filter_map(|&byte| lines.feed(byte)).collect();
        let asked = heard.iter().filter_map(|line| line.payload.strip_prefix('S').map(str::to_owned));
        asked.flat_map(|id| sealed(&format!("o{id},0,0,2,250,1,7"), NO_SESSION)).collect()
    }
}

/// A person tries to run the job there.
fn run(job: &Job, runs: &str, port: &str) -> Running {
    job.shop.start(runs, &["run", job.file.to_str().unwrap(), "--port", port, "--yes"])
}

#[test]
fn a_port_that_is_no_machine_is_told_from_one() {
    let _others = shared();
    let job = Job::cube();
    let echo: Answer = Box::new(<[u8]>::to_vec);
    let others = [
        ("silent", Other::default(), "nothing that speaks the WireBend-kit protocol"),
        (
            "echo",
            Other { answer: Some(echo), ..Other::default() },
            "nothing that speaks the WireBend-kit protocol",
        ),
        (
            "noise",
            Other { noise: Some(1), ..Other::default() },
            "nothing that speaks the WireBend-kit protocol",
        ),
        (
            "later",
            Other { answer: Some(Box::new(of_later_protocol())), ..Other::default() },
            "flash the firmware that came with this program",
        ),
    ];
    let started = others.map(|(name, other, says)| {
        let port = OnPty::new(other, Options::default()).unwrap();
        let running = run(job, &format!("wrong-{name}"), port.port().to_str().unwrap());
        (port, running, says)
    });
    for (port, running, says) in started {
        running.wait().ended(5).says(says);
        drop(port);
    }
}

/// With the firmware of another machine a motor runs where a servo is sent to stand: what goes out on the pins and what
/// stays in the memory is as if no program had connected.
#[test]
fn a_board_with_the_firmware_of_another_machine_is_refused() {
    let _others = shared();
    let job = Job::cube();
    let mut clone = coarse();
    clone["id"] = json!("clone-kit");
    clone["driver"]["settings"]["firmware_machine"] = json!(2);
    let shop = Shop::new(&[coarse(), clone]);
    for (flashed, machine, advice) in [
        ("howtomechatronics", MACHINE, "make -C firmware flash MACHINE=wirebend-kit"),
        ("wirebend-kit", "clone-kit", "make -C firmware flash MACHINE=howtomechatronics"),
    ] {
        let board = Uno::new(&firmware(flashed)).unwrap().on_pty(Options::default()).unwrap();
        let port = board.port().to_str().unwrap();
        let before = board.with(Uno::eeprom).unwrap();
        let settings = ["machine-settings", "--machine", machine, "--port", port, "--write", "--yes"];
        shop.ran("r", &settings).ended(5).says("the board has the firmware for").says(advice);
        let home = ["jog", "--machine", machine, "--port", port, "--yes", "home"];
        shop.ran("r", &home).ended(5).says(advice);
        if machine == MACHINE {
            run(job, "other-machine", port).wait().ended(5).says(advice);
        }
        // The number of starts is counted up, before the settings and in the ring behind them.
        let (after, pins) = board.with(|uno| (uno.eeprom(), uno.pins())).unwrap();
        assert_eq!(after[2..SETTINGS_END], before[2..SETTINGS_END], "{flashed}: settings were stored");
        // D8 of the kit and D12 of the clone keep their drivers off.
        let off = [(Port::B, 0), (Port::B, 4)];
        let high: Vec<_> =
            pins.iter().filter(|pin| pin.level && !off.contains(&(pin.port, pin.bit))).collect();
        assert_eq!(high, Vec::<&wirebend_tests_firmware::PinChange>::new(), "{flashed}: a pin was moved");
    }
    // The firmware that the profile wants is taken, whichever it is.
    for (flashed, machine) in [("howtomechatronics", "clone-kit"), ("wirebend-kit", MACHINE)] {
        let board = Uno::new(&firmware(flashed)).unwrap().on_pty(Options::default()).unwrap();
        let port = board.port().to_str().unwrap();
        let settings = ["machine-settings", "--machine", machine, "--port", port, "--write", "--yes"];
        shop.ran("r", &settings).ended(0);
    }
}

#[test]
fn a_port_that_is_not_there_is_named() {
    let _others = shared();
    let job = Job::cube();
    run(job, "wrong-none", "/dev/ttyNONE7").wait().ended(5).says("there is no port '/dev/ttyNONE7'");
}

/// A bender with another gear would bend another wire.
#[test]
fn a_machine_with_other_settings_moves_only_when_a_person_says_so() {
    let _others = shared();
    let stored = &Job::cube().stored;
    let mut other = coarse();
    other["id"] = json!("other-kit");
    other["driver"]["settings"]["bend_steps_per_turn"] = json!(2200);
    let shop = Shop::new(&[other]);
    let job = shop.path("cube.wbjob");
    let job = job.to_str().unwrap();
    shop.ran("r", &["plan", &example("cube-8-edges.obj"), "--machine", "other-kit", "-o", job]).ended(0);
    let at = AtPort::<Host>::new(GEARS, Some(stored), true);
    shop.ran("r", &["run", job, "--port", &at.port, "--yes"])
        .ended(5)
        .says("bend_steps_per_rev is 2148 steps/rev, not 2200 steps/rev")
        .says("wirebend machine-settings --machine other-kit")
        .says("--accept-settings");
    assert_eq!(at.with(|bender| bender.pulses.len()), 0, "it has moved");
    let running = shop.start("r", &["run", job, "--port", &at.port, "--yes", "--accept-settings"]);
    running.reached(&at.at(Moment { pulses: 1, cycles: 0 }, |_| {}));
    running.kill(Signal::INT);
    running.wait().ended(130);
}

#[test]
fn damaged_settings_are_told_and_written_again() {
    let _others = shared();
    let job = Job::cube();
    let mut stored = job.stored.clone();
    // Both copies: one alone is made good by the other.
    for copy in [256, 512] {
        stored[copy + 10] ^= 0x04;
    }
    let at = AtPort::<Host>::new(GEARS, Some(&stored), true);
    let refused = run(job, "damaged", &at.port).wait().ended(5).says("damaged");
    refused.says(&format!("wirebend machine-settings --machine {MACHINE}")).says("--write");
    // Nor can a person have it otherwise: it is not known what its steps mean.
    let all_the_same = ["run", job.file.to_str().unwrap(), "--port", &at.port, "--yes", "--accept-settings"];
    job.shop.ran("damaged", &all_the_same).ended(5);
    assert_eq!(at.with(|bender| bender.pulses.len()), 0, "it has moved");
    let settings = ["machine-settings", "--machine", MACHINE, "--port", &at.port, "--write", "--yes"];
    job.shop.ran("damaged", &settings).ended(0);
    let running = run(job, "mended", &at.port);
    running.reached(&at.at(Moment { pulses: 1, cycles: 0 }, |_| {}));
    running.kill(Signal::INT);
    running.wait().ended(130);
}

/// What a program has left in the machine is not run by another, nor thrown away in silence.
#[test]
fn a_machine_in_the_middle_of_a_wire_takes_nothing_else() {
    let _others = shared();
    let job = Job::cube();
    let at = AtPort::<Host>::new(GEARS, Some(&job.stored), false);
    let running = run(job, "middle", &at.port);
    running.reached(&at.at(Moment { pulses: 400, cycles: 0 }, |_| {}));
    running.kill(Signal::KILL);
    running.wait();
    at.until_still();
    let before = at.with(|bender| bender.pulses.len());
    let jog = ["jog", "--machine", MACHINE, "--port", &at.port, "--yes", "f", "10"];
    job.shop.ran("middle", &jog).ended(5).says("lines of another session");
    assert_eq!(at.with(|bender| bender.pulses.len()), before, "it has moved");
    run(job, "middle", &at.port).wait().ended(2).says("--resume").says("--abandon");
}

#[test]
fn a_second_program_at_the_port_does_not_spoil_the_wire() {
    let _others = shared();
    let job = Job::cube();
    let at = AtPort::<Host>::new(GEARS, Some(&job.stored), true);
    let running = run(job, "first", &at.port);
    running.reached(&at.at(Moment { pulses: 300, cycles: 0 }, |_| {}));
    run(job, "second", &at.port).wait().ended(5).says("is used by another program");
    // A program that shares its journals knows more, and does not call it interrupted.
    let at_work = "bends the wire 'cube' on the machine at";
    run(job, "first", &at.port).wait().ended(5).says(at_work);
    let jog = ["jog", "--machine", MACHINE, "--port", &at.port, "--yes", "home"];
    job.shop.ran("first", &jog).ended(5).says(at_work);
    for option in ["--resume", "--abandon"] {
        let ran =
            job.shop.ran("first", &["run", job.file.to_str().unwrap(), "--port", &at.port, "--yes", option]);
        ran.ended(5).says("another window of this one, bends this wire");
    }
    running.wait().ended(0);
    let pulses = at.with(|bender| bender.pulses.job().to_vec());
    assert_eq!(ways(&pulses), ways(&job.whole().pulses));
}
