//! Libraries that cannot be used, and the ways in which each is reported.
#![cfg(unix)] // folders for everybody, and compilers that take Unix words

use std::fs;
use std::os::unix::fs::PermissionsExt;

use serde_json::Value;

use super::in_c::{Home, driver_of_major, library_name};
use crate::{assert_fits, example, run};

/// Loading a library runs its code. Only `driver check` does that with one that was not accepted.
#[test]
fn what_nobody_has_accepted_is_run_by_a_check_alone() {
    let home = Home::new();
    let mark = home.path("loaded");
    let library = home.compile("mine", "marked", &driver_of_major("WIREBEND_ABI_MAJOR", &mark));
    let path = library.display().to_string();
    home.run_with_mine(&["drivers"]).ended(0);
    home.run_with_mine(&["export", &example("house.obj"), "-m", "grbl-bender", "-o", "house.nc"]).ended(0);
    home.run_with_mine(&["export", &example("house.obj"), "-m", "grbl-bender", "-f", "marked-text"]).ended(2);
    home.run(&["driver", "trust", &path]).ended(2);
    home.run(&["driver", "trust", &path, "--sha256", &"0".repeat(64)]).ended(2);
    assert!(!mark.exists(), "it was run");
    let said = home.run(&["driver", "check", &path]).ended(5).err;
    assert!(mark.exists() && said.contains("the function 'describe' is missing"), "{said}");
}

/// Its table may look different from ours, so nothing but its version is read.
#[test]
fn a_driver_for_the_next_version_of_the_boundary_is_refused_with_advice() {
    let home = Home::new();
    let newer = driver_of_major("WIREBEND_ABI_MAJOR + 1", &home.path("loaded"));
    let library = home.compile("mine", "newer", &newer);
    let path = library.display().to_string();
    let advice = "was built for version 2.0 of the driver interface, this program speaks 1.7\n  help: update the program\n";
    let said = home.run(&["driver", "check", &path]).ended(5).err;
    assert!(said.contains(advice) && said.contains(&library_name("newer")), "{said}");
    let told = home.run(&["driver", "check", &path, "--json"]).ended(5).json();
    assert_fits("error", &told);
    assert_eq!(told["error"]["code"], "driver-load");
    // To accept it gives the same report, and it is not accepted.
    let hash = home.run(&["driver", "trust", &path, "--json"]).ended(2).json()["sha256"].clone();
    let said = home.run(&["driver", "trust", &path, "--sha256", hash.as_str().unwrap()]).ended(5).err;
    assert!(said.contains(advice), "{said}");
    assert!(!home.path("wirebend/trusted-drivers.json").exists());
    // Left over in the program's own folder, say by an update, it is listed and the others work.
    home.installed();
    fs::copy(&library, home.path("installed/drivers").join(library.file_name().unwrap())).unwrap();
    let tables = wirebend_tests_built::driver("tables");
    fs::copy(&tables, home.path("installed/drivers").join(tables.file_name().unwrap())).unwrap();
    let ran = home.run_installed(&["drivers"]).ended(0);
    assert!(ran.err.contains("not usable") && ran.err.contains(advice), "{}", ran.err);
    assert!(String::from_utf8(ran.out).unwrap().contains("lra-csv"));
    let list = home.run_installed(&["drivers", "--json"]).ended(0).json();
    assert_fits("drivers", &list);
    let states: Vec<&Value> =
        list["drivers"].as_array().unwrap().iter().map(|driver| &driver["state"]).collect();
    assert_eq!(states, ["refused", "shipped"], "{list:#}");
}

/// A user who may write to a folder could put another library into the place of an accepted one.
#[test]
fn a_library_that_everybody_could_replace_is_refused() {
    let home = Home::new();
    let library = home.make_template();
    let path = library.display().to_string();
    let hash = home.run(&["driver", "trust", &path, "--json"]).ended(2).json()["sha256"].clone();
    let hash = hash.as_str().unwrap();
    home.run(&["driver", "trust", &path, "--sha256", hash]).ended(0);
    fs::set_permissions(home.path("mine"), fs::Permissions::from_mode(0o777)).unwrap();
    let advice = format!("chmod o-w {}", home.word("mine"));
    let said = home.run_with_mine(&["drivers"]).ended(0).err;
    assert!(said.contains("not usable") && said.contains(&advice), "{said}");
    for arguments in [&["driver", "trust", &path][..], &["driver", "trust", &path, "--sha256", hash]] {
        let said = home.run(arguments).ended(5).err;
        assert!(
            said.contains("every user of this computer may write to") && said.contains(&advice),
            "{said}"
        );
    }
    let format = ["export", &example("house.obj"), "-m", "grbl-bender", "-f", "template-c-text"];
    let said = home.run_with_mine(&format).ended(2).err;
    assert!(said.contains("'template-c-text' is not a format"), "{said}");
    fs::set_permissions(home.path("mine"), fs::Permissions::from_mode(0o755)).unwrap();
    let table = String::from_utf8(home.run_with_mine(&["drivers"]).ended(0).out).unwrap();
    assert!(table.contains("template-c-text"), "{table}");
}

#[test]
fn what_is_no_driver_is_told_from_what_is_not_there() {
    let home = Home::new();
    fs::write(home.path("note.txt"), "no library at all\n").unwrap();
    let said = home.run(&["driver", "check", "note.txt"]).ended(5).err;
    assert!(
        said.contains("note.txt") && said.contains("not a library that this computer can load"),
        "{said}"
    );
    let said = home.run(&["driver", "check", "nowhere.so"]).ended(3).err;
    assert!(said.contains("nowhere.so") && said.contains("No such file"), "{said}");
    let said = home.run(&["driver", "trust", "nowhere.so"]).ended(3).err;
    assert!(said.contains("nowhere.so"), "{said}");
    let other = home.compile("mine", "other", "int unrelated(void);\nint unrelated(void) { return 7; }\n");
    let said = home.run(&["driver", "check", other.to_str().unwrap()]).ended(5).err;
    assert!(said.contains("it does not export 'wirebend_driver_entry': it is no WireBend driver"), "{said}");
    let error = home.run(&["driver", "check", other.to_str().unwrap(), "--json"]).ended(5).json();
    assert_fits("error", &error);
    let list = home.run(&["drivers", "--driver-path", "nowhere", "--json"]).ended(0).json();
    assert_fits("drivers", &list);
    assert!(list["missing"][0].as_str().unwrap().starts_with("nowhere: "), "{list:#}");
    let said = home.run(&["drivers", "--driver-path", "nowhere"]).ended(0).err;
    assert!(said.contains("not found: nowhere: "), "{said}");
}

/// The hidden command runs a library; a person who finds it gets a sentence.
#[test]
fn the_process_of_a_driver_is_not_for_people() {
    for arguments in
        [&["driver-child"][..], &["driver-child", "library.so"], &["driver-child", "a", "b", "c"]]
    {
        let ran = run(arguments).ended(2);
        assert!(ran.err.contains("for the program itself") && ran.out.is_empty(), "{}", ran.err);
    }
}
