//! What it was ordered to do, and those misdeeds that need no answer.

use std::fs::File;
use std::io::Write;
use std::mem::ManuallyDrop;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::OnceLock;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Conduct {
    /// As a driver should.
    Well,
    /// One of [`HOW`](crate::HOW), for the code that makes the answer.
    As(&'static str),
}

/// What it is to do now. Misdeeds that need no answer have been done when this returns, if it returns.
pub(crate) fn conduct(now: &str) -> Conduct {
    let Some((when, how)) = told() else { return Conduct::Well };
    if when != now || is_on_leash() {
        return Conduct::Well;
    }
    match how {
        "exit" => std::process::exit(3),
        "abort" => std::process::abort(),
        // SAFETY: none. That is the point.
        "segfault" => unsafe { (8 as *mut u8).write_volatile(1) },
        "hang" => loop {
            std::thread::park();
        },
        "spin" => loop {
            std::hint::spin_loop();
        },
        "garbage" => each_descriptor(|file| drop(file.write_all(b"this is no frame\n"))),
        // The head of a frame of two thousand million bytes.
        "torrent" => each_descriptor(|file| drop(file.write_all(&[255, 255, 255, 127, 1, 0, 0, 0, 16]))),
        "deaf" => (3..32).for_each(close),
        "leak" => leak(),
        "orphan" => orphan(),
        "shout" => shout(),
        _ => {}
    }
    Conduct::As(how)
}

/// Whether it is to do something now that is no misdeed of the boundary.
pub(crate) fn is_told(when: &str, how: &str) -> bool {
    told() == Some((when, how)) && !is_on_leash()
}

/// Whether it has to behave for now.
fn is_on_leash() -> bool {
    static LEASH: OnceLock<Option<PathBuf>> = OnceLock::new();
    LEASH.get_or_init(|| beside("leash")).as_ref().is_some_and(|leash| leash.exists())
}

/// The file with its name and another extension.
pub(crate) fn beside(extension: &str) -> Option<PathBuf> {
    let mut words = std::env::args().map(PathBuf::from);
    let library = words.find(|word| word.extension().is_some_and(|e| e == "so"))?;
    Some(library.with_extension(extension))
}

/// When and how to misbehave: the process has the library's path among its arguments.
fn told() -> Option<(&'static str, &'static str)> {
    static TOLD: OnceLock<Option<(&str, &str)>> = OnceLock::new();
    *TOLD.get_or_init(|| {
        let words: Vec<String> = std::env::args().collect();
        let known = |list: &[&'static str], word: &str| list.iter().find(|known| **known == word).copied();
        words.iter().find_map(|word| {
            let (when, how) = Path::new(word).file_stem()?.to_str()?.rsplit_once('-')?;
            Some((known(&crate::WHEN, when)?, known(&crate::HOW, how)?))
        })
    })
}

/// Descriptors that the driver was never given.
fn each_descriptor(mut misuse: impl FnMut(&mut File)) {
    for number in 3..32 {
        // SAFETY: none: the descriptor may belong to any other code, or to none.
        let mut file = ManuallyDrop::new(unsafe { <File as std::os::fd::FromRawFd>::from_raw_fd(number) });
        misuse(&mut file);
    }
}

/// Closes a descriptor that other code uses. Rust refuses to close what it did not open, C does not.
fn close(number: i32) {
    unsafe extern "C" {
        safe fn close(number: i32) -> i32;
    }
    let _ = close(number);
}

/// Takes memory and never gives it back, until there is none.
fn leak() {
    for _ in 0..4096 {
        std::hint::black_box(Box::leak(vec![7_u8; 16 << 20].into_boxed_slice()));
    }
}

/// Leaves a process behind that holds on to whatever it can.
fn orphan() {
    let _ = Command::new("sleep").arg("86419").stdin(Stdio::inherit()).spawn();
    std::process::exit(0);
}

/// Prints more than a pipe holds where a driver may print.
fn shout() {
    let (out, err) = (std::io::stdout(), std::io::stderr());
    for _ in 0..100 {
        let _ = writeln!(out.lock(), "{}", "out ".repeat(250));
        let _ = writeln!(err.lock(), "{}", "err ".repeat(250));
    }
}
