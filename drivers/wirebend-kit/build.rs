//! Compiles the firmware's core with its clock for computers: the simulated controller is the real one.

use std::path::{Path, PathBuf};
use std::{fs, io};

const FIRMWARE: &str = "../../firmware";

fn main() -> io::Result<()> {
    let machine = format!("{FIRMWARE}/machines/wirebend-kit.h");
    let mut build = cc::Build::new();
    build.std("c11").flag("-include").flag(&machine).include(format!("{FIRMWARE}/core"));
    for folder in ["core", "hal_host"] {
        let folder = Path::new(FIRMWARE).join(folder);
        println!("cargo:rerun-if-changed={}", folder.display());
        build.files(sources(&folder)?);
    }
    println!("cargo:rerun-if-changed={machine}");
    // Simulated minutes are run in seconds, in tests too.
    build.opt_level(2);
    build.warnings(true).extra_warnings(true).flag_if_supported("-Wconversion");
    build.compile("wirebend_controller");
    Ok(())
}

fn sources(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut files: Vec<_> =
        fs::read_dir(folder)?.map(|entry| Ok(entry?.path())).collect::<io::Result<_>>()?;
    files.retain(|file| file.extension().is_some_and(|extension| extension == "c"));
    files.sort();
    Ok(files)
}
