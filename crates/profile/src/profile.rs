//! What all kinds of profile have in common.

use schemars::JsonSchema;
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::Kind;

/// Declares a group of keys of a profile: every field is optional, because a file sets only what
/// it changes; unknown keys are refused.
macro_rules! layer {
    ($(#[$of:meta])* pub struct $name:ident { $($(#[$at:meta])* pub $field:ident: $type:ty,)+ }) => {
        $(#[$of])*
        #[derive(
            Clone, Debug, Default, PartialEq,
            serde::Serialize, serde::Deserialize, schemars::JsonSchema,
        )]
        #[serde(deny_unknown_fields)]
        pub struct $name {
            $(
                $(#[$at])*
                #[serde(default, skip_serializing_if = "Option::is_none")]
                pub $field: Option<$type>,
            )+
        }
    };
}
pub(crate) use layer;

/// Whether a group sets nothing, so that it is left out when written.
pub(crate) fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

/// A profile of one kind, either one file's layer or the merged whole.
pub trait Profile: DeserializeOwned + Serialize + JsonSchema {
    /// Which kind this is.
    const KIND: Kind;
    /// Dotted keys whose objects a child replaces whole instead of key by key.
    const WHOLE: &'static [&'static str];

    /// The slug; equals the file's stem.
    fn id(&self) -> &str;
    /// Id of the parent.
    fn inherits(&self) -> Option<&str>;
    /// Whether this only serves to be inherited from.
    fn is_abstract(&self) -> bool;
    /// Dotted keys that a complete profile must have, with how to set each.
    fn required(&self) -> Vec<(&'static str, &'static str)>;
    /// What contradicts itself or physics. Values that are not set are passed over.
    fn faults(&self) -> Vec<Fault>;
    /// Ids of other profiles that this one names: dotted key, kind, id.
    fn references(&self) -> Vec<(&'static str, Kind, &str)> {
        Vec::new()
    }
}

/// A value that breaks a rule, before it is known which file set it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// Dotted key of the value to change.
    pub key: String,
    /// The value as found.
    pub found: String,
    /// What the rule asks for.
    pub expected: String,
    /// Dotted key of the value that this one contradicts, if that is what is wrong.
    pub against: Option<String>,
}

impl Fault {
    #[expect(clippy::needless_pass_by_value, reason = "a rule passes its number or text as it is")]
    pub(crate) fn new(key: &str, found: impl ToString, expected: impl Into<String>) -> Self {
        let (found, expected) = (found.to_string(), expected.into());
        Self { key: key.into(), found, expected, against: None }
    }

    pub(crate) fn against(self, key: &str) -> Self {
        Self { against: Some(key.into()), ..self }
    }
}

/// The text of a profile file: pretty JSON in the order of the documentation, unset keys left
/// out, one newline at the end.
///
/// # Errors
/// A value that JSON cannot say; does not occur for profiles that were read.
pub fn to_text<T: Profile>(profile: &T) -> Result<String, serde_json::Error> {
    let mut text = serde_json::to_string_pretty(profile)?;
    text.push('\n');
    Ok(text)
}
