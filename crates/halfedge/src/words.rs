//! Numbers and nouns as messages write them.

use crate::Element;
use std::fmt::Display;

/// A whole number with its thousands separated by no-break spaces: `1 234 567`.
pub fn thousands(value: impl Display) -> String {
    let digits = value.to_string();
    let mut text = String::with_capacity(digits.len() * 2);
    for (at, digit) in digits.chars().enumerate() {
        if at > 0 && (digits.len() - at).is_multiple_of(3) {
            text.push('\u{a0}');
        }
        text.push(digit);
    }
    text
}

/// A count with its noun: "1 patch", "2 500 patches".
pub fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{} {}", thousands(count), if count == 1 { one } else { many })
}

/// The text with a capital at its start.
pub fn capitalized(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

/// The text with a capital at its start and a full stop at its end, unless it ends like a sentence already.
pub fn sentence(text: &str) -> String {
    let mut text = capitalized(text);
    if !text.ends_with(['.', '!', '?']) {
        text.push('.');
    }
    text
}

impl Element {
    /// The plural of the kind: "vertices".
    pub fn plural(self) -> &'static str {
        match self {
            Self::Vertex => "vertices",
            Self::Halfedge => "half-edges",
            Self::Edge => "edges",
            Self::Face => "faces",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thousands_are_separated() {
        assert_eq!(thousands(7), "7");
        assert_eq!(thousands(1000), "1\u{a0}000");
        assert_eq!(thousands(3_000_000), "3\u{a0}000\u{a0}000");
        assert_eq!(counted(1, "patch", "patches"), "1 patch");
        assert_eq!(counted(1250, "patch", "patches"), "1\u{a0}250 patches");
    }

    #[test]
    fn sentences_have_a_capital_and_a_full_stop() {
        assert_eq!(sentence("select an edge"), "Select an edge.");
        assert_eq!(sentence("Done!"), "Done!");
    }
}
