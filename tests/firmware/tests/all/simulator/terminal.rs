//! The controller behind a pseudo-terminal, opened as a driver opens a port.

use std::fs::File;
use std::io::{Read, Write};
use std::time::{Duration, Instant};

use serialport::TTYPort;
use wirebend_tests_firmware::{OnPty, Options, Pace, Port, Ram, ResetCause, UnoError};

use super::{edges, started};

/// Nothing waits as long as this when all is well.
const DEADLINE: Duration = Duration::from_mins(1);

fn on_pty(reset_on_open: bool) -> OnPty {
    started().on_pty(Options { pace: Pace::Times(4), reset_on_open }).unwrap()
}

/// Opened as soon as it is there: after a close, a fresh terminal takes its place.
fn open(bench: &OnPty) -> TTYPort {
    let begin = Instant::now();
    loop {
        match serialport::new(bench.port().to_str().unwrap(), 115_200).timeout(DEADLINE).open_native() {
            Ok(port) => return port,
            Err(why) => assert!(begin.elapsed() < DEADLINE, "{why}"),
        }
    }
}

fn read(port: &mut TTYPort, count: usize) -> String {
    let mut bytes = vec![0; count];
    port.read_exact(&mut bytes).unwrap();
    String::from_utf8(bytes).unwrap()
}

#[test]
fn opening_the_port_resets_the_controller_and_it_answers() {
    let bench = on_pty(true);
    for connection in 1..=3 {
        let mut port = open(&bench);
        assert!(read(&mut port, 5).starts_with("B02"), "connection {connection}");
        port.write_all(b"HELLO").unwrap();
        assert_eq!(read(&mut port, 5), "HELLO");
        assert_eq!(bench.connections(), connection);
    }
    bench.stop().unwrap();
}

/// A close and an open that come at once fall into any place between two looks of the controller's thread.
#[test]
fn a_port_that_is_opened_again_at_once_resets_the_controller_again() {
    let bench = on_pty(true);
    for connection in 1..=5_000 {
        let mut port = open(&bench);
        let mut said = [0; 5];
        let heard = port.read_exact(&mut said);
        assert!(heard.is_ok() && said.starts_with(b"B02"), "connection {connection}: {heard:?}");
        assert_eq!(bench.connections(), connection);
    }
    bench.stop().unwrap();
}

#[test]
fn every_byte_comes_through_as_it_is() {
    let bench = on_pty(true);
    let mut port = open(&bench);
    read(&mut port, 5);
    // A terminal that is not raw would change line ends, swallow 0x03 and 0x11, and echo.
    let bytes: Vec<u8> = (0..=255).filter(|byte: &u8| !byte.is_ascii_lowercase()).collect();
    port.write_all(&bytes).unwrap();
    let mut echo = vec![0; bytes.len()];
    port.read_exact(&mut echo).unwrap();
    assert_eq!(echo, bytes);
    assert_eq!(bench.with(|uno| uno.overruns()).unwrap(), 0);
}

#[test]
fn the_terminal_is_raw_before_its_user_sets_it_up() {
    let bench = on_pty(false);
    let mut port = File::options().read(true).write(true).open(bench.port()).unwrap();
    let bytes = b"\r\n\x03\x04\x11\x13\x1A\x7F\xFFQ";
    port.write_all(bytes).unwrap();
    let mut echo = vec![0; bytes.len()];
    port.read_exact(&mut echo).unwrap();
    assert_eq!(echo, bytes);
}

#[test]
fn each_connection_gets_a_fresh_terminal() {
    let bench = on_pty(true);
    let first = std::fs::read_link(bench.port()).unwrap();
    drop(open(&bench));
    let begin = Instant::now();
    while std::fs::read_link(bench.port()).unwrap() == first {
        assert!(begin.elapsed() < DEADLINE, "a terminal that was left locked would be opened again");
    }
}

#[test]
fn without_reset_on_open_it_goes_on_as_it_was() {
    let bench = on_pty(false);
    let mut port = open(&bench);
    port.write_all(b"p").unwrap();
    assert_eq!(read(&mut port, 1), "p");
}

#[test]
fn a_reset_leaves_the_port_open() {
    let bench = on_pty(true);
    let mut port = open(&bench);
    read(&mut port, 5);
    bench.reset(ResetCause::BrownOut, Ram::Kept).unwrap();
    assert!(read(&mut port, 5).starts_with("B04"));
}

#[test]
fn a_cable_that_is_pulled_is_an_error_to_its_user_and_can_be_plugged_in_again() {
    let bench = on_pty(true);
    let mut port = open(&bench);
    read(&mut port, 5);
    bench.unplug().unwrap();
    assert!(port.read(&mut [0]).is_err());
    assert!(!bench.port().exists());
    bench.plug_in().unwrap();
    let mut port = open(&bench);
    assert!(read(&mut port, 5).starts_with("B02"));
    bench.stop().unwrap();
    assert!(port.read(&mut [0]).is_err());
}

#[test]
fn pin_changes_are_there_when_it_is_stopped() {
    let bench = on_pty(true);
    let mut port = open(&bench);
    read(&mut port, 5);
    bench.with(|uno| drop(uno.pins())).unwrap();
    port.write_all(b"aQ").unwrap(); // 100 steps of 0.5 ms
    assert_eq!(read(&mut port, 1), "Q");
    let begin = Instant::now();
    let start = bench.with(|uno| uno.cycle()).unwrap();
    while bench.with(|uno| uno.cycle()).unwrap() < start + 100 * 8000 + 40_000 {
        assert!(begin.elapsed() < DEADLINE);
    }
    let mut uno = bench.stop().unwrap();
    let pins = uno.pins();
    assert_eq!(edges(&pins, Port::D, 2, true).len(), 100);
    uno.run_for(1).unwrap();
}

#[test]
fn as_fast_as_it_can_it_also_answers() {
    let options = Options { pace: Pace::AsFastAsItCan, reset_on_open: true };
    let bench = started().on_pty(options).unwrap();
    let mut port = open(&bench);
    assert!(read(&mut port, 5).starts_with("B02"));
    port.write_all(b"p").unwrap();
    assert_eq!(read(&mut port, 1), "p");
}

#[test]
fn a_crash_closes_the_port_and_is_told_at_the_end() {
    let bench = on_pty(true);
    let mut port = open(&bench);
    read(&mut port, 5);
    port.write_all(b"j").unwrap();
    assert!(port.read(&mut [0]).is_err());
    assert!(matches!(bench.reset(ResetCause::External, Ram::Kept), Err(UnoError::Ended)));
    assert!(matches!(bench.stop(), Err(UnoError::Crashed { .. })));
}

#[test]
fn a_port_that_cannot_be_made_is_told_at_the_end() {
    let bench = on_pty(true);
    bench.unplug().unwrap();
    std::fs::remove_dir(bench.port().parent().unwrap()).unwrap();
    assert!(matches!(bench.plug_in(), Err(UnoError::Ended)));
    assert!(matches!(bench.stop(), Err(UnoError::Terminal { .. })));
}
