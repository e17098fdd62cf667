//! Files derived from code or tables: JSON Schemas, the reference of the command line, codes of the wire
//! protocol, packages of others, pictures. One module here for each kind of file.

mod packages;
mod pictures;
mod protocol;
mod reference;
mod schemas;

use std::path::Path;

use anyhow::Result;

use crate::committed::CommittedFile;

/// Every derived file of the workspace.
pub(crate) fn files(root: &Path) -> Result<Vec<CommittedFile>> {
    let mut files = schemas::files()?;
    files.push(reference::file());
    files.extend(protocol::files(root)?);
    files.push(packages::file(root)?);
    files.extend(pictures::files(root)?);
    Ok(files)
}
