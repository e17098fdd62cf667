//! `cargo xtask`: the commands that keep the workspace tidy and its committed, generated files fresh.
//!
//! One folder a command: `tidy/` checks, `examples/` and `generate/` write files that are committed.

#![allow(
    clippy::print_stdout,
    clippy::print_stderr,
    reason = "a tool of the command line speaks to a person"
)]

mod committed;
mod examples;
mod generate;
mod tidy;

use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use clap::{Parser, Subcommand};

/// House-keeping of this workspace.
#[derive(Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask")]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Check the rules of the house that the compiler cannot check
    Tidy,
    /// Write the parametric example wireframes
    Examples(Freshness),
    /// Write the files that are derived from code: schemas, reference of the command line
    Generate(Freshness),
}

#[derive(clap::Args)]
struct Freshness {
    /// Write nothing; fail when a committed file is stale
    #[arg(long)]
    check: bool,
}

fn main() -> Result<()> {
    let root = workspace_root()?;
    match Arguments::parse().command {
        Command::Tidy => tidy::run(&root),
        Command::Examples(freshness) => {
            committed::settle(&root, &examples::files(), freshness.check, "cargo xtask examples")
        }
        Command::Generate(freshness) => {
            committed::settle(&root, &generate::files(&root)?, freshness.check, "cargo xtask generate")
        }
    }
}

/// The folder above this package, wherever the command is started.
fn workspace_root() -> Result<PathBuf> {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    let root = package.parent().context("the xtask package has no parent folder")?;
    Ok(root.to_path_buf())
}
