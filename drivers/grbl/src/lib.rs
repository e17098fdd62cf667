//! G-code, and live streaming to grbl 1.1. README.md beside this says what is written and spoken.

mod codes;
mod export;
mod limits;
mod live;
mod program;
mod settings;

use std::rc::Rc;

use wirebend_driver_api::{
    Capability, Content, Description, DriverError, Encoded, Files, FormatDescription, Job, Limits,
    MachineDriver, MachineSession, Port, serial,
};

pub use settings::{Comments, Homing, Letter, Mode, Moves, Settings, Streaming};

const FORMAT: &str = "gcode";

#[derive(Debug)]
pub struct Grbl {
    settings: Rc<Settings>,
}

impl MachineDriver for Grbl {
    type Settings = Settings;

    fn describe() -> Description {
        Description {
            id: "grbl".to_owned(),
            name: "G-code and grbl 1.1".to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            description:
                "Writes G-code for benders whose feed, rotation and bend are machine axes, and runs \
                          them live on grbl 1.1. Made and tested after grbl's documentation against a model \
                          of the controller; it has not been tried on a machine."
                    .to_owned(),
            capabilities: [
                Capability::Export,
                Capability::Live,
                Capability::Jog,
                Capability::DryRun,
                Capability::Speed,
                Capability::Console,
                Capability::Cut,
                Capability::Home,
                Capability::Pause,
                Capability::Resume,
                Capability::Stop,
                Capability::Ports,
            ]
            .into(),
            formats: vec![FormatDescription {
                id: FORMAT.to_owned(),
                name: "G-code".to_owned(),
                extensions: ["nc", "gcode", "txt"].map(str::to_owned).into(),
                content: Content::Machine,
                files: Files::EachWire,
                program: true,
            }],
            settings_schema: serde_json::Value::Null,
        }
    }

    fn open(settings: Settings) -> Result<Self, DriverError> {
        settings.check()?;
        Ok(Self { settings: Rc::new(settings) })
    }

    fn encode(&self, format: &str, job: &Job) -> Result<Encoded, DriverError> {
        if format != FORMAT {
            return Err(DriverError::unknown_format(format, &[FORMAT]));
        }
        let files = (0..job.wires.len()).map(|index| export::wire(&self.settings, job, index));
        Ok(Encoded { files: files.collect::<Result<_, _>>()?, notes: Vec::new() })
    }

    fn limits(&self) -> Limits {
        limits::of(&self.settings)
    }

    fn ports(&self) -> Result<Vec<Port>, DriverError> {
        serial::ports()
    }

    fn connect(&self, port: &str, _resume: Option<&str>) -> Result<Box<dyn MachineSession>, DriverError> {
        Ok(Box::new(live::Session::open(port, Rc::clone(&self.settings))?))
    }
}

wirebend_driver_api::export_driver!(Grbl);
