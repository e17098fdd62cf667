//! The WireBend-kit bender: its text, its protocol, and its simulated machine.
//!
//! ```text
//! app ─▶ live (machine) ─▶ link ─▶ protocol ─▶ serial port ─▶ firmware
//!                                          └─▶ controller (the firmware's own core) ─▶ bench (a wire)
//! ```

pub mod bench;
pub mod controller;
mod export;
mod limits;
pub mod link;
mod live;
pub mod protocol;
mod settings;

use std::rc::Rc;

use wirebend_driver_api::{
    Capability, Content, Description, DriverError, Encoded, Files, FormatDescription, Job, Limits,
    MachineDriver, MachineSession, Port,
};

pub use settings::Settings;

const FORMAT: &str = "wirebend-kit-text";

#[derive(Debug)]
pub struct WirebendKit {
    settings: Rc<Settings>,
}

impl MachineDriver for WirebendKit {
    type Settings = Settings;

    fn describe() -> Description {
        Description {
            id: "wirebend-kit".to_owned(),
            name: "WireBend-kit".to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            description:
                "Runs the WireBend-kit bender and its clones with the firmware of this program, over a \
                          serial port or simulated, and writes its text. The firmware was run on a simulated \
                          processor; neither it nor this driver was tried on a machine."
                    .to_owned(),
            capabilities: [
                Capability::Export,
                Capability::Live,
                Capability::Jog,
                Capability::DryRun,
                Capability::Speed,
                Capability::Home,
                Capability::Pause,
                Capability::Resume,
                Capability::Stop,
                Capability::Ports,
                Capability::Settings,
                Capability::BeforeZero,
                Capability::Console,
            ]
            .into(),
            formats: vec![FormatDescription {
                id: FORMAT.to_owned(),
                name: "WireBend-kit text".to_owned(),
                extensions: vec!["txt".to_owned()],
                content: Content::Machine,
                files: Files::EachWire,
                program: true,
            }],
            settings_schema: serde_json::Value::Null, // filled in from `Settings`
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
        let files = (0..job.wires.len()).map(|index| export::wire(job, index));
        let files = files.collect::<Result<_, _>>()?;
        Ok(Encoded { files, notes: export::approaches_left_out(job)?.into_iter().collect() })
    }

    fn limits(&self) -> Limits {
        limits::of(&self.settings)
    }

    fn ports(&self) -> Result<Vec<Port>, DriverError> {
        live::ports()
    }

    fn connect(&self, port: &str, resume: Option<&str>) -> Result<Box<dyn MachineSession>, DriverError> {
        Ok(Box::new(live::Session::open(port, resume, &self.settings)?))
    }
}

wirebend_driver_api::export_driver!(WirebendKit);
