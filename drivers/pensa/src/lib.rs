//! Scripts for the Pensa D.I.Wire. `README.md` says exactly what is written and what is not known.

mod rounding;
mod script;
mod settings;

use serde_json::Value;
use wirebend_driver_api::{
    Capability, Content, Description, DriverError, Encoded, EncodedFile, Files, FormatDescription, Job,
    MachineDriver, Note,
};

pub use settings::{Case, Comments, Extension, Settings};

use rounding::Rounding;

const FORMAT: &str = "pensa-script";

/// Writes `FEED`, `ROTATE` and `BEND`, a command a line.
#[derive(Debug)]
pub struct Pensa {
    settings: Settings,
}

impl MachineDriver for Pensa {
    type Settings = Settings;

    fn describe() -> Description {
        Description {
            id: "pensa".to_owned(),
            name: "Pensa D.I.Wire".to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            description:
                "Writes scripts of FEED, ROTATE and BEND for the Pensa D.I.Wire, whose own software \
                          runs them. The format is that of published programs; no machine has been run from \
                          these files."
                    .to_owned(),
            capabilities: [Capability::Export].into(),
            formats: vec![FormatDescription {
                id: FORMAT.to_owned(),
                name: "Pensa D.I.Wire script".to_owned(),
                extensions: Extension::ALL.map(|extension| extension.word().to_owned()).to_vec(),
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
        let mut rounding = Rounding::default();
        let mut files = Vec::with_capacity(job.wires.len());
        let mut ends_on_bend = 0;
        for (index, wire) in job.wires.iter().enumerate() {
            let steps = wire.machine_steps(index)?;
            let text = script::write(index, steps, &job.design_hash, &self.settings, &mut rounding)?;
            ends_on_bend += usize::from(script::ends_on_bend(&text));
            files.push(EncodedFile { text });
        }
        let mut notes = Vec::new();
        notes.extend(rounding.note());
        if ends_on_bend > 0 {
            let message = "the script ends on a bend that no feed follows; the wire stays in the head";
            notes.push(note("ends-on-bend", ends_on_bend, message));
        }
        if self.settings.extension != Extension::default() {
            let message = format!("save it with the ending .{}", self.settings.extension.word());
            notes.push(note("extension", files.len(), message));
        }
        Ok(Encoded { files, notes })
    }
}

fn note(code: &str, count: usize, message: impl Into<String>) -> Note {
    Note { code: code.to_owned(), count, message: message.into() }
}

wirebend_driver_api::export_driver!(Pensa);
