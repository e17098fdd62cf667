//! What a person can set.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use wirebend_driver_api::DriverError;

/// The most digits behind the decimal point.
const MAX_DECIMALS: u8 = 9;

/// How scripts are written. The comments below are shown in a form.
#[derive(Debug, Clone, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Settings {
    /// How the commands are spelled: FEED, feed or Feed.
    pub case: Case,
    /// File name extension of scripts. Any other than dsw is said in a note with every script, since it is the program that names the file.
    pub extension: Extension,
    /// How the first line, with the hash of the design, is marked as a comment; none leaves it out.
    pub comments: Comments,
    /// Digits behind the decimal point of feeds (mm), rotations and bends (degrees), 0 to 9.
    #[schemars(range(min = 0, max = 9))]
    pub decimals: u8,
    /// Whether the pin is retracted (PINZ -5) after each bend and put up (PINZ 0) before the next, so that the wire is fed and turned without it. Published programs do this for rotations above 90 degrees only.
    pub pin_between: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            case: Case::default(),
            extension: Extension::default(),
            comments: Comments::default(),
            decimals: 5,
            pin_between: false,
        }
    }
}

/// How commands are spelled.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Case {
    /// FEED
    #[default]
    Upper,
    /// feed
    Lower,
    /// Feed
    Title,
}

/// A file name extension.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Extension {
    /// .dsw
    #[default]
    Dsw,
    /// .txt
    Txt,
    /// .diw
    Diw,
}

/// How comments are marked.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Comments {
    /// (comment)
    #[default]
    Parentheses,
    /// No comments.
    None,
}

impl Settings {
    pub(crate) fn check(&self) -> Result<(), DriverError> {
        if self.decimals > MAX_DECIMALS {
            let message = format!("'decimals' is {}; it can be 0 to {MAX_DECIMALS}", self.decimals);
            return Err(DriverError::new("settings", message, "set it to 5, as published programs have"));
        }
        Ok(())
    }
}

impl Case {
    /// A command, which is given in capitals.
    pub(crate) fn spell(self, command: &str) -> String {
        match self {
            Self::Upper => command.to_owned(),
            Self::Lower => command.to_lowercase(),
            Self::Title => {
                let (first, rest) = command.split_at(1);
                format!("{first}{}", rest.to_lowercase())
            }
        }
    }
}

impl Extension {
    pub(crate) const ALL: [Self; 3] = [Self::Dsw, Self::Txt, Self::Diw];

    pub(crate) const fn word(self) -> &'static str {
        match self {
            Self::Dsw => "dsw",
            Self::Txt => "txt",
            Self::Diw => "diw",
        }
    }
}
