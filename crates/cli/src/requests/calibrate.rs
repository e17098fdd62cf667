//! From the arguments of `calibrate` and `profile set` to requests.

use std::path::PathBuf;

use wirebend_api::{
    CalibrateApplyRequest, CalibrateCompareRequest, CalibrateEnterRequest, CalibrateFitRequest,
    CalibrateNewRequest, Command,
};

use crate::args::CalibrateCommand;
use crate::usage::WrongUse;

pub(super) fn calibrate(command: CalibrateCommand) -> Result<Command, WrongUse> {
    Ok(match command {
        CalibrateCommand::New { machine, material, angles, repeats, output, paper, force } => {
            Command::CalibrateNew(CalibrateNewRequest {
                machine,
                material,
                angles_deg: angles,
                repeats,
                folder: output,
                paper,
                force,
            })
        }
        CalibrateCommand::Enter { sheet, readings, pin_table, bent } => {
            Command::CalibrateEnter(CalibrateEnterRequest { sheet, readings, pin_tables: pin_table, bent })
        }
        CalibrateCommand::Fit { sheet, shape } => {
            Command::CalibrateFit(CalibrateFitRequest { sheet, shape: shape.map(Into::into) })
        }
        CalibrateCommand::Apply { sheet, machine_id, material_id, shape, date, output, force } => {
            let folder = match output {
                Some(folder) => folder,
                None => own_folder("name a folder with -o")?,
            };
            let shape = shape.map(Into::into);
            Command::CalibrateApply(CalibrateApplyRequest {
                sheet,
                shape,
                machine_id,
                material_id,
                date,
                folder,
                force,
            })
        }
        CalibrateCommand::Compare { first, second, sheet } => {
            Command::CalibrateCompare(CalibrateCompareRequest { machines: [first, second], sheet })
        }
    })
}

/// The folder with profiles of the person's own; `instead` is what helps where there is none.
pub(super) fn own_folder(instead: &str) -> Result<PathBuf, WrongUse> {
    let homeless = || WrongUse(format!("there is no home folder with profiles of your own: {instead}"));
    wirebend_api::Places::of_person().own.ok_or_else(homeless)
}
