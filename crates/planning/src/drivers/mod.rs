//! Commands about drivers, and the limits that they report.

mod check;
mod limits;
mod list;
mod trust;

pub use check::{DriverCheckRequest, DriverCheckResponse, RuleReport, check};
pub use limits::Told;
pub use list::{DriverEntry, DriverState, DriversRequest, DriversResponse, drivers};
pub use trust::{DriverTrustRequest, DriverTrustResponse, trust};
