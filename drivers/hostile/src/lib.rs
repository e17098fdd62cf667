//! A driver that misbehaves on demand. For tests only: it is never shipped.
//!
//! The name of the library says what it does and when: a copy named `WHEN-HOW.so` does `HOW` when it is
//! asked `WHEN`, and is an ordinary driver otherwise. [`WHEN`] and [`HOW`] list them. As long as there is a file
//! `WHEN-HOW.leash` beside it, it behaves. With a library `WHEN-HOW.real` beside it, it does what that does. With the setting
//! `machine` it moves one that outlives it, and that loses its cable, its driver or its memory at a step.

#![cfg(unix)] // it misuses descriptors and signals
#![allow(unsafe_code)] // it breaks the boundary on purpose

mod conduct;
mod machine;
mod manners;
mod real;

use std::ffi::{c_char, c_void};

use conduct::{Conduct, conduct};
use wirebend_driver_api::{ABI_MAJOR, ABI_MINOR, Buffer, Bytes, OK, REFUSED, Table};

/// When it can misbehave.
pub const WHEN: [&str; 20] = [
    "entry",
    "describe",
    "open",
    "encode",
    "ports",
    "limits",
    "connect",
    "home",
    "arm",
    "send",
    "jog",
    "pause",
    "resume",
    "stop",
    "disconnect",
    "poll",
    "write-settings",
    "console",
    "cut",
    "close",
];

/// How it can misbehave.
pub const HOW: [&str; 23] = [
    "exit", "abort", "segfault", "hang", "spin", "flood", "garbage", "torrent", "deaf", "leak", "orphan",
    "null", "status", "nonsense", "shout", "lie", "differ", "version", "old", "mute", "fault", "numb",
    "gone",
];

/// The table of this driver.
#[unsafe(no_mangle)]
pub extern "C" fn wirebend_driver_entry() -> *const Table {
    static HONEST: Table = table(ABI_MAJOR, ABI_MINOR);
    static NEWER: Table = table(ABI_MAJOR + 1, ABI_MINOR);
    static OLDER: Table = table(ABI_MAJOR, 0);
    match conduct("entry") {
        Conduct::As("version") => &raw const NEWER,
        Conduct::As("old") => &raw const OLDER,
        Conduct::As("null" | "status" | "nonsense" | "flood") => std::ptr::null(),
        Conduct::As(_) | Conduct::Well => &raw const HONEST,
    }
}

const fn table(abi_major: u32, abi_minor: u32) -> Table {
    Table {
        abi_major,
        abi_minor,
        describe: Some(describe),
        open: Some(open),
        call: Some(call),
        poll: Some(poll),
        close: Some(close),
        free: Some(free),
        extension: Some(extension),
    }
}

extern "C" fn describe(out: *mut Buffer) -> i32 {
    hand(out, "describe", manners::describe())
}

extern "C" fn open(settings: Bytes, instance: *mut *mut c_void, out: *mut Buffer) -> i32 {
    let mut reply = Ok(String::new());
    if conduct("open") != Conduct::As("null") {
        // SAFETY: the caller keeps the bytes alive during the call.
        let settings = unsafe { std::slice::from_raw_parts(settings.data, settings.len) };
        match manners::Instance::open(settings) {
            // SAFETY: the caller gives a place for a pointer.
            Ok(opened) => unsafe { *instance = Box::into_raw(Box::new(opened)).cast() },
            Err(refusal) => reply = Err(refusal),
        }
    }
    hand(out, "open", reply)
}

extern "C" fn call(instance: *mut c_void, request: Bytes, out: *mut Buffer) -> i32 {
    // SAFETY: the caller keeps the bytes alive during the call, and the instance came from `open`.
    let (request, instance) = unsafe {
        (std::slice::from_raw_parts(request.data, request.len), &mut *instance.cast::<manners::Instance>())
    };
    let (name, reply) = instance.call(request);
    hand(out, &name, reply)
}

extern "C" fn poll(instance: *mut c_void, out: *mut Buffer) -> i32 {
    // SAFETY: the instance came from `open`.
    let event = unsafe { &mut *instance.cast::<manners::Instance>() }.poll();
    hand(out, "poll", event)
}

extern "C" fn close(instance: *mut c_void) {
    let mut nothing = Buffer::EMPTY;
    hand(&raw mut nothing, "close", Ok(String::new()));
    free(nothing);
    // SAFETY: the instance came from `open` and is not used again.
    drop(unsafe { Box::from_raw(instance.cast::<manners::Instance>()) });
}

extern "C" fn free(buffer: Buffer) {
    if !buffer.data.is_null() {
        // SAFETY: `give` made it from a boxed slice.
        drop(unsafe { Box::from_raw(std::ptr::slice_from_raw_parts_mut(buffer.data, buffer.len)) });
    }
}

extern "C" fn extension(_name: *const c_char) -> *const c_void {
    std::ptr::null()
}

/// Answers a function, well or not.
fn hand(out: *mut Buffer, when: &str, reply: Result<String, String>) -> i32 {
    let null = Buffer { data: std::ptr::null_mut(), len: 3 };
    let (buffer, status) = match (conduct(when), reply) {
        (Conduct::As("null"), _) => (null, OK),
        (Conduct::As("status"), _) => (Buffer::EMPTY, 77),
        (Conduct::As("nonsense"), _) => (give("{\"no\": [such, thing".to_owned()), OK),
        (Conduct::As("flood"), _) => (give("x".repeat(100 << 20)), OK),
        (_, Ok(text)) => (give(text), OK),
        (_, Err(text)) => (give(text), REFUSED),
    };
    // SAFETY: the caller gives a place for a buffer.
    unsafe { *out = buffer };
    status
}

fn give(text: String) -> Buffer {
    if text.is_empty() {
        return Buffer::EMPTY;
    }
    let bytes = text.into_bytes().into_boxed_slice();
    Buffer { len: bytes.len(), data: Box::into_raw(bytes).cast() }
}
