//! The controller's memories, and how much of the RAM its stack has never used.

use crate::error::UnoError;
use crate::ffi::DATA_BYTES;
use crate::uno::Uno;

/// First byte of RAM; below are registers.
const RAM_START: usize = 0x100;
const EEPROM_BYTES: usize = 1024;
/// What unused stack is painted with: neither 0 nor 0xFF, which programs write often.
const PAINT: u8 = 0xC5;

impl Uno {
    /// The whole EEPROM. A byte that was never written is 0xFF.
    pub fn eeprom(&mut self) -> [u8; EEPROM_BYTES] {
        self.controller.eeprom()
    }

    /// Writes the EEPROM from its first byte on.
    ///
    /// # Errors
    /// When it has fewer bytes.
    pub fn set_eeprom(&mut self, bytes: &[u8]) -> Result<(), UnoError> {
        if bytes.len() > EEPROM_BYTES {
            let (from, to) = (0, EEPROM_BYTES - 1);
            return Err(UnoError::OutOfMemory { what: "the EEPROM", from, to, at: 0, count: bytes.len() });
        }
        self.controller.set_eeprom(bytes);
        Ok(())
    }

    /// The RAM, which begins at address 0x100.
    #[must_use]
    pub fn ram(&self) -> &[u8] {
        self.controller.data().get(RAM_START..).unwrap_or_default()
    }

    /// Writes RAM from an address in data memory on, which is 0x100 or more.
    ///
    /// # Errors
    /// When the bytes do not fit.
    pub fn set_ram(&mut self, address: usize, bytes: &[u8]) -> Result<(), UnoError> {
        let out = UnoError::OutOfMemory {
            what: "the RAM",
            from: RAM_START,
            to: DATA_BYTES - 1,
            at: address,
            count: bytes.len(),
        };
        if address < RAM_START {
            return Err(out);
        }
        let place =
            self.controller.data_mut().get_mut(address..).and_then(|rest| rest.get_mut(..bytes.len()));
        place.ok_or(out)?.copy_from_slice(bytes);
        Ok(())
    }

    /// Address in data memory of a symbol of the program, such as `_end` or a variable.
    ///
    /// # Errors
    /// When it has none of that name.
    pub fn symbol(&self, name: &str) -> Result<usize, UnoError> {
        self.controller.symbol(name).ok_or_else(|| UnoError::NoSymbol { name: name.to_owned() })
    }

    /// Paints the RAM from the end of the program's variables to just below the stack pointer, so that
    /// [`Self::untouched_stack`] can show later what the stack has used.
    ///
    /// # Errors
    /// When the program has no symbol `_end`.
    pub fn paint_stack(&mut self) -> Result<(), UnoError> {
        let end = self.symbol("_end")?;
        let pointer = self.stack_pointer();
        self.controller.data_mut().get_mut(end..=pointer).unwrap_or_default().fill(PAINT);
        Ok(())
    }

    /// Bytes between the end of the program's variables and the deepest place that the stack has reached since it
    /// was painted; 0 when they met.
    ///
    /// # Errors
    /// When the program has no symbol `_end`.
    pub fn untouched_stack(&self) -> Result<usize, UnoError> {
        let end = self.symbol("_end")?;
        let above = self.controller.data().get(end..).unwrap_or_default();
        Ok(above.iter().take_while(|&&byte| byte == PAINT).count())
    }

    /// The next free byte of the stack, which grows down.
    pub(crate) fn stack_pointer(&self) -> usize {
        let at = |address| self.controller.data().get(address).copied().unwrap_or_default();
        usize::from(u16::from_le_bytes([at(0x5D), at(0x5E)])).min(DATA_BYTES - 1)
    }

    /// Fills the RAM with noise: a generator after Marsaglia, "Xorshift RNGs", 2003.
    pub(crate) fn scramble(&mut self, seed: u64) {
        let mut state = seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1;
        for byte in self.controller.data_mut().iter_mut().skip(RAM_START) {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            *byte = state.to_le_bytes()[4];
        }
    }
}
