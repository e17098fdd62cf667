//! The words that the sketch reads, and what it prints when it has read one.

use std::fmt;

/// A command: one line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Command {
    /// Take commands from the port.
    Manual,
    /// Feed, mm; above zero.
    Feed(i32),
    /// Rotate, degrees; not zero.
    Rotate(i32),
    /// Bend, degrees; not zero.
    Bend(i32),
    /// Take no more commands.
    End,
}

impl fmt::Display for Command {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Manual => write!(f, "manual"),
            Self::Feed(mm) => write!(f, "f{mm}"),
            Self::Rotate(deg) => write!(f, "z{deg}"),
            Self::Bend(deg) => write!(f, "b{deg}"),
            Self::End => write!(f, "end"),
        }
    }
}

/// What the sketch prints before a motion, such as `Feed 38mm wire.`: the motion as it has read it. `None`
/// for any other line. The numbers of a damaged line can be anything.
pub(crate) fn echoed(line: &str) -> Option<Command> {
    let number = |word: &str| {
        let rest = line.strip_prefix(word)?;
        let end = rest.find(|c: char| c != '-' && !c.is_ascii_digit()).unwrap_or(rest.len());
        rest[..end].parse().ok()
    };
    let rotate = || number("Move Z-Axis ").map(Command::Rotate);
    number("Feed ").map(Command::Feed).or_else(rotate).or_else(|| number("Bend ").map(Command::Bend))
}

/// Whether a line is one that the sketch prints besides, such as `// MANUAL MODE //`, or nothing.
pub(crate) fn is_remark(line: &str) -> bool {
    line.is_empty() || (line.starts_with("//") && line.ends_with("//"))
}

/// Whether a line is that of another controller, whatever is under way: grbl's greeting and answers, or a sealed line of the
/// WireBend-kit's firmware, which ends with `*` and four hexadecimal digits.
pub(crate) fn is_of_another(line: &str) -> bool {
    let begins = |word: &str| line.get(..word.len()).is_some_and(|begin| begin.eq_ignore_ascii_case(word));
    let sealed = line
        .rsplit_once('*')
        .is_some_and(|(_, seal)| seal.len() == 4 && seal.bytes().all(|byte| byte.is_ascii_hexdigit()));
    sealed
        || line == "ok"
        || ["grbl", "error:", "alarm:", "[msg:", "<idle|", "<alarm|"].into_iter().any(begins)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The lines are those that the published sketch prints.
    #[test]
    fn an_echo_is_the_command_that_was_read() {
        assert_eq!(echoed("Feed 38mm wire."), Some(Command::Feed(38)));
        assert_eq!(echoed("Bend -45 degrees."), Some(Command::Bend(-45)));
        assert_eq!(echoed("Move Z-Axis 90 degrees."), Some(Command::Rotate(90)));
        assert_eq!(echoed("  // MANUAL MODE //"), None);
        assert_eq!(echoed("Feed mm wire."), None);
        assert_eq!(echoed("Bend 99999999999 degrees."), None);
    }

    #[test]
    fn other_controllers_are_known_by_what_they_say() {
        for line in
            ["Grbl 1.1h ['$' for help]", "error:9", "ok", "[MSG:'$H'|'$X' to unlock]", "o1,0,0,1*3F0A"]
        {
            assert!(is_of_another(line) && !is_remark(line), "{line}");
        }
        for line in ["", "// MANUAL MODE //", "Feed 38mm wire.", "ready", "2 * 1234567"] {
            assert!(!is_of_another(line), "{line}");
        }
        assert!(is_remark("// MANUAL MODE //") && is_remark("") && !is_remark("ready"));
    }
}
