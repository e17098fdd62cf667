//! Where a person's own things are.

use std::path::PathBuf;

use etcetera::BaseStrategy;

use crate::{ApiError, DriverFolders, Installation};

/// The folder of this program in the folders of a person.
const FOLDER: &str = "wirebend";

/// Where a person's own profiles and drivers are, and what the program keeps for them. Absent what there is no place for.
#[derive(Debug, Clone, Default)]
pub struct Places {
    /// Profiles in folders by kind, `drivers`, and the list of accepted drivers; whether it is there or not.
    pub own: Option<PathBuf>,
    /// Further folders of profiles.
    pub profiles: Vec<PathBuf>,
    /// Folders or libraries of drivers that were named for this time.
    pub drivers: Vec<PathBuf>,
    /// The program's own drivers; absent, those beside the running program.
    pub shipped_drivers: Option<Vec<PathBuf>>,
    /// The program that is a driver's process; absent, the running one.
    pub driver_program: Option<PathBuf>,
    /// Journals and records of the wires that were bent.
    pub runs: Option<PathBuf>,
    /// What is open and not saved, and what was open before.
    pub state: Option<PathBuf>,
}

impl Places {
    /// Those of the person that runs the program, by the rules of the system; none without a home.
    #[must_use]
    pub fn of_person() -> Self {
        let Ok(home) = etcetera::choose_base_strategy() else { return Self::default() };
        let data = home.data_dir().join(FOLDER);
        Self {
            own: Some(home.config_dir().join(FOLDER)),
            runs: Some(data.join("runs")),
            state: Some(data.join("state")),
            ..Self::default()
        }
    }

    /// The application with what is there now.
    ///
    /// # Errors
    /// [`ApiError::Planning`] when a shipped profile is damaged.
    pub fn installation(&self) -> Result<Installation, ApiError> {
        let own = self.own.iter().filter(|folder| folder.is_dir());
        let folders: Vec<PathBuf> = own.chain(&self.profiles).cloned().collect();
        let drivers = DriverFolders {
            own: self.shipped_drivers.clone(),
            user: self.own.as_ref().map(|own| own.join("drivers")).filter(|folder| folder.is_dir()),
            named: self.drivers.clone(),
            trusted: self.own.as_ref().map(|own| own.join("trusted-drivers.json")),
            program: self.driver_program.clone(),
        };
        Ok(Installation::new(&folders)?.with_drivers(drivers).with_runs(self.runs.clone()))
    }
}
