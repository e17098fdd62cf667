//! The C header says what the Rust types say: a C compiler decides.

use std::ffi::{c_char, c_void};
use std::fmt::Write as _;
use std::mem::{align_of, offset_of, size_of};
use std::path::{Path, PathBuf};
use std::process::Command;

use wirebend_driver_api::{ABI_MAJOR, ABI_MINOR, Buffer, Bytes, ENTRY_SYMBOL, Entry, OK, REFUSED, Table};

/// What C calls a type.
trait InC {
    fn in_c() -> String;
}

macro_rules! in_c {
    ($($rust:ty => $c:literal),* $(,)?) => { $(impl InC for $rust { fn in_c() -> String { $c.to_owned() } })* };
}

in_c! {
    () => "void", i32 => "int32_t", u32 => "uint32_t", usize => "size_t",
    *const u8 => "const uint8_t *", *mut u8 => "uint8_t *",
    *const c_char => "const char *", *const c_void => "const void *",
    *mut c_void => "void *", *mut *mut c_void => "void **",
    Bytes => "wirebend_bytes", Buffer => "wirebend_buffer", *mut Buffer => "wirebend_buffer *",
    *const Table => "const wirebend_driver *",
}

impl<T: InC> InC for Option<T> {
    fn in_c() -> String {
        T::in_c()
    }
}

macro_rules! function_in_c {
    ($(($($argument:ident),*)),*) => { $(
        impl<$($argument: InC,)* R: InC> InC for unsafe extern "C" fn($($argument),*) -> R {
            fn in_c() -> String {
                let arguments: Vec<String> = vec![$($argument::in_c()),*];
                let arguments = if arguments.is_empty() { "void".to_owned() } else { arguments.join(", ") };
                format!("{} (*)({arguments})", R::in_c())
            }
        }
    )* };
}

function_in_c!((), (A), (A, B), (A, B, C));

fn type_of<S, T: InC>(_: impl Fn(&S) -> T) -> String {
    T::in_c()
}

macro_rules! claims {
    ($text:ident, $rust:ident as $c:literal { $($field:ident),* }) => {
        writeln!($text, "_Static_assert(sizeof({}) == {}, \"size\");", $c, size_of::<$rust>()).unwrap();
        writeln!($text, "_Static_assert(_Alignof({}) == {}, \"alignment\");", $c, align_of::<$rust>()).unwrap();
        $(
            let (place, field) = (offset_of!($rust, $field), stringify!($field));
            let in_c = type_of(|value: &$rust| value.$field);
            writeln!($text, "_Static_assert(offsetof({}, {field}) == {place}, \"offset of {field}\");", $c).unwrap();
            writeln!(
                $text,
                "_Static_assert(__builtin_types_compatible_p(__typeof__((({} *)0)->{field}), {in_c}), \"type of {field}\");",
                $c
            )
            .unwrap();
        )*
        // Patterns without `..`: a field that is added to the Rust type does not compile until it is here.
        let _ = |value: $rust| { let $rust { $($field: _),* } = value; };
    };
}

/// What must hold in C, as the Rust types have it.
fn claims() -> String {
    let mut text = "#include \"wirebend_driver.h\"\n".to_owned();
    for (name, value) in [("WIREBEND_ABI_MAJOR", ABI_MAJOR), ("WIREBEND_ABI_MINOR", ABI_MINOR)] {
        writeln!(text, "_Static_assert({name} == {value}u, \"{name}\");").unwrap();
    }
    for (name, value) in [("WIREBEND_OK", OK), ("WIREBEND_REFUSED", REFUSED)] {
        writeln!(text, "_Static_assert({name} == {value}, \"{name}\");").unwrap();
    }
    claims!(text, Bytes as "wirebend_bytes" { data, len });
    claims!(text, Buffer as "wirebend_buffer" { data, len });
    claims!(text, Table as "wirebend_driver" {
        abi_major, abi_minor, describe, open, call, poll, close, free, extension
    });
    let entry = <Entry as InC>::in_c();
    let claim = format!("__builtin_types_compatible_p(__typeof__(&{ENTRY_SYMBOL}), {entry})");
    writeln!(text, "_Static_assert({claim}, \"entry\");").unwrap();
    text
}

fn include() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("include")
}

/// Compiles a text as C or C++ and gives what the compiler has to say against it.
fn compile(compiler: &str, standard: &str, file: &str, text: &str) -> Result<(), String> {
    let folder = tempfile::tempdir().unwrap();
    let source = folder.path().join(file);
    std::fs::write(&source, text).unwrap();
    let done = Command::new(compiler)
        .args([standard, "-Wall", "-Wextra", "-Wpedantic", "-Werror", "-fsyntax-only", "-I"])
        .arg(include())
        .arg(&source)
        .output()
        .unwrap_or_else(|error| {
            panic!("{compiler}: {error}; to install it: apt-get install -y build-essential")
        });
    if done.status.success() { Ok(()) } else { Err(String::from_utf8(done.stderr).unwrap()) }
}

/// Were they different, a C driver would be called with the wrong arguments.
#[test]
fn the_header_and_the_types_are_the_same() {
    let text = claims();
    assert!(text.lines().count() > 25, "{text}");
    compile("cc", "-std=gnu11", "claims.c", &text).unwrap();
}

/// The comparison itself can fail.
#[test]
fn a_difference_is_found() {
    for (of_rust, other) in [
        ("int32_t (*)(void *, wirebend_bytes,", "int64_t (*)(void *, wirebend_bytes,"),
        ("_MAJOR == 1u", "_MAJOR == 2u"),
    ] {
        let text = claims();
        assert!(text.contains(of_rust), "{text}");
        compile("cc", "-std=gnu11", "claims.c", &text.replace(of_rust, other)).unwrap_err();
    }
}

/// Drivers are written in C++ too.
#[test]
fn the_header_is_strict_c_and_cpp() {
    let text = "#include \"wirebend_driver.h\"\nint main(void) { return WIREBEND_OK; }\n";
    compile("cc", "-std=c99", "plain.c", text).unwrap();
    compile(
        "c++",
        "-std=c++11",
        "plain.cpp",
        "#include \"wirebend_driver.h\"\nint main() { return WIREBEND_OK; }\n",
    )
    .unwrap();
}

/// An author of a C driver reads the deadlines there.
#[test]
fn the_header_tells_the_deadlines() {
    use wirebend_driver_api::deadline;
    let header = std::fs::read_to_string(include().join("wirebend_driver.h")).unwrap();
    let words: String = header.split_whitespace().collect::<Vec<_>>().join(" ");
    let expected = [
        ("from the start of the process", deadline::START, "s"),
        ("* open", deadline::OPEN, "s"),
        ("call \"encode\"", deadline::ENCODE, "s"),
        ("call \"stop\"", deadline::STOP, "ms"),
        ("any other call", deadline::CALL, "s"),
        ("poll", deadline::POLL, "s"),
        ("close", deadline::CLOSE, "ms"),
    ];
    for (name, duration, unit) in expected {
        let value = if unit == "s" { u128::from(duration.as_secs()) } else { duration.as_millis() };
        assert!(words.contains(&format!("{name} {value} {unit}")), "{name}: {value} {unit}");
    }
}
