//! From the C table to a [`MachineDriver`]: the functions behind the pointers.

#![allow(unsafe_code)] // the boundary itself; every block says what it relies on

use std::ffi::{c_char, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};

use crate::dispatch::{Answer, Instance, describe, guard};
use crate::{ABI_MAJOR, ABI_MINOR, Buffer, Bytes, MachineDriver, OK, REFUSED, Table};

/// The table of a driver.
#[must_use]
pub const fn table<D: MachineDriver>() -> Table {
    Table {
        abi_major: ABI_MAJOR,
        abi_minor: ABI_MINOR,
        describe: Some(describe_c::<D>),
        open: Some(open_c::<D>),
        call: Some(call_c::<D>),
        poll: Some(poll_c::<D>),
        close: Some(close_c::<D>),
        free: Some(free_c),
        extension: Some(extension_c),
    }
}

/// Exports a driver from a `cdylib`: the one symbol that the program looks for.
///
/// ```text
/// wirebend_driver_api::export_driver!(MyDriver);
/// ```
#[macro_export]
macro_rules! export_driver {
    ($driver:ty) => {
        /// The table of this driver, for the program that loads it.
        #[allow(unsafe_code)] // an exported symbol has a name that nothing else may have
        #[unsafe(no_mangle)]
        pub extern "C" fn wirebend_driver_entry() -> *const $crate::Table {
            static TABLE: $crate::Table = $crate::table::<$driver>();
            &raw const TABLE
        }
    };
}

extern "C" fn describe_c<D: MachineDriver>(out: *mut Buffer) -> i32 {
    answer(describe::<D>(), out)
}

unsafe extern "C" fn open_c<D: MachineDriver>(
    settings: Bytes,
    instance: *mut *mut c_void,
    out: *mut Buffer,
) -> i32 {
    // SAFETY: the caller keeps `settings` alive during the call.
    let settings = unsafe { slice(&settings) };
    match guard(|| Instance::<D>::open(settings)) {
        Ok(opened) => {
            // SAFETY: `instance` points to a place for a pointer.
            unsafe { *instance = Box::into_raw(Box::new(opened)).cast() };
            answer(Ok(Vec::new()), out)
        }
        Err(error) => answer(Err(error), out),
    }
}

unsafe extern "C" fn call_c<D: MachineDriver>(
    instance: *mut c_void,
    request: Bytes,
    out: *mut Buffer,
) -> i32 {
    // SAFETY: `instance` came from `open_c::<D>` and is used by one thread at a time; `request` lives as
    // long as the call.
    let (instance, request) = unsafe { (&mut *instance.cast::<Instance<D>>(), slice(&request)) };
    answer(instance.call(request), out)
}

unsafe extern "C" fn poll_c<D: MachineDriver>(instance: *mut c_void, out: *mut Buffer) -> i32 {
    // SAFETY: as in `call_c`.
    let instance = unsafe { &mut *instance.cast::<Instance<D>>() };
    answer(instance.poll(), out)
}

unsafe extern "C" fn close_c<D: MachineDriver>(instance: *mut c_void) {
    if !instance.is_null() {
        // SAFETY: `instance` came from `open_c::<D>` and is not used again.
        let instance = unsafe { Box::from_raw(instance.cast::<Instance<D>>()) };
        // A driver that panics while it closes has nothing left to report.
        let _ = catch_unwind(AssertUnwindSafe(move || drop(instance)));
    }
}

unsafe extern "C" fn free_c(buffer: Buffer) {
    if !buffer.data.is_null() {
        // SAFETY: `answer` made the buffer from a boxed slice of this length.
        drop(unsafe { Box::from_raw(std::ptr::slice_from_raw_parts_mut(buffer.data, buffer.len)) });
    }
}

extern "C" fn extension_c(_name: *const c_char) -> *const c_void {
    std::ptr::null()
}

/// Hands an answer over.
fn answer(answer: Answer, out: *mut Buffer) -> i32 {
    let (status, bytes) = match answer {
        Ok(bytes) => (OK, bytes),
        Err(error) => (REFUSED, serde_json::to_vec(&error).unwrap_or_default()),
    };
    let buffer = if bytes.is_empty() {
        Buffer::EMPTY
    } else {
        let bytes = bytes.into_boxed_slice();
        Buffer { len: bytes.len(), data: Box::into_raw(bytes).cast() }
    };
    // SAFETY: the caller gives a place for a buffer.
    unsafe { *out = buffer };
    status
}

/// # Safety
/// `bytes` are readable for as long as the result is used.
unsafe fn slice(bytes: &Bytes) -> &[u8] {
    if bytes.data.is_null() || bytes.len == 0 {
        return &[];
    }
    // SAFETY: promised by the caller.
    unsafe { std::slice::from_raw_parts(bytes.data, bytes.len) }
}
