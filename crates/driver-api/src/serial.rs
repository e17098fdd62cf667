//! Serial ports, for drivers that move machines: opened with an error that helps, read without waiting.

mod listing;

use std::io::{self, Read, Write};
use std::time::Duration;

use serialport::{ErrorKind, SerialPort};

use crate::DriverError;
pub use listing::ports;

/// A line to a machine: a serial port, or what stands in for one in a test.
pub trait Line {
    /// What has come since the last time; empty when nothing has. Does not wait.
    ///
    /// # Errors
    /// When the line is gone, as when a cable is pulled.
    fn read(&mut self) -> io::Result<Vec<u8>>;

    /// Sends bytes, all of them.
    ///
    /// # Errors
    /// When the line is gone or takes nothing for 50 ms.
    fn write(&mut self, bytes: &[u8]) -> io::Result<()>;
}

/// How long the system may take to say that no bytes have come.
const READ_PATIENCE: Duration = Duration::from_millis(1);
/// How long it may take nothing. A stop has to be passed on within [`deadline::STOP`](crate::deadline::STOP),
/// and half of that is left for all else.
const WRITE_PATIENCE: Duration = Duration::from_millis(50);
/// The most that is read at once: at 115200 baud this is more than a third of a second.
const MAX_BYTES: usize = 4096;

struct Port(Box<dyn SerialPort>);

/// Opens a port with eight data bits, no parity and one stop bit.
///
/// # Errors
/// [`DriverError`] with the code `no-port`, `port-busy`, `port-denied` or `port`; it names the port and
/// says what to do.
pub fn open(port: &str, baud: u32) -> Result<Box<dyn Line>, DriverError> {
    let opened = serialport::new(port, baud).timeout(READ_PATIENCE).open();
    opened.map(|opened| Box::new(Port(opened)) as Box<dyn Line>).map_err(|error| refusal(port, &error))
}

fn refusal(port: &str, error: &serialport::Error) -> DriverError {
    let (code, what, help) = match error.kind() {
        ErrorKind::Io(io::ErrorKind::PermissionDenied) => (
            "port-denied",
            format!("this user may not open the port '{port}'"),
            "on Linux add this user to the group that serial ports belong to, dialout on Debian and Ubuntu, then log in again",
        ),
        // A port that another program has locked is reported as if it were not there.
        ErrorKind::NoDevice if is_there(port) => (
            "port-busy",
            format!("the port '{port}' is used by another program"),
            "close the program that has it open, such as a serial monitor",
        ),
        ErrorKind::NoDevice | ErrorKind::Io(io::ErrorKind::NotFound) => (
            "no-port",
            format!("there is no port '{port}'"),
            "plug the machine in, and see which ports the system has",
        ),
        _ => (
            "port",
            format!("the port '{port}' cannot be opened: {error}"),
            "unplug the machine and plug it in again",
        ),
    };
    DriverError::new(code, what, help)
}

/// Whether the system has a port of this name, whoever has it open.
fn is_there(port: &str) -> bool {
    let listed =
        || serialport::available_ports().unwrap_or_default().iter().any(|known| known.port_name == port);
    std::path::Path::new(port).exists() || listed()
}

impl Line for Port {
    fn read(&mut self) -> io::Result<Vec<u8>> {
        let mut bytes = vec![0; MAX_BYTES];
        match self.0.read(&mut bytes) {
            Ok(0) => Err(io::ErrorKind::UnexpectedEof.into()),
            Ok(count) => {
                bytes.truncate(count);
                Ok(bytes)
            }
            Err(error) if matches!(error.kind(), io::ErrorKind::TimedOut | io::ErrorKind::Interrupted) => {
                Ok(Vec::new())
            }
            Err(error) => Err(error),
        }
    }

    fn write(&mut self, bytes: &[u8]) -> io::Result<()> {
        // The port has one patience for both.
        self.0.set_timeout(WRITE_PATIENCE)?;
        let written = self.0.write_all(bytes);
        // Whatever has become of it, reads do not wait for as long.
        let set_back = self.0.set_timeout(READ_PATIENCE);
        written.and(set_back.map_err(io::Error::from))
    }
}

#[cfg(all(test, unix))]
mod tests {
    use std::time::Instant;

    use serialport::TTYPort;

    use super::*;

    /// A user who reads that there is no such port looks at the cable, and not for the other program.
    #[test]
    fn a_port_that_is_in_use_is_told_from_one_that_is_not_there() {
        let (_other_end, port) = TTYPort::pair().unwrap();
        let name = port.name().unwrap();
        drop(port);
        let _first = open(&name, 115_200).unwrap();
        assert_eq!(open(&name, 115_200).err().unwrap().code, "port-busy");
        assert_eq!(open("/dev/ttyNONE7", 115_200).err().unwrap().code, "no-port");
    }

    /// A machine that is busy for a few milliseconds is still there; reads must not wait for as long.
    #[test]
    fn a_write_is_given_more_time_than_a_read() {
        // The other end does not read: the line takes bytes until it is full.
        let (_other_end, port) = TTYPort::pair().unwrap();
        let mut port = Port(Box::new(port));
        port.0.set_timeout(READ_PATIENCE).unwrap();
        let error = loop {
            let begin = Instant::now();
            // One at a time, since the system waits without end for room for the rest of several.
            if let Err(error) = port.write(b"x") {
                assert!(begin.elapsed() >= Duration::from_millis(50), "given up after {:?}", begin.elapsed());
                break error;
            }
            assert_eq!(port.0.timeout(), READ_PATIENCE, "what reads wait for, after a write");
        };
        assert_eq!(error.kind(), io::ErrorKind::TimedOut);
        assert_eq!(port.0.timeout(), READ_PATIENCE, "what reads wait for, after a write that failed");
        assert_eq!(port.read().unwrap(), b"");
    }
}
