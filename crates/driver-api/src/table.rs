//! The program's side of the table: checked once, then safe to use.

#![allow(unsafe_code)] // the boundary itself; every block says what it relies on

use std::ffi::{CString, c_void};

use crate::{ABI_MAJOR, ABI_MINOR, Buffer, Bytes, OK, REFUSED, Table};

/// The most that a driver may answer at once, in bytes.
const MAX_BYTES: usize = 64 << 20;

/// What a driver answered.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Reply {
    /// Its result.
    Ok(Vec<u8>),
    /// A [`DriverError`](crate::DriverError) as JSON.
    Refused(Vec<u8>),
}

/// A driver that does not keep to the table.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum TableError {
    /// The entry function gave nothing.
    #[error("{} returned no table", crate::ENTRY_SYMBOL)]
    NoTable,
    /// The driver speaks another major version.
    #[error(
        "the driver was built for version {major}.{minor} of the driver interface, this program speaks {ABI_MAJOR}.{ABI_MINOR}"
    )]
    Version {
        /// The driver's.
        major: u32,
        /// The driver's.
        minor: u32,
    },
    /// The table has a hole.
    #[error("the function '{0}' is missing from the driver's table; all of them are needed")]
    Missing(&'static str),
    /// A status that does not exist.
    #[error("'{function}' returned the status {status}; there are only {OK} and {REFUSED}")]
    Status {
        /// Which function.
        function: &'static str,
        /// What it returned.
        status: i32,
    },
    /// A length without bytes.
    #[error("'{0}' gave a length and no bytes")]
    NullBytes(&'static str),
    /// `open` said that all is well and gave nothing.
    #[error("'open' succeeded and gave no instance")]
    NoInstance,
    /// There is no instance to ask.
    #[error("'{0}' needs an open instance")]
    NotOpen(&'static str),
    /// An answer beyond all measure.
    #[error("'{function}' answered {len} bytes; the most is {MAX_BYTES}")]
    TooLarge {
        /// Which function.
        function: &'static str,
        /// How many bytes.
        len: usize,
    },
}

/// A table whose functions are all there, and at most one open instance.
#[derive(Debug)]
pub struct SafeTable {
    table: Table,
    instance: *mut c_void,
}

macro_rules! function {
    ($table:expr, $name:ident) => {
        $table.$name.ok_or(TableError::Missing(stringify!($name)))
    };
}

impl SafeTable {
    /// Checks a table: the version first, from its first eight bytes, then that every function is there.
    ///
    /// # Errors
    /// [`TableError::NoTable`], [`TableError::Version`], [`TableError::Missing`].
    ///
    /// # Safety
    /// A table that is not null starts with its two version numbers, is as large as [`Table`] when its
    /// major is [`ABI_MAJOR`], stays valid, and its functions keep to the rules of the boundary. The
    /// result stays on the thread that calls it.
    pub unsafe fn new(table: *const Table) -> Result<Self, TableError> {
        if table.is_null() {
            return Err(TableError::NoTable);
        }
        // SAFETY: both numbers are at the start of every version of the table.
        let (major, minor) =
            unsafe { ((&raw const (*table).abi_major).read(), (&raw const (*table).abi_minor).read()) };
        if major != ABI_MAJOR {
            return Err(TableError::Version { major, minor });
        }
        // SAFETY: promised for this major.
        let table = unsafe { table.read() };
        function!(table, describe)?;
        function!(table, open)?;
        function!(table, call)?;
        function!(table, poll)?;
        function!(table, close)?;
        function!(table, free)?;
        function!(table, extension)?;
        Ok(Self { table, instance: std::ptr::null_mut() })
    }

    /// Major and minor version that the driver was built against.
    #[must_use]
    pub const fn version(&self) -> (u32, u32) {
        (self.table.abi_major, self.table.abi_minor)
    }

    /// The description.
    ///
    /// # Errors
    /// [`TableError`] when the driver breaks a rule of the boundary.
    pub fn describe(&mut self) -> Result<Reply, TableError> {
        let describe = function!(self.table, describe)?;
        // SAFETY: `out` is a place for a buffer.
        self.collect("describe", |out| unsafe { describe(out) })
    }

    /// Opens an instance, after closing the one before.
    ///
    /// # Errors
    /// As [`SafeTable::describe`].
    pub fn open(&mut self, settings: &[u8]) -> Result<Reply, TableError> {
        self.close()?;
        let open = function!(self.table, open)?;
        let mut instance = std::ptr::null_mut();
        // SAFETY: `settings` lives through the call, both places exist.
        let reply = self.collect("open", |out| unsafe { open(bytes(settings), &raw mut instance, out) })?;
        if matches!(reply, Reply::Ok(_)) {
            if instance.is_null() {
                return Err(TableError::NoInstance);
            }
            self.instance = instance;
        }
        Ok(reply)
    }

    /// Asks the open instance.
    ///
    /// # Errors
    /// As [`SafeTable::describe`], and [`TableError::NotOpen`].
    pub fn call(&mut self, request: &[u8]) -> Result<Reply, TableError> {
        let call = function!(self.table, call)?;
        let instance = self.instance("call")?;
        // SAFETY: the instance is open, `request` lives through the call.
        self.collect("call", |out| unsafe { call(instance, bytes(request), out) })
    }

    /// The next event of the open instance; no bytes when there is none.
    ///
    /// # Errors
    /// As [`SafeTable::call`].
    pub fn poll(&mut self) -> Result<Reply, TableError> {
        let poll = function!(self.table, poll)?;
        let instance = self.instance("poll")?;
        // SAFETY: the instance is open.
        self.collect("poll", |out| unsafe { poll(instance, out) })
    }

    /// Closes the open instance, if there is one.
    ///
    /// # Errors
    /// [`TableError::Missing`]; never for a checked table.
    pub fn close(&mut self) -> Result<(), TableError> {
        let close = function!(self.table, close)?;
        let instance = std::mem::replace(&mut self.instance, std::ptr::null_mut());
        if !instance.is_null() {
            // SAFETY: the instance was open and is forgotten here.
            unsafe { close(instance) };
        }
        Ok(())
    }

    /// Whether the driver has an extension.
    ///
    /// # Errors
    /// [`TableError::Missing`]; never for a checked table.
    pub fn has_extension(&self, name: &str) -> Result<bool, TableError> {
        let extension = function!(self.table, extension)?;
        let name = CString::new(name).unwrap_or_default();
        // SAFETY: `name` ends with a zero byte and lives through the call.
        Ok(!unsafe { extension(name.as_ptr()) }.is_null())
    }

    fn instance(&self, function: &'static str) -> Result<*mut c_void, TableError> {
        if self.instance.is_null() { Err(TableError::NotOpen(function)) } else { Ok(self.instance) }
    }

    /// Copies what a function gave and hands the buffer back.
    fn collect(
        &self,
        function: &'static str,
        work: impl FnOnce(*mut Buffer) -> i32,
    ) -> Result<Reply, TableError> {
        let free = function!(self.table, free)?;
        let mut out = Buffer::EMPTY;
        let status = work(&raw mut out);
        let copied = if out.len == 0 {
            Ok(Vec::new())
        } else if out.data.is_null() {
            return Err(TableError::NullBytes(function));
        } else if out.len > MAX_BYTES {
            Err(TableError::TooLarge { function, len: out.len })
        } else {
            // SAFETY: the driver says that these bytes are there, and keeps them until `free`.
            Ok(unsafe { std::slice::from_raw_parts(out.data, out.len) }.to_vec())
        };
        // SAFETY: the buffer came from this driver and is not used again.
        unsafe { free(out) };
        match (status, copied?) {
            (OK, bytes) => Ok(Reply::Ok(bytes)),
            (REFUSED, bytes) => Ok(Reply::Refused(bytes)),
            (status, _) => Err(TableError::Status { function, status }),
        }
    }
}

impl Drop for SafeTable {
    fn drop(&mut self) {
        let _ = self.close();
    }
}

const fn bytes(slice: &[u8]) -> Bytes {
    Bytes { data: slice.as_ptr(), len: slice.len() }
}
