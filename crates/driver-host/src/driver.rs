//! A driver in its process: started, opened with settings, asked.

use std::ffi::OsString;
use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

use serde::de::DeserializeOwned;
use serde_json::Value;
use wirebend_driver_api::conformance::{Broken, Subject};
use wirebend_driver_api::{
    Call, Capability, Content, Description, DriverError, Encode, Encoded, Event, Job, Limits, Port, Ports,
    Reply, Step, deadline,
};

use crate::child::MINOR;
use crate::ending::Ending;
use crate::error::HostError;
use crate::frame::{Frame, Mark};
use crate::process::{Failure, Process, ProcessHandle};
use crate::registry::{DiscoveredDriver, TrustStatus};
use crate::trust::Fingerprint;

/// Which program is the process of a driver, and what it may use.
#[derive(Debug, Clone)]
pub struct Launch {
    /// The program; it hands what follows [`CHILD_COMMAND`](crate::CHILD_COMMAND) to
    /// [`child_main`](crate::child_main).
    pub program: PathBuf,
    /// How much memory a driver may have for itself, bytes.
    pub memory_bytes: u64,
}

/// A job of a hundred thousand steps is some 30 MB as text, and a driver holds it a few times over.
const MEMORY_BYTES: u64 = 512 << 20;

impl Launch {
    /// The running program itself.
    ///
    /// # Errors
    /// When the system does not report which file that is.
    pub fn this_program() -> io::Result<Self> {
        Ok(Self { program: std::env::current_exe()?, memory_bytes: MEMORY_BYTES })
    }
}

/// A driver that has said what it is.
#[derive(Debug)]
pub struct Driver {
    link: Link,
    description: Description,
    minor: u64,
}

/// A process with the name that messages use.
#[derive(Debug)]
struct Link {
    process: Process,
    name: String,
}

impl Driver {
    /// Starts a library that may be loaded.
    ///
    /// # Errors
    /// [`HostError::NotTrusted`], [`HostError::Changed`] or [`HostError::Unsafe`] when it may not; else as every
    /// call.
    pub fn start(found: &DiscoveredDriver, launch: &Launch) -> Result<Self, HostError> {
        let file = found.file.clone();
        let expected = match &found.verdict {
            TrustStatus::Shipped => None,
            TrustStatus::Accepted(hash) => Some(*hash),
            TrustStatus::Unknown(hash) => return Err(HostError::NotTrusted { file, hash: *hash }),
            TrustStatus::Changed(hash) => return Err(HostError::Changed { file, hash: *hash }),
            TrustStatus::Refused(reason) => return Err(HostError::Unsafe { file, reason: reason.clone() }),
        };
        let (mut link, greeting) = Link::start(&file, expected.as_ref(), launch)?;
        let description: Description = link.parse("its start", &greeting)?;
        let keys: Value = link.parse("its start", &greeting)?;
        let minor = keys.get(MINOR).and_then(Value::as_u64).unwrap_or_default();
        description.id.clone_into(&mut link.name);
        Ok(Self { link, description, minor })
    }

    /// What it says of itself.
    #[must_use]
    pub const fn description(&self) -> &Description {
        &self.description
    }

    /// Gives it settings.
    ///
    /// # Errors
    /// [`HostError::Refused`] when it does not take them; else as every call.
    pub fn open(self, settings: &Value) -> Result<OpenDriver, HostError> {
        let body = settings.to_string().into_bytes();
        self.link.ask("the settings", Mark::Open, body, deadline::OPEN)?;
        Ok(OpenDriver { link: self.link, description: self.description, minor: self.minor })
    }

    #[must_use]
    pub fn process_id(&self) -> u32 {
        self.link.process.id()
    }
}

/// A driver with settings. One that has failed answers every later call with [`HostError::Ended`].
#[derive(Debug)]
pub struct OpenDriver {
    link: Link,
    description: Description,
    minor: u64,
}

impl OpenDriver {
    /// What it says of itself.
    #[must_use]
    pub const fn description(&self) -> &Description {
        &self.description
    }

    /// The minor version of the boundary that it was built against: what a later one has it does not know, and
    /// passes over.
    #[must_use]
    pub const fn minor(&self) -> u64 {
        self.minor
    }

    /// Writes a job.
    ///
    /// # Errors
    /// [`HostError`].
    pub fn encode(&self, format: &str, job: Job) -> Result<Encoded, HostError> {
        let told = self.description().format(format).is_some_and(|format| format.content == Content::Machine);
        for (wire, steps) in job.wires.iter().enumerate().filter(|_| told) {
            let place = |step: usize| format!("step {} of wire {}", step + 1, wire + 1);
            let steps = steps.machine.iter().flatten().enumerate();
            steps.map(|(step, told)| (place(step), told)).try_for_each(|(at, told)| self.takes(&at, told))?;
        }
        self.call_for(
            "the job",
            &Call::Encode(Box::new(Encode { format: format.to_owned(), job })),
            deadline::ENCODE,
        )
    }

