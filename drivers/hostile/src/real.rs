//! A real driver in whose place this one stands, with its machine: the library `WHEN-HOW.real` beside this one. It does all that
//! is asked, but where this one misbehaves.

use libloading::Library;
use wirebend_driver_api::{ENTRY_SYMBOL, Entry, Reply, SafeTable, TableError};

use crate::conduct::beside;

/// Its table, where there is one.
pub(crate) fn table() -> Option<SafeTable> {
    let file = beside("real").filter(|file| file.exists())?;
    // SAFETY: what the library does, it does to this process alone, which is that of a driver.
    let library = unsafe { Library::new(file) }.ok()?;
    // SAFETY: the symbol has this type in every driver.
    let entry = unsafe { library.get::<Entry>(ENTRY_SYMBOL.as_bytes()) }.ok()?;
    // SAFETY: as above.
    let table = unsafe { SafeTable::new(entry()) }.ok()?;
    // The table points into it.
    std::mem::forget(library);
    Some(table)
}

/// What it has answered.
pub(crate) fn text(reply: Result<Reply, TableError>) -> Result<String, String> {
    let text = |bytes: Vec<u8>| String::from_utf8_lossy(&bytes).into_owned();
    match reply {
        Ok(Reply::Ok(bytes)) => Ok(text(bytes)),
        Ok(Reply::Refused(bytes)) => Err(text(bytes)),
        Err(error) => Err(serde_json::json!({"code": "table", "message": error.to_string()}).to_string()),
    }
}
