//! Machine drivers: which there are, which of them writes a format, and whether one is trusted.

mod boards;
mod check;
mod job;
mod limits;
mod list;
mod making;
mod problem;
mod signs;
mod trust;

use std::path::PathBuf;

use wirebend_driver_host::api::{Content, Description, FormatDescription};
use wirebend_driver_host::{Driver, Found, HostError, Launch, Places, Shelf, TrustStore, Verdict};

use crate::machine::Setup;
use crate::{App, AppError, ExportFormat};
pub(crate) use boards::{Board, Boards, Met};
pub(crate) use check::check;
pub use check::{DriverCheckRequest, DriverCheckResponse, RuleReport};
pub(crate) use job::{Stages, job};
pub(crate) use limits::Told;
pub(crate) use list::drivers;
pub use list::{DriverEntry, DriverState, DriversRequest, DriversResponse};
pub(crate) use making::{opened, work};
pub use problem::DriverProblem;
pub(crate) use signs::Signs;
pub(crate) use trust::trust;
pub use trust::{DriverTrustRequest, DriverTrustResponse};

/// Where drivers are, and which program runs each in a process of its own.
#[derive(Debug, Clone, Default)]
pub struct DriverFolders {
    /// The program's own folders; absent, those beside the running program.
    pub own: Option<Vec<PathBuf>>,
    /// The person's folder.
    pub user: Option<PathBuf>,
    /// Folders or libraries named for this time.
    pub named: Vec<PathBuf>,
    /// The list of accepted libraries; without one, none can be accepted.
    pub trusted: Option<PathBuf>,
    /// The program that is a driver's process; absent, the running one.
    pub program: Option<PathBuf>,
}

impl DriverFolders {
    fn launch(&self) -> Result<Launch, DriverProblem> {
        let launch = Launch::this_program().map_err(DriverProblem::OwnProgram)?;
        Ok(match &self.program {
            Some(program) => Launch { program: program.clone(), ..launch },
            None => launch,
        })
    }

    fn store(&self) -> Result<TrustStore, DriverProblem> {
        let file = self.trusted.clone().unwrap_or_default();
        Ok(TrustStore::open(&file).map_err(HostError::from)?)
    }
}

impl App {
    /// Every library that is there; what could not be looked into is told to whoever listens.
    fn told_shelf(&self) -> Result<Shelf, DriverProblem> {
        let shelf = self.shelf()?;
        shelf.missing.iter().for_each(|what| tracing::warn!("no drivers were looked for in {what}"));
        Ok(shelf)
    }

    /// Every library that is there; none is loaded.
    fn shelf(&self) -> Result<Shelf, DriverProblem> {
        let folders = &self.drivers;
        let own = match &folders.own {
            Some(own) => own.clone(),
            None => Places::of_program(&folders.launch()?.program),
        };
        let places = Places { app: own, user: folders.user.clone(), named: folders.named.clone() };
        Ok(Shelf::look(&places, &folders.store()?))
    }

    /// Starts the driver with this id.
    pub(crate) fn driver(&self, id: &str) -> Result<Driver, DriverProblem> {
        let shelf = self.told_shelf()?;
        // One that is named after the id is most likely it; one that is named after another id is not.
        let named_so = |found: &&Found| found.suggested_id().as_deref() == Some(id);
        let unnamed = |found: &&Found| found.suggested_id().is_none();
        let candidates = shelf.found.iter().filter(named_so).chain(shelf.found.iter().filter(unnamed));
        let mut failure = None;
        for found in candidates.filter(|found| may_be_loaded(found) || named_so(found)) {
            match Driver::start(found, &self.drivers.launch()?) {
                Ok(driver) if driver.description().id == id => return Ok(driver),
                Ok(_) => {}
                // A failure of the very driver that is wanted is what a person has to hear.
                Err(error) if named_so(&found) => failure = failure.or(Some(error)),
                Err(error) => tracing::warn!("{error}"),
            }
        }
        Err(match failure {
            Some(error) => error.into(),
            None => DriverProblem::NoDriver { id: id.to_owned(), waiting: waiting(&shelf) },
        })
    }

    /// Starts the driver that writes a format: the machine's own if it does, else the first that does. What
    /// is for one machine alone only that machine's driver writes: another would do it with settings of its own.
    pub(crate) fn driver_of_format(
        &self,
        format: &str,
        setup: &Setup,
    ) -> Result<(Driver, FormatDescription), AppError> {
        let profile = &setup.machine.profile;
        let own_id = profile.driver.id.as_deref().unwrap_or_default();
        let (mut known, mut missing, mut another) = (built_in(), None, false);
        let own = self.driver(own_id).map_err(|error| missing = Some(Box::new(error)));
        for driver in own.into_iter().chain(self.all_drivers()?) {
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
            _ if another => Err(AppError::FormatOfAnother {
                format: format.to_owned(),
                machine: setup.machine_id().to_owned(),
                known: listed.join(", "),
            }),
            missing => {
                known.sort();
                known.dedup();
                Err(AppError::UnknownFormat { name: format.to_owned(), known: known.join(", "), missing })
            }
        }
    }

    /// Every driver that may be loaded, started when its turn comes.
    pub(crate) fn all_drivers(&self) -> Result<impl Iterator<Item = Driver>, DriverProblem> {
        let launch = self.drivers.launch()?;
        let loadable = self.shelf()?.found.into_iter().filter(may_be_loaded);
        Ok(loadable.filter_map(move |found| {
            Driver::start(&found, &launch).inspect_err(|error| tracing::warn!("{error}")).ok()
        }))
    }

    /// The formats that there are, with those of drivers.
    pub(crate) fn formats(&self) -> Result<Vec<String>, DriverProblem> {
        let mut known = built_in();
        self.all_drivers()?.for_each(|driver| known.extend(formats(driver.description())));
        Ok(known)
    }
}

fn built_in() -> Vec<String> {
    ExportFormat::ALL.map(|format| format.id().to_owned()).into()
}

fn formats(description: &Description) -> impl Iterator<Item = String> {
    description.formats.iter().map(|format| format.id.clone())
}

fn may_be_loaded(found: &Found) -> bool {
    matches!(found.verdict, Verdict::Shipped | Verdict::Accepted(_))
}

/// Libraries that nobody has accepted yet: one of them may be what is missing.
fn waiting(shelf: &Shelf) -> Vec<PathBuf> {
    let unknown = |found: &&Found| matches!(found.verdict, Verdict::Unknown(_) | Verdict::Changed(_));
    shelf.found.iter().filter(unknown).map(|found| found.file.clone()).collect()
}
