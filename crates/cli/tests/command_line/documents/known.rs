//! What there is: keys of schemas, settings of drivers, commands and their options, formats, codes, files.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

use crate::documents::root;

/// Formats that the program writes without a driver.
const OWN_FORMATS: [&str; 9] =
    ["svg", "png", "obj", "obj-tube", "gltf", "template-svg", "template-dxf", "template-pdf", "job-sheet"];

/// A JSON file of the repository.
pub fn json(path: &str) -> Value {
    let bytes = std::fs::read(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"));
    serde_json::from_slice(&bytes).unwrap()
}

/// Whether objects of a schema can have a key; `a.b` is the key b of what is at a, `[]` goes into lists by itself.
pub fn has_key(whole: &Value, schema: &Value, path: &str) -> bool {
    let here = |inner: &Value| has_key(whole, inner, path);
    if let Some((file, name)) = schema["$ref"].as_str().and_then(|to| to.split_once('#')) {
        if !file.is_empty() {
            let other = json(&format!("crates/api/schema/{file}"));
            return other.pointer(name).is_some_and(|inner| has_key(&other, inner, path));
        }
        return whole.pointer(name).is_some_and(here);
    }
    let (key, rest) = path.split_once('.').map_or((path, None), |(key, rest)| (key, Some(rest)));
    let inner = &schema["properties"][key];
    if !inner.is_null() {
        return rest.is_none_or(|rest| has_key(whole, inner, rest));
    }
    let choices = ["anyOf", "oneOf", "allOf"].iter().filter_map(|kind| schema[*kind].as_array()).flatten();
    choices
        .chain(["items", "additionalProperties"].iter().map(|kind| &schema[*kind]))
        .any(|inner| inner.is_object() && here(inner))
}

/// Values of a key by which the messages of a schema differ.
pub fn constants(path: &str, key: &str) -> BTreeSet<String> {
    fn walk(value: &Value, key: &str, found: &mut BTreeSet<String>) {
        if let Some(name) = value["properties"][key]["const"].as_str() {
            found.insert(name.to_owned());
        }
        let inner = value
            .as_object()
            .into_iter()
            .flat_map(|map| map.values())
            .chain(value.as_array().into_iter().flatten());
        inner.for_each(|inner| walk(inner, key, found));
    }
    let mut found = BTreeSet::new();
    walk(&json(path), key, &mut found);
    assert!(!found.is_empty(), "{path} states no {key}");
    found
}

/// What the program answers as JSON, to a user who has no files of their own.
fn answer(arguments: &[&str]) -> Value {
    let program = crate::documents::console::program_folder().join("wirebend");
    let home = tempfile::tempdir().unwrap();
    let mut command = Command::new(program);
    command
        .args(arguments)
        .env("HOME", home.path())
        .env("XDG_CONFIG_HOME", home.path())
        .env("XDG_DATA_HOME", home.path());
    serde_json::from_slice(&command.output().unwrap().stdout).unwrap()
}

/// `plan`, `profile new` and so on; what is there for other programs alone is left out.
pub fn commands(command: &clap::Command, before: &str) -> BTreeSet<String> {
    let inner = command.get_subcommands().filter(|inner| inner.get_name() != "help" && !inner.is_hide_set());
    inner
        .flat_map(|inner| {
            let name = format!("{before}{}", inner.get_name());
            let below = commands(inner, &format!("{name} "));
            if below.is_empty() { BTreeSet::from([name]) } else { below }
        })
        .collect()
}

/// The options of a command as they are typed.
pub fn options(command: &str) -> BTreeSet<String> {
    let mut root = wirebend_cli::command();
    root.build();
    let found = command.split(' ').fold(&root, |command, name| command.find_subcommand(name).unwrap());
    found.get_arguments().filter_map(|argument| argument.get_long()).map(|name| format!("--{name}")).collect()
}

/// What `export --format` takes: the program's own formats and those of drivers.
pub fn formats() -> BTreeSet<String> {
    let drivers = answer(&["drivers", "--json"]);
    let drivers = drivers["drivers"].as_array().unwrap().iter();
    let theirs = drivers.flat_map(|driver| driver["formats"].as_array().unwrap());
    let theirs = theirs.map(|format| format["id"].as_str().unwrap().to_owned());
    theirs.chain(OWN_FORMATS.map(str::to_owned)).collect()
}

#[test]
fn the_own_formats_of_the_program_can_be_written() {
    let house = root().join("examples/house.obj").display().to_string();
    for format in OWN_FORMATS {
        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("house").display().to_string();
        let written =
            answer(&["export", &house, "-m", "wirebend-kit", "--format", format, "-o", &file, "--json"]);
        assert!(written["error"].is_null(), "{format}: {written}");
    }
}

/// What `--from` takes: the names in `read/format.rs`.
pub fn readers() -> BTreeSet<String> {
    let text = std::fs::read_to_string(root().join("crates/files/src/read/format.rs")).unwrap();
    let names = text.split("fn name(self)").nth(1).and_then(|rest| rest.split("fn ").next()).unwrap();
    let quoted = names.lines().filter_map(|line| line.trim().strip_suffix("\",")?.split_once(" => \""));
    quoted.map(|(_, name)| name.to_owned()).collect()
}

/// The codes of `checks/code.rs`.
pub fn checks() -> BTreeSet<String> {
    let text = std::fs::read_to_string(root().join("crates/core/src/checks/code.rs")).unwrap();
    let codes = text.lines().filter_map(|line| line.trim().strip_suffix("\",")?.split_once(" = \""));
    codes.map(|(_, code)| code.to_owned()).collect()
}

/// Names of the files of a folder without their ends.
pub fn ids(folder: &str) -> BTreeSet<String> {
    let names = files(folder).into_iter().filter_map(|name| name.strip_suffix(".json").map(str::to_owned));
    // A base to inherit from is no wire.
    names.filter(|id| json(&format!("{folder}/{id}.json"))["abstract"] != true).collect()
}

/// Names of the files of a folder.
pub fn files(folder: &str) -> BTreeSet<String> {
    let entries = std::fs::read_dir(root().join(folder)).unwrap().map(|entry| entry.unwrap());
    entries
        .filter(|entry| entry.path().is_file())
        .map(|entry| entry.file_name().display().to_string())
        .collect()
}

/// Names of the folders of a folder.
pub fn folders(folder: &str) -> BTreeSet<String> {
    let entries = std::fs::read_dir(root().join(folder)).unwrap().map(|entry| entry.unwrap());
    entries
        .filter(|entry| entry.path().is_dir())
        .map(|entry| entry.file_name().display().to_string())
        .collect()
}

/// Rust and C below a folder.
pub fn sources(folder: &Path) -> Vec<String> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
        if entry.is_dir() {
            found.extend(sources(&entry));
        } else if entry.extension().is_some_and(|extension| extension == "rs" || extension == "c") {
            found.push(std::fs::read_to_string(entry).unwrap());
        }
    }
    found
}

