//! JSON in, trait methods, JSON out. Nothing here is unsafe.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};

use serde::de::IntoDeserializer;
use serde::de::value::{Error as ValueError, StrDeserializer};
use serde::{Deserialize, Serialize};
use serde_json::json;

use crate::call::{CallName, SPEEDS};
use crate::{Call, ConsoleLine, Description, DriverError, MachineDriver, MachineSession, Ports};

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

    /// What panicked once is in no state to continue.
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
            Call::Speed { percent } if SPEEDS.contains(&percent) => self.session()?.set_speed(percent)?,
            Call::Speed { percent } => {
                let what = format!(
                    "a speed of {percent} % is not possible: {} to {} % are",
                    SPEEDS.start(),
                    SPEEDS.end()
                );
                return Err(DriverError::new("speed", what, ""));
            }
            Call::Console { line, may_change } => {
                let line = ConsoleLine::new(&line)?;
                self.session()?.console(&line, may_change)?;
            }
            Call::Cut => self.session()?.cut()?,
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
    let Named { call } = serde_json::from_slice(request).map_err(unreadable)?;
    let text: StrDeserializer<'_, ValueError> = call.as_str().into_deserializer();
    let Ok(name) = CallName::deserialize(text) else {
        let message = format!("'{call}' is not a call that this driver knows");
        let help = "it may be older than the program: look for a newer one";
        return Err(DriverError::new("unknown-call", message, help));
    };
    // A job is large, and reading it through the enum would hold all of it twice.
    if name == CallName::Encode {
        return serde_json::from_slice(request)
            .map(|asked| Call::Encode(Box::new(asked)))
            .map_err(unreadable);
    }
    serde_json::from_slice(request).map_err(unreadable)
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
    text.or_else(|| cause.downcast_ref::<String>().map(String::as_str)).unwrap_or("no message")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::conformance::sample_job;
    use crate::{Axis, Batch, Encode, Motion, Run};

    /// The name of every call: a new one does not compile here before it has one.
    const fn name(call: &Call) -> CallName {
        match call {
            Call::Encode(_) => CallName::Encode,
            Call::Ports => CallName::Ports,
            Call::Limits => CallName::Limits,
            Call::Connect { .. } => CallName::Connect,
            Call::Disconnect => CallName::Disconnect,
            Call::Home { .. } => CallName::Home,
            Call::Arm(_) => CallName::Arm,
            Call::Send(_) => CallName::Send,
            Call::Jog(_) => CallName::Jog,
            Call::Speed { .. } => CallName::Speed,
            Call::Console { .. } => CallName::Console,
            Call::Cut => CallName::Cut,
            Call::Pause => CallName::Pause,
            Call::Resume => CallName::Resume,
            Call::Stop => CallName::Stop,
            Call::WriteSettings => CallName::WriteSettings,
        }
    }

    /// A driver that took a call of its own for an unknown one would be of no use to the program.
    #[test]
    fn every_call_is_known_by_its_name() {
        let calls = [
            Call::Encode(Box::new(Encode { format: "x".to_owned(), job: sample_job() })),
            Call::Ports,
            Call::Limits,
            Call::Connect { port: "p".to_owned(), resume: None },
            Call::Disconnect,
            Call::Home { head_at_deg: None },
            Call::Arm(Run::default()),
            Call::Send(Batch { steps: Vec::new(), last: true }),
            Call::Jog(Motion::new(Axis::Feed, 1.0)),
            Call::Speed { percent: 50 },
            Call::Console { line: "$$".to_owned(), may_change: false },
            Call::Cut,
            Call::Pause,
            Call::Resume,
            Call::Stop,
            Call::WriteSettings,
        ];
        for call in calls {
            let parsed = parse(&serde_json::to_vec(&call).unwrap());
            assert_eq!(parsed.as_ref().map(name), Ok(name(&call)), "{parsed:?}");
        }
    }

    #[test]
    fn an_unknown_call_is_told_apart_from_a_damaged_one() {
        let code = |request: &str| parse(request.as_bytes()).unwrap_err().code;
        assert_eq!(code(r#"{"call":"fold"}"#), "unknown-call");
        for damaged in
            [r#"{"call":"connect"}"#, r#"{"call":7}"#, "{}", r#"{"call":"jog","axis":"unknown variant"}"#]
        {
            assert_eq!(code(damaged), "request", "{damaged}");
        }
    }
}
