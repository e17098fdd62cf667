//! Drivers: the list, the rules, and trust.

use std::io::Write;

use wirebend_api::{
    DriverCheckResponse, DriverEntry, DriverState, DriverTrustResponse, DriversResponse, SeverityName,
};

use super::tables::table;
use super::{advice, severity_style};

pub(super) fn list(
    out: &mut impl Write,
    err: &mut impl Write,
    found: &DriversResponse,
) -> std::io::Result<()> {
    let rows = found.drivers.iter().filter(|driver| driver.problem.is_none()).map(|driver| {
        let formats: Vec<&str> = driver.formats.iter().map(|format| format.id.as_str()).collect();
        [
            driver.id.clone().unwrap_or_default(),
            driver.version.clone().unwrap_or_default(),
            state(driver.state).to_owned(),
            formats.join(", "),
            if driver.capabilities.contains(&wirebend_api::Capability::Live) { "yes" } else { "no" }
                .to_owned(),
            driver.machines.join(", "),
        ]
    });
    table(out, ["id", "version", "from", "writes", "moves", "machines"], rows)?;
    found.drivers.iter().try_for_each(|driver| unusable(err, driver))?;
    found.missing.iter().try_for_each(|what| writeln!(err, "not found: {what}"))
}

const fn state(state: DriverState) -> &'static str {
    match state {
        DriverState::Shipped => "the program",
        DriverState::Accepted => "accepted",
        DriverState::Unknown => "not accepted",
        DriverState::Changed => "changed",
        DriverState::Refused => "not usable",
    }
}

fn unusable(err: &mut impl Write, driver: &DriverEntry) -> std::io::Result<()> {
    let Some(problem) = &driver.problem else { return Ok(()) };
    let style = severity_style(SeverityName::Warning);
    writeln!(err, "{style}{}{style:#}: {problem}", state(driver.state))?;
    advice::write(err, &driver.remedies)
}

pub(super) fn check(err: &mut impl Write, found: &DriverCheckResponse) -> std::io::Result<()> {
    for rule in &found.rules {
        match &rule.broken {
            None => writeln!(err, "kept    {}", rule.rule)?,
            Some(what) => {
                let style = severity_style(SeverityName::Error);
                writeln!(err, "{style}BROKEN{style:#}  {}\n        {what}", rule.rule)?;
            }
        }
    }
    let broken = found.rules.iter().filter(|rule| rule.broken.is_some()).count();
    let library = found.library.display();
    writeln!(err, "{library}: {} rules tried, {broken} broken; SHA-256 {}", found.rules.len(), found.sha256)
}

pub(super) fn trust(err: &mut impl Write, found: &DriverTrustResponse) -> std::io::Result<()> {
    let library = found.library.display();
    if found.accepted {
        let (id, version) =
            (found.id.as_deref().unwrap_or_default(), found.version.as_deref().unwrap_or_default());
        return writeln!(err, "{library}: accepted as it is now: driver '{id}', version {version}");
    }
    let hash = &found.sha256;
    writeln!(err, "{library}\nSHA-256 {hash}")?;
    writeln!(
        err,
        "A driver runs with your rights. If this is the library that its author gave you, trust it with:"
    )?;
    writeln!(err, "  wirebend driver trust {library} --sha256 {hash}")
}