/// The schema of a driver's settings.
pub fn settings(driver: &str) -> Option<Value> {
    let drivers = answer(&["drivers", "--json"]);
    let found = drivers["drivers"].as_array().unwrap().iter().find(|known| known["id"] == driver)?.clone();
    Some(found["settings_schema"].clone())
}

/// Every option of every command.
pub fn all_options() -> BTreeSet<String> {
    fn walk(command: &clap::Command, found: &mut BTreeSet<String>) {
        let long = command.get_arguments().filter_map(|argument| argument.get_long());
        found.extend(long.map(|name| format!("--{name}")));
        command.get_subcommands().for_each(|inner| walk(inner, found));
    }
    let mut root = wirebend_cli::command();
    root.build();
    let mut found = BTreeSet::new();
    walk(&root, &mut found);
    found
}

/// Every key that a schema of this repository, or the settings of a shipped driver, knows.
pub fn all_keys() -> BTreeSet<String> {
    fn walk(value: &Value, found: &mut BTreeSet<String>) {
        if let Some(properties) = value["properties"].as_object() {
            found.extend(properties.keys().cloned());
        }
        let inner = value.as_object().into_iter().flat_map(|map| map.values());
        inner.chain(value.as_array().into_iter().flatten()).for_each(|inner| walk(inner, found));
    }
    let mut found = BTreeSet::new();
    for folder in
        ["crates/api/schema", "crates/files/schema", "crates/driver-api/schema", "machine-profiles/schema"]
    {
        for name in files(folder) {
            walk(&json(&format!("{folder}/{name}")), &mut found);
        }
    }
    walk(&answer(&["drivers", "--json"]), &mut found);
    found
}
