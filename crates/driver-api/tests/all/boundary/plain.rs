//! A driver that keeps the rules.

use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::Value;
use wirebend_driver_api::{
    ArmedReply, Batch, Capability, Content, Description, DriverError, Encoded, EncodedFile, Event, Files,
    FormatDescription, Job, MachineDriver, MachineSession, Port, Run, Sent, Step,
};

/// Writes the steps of the machine, and moves a machine that only exists in memory.
pub struct Plain(Settings);

#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Settings {
    /// Digits behind the decimal point.
    decimals: usize,
}

impl MachineDriver for Plain {
    type Settings = Settings;

    fn describe() -> Description {
        Description {
            id: "plain".into(),
            name: "Plain".into(),
            version: "1.0.0".into(),
            description: "For tests.".into(),
            capabilities: [Capability::Export, Capability::Live, Capability::Stop, Capability::Ports].into(),
            formats: vec![FormatDescription {
                id: "plain-text".into(),
                name: "Text".into(),
                extensions: vec!["txt".into()],
                content: Content::Machine,
                files: Files::EachWire,
                program: true,
            }],
            settings_schema: Value::Null,
        }
    }

    fn open(settings: Settings) -> Result<Self, DriverError> {
        assert!(settings.decimals < 100, "a hundred decimals");
        Ok(Self(settings))
    }

    fn encode(&self, format: &str, job: &Job) -> Result<Encoded, DriverError> {
        if format != "plain-text" {
            return Err(DriverError::unknown_format(format, &["plain-text"]));
        }
        assert!(job.name != "panic", "asked to");
        let text = |(index, wire): (usize, &wirebend_driver_api::Wire)| {
            let steps = wire.machine_steps(index)?.iter();
            let places = self.0.decimals;
            let line = |s: &Step| {
                format!("{:.places$} {:.places$} {:.places$}\n", s.feed_mm, s.rotate_deg, s.bend_deg)
            };
            Ok(EncodedFile { text: steps.map(line).collect() })
        };
        Ok(Encoded {
            files: job.wires.iter().enumerate().map(text).collect::<Result<_, _>>()?,
            notes: Vec::new(),
        })
    }

    fn ports(&self) -> Result<Vec<Port>, DriverError> {
        Ok(vec![Port { name: "memory".into(), likely: true, ..Port::default() }])
    }

    fn connect(&self, port: &str, resume: Option<&str>) -> Result<Box<dyn MachineSession>, DriverError> {
        if port == "memory" {
            return Ok(Box::new(Memory { done: 0, stopped: false, resume: resume.map(str::to_owned) }));
        }
        Err(DriverError::new("no-port", format!("there is no port '{port}'"), ""))
    }
}

struct Memory {
    done: u32,
    stopped: bool,
    /// The token that it was connected with.
    resume: Option<String>,
}

impl MachineSession for Memory {
    fn arm(&mut self, run: &Run) -> Result<ArmedReply, DriverError> {
        Ok(ArmedReply { token: Some(self.resume.take().unwrap_or_else(|| run.job_hash.clone())) })
    }

    fn send(&mut self, batch: &Batch) -> Result<Sent, DriverError> {
        self.done = batch.steps.last().map_or(0, |step| step.n);
        Ok(Sent { accepted: self.done, free: 8 })
    }

    fn stop(&mut self) -> Result<(), DriverError> {
        self.stopped = true;
        Ok(())
    }

    fn poll(&mut self) -> Result<Option<Event>, DriverError> {
        let done = std::mem::take(&mut self.done);
        if done > 0 {
            return Ok(Some(Event::Done { n: done }));
        }
        Ok(std::mem::take(&mut self.stopped).then_some(Event::Stopped { homed: false }))
    }
}
