//! The shim of `shim/` as a safe type. All that is unsafe in this crate is in this file.

#![allow(unsafe_code)] // the simulator is a C library; the shim's pointers do not leave this file

use std::ffi::{CStr, CString, c_char, c_int};
use std::ptr::NonNull;

use crate::chip::{InterruptTime, PinChange, Port};

/// Bytes of data memory: registers, I/O and RAM.
pub(crate) const DATA_BYTES: usize = 0x900;

#[repr(C)]
struct Shim {
    opaque: [u8; 0],
}

#[repr(C)]
#[derive(Clone, Copy)]
struct ShimPin {
    cycle: u64,
    port: u8,
    bit: u8,
    level: u8,
}

#[repr(C)]
#[derive(Clone, Copy)]
struct ShimByte {
    cycle: u64,
    value: u16,
}

#[repr(C)]
struct ShimTime {
    count: u64,
    worst_run: u64,
    worst_wait: u64,
}

unsafe extern "C" {
    fn uno_new(elf: *const c_char) -> *mut Shim;
    fn uno_free(uno: *mut Shim);
    fn uno_reset(uno: *mut Shim, flag: u8, alone: u8);
    fn uno_run_until(uno: *mut Shim, cycle: u64) -> c_int;
    fn uno_last_words() -> *const c_char;
    fn uno_cycle(uno: *const Shim) -> u64;
    fn uno_crashed_at(uno: *const Shim) -> u32;
    fn uno_overruns(uno: *const Shim) -> u64;
    fn uno_lost_sending(uno: *const Shim) -> u64;
    fn uno_asleep(uno: *const Shim) -> u64;
    fn uno_watchdog_resets(uno: *const Shim) -> u64;
    fn uno_data(uno: *mut Shim) -> *mut u8;
    fn uno_vector_time(uno: *const Shim, vector: u8) -> ShimTime;
    fn uno_take_pins(uno: *mut Shim, count: *mut usize) -> *const ShimPin;
    fn uno_sent(uno: *mut Shim, count: *mut usize) -> *const ShimByte;
    fn uno_drop_sent(uno: *mut Shim, count: usize);
    fn uno_receive(uno: *mut Shim, cycle: u64, value: u16);
    fn uno_set_input(uno: *mut Shim, port: u8, bit: u8, level: u8);
    fn uno_eeprom(uno: *mut Shim, bytes: *mut u8, offset: u16, size: u16, write: u8) -> c_int;
    fn uno_symbol(uno: *const Shim, name: *const c_char) -> i32;
}

/// Why a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Ended {
    Reached,
    Crashed,
    AsleepForEver,
}

pub(crate) struct Controller(NonNull<Shim>);

// SAFETY: the shim keeps nothing of a controller in a thread or in a global but the simulator's log function,
// which is the same for all; one controller is used through `&mut` or `&` of its one owner.
unsafe impl Send for Controller {}

impl Drop for Controller {
    fn drop(&mut self) {
        // SAFETY: made by `uno_new`, freed here alone.
        unsafe { uno_free(self.0.as_ptr()) }
    }
}

/// A list of the shim, copied.
///
/// # Safety
/// `items` has `count` items, or `count` is 0.
unsafe fn copied<T: Copy>(items: *const T, count: usize) -> Vec<T> {
    if count == 0 {
        return Vec::new();
    }
    // SAFETY: as promised by the caller; a list that holds something is not null.
    unsafe { std::slice::from_raw_parts(items, count) }.to_vec()
}

impl Controller {
    /// None when the simulator does not take the file; [`last_words`] has what it said.
    pub(crate) fn new(elf: &CStr) -> Option<Self> {
        // SAFETY: a string that ends in 0 and is only read during the call.
        NonNull::new(unsafe { uno_new(elf.as_ptr()) }).map(Self)
    }

    /// Resets with a `flag` of MCUSR, which is the only one when `alone`.
    pub(crate) fn reset(&mut self, flag: u8, alone: bool) {
        // SAFETY: a living controller, as in every call below.
        unsafe { uno_reset(self.0.as_ptr(), flag, u8::from(alone)) }
    }

    pub(crate) fn run_until(&mut self, cycle: u64) -> Ended {
        // SAFETY: see `reset`.
        match unsafe { uno_run_until(self.0.as_ptr(), cycle) } {
            0 => Ended::Reached,
            1 => Ended::Crashed,
            _ => Ended::AsleepForEver,
        }
    }

    pub(crate) fn cycle(&self) -> u64 {
        // SAFETY: see `reset`.
        unsafe { uno_cycle(self.0.as_ptr()) }
    }

    pub(crate) fn crashed_at(&self) -> u32 {
        // SAFETY: see `reset`.
        unsafe { uno_crashed_at(self.0.as_ptr()) }
    }

    pub(crate) fn overruns(&self) -> u64 {
        // SAFETY: see `reset`.
        unsafe { uno_overruns(self.0.as_ptr()) }
    }

    pub(crate) fn lost_sending(&self) -> u64 {
        // SAFETY: see `reset`.
        unsafe { uno_lost_sending(self.0.as_ptr()) }
    }

