//! Which libraries are loaded, and which a person is asked about first.

#![cfg(unix)] // who may write where is asked in the words of Unix

use std::fs;
use std::os::unix::fs::{PermissionsExt, symlink};
use std::path::{Path, PathBuf};

use proptest::prelude::*;
use wirebend_driver_host::{
    DiscoveredDriver, Driver, DriverRegistry, Fingerprint, HostError, Launch, LibraryRefusal, Place, Places,
    TrustError, TrustStatus, TrustStore,
};
use wirebend_error::ErrorRemedy;

struct Home {
    folder: tempfile::TempDir,
}

impl Home {
    fn new() -> Self {
        Self { folder: tempfile::tempdir().unwrap() }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().canonicalize().unwrap().join(name)
    }

    fn drivers(&self) -> PathBuf {
        let folder = self.path("drivers");
        fs::create_dir_all(&folder).unwrap();
        folder
    }

    /// A copy of a driver that behaves.
    fn library(&self, name: &str) -> PathBuf {
        let file = self.drivers().join(name);
        fs::copy(wirebend_tests_built::driver("hostile"), &file).unwrap();
        file
    }

    fn trust(&self) -> TrustStore {
        TrustStore::open(&self.path("config/trusted-drivers.json")).unwrap()
    }

    fn user_places(&self) -> Places {
        Places { user: Some(self.drivers()), ..Places::default() }
    }

    fn look(&self) -> Vec<DiscoveredDriver> {
        DriverRegistry::look(&self.user_places(), &self.trust()).found
    }
}

fn launch() -> Launch {
    Launch { program: wirebend_tests_built::driver_child(), memory_bytes: 256 << 20 }
}

/// Without this, a file that lands in a folder would be run.
#[test]
fn a_library_is_asked_about_once_and_again_when_it_changes() {
    let home = Home::new();
    let file = home.library("mine.so");
    let hash = Fingerprint::of(&file).unwrap();

    assert_eq!(home.look()[0].verdict, TrustStatus::Unknown(hash));
    let error = Driver::start(&home.look()[0], &launch()).unwrap_err();
    assert!(matches!(error, HostError::NotTrusted { .. }), "{error}");
    assert!(error.to_string().contains(&hash.to_string()), "{error}");
    assert_eq!(error.remedies(), [ErrorRemedy::TrustDriver { file: file.clone(), again: false }]);

    home.trust().accept(&file, hash).unwrap();
    assert_eq!(home.look()[0].verdict, TrustStatus::Accepted(hash));
    assert_eq!(Driver::start(&home.look()[0], &launch()).unwrap().description().id, "hostile");

    let mut bytes = fs::read(&file).unwrap();
    bytes.push(0);
    fs::write(&file, bytes).unwrap();
    let other = Fingerprint::of(&file).unwrap();
    assert_eq!(home.look()[0].verdict, TrustStatus::Changed(other));
    let error = Driver::start(&home.look()[0], &launch()).unwrap_err();
    assert!(matches!(error, HostError::Changed { .. }), "{error}");
}

/// Between the look and the start another user may change the file.
#[test]
fn a_library_that_is_changed_at_the_last_moment_is_not_loaded() {
    let home = Home::new();
    let file = home.library("mine.so");
    home.trust().accept(&file, Fingerprint::of(&file).unwrap()).unwrap();
    let found = home.look().remove(0);
    let mut bytes = fs::read(&file).unwrap();
    bytes.push(0);
    fs::write(&file, bytes).unwrap();
    let error = Driver::start(&found, &launch()).unwrap_err();
    assert!(matches!(&error, HostError::Load { code, .. } if code == "changed"), "{error}");
}

#[test]
fn what_everybody_may_write_to_is_refused() {
    let home = Home::new();
    let file = home.library("mine.so");
    home.trust().accept(&file, Fingerprint::of(&file).unwrap()).unwrap();
    let set = |path: &Path, mode| fs::set_permissions(path, fs::Permissions::from_mode(mode)).unwrap();
    let refused = || match home.look().remove(0).verdict {
        TrustStatus::Refused(reason) => reason,
        other => panic!("{other:?}"),
    };
    for (path, mode, back) in [
        (file.clone(), 0o666, 0o644),
        (home.drivers(), 0o777, 0o755),
        // Sticky folders keep names to their owners, but let anybody add a library.
        (home.drivers(), 0o1777, 0o755),
        (home.path(""), 0o777, 0o700),
    ] {
        set(&path, mode);
        assert!(refused() == LibraryRefusal::WritableByAll(path.clone()), "{}", path.display());
        let error = Driver::start(&home.look()[0], &launch()).unwrap_err();
        assert!(matches!(error, HostError::Unsafe { .. }), "{error}");
        set(&path, back);
        assert!(matches!(home.look()[0].verdict, TrustStatus::Accepted(_)), "{}", path.display());
    }
}

/// A link must not lend the trust of its own place to what it points at.
#[test]
fn a_link_is_what_it_points_at() {
    let home = Home::new();
    let file = home.library("real.so");
    let linked = home.path("elsewhere.so");
    fs::rename(&file, &linked).unwrap();
    symlink(&linked, home.drivers().join("link.so")).unwrap();
    let found = home.look().remove(0);
    assert_eq!(found.file, linked);
    home.trust().accept(&found.file, Fingerprint::of(&linked).unwrap()).unwrap();
    assert!(matches!(home.look()[0].verdict, TrustStatus::Accepted(_)));
    fs::remove_file(&linked).unwrap();
    assert!(matches!(home.look()[0].verdict, TrustStatus::Refused(_)), "a link to nothing");
}

