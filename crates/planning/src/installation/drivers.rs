//! Which drivers are installed, and the start of one.

use std::path::PathBuf;

use wirebend_driver_host::{
    DiscoveredDriver, Driver, DriverRegistry, HostError, Launch, Places, TrustStatus, TrustStore,
};

use super::Installation;
use crate::error::DriverProblem;

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
    pub fn launch(&self) -> Result<Launch, DriverProblem> {
        let launch = Launch::this_program().map_err(DriverProblem::OwnProgram)?;
        Ok(match &self.program {
            Some(program) => Launch { program: program.clone(), ..launch },
            None => launch,
        })
    }

    pub fn store(&self) -> Result<TrustStore, DriverProblem> {
        let file = self.trusted.clone().unwrap_or_default();
        Ok(TrustStore::open(&file).map_err(HostError::from)?)
    }
}

impl Installation {
    /// Every library that is there; what could not be looked into is reported to the caller.
    fn told_registry(&self) -> Result<DriverRegistry, DriverProblem> {
        let registry = self.registry()?;
        registry.missing.iter().for_each(|what| tracing::warn!("no drivers were looked for in {what}"));
        Ok(registry)
    }

    /// Every library that is there; none is loaded.
    pub fn registry(&self) -> Result<DriverRegistry, DriverProblem> {
        let folders = &self.drivers;
        let own = match &folders.own {
            Some(own) => own.clone(),
            None => Places::of_program(&folders.launch()?.program),
        };
        let places = Places { app: own, user: folders.user.clone(), named: folders.named.clone() };
        Ok(DriverRegistry::look(&places, &folders.store()?))
    }

    /// Starts the driver with this id.
    pub fn driver(&self, id: &str) -> Result<Driver, DriverProblem> {
        let registry = self.told_registry()?;
        // One that is named after the id is most likely it; one that is named after another id is not.
        let named_so = |found: &&DiscoveredDriver| found.suggested_id().as_deref() == Some(id);
        let unnamed = |found: &&DiscoveredDriver| found.suggested_id().is_none();
        let candidates = registry.found.iter().filter(named_so).chain(registry.found.iter().filter(unnamed));
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
            None => DriverProblem::NoDriver { id: id.to_owned(), waiting: waiting(&registry) },
        })
    }

    /// Every driver that may be loaded, started when its turn comes, or why it does not start.
    pub fn all_drivers(&self) -> Result<impl Iterator<Item = Result<Driver, DriverProblem>>, DriverProblem> {
        let launch = self.drivers.launch()?;
        let loadable = self.registry()?.found.into_iter().filter(may_be_loaded);
        Ok(loadable.map(move |found| {
            let started = Driver::start(&found, &launch).inspect_err(|error| tracing::warn!("{error}"));
            started.map_err(DriverProblem::from)
        }))
    }
}

fn may_be_loaded(found: &DiscoveredDriver) -> bool {
    matches!(found.verdict, TrustStatus::Shipped | TrustStatus::Accepted(_))
}

/// Libraries that were not accepted yet: one of them may be what is missing.
fn waiting(registry: &DriverRegistry) -> Vec<PathBuf> {
    let unknown = |found: &&DiscoveredDriver| {
        matches!(found.verdict, TrustStatus::Unknown(_) | TrustStatus::Changed(_))
    };
    registry.found.iter().filter(unknown).map(|found| found.file.clone()).collect()
}
