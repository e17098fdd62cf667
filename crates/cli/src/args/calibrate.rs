//! The arguments of `calibrate`.

use std::path::PathBuf;

use clap::{Subcommand, ValueEnum};
use wirebend_api::ShapeName;

#[derive(Debug, Clone, Copy, ValueEnum)]
pub(crate) enum ShapeArg {
    /// Every bend loses the same
    Constant,
    /// The loss is that of the profile, moved by one angle
    Moved,
    /// The loss depends on the angle and the side
    Curve,
}

impl From<ShapeArg> for ShapeName {
    fn from(shape: ShapeArg) -> Self {
        match shape {
            ShapeArg::Constant => Self::Constant,
            ShapeArg::Moved => Self::Moved,
            ShapeArg::Curve => Self::Curve,
        }
    }
}

#[derive(Debug, Subcommand)]
pub(crate) enum CalibrateCommand {
    /// Write coupons to bend, as jobs, and a table for what you measure of them
    #[command(after_help = "Example:\n  wirebend calibrate new --machine wirebend-kit -o calibration")]
    New {
        /// Machine, by id
        #[arg(long, value_name = "ID")]
        machine: String,
        /// Wire, by id; the one that the machine names if absent
        #[arg(long, value_name = "ID")]
        material: Option<String>,
        /// Angles of the ladder, degrees, with commas between them
        #[arg(long, value_name = "DEGREES", value_delimiter = ',')]
        angles: Vec<f64>,
        /// How often each coupon is bent
        #[arg(long, value_name = "N", default_value_t = 2)]
        repeats: u32,
        /// Folder for jobs, table and the sheet to print
        #[arg(long, short, value_name = "FOLDER")]
        output: PathBuf,
        /// What the sheet is printed on: a4 or letter
        #[arg(long, value_name = "PAPER")]
        paper: Option<String>,
        /// Replace files that are there
        #[arg(long)]
        force: bool,
    },
    /// Enter readings into the table
    #[command(
        after_help = "Examples:\n  wirebend calibrate enter calibration/sheet.csv angle-40:1=38.5,39 angle-40:2=-39,-39.5\n  wirebend calibrate enter calibration/sheet.csv --pin-table others.csv"
    )]
    Enter {
        /// Table to enter them into
        #[arg(value_name = "SHEET")]
        sheet: PathBuf,
        /// Coupon, which of its rows where it has several, and its readings; - leaves one out
        #[arg(value_name = "COUPON[:ROW]=READING,…")]
        readings: Vec<String>,
        /// Add a table of pin angle and springback angle
        #[arg(long, value_name = "FILE")]
        pin_table: Vec<PathBuf>,
        /// Take the readings from the wires of this job that the simulated machine has bent
        #[arg(long, value_name = "JOB")]
        bent: Vec<PathBuf>,
    },
    /// Say what the table tells of machine and wire
    #[command(after_help = "Example:\n  wirebend calibrate fit calibration/sheet.csv")]
    Fit {
        /// Table to read
        #[arg(value_name = "SHEET")]
        sheet: PathBuf,
        /// What the springback depends on; what predicts best if absent
        #[arg(long, value_name = "SHAPE")]
        shape: Option<ShapeArg>,
    },
    /// Write a profile of your machine and one of your wire with what the table tells
    #[command(
        after_help = "Example:\n  wirebend calibrate apply calibration/sheet.csv --machine-id my-kit --material-id my-wire"
    )]
    Apply {
        /// Table to read
        #[arg(value_name = "SHEET")]
        sheet: PathBuf,
        /// Id of the new profile of the machine
        #[arg(long, value_name = "NEW_ID")]
        machine_id: String,
        /// Id of the new profile of the wire
        #[arg(long, value_name = "NEW_ID")]
        material_id: String,
        /// What the springback depends on; what predicts best if absent
        #[arg(long, value_name = "SHAPE")]
        shape: Option<ShapeArg>,
        /// Day of the measurement, such as 2026-11-25; today if absent
        #[arg(long, value_name = "DATE")]
        date: Option<String>,
        /// Folder with profiles; your own if absent
        #[arg(long, short, value_name = "FOLDER")]
        output: Option<PathBuf>,
        /// Replace profiles that are there
        #[arg(long)]
        force: bool,
    },
    /// Compare two versions of a machine, each with the wire that it names; the one that a sheet is of with the wire of the sheet
    #[command(
        after_help = "Example:\n  wirebend calibrate compare wirebend-kit my-kit --sheet calibration/sheet.csv"
    )]
    Compare {
        /// Machine, by id
        #[arg(value_name = "ID")]
        first: String,
        /// Other machine, by id
        #[arg(value_name = "ID")]
        second: String,
        /// Say how well each fits the readings of this table
        #[arg(long, value_name = "SHEET")]
        sheet: Option<PathBuf>,
    },
}
