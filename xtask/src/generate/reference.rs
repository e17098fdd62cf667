//! The reference of the command line: the help of every command, in one file.

use std::fmt::Write;

use clap::Command;

use crate::committed::CommittedFile;

pub(super) fn file() -> CommittedFile {
    let mut text = "# `wirebend`\n\nMade by `cargo xtask generate` from the command's own help.\n".to_owned();
    let mut root = wirebend_cli::command().term_width(100);
    root.build();
    section(&mut text, &mut root, "wirebend");
    CommittedFile { path: "crates/cli/REFERENCE.md".into(), text }
}

fn section(text: &mut String, command: &mut Command, name: &str) {
    let help = command.render_long_help().to_string();
    let help: Vec<&str> = help.trim().lines().map(str::trim_end).collect();
    // Writing to a string does not fail.
    let _ = write!(text, "\n## `{name}`\n\n```text\n{}\n```\n", help.join("\n"));
    let inner: Vec<String> = command.get_subcommands().map(|sub| sub.get_name().to_owned()).collect();
    for sub in inner.into_iter().filter(|sub| sub != "help") {
        if let Some(command) = command.find_subcommand_mut(&sub) {
            section(text, command, &format!("{name} {sub}"));
        }
    }
}