    pub(crate) fn asleep(&self) -> u64 {
        // SAFETY: see `reset`.
        unsafe { uno_asleep(self.0.as_ptr()) }
    }

    pub(crate) fn watchdog_resets(&self) -> u64 {
        // SAFETY: see `reset`.
        unsafe { uno_watchdog_resets(self.0.as_ptr()) }
    }

    pub(crate) fn data(&self) -> &[u8] {
        // SAFETY: data memory has `DATA_BYTES` and lives as long as the controller; nothing runs meanwhile.
        unsafe { std::slice::from_raw_parts(uno_data(self.0.as_ptr()), DATA_BYTES) }
    }

    pub(crate) fn data_mut(&mut self) -> &mut [u8] {
        // SAFETY: as `data`, and no other code has it.
        unsafe { std::slice::from_raw_parts_mut(uno_data(self.0.as_ptr()), DATA_BYTES) }
    }

    /// Of a vector from 1 to 25.
    pub(crate) fn interrupt_time(&self, vector: u8) -> InterruptTime {
        // SAFETY: see `reset`; the number is kept inside of the shim's table.
        let time = unsafe { uno_vector_time(self.0.as_ptr(), vector.clamp(1, 25)) };
        InterruptTime {
            vector,
            count: time.count,
            worst_cycles: time.worst_run,
            worst_wait_cycles: time.worst_wait,
        }
    }

    pub(crate) fn take_pins(&mut self) -> Vec<PinChange> {
        let mut count = 0;
        // SAFETY: the shim gives as many as it counts, and they are copied before it runs again.
        let pins = unsafe {
            let pins = uno_take_pins(self.0.as_ptr(), &raw mut count);
            copied(pins, count)
        };
        let port = |number| match number {
            0 => Port::B,
            1 => Port::C,
            _ => Port::D,
        };
        let changed = |pin: &ShimPin| PinChange {
            cycle: pin.cycle,
            port: port(pin.port),
            bit: pin.bit,
            level: pin.level != 0,
        };
        pins.iter().map(changed).collect()
    }

    /// Bytes that have left whole, with the cycle of the end of each.
    pub(crate) fn take_sent(&mut self) -> Vec<(u64, u8)> {
        let mut count = 0;
        // SAFETY: as in `take_pins`; what was copied is dropped.
        let sent = unsafe {
            let sent = uno_sent(self.0.as_ptr(), &raw mut count);
            let sent = copied(sent, count);
            uno_drop_sent(self.0.as_ptr(), count);
            sent
        };
        sent.iter().map(|byte| (byte.cycle, byte.value.to_le_bytes()[0])).collect()
    }

    /// A byte whose stop bit ends at `cycle`, which is not before that of the byte before.
    pub(crate) fn receive(&mut self, cycle: u64, byte: u8, broken: bool) {
        let value = u16::from(byte) | if broken { 0x8000 } else { 0 };
        // SAFETY: see `reset`.
        unsafe { uno_receive(self.0.as_ptr(), cycle, value) }
    }

    /// `bit` is 0 to 7.
    pub(crate) fn set_input(&mut self, port: Port, bit: u8, level: bool) {
        let port = match port {
            Port::B => 0,
            Port::C => 1,
            Port::D => 2,
        };
        // SAFETY: see `reset`; the port is one of three and the bit one of eight.
        unsafe { uno_set_input(self.0.as_ptr(), port, bit & 7, u8::from(level)) }
    }

    /// The whole EEPROM.
    pub(crate) fn eeprom<const N: usize>(&mut self) -> [u8; N] {
        let mut bytes = [0xFF; N];
        let size = u16::try_from(N).unwrap_or(u16::MAX);
        // SAFETY: the shim writes `size` bytes at most, which is what there is.
        unsafe { uno_eeprom(self.0.as_ptr(), bytes.as_mut_ptr(), 0, size, 0) };
        bytes
    }

    /// At most as many bytes as it has.
    pub(crate) fn set_eeprom(&mut self, bytes: &[u8]) {
        let mut copy = bytes.to_vec();
        let size = u16::try_from(copy.len()).unwrap_or(u16::MAX);
        // SAFETY: the shim reads `size` bytes, which is not more than there are.
        unsafe { uno_eeprom(self.0.as_ptr(), copy.as_mut_ptr(), 0, size, 1) };
    }

    /// Address in data memory of a symbol of the program.
    pub(crate) fn symbol(&self, name: &str) -> Option<usize> {
        let name = CString::new(name).ok()?;
        // SAFETY: see `reset`; the string is only read during the call.
        usize::try_from(unsafe { uno_symbol(self.0.as_ptr(), name.as_ptr()) }).ok()
    }
}

/// What the simulator complained of last in this thread.
pub(crate) fn last_words() -> String {
    // SAFETY: a string of this thread that ends in 0 and that no other call changes meanwhile.
    let said = unsafe { CStr::from_ptr(uno_last_words()) }.to_string_lossy();
    let said = said.trim();
    if said.is_empty() { "it says nothing".to_owned() } else { said.to_owned() }
}
