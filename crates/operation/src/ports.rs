//! `ports`: where machines can be.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_driver_host::OpenDriver;
use wirebend_driver_host::api::{Capability, Port, Usb};
use wirebend_error::ErrorRemedy;

use crate::FrontEnd;
use crate::{LiveProblem, OperationError};
use wirebend_planning::job::opened;
use wirebend_planning::{DriverProblem, Installation};

/// Asks for the ports.
#[derive(Debug, Clone, Default, Deserialize, JsonSchema)]
pub struct PortsRequest {
    /// For this machine; absent, for every machine.
    pub machine: Option<String>,
    /// For the machines of this driver; absent, of every driver.
    pub driver: Option<String>,
}

#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct PortEntry {
    /// What `--port` takes.
    pub name: String,
    /// What is plugged in there, as far as it is known.
    pub description: String,
    /// What the plug says of itself; null where it is no USB port.
    pub usb: Option<Usb>,
    /// Drivers that list it.
    pub drivers: Vec<String>,
    /// Those that guess that one of their machines is there. Several kinds of machines have the same chip.
    pub likely_for: Vec<String>,
    /// No machine is at it: a driver computes one. The first is taken where no port is named.
    pub simulated: bool,
}

#[derive(Debug, Clone, Serialize, JsonSchema)]
pub struct PortsResponse {
    /// Those that a machine is likely at first.
    pub ports: Vec<PortEntry>,
    /// Drivers that could not be asked, and why.
    pub problems: Vec<String>,
    /// What can be done about that.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub remedies: Vec<ErrorRemedy>,
}

pub fn ports(
    app: &Installation,
    request: &PortsRequest,
    progress: &dyn FrontEnd,
) -> Result<PortsResponse, OperationError> {
    progress.stage("asking drivers");
    let mut response = PortsResponse { ports: Vec::new(), problems: Vec::new(), remedies: Vec::new() };
    if let Some(machine) = &request.machine {
        let profile = app.library.machine(machine)?.profile;
        let driver = opened(app, &profile)?;
        require_ports(&driver, machine)?;
        response.add(&driver)?;
    } else if let Some(id) = &request.driver {
        let driver = app.driver(id)?.open(&serde_json::json!({})).map_err(DriverProblem::from)?;
        require_ports(&driver, id)?;
        response.add(&driver)?;
    } else {
        for started in app.all_drivers()? {
            // One that fails does not hide what the others say.
            let asked = started.and_then(|driver| {
                if !driver.description().can(Capability::Ports) {
                    return Ok(());
                }
                let driver = driver.open(&serde_json::json!({}))?;
                Ok(response.add(&driver)?)
            });
            if let Err(error) = asked {
                response.problems.push(error.to_string());
                response.remedies.extend(error.remedies());
            }
        }
    }
    response.ports.sort_by_key(|port| port.likely_for.is_empty());
    Ok(response)
}

fn require_ports(driver: &OpenDriver, machine: &str) -> Result<(), LiveProblem> {
    if driver.description().can(Capability::Ports) {
        return Ok(());
    }
    let driver = driver.description().id.clone();
    Err(LiveProblem::FilesOnly { machine: machine.to_owned(), driver })
}

impl PortsResponse {
    fn add(&mut self, driver: &OpenDriver) -> Result<(), wirebend_driver_host::HostError> {
        let id = &driver.description().id;
        for Port { name, description, usb, likely, simulated } in driver.ports()? {
            let place = self.ports.iter().position(|port| port.name == name).unwrap_or_else(|| {
                let (drivers, likely_for) = (Vec::new(), Vec::new());
                self.ports.push(PortEntry { name, description, usb, drivers, likely_for, simulated });
                self.ports.len() - 1
            });
            let port = &mut self.ports[place];
            port.drivers.push(id.clone());
            port.likely_for.extend(likely.then(|| id.clone()));
        }
        Ok(())
    }
}