    /// Refuses a step that a driver without the capability would bend to the wrong side. `at`: which step it is.
    pub(crate) fn takes(&self, at: &str, step: &Step) -> Result<(), HostError> {
        if !step.ends_before_zero() || self.description().can(Capability::BeforeZero) {
            return Ok(());
        }
        let message = format!(
            "the bend axis stops before zero in {at}, at {:.2}°, and this driver cannot tell its machine to which side that is",
            step.bend_deg
        );
        let help = "set 'bend.before_zero' of the machine's profile to false, and plan the design again";
        let error = DriverError::new("unsupported", message, help);
        Err(HostError::Refused { driver: self.description().id.clone(), error })
    }

    /// The ports that one of its machines can be at.
    ///
    /// # Errors
    /// [`HostError::Refused`] for a driver that lacks `ports`; else as every call.
    pub fn ports(&self) -> Result<Vec<Port>, HostError> {
        self.call_for::<Ports>("the ports", &Call::Ports, deadline::CALL).map(|listed| listed.ports)
    }

    /// How far the axes of its machine go and how fast; nothing for a driver that was built before it could be asked.
    ///
    /// # Errors
    /// [`HostError`].
    pub fn limits(&self) -> Result<Limits, HostError> {
        match self.call_for("its limits", &Call::Limits, deadline::CALL) {
            Err(HostError::Refused { error, .. })
                if ["unknown-call", "unsupported"].contains(&error.code.as_str()) =>
            {
                Ok(Limits::default())
            }
            told => told,
        }
    }

    /// Asks something whose answer has a shape.
    pub(crate) fn call_for<T: DeserializeOwned>(
        &self,
        during: &'static str,
        call: &Call,
        deadline: Duration,
    ) -> Result<T, HostError> {
        self.motion_for(during, call, deadline, || true)
    }

    /// The same for a motion, if it is still allowed when it takes its place in the queue.
    pub(crate) fn motion_for<T: DeserializeOwned>(
        &self,
        during: &'static str,
        call: &Call,
        deadline: Duration,
        allowed: impl FnOnce() -> bool,
    ) -> Result<T, HostError> {
        let frame = self.link.process.handle().request_if(Mark::Call, to_body(call), deadline, allowed);
        let reply = self.link.answer(during, frame, deadline)?;
        self.link.parse(during, &reply)
    }

    /// Asks something whose answer only says that it was done.
    ///
    /// # Errors
    /// [`HostError`].
    pub fn call(&self, during: &'static str, call: &Call) -> Result<(), HostError> {
        self.call_for::<Value>(during, call, deadline::CALL).map(drop)
    }

    /// What there is to report.
    ///
    /// # Errors
    /// [`HostError`].
    pub fn poll(&self) -> Result<Vec<Event>, HostError> {
        let reply = self.link.ask("polling", Mark::Poll, Vec::new(), deadline::POLL)?;
        self.link.parse("polling", &reply)
    }

    /// Closes it, and ends its process.
    ///
    /// # Errors
    /// [`HostError`]; its process has ended in any case.
    pub fn close(self) -> Result<(), HostError> {
        self.link.ask("closing", Mark::Close, Vec::new(), deadline::CLOSE).map(drop)
    }

    pub(crate) fn handle(&self) -> ProcessHandle {
        self.link.process.handle().clone()
    }

    #[must_use]
    pub fn process_id(&self) -> u32 {
        self.link.process.id()
    }
}

pub(crate) fn to_body(call: &Call) -> Vec<u8> {
    // Calls are plain values: nothing in them cannot be written.
    serde_json::to_vec(call).unwrap_or_default()
}

impl Link {
    fn start(
        file: &Path,
        expected: Option<&Fingerprint>,
        launch: &Launch,
    ) -> Result<(Self, Vec<u8>), HostError> {
        let name = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let hash = expected.map_or_else(|| "-".to_owned(), ToString::to_string);
        let arguments: [OsString; 4] =
            [crate::CHILD_COMMAND.into(), file.into(), hash.into(), launch.memory_bytes.to_string().into()];
        let started = Process::start(&launch.program, &arguments);
        let (process, greeting) =
            started.map_err(|cause| HostError::Start { driver: name.clone(), cause })?;
        let link = Self { process, name };
        let frame = link.process.greeting(&greeting, deadline::START);
        match frame.map_err(|failure| link.failed("its start", failure, deadline::START))? {
            Frame { mark: Mark::Ok, body, .. } => Ok((link, body)),
            Frame { mark: Mark::Refused, body, .. } => Err(link.refused("its start", &body)),
            Frame { body, .. } => {
                let error: DriverError = link.parse("its start", &body)?;
                Err(HostError::Load {
                    driver: link.name,
                    code: error.code.clone(),
                    reason: error.to_string(),
                })
            }
        }
    }

