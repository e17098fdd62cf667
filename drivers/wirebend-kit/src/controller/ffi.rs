//! Bindings of the firmware's `hal_host/host.h`, and their owner. The only unsafe code of this driver.
#![allow(unsafe_code)]

use std::ptr::NonNull;

#[repr(C)]
#[derive(Clone, Copy, Default)]
pub(super) struct RawEvent {
    pub at: u64,
    pub value: u16,
    pub kind: u8,
    pub on: u8,
}

#[repr(C)]
struct RawHost {
    _private: [u8; 0],
}

unsafe extern "C" {
    fn wb_host_new() -> *mut RawHost;
    fn wb_host_free(host: *mut RawHost);
    fn wb_host_reset(host: *mut RawHost, cause: u8);
    fn wb_host_restart_clock(host: *mut RawHost);
    fn wb_host_receive(host: *mut RawHost, byte: u8, damaged: bool);
    fn wb_host_receive_all(host: *mut RawHost, bytes: *const u8, count: usize);
    fn wb_host_busy(host: *mut RawHost, until: u64);
    fn wb_host_switch(host: *mut RawHost, high: bool);
    fn wb_host_inputs(host: *mut RawHost, open: u8);
    fn wb_host_run(host: *mut RawHost, until: u64) -> u64;
    fn wb_host_next(host: *mut RawHost, event: *mut RawEvent) -> bool;
    fn wb_host_fail_after(host: *mut RawHost, bytes: u32);
    fn wb_host_stored(host: *mut RawHost, count: *mut usize) -> *mut u8;
}

/// Owns a `struct wb_host`.
#[derive(Debug)]
pub(super) struct Host(NonNull<RawHost>);

// SAFETY: the C side has no state outside its struct and no thread of its own.
unsafe impl Send for Host {}

impl Host {
    /// `None` when memory has run out.
    pub fn new() -> Option<Self> {
        // SAFETY: takes nothing; gives a new struct or null.
        NonNull::new(unsafe { wb_host_new() }).map(Self)
    }

    pub fn reset(&mut self, cause: u8) {
        // SAFETY: the pointer is that of `new` and lives as long as this; `&mut` makes it the only user.
        unsafe { wb_host_reset(self.0.as_ptr(), cause) }
    }

    pub fn restart_clock(&mut self) {
        // SAFETY: as in `reset`.
        unsafe { wb_host_restart_clock(self.0.as_ptr()) }
    }

    pub fn receive(&mut self, byte: u8, damaged: bool) {
        // SAFETY: as in `reset`.
        unsafe { wb_host_receive(self.0.as_ptr(), byte, damaged) }
    }

    pub fn receive_all(&mut self, bytes: &[u8]) {
        // SAFETY: as in `reset`; the bytes are read, not kept.
        unsafe { wb_host_receive_all(self.0.as_ptr(), bytes.as_ptr(), bytes.len()) }
    }

    pub fn busy(&mut self, until: u64) {
        // SAFETY: as in `reset`.
        unsafe { wb_host_busy(self.0.as_ptr(), until) }
    }

    pub fn switch(&mut self, high: bool) {
        // SAFETY: as in `reset`.
        unsafe { wb_host_switch(self.0.as_ptr(), high) }
    }

    pub fn inputs(&mut self, open: u8) {
        // SAFETY: as in `reset`.
        unsafe { wb_host_inputs(self.0.as_ptr(), open) }
    }

    pub fn run(&mut self, until: u64) -> u64 {
        // SAFETY: as in `reset`.
        unsafe { wb_host_run(self.0.as_ptr(), until) }
    }

    pub fn next(&mut self) -> Option<RawEvent> {
        let mut event = RawEvent::default();
        // SAFETY: as in `reset`; `event` is written, not kept.
        unsafe { wb_host_next(self.0.as_ptr(), &raw mut event) }.then_some(event)
    }

    pub fn fail_after(&mut self, bytes: u32) {
        // SAFETY: as in `reset`.
        unsafe { wb_host_fail_after(self.0.as_ptr(), bytes) }
    }

    pub fn stored(&mut self) -> &mut [u8] {
        let mut count = 0;
        // SAFETY: as in `reset`; the bytes are part of the struct, `count` of them, and borrowed with it.
        unsafe {
            let bytes = wb_host_stored(self.0.as_ptr(), &raw mut count);
            std::slice::from_raw_parts_mut(bytes, count)
        }
    }
}

impl Drop for Host {
    fn drop(&mut self) {
        // SAFETY: freed once, by its owner.
        unsafe { wb_host_free(self.0.as_ptr()) }
    }
}
