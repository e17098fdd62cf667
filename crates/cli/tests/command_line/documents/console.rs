//! Blocks of `console`: run in a shell as a person would, in a folder that has the files of this repository.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::documents::markdown::{Block, Document};
use crate::documents::{assert_none, documents, root};

/// Separates a command's output from its exit status in what the shell prints; no command prints it.
const MARK: char = '\u{1e}';

/// A command of a document and what the document shows of it.
struct Shown<'a> {
    block: &'a Block,
    /// Index of its line in the block.
    at: usize,
    command: &'a str,
    output: &'a [String],
}

/// What it really did.
struct Ran {
    output: Vec<String>,
    status: i32,
}

/// The home of a user who has just cloned the repository.
struct Home(tempfile::TempDir);

/// Folders of the repository that commands in documents use.
const CLONED: [&str; 4] = ["crates/driver-api", "drivers", "examples", "machine-profiles"];

/// Copies: what a document writes there must not reach the repository.
fn copy(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).unwrap();
    for entry in std::fs::read_dir(from).unwrap().map(|entry| entry.unwrap()) {
        let to = to.join(entry.file_name());
        if entry.path().is_dir() {
            copy(&entry.path(), &to);
        } else {
            std::fs::copy(entry.path(), to).unwrap();
        }
    }
}

impl Home {
    fn new() -> Self {
        let home = Self(tempfile::tempdir().unwrap());
        for folder in CLONED {
            copy(&root().join(folder), &home.clone_folder().join(folder));
        }
        home
    }

    /// Absolute and without links, as programs print it.
    fn path(&self) -> PathBuf {
        self.0.path().canonicalize().unwrap()
    }

    fn clone_folder(&self) -> PathBuf {
        self.path().join("wirebend-kit")
    }

    /// Runs a script and gives what it prints, on both streams in the order of writing.
    fn shell(&self, script: &str) -> String {
        let file = self.path().join(".script");
        std::fs::write(&file, format!("exec 2>&1\n{script}")).unwrap();
        let beside = program_folder().display().to_string();
        let path = std::env::var("PATH").unwrap_or_default();
        let mut shell = Command::new("sh");
        shell.arg(&file).current_dir(self.clone_folder()).env("HOME", self.path());
        shell.env("PATH", format!("{beside}:{path}")).env("LC_ALL", "C.UTF-8");
        shell.env_remove("XDG_CONFIG_HOME").env_remove("XDG_DATA_HOME").env_remove("COLUMNS");
        let done = shell.stdin(Stdio::null()).stderr(Stdio::inherit()).output().unwrap();
        String::from_utf8(done.stdout).unwrap().replace(&self.path().display().to_string(), "~")
    }
}

/// The folder of the program, where its drivers lie beside it.
pub fn program_folder() -> PathBuf {
    let program = wirebend_tests_built::wirebend();
    for driver in ["pensa", "tables", "grbl", "howtomechatronics", "wirebend-kit"] {
        assert_eq!(wirebend_tests_built::driver(driver).parent(), program.parent());
    }
    program.parent().unwrap().to_owned()
}

/// The commands of a document with the files that are written between them, as one script.
fn script(document: &Document) -> (Vec<Shown<'_>>, String) {
    let (mut shown, mut script) = (Vec::new(), String::new());
    for block in &document.blocks {
        match &block.name {
            Some(file) if file.contains('.') => {
                let folder = Path::new(file).parent().unwrap().display().to_string();
                let folder = if folder.is_empty() { "." } else { &folder };
                let text = block.lines.join("\n");
                writeln!(script, "mkdir -p {folder}\ncat > {file} <<'END OF FILE'\n{text}\nEND OF FILE")
                    .unwrap();
            }
            _ if block.language == "console" => {
                let starts: Vec<usize> =
                    (0..block.lines.len()).filter(|&k| block.lines[k].starts_with("$ ")).collect();
                assert!(
                    starts.first() == Some(&0),
                    "{}: a block of console begins with '$ '",
                    document.at(block.line)
                );
                for (k, &at) in starts.iter().enumerate() {
                    let end = starts.get(k + 1).copied().unwrap_or(block.lines.len());
                    let command = &block.lines[at][2..];
                    shown.push(Shown { block, at, command, output: &block.lines[at + 1..end] });
                    // The status is handed on, so that `echo $?` shows it.
                    writeln!(script, "{command}\ns=$?; printf '{MARK}%s{MARK}\\n' $s; (exit $s)").unwrap();
                }
            }
            _ => {}
        }
    }
    (shown, script)
}

