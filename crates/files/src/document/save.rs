//! Saving so that a file is either the old one or the new one, whatever happens in between.

use std::fs;
use std::io::{self, Write};
use std::path::Path;

use super::error::DocumentError;

/// Writes a file by way of a temporary one in the same folder: write, fsync, rename, fsync of the
/// folder. Whenever it is interrupted, the path holds the old content or the new one. A symbolic
/// link is followed; the permissions of a file that is there are kept.
///
/// # Errors
/// [`DocumentError::Save`]; what was at the path is still there.
pub fn save_atomically(path: &Path, bytes: &[u8]) -> Result<(), DocumentError> {
    write(path, bytes).map_err(|error| DocumentError::Save { path: path.display().to_string(), error })
}

fn write(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let mut builder = tempfile::Builder::new();
    builder.prefix(".wirebend-");
    // As a newly created file would have; the umask still applies.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    fs::metadata(folder)?;
    // Its errors name the temporary file, which means nothing to a person.
    let mut file = builder.tempfile_in(folder).map_err(|error| io::Error::from(error.kind()))?;
    file.as_file_mut().write_all(bytes)?;
    if let Ok(old) = fs::metadata(&path) {
        file.as_file().set_permissions(old.permissions())?;
    }
    file.as_file().sync_all()?;
    file.persist(&path).map_err(|error| error.error)?;
    // The rename itself is only safe once the folder is; not every system can open one.
    if cfg!(unix) {
        fs::File::open(folder)?.sync_all()?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_save_replaces_the_whole_file_and_leaves_nothing_else() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.wirebend");
        save_atomically(&path, b"a long first version").unwrap();
        save_atomically(&path, b"second").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"second");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "no temporary file stays");
    }

    #[test]
    fn a_save_that_fails_keeps_the_old_file_and_says_so() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("missing").join("a.wirebend");
        let error = save_atomically(&path, b"x").unwrap_err();
        assert!(matches!(error, DocumentError::Save { .. }) && error.code() == "document-save");
        assert!(!error.to_string().contains(".wirebend-"), "{error}");
        // A folder stands where the file should go: the rename fails after the write.
        let taken = folder.path().join("taken");
        fs::create_dir_all(taken.join("inside")).unwrap();
        assert!(save_atomically(&taken, b"x").is_err());
        assert!(taken.join("inside").exists());
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1, "no temporary file stays");
    }

    #[cfg(unix)]
    #[test]
    fn links_and_permissions_survive() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().unwrap();
        let (path, link) = (folder.path().join("real"), folder.path().join("link"));
        save_atomically(&path, b"1").unwrap();
        fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).unwrap();
        std::os::unix::fs::symlink(&path, &link).unwrap();
        save_atomically(&link, b"2").unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"2");
        assert!(fs::symlink_metadata(&link).unwrap().is_symlink());
        assert_eq!(fs::metadata(&path).unwrap().permissions().mode() & 0o777, 0o640);
    }
}
