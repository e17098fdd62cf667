//! A file to which lines are only added, each on the disk before anything else happens.
//!
//! Each line is JSON: its number, a hash over it and all lines before, and an entry. What an entry says is its
//! writer's affair. Whatever happens to the program or to the power, the file can be read to its last whole line.
//!
//! ```
//! use wirebend_journal::Log;
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! let folder = tempfile::tempdir()?;
//! let path = folder.path().join("a.journal");
//! let mut log = Log::create(&path, r#"{"begun":true}"#)?;
//! log.add("1")?;
//! assert_eq!(Log::read(&path)?.entries, [r#"{"begun":true}"#, "1"]);
//! # Ok(())
//! # }
//! ```

mod chain;
mod error;
mod log;
mod reading;
#[cfg(test)]
mod tests;

pub use error::LogError;
pub use log::Log;
pub use reading::Lines;
