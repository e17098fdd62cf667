//! The driver to copy: a table of the machine's steps as text. `README.md` says how to make another one of it.

use std::fmt::Write as _;

use schemars::JsonSchema;
use serde::Deserialize;
use serde_json::Value;
use wirebend_driver_api::{
    Capability, Content, Description, DriverError, Encoded, EncodedFile, Files, FormatDescription, Job,
    MachineDriver, Wire,
};

const FORMAT: &str = "template-text";
/// The most digits behind the decimal point.
const MAX_DECIMALS: u8 = 6;
/// The largest length or angle that a column holds. With six decimals it still is a whole number of units
/// below 2^53, which a float counts exactly.
const MAX_VALUE: f64 = 100_000.0;

/// What a person can set. The comments below are shown in a form.
#[derive(Debug, Clone, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Settings {
    /// Digits behind the decimal point of lengths (mm) and angles (degrees), 0 to 6.
    #[schemars(range(min = 0, max = 6))]
    pub decimals: u8,
    /// Whether a line with the names and units of the columns stands above the steps.
    pub header: bool,
    /// What a comment line starts with. The first line is a comment with the names of design and machine and the hash of the design; empty: it is left out.
    pub comment: String,
}

impl Default for Settings {
    fn default() -> Self {
        Self { decimals: 3, header: true, comment: "#".to_owned() }
    }
}

/// Writes `n, feed, rotate, bend`, a line a step.
#[derive(Debug)]
pub struct Template {
    settings: Settings,
}

impl MachineDriver for Template {
    type Settings = Settings;

    fn describe() -> Description {
        Description {
            id: "template".to_owned(),
            name: "Template".to_owned(),
            version: env!("CARGO_PKG_VERSION").to_owned(),
            description: "The driver to copy: it writes the machine's steps as a table, for no machine in \
                          particular. No machine has been run from its files."
                .to_owned(),
            capabilities: [Capability::Export].into(),
            formats: vec![FormatDescription {
                id: FORMAT.to_owned(),
                name: "Table of steps".to_owned(),
                extensions: vec!["txt".to_owned()],
                content: Content::Machine,
                files: Files::EachWire,
                program: true,
            }],
            settings_schema: Value::Null, // filled in from `Settings`
        }
    }

    fn open(settings: Settings) -> Result<Self, DriverError> {
        let refused = |message: String, help: &str| Err(DriverError::new("settings", message, help));
        if settings.decimals > MAX_DECIMALS {
            return refused(
                format!("'decimals' is {}; it can be 0 to {MAX_DECIMALS}", settings.decimals),
                "set it to 3 for thousandths",
            );
        }
        if settings.comment.chars().any(char::is_control) {
            return refused(
                "'comment' has a control character, such as the end of a line, in it".to_owned(),
                "use the mark that starts a comment, such as #",
            );
        }
        Ok(Self { settings })
    }

    fn encode(&self, format: &str, job: &Job) -> Result<Encoded, DriverError> {
        if format != FORMAT {
            return Err(DriverError::unknown_format(format, &[FORMAT]));
        }
        let wires = job.wires.iter().enumerate();
        let files = wires.map(|(index, wire)| Ok(EncodedFile { text: self.table(job, index, wire)? }));
        Ok(Encoded { files: files.collect::<Result<_, DriverError>>()?, notes: Vec::new() })
    }
}

impl Template {
    fn table(&self, job: &Job, index: usize, wire: &Wire) -> Result<String, DriverError> {
        let Settings { decimals, header, comment } = &self.settings;
        let mut text = String::new();
        if !comment.is_empty() {
            let (name, machine) = (one_line(&job.name), one_line(&job.machine.name));
            let _ = writeln!(text, "{comment} {name} for {machine}, design {}", one_line(&job.design_hash));
        }
        if *header {
            text.push_str("n, feed_mm, rotate_deg, bend_deg\n");
        }
        let mut columns = ["feed", "rotate", "bend"].map(|name| Column::new(name, *decimals));
        // The machine's own signs are in the steps already: nothing here turns a sign round.
        for (n, step) in (1_usize..).zip(wire.machine_steps(index)?) {
            let _ = write!(text, "{n}");
            for (column, value) in columns.iter_mut().zip([step.feed_mm, step.rotate_deg, step.bend_deg]) {
                let number = column.next(value).map_err(|what| {
                    let message = format!("wire {}, step {n}: {what}", index + 1);
                    DriverError::new("too-large", message, "divide the design, or look at its scale")
                })?;
                let _ = write!(text, ", {number}");
            }
            text.push('\n');
        }
        Ok(text)
    }
}

/// A column of rounded numbers. What rounding takes from one step is given to the next, so that the sum
/// down the column is never off by more than half of the last digit.
struct Column {
    name: &'static str,
    decimals: u32,
    /// What is left over, in units of the last digit.
    carry: f64,
}

impl Column {
    fn new(name: &'static str, decimals: u8) -> Self {
        Self { name, decimals: decimals.into(), carry: 0.0 }
    }

    fn next(&mut self, value: f64) -> Result<String, String> {
        if !value.is_finite() || value.abs() > MAX_VALUE {
            return Err(format!("{} is {value}; a column holds up to {MAX_VALUE}", self.name));
        }
        let scale = f64::from(10_u32.pow(self.decimals));
        let exact = value * scale + self.carry;
        // Halves go to the even side: what is left over is a half at most, and so a zero stays zero. What
        // rounds to -0.0 becomes 0.0 by adding 0.0, and is never written with a sign.
        let units = exact.round_ties_even() + 0.0;
        self.carry = exact - units;
        Ok(format!("{:.*}", self.decimals as usize, units / scale))
    }
}

/// Text that cannot end a comment line before its time.
fn one_line(text: &str) -> String {
    text.chars().filter(|c| !c.is_control()).collect()
}

wirebend_driver_api::export_driver!(Template);