fn run(script: &str) -> Vec<Ran> {
    let printed = Home::new().shell(script);
    let mut parts = printed.split(MARK);
    let mut ran = Vec::new();
    while let (Some(output), Some(status)) = (parts.next(), parts.next()) {
        let output = output.strip_prefix('\n').filter(|_| !ran.is_empty()).unwrap_or(output);
        let lines = output.lines().map(|line| line.trim_end().to_owned()).collect();
        ran.push(Ran { output: lines, status: status.parse().unwrap() });
    }
    ran
}

/// Whether a line that is shown is the line that was printed: `…` stands for any text.
fn is_line(shown: &str, printed: &str) -> bool {
    let mut parts = shown.split('…');
    let Some(mut rest) = printed.strip_prefix(parts.next().unwrap_or_default()) else { return false };
    let Some(last) = parts.next_back() else { return rest.is_empty() };
    for part in parts {
        let Some(at) = rest.find(part) else { return false };
        rest = &rest[at + part.len()..];
    }
    rest.ends_with(last)
}

fn is_output(shown: &[String], printed: &[String]) -> bool {
    shown.len() == printed.len() && shown.iter().zip(printed).all(|(shown, printed)| is_line(shown, printed))
}

/// Writes what was printed in the place of what was shown; lines that still fit stay as they were.
fn update(document: &Document, corrected: &BTreeMap<(usize, usize), Vec<String>>) {
    let mut lines = document.lines.clone();
    // From the end, so that the numbers of the lines before stay.
    for (&(from, to), printed) in corrected.iter().rev() {
        lines.splice(from..to, printed.iter().cloned());
    }
    std::fs::write(&document.path, lines.join("\n") + "\n").unwrap();
}

fn check(document: &Document, wrong: &mut Vec<String>) {
    let (commands, script) = script(document);
    if commands.is_empty() {
        return;
    }
    let ran = run(&script);
    assert_eq!(ran.len(), commands.len(), "{}: the shell ended before its last command", document.name());
    let mut corrected = BTreeMap::new();
    for (k, (shown, ran)) in commands.iter().zip(&ran).enumerate() {
        let first = shown.block.within.start + shown.at;
        let at = document.at(first + 1);
        let status_is_shown = commands.get(k + 1).is_some_and(|next| next.command == "echo $?");
        if ran.status != 0 && !status_is_shown {
            wrong.push(format!(
                "{at}: `{}` ends with status {}: show it by `echo $?`",
                shown.command, ran.status
            ));
        }
        if !is_output(shown.output, &ran.output) {
            wrong.push(format!("{at}: `{}` prints\n{}\n", shown.command, ran.output.join("\n")));
            let margin = " ".repeat(shown.block.indent);
            let kept =
                |line: &String| shown.output.iter().find(|old| is_line(old, line)).unwrap_or(line).clone();
            let lines = ran.output.iter().map(|line| format!("{margin}{}", kept(line)).trim_end().to_owned());
            corrected.insert((first + 1, first + 1 + shown.output.len()), lines.collect());
        }
    }
    if std::env::var_os("UPDATE_EXPECT").is_some() {
        update(document, &corrected);
    }
}

#[test]
fn every_command_prints_what_its_document_shows() {
    let mut wrong = Vec::new();
    for document in documents() {
        check(&document, &mut wrong);
    }
    assert_none(&wrong);
}

#[test]
fn a_line_with_an_ellipsis_stands_for_many_and_another_for_itself() {
    assert!(is_line("wrote …/a.json", "wrote ~/x/a.json") && is_line("a … c … e", "a b c d e"));
    assert!(
        is_line("the head ends -0.9°", "the head ends -0.9°") && is_line("… and 5 more", "  … and 5 more")
    );
    for (shown, printed) in
        [("wrote a", "wrote ab"), ("wrote ab", "wrote a"), ("a … c", "a b"), ("…x", "y"), ("", "x")]
    {
        assert!(!is_line(shown, printed), "{shown} is not {printed}");
    }
}

#[test]
fn the_output_and_the_status_of_each_command_are_told_apart() {
    let script = |commands: &[&str]| {
        let lines = commands.iter().map(|c| format!("{c}\ns=$?; printf '{MARK}%s{MARK}\\n' $s; (exit $s)\n"));
        lines.collect::<String>()
    };
    let ran = run(&script(&["echo one; echo two >&2", "false", "echo $?", "printf no-newline", "cd", "pwd"]));
    let told: Vec<(String, i32)> = ran.iter().map(|ran| (ran.output.join(" "), ran.status)).collect();
    let expected = [("one two", 0), ("", 1), ("1", 0), ("no-newline", 0), ("", 0), ("~", 0)];
    assert_eq!(told, expected.map(|(output, status)| (output.to_owned(), status)));
}
