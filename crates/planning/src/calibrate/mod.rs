//! `calibrate`: coupons as jobs and a sheet for what is measured of them, the fit, and profiles that have it.

mod apply;
mod assumed;
mod beyond;
mod compare;
mod coupons;
mod enter;
mod fit;
mod measured;
mod report;
mod rounded;
mod sheet;
mod values;

pub use apply::{CalibrateApplyRequest, CalibrateApplyResponse, apply};
pub use compare::{CalibrateCompareRequest, CalibrateCompareResponse, ComparedValue, VersionMisfit, compare};
pub use coupons::{CalibrateNewRequest, CalibrateNewResponse, new};
pub use enter::{Bent, CalibrateEnterResponse, SheetFile};
pub use fit::{CalibrateFitRequest, ShapeName, fit};
pub use report::{
    CalibrationReport, KindName, KindReport, LeftOutReport, MisfitReport, ParameterReport, ReadingReport,
};
pub use sheet::{CalibrationRow, CalibrationSheet, CalibrationSheetRequest, sheet};
