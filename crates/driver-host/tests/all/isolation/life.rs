//! The life of a driver: every call once, in order.

use std::time::Duration;

use wirebend_driver_api::conformance::sample_job;
use wirebend_driver_api::{Axis, Motion, NumberedStep, Run, Step, deadline};
use wirebend_driver_host::{
    Armed, DiscoveredDriver, Driver, Launch, OpenDriver, Phase, Session, SessionError,
};

use crate::awake::Awake;
use crate::permits;

/// One thing that a driver is asked. `entry` and `describe` are both part of its start.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stage {
    Start,
    Open,
    Encode,
    Ports,
    Limits,
    Connect,
    Poll,
    WriteSettings,
    Console,
    Home,
    Cut,
    Jog,
    Arm,
    Send,
    Pause,
    Resume,
    Stop,
    Disconnect,
    Close,
}

/// The calls that a connected driver is asked, by the word for which the driver listens.
pub const CALLS: [&str; 12] = [
    "poll",
    "write-settings",
    "console",
    "home",
    "cut",
    "jog",
    "arm",
    "send",
    "pause",
    "resume",
    "stop",
    "disconnect",
];

const ORDER: [Stage; 19] = [
    Stage::Start,
    Stage::Open,
    Stage::Encode,
    Stage::Ports,
    Stage::Limits,
    Stage::Connect,
    Stage::Poll,
    Stage::WriteSettings,
    Stage::Console,
    Stage::Home,
    Stage::Cut,
    Stage::Jog,
    Stage::Arm,
    Stage::Send,
    Stage::Pause,
    Stage::Resume,
    Stage::Stop,
    Stage::Disconnect,
    Stage::Close,
];

impl Stage {
    pub fn of(word: &str) -> Option<Self> {
        let word = word.replace('-', "");
        let name = |stage: &Self| format!("{stage:?}").to_lowercase();
        match word.as_str() {
            "entry" | "describe" => Some(Self::Start),
            _ => ORDER.into_iter().find(|stage| name(stage) == word),
        }
    }

    pub fn deadline(self) -> Duration {
        match self {
            Self::Start => deadline::START,
            Self::Open => deadline::OPEN,
            Self::Encode => deadline::ENCODE,
            Self::Poll => deadline::POLL,
            Self::Stop => deadline::STOP,
            Self::Close => deadline::CLOSE,
            // These wait for what they bring about, by polling.
            _ => deadline::CALL + deadline::POLL,
        }
    }
}

/// How far a driver has come.
pub struct Life<'a> {
    found: &'a DiscoveredDriver,
    launch: &'a Launch,
    driver: Option<Driver>,
    open: Option<OpenDriver>,
    session: Option<Session>,
    armed: Option<Armed>,
    took: Vec<(Stage, Duration)>,
    pub ended: Result<(), SessionError>,
}

impl<'a> Life<'a> {
    fn new(found: &'a DiscoveredDriver, launch: &'a Launch) -> Self {
        Self {
            found,
            launch,
            driver: None,
            open: None,
            session: None,
            armed: None,
            took: Vec::new(),
            ended: Ok(()),
        }
    }

    /// All of it, or as far as it goes.
    pub fn whole(found: &'a DiscoveredDriver, launch: &'a Launch) -> Self {
        let mut life = Self::new(found, launch);
        for stage in ORDER {
            life.ended = life.timed(stage);
            if life.ended.is_err() {
                break;
            }
        }
        // What is left of the driver ends with these.
        (life.driver, life.open, life.session) = (None, None, None);
        life
    }

    /// Up to a call, if the driver gets there; a driver that misbehaves when it is asked something else
    /// before does not.
    pub fn until(found: &'a DiscoveredDriver, launch: &'a Launch, word: &str) -> Option<Self> {
        let last = Stage::of(word)?;
        let mut life = Self::new(found, launch);
        for stage in ORDER.into_iter().take_while(|stage| *stage != last) {
            if life.timed(stage).is_err() {
                return None;
            }
        }
        Some(life)
    }

    pub fn session(&mut self) -> &mut Session {
        self.session.as_mut().unwrap()
    }

    /// Asks what the word stands for.
    pub fn advance(&mut self, word: &str) -> Result<(), SessionError> {
        self.timed(Stage::of(word).unwrap())
    }

    /// Which stage came last, and how long it took.
    pub fn last(&self) -> (Stage, Duration) {
        *self.took.last().unwrap()
    }

