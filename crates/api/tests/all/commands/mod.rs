//! Commands as a front end gives them, without a window or a command line.

mod compare;
mod profiles;
mod starts;

use std::path::PathBuf;

use wirebend_api::{DesignInput, PlanChoices};

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn example(name: &str) -> DesignInput {
    DesignInput::file(root().join("examples").join(name))
}

/// A machine, the cheapest edges travelled twice.
fn doubled(machine: &str) -> PlanChoices {
    PlanChoices { machine: Some(machine.to_owned()), double: true, ..PlanChoices::default() }
}
