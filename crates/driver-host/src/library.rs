//! Loading the library of a driver: only ever in a process of its own.

#![allow(unsafe_code)] // loading a library runs its code; that is why this process is alone

use std::path::Path;

use wirebend_driver_api::{ABI_MAJOR, ENTRY_SYMBOL, Entry, SafeTable, TableError};

/// Why a library is no driver that this program can use.
#[derive(Debug, thiserror::Error)]
pub(crate) enum LoadError {
    #[error("it is not a library that this computer can load: {0}")]
    Library(String),
    #[error("it does not export '{ENTRY_SYMBOL}': it is no WireBend driver")]
    Symbol,
    #[error(transparent)]
    Table(#[from] TableError),
}

impl LoadError {
    pub fn code(&self) -> &'static str {
        match self {
            Self::Library(_) => "library",
            Self::Symbol => "symbol",
            Self::Table(TableError::Version { major, .. }) if *major > ABI_MAJOR => "newer-version",
            Self::Table(TableError::Version { .. }) => "older-version",
            Self::Table(_) => "table",
        }
    }
}

/// An error with its causes: the first says "dlopen failed", the last why.
fn in_full(error: &dyn std::error::Error) -> String {
    let causes = std::iter::successors(Some(error), |error| error.source());
    causes.map(ToString::to_string).collect::<Vec<_>>().join(": ")
}

/// Loads a library and checks its table.
pub(crate) fn load(file: &Path) -> Result<SafeTable, LoadError> {
    // SAFETY: whatever the library does on loading, it does to this process alone.
    let library =
        unsafe { libloading::Library::new(file) }.map_err(|error| LoadError::Library(in_full(&error)))?;
    // SAFETY: the symbol has this type in every driver; one that has not harms this process alone.
    let entry = unsafe { library.get::<Entry>(ENTRY_SYMBOL.as_bytes()) }.map_err(|_| LoadError::Symbol)?;
    // SAFETY: as above.
    let table = unsafe { SafeTable::new(entry()) }?;
    // The table points into the library, which stays until the process ends.
    std::mem::forget(library);
    Ok(table)
}
