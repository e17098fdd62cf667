//! The ports that a machine can be at.

use wirebend_driver_api::{DriverError, Port, serial};

/// Those of the computer, those that are likely first, and the simulated machine's.
pub(crate) fn ports() -> Result<Vec<Port>, DriverError> {
    let simulated = [
        ("sim", "simulated machine, in real time"),
        ("sim:10", "simulated machine, ten times as fast"),
        ("sim:max", "simulated machine, as fast as it can be computed"),
    ];
    let mut ports = serial::ports()?;
    ports.extend(simulated.map(|(name, description)| Port {
        name: name.to_owned(),
        description: description.to_owned(),
        usb: None,
        likely: false,
        simulated: true,
    }));
    Ok(ports)
}
