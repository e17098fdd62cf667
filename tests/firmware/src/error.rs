//! What can go wrong on the bench. None of it is a finding about the wire protocol: that is for the tests.

use std::path::PathBuf;

/// Why the simulated controller could not do what was asked. The message says what to do.
#[derive(Debug, thiserror::Error)]
pub enum UnoError {
    /// The file is missing, or no ELF file for an AVR.
    #[error("{} is no program for an AVR: {why}; give the .elf that avr-gcc makes", file.display())]
    NoProgram { file: PathBuf, why: String },
    /// An instruction that the chip does not have: the program jumped out of itself.
    #[error("the controller crashed at cycle {cycle}, byte address {program_counter:#06x}: {said}")]
    Crashed {
        cycle: u64,
        /// Where, in bytes of flash.
        program_counter: u32,
        /// What the simulator said.
        said: String,
    },
    /// It sleeps with interrupts off, where the simulator ends.
    #[error(
        "the controller sleeps with interrupts off from cycle {cycle} on; reset it, or let it sleep after sei"
    )]
    AsleepForEver { cycle: u64 },
    /// No interrupt came to be led astray.
    #[error("no interrupt began until cycle {cycle}; let the program turn one on")]
    NoInterrupt {
        /// When it was given up.
        cycle: u64,
    },
    /// A port has bits 0 to 7.
    #[error("a port has no bit {bit}; give 0 to 7")]
    NoBit { bit: u8 },
    /// Bytes outside of a memory.
    #[error("{what} is bytes {from:#06x} to {to:#06x}; {count} bytes from {at:#06x} on do not fit")]
    OutOfMemory {
        what: &'static str,
        from: usize,
        to: usize,
        /// What was asked for.
        at: usize,
        count: usize,
    },
    /// The ELF file has no such symbol.
    #[error("the program has no symbol {name}; link it with avr-libc's start-up code and keep its symbols")]
    NoSymbol { name: String },
    /// The pseudo-terminal could not be made or used.
    #[error("{doing} failed: {why}")]
    Terminal { doing: &'static str, why: std::io::Error },
    /// The thread with the controller has ended: `stop` says why.
    #[error("the controller's thread has ended; `stop` gives the reason")]
    Ended,
}
