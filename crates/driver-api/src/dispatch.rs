//! JSON in, trait methods, JSON out. Nothing here is unsafe.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};

use serde::{Deserialize, Serialize};
use serde_json::json;

use crate::{Call, Description, DriverError, MachineDriver, MachineSession, Ports};

/// What a function of the table answers: JSON, or a refusal.
pub(crate) type Answer = Result<Vec<u8>, DriverError>;

/// The description of a driver with the schema of its settings.
#[must_use]
pub fn describe_json<D: MachineDriver>() -> Description {
    Description { settings_schema: schemars::schema_for!(D::Settings).to_value(), ..D::describe() }
}

/// A driver with settings, and its session when it is connected.
pub(crate) struct Instance<D> {
    driver: D,
    session: Option<Box<dyn MachineSession>>,
    panicked: bool,
}

pub(crate) fn describe<D: MachineDriver>() -> Answer {
    guard(|| to_json(&describe_json::<D>()))
}

impl<D: MachineDriver> Instance<D> {
    pub fn open(settings: &[u8]) -> Result<Self, DriverError> {
        let settings = if settings.is_empty() { b"{}" } else { settings };
        let settings = serde_json::from_slice(settings).map_err(|error| {
            DriverError::new(
                "settings",
                format!("the settings cannot be used: {error}"),
                "see the settings' schema",
            )
        })?;
        let driver = guard(|| D::open(settings))?;
        Ok(Self { driver, session: None, panicked: false })
    }

    pub fn call(&mut self, request: &[u8]) -> Answer {
        let call = parse(request)?;
        self.guarded(|this| this.answer(call))
    }

    /// The next event as JSON; no bytes when there is none.
    pub fn poll(&mut self) -> Answer {
        self.guarded(|this| {
            match this.session.as_mut().map(|session| session.poll()).transpose()?.flatten() {
                Some(event) => to_json(&event),
                None => Ok(Vec::new()),
            }
        })
    }

    /// What panicked once is in no state to go on.
    fn guarded(&mut self, work: impl FnOnce(&mut Self) -> Answer) -> Answer {
        if self.panicked {
            let message = "the driver failed in an earlier call";
            return Err(DriverError::new(DriverError::PANICKED, message, "close it and open it again"));
        }
        let answer = guard(|| work(self));
        if answer.as_ref().is_err_and(|error| error.code == DriverError::PANIC) {
            self.panicked = true;
            self.session = None;
        }
        answer
    }

    fn answer(&mut self, call: Call) -> Answer {
        match call {
            Call::Encode(asked) => return to_json(&self.driver.encode(&asked.format, &asked.job)?),
            Call::Ports => return to_json(&Ports { ports: self.driver.ports()? }),
            Call::Limits => return to_json(&self.driver.limits()),
            Call::Connect { port, resume } => {
                if self.session.is_some() {
                    let message = "the driver has a connection already";
                    return Err(DriverError::new("connected", message, "disconnect first"));
                }
                self.session = Some(self.driver.connect(&port, resume.as_deref())?);
            }
            Call::Disconnect => self.session = None,
            Call::Send(batch) => return to_json(&self.session()?.send(&batch)?),
            Call::Home { head_at_deg: Some(deg) } => self.session()?.home_from(deg)?,
            Call::Home { head_at_deg: None } => self.session()?.home()?,
            Call::Arm(run) => return to_json(&self.session()?.arm(&run)?),
            Call::Jog(motion) => self.session()?.jog(motion)?,
            Call::Pause => self.session()?.pause()?,
            Call::Resume => self.session()?.resume()?,
            Call::Stop => self.session()?.stop()?,
            Call::WriteSettings => self.session()?.write_settings()?,
        }
        to_json(&json!({}))
    }

    fn session(&mut self) -> Result<&mut Box<dyn MachineSession>, DriverError> {
        let refused = || DriverError::new("not-connected", "the driver has no connection", "connect first");
        self.session.as_mut().ok_or_else(refused)
    }
}

fn parse(request: &[u8]) -> Result<Call, DriverError> {
    #[derive(Deserialize)]
    struct Named {
        call: String,
    }
    let unreadable = |error: serde_json::Error| {
        DriverError::new("request", format!("the request cannot be read: {error}"), "see the schema of calls")
    };
    let named: Named = serde_json::from_slice(request).map_err(unreadable)?;
    // A job is large, and reading it through the enum would hold all of it twice.
    if named.call == "encode" {
        return serde_json::from_slice(request)
            .map(|asked| Call::Encode(Box::new(asked)))
            .map_err(unreadable);
    }
    serde_json::from_slice(request).map_err(|error| {
        if error.to_string().starts_with("unknown variant") {
            let message = format!("'{}' is not a call that this driver knows", named.call);
            return DriverError::new(
                "unknown-call",
                message,
                "it may be older than the program: look for a newer one",
            );
        }
        unreadable(error)
    })
}

fn to_json(value: &impl Serialize) -> Answer {
    serde_json::to_vec(value)
        .map_err(|error| DriverError::new("reply", format!("the reply cannot be written: {error}"), ""))
}

/// Runs a driver's code; a panic becomes a refusal.
pub(crate) fn guard<T>(work: impl FnOnce() -> Result<T, DriverError>) -> Result<T, DriverError> {
    catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|cause| {
        Err(DriverError::new(
            DriverError::PANIC,
            format!("the driver failed: {}", said(cause.as_ref())),
            "report this to its author",
        ))
    })
}

fn said(cause: &(dyn Any + Send)) -> &str {
    let text = cause.downcast_ref::<&str>().copied();
    text.or_else(|| cause.downcast_ref::<String>().map(String::as_str)).unwrap_or("without a word")
}
