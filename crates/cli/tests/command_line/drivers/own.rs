//! A third-party driver, written in C against the header alone: listed, checked, trusted, used, and not
//! used any more once it is another one.

use std::fmt::Write as _;
use std::fs;
use std::io::Write as _;
use std::path::Path;

use serde_json::{Value, json};
use sha2::{Digest, Sha256};

use super::in_c::Home;
use crate::{assert_fits, example};

fn sha256(file: &Path) -> String {
    Sha256::digest(fs::read(file).unwrap()).iter().fold(String::new(), |mut hash, byte| {
        write!(hash, "{byte:02x}").unwrap();
        hash
    })
}

/// What the list says of a library.
fn entry(home: &Home, library: &Path) -> Value {
    let list = home.run_with_mine(&["drivers", "--json"]).ended(0).json();
    assert_fits("drivers", &list);
    let mut drivers = list["drivers"].as_array().unwrap().iter();
    let found = drivers.find(|driver| driver["file"] == library.to_str().unwrap());
    found.unwrap_or_else(|| panic!("{list:#}")).clone()
}

/// A profile of one's own that is made for a driver: started from another, then edited.
fn profile_for(home: &Home, id: &str, driver: &str, format: &str) {
    let new = ["profile", "new", id, "--from", "grbl-bender", "--name", "My bender"];
    home.run(&new).ended(0);
    let file = home.path(&format!("wirebend/machines/{id}.json"));
    let mut profile: Value = serde_json::from_slice(&fs::read(&file).unwrap()).unwrap();
    profile["driver"] = json!({"id": driver, "settings": {"decimals": 2}});
    profile["export"] = json!({"native": format, "formats": ["svg"]});
    fs::write(&file, profile.to_string()).unwrap();
}

fn export(home: &Home, machine: &str, output: &str, more: &[&str]) -> crate::Ran {
    let house = example("house.obj");
    home.run_with_mine(&[&["export", &house, "-m", machine, "-o", output][..], more].concat())
}

