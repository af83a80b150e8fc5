//! Import reports, in one form for all formats.

use halfedge::words;
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::fmt;

/// The importance of a note.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Severity {
    /// What was read, or something left out that doesn't affect the mesh.
    Info,
    /// Something in the file was changed or left out.
    Warning,
}

/// One sentence about an import, for people who may not know the format.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct ReportNote {
    /// Its importance.
    pub severity: Severity,
    /// What happened, with counts and the first few line or element numbers.
    pub text: String,
}

/// What was read, what was changed and why, and what was left out.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct ImportReport {
    notes: Vec<ReportNote>,
}

impl ImportReport {
    /// All notes, in order of creation.
    pub fn notes(&self) -> &[ReportNote] {
        &self.notes
    }

    /// The texts of the warnings.
    pub fn warnings(&self) -> impl Iterator<Item = &str> {
        self.notes.iter().filter(|note| note.severity == Severity::Warning).map(|note| note.text.as_str())
    }

    /// Whether there are no warnings.
    pub fn is_clean(&self) -> bool {
        self.warnings().next().is_none()
    }

    /// Adds a note about what was read.
    pub fn info(&mut self, text: impl Into<String>) {
        self.notes.push(ReportNote { severity: Severity::Info, text: text.into() });
    }

    /// Adds a warning: something was changed or left out.
    pub fn warn(&mut self, text: impl Into<String>) {
        self.notes.push(ReportNote { severity: Severity::Warning, text: text.into() });
    }

    /// Adds another report's notes after these.
    pub fn append(&mut self, other: Self) {
        self.notes.extend(other.notes);
    }

    /// Prefixes every note with the file or object that it is about.
    pub(crate) fn prefixed(mut self, prefix: &str) -> Self {
        for note in &mut self.notes {
            note.text = format!("{prefix}: {}", note.text);
        }
        self
    }
}

impl fmt::Display for ImportReport {
    /// One note a line.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for note in &self.notes {
            writeln!(f, "{}", note.text)?;
        }
        Ok(())
    }
}

/// The places in a file where the same thing happened: their count and the first few.
#[derive(Clone, Debug, Default)]
pub(crate) struct Places {
    count: usize,
    first: Vec<usize>,
}

impl Places {
    const PLACES_SHOWN: usize = 6;

    /// Adds a place. Consecutive places with the same number are counted, but shown once.
    pub(crate) fn add(&mut self, number: usize) {
        self.count += 1;
        if self.first.len() < Self::PLACES_SHOWN && self.first.last() != Some(&number) {
            self.first.push(number);
        }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// How many there are.
    pub(crate) fn count(&self) -> usize {
        self.count
    }

    /// "3 faces left out (lines 4, 9, 12)": `one` or `many` by count, then `what`.
    pub(crate) fn sentence(&self, one: &str, many: &str, what: &str, place: &str) -> String {
        let numbers: Vec<String> = self.first.iter().map(usize::to_string).collect();
        format!(
            "{} {what} ({place}{} {}{})",
            words::counted(self.count, one, many),
            if numbers.len() == 1 { "" } else { "s" },
            numbers.join(", "),
            if self.count > self.first.len() { ", …" } else { "" }
        )
    }
}

/// At most `shown` words: "a, b, c, …".
pub fn first_few(words: &[impl AsRef<str>], shown: usize) -> String {
    let few: Vec<&str> = words.iter().take(shown).map(AsRef::as_ref).collect();
    few.join(", ") + if words.len() > shown { ", …" } else { "" }
}

/// The first few words in order of first use, each with its count: "a (3), b (1)". `None` if there are no
/// words.
pub(crate) fn counted_words<'a>(words: impl IntoIterator<Item = &'a str>) -> Option<String> {
    const WORDS_SHOWN: usize = 8;
    let mut counts: Vec<(&str, usize)> = Vec::new();
    let mut places: HashMap<&str, usize> = HashMap::new();
    for word in words {
        let place = *places.entry(word).or_insert(counts.len());
        match counts.get_mut(place) {
            Some((_, count)) => *count += 1,
            None => counts.push((word, 1)),
        }
    }
    let words: Vec<String> = counts.iter().map(|(word, count)| format!("{word} ({count})")).collect();
    (!words.is_empty()).then(|| first_few(&words, WORDS_SHOWN))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_say_how_many_and_the_first_few() {
        let mut places = Places::default();
        places.add(4);
        assert_eq!(places.sentence("face", "faces", "left out", "line"), "1 face left out (line 4)");
        for line in 5..20 {
            places.add(line);
        }
        assert_eq!(
            places.sentence("face", "faces", "left out", "line"),
            "16 faces left out (lines 4, 5, 6, 7, 8, 9, …)"
        );
    }

    #[test]
    fn a_report_serialises_as_a_list_of_notes() {
        let mut report = ImportReport::default();
        report.info("Read 8 vertices.");
        report.warn("1 face left out (line 4)");
        let json = serde_json::to_string(&report).expect("plain data");
        assert_eq!(
            json,
            r#"[{"severity":"info","text":"Read 8 vertices."},{"severity":"warning","text":"1 face left out (line 4)"}]"#
        );
        assert_eq!(serde_json::from_str::<ImportReport>(&json).expect("its own output"), report);
        assert_eq!(report.warnings().collect::<Vec<_>>(), ["1 face left out (line 4)"]);
        assert!(!report.is_clean());
    }
}
