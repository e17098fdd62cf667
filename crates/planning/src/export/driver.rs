//! Which driver writes a format.

use wirebend_driver_host::Driver;
use wirebend_driver_host::api::{Content, Description, FormatDescription};

use super::ExportFormat;
use crate::error::{DriverProblem, PlanningError};
use crate::installation::Installation;
use crate::machine::Setup;

impl Installation {
    /// Starts the driver that writes a format: the machine's own if it does, else the first that does. What
    /// is for one machine alone only that machine's driver writes: another would do it with settings of its own.
    pub fn driver_of_format(
        &self,
        format: &str,
        setup: &Setup,
    ) -> Result<(Driver, FormatDescription), PlanningError> {
        let profile = &setup.machine.profile;
        let own_id = profile.driver.id.as_deref().unwrap_or_default();
        let (mut known, mut missing, mut another) = (built_in(), None, false);
        let own = self.driver(own_id).map_err(|error| missing = Some(Box::new(error)));
        // One that does not start writes nothing; it is in the log.
        for driver in own.into_iter().chain(self.all_drivers()?.flatten()) {
            if let Some(found) = driver.description().format(format).cloned() {
                if found.content == Content::Design || driver.description().id == own_id {
                    return Ok((driver, found));
                }
                another = true;
            }
            known.extend(formats(driver.description()));
        }
        let listed: Vec<String> =
            profile.export.native.iter().chain(profile.export.formats.iter().flatten()).cloned().collect();
        match missing {
            // A format of the machine's own is not unknown: its driver is what is missing.
            Some(cause) if listed.iter().any(|id| id == format) => {
                Err(DriverProblem::OwnFormat { format: format.to_owned(), cause }.into())
            }
            _ if another => Err(PlanningError::FormatOfAnother {
                format: format.to_owned(),
                machine: setup.machine_id().to_owned(),
                known: listed,
            }),
            missing => {
                known.sort();
                known.dedup();
                Err(PlanningError::UnknownFormat { name: format.to_owned(), known, missing })
            }
        }
    }

    /// The formats that there are for a machine with this driver: of what is for one machine alone, those of its driver. Absent: all.
    pub fn formats(&self, own: Option<&str>) -> Result<Vec<String>, DriverProblem> {
        let mut known = built_in();
        for driver in self.all_drivers()?.flatten() {
            let description = driver.description();
            let is_own = own.is_none_or(|own| own == description.id);
            let can_be = |format: &&FormatDescription| is_own || format.content == Content::Design;
            known.extend(description.formats.iter().filter(can_be).map(|format| format.id.clone()));
        }
        Ok(known)
    }
}

fn built_in() -> Vec<String> {
    ExportFormat::ALL.map(|format| format.id().to_owned()).into()
}

fn formats(description: &Description) -> impl Iterator<Item = String> {
    description.formats.iter().map(|format| format.id.clone())
}
