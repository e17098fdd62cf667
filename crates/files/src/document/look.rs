//! How a part of a design looks in a list and in the view.

use std::fmt;
use std::str::FromStr;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What it is called, its colour, and whether it is hidden. None of it changes what is bent.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Look {
    /// Empty where nobody has named it.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub name: String,
    /// Absent for the usual one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub colour: Option<Colour>,
    /// Whether it is left out of the view.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub hidden: bool,
}

impl Look {
    /// The same with a name on one line, without spaces around it.
    #[must_use]
    pub fn with_tidy_name(self) -> Self {
        let words: Vec<&str> = self.name.split_whitespace().collect();
        Self { name: words.join(" "), ..self }
    }
}

/// Red, green and blue as the screen takes them: "#7f93ab".
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(try_from = "String", into = "String")]
pub struct Colour(#[schemars(with = "String", regex(pattern = "^#[0-9a-f]{6}$"))] [u8; 3]);

/// A text is no colour.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("\"{0}\" is no colour: one is written as # and six hexadecimal digits, such as #7f93ab")]
pub struct NoColour(String);

impl FromStr for Colour {
    type Err = NoColour;

    fn from_str(text: &str) -> Result<Self, NoColour> {
        let digits = text.strip_prefix('#').filter(|digits| digits.len() == 6);
        // `from_str_radix` takes a sign.
        let digits = digits.filter(|digits| digits.bytes().all(|byte| byte.is_ascii_hexdigit()));
        let number = digits.and_then(|digits| u32::from_str_radix(digits, 16).ok());
        let [_, r, g, b] = number.ok_or_else(|| NoColour(text.to_owned()))?.to_be_bytes();
        Ok(Self([r, g, b]))
    }
}

impl TryFrom<String> for Colour {
    type Error = NoColour;

    fn try_from(text: String) -> Result<Self, NoColour> {
        text.parse()
    }
}

impl From<Colour> for String {
    fn from(colour: Colour) -> Self {
        colour.to_string()
    }
}

impl fmt::Display for Colour {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [r, g, b] = self.0;
        write!(out, "#{r:02x}{g:02x}{b:02x}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_colour_is_six_hexadecimal_digits() {
        assert_eq!("#7F93ab".parse::<Colour>().unwrap().to_string(), "#7f93ab");
        for wrong in ["", "#", "7f93ab", "#7f93a", "#7f93abc", "#+f93ab", "#ü93ab", "red", "#7f93g0"] {
            let refused = wrong.parse::<Colour>().unwrap_err();
            assert!(refused.to_string().contains("six hexadecimal digits"), "{wrong}");
        }
    }

    #[test]
    fn a_name_is_one_line() {
        let look = Look { name: " left \n arm ".to_owned(), ..Look::default() };
        assert_eq!(look.with_tidy_name().name, "left arm");
    }
}
