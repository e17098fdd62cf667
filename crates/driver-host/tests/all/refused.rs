//! What cannot be started at all.

use std::path::{Path, PathBuf};

use wirebend_driver_host::{DiscoveredDriver, Driver, HostError, Launch, Place, TrustStore};

fn launch() -> Launch {
    Launch { program: wirebend_tests_built::driver_child(), memory_bytes: 256 << 20 }
}

fn found(file: &Path) -> DiscoveredDriver {
    DiscoveredDriver::at(file, Place::App, &TrustStore::open(Path::new("none.json")).unwrap())
}

#[test]
fn what_is_no_driver_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let start = |name: &str, bytes: &[u8]| {
        let file: PathBuf = folder.path().join(name);
        std::fs::write(&file, bytes).unwrap();
        Driver::start(&found(&file), &launch()).unwrap_err()
    };
    for (name, bytes) in [
        ("empty.so", &b""[..]),
        ("text.so", b"not a library at all"),
        ("noise.so", b"\x7fELF\x02\x01\x01garbage"),
    ] {
        let error = start(name, bytes);
        assert!(matches!(&error, HostError::Load { code, .. } if code == "library"), "{error}");
        assert!(error.to_string().contains(name), "{error}");
        // Why, in the words of the system: "file too short" or "invalid ELF header".
        #[cfg(target_env = "gnu")]
        assert!(error.to_string().contains("short") || error.to_string().contains("ELF"), "{error}");
    }
}

#[test]
fn a_program_that_is_not_there_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let launch = Launch { program: folder.path().join("nobody"), ..launch() };
    let error = Driver::start(&found(&wirebend_tests_built::driver("hostile")), &launch).unwrap_err();
    assert!(matches!(error, HostError::Start { .. }), "{error}");
}
