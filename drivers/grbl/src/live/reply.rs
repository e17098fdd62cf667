//! What a line from the machine is. After grbl's `doc/markdown/interface.md`.

use super::status::Status;

/// A line from the machine.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Reply {
    /// The greeting, without the hint at its end.
    Greeting(String),
    /// A line was taken.
    Ok,
    /// A line was refused; no number where the controller writes words, as before version 1.1.
    Error(Option<u32>),
    /// Everything is halted or locked; no number where the controller writes words.
    Alarm(Option<u32>),
    /// Answer to `?`.
    Status(Status),
    /// `$N=value`.
    Setting {
        key: String,
        value: String,
    },
    /// `[…]`, without the brackets.
    Message(String),
    /// A line that the controller runs by itself when it starts.
    Startup,
    Unknown,
}

impl Reply {
    pub fn of(line: &str) -> Self {
        let line = line.trim();
        if line == "ok" {
            Self::Ok
        } else if let Some(code) = line.strip_prefix("error:") {
            Self::Error(code.trim().parse().ok())
        } else if let Some(code) = line.strip_prefix("ALARM:") {
            Self::Alarm(code.trim().parse().ok())
        } else if line.len() >= 4 && line.as_bytes()[..4].eq_ignore_ascii_case(b"grbl") {
            Self::Greeting(greeting(line))
        } else if let Some(report) = line.strip_prefix('<').and_then(|rest| rest.strip_suffix('>')) {
            Status::of(report).map_or(Self::Unknown, Self::Status)
        } else if let Some(text) = line.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
            Self::Message(text.to_owned())
        } else if line.starts_with('>') && line.contains(':') {
            Self::Startup
        } else {
            setting(line).unwrap_or(Self::Unknown)
        }
    }
}

/// `Grbl 1.1h ['$' for help]` without what is in the brackets, unless that says more than the hint.
fn greeting(line: &str) -> String {
    match line.split_once(" [") {
        Some((name, hint)) if hint.starts_with("'$'") => name.to_owned(),
        _ => line.to_owned(),
    }
}

fn setting(line: &str) -> Option<Reply> {
    let (key, value) = line.split_once('=')?;
    let number = key.strip_prefix('$')?;
    let known = !number.is_empty()
        && number.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'/' || byte == b'_');
    // Before version 1.1 a description follows in parentheses.
    let value = value.split(" (").next().unwrap_or(value);
    known.then(|| Reply::Setting { key: key.to_owned(), value: value.trim().to_owned() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_kind_of_line_is_told_apart() {
        assert_eq!(Reply::of("ok"), Reply::Ok);
        assert_eq!(Reply::of("error:20"), Reply::Error(Some(20)));
        assert_eq!(Reply::of("error: Bad number format"), Reply::Error(None));
        assert_eq!(Reply::of("ALARM:9"), Reply::Alarm(Some(9)));
        assert_eq!(Reply::of("ALARM: Hard limit"), Reply::Alarm(None));
        assert_eq!(Reply::of("Grbl 1.1h ['$' for help]"), Reply::Greeting("Grbl 1.1h".into()));
        let other = "Grbl 3.7 [FluidNC v3.7.8 (wifi) '$' for help]";
        assert_eq!(Reply::of(other), Reply::Greeting(other.into()));
        assert_eq!(
            Reply::of("GrblHAL 1.1f ['$' or '$HELP' for help]"),
            Reply::Greeting("GrblHAL 1.1f".into())
        );
        assert_eq!(Reply::of("[MSG:Check Door]"), Reply::Message("MSG:Check Door".into()));
        assert_eq!(Reply::of(">G54G20:ok"), Reply::Startup);
        let setting = |key: &str, value: &str| Reply::Setting { key: key.into(), value: value.into() };
        assert_eq!(Reply::of("$100=250.000"), setting("$100", "250.000"));
        assert_eq!(Reply::of("$N0=G54"), setting("$N0", "G54"));
        assert_eq!(Reply::of("$0=10 (step pulse, usec)"), setting("$0", "10"));
        for noise in ["o", "okok", "<Idle", "<Nonsense|MPos:1,2,3>", "$=1", "rst:0x1", "", "gr"] {
            assert_eq!(Reply::of(noise), Reply::Unknown, "{noise}");
        }
    }
}
