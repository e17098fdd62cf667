//! A line that a person has typed for a machine.

use std::fmt;

use crate::DriverError;

/// The longest line, bytes. No firmware of benders takes one so long; a driver refuses what is too long for its own.
pub const LONGEST_CONSOLE_LINE: usize = 256;

/// A line that can be passed on: not empty, not too long, one line, and without control characters. Whether the machine's protocol
/// has its characters the driver says.
///
/// ```
/// use wirebend_driver_api::ConsoleLine;
/// assert_eq!(ConsoleLine::new(" $$ \n").unwrap().as_str(), "$$");
/// assert_eq!(ConsoleLine::new("$$\u{18}").unwrap_err().code, "console-line");
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ConsoleLine(String);

impl ConsoleLine {
    /// Takes what was typed; blanks and line ends around it are left out.
    ///
    /// # Errors
    /// [`DriverError`] with the code `console-line`.
    pub fn new(typed: &str) -> Result<Self, DriverError> {
        let refused = |what: String, help| Err(DriverError::new("console-line", what, help));
        let line = typed.trim_matches([' ', '\t', '\r', '\n']);
        if line.is_empty() {
            return refused("the line is empty".to_owned(), "type a command");
        }
        if line.len() > LONGEST_CONSOLE_LINE {
            let what =
                format!("the line has {} bytes; at most {LONGEST_CONSOLE_LINE} are possible", line.len());
            return refused(what, "type a shorter one");
        }
        if let Some((at, control)) = line.chars().enumerate().find(|(_, one)| one.is_control()) {
            let what = format!(
                "character {} of the line is the control character {}, which is not passed on",
                at + 1,
                control.escape_unicode()
            );
            return refused(what, "type one line of text; to stop the machine use STOP");
        }
        Ok(Self(line.to_owned()))
    }

    /// The line as it was typed, without blanks around it.
    #[must_use]
    pub fn as_str(&self) -> &str {
        &self.0
    }

    /// The line, if it is printable ASCII of at most so many bytes.
    ///
    /// # Errors
    /// [`DriverError`] with the code `console-line`.
    pub fn ascii(&self, most: usize) -> Result<&str, DriverError> {
        let refused = |what: String, help| Err(DriverError::new("console-line", what, help));
        if let Some((at, other)) = self.0.chars().enumerate().find(|(_, one)| !one.is_ascii()) {
            let what =
                format!("character {} of the line is '{other}'; the machine reads ASCII alone", at + 1);
            return refused(what, "use letters without accents, digits and signs");
        }
        if self.0.len() > most {
            let what = format!("the line has {} characters; the machine takes at most {most}", self.0.len());
            return refused(what, "type a shorter one");
        }
        Ok(&self.0)
    }
}

impl fmt::Display for ConsoleLine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn said(typed: &str) -> String {
        ConsoleLine::new(typed).and_then(|line| line.ascii(79).map(drop)).unwrap_err().message
    }

    /// A control character would be a real-time command of some firmware, and a second line one that nobody has looked at.
    #[test]
    fn what_is_no_line_of_text_is_refused_and_named() {
        for (typed, what) in [
            ("", "empty"),
            (" \t\r\n", "empty"),
            ("$$\nG1 X9 F9", "character 3"),
            ("G1\u{18}", "\\u{18}"),
            ("G1 X1\u{85}", "\\u{85}"),
            ("G1 Ä", "'Ä'"),
            (&"x".repeat(80), "80 characters"),
            (&"x".repeat(257), "257 bytes"),
        ] {
            assert!(said(typed).contains(what), "{typed:?}: {}", said(typed));
        }
    }

    #[test]
    fn what_fits_is_passed_on_as_it_is() {
        let line = ConsoleLine::new("  G1 X1 F100 (slowly)\r\n").unwrap();
        assert_eq!(line.ascii(79).unwrap(), "G1 X1 F100 (slowly)");
        assert!(ConsoleLine::new(&"x".repeat(79)).unwrap().ascii(79).is_ok());
    }
}