    fn ask(
        &self,
        during: &'static str,
        mark: Mark,
        body: Vec<u8>,
        deadline: Duration,
    ) -> Result<Vec<u8>, HostError> {
        self.answer(during, self.process.handle().request(mark, body, deadline), deadline)
    }

    fn answer(
        &self,
        during: &'static str,
        frame: Result<Frame, Failure>,
        deadline: Duration,
    ) -> Result<Vec<u8>, HostError> {
        match frame.map_err(|failure| self.failed(during, failure, deadline))? {
            Frame { mark: Mark::Ok, body, .. } => Ok(body),
            Frame { mark: Mark::Refused, body, .. } => Err(self.refused(during, &body)),
            Frame { body, .. } => {
                let error: DriverError = self.parse(during, &body)?;
                Err(self.broken(during, error.to_string()))
            }
        }
    }

    fn parse<T: DeserializeOwned>(&self, during: &'static str, body: &[u8]) -> Result<T, HostError> {
        serde_json::from_slice(body)
            .map_err(|error| self.broken(during, format!("its answer has the wrong shape: {error}")))
    }

    fn refused(&self, during: &'static str, body: &[u8]) -> HostError {
        match self.parse(during, body) {
            Ok(error) => HostError::Refused { driver: self.name.clone(), error },
            Err(error) => error,
        }
    }

    fn broken(&self, during: &'static str, reason: String) -> HostError {
        HostError::Broken { driver: self.name.clone(), during, reason }
    }

    fn failed(&self, during: &'static str, failure: Failure, deadline: Duration) -> HostError {
        let (driver, said) = (self.name.clone(), self.process.said());
        match failure {
            Failure::Hung => HostError::Hung { driver, during, deadline, said },
            Failure::Ended(Ending::Died(how)) => HostError::Died { driver, during, how, said },
            Failure::Ended(Ending::Garbage) => HostError::Garbage { driver, during },
            Failure::Ended(Ending::TooLarge(bytes)) => HostError::TooLarge { driver, during, bytes },
            Failure::Ended(Ending::Killed) => HostError::Ended { driver },
            Failure::NotAllowed => HostError::StoppedBefore { during },
        }
    }
}

/// A library under examination, whether it is trusted or not: a person has named it to have it run.
#[derive(Debug)]
pub struct Examined(Link);

impl Examined {
    /// Starts a library in order to see whether it keeps the rules. This runs its code.
    ///
    /// # Errors
    /// [`HostError`] when it cannot be used at all.
    pub fn start(library: &Path, launch: &Launch) -> Result<Self, HostError> {
        Ok(Self(Link::start(library, None, launch)?.0))
    }

    fn ask(
        &self,
        during: &'static str,
        mark: Mark,
        body: &[u8],
        deadline: Duration,
    ) -> Result<Reply, Broken> {
        let frame = self.0.process.handle().request(mark, body.to_vec(), deadline);
        match frame.map_err(|failure| Broken(self.0.failed(during, failure, deadline).to_string()))? {
            Frame { mark: Mark::Ok, body, .. } => Ok(Reply::Ok(body)),
            Frame { mark: Mark::Refused, body, .. } => Ok(Reply::Refused(body)),
            Frame { body, .. } => Err(Broken(String::from_utf8_lossy(&body).into_owned())),
        }
    }
}

impl Subject for Examined {
    fn describe(&mut self) -> Result<Reply, Broken> {
        self.ask("the description", Mark::Describe, b"", deadline::START)
    }

    fn open(&mut self, settings: &[u8]) -> Result<Reply, Broken> {
        self.ask("the settings", Mark::Open, settings, deadline::OPEN)
    }

    fn call(&mut self, request: &[u8]) -> Result<Reply, Broken> {
        let encoding = request.starts_with(b"{\"call\":\"encode\"");
        self.ask("a call", Mark::Call, request, if encoding { deadline::ENCODE } else { deadline::CALL })
    }

    fn poll(&mut self) -> Result<Reply, Broken> {
        // One event is one event here, and no event no bytes.
        match self.ask("polling", Mark::Poll, b"", deadline::POLL)? {
            Reply::Ok(events) if events == b"[]" => Ok(Reply::Ok(Vec::new())),
            reply => Ok(reply),
        }
    }

    fn close(&mut self) -> Result<(), Broken> {
        self.ask("closing", Mark::Close, b"", deadline::CLOSE).map(drop)
    }
}
