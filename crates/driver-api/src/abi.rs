//! The C types of the boundary. `include/wirebend_driver.h` is held equal to them by a test that compiles it.

use std::ffi::{c_char, c_void};

/// Drivers and programs with the same major understand each other.
pub const ABI_MAJOR: u32 = 1;
/// A larger minor has more messages or extensions; nothing that was there has changed.
pub const ABI_MINOR: u32 = 7;
/// The one symbol that a driver exports.
pub const ENTRY_SYMBOL: &str = "wirebend_driver_entry";
/// A function did what it was asked to; `out` holds its result.
pub const OK: i32 = 0;
/// A function did not; `out` holds a [`DriverError`](crate::DriverError).
pub const REFUSED: i32 = 1;

/// Bytes that the caller owns; valid until the function returns.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct Bytes {
    /// Where they start; may be null when there are none.
    pub data: *const u8,
    /// How many.
    pub len: usize,
}

/// Bytes that the driver owns until the program hands them to [`Table::free`].
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct Buffer {
    /// Where they start; may be null when there are none.
    pub data: *mut u8,
    /// How many.
    pub len: usize,
}

impl Buffer {
    /// No bytes.
    pub const EMPTY: Self = Self { data: std::ptr::null_mut(), len: 0 };
}

/// The exported function. The table that it returns is valid for the life of the process.
pub type Entry = unsafe extern "C" fn() -> *const Table;

/// What a driver can be asked. The two numbers stay first in every version of this table, so that a
/// program can read them before it trusts the rest.
#[repr(C)]
#[derive(Debug, Clone, Copy)]
pub struct Table {
    /// [`ABI_MAJOR`] that the driver was built against.
    pub abi_major: u32,
    /// [`ABI_MINOR`] that the driver was built against.
    pub abi_minor: u32,
    /// Gives the [`Description`](crate::Description). Needs no machine and no settings.
    pub describe: Option<unsafe extern "C" fn(out: *mut Buffer) -> i32>,
    /// Takes settings (a JSON object, `{}` for the defaults) and makes an instance.
    pub open:
        Option<unsafe extern "C" fn(settings: Bytes, instance: *mut *mut c_void, out: *mut Buffer) -> i32>,
    /// Takes a [`Call`](crate::Call) and gives its reply.
    pub call: Option<unsafe extern "C" fn(instance: *mut c_void, request: Bytes, out: *mut Buffer) -> i32>,
    /// Gives the next [`Event`](crate::Event), or no bytes when there is none. Never waits.
    pub poll: Option<unsafe extern "C" fn(instance: *mut c_void, out: *mut Buffer) -> i32>,
    /// Ends an instance: connection closed, memory given back.
    pub close: Option<unsafe extern "C" fn(instance: *mut c_void)>,
    /// Takes back a buffer that the driver filled. Empty buffers may be handed in too.
    pub free: Option<unsafe extern "C" fn(buffer: Buffer)>,
    /// Gives the table of a later feature by `"name/revision"` (ends with a zero byte), or null.
    pub extension: Option<unsafe extern "C" fn(name: *const c_char) -> *const c_void>,
}
