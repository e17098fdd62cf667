//! A driver's process and nothing else.

fn main() -> std::process::ExitCode {
    let arguments: Vec<_> =
        std::env::args_os().skip_while(|word| word != wirebend_driver_host::CHILD_COMMAND).skip(1).collect();
    wirebend_driver_host::child_main(&arguments)
}
