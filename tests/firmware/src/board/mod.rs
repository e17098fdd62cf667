//! The two controllers that must behave alike: the core with a clock for computers, and the binary of the board.

mod avr;
mod host;

pub use avr::Avr;
pub use host::Host;
pub use wirebend_driver_wirebend_kit::protocol::Reset;

/// Cycles of the clock in a millisecond.
pub const MS: u64 = 16_000;
/// And in a second.
pub const HZ: u64 = 1000 * MS;
/// Axes are feed 0, rotate 1 and bend 2, as the firmware numbers them.
pub const BEND: usize = 2;

/// Something that can be seen on a pin or on the serial line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum What {
    /// A step pulse has begun, with its direction pin high or low.
    Pulse {
        axis: usize,
        /// Its direction, as the motor sees it.
        forward: bool,
    },
    /// The servo gets pulses of another width from now on, µs. The board shows it when the first one is over.
    Servo { width_us: u16 },
    /// A byte to the host is over.
    Byte(u8),
    /// The motor drivers are on or off.
    Motors(bool),
}

/// Something seen, and when, in cycles since the first power-on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Observation {
    pub at: u64,
    pub what: What,
}

/// A controller in virtual time.
pub trait Board {
    const NAME: &'static str;
    /// A new one, nothing stored, its power just switched on.
    fn new() -> Self;
    /// Cycles since the first power-on.
    fn now(&self) -> u64;
    /// Bytes to its serial line.
    fn send(&mut self, bytes: &[u8]);
    /// Lets time pass until a cycle or until something is seen; what was seen, in order. Empty when the cycle is
    /// reached and nothing more is to be seen.
    fn run(&mut self, until: u64) -> Vec<Observation>;
    /// The level of the pin of the switch.
    fn set_switch(&mut self, high: bool);
    /// Whether the contacts of the hold input and of the emergency stop's sense are open.
    fn set_inputs(&mut self, hold_open: bool, emergency_open: bool);
    fn reset(&mut self, cause: Reset);
    /// Bytes that outlive power.
    fn stored(&mut self) -> Vec<u8>;
    fn store(&mut self, bytes: &[u8]);
}
