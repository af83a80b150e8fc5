//! Group names as labels of a mesh and back, and names as text of a line.

use std::collections::HashSet;

/// The label of faces with these `o` and `g` names.
pub(crate) fn group_label(object: &str, group: &str) -> Option<String> {
    match (object.is_empty(), group.is_empty()) {
        (true, true) => None,
        (true, false) => Some(group.to_owned()),
        (false, true) => Some(format!("o {object}")),
        (false, false) => Some(format!("o {object}; g {group}")),
    }
}

/// The `o` and `g` names of a label; empty where it has none.
pub(crate) fn group_lines(label: &str) -> (&str, &str) {
    match label.strip_prefix("o ") {
        Some(rest) => rest.split_once("; g ").unwrap_or((rest, "")),
        None => ("", label),
    }
}

/// What to call a group with this label: the object's name where its faces are in no group, else the label.
///
/// A mesh with several `o` and `g` names has one label for each pair: `wheel`, `o car`, or `o car; g wheel`.
pub fn name_of_group(label: &str) -> &str {
    match group_lines(label) {
        (object, "") if !object.is_empty() => object,
        _ => label,
    }
}

/// The group that a file is in before its first `g`: programs write it where it has no faces.
const DEFAULT_GROUP: &str = "default";

/// The `o` and `g` names that no face has, by all labels and those of faces.
pub(crate) fn names_without_faces<'a>(
    all: impl Iterator<Item = &'a str>,
    used: impl Iterator<Item = &'a str>,
) -> Vec<&'a str> {
    let mut seen: HashSet<&str> = used.map(group_lines).flat_map(|(object, group)| [object, group]).collect();
    seen.extend(["", DEFAULT_GROUP]);
    all.map(group_lines)
        .flat_map(|(object, group)| [object, group])
        .filter(|name| seen.insert(name))
        .collect()
}

/// A name that can be written on a line: without control characters, without anything that reads as a comment,
/// and without blanks around it.
pub(crate) fn clean(name: &str) -> String {
    let mut name: String = name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    // A `#` before a blank would start a comment.
    while name.contains("# ") {
        name = name.replace("# ", "#");
    }
    let mut name = name.trim_start().trim_end_matches(|c: char| c == '\\' || c.is_whitespace()).to_owned();
    if name.ends_with('#') {
        name.push('_');
    }
    name
}

/// A text with single blanks between its words.
pub(crate) fn spaced(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_and_lines() {
        for (object, group) in [("", "a b"), ("car", ""), ("car", "wheel left")] {
            let label = group_label(object, group).expect("not empty");
            assert_eq!(group_lines(&label), (object, group));
        }
        assert_eq!(group_label("", ""), None);
    }

    #[test]
    fn names_without_faces_are_found_once() {
        let all = ["default", "o a", "o a; g x", "o b", "o b; g x", "y", "o c", "o c; g y", "z"];
        assert_eq!(names_without_faces(all.into_iter(), ["o b; g x"].into_iter()), ["a", "y", "c", "z"]);
        assert_eq!(names_without_faces([""; 0].into_iter(), [""; 0].into_iter()), [""; 0]);
    }

    #[test]
    fn names_become_text_of_a_line() {
        assert_eq!(clean(" a\nb\t"), "a b");
        assert_eq!(clean("Material #25"), "Material #25");
        assert_eq!(clean("a # b"), "a #b");
        for name in ["a\\", "a\\ \\", "a \\\n"] {
            assert_eq!(clean(name), "a");
        }
        assert_eq!(clean("a#\\"), "a#_");
    }
}
