//! The pictures of the README, drawn by the program itself.

use std::path::Path;

use anyhow::{Result, bail};
use wirebend_api::{Command, DesignInput, ExportRequest, Installation, NoProgress, PlanChoices, Response};

use crate::committed::CommittedFile;

/// Example, whether its face edges are meant, and machine.
const PICTURES: [(&str, bool, &str); 3] = [
    ("bunny", true, "wirebend-kit"),
    ("cup-holder", false, "wirebend-kit"),
    ("truss-1", false, "pensa-diwire-pro"),
];

pub(super) fn files(root: &Path) -> Result<Vec<CommittedFile>> {
    let app = Installation::new(&[])?;
    PICTURES.iter().map(|&(name, face_edges, machine)| draw(&app, root, name, face_edges, machine)).collect()
}

fn draw(
    app: &Installation,
    root: &Path,
    name: &str,
    face_edges: bool,
    machine: &str,
) -> Result<CommittedFile> {
    let design = DesignInput { face_edges, ..DesignInput::file(root.join(format!("examples/{name}.obj"))) };
    let choices = PlanChoices { machine: Some(machine.into()), double: true, ..PlanChoices::default() };
    let request = ExportRequest {
        design,
        choices,
        format: Some("svg".into()),
        settings: serde_json::Map::new(),
        output: None,
        despite_errors: true,
    };
    let Response::Export(found) = Command::Export(request).run(app, &NoProgress)? else {
        bail!("an export answered something else");
    };
    let text = String::from_utf8(found.contents.concat())?;
    Ok(CommittedFile { path: format!("docs/pictures/{name}.svg"), text })
}
