//! LRA/YBC, XYZ and cumulative tables. `README.md` says exactly what is written, and where each
//! convention comes from.

mod bends;
mod format;
mod grid;
mod layout;
mod measure;
mod points;
mod preset;
mod refusal;
mod rounding;
mod settings;
mod sheet;
mod values;

use serde_json::Value;
use wirebend_driver_api::{
    Capability, Content, Description, DriverError, Encoded, EncodedFile, Files, FormatDescription, Job,
    MachineDriver,
};

pub use preset::Preset;
pub use settings::Settings;
pub use values::{
    Column, Comments, DecimalMark, Handedness, LengthUnit, Lengths, LineEnd, PointColumn, RotationCount,
    Separator,
};

use format::TableFormat;
use rounding::Rounding;

/// Writes tables of the design for machines that compensate on their own.
#[derive(Debug)]
pub struct Tables {
    settings: Settings,
}

impl MachineDriver for Tables {
    type Settings = Settings;

    fn describe() -> Description {
        Description {
            id: "tables".to_owned(),
            name: "Tables".to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            description: "Writes the design as an LRA, YBC, XYZ or cumulative table, for benders that read \
                          such tables and compensate on their own. The conventions are those of published \
                          samples; no machine has been run from these files."
                .to_owned(),
            capabilities: [Capability::Export].into(),
            formats: TableFormat::ALL.map(describe).to_vec(),
            settings_schema: Value::Null, // filled in from `Settings`
        }
    }

    fn open(settings: Settings) -> Result<Self, DriverError> {
        for format in TableFormat::ALL {
            layout::check(&settings, format)?;
        }
        Ok(Self { settings })
    }

    fn encode(&self, format: &str, job: &Job) -> Result<Encoded, DriverError> {
        let Some(format) = TableFormat::ALL.into_iter().find(|one| one.id() == format) else {
            return Err(DriverError::unknown_format(format, &TableFormat::ALL.map(TableFormat::id)));
        };
        if !(job.bend_radius_mm.is_finite() && job.bend_radius_mm >= 0.0) {
            return Err(refusal::radius(job.bend_radius_mm));
        }
        let mut rounding = Rounding::default();
        let mut files = Vec::with_capacity(job.wires.len());
        for (index, wire) in job.wires.iter().enumerate() {
            let text = if format == TableFormat::Xyz {
                points::table(job, index, wire, &layout::points(&self.settings)?, &mut rounding)?
            } else {
                bends::table(job, index, wire, &layout::bends(&self.settings, format)?, &mut rounding)?
            };
            files.push(EncodedFile { text });
        }
        Ok(Encoded { files, notes: rounding.note().into_iter().collect() })
    }
}

fn describe(format: TableFormat) -> FormatDescription {
    FormatDescription {
        id: format.id().to_owned(),
        name: format.name().to_owned(),
        extensions: format.extensions().iter().map(|&extension| extension.to_owned()).collect(),
        content: Content::Design,
        files: Files::EachWire,
        program: format != TableFormat::Xyz,
    }
}

wirebend_driver_api::export_driver!(Tables);
