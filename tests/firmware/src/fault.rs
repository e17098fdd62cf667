//! Faults that no program makes on purpose.

use crate::error::UnoError;
use crate::uno::Uno;

/// How long an interrupt is waited for: half a second.
const MAX_CYCLES: u64 = crate::uno::HZ / 2;

/// MCUSR in data memory.
const MCUSR: usize = 0x54;

impl Uno {
    /// Clears the cause of a reset, as the boot loader of an Uno does before it starts the program. To be called
    /// before the program runs again.
    pub fn forget_reset_cause(&mut self) {
        if let Some(flags) = self.controller.data_mut().get_mut(MCUSR) {
            *flags = 0;
        }
    }

    /// Lets the next interrupt that begins while the program sleeps or loops return to a symbol of the program, and
    /// so many bytes behind it: as if the place to return to had been overwritten.
    ///
    /// # Errors
    /// When the program has no such symbol, or crashes before, or no interrupt comes within half a second.
    pub fn derail(&mut self, symbol: &str, behind: usize) -> Result<(), UnoError> {
        let words = self.symbol(symbol)? / 2 + behind / 2;
        let [low, high, ..] = words.to_le_bytes();
        // The stack of the main loop: what the pointer comes back to.
        let end = self.cycle().saturating_add(MAX_CYCLES);
        let mut main = self.stack_pointer();
        while self.cycle() < end {
            let before = self.stack_pointer();
            main = main.max(before);
            self.run_for(1)?;
            let now = self.stack_pointer();
            // An interrupt of the main loop begins: two bytes at once, which a push never takes.
            if before == main && now + 2 == before {
                return self.set_ram(now + 1, &[high, low]);
            }
        }
        Err(UnoError::NoInterrupt { cycle: self.cycle() })
    }
}
