//! Drivers in C, built with a C compiler and the header alone, far from this repository; and folders to put them in.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::{Ran, root, run_in, run_program, wirebend};

/// A person's home for a test: their configuration, and a folder `mine` with drivers.
pub struct Home {
    folder: tempfile::TempDir,
}

impl Home {
    pub fn new() -> Self {
        let home = Self { folder: tempfile::tempdir().unwrap() };
        fs::create_dir(home.path("mine")).unwrap();
        home
    }

    /// The absolute path without links of a file that may not be there yet.
    pub fn path(&self, name: &str) -> PathBuf {
        self.folder.path().canonicalize().unwrap().join(name)
    }

    /// The same as a word for the command line.
    pub fn word(&self, name: &str) -> String {
        self.path(name).display().to_string()
    }

    pub fn run(&self, arguments: &[&str]) -> Ran {
        run_in(self.folder.path(), arguments, b"")
    }

    /// Runs with the drivers of the folder `mine`.
    pub fn run_with_mine(&self, arguments: &[&str]) -> Ran {
        self.run(&[arguments, &["--driver-path", "mine"]].concat())
    }

    /// The program as a user would install it: in a folder of its own, `drivers/` beside it.
    pub fn installed(&self) -> PathBuf {
        let program = self.path("installed/wirebend");
        fs::create_dir_all(self.path("installed/drivers")).unwrap();
        if !program.exists() {
            fs::copy(wirebend(), &program).unwrap();
        }
        program
    }

    pub fn run_installed(&self, arguments: &[&str]) -> Ran {
        run_program(&self.installed(), self.folder.path(), arguments, b"")
    }

    pub fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
    }

    /// Builds the C template by its own Makefile into the folder `mine`, from a copy that has the header and
    /// nothing else of the repository.
    pub fn make_template(&self) -> PathBuf {
        let sources = self.path("template-c");
        fs::create_dir(&sources).unwrap();
        for entry in fs::read_dir(root().join("drivers/template-c")).unwrap() {
            let file = entry.unwrap().path();
            if file.is_file() {
                fs::copy(&file, sources.join(file.file_name().unwrap())).unwrap();
            }
        }
        fs::copy(header(), sources.join("wirebend_driver.h")).unwrap();
        let mut make = Command::new("make");
        make.arg("-C")
            .arg(&sources)
            .arg("HEADER=wirebend_driver.h")
            .arg(format!("OUT={}", self.word("mine")));
        // `make test` hands its own flags down, which mean nothing here.
        done(make.env_remove("MAKEFLAGS"));
        let library = self.path(&format!("mine/libtemplate_c_driver.{}", std::env::consts::DLL_EXTENSION));
        assert!(library.is_file());
        library
    }

    /// Compiles a few lines of C with the header to a library in a folder.
    pub fn compile(&self, folder: &str, name: &str, text: &str) -> PathBuf {
        let (source, library) =
            (self.path("source.c"), self.path(&format!("{folder}/{}", library_name(name))));
        fs::write(&source, text).unwrap();
        let mut cc = Command::new("cc");
        cc.args(["-std=c11", "-Wall", "-Wextra", "-Werror", "-fPIC", "-shared", "-o"]).arg(&library);
        done(cc.arg("-I").arg(header().parent().unwrap()).arg(&source));
        library
    }
}

fn header() -> PathBuf {
    root().join("crates/driver-api/include/wirebend_driver.h")
}

pub fn library_name(name: &str) -> String {
    format!("{}{name}{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX)
}

fn done(command: &mut Command) {
    let made = command.output().unwrap_or_else(|error| {
        panic!(
            "{command:?}: {error}; this test needs make and a C compiler: apt-get install -y build-essential"
        )
    });
    assert!(made.status.success(), "{command:?}:\n{}", String::from_utf8_lossy(&made.stderr));
}

/// A driver that does nothing but say of which major version of the boundary it is, and leave a mark when its library
/// is loaded.
pub fn driver_of_major(major: &str, mark: &Path) -> String {
    format!(
        r#"#include <stdio.h>
#include "wirebend_driver.h"

__attribute__((constructor)) static void loaded(void) {{
    FILE *file = fopen("{}", "w");
    if (file != NULL) {{
        fclose(file);
    }}
}}

static const wirebend_driver table = {{.abi_major = {major}, .abi_minor = 0}};

WIREBEND_EXPORT const wirebend_driver *wirebend_driver_entry(void) {{
    return &table;
}}
"#,
        mark.display()
    )
}
