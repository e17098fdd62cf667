//! The ports of a computer, as a driver sees them.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Reply of [`Call::Ports`](crate::Call::Ports).
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Ports {
    /// Those that a machine is likely at first, else by name.
    pub ports: Vec<Port>,
}

/// A port that could be connected to.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Port {
    /// What [`Call::Connect`](crate::Call::Connect) takes.
    pub name: String,
    /// For people: what is plugged in there, as far as it is known.
    #[serde(default)]
    pub description: String,
    /// What the plug says of itself; absent where it is no USB port.
    #[serde(default)]
    pub usb: Option<Usb>,
    /// Whether one of the driver's machines may well be at it. A guess, for the order of a list: several kinds
    /// of machines have the same chip.
    #[serde(default)]
    pub likely: bool,
    /// No machine is at it: the driver computes one. The first of a list is taken where no port is named.
    #[serde(default)]
    pub simulated: bool,
}

/// What a USB device says of itself.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Usb {
    /// Number of its vendor.
    pub vid: u16,
    /// The vendor's number of the product.
    pub pid: u16,
    /// Name of the vendor.
    #[serde(default)]
    pub manufacturer: Option<String>,
    /// Name of the product.
    #[serde(default)]
    pub product: Option<String>,
    /// Serial number: tells two machines of the same kind apart.
    #[serde(default)]
    pub serial: Option<String>,
}
