//! What is installed on this computer: profiles and drivers.

mod boards;
mod drivers;

use std::path::PathBuf;

use wirebend_profile::{Kind, Library, ProfileError};

pub use boards::{Board, Boards, Met};
pub use drivers::DriverFolders;

use crate::error::PlanningError;

/// The profiles and drivers that are installed, and the folders of the person who uses them.
#[derive(Debug)]
pub struct Installation {
    pub library: Library,
    refused: Vec<ProfileError>,
    pub drivers: DriverFolders,
    /// Whether drivers are asked for the limits of their machines: where it was said where they are.
    pub asks_drivers: bool,
    /// The machines that are connected.
    pub boards: Boards,
    /// Where journals and records of wires are; without a folder, no wire is bent.
    pub runs: Option<PathBuf>,
}

impl Installation {
    /// The shipped profiles and those in further folders. Files there that break a rule are left out;
    /// [`Installation::refused_profiles`] says why.
    pub fn new(profile_folders: &[PathBuf]) -> Result<Self, PlanningError> {
        let mut library = Library::shipped()?;
        let mut refused = Vec::new();
        for folder in profile_folders {
            refused.extend(library.add_folder(folder).refused);
        }
        Ok(Self {
            library,
            refused,
            drivers: DriverFolders::default(),
            asks_drivers: false,
            boards: Boards::default(),
            runs: None,
        })
    }

    /// The same with other profiles, which are given.
    #[must_use]
    pub(crate) fn with_library(&self, library: Library) -> Self {
        Self {
            library,
            refused: Vec::new(),
            drivers: self.drivers.clone(),
            asks_drivers: self.asks_drivers,
            boards: self.boards.clone(),
            runs: self.runs.clone(),
        }
    }

    /// The same with drivers from other places than the folders beside the program.
    #[must_use]
    pub fn with_drivers(self, drivers: DriverFolders) -> Self {
        Self { drivers, asks_drivers: true, ..self }
    }

    /// The same that knows the machines which are connected to another.
    #[must_use]
    pub fn with_boards_of(self, other: &Self) -> Self {
        Self { boards: other.boards.clone(), ..self }
    }

    /// The same with a folder for journals and records of wires.
    #[must_use]
    pub fn with_runs(self, folder: Option<PathBuf>) -> Self {
        Self { runs: folder, ..self }
    }

    /// Profiles in a person's folders that could not be used, and why.
    pub fn refused_profiles(&self) -> &[ProfileError] {
        &self.refused
    }

    /// The ids of the machines that can be chosen.
    pub fn machine_ids(&self) -> Vec<String> {
        let concrete = self.library.machines().into_iter().filter(|listing| !listing.is_abstract);
        concrete.map(|listing| listing.id).collect()
    }

    /// The kind of a profile, by its id alone where no kind is given and only one has it.
    pub fn kind_of(&self, id: &str, kind: Option<Kind>) -> Result<Kind, PlanningError> {
        match (kind, self.library.kinds(id)) {
            (Some(kind), Ok(kinds)) if !kinds.contains(&kind) => {
                Err(PlanningError::OtherKind { id: id.to_owned(), wanted: kind, kinds })
            }
            (Some(kind), _) => Ok(kind),
            (None, Err(error)) => Err(error.into()),
            (None, Ok(kinds)) => match kinds.as_slice() {
                [kind] => Ok(*kind),
                _ => Err(PlanningError::SeveralKinds { id: id.to_owned(), kinds }),
            },
        }
    }
}
