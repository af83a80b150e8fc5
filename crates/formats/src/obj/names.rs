//! How the group names of a file become labels of a mesh, and back, and names fit for a line of text.

/// The label of the faces between these `o` and `g` lines.
pub(crate) fn group_label(object: &str, group: &str) -> Option<String> {
    match (object.is_empty(), group.is_empty()) {
        (true, true) => None,
        (true, false) => Some(group.to_owned()),
        (false, true) => Some(format!("o {object}")),
        (false, false) => Some(format!("o {object}; g {group}")),
    }
}

/// The `o` and `g` names that a label stands for; empty where it has none.
pub(crate) fn group_lines(label: &str) -> (&str, &str) {
    match label.strip_prefix("o ") {
        Some(rest) => rest.split_once("; g ").unwrap_or((rest, "")),
        None => ("", label),
    }
}

/// A name as it can stand on a line of a file: no control characters, nothing that would read as a
/// comment, no blanks around it.
pub(crate) fn clean(name: &str) -> String {
    let mut name: String = name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    // A `#` starts a comment where a blank follows it.
    while name.contains("# ") {
        name = name.replace("# ", "#");
    }
    let mut name = name.trim_start().trim_end_matches(|c: char| c == '\\' || c.is_whitespace()).to_owned();
    if name.ends_with('#') {
        name.push('_');
    }
    name
}

/// The words of a group line with one blank between.
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
    fn names_are_made_fit_for_a_line() {
        assert_eq!(clean(" a\nb\t"), "a b");
        assert_eq!(clean("Material #25"), "Material #25");
        assert_eq!(clean("a # b"), "a #b");
        for name in ["a\\", "a\\ \\", "a \\\n"] {
            assert_eq!(clean(name), "a");
        }
        assert_eq!(clean("a#\\"), "a#_");
    }
}
