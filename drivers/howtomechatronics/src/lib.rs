//! The serial commands of the Arduino bender of howtomechatronics.com and its clones, as a file or sent by
//! the clock.
//! `README.md` says exactly what is written and sent, and what the machine cannot do.

mod command;
mod duration;
mod limits;
mod program;
mod session;
mod settings;
mod timed;
mod whole;

use serde_json::Value;
use wirebend_driver_api::{
    Capability, Content, Description, DriverError, Encoded, Files, FormatDescription, Job, Limits,
    MachineDriver, MachineSession, Port, serial,
};

pub use settings::Settings;

const FORMAT: &str = "howtomechatronics-serial";

/// Writes `manual`, `f38`, `z90`, `b-45`, `end`, and sends the same one after the other by the clock.
#[derive(Debug)]
pub struct HowToMechatronics {
    settings: Settings,
}

impl MachineDriver for HowToMechatronics {
    type Settings = Settings;

    fn describe() -> Description {
        Description {
            id: "howtomechatronics".to_owned(),
            name: "HowToMechatronics bender".to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            description: "The Arduino bender of HowToMechatronics and its clones: whole millimetres and \
                          degrees, as a file or sent by the clock. The machine moves its arm when the port is \
                          opened, acknowledges nothing, so that steps count as done by the clock alone, and \
                          cannot be stopped by the program: keep its power switch at hand. No machine has been run by this driver."
                .to_owned(),
            capabilities: [Capability::Export, Capability::Live, Capability::Ports].into(),
            formats: vec![FormatDescription {
                id: FORMAT.to_owned(),
                name: "HowToMechatronics serial commands".to_owned(),
                extensions: vec!["txt".to_owned()],
                content: Content::Machine,
                files: Files::EachWire,
                program: true,
            }],
            settings_schema: Value::Null, // filled in from `Settings`
        }
    }

    fn open(settings: Settings) -> Result<Self, DriverError> {
        settings.check()?;
        Ok(Self { settings })
    }

    fn encode(&self, format: &str, job: &Job) -> Result<Encoded, DriverError> {
        if format != FORMAT {
            return Err(DriverError::unknown_format(format, &[FORMAT]));
        }
        program::encode(job, self.settings.most_feed_mm)
    }

    fn limits(&self) -> Limits {
        limits::of(&self.settings)
    }

    fn ports(&self) -> Result<Vec<Port>, DriverError> {
        serial::ports()
    }

    fn connect(&self, port: &str, _resume: Option<&str>) -> Result<Box<dyn MachineSession>, DriverError> {
        let line = serial::open(port, self.settings.baud)?;
        Ok(Box::new(session::Session::new(line, self.settings.clone())))
    }
}

wirebend_driver_api::export_driver!(HowToMechatronics);
