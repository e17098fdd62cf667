//! What is seen of the chip from outside.

/// A port of the chip.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Port {
    /// Pins 8 to 13 of the board.
    B,
    /// Pins A0 to A5.
    C,
    /// Pins 0 to 7.
    D,
}

/// A pin that the controller drives has changed its level. A pin that it does not drive reads low here, as the
/// drivers' inputs have pull-downs: when a reset lets go of a pin that was high, it falls.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PinChange {
    pub cycle: u64,
    pub port: Port,
    /// Bit of the port, 0 to 7.
    pub bit: u8,
    /// True when it is high now.
    pub level: bool,
}

/// What an interrupt has cost so far.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct InterruptTime {
    /// Its number in the chip's table, 1 to 25.
    pub vector: u8,
    /// How often it ran.
    pub count: u64,
    /// The longest run, from its vector to the end of its `reti`. The chip takes 4 cycles more to get there.
    pub worst_cycles: u64,
    /// The longest wait from its flag to its vector, in cycles; while it was not enabled it waited too.
    pub worst_wait_cycles: u64,
}
