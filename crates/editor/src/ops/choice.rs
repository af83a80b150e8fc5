//! Choices: fields that take one of some words, which are defined in one place each.

/// One word of a choice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Choice {
    /// The word in JSON.
    pub name: &'static str,
    /// How forms write it.
    pub label: &'static str,
}

/// Defines the words of a choice once: the enum, its JSON names and what forms call them. The first
/// one is the default.
macro_rules! choice {
    ($(#[$doc:meta])* pub enum $name:ident {
        $(#[$first_doc:meta])* $first:ident = $first_json:literal $first_label:literal,
        $($(#[$variant_doc:meta])* $variant:ident = $json:literal $label:literal,)*
    }) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
        pub enum $name {
            $(#[$first_doc])*
            #[default]
            #[serde(rename = $first_json)]
            $first,
            $($(#[$variant_doc])* #[serde(rename = $json)] $variant,)*
        }

        impl $name {
            /// The words in JSON, with what forms call them.
            pub const CHOICES: &'static [$crate::ops::Choice] = &[
                $crate::ops::Choice { name: $first_json, label: $first_label },
                $($crate::ops::Choice { name: $json, label: $label },)*
            ];

            /// The choices in the order that forms list them.
            pub const ALL: &'static [Self] = &[Self::$first, $(Self::$variant),*];

            /// How forms write it.
            pub fn label(self) -> &'static str {
                match self {
                    Self::$first => $first_label,
                    $(Self::$variant => $label,)*
                }
            }

            /// The word in JSON.
            #[allow(dead_code, reason = "serde writes the words of most choices")]
            pub fn name(self) -> &'static str {
                match self {
                    Self::$first => $first_json,
                    $(Self::$variant => $json,)*
                }
            }

            /// A field that takes one of these words; the first one when left out.
            #[allow(dead_code, reason = "a choice may be a field with a default of its own")]
            pub(crate) const fn field(name: &'static str, description: &'static str) -> $crate::ops::Field {
                $crate::ops::Field::required(name, $crate::ops::FieldKind::Choice(Self::CHOICES), description)
                    .or($crate::ops::DefaultValue::Choice($first_json))
            }
        }
    };
}
pub(crate) use choice;
