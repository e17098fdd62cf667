//! The command that continues what this one could not end.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use wirebend_api::RunTarget;

/// The options of this command without which the next one would look elsewhere.
static SAID: OnceLock<Vec<String>> = OnceLock::new();

/// Keeps the options that say where profiles, drivers and journals are.
pub(crate) fn keep(profiles: &[PathBuf], drivers: &[PathBuf], runs: Option<&Path>) {
    let profiles = profiles.iter().map(|path| ("--profiles", path.as_path()));
    let drivers = drivers.iter().map(|path| ("--driver-path", path.as_path()));
    let all = profiles.chain(drivers).chain(runs.map(|path| ("--runs-folder", path)));
    let _ =
        SAID.set(all.flat_map(|(option, path)| [option.to_owned(), path.display().to_string()]).collect());
}

/// The command that resumes a wire.
pub(crate) fn resume(run: &RunTarget) -> String {
    command(run, SAID.get().map_or(&[], Vec::as_slice), "--resume")
}

/// The command that gives a wire up.
pub(crate) fn abandon(run: &RunTarget) -> String {
    // Nothing moves for it: the port does not matter.
    let run = RunTarget { port: None, ..run.clone() };
    command(&run, SAID.get().map_or(&[], Vec::as_slice), "--abandon")
}

fn command(run: &RunTarget, said: &[String], option: &str) -> String {
    let job = run.job.as_ref().map_or_else(|| "JOB".to_owned(), |job| quoted(&job.display().to_string()));
    let wire = run.wire.map(|wire| format!("--wire {}", wire + 1));
    let port = run.port.as_ref().map(|port| format!("--port {}", quoted(port)));
    let machine = run.machine.as_ref().map(|id| format!("--machine {}", quoted(id)));
    let material = run.material.as_ref().map(|id| format!("--material {}", quoted(id)));
    let said = said.iter().map(|word| quoted(word));
    let words = ["wirebend run".to_owned(), job].into_iter().chain(machine).chain(material);
    let words = words.chain(port).chain(wire).chain(said);
    words.chain([option.to_owned()]).collect::<Vec<_>>().join(" ")
}

/// A word for a shell.
pub(crate) fn quoted(word: &str) -> String {
    let plain = |c: char| c.is_ascii_alphanumeric() || "-_./:=+,@%".contains(c);
    if !word.is_empty() && word.chars().all(plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_command_looks_where_this_one_did() {
        let run = RunTarget {
            job: Some("my job.wbjob".into()),
            wire: Some(1),
            port: Some("/dev/ttyUSB0".to_owned()),
            machine: None,
            material: None,
        };
        let said = ["--runs-folder".to_owned(), "kept".to_owned()];
        let expected = "wirebend run 'my job.wbjob' --port /dev/ttyUSB0 --wire 2 --runs-folder kept --resume";
        assert_eq!(command(&run, &said, "--resume"), expected);
        let nowhere = RunTarget { job: None, wire: None, port: None, machine: None, material: None };
        let program =
            RunTarget { job: Some("u.txt".into()), machine: Some("kit".to_owned()), ..nowhere.clone() };
        assert_eq!(command(&program, &[], "--resume"), "wirebend run u.txt --machine kit --resume");
        assert_eq!(command(&nowhere, &[], "--abandon"), "wirebend run JOB --abandon");
    }
}
