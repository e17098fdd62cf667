//! What the rules are tried on: a table in this process, or a library behind a process of its own.

use crate::{DriverError, MachineDriver, Reply, SafeTable, TableError};

/// A driver that broke the boundary itself, so that nothing more can be said: what happened.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Broken(pub String);

/// A driver under examination.
pub trait Subject {
    /// The description.
    ///
    /// # Errors
    /// [`Broken`].
    fn describe(&mut self) -> Result<Reply, Broken>;

    /// Opens an instance, after closing the one before.
    ///
    /// # Errors
    /// [`Broken`].
    fn open(&mut self, settings: &[u8]) -> Result<Reply, Broken>;

    /// Asks the open instance.
    ///
    /// # Errors
    /// [`Broken`].
    fn call(&mut self, request: &[u8]) -> Result<Reply, Broken>;

    /// The next event.
    ///
    /// # Errors
    /// [`Broken`].
    fn poll(&mut self) -> Result<Reply, Broken>;

    /// Closes the open instance, if there is one.
    ///
    /// # Errors
    /// [`Broken`].
    fn close(&mut self) -> Result<(), Broken>;
}

/// A driver in this process.
pub(super) struct InProcess(Result<SafeTable, TableError>);

impl InProcess {
    #[allow(unsafe_code)]
    pub fn new<D: MachineDriver>() -> Self {
        let table = crate::table::<D>();
        // SAFETY: the table is complete and of this version; it is copied at once.
        Self(unsafe { SafeTable::new(&raw const table) })
    }

    fn table(&mut self) -> Result<&mut SafeTable, Broken> {
        self.0.as_mut().map_err(|error| Broken::from(error.clone()))
    }
}

impl From<TableError> for Broken {
    fn from(error: TableError) -> Self {
        Self(error.to_string())
    }
}

impl Subject for InProcess {
    fn describe(&mut self) -> Result<Reply, Broken> {
        Ok(self.table()?.describe()?)
    }

    fn open(&mut self, settings: &[u8]) -> Result<Reply, Broken> {
        Ok(self.table()?.open(settings)?)
    }

    fn call(&mut self, request: &[u8]) -> Result<Reply, Broken> {
        Ok(self.table()?.call(request)?)
    }

    fn poll(&mut self) -> Result<Reply, Broken> {
        Ok(self.table()?.poll()?)
    }

    fn close(&mut self) -> Result<(), Broken> {
        Ok(self.table()?.close()?)
    }
}

/// The result of something that has to be done.
pub(super) fn done(reply: Result<Reply, Broken>) -> Result<Vec<u8>, String> {
    match reply.map_err(|broken| broken.0)? {
        Reply::Ok(bytes) => Ok(bytes),
        Reply::Refused(bytes) => Err(format!("it was refused: {}", refusal(&bytes)?)),
    }
}

/// The refusal of something that has to be refused.
pub(super) fn refused(reply: Result<Reply, Broken>) -> Result<DriverError, String> {
    match reply.map_err(|broken| broken.0)? {
        Reply::Ok(_) => Err("it was accepted".to_owned()),
        Reply::Refused(bytes) => refusal(&bytes),
    }
}

fn refusal(bytes: &[u8]) -> Result<DriverError, String> {
    let text = String::from_utf8_lossy(bytes);
    let error: DriverError = serde_json::from_slice(bytes).map_err(|error| {
        format!("a refusal must be {{\"code\", \"message\", \"help\"}}: {error} in: {text}")
    })?;
    if !is_slug(&error.code) {
        return Err(format!("the code of a refusal is a word in lower case, with hyphens: '{}'", error.code));
    }
    if error.message.trim().is_empty() {
        return Err(format!("the refusal '{}' says nothing", error.code));
    }
    Ok(error)
}

/// Lower-case letters, digits and single hyphens between them.
pub(super) fn is_slug(text: &str) -> bool {
    let part = |part: &str| {
        !part.is_empty() && part.bytes().all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit())
    };
    text.split('-').all(part)
}
