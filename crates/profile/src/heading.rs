//! The heading that every profile file begins with, in one place for all kinds.

/// Keys that speak of one file and are never taken from a parent: all of the heading but its texts for people.
pub(crate) const OWN: [&str; 6] = ["$schema", "schema_version", "kind", "id", "inherits", "abstract"];

/// Declares the profile of a kind: the heading, the values of the kind, and its publications. Every value has a default,
/// because a file sets only what it changes; unknown keys are refused. The word of the kind is that of `Kind::word`.
macro_rules! profile {
    (
        $(#[$of:meta])*
        pub struct $name:ident: $tag:ident::$variant:ident, $word:literal {
            $(#[$description:meta])*
            description;
            $($(#[$at:meta])* pub $field:ident: $type:ty,)+
        }
    ) => {
        #[doc = concat!("The `kind` of a ", $word, " profile.")]
        #[derive(
            Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize, schemars::JsonSchema,
        )]
        #[serde(rename_all = "kebab-case")]
        pub enum $tag {
            /// The only word.
            $variant,
        }

        $(#[$of])*
        #[derive(Clone, Debug, PartialEq, serde::Serialize, serde::Deserialize, schemars::JsonSchema)]
        #[serde(deny_unknown_fields)]
        pub struct $name {
            /// Address or path of the JSON Schema, for editors. Not read by the program.
            #[serde(rename = "$schema", default, skip_serializing_if = "Option::is_none")]
            pub schema: Option<String>,
            /// Version of this format.
            #[schemars(range(min = 1, max = 1))]
            pub schema_version: u32,
            #[doc = concat!("Says that this is a ", $word, " profile.")]
            pub kind: $tag,
            /// Slug of lower-case letters, digits and hyphens; equals the file's name without `.json`.
            #[schemars(regex(pattern = r"^[a-z0-9]+(-[a-z0-9]+)*$"))]
            pub id: String,
            #[doc = concat!("Id of the ", $word, " profile that gives every value not set here.")]
            #[serde(default, skip_serializing_if = "Option::is_none")]
            pub inherits: Option<String>,
            /// True for a base that only serves to be inherited from and may leave values open.
            #[serde(rename = "abstract", default, skip_serializing_if = "crate::profile::is_default")]
            pub is_abstract: bool,
            /// Name for people.
            #[serde(default, skip_serializing_if = "Option::is_none")]
            pub name: Option<String>,
            $(#[$description])*
            #[serde(default, skip_serializing_if = "Option::is_none")]
            pub description: Option<String>,
            $(
                $(#[$at])*
                #[serde(default, skip_serializing_if = "crate::profile::is_default")]
                pub $field: $type,
            )+
            /// Publications that the `source` texts name.
            #[serde(default, skip_serializing_if = "Option::is_none")]
            pub sources: Option<Vec<crate::sourced::Reference>>,
        }
    };
}
pub(crate) use profile;

/// Gives a profile the accessors of its heading.
macro_rules! heading {
    () => {
        fn id(&self) -> &str {
            &self.id
        }
        fn inherits(&self) -> Option<&str> {
            self.inherits.as_deref()
        }
        fn is_abstract(&self) -> bool {
            self.is_abstract
        }
    };
}
pub(crate) use heading;
