//! The profiles inside the program.

use include_dir::{Dir, include_dir};

use crate::Kind;

static FOLDER: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/../../machine-profiles");

/// Name of the folder, the first part of a shipped file's name.
const NAME: &str = "machine-profiles";

/// Name and bytes of every shipped profile.
pub(crate) fn files() -> impl Iterator<Item = (String, &'static [u8])> {
    Kind::ALL
        .into_iter()
        .filter_map(|kind| FOLDER.get_dir(kind.folder()))
        .flat_map(Dir::files)
        .filter(|file| file.path().extension().is_some_and(|extension| extension == "json"))
        .map(|file| {
            // Windows embeds backslashes; messages and provenance are the same everywhere.
            let path = file.path().display().to_string().replace('\\', "/");
            (format!("{NAME}/{path}"), file.contents())
        })
}
