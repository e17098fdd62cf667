//! The bench itself: a small program on the simulated Uno shows that the simulator's traps are handled. What fails
//! here makes every finding about the firmware doubtful.

mod errors;
mod memory;
mod pins;
mod reset;
mod servo;
mod terminal;
mod wire;

use wirebend_tests_firmware::{HZ, PinChange, Port, Uno, probe};

const MILLISECOND: u64 = HZ / 1000;

/// The probe, its boot line sent and taken away.
fn started() -> Uno {
    let mut uno = Uno::new(&probe()).unwrap();
    assert!(said(&mut uno).starts_with("B01"), "the program does not start");
    uno.pins();
    uno
}

/// What it says in the next twenty milliseconds.
fn said(uno: &mut Uno) -> String {
    uno.run_for(20 * MILLISECOND).unwrap();
    uno.received().into_iter().map(|(_, byte)| char::from(byte)).collect()
}

/// What it answers.
fn asked(uno: &mut Uno, command: &[u8]) -> String {
    uno.send(command);
    said(uno)
}

/// Cycles at which a pin got this level.
fn edges(pins: &[PinChange], port: Port, bit: u8, level: bool) -> Vec<u64> {
    let wanted = |pin: &&PinChange| pin.port == port && pin.bit == bit && pin.level == level;
    pins.iter().filter(wanted).map(|pin| pin.cycle).collect()
}
