//! `wirebend`: see `wirebend --help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    wirebend_cli::main()
}
