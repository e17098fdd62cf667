//! Which ports this computer has, and at which of them a machine is likely.

use std::path::Path;

use serialport::{SerialPortInfo, SerialPortType, UsbPortInfo};

use crate::{DriverError, Port, Usb};

/// Chips that the boards of benders are plugged in with: vendor, product, what people call it. The numbers are
/// assigned by USB-IF to the vendors, who document their products'.
const KNOWN: &[(u16, u16, &str)] = &[
    (0x2341, 0x0043, "Arduino Uno"),
    (0x2341, 0x0001, "Arduino Uno, first edition"),
    (0x2341, 0x0243, "Arduino Uno, sold as Genuino"),
    (0x1a86, 0x7523, "CH340 chip, as on copies of the Arduino Uno and Nano"),
    (0x0403, 0x6001, "FTDI FT232 chip, as on older Arduino boards and cables"),
    (0x10c4, 0xea60, "CP210x chip, as on ESP32 boards"),
];

/// Where Linux shows its terminals.
const TERMINALS: &str = "/sys/class/tty";

/// The ports of this computer, those with a chip that benders have first.
///
/// # Errors
/// [`DriverError`] with the code `ports` when the system does not report them.
pub fn ports() -> Result<Vec<Port>, DriverError> {
    // The library panics where the system does not show its terminals, as in a container: there are no ports then.
    if cfg!(target_os = "linux") && !Path::new(TERMINALS).is_dir() {
        return Ok(Vec::new());
    }
    let found = serialport::available_ports().map_err(|error| {
        let what = format!("the system does not list its ports: {error}");
        DriverError::new("ports", what, "write the port's name yourself, such as /dev/ttyUSB0 or COM3")
    })?;
    Ok(in_order(found.into_iter().map(described).collect()))
}

fn in_order(mut ports: Vec<Port>) -> Vec<Port> {
    ports.sort_by(|a, b| (!a.likely, &a.name).cmp(&(!b.likely, &b.name)));
    ports
}

fn described(found: SerialPortInfo) -> Port {
    let name = found.port_name;
    match found.port_type {
        SerialPortType::UsbPort(usb) => of_usb(name, usb),
        SerialPortType::BluetoothPort => plain(name, "Bluetooth"),
        SerialPortType::PciPort => plain(name, "built in"),
        SerialPortType::Unknown => plain(name, ""),
    }
}

fn plain(name: String, description: &str) -> Port {
    Port { name, description: description.to_owned(), ..Port::default() }
}

fn of_usb(name: String, usb: UsbPortInfo) -> Port {
    let known = KNOWN.iter().find(|(vid, pid, _)| (*vid, *pid) == (usb.vid, usb.pid));
    let description = match (known, &usb.product) {
        (Some((_, _, known)), _) => (*known).to_owned(),
        (None, Some(product)) => product.clone(),
        (None, None) => format!("USB {:04x}:{:04x}", usb.vid, usb.pid),
    };
    let UsbPortInfo { vid, pid, manufacturer, product, serial_number: serial } = usb;
    Port {
        name,
        description,
        usb: Some(Usb { vid, pid, manufacturer, product, serial }),
        likely: known.is_some(),
        simulated: false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(name: &str, port_type: SerialPortType) -> Port {
        described(SerialPortInfo { port_name: name.to_owned(), port_type })
    }

    fn usb(vid: u16, pid: u16, product: Option<&str>) -> SerialPortType {
        let product = product.map(str::to_owned);
        SerialPortType::UsbPort(UsbPortInfo { vid, pid, serial_number: None, manufacturer: None, product })
    }

    /// A user who plugs in a copy of an Uno finds it at the top, by a name that says something.
    #[test]
    fn a_board_comes_before_a_modem() {
        let ports = in_order(vec![
            found("/dev/ttyACM9", usb(0x1199, 0x9071, Some("Modem"))),
            found("/dev/ttyS0", SerialPortType::PciPort),
            found("/dev/ttyUSB1", usb(0x1a86, 0x7523, Some("USB Serial"))),
            found("/dev/ttyACM0", usb(0x2341, 0x0043, None)),
            found("/dev/ttyUSB7", usb(0x1199, 0x0001, None)),
        ]);
        let names: Vec<_> = ports.iter().map(|port| (port.name.as_str(), port.likely)).collect();
        let expected = [
            ("/dev/ttyACM0", true),
            ("/dev/ttyUSB1", true),
            ("/dev/ttyACM9", false),
            ("/dev/ttyS0", false),
            ("/dev/ttyUSB7", false),
        ];
        assert_eq!(names, expected);
        let words: Vec<_> = ports.iter().map(|port| port.description.as_str()).collect();
        assert_eq!(words[0], "Arduino Uno");
        assert!(words[1].starts_with("CH340"), "{words:?}");
        assert_eq!(words[2..], ["Modem", "built in", "USB 1199:0001"]);
    }
}