    /// The driver is gone, and every later request says so at once.
    pub fn assert_over(&mut self) {
        let Some(session) = self.session.as_mut() else { return };
        let started = Awake::now();
        let error = session.poll().unwrap_err();
        assert!(matches!(error, SessionError::Host(_)), "{error}");
        assert!(started.elapsed() < Duration::from_secs(1));
        assert_eq!(session.phase(), Phase::Failed);
        let steps = [step(session.progress().0 + 1)];
        let armed = self.armed.take();
        if let Some(armed) = armed {
            assert!(session.send(&armed, &steps).is_err(), "a stop ends the permission to move");
        }
    }

    fn timed(&mut self, stage: Stage) -> Result<(), SessionError> {
        let started = Awake::now();
        let done = self.go(stage);
        self.took.push((stage, started.elapsed()));
        done
    }

    fn go(&mut self, stage: Stage) -> Result<(), SessionError> {
        match stage {
            Stage::Start => self.driver = Some(Driver::start(self.found, self.launch)?),
            Stage::Open => self.open = Some(self.driver.take().unwrap().open(&serde_json::json!({}))?),
            Stage::Encode => {
                let encoded = self.open.as_ref().unwrap().encode("hostile-text", sample_job())?;
                assert_eq!(encoded.files[0].text, "a wire\n");
            }
            Stage::Ports => assert_eq!(self.open.as_ref().unwrap().ports()?[0].name, "anywhere"),
            Stage::Limits => assert_eq!(self.open.as_ref().unwrap().limits()?.limits.len(), 1),
            Stage::Connect => {
                self.session = Some(Session::connect(self.open.take().unwrap(), "anywhere", None)?);
            }
            Stage::Poll => return self.polled(Phase::Connected),
            Stage::WriteSettings => {
                permits::write_settings(self.session())?;
                return self.polled(Phase::Connected);
            }
            Stage::Console => {
                assert!(self.session().question("?")?);
                return self.polled(Phase::Connected);
            }
            Stage::Home => {
                permits::home(self.session())?;
                return self.polled(Phase::Ready);
            }
            Stage::Cut => {
                permits::cut(self.session())?;
                return self.polled(Phase::Ready);
            }
            Stage::Jog => {
                let armed = permits::arm_by_hand(self.session())?;
                self.session().jog(&armed, Motion::new(Axis::Feed, 1.0))?;
                return self.polled(Phase::Moving);
            }
            Stage::Arm => {
                let run = Run {
                    job_hash: "0".repeat(64),
                    name: "life".to_owned(),
                    wire: 0,
                    steps: 3,
                    ..Run::default()
                };
                self.armed = Some(permits::arm(self.session(), run)?);
            }
            Stage::Send => {
                let armed = self.armed.take().unwrap();
                let sent = self.session().send(&armed, &[step(1), step(2)]);
                self.armed = Some(armed);
                assert_eq!(sent?.accepted, 2);
                return self.polled(Phase::Making);
            }
            Stage::Pause => {
                self.session().pause()?;
                return self.polled(Phase::Holding);
            }
            Stage::Resume => {
                let armed = self.armed.take().unwrap();
                let resumed = self.session().resume(&armed);
                self.armed = Some(armed);
                resumed?;
                return self.polled(Phase::Making);
            }
            Stage::Stop => {
                let outcome = self.session().stop();
                // A stop has no error: what the driver did is reported by the next request.
                if outcome.by == wirebend_driver_host::StoppedBy::EndOfDriver {
                    self.session().poll()?;
                }
                return self.polled(Phase::Stopped);
            }
            Stage::Disconnect => self.open = Some(self.session.take().unwrap().disconnect()?),
            Stage::Close => self.open.take().unwrap().close()?,
        }
        Ok(())
    }

    /// Takes events until the session is in a state, or it was stopped.
    fn polled(&mut self, phase: Phase) -> Result<(), SessionError> {
        let session = self.session.as_mut().unwrap();
        for _ in 0..100 {
            session.poll()?;
            if [phase, Phase::Stopped].contains(&session.phase()) {
                return Ok(());
            }
        }
        panic!("{} and not {phase}", session.phase());
    }
}

fn step(n: u32) -> NumberedStep {
    NumberedStep { n, step: Step { feed_mm: 30.0, rotate_deg: 0.0, bend_deg: 45.0, approach_deg: None } }
}
