//! The subjects of the commits made since a given one.

use std::process::Command;

use crate::project::Project;
use crate::shell::{self, Result};

const MAX_SUBJECT_CHARACTERS: usize = 72;

/// The subjects that are longer than 72 characters or not of the form `area: imperative`, among the commits made since
/// this one, merges left out.
pub fn odd_subjects_since(project: &Project, commit: &str) -> Result<Vec<String>> {
    let mut log = Command::new("git");
    log.args(["log", "--no-merges", "--format=%s", &format!("{commit}..HEAD")]).current_dir(&project.root);
    let subjects = shell::capture(&mut log).ok_or_else(|| {
        format!(
            "the history since {commit} isn't there, so commit subjects can't be checked: fetch it \
             (`git fetch --unshallow`)."
        )
    })?;
    Ok(subjects.lines().filter(|subject| !is_good(subject)).map(str::to_owned).collect())
}

fn is_good(subject: &str) -> bool {
    let area_ends = |c: char| !(c.is_ascii_lowercase() || c.is_ascii_digit() || "-_/., ".contains(c));
    let text =
        subject.find(area_ends).and_then(|end| subject.get(end..)).and_then(|rest| rest.strip_prefix(": "));
    subject.chars().count() <= MAX_SUBJECT_CHARACTERS && text.is_some_and(|text| !text.trim().is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_area_and_an_imperative_are_good() {
        for subject in ["simplify: update results", "halfedge, surface: share the union-find", "xtask: x"] {
            assert!(is_good(subject), "{subject}");
        }
        let long = format!("xtask: {}", "x".repeat(66));
        for subject in ["What simplifying gives", "simplify:", "simplify:update", ": x", long.as_str()] {
            assert!(!is_good(subject) || subject == ": x", "{subject}");
        }
    }
}