/// The whole way of a driver that was not written in Rust, from its compiler to a file for the machine.
#[test]
fn a_driver_in_c_is_listed_checked_trusted_and_used() {
    let home = Home::new();
    let library = home.make_template();
    let (path, hash) = (library.display().to_string(), sha256(&library));

    // Listed as what it is, a file that was not accepted.
    let found = entry(&home, &library);
    assert_eq!((&found["state"], &found["sha256"]), (&json!("unknown"), &json!(hash)));
    assert_eq!(found["id"], Value::Null, "it is not run to see what it is");
    let ran = home.run_with_mine(&["drivers"]).ended(0);
    for said in ["not accepted", &path, &hash, "wirebend driver trust"] {
        assert!(ran.err.contains(said), "{said}: {}", ran.err);
    }
    let table = String::from_utf8(ran.out).unwrap();
    assert!(table.contains("pensa-script") && !table.contains("template-c"), "{table}");

    // Checked, though it was not accepted: a user who names it wants it to be run.
    let checked = home.run(&["driver", "check", &path]).ended(0).err;
    assert!(
        checked.contains(" 0 broken") && checked.contains(&hash) && !checked.contains("BROKEN"),
        "{checked}"
    );
    let checked = home.run(&["driver", "check", &path, "--json"]).ended(0).json();
    assert_fits("driver-check", &checked);
    assert_eq!((&checked["kept"], &checked["sha256"]), (&json!(true), &json!(hash)));
    assert!(checked["rules"].as_array().unwrap().len() > 15, "{checked:#}");

    // Not used before it is accepted, and accepted with the hash alone.
    profile_for(&home, "my-bender", "template-c", "template-c-text");
    let said = export(&home, "my-bender", "house.txt", &[]).ended(5).err;
    assert!(said.contains("'template-c'") && said.contains(&path) && said.contains("not accepted"), "{said}");
    let told = home.run(&["driver", "trust", &path]).ended(2).err;
    assert!(told.contains(&format!("wirebend driver trust {path} --sha256 {hash}")), "{told}");
    let told = home.run(&["driver", "trust", &path, "--json"]).ended(2).json();
    assert_fits("driver-trust", &told);
    assert_eq!(
        (&told["accepted"], &told["sha256"], &told["id"]),
        (&json!(false), &json!(hash), &Value::Null)
    );
    let other = "0".repeat(64);
    let said = home.run(&["driver", "trust", &path, "--sha256", &other]).ended(2).err;
    assert!(said.contains("is not the library that was meant") && said.contains(&hash), "{said}");
    let said = home.run(&["driver", "trust", &path, "--sha256", "0123"]).ended(2).err;
    assert!(said.contains("64 hexadecimal digits"), "{said}");
    assert_eq!(entry(&home, &library)["state"], "unknown");
    let accepted =
        home.run(&["driver", "trust", &path, "--sha256", &hash.to_uppercase(), "--json"]).ended(0).json();
    assert_fits("driver-trust", &accepted);
    assert_eq!((&accepted["accepted"], &accepted["id"]), (&json!(true), &json!("template-c")));

    // Listed with what it says of itself.
    let found = entry(&home, &library);
    assert_eq!((&found["state"], &found["problem"]), (&json!("accepted"), &Value::Null));
    assert_eq!((&found["id"], &found["name"]), (&json!("template-c"), &json!("Template in C")));
    assert_eq!(found["formats"][0]["id"], "template-c-text");
    assert_eq!(found["machines"], json!(["my-bender"]));
    assert!(found["description"].as_str().unwrap().contains("in C"), "{found:#}");

    // Used, with the settings of the profile: its text is that of its twin in Rust.
    home.run_with_mine(&["profile", "check", "wirebend/machines/my-bender.json"]).ended(0);
    export(&home, "my-bender", "house.txt", &[]).ended(0);
    assert_eq!(home.read("house.txt"), text_of_the_twin(&home));
    assert!(
        home.read("house.txt").contains("n, feed_mm, rotate_deg, bend_deg\n1, "),
        "{}",
        home.read("house.txt")
    );

    // Another one by a single byte: asked about again.
    fs::OpenOptions::new().append(true).open(&library).unwrap().write_all(b"\n").unwrap();
    let found = entry(&home, &library);
    assert_eq!((&found["state"], &found["sha256"]), (&json!("changed"), &json!(sha256(&library))));
    assert!(found["problem"].as_str().unwrap().contains("was changed since it was accepted"), "{found:#}");
    assert_eq!(found["id"], Value::Null);
    let said = export(&home, "my-bender", "house.txt", &["--force"]).ended(5).err;
    assert!(said.contains(&path), "{said}");
    home.run(&["driver", "trust", &path, "--sha256", &hash]).ended(2);
    home.run(&["driver", "trust", &path, "--sha256", &sha256(&library)]).ended(0);
    export(&home, "my-bender", "house.txt", &["--force"]).ended(0);
}

/// What the template in Rust writes of the same house for the same machine.
fn text_of_the_twin(home: &Home) -> String {
    let library = wirebend_tests_built::driver("template");
    let path = library.display().to_string();
    profile_for(home, "my-twin", "template", "template-text");
    home.run(&["driver", "trust", &path, "--sha256", &sha256(&library)]).ended(0);
    let house = example("house.obj");
    home.run(&["export", &house, "-m", "my-twin", "-o", "twin.txt", "--driver-path", &path]).ended(0);
    home.read("twin.txt")
}

/// A folder for drivers in a person's configuration is looked into without being named.
#[test]
fn a_persons_own_folder_is_looked_into() {
    let home = Home::new();
    let library = home.make_template();
    fs::create_dir_all(home.path("wirebend")).unwrap();
    fs::rename(home.path("mine"), home.path("wirebend/drivers")).unwrap();
    let library = home.path("wirebend/drivers").join(library.file_name().unwrap());
    home.run(&["driver", "trust", library.to_str().unwrap(), "--sha256", &sha256(&library)]).ended(0);
    let table = String::from_utf8(home.run(&["drivers"]).ended(0).out).unwrap();
    let row = table.lines().find(|line| line.starts_with("template-c ")).unwrap_or_else(|| panic!("{table}"));
    assert!(row.contains("accepted") && row.contains("template-c-text"), "{row}");
    assert!(home.read("wirebend/trusted-drivers.json").contains(&sha256(&library)));
}
