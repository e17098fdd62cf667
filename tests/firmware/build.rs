//! Compiles the shim over simavr and links the shared library.

use std::path::Path;
use std::process::{Command, ExitCode};

const SHIM: [&str; 3] = ["shim/uno.c", "shim/pins.c", "shim/wire.c"];
/// What has to be installed, as one sentence.
const ADVICE: &str = "the tests of the firmware need the simulator simavr 1.6: apt-get install -y \
                      --no-install-recommends gcc-avr binutils-avr avr-libc libsimavr-dev libelf-dev pkg-config";

fn main() -> ExitCode {
    println!("cargo::rerun-if-changed=shim");
    if std::env::var("CARGO_CFG_TARGET_OS").as_deref() != Ok("linux") {
        return ExitCode::SUCCESS; // the crate is empty there
    }
    let Some(folder) = headers() else {
        println!("cargo::error={ADVICE}");
        return ExitCode::FAILURE;
    };
    // It is called for every cycle of the chip.
    let mut shim = cc::Build::new();
    shim.opt_level(2);
    shim.files(SHIM).std("gnu11").include(&folder).extra_warnings(true).flag_if_supported("-Wno-pedantic");
    if let Err(why) = shim.try_compile("wirebend_simulator_shim") {
        println!("cargo::error=the shim does not compile against {folder}: {why}");
        return ExitCode::FAILURE;
    }
    println!("cargo::rustc-link-lib=dylib=simavr");
    ExitCode::SUCCESS
}

/// The folder of simavr's headers, from `pkg-config`; none when it is not installed.
fn headers() -> Option<String> {
    let asked = Command::new("pkg-config").args(["--cflags-only-I", "simavr"]).output().ok()?;
    if !asked.status.success() {
        return None;
    }
    let flags = String::from_utf8(asked.stdout).ok()?;
    let mut folders = flags.split_whitespace().filter_map(|flag| flag.strip_prefix("-I"));
    folders.find(|folder| Path::new(folder).join("sim_avr.h").is_file()).map(str::to_owned)
}