/// Reading a pipe would wait for ever.
#[test]
fn what_is_no_file_is_refused() {
    let home = Home::new();
    let made = std::process::Command::new("mkfifo").arg(home.drivers().join("pipe.so")).status().unwrap();
    assert!(made.success());
    fs::create_dir(home.drivers().join("folder.so")).unwrap();
    assert!(
        home.look().iter().all(|found| matches!(found.verdict, TrustStatus::Refused(_))),
        "{:?}",
        home.look()
    );
}

/// A program that was unpacked where everybody may write must not take what others put beside it.
#[test]
fn beside_a_program_nobody_else_may_put_a_library() {
    let home = Home::new();
    let file = home.library("libwirebend_driver_pensa.so");
    let places = Places { app: vec![home.drivers()], ..Places::default() };
    let verdict = || DriverRegistry::look(&places, &home.trust()).found.remove(0).verdict;
    assert_eq!(verdict(), TrustStatus::Shipped);
    fs::set_permissions(home.drivers(), fs::Permissions::from_mode(0o1777)).unwrap();
    assert!(matches!(verdict(), TrustStatus::Refused(_)), "{}", file.display());
}

#[test]
fn libraries_are_found_where_they_may_be() {
    let home = Home::new();
    home.library("b.so");
    home.library("a.so");
    fs::write(home.drivers().join("README.md"), "not a library").unwrap();
    let names = |found: &[DiscoveredDriver]| -> Vec<String> {
        found.iter().map(|found| found.file.file_name().unwrap().to_string_lossy().into_owned()).collect()
    };
    assert_eq!(names(&home.look()), ["a.so", "b.so"]);

    // Beside a program only what is named as the program's own counts; in its folders everything does.
    let program = home.path("bin/wirebend");
    for name in [
        "bin/libwirebend_driver_pensa.so",
        "bin/libother.so",
        "bin/drivers/x.so",
        "lib/wirebend/drivers/y.so",
    ] {
        fs::create_dir_all(home.path(name).parent().unwrap()).unwrap();
        fs::copy(wirebend_tests_built::driver("hostile"), home.path(name)).unwrap();
    }
    let places = Places { app: Places::of_program(&program), ..Places::default() };
    let shelf = DriverRegistry::look(&places, &home.trust());
    assert_eq!(names(&shelf.found), ["x.so", "y.so", "libwirebend_driver_pensa.so"]);
    assert!(shelf.found.iter().all(|found| found.verdict == TrustStatus::Shipped));
    assert_eq!(shelf.found[2].suggested_id().as_deref(), Some("pensa"));

    // What was named and is not there is reported; the same library twice is one.
    let named = vec![home.path("nowhere"), home.drivers().join("a.so"), home.drivers()];
    let shelf = DriverRegistry::look(&Places { named, ..Places::default() }, &home.trust());
    assert_eq!(names(&shelf.found), ["a.so", "b.so"]);
    assert!(shelf.missing.len() == 1 && shelf.missing[0].contains("nowhere"), "{:?}", shelf.missing);
    assert!(shelf.found.iter().all(|found| found.place == Place::Named));
}

/// A damaged list must neither accept everything nor be lost.
#[test]
fn a_damaged_list_is_told_and_kept() {
    let home = Home::new();
    let file = home.path("list.json");
    for text in [
        "",
        "{",
        "{\"version\": 1, \"accepted\": [{\"library\": \"/x\", \"sha256\": \"00\"}]}",
        "{\"trusted\": []}",
    ] {
        fs::write(&file, text).unwrap();
        let error = TrustStore::open(&file).unwrap_err();
        assert!(
            matches!(error, TrustError::Shape { .. }) && error.to_string().contains("list.json"),
            "{error}"
        );
        assert_eq!(fs::read_to_string(&file).unwrap(), text);
    }
    fs::write(&file, "{\"version\": 2, \"accepted\": []}").unwrap();
    assert!(matches!(TrustStore::open(&file).unwrap_err(), TrustError::Version { version: 2, .. }));
    let error = TrustStore::open(&home.drivers()).unwrap_err();
    assert!(matches!(error, TrustError::Io { .. }), "{error}");
}

#[test]
fn the_list_outlives_the_program() {
    let home = Home::new();
    let (one, two) = (home.library("one.so"), home.library("two.so"));
    let hash = Fingerprint::of(&one).unwrap();
    home.trust().accept(&one, hash).unwrap();
    home.trust().accept(&two, hash).unwrap();
    assert_eq!((home.trust().accepted(&one), home.trust().accepted(&two)), (Some(hash), Some(hash)));
    assert_eq!(home.trust().accepted(Path::new("/other.so")), None);
}

/// The hash is the one that other programs show.
#[test]
fn a_fingerprint_is_a_sha_256() {
    let home = Home::new();
    let file = home.path("abc");
    fs::write(&file, "abc").unwrap();
    // FIPS 180-2, appendix B.1.
    let known = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
    assert_eq!(Fingerprint::of(&file).unwrap().to_string(), known);
}

proptest! {
    #[test]
    fn any_text_is_a_fingerprint_or_an_error(text in "[0-9a-fA-Fx ]{0,70}|\\PC{0,70}") {
        match text.parse::<Fingerprint>() {
            Ok(hash) => prop_assert_eq!(hash.to_string(), text.to_lowercase()),
            Err(error) => prop_assert!(error.contains("64 hexadecimal digits")),
        }
    }
}
