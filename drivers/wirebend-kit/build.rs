//! Compiles the firmware's core with its virtual clock: the simulated controller runs the real code.

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
        let mut files = Vec::new();
        sources(&folder, &mut files)?;
        files.sort();
        build.files(files);
    }
    println!("cargo:rerun-if-changed={machine}");
    // Tests simulate minutes too, and wait for them in seconds.
    build.opt_level(2);
    build.warnings(true).extra_warnings(true).flag_if_supported("-Wconversion");
    build.compile("wirebend_controller");
    Ok(())
}

/// Adds the files in C of a folder and of the folders in it.
fn sources(folder: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            sources(&path, files)?;
        } else if path.extension().is_some_and(|extension| extension == "c") {
            files.push(path);
        }
    }
    Ok(())
}
